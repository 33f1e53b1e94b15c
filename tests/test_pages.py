"""The pages of the site without the reference: they are built as `make docs` does, and links and navigation hold."""

from __future__ import annotations

import importlib
import importlib.util
import re
from pathlib import Path

import pytest

from tests.test_docstrings import PUBLIC, public
from tests.test_repository import ROOT

DIRECTIVE = re.compile(r"^::: ([\w.]+)\n(?:(?: {4}.*)?\n)*", re.MULTILINE)
"""Where the reference of a name goes in, with its options."""


@pytest.fixture(scope="module")
def pages(tmp_path_factory) -> Path:
    """The built pages; a warning, as of a link that leads nowhere, ends the build. What takes long is left out: the
    reference of names, which ``test_site.py`` builds as well, and the index for searching."""
    if importlib.util.find_spec("mkdocs") is None:
        pytest.skip("mkdocs is not installed")
    from mkdocs.commands.build import build
    from mkdocs.config import load_config
    from mkdocs.plugins import BasePlugin

    class Names(BasePlugin):
        def on_page_markdown(self, markdown, **_):
            return DIRECTIVE.sub(lambda found: f'<a id="{found[1]}"></a>\n\n', markdown)

    out = tmp_path_factory.mktemp("pages")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NO_MKDOCS_2_WARNING", "1")
        config = load_config(str(ROOT / "mkdocs.yml"), plugins=[], strict=True, site_dir=str(out))
        config.plugins["names"] = Names()
        build(config)
    return out


def test_every_page_and_decision_is_in_the_navigation(pages):
    front = (pages / "contributing.html").read_text()
    names = [path.relative_to(ROOT / "docs") for path in (ROOT / "docs").rglob("*.md") if path.name != "README.md"]
    missing = [name for name in names if not (pages / name.with_suffix(".html")).is_file()]
    unlisted = [name for name in names if f'href="{name.with_suffix(".html").as_posix()}"' not in front]
    assert (missing, unlisted) == ([], [])
    for notebook in (ROOT / "notebooks").glob("*.ipynb"):
        assert f'href="notebooks/{notebook.stem}.html"' in front


def is_there(name: str) -> bool:
    """Whether it is a module, or something of one."""
    module, _, last = name.rpartition(".")
    inside = importlib.import_module(module)
    return (hasattr(inside, "__path__") and importlib.util.find_spec(name) is not None) or hasattr(inside, last)


def test_names_of_the_reference_are_there_and_every_public_one_is_in_it(pages):
    anchors = set(re.findall(r'id="(sceneweaver\.[\w.]+)"', "".join(p.read_text() for p in pages.rglob("*.html"))))
    assert len(anchors) > 60 and [name for name in sorted(anchors) if not is_there(name)] == []
    for name in PUBLIC:
        module, _, last = name.rpartition(".")
        found = public(name)
        home = f"{getattr(found, '__module__', module)}.{getattr(found, '__qualname__', last)}"
        assert {name, home, module} & anchors, f"{name} is on no page of docs/reference"
