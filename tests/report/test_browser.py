"""The page in a real browser: it draws, nothing complains, clicks and keys do what they say."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sceneweaver.assets import make
from sceneweaver.report import ReportData, write_report
from sceneweaver.scene import Pose, Room, Scene
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
        _gather(browser, False)
        yield browser


def _gather(page: Browser, wanted: bool) -> None:
    """Whether a still picture gathers light, which takes all cores for seconds where there is no GPU."""
    page.wait("window.sceneView?.renderer.sums")  # made with the first frame, if it may gather then
    page.js(f"sceneView.renderer.canGather = {str(wanted).lower()}; sceneView.renderer.gathered = 0")
    page.js("document.getElementById('button-reset').click()")


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
    page.js("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done())))")
    page.shoot(path)
    return np.asarray(Image.open(io.BytesIO(path.read_bytes())).convert("RGB")).astype(int)


def test_it_draws(page: Browser, tmp_path: Path) -> None:
    assert page.js("document.getElementById('stage').className") == "stage running"
    page.js("document.getElementById('room').scrollIntoView()")
    x, y = _spot(page, (2.2, 2.0, 0.4))
    few = "{still: true, boxes: false, shown: new Set(), hover: null, frames: 2}"
    for gathered in (False, True):
        if gathered:
            _gather(page, True)
            page.wait("Number(document.getElementById('stage').dataset.frames) >= 2")  # they go on by themselves
            # What eight of them make is made of two as well.
            page.js(f"sceneView.renderer.draw(sceneView.orbit, {few})")
            page.js("sceneView.renderer.canGather = false")
        picture = _shot(page, tmp_path / "view.png")
        around = picture[int(y) - 60 : int(y) + 60, int(x) - 60 : int(x) + 60].reshape(-1, 3)
        assert len(np.unique(around // 8, axis=0)) > 40, "there is more than the background"
    _gather(page, False)


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


SHOWN = "[...document.querySelectorAll('.object-row.shown .object-id')].map(e => e.textContent)"


def _phrase(page: Browser, words: str) -> tuple[float, float]:
    """The middle of a phrase in the window, in CSS pixels."""
    x, y = page.js(
        f"(() => {{ const mark = [...document.querySelectorAll('.phrase')].find(e => e.innerText.includes('{words}'));"
        "mark.scrollIntoView({block: 'center'}); const b = mark.getClientRects()[0];"
        "return [b.left + b.width / 2, b.top + b.height / 2]; })()"
    )
    return x, y


def test_a_click_on_a_phrase_shows_its_objects(page: Browser) -> None:
    page.click(*_phrase(page, "near the armchair"))
    page.wait(f"{SHOWN}.length === 3")
    assert set(page.js(SHOWN)) == {"lamp-0", "lamp-1", "armchair-0"}
    page.wait("[...document.querySelectorAll('.label.chosen')].filter(l => !l.hidden).length > 0")
    detail = "document.getElementById('request-detail').innerText"
    assert "gap 1.82 m, allowed 0 to 1.5 m" in page.js(detail)
    assert page.js("document.getElementById('announce').textContent") == "lamp-0, lamp-1, armchair-0 shown"
    page.key("Escape")
    page.wait(f"{SHOWN}.length === 0 && {detail} === ''")


def test_a_fault_that_a_model_saw_shows_its_objects(page: Browser) -> None:
    page.click(*_phrase(page, "near the armchair"))
    page.wait(f"{SHOWN}.length === 3")
    fault = "document.querySelector('#seen .item')"
    page.js(f"{fault}.click()")
    page.wait(f"{SHOWN}.length === 1")
    assert page.js(SHOWN) == ["armchair-0"]
    assert page.js("document.querySelectorAll('#request [aria-pressed=true]').length") == 0
    page.key("Escape")
    page.wait(f"{SHOWN}.length === 0 && {fault}.getAttribute('aria-pressed') === 'false'")


def test_the_outline_of_what_a_phrase_names_is_drawn(page: Browser, tmp_path: Path) -> None:
    around = "document.getElementById('room').scrollIntoView()"
    page.js(around)
    before = _shot(page, tmp_path / "before.png")
    page.js("[...document.querySelectorAll('.phrase')].find(e => e.innerText.includes('A desk')).click()")
    page.js(around)
    page.wait(f"{SHOWN}.length === 1")
    page.wait("[...document.querySelectorAll('.label.chosen')].some(l => l.textContent === 'desk-0' && !l.hidden)")
    after = _shot(page, tmp_path / "after.png")
    blue = [int(((p[..., 2] > 200) & (p[..., 0] < 110)).sum()) for p in (before, after)]
    assert blue[1] > blue[0] + 50, "the accent colour of the outline"
    page.js("[...document.querySelectorAll('.phrase')].find(e => e.innerText.includes('A desk')).click()")
    page.wait(f"{SHOWN}.length === 0")


def test_a_phrase_can_be_reached_and_pressed_by_keys(page: Browser) -> None:
    page.js("document.querySelector('.phrase.met').focus()")
    assert "met: words" in page.js("document.getElementById('request-detail').innerText")
    page.key("Enter")
    page.wait(f"{SHOWN}.length === 1 && {SHOWN}[0] === 'desk-0'")
    assert page.js("document.querySelector('.phrase.met').getAttribute('aria-pressed')") == "true"
    page.js("[...document.querySelectorAll('.object-row')].find(r => r.textContent.startsWith('mug-0')).click()")
    assert (
        page.js(f"{SHOWN}.join()") == "mug-0"
        and page.js("document.querySelectorAll('#request [aria-pressed=true]').length") == 0
    )
    page.js("document.querySelector('.panel-close').click()")


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


def test_a_click_opens_a_door_of_the_room_and_closes_it(page: Browser) -> None:
    """It swings about its hinge as the scene says, and is drawn open."""
    door = "sceneView.renderer.moving('door-0')[0]"
    assert page.js(f"[{door}.kind, {door}.wall, {door}.share]") == ["leaf", 1, 0]
    page.js("sceneView.orbit.yaw = Math.PI; document.getElementById('view').focus()")  # from the side away from it
    page.key("ArrowRight")
    page.wait(f"{door}.cut > 2")
    page.click(*_spot(page, (4.0, 1.3, 1.0)))
    page.wait(f"{door}.share === 1")
    assert page.js("document.getElementById('announce').textContent") == "door-0 opened"
    model = np.array(page.js(f"Array.from({door}.model)")).reshape(4, 4).T
    assert model[:2, 3] == pytest.approx((4.0, 1.0), abs=0.02), "on the hinge, where it begins"
    assert model[:2, 0] == pytest.approx((-1.0, 0.0), abs=1e-3), "square to the wall, into the room"
    page.click(*_spot(page, (3.5, 1.02, 1.0)))
    page.wait(f"{door}.share === 0")
    assert page.js("document.getElementById('announce').textContent") == "door-0 closed"
    page.js("document.getElementById('button-reset').click()")
    page.wait("sceneView.orbit.goal === null")


def test_hostile_text_does_not_run(tmp_path: Path) -> None:
    write_report(tmp_path / "report.html", full(HOSTILE))
    with Browser(400, 560) as browser:
        browser.open((tmp_path / "report.html").as_uri())
        browser.wait("document.getElementById('stage').className === 'stage running'")
        assert [line for line in browser.logs if not line.startswith("request: file:")] == []
        assert HOSTILE in browser.js("document.getElementById('request').textContent")
        assert browser.js("document.documentElement.scrollWidth <= innerWidth"), "nothing sticks out"


def test_without_webgl_a_picture_stands_in(tmp_path: Path) -> None:
    write_report(tmp_path / "report.html", full())
    with Browser(700, 500, flags=("--disable-3d-apis",)) as browser:
        browser.open((tmp_path / "report.html").as_uri())
        browser.wait("document.getElementById('stage').classList.contains('failed')")
        assert "WebGL 2 is not available" in browser.js("document.getElementById('stage-note').innerText")
        assert browser.js("document.querySelector('.still').getBoundingClientRect().width > 100")


def test_doors_and_drawers_open(tmp_path: Path) -> None:
    """By a slider each and by one button for all: they move as their joints say, and are drawn open."""
    chest, fridge = make("filing_cabinet", 1), make("fridge", 1)
    objects = (
        chest.object("chest", pose=Pose.from_yaw(1.2, 2.0, 0.0, -1.57)),
        fridge.object("fridge", pose=Pose.from_yaw(2.6, 2.0, 0.0, -1.57)),
    )
    scene = Scene(id="s", room=Room(outline=((0, 0), (4, 0), (4, 4), (0, 4))), objects=objects)
    path = tmp_path / "report.html"
    load = {a.id: a for a in (chest, fridge)}.__getitem__
    write_report(path, ReportData(scene, load=load))
    with Browser(640, 440, limit=90.0) as page:
        page.open(path.as_uri())
        page.wait("document.getElementById('stage').className === 'stage running'")
        moving = page.js("sceneView.renderer.moving().map(i => [i.id, i.joint.name])")
        page.click(*_spot(page, (1.2, 1.7, 0.3)))  # the front of one of its drawers
        page.wait(f"{TITLE} === 'chest' && sceneView.renderer.moving('chest').some(i => i.share === 1)")
        assert "100" in page.js("[...document.querySelectorAll('.panel-doors input')].map(s => s.value)")
        page.js("sceneView.renderer.open(sceneView.renderer.moving(), 0)")
        page.key("Escape")
        wanted = {(k, link.name) for k, a in (("chest", chest), ("fridge", fridge)) for link in a.links}
        assert len(moving) >= 4 and {(k, name) for k, name in moving} <= wanted
        _gather(page, False)
        page.js("document.getElementById('room').scrollIntoView()")
        before = _shot(page, tmp_path / "closed.png")
        page.js("[...document.querySelectorAll('.object-row')].find(r => r.textContent.startsWith('chest')).click()")
        assert page.js("document.querySelectorAll('.panel-doors input').length") == sum(k == "chest" for k, _ in moving)
        page.js(
            "(() => { const s = document.querySelector('.panel-doors input'); s.value = '50';"
            "s.dispatchEvent(new Event('input')); })()"
        )
        name, far = page.js(
            "(() => { const i = sceneView.renderer.moving('chest')[0]; const [x, y, z] = i.position;"
            "return [i.joint.name, Math.hypot(i.model[12] - x, i.model[13] - y, i.model[14] - z)]; })()"
        )
        link = next(link for link in chest.links if link.name == name)
        assert link.joint == "slide" and far == pytest.approx(0.5 * max(map(abs, link.limits)), abs=1e-4)
        page.js("document.getElementById('button-open').click()")
        assert page.js("[...document.querySelectorAll('.panel-doors input')].map(s => s.value)") == ["100"] * sum(
            k == "chest" for k, _ in moving
        )
        door = next(link for link in fridge.links if link.joint == "hinge")
        item = f"sceneView.renderer.moving('fridge').find(i => i.joint.name === '{door.name}')"
        model = np.array(page.js(f"Array.from({item}.model)")).reshape(4, 4).T
        hinge = (model @ [*door.anchor, 1.0])[:2]
        turn = np.array([[0.0008, 1.0], [-1.0, 0.0008]])  # of the fridge, by -1.57
        assert hinge == pytest.approx(np.array([2.6, 2.0]) + turn @ np.array(door.anchor[:2]), abs=2e-3)
        page.key("Escape")
        after = _shot(page, tmp_path / "open.png")
        assert (np.abs(after - before).max(axis=-1) > 40).mean() > 0.01, "open doors are to be seen"
        page.js("document.getElementById('button-open').click()")
        assert page.js("sceneView.renderer.moving().every(i => i.share === 0)")
        assert [line for line in page.logs if not line.startswith("request: file:")] == []
