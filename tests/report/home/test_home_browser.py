"""The page of a home in a real browser: nothing complains, rooms of the plan lead to their sections, scopes change."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from sceneweaver.render.home import report_parts
from sceneweaver.render.home.overview import hidden_when_cut
from sceneweaver.report.home import HomePage, write_home_report
from tests.render.home.homes import flat
from tests.report.browser import BINARY, Browser

pytestmark = pytest.mark.skipif(BINARY is None, reason="no Chromium here")

LISTED = "[...document.querySelectorAll('#object-list li')].filter(li => !li.hidden).map(li => li.innerText)"


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Browser]:
    path = tmp_path_factory.mktemp("report") / "report.html"
    write_home_report(path, HomePage(flat(), **report_parts(flat())))
    with Browser(480, 360, limit=90) as browser:
        browser.open(path.as_uri())
        browser.wait("document.getElementById('stage').className !== 'stage'")
        browser.js("if (window.sceneView) sceneView.renderer.canGather = false")  # it takes all cores for seconds
        yield browser


def test_it_shows_the_whole_home(page: Browser) -> None:
    assert page.js("document.getElementById('stage').className") == "stage running"
    assert page.js("document.querySelector('[data-scope][aria-pressed=true]').innerText") == "Whole home"
    rooms = [room.scene for room in flat().rooms if room.scene is not None]
    assert len(page.js(LISTED)) == sum(len(scene.objects) - len(hidden_when_cut(scene)) for scene in rooms)


def test_a_room_of_the_plan_leads_to_its_section(page: Browser) -> None:
    page.js("document.querySelector('.sheet').scrollIntoView()")
    x, y = page.js(
        "(() => { const b = document.querySelector('.sheet a[href=\"#room-bath\"] polygon').getBoundingClientRect();"
        "return [b.left + b.width / 2, b.top + b.height / 2]; })()"
    )
    page.click(x, y)
    page.wait("location.hash === '#room-bath'")


def test_a_room_is_looked_at_alone(page: Browser) -> None:
    page.js("document.querySelector('#room-bedroom [data-scope]').click()")
    bedroom = next(room for room in flat().rooms if room.id == "bedroom")
    assert bedroom.scene is not None
    listed = page.js(LISTED)
    assert len(listed) == len(bedroom.scene.objects) and all("bedroom/" in text for text in listed)
    assert page.js("sceneView.renderer.items.every(i => i.kind !== 'object' || i.id.startsWith('bedroom/'))")


def test_nothing_complains_and_nothing_is_asked_for(page: Browser) -> None:
    assert [log for log in page.logs if not log.startswith("request: file:")] == []
    assert len(page.logs) == 1
