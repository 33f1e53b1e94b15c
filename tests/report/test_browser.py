"""The page in a real browser: it draws, nothing complains, clicks and keys do what they say."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sceneweaver.report import write_report
from tests.report.browser import BINARY, Browser
from tests.report.scenes import HOSTILE, full

pytestmark = pytest.mark.skipif(BINARY is None, reason="no Chromium here")

TITLE = "document.querySelector('#object-panel h3')?.textContent"
PRESSED = "document.querySelector('.object-row[aria-pressed=true] .object-id')?.textContent"


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Browser]:
    path = tmp_path_factory.mktemp("report") / "report.html"
    write_report(path, full())
    with Browser(640, 440) as browser:
        browser.open(path.as_uri())
        browser.wait("document.getElementById('stage').className !== 'stage'")
        yield browser


def _spot(page: Browser, point: tuple[float, float, float]) -> tuple[float, float]:
    """Where a point of the room [m] is in the window, in CSS pixels."""
    x, y = page.js(
        "(() => { document.getElementById('room').scrollIntoView();"
        f"const [x, y, , w] = sceneView.project({list(point)});"
        "const b = document.getElementById('view').getBoundingClientRect();"
        "return [b.left + (x / w / 2 + 0.5) * b.width, b.top + (0.5 - y / w / 2) * b.height]; })()"
    )
    return x, y


def _shot(page: Browser, path: Path) -> np.ndarray:
    page.shoot(path)
    return np.asarray(Image.open(io.BytesIO(path.read_bytes())).convert("RGB")).astype(int)


def test_it_draws(page: Browser, tmp_path: Path) -> None:
    assert page.js("document.getElementById('stage').className") == "stage running"
    page.js("document.getElementById('room').scrollIntoView()")
    page.wait("Number(document.getElementById('stage').dataset.frames) >= 1")
    x, y = _spot(page, (2.2, 2.0, 0.4))
    picture = _shot(page, tmp_path / "view.png")
    around = picture[int(y) - 60 : int(y) + 60, int(x) - 60 : int(x) + 60].reshape(-1, 3)
    assert len(np.unique(around // 8, axis=0)) > 40, "there is more than the background"


def test_nothing_complains(page: Browser) -> None:
    assert [line for line in page.logs if not line.startswith("request: file:")] == []
    assert sum(line.startswith("request:") for line in page.logs) == 1, "only the page itself is loaded"


def test_a_click_selects(page: Browser) -> None:
    page.click(*_spot(page, (2.2, 2.0, 0.4)))
    page.wait(f"{TITLE} === 'armchair-0'")
    assert page.js(PRESSED) == "armchair-0"
    text = page.js("document.getElementById('object-panel').innerText")
    for words in ("armchair", "2.20, 2.00, 0.00 m", "armchair-0 near desk-0", "-90.0°"):
        assert words in text, words
    page.key("Escape")
    page.wait("document.getElementById('object-panel').hidden")


def test_the_list_selects_and_links_lead_on(page: Browser) -> None:
    page.js("[...document.querySelectorAll('.object-row')].find(r => r.textContent.startsWith('mug-0')).click()")
    assert page.js(TITLE) == "mug-0"
    page.js("document.querySelector('#object-panel .link').click()")
    assert page.js(TITLE) == "desk-0"
    assert page.js("document.querySelector('#object-panel .link').textContent") == "mug-0"
    page.js("document.querySelector('.panel-close').click()")
    assert page.js("document.getElementById('object-panel').hidden")


def test_buttons_and_keys_move_the_camera(page: Browser) -> None:
    assert page.js("sceneView.orbit.pitch") < 1
    page.js("document.getElementById('button-top').click()")
    page.wait("sceneView.orbit.pitch > 1.5 && sceneView.orbit.goal === null")
    a, b = _spot(page, (1, 1, 0)), _spot(page, (3, 2, 0))
    assert b[0] > a[0] and b[1] < a[1], "x to the right, y up"
    page.js("document.getElementById('button-reset').click()")
    page.wait("sceneView.orbit.pitch < 1 && sceneView.orbit.goal === null")
    yaw = page.js("sceneView.orbit.yaw")
    page.js("document.getElementById('view').focus()")
    page.key("ArrowRight")
    assert page.js("sceneView.orbit.yaw") > yaw
    page.js("document.getElementById('button-labels').click()")
    page.wait("[...document.querySelectorAll('.label')].some(l => !l.hidden)")
    page.js("document.getElementById('button-labels').click()")


def test_hidden_walls_take_their_pictures_along(page: Browser) -> None:
    page.js("document.getElementById('button-walls').click()")
    page.wait("sceneView.renderer.items.filter(i => i.wall !== null).every(i => i.cut < 0.1)")
    page.js("document.getElementById('button-walls').click()")
    page.wait("sceneView.renderer.items.some(i => i.kind === 'wall' && i.cut > 2)")


def test_hostile_text_does_not_run(tmp_path: Path) -> None:
    write_report(tmp_path / "report.html", full(HOSTILE))
    with Browser(400, 560) as browser:
        browser.open((tmp_path / "report.html").as_uri())
        browser.wait("document.getElementById('stage').className === 'stage running'")
        assert [line for line in browser.logs if not line.startswith("request: file:")] == []
        assert HOSTILE in browser.js("document.querySelector('header').textContent")
        assert browser.js("document.documentElement.scrollWidth <= innerWidth"), "nothing sticks out"


def test_without_webgl_a_picture_stands_in(tmp_path: Path) -> None:
    write_report(tmp_path / "report.html", full())
    with Browser(700, 500, flags=("--disable-3d-apis",)) as browser:
        browser.open((tmp_path / "report.html").as_uri())
        browser.wait("document.getElementById('stage').classList.contains('failed')")
        assert "WebGL 2 is not available" in browser.js("document.getElementById('stage-note').innerText")
        assert browser.js("document.querySelector('.still').getBoundingClientRect().width > 100")
