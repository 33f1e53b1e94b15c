"""The documentation site builds without a warning, holds every page and public name, and fetches nothing.

It takes a quarter of a minute: `make bench` does it. `make test` builds the pages alone (``test_pages.py``).
"""

from __future__ import annotations

import html
import importlib
import importlib.util
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.report.browser import BINARY, Browser
from tests.sizes import sizes
from tests.test_docstrings import MODULES, PUBLIC, public
from tests.test_repository import ROOT

pytestmark = pytest.mark.slow

FETCHED = re.compile(r"<(?:script|link|img|iframe)\b[^>]*?\b(?:src|href)=\"?(https?:)?//[^\s\">]+", re.IGNORECASE)


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> Path:
    """The site, built as `make docs` does; a warning ends the build."""
    if importlib.util.find_spec("mkdocs") is None:
        pytest.skip("mkdocs is not installed")
    out = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(out)]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1", "NO_COLOR": "1"}
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, env=environment, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    yield out
    shutil.rmtree(out)


def test_it_has_every_page_and_decision_in_its_navigation(site):
    front = (site / "contributing.html").read_text()
    pages = [path.relative_to(ROOT / "docs") for path in (ROOT / "docs").rglob("*.md") if path.name != "README.md"]
    missing = [page for page in pages if not (site / page.with_suffix(".html")).is_file()]
    unlisted = [page for page in pages if f'href="{page.with_suffix(".html").as_posix()}"' not in front]
    assert (missing, unlisted) == ([], [])
    for notebook in (ROOT / "notebooks").glob("*.ipynb"):
        assert f'href="notebooks/{notebook.stem}.html"' in front


def test_every_public_name_is_in_the_reference(site):
    text = "".join(path.read_text() for path in (site / "reference").glob("*.html"))
    anchors = set(re.findall(r'id="(sceneweaver\.[\w.]+)"', text))
    for name in ("sceneweaver.__version__", *PUBLIC):
        module, _, last = name.rpartition(".")
        found = None if last == "__version__" else public(name)
        home = f"{getattr(found, '__module__', module)}.{getattr(found, '__qualname__', last)}"
        assert {name, home} & anchors, f"{name} is on no page of docs/reference"
    assert len(anchors) > 60 and {m for m in MODULES if f"{m}." in "".join(anchors)} >= {"sceneweaver.jax"}


def callables():
    """Public functions, classes and methods: name, where it is defined, names of arguments."""
    for name in PUBLIC:
        found = public(name)
        found = found if inspect.isroutine(found) or inspect.isclass(found) else None
        if found is None or (inspect.isclass(found) and issubclass(found, Exception)):
            continue
        yield name, f"{found.__module__}.{found.__qualname__}", arguments(found)
        for key, member in dict(vars(found)).items() if inspect.isclass(found) else ():
            member = getattr(member, "__func__", member)
            if inspect.isfunction(member) and not key.startswith("_") and key != "model_validate":
                yield f"{name}.{key}", f"{found.__module__}.{found.__qualname__}.{key}", arguments(member)


def arguments(found) -> list[str]:
    """What can be given to it by name or place; of a model its fields."""
    if fields := getattr(found, "model_fields", None):
        return [name for name in fields if name != "schema_"]  # which nobody writes in Python
    if getattr(found, "_is_protocol", False):  # what others write has no arguments of its own
        return []
    return [name for name in inspect.signature(found).parameters if name not in ("self", "cls")]


def test_every_signature_is_whole(site):
    shown: dict[str, str] = {}
    heading = re.compile(r'<h\d id="(sceneweaver\.[\w.]+)" class="doc doc-heading">')
    for path in (site / "reference").glob("*.html"):
        parts = heading.split(path.read_text())[1:]
        for name, text in zip(parts[::2], parts[1::2], strict=True):
            blocks = re.findall(r'<div class="[^"]*doc-signature[^"]*">(.*?)</div>', text, re.DOTALL)
            shown[name] = html.unescape(re.sub(r"<[^>]+>", "", " ".join(blocks)))
    lacking, seen = {}, 0
    for name, home, names in callables():
        text = shown.get(name) or shown.get(home) or ""
        absent = [one for one in names if not re.search(rf"\b{one}\b[:,=)\s]", text)]
        seen += len(names)
        if absent or "..." in text.replace(", ...", ""):
            lacking[name] = absent
    assert lacking == {} and seen > 500


def test_the_search_finds_every_public_name(site):
    index = json.loads((site / "search" / "search_index.json").read_text())
    known = {entry["location"].partition("#")[2] for entry in index["docs"]}
    assert [n for n, home, _ in callables() if n not in known and home not in known] == []
    offline = (site / "search" / "search_index.js").read_text()
    assert offline.startswith("var __index = {") and "reference/layouts.html" in offline


def test_examples_are_shown_as_code(site):
    text = (site / "reference" / "layouts.html").read_text()
    assert "Examples:" in text and text.count("&gt;&gt;&gt;") > 20
    assert "<blockquote>\n<blockquote>" not in text, "an example without the heading 'Examples:'"


@pytest.mark.skipif(BINARY is None, reason="needs Chromium")
def test_pages_opened_from_disk_can_be_searched(site):
    with Browser(1240, 900) as browser:
        browser.open((site / "reference" / "layouts.html").as_uri())
        shown = "getComputedStyle(document.querySelector('.md-search__form')).display !== 'none'"
        browser.wait(f"{shown} && document.querySelector('.md-search__input').offsetWidth > 100")
        browser.js("document.querySelector('.md-search__input').focus()")
        browser.call("Input.insertText", text="collision")
        browser.wait("document.querySelectorAll('.md-search-result__item').length > 5")
        asked = [
            line for line in browser.logs if line.startswith("request: ") and not line.startswith("request: file:")
        ]
        assert asked == []


@pytest.mark.skipif(BINARY is None, reason="needs Chromium")
@sizes("pages", "[bl]*", "*")
def test_signatures_are_not_cut_off(site, pages):
    cut = "[...document.querySelectorAll('.doc-signature code')].filter(c => c.scrollWidth > c.clientWidth + 1).length"
    with Browser(1240, 900) as browser:
        for path in sorted((site / "reference").glob(f"{pages}.html")):
            browser.open(path.as_uri())
            assert path.stem == "index" or browser.js("document.querySelectorAll('.doc-signature code').length") > 2
            for width in (1240, 420):
                browser.resize(width, 900)
                assert browser.js(cut) == 0, (path.stem, width)


def test_it_fetches_nothing(site):
    fetched = {match[0] for path in site.rglob("*.html") for match in FETCHED.finditer(path.read_text())}
    assert fetched == set()
    styles = "".join(path.read_text() for path in site.rglob("*.css"))
    assert re.findall(r"(?:@import|url\()\s*[\"']?(?:https?:)?//[^)\"']+", styles) == []
    assert not any("mermaid" in path.read_text() for path in site.rglob("*.html") if path.name != "changelog.html")
