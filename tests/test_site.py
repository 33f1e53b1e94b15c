"""The documentation site builds without a warning, holds every page and public name, and fetches nothing."""

from __future__ import annotations

import importlib
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.report.browser import BINARY, Browser
from tests.test_docstrings import MODULES, PUBLIC, public
from tests.test_repository import ROOT

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
def test_signatures_are_not_cut_off(site):
    cut = "[...document.querySelectorAll('.doc-signature code')].filter(c => c.scrollWidth > c.clientWidth + 1).length"
    with Browser(1240, 900) as browser:
        for name in ("building", "drawing", "layouts"):
            browser.open((site / "reference" / f"{name}.html").as_uri())
            assert browser.js("document.querySelectorAll('.doc-signature code').length") > 10
            for width in (1240, 800, 420):
                browser.resize(width, 900)
                assert browser.js(cut) == 0, (name, width)


def test_it_fetches_nothing(site):
    fetched = {match[0] for path in site.rglob("*.html") for match in FETCHED.finditer(path.read_text())}
    assert fetched == set()
    styles = "".join(path.read_text() for path in site.rglob("*.css"))
    assert re.findall(r"(?:@import|url\()\s*[\"']?(?:https?:)?//[^)\"']+", styles) == []
    assert not any("mermaid" in path.read_text() for path in site.rglob("*.html") if path.name != "changelog.html")
