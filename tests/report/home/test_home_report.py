"""The page of a home: what it says, that it holds together, and that nothing of a file becomes markup."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import pytest
from PIL import Image

from sceneweaver.home import Home
from sceneweaver.render.home import report_parts
from sceneweaver.report.home import HomePage, home_report, write_home_report
from tests.render.home.homes import flat, house

METRICS: Mapping[str, Any] = {
    "valid": True,
    "violations": [{"kind": "unreachable", "detail": "wardrobe-0 of bedroom is out of reach", "objects": []}],
    "access": {"walkable_share": 0.62, "reachable_share": 0.9},
    "rooms": {
        "bedroom": {
            "valid": False,
            "violations": [{"kind": "collision", "objects": ["a", "b"], "detail": "a and b overlap by 3 cm"}],
        }
    },
    "plan": {
        "valid": False,
        "violations": [{"rule": "bath-door", "rooms": ["bath"], "detail": "0.6 m wide; at least 0.8", "amount": 0.2}],
        "soft": [{"rule": "near", "rooms": ["kitchen", "hall"], "detail": "6 m apart; at most 5", "amount": 1.0}],
        "measures": {"circulation_share": 0.118},
        "cost": 0.4,
    },
    "design": {"unmet": ["a balcony"], "notes": ["storeys are 2.70 m high"], "grades": {"living": 8.2}},
}


@cache
def page() -> HomePage:
    pictures = {name: Image.new("RGB", (40, 30), (200, 180, 160)) for name in ("overview_ground", "walk_02")}
    return HomePage(flat(), METRICS, pictures=pictures, **report_parts(flat()))


@cache
def text() -> str:
    return home_report(page())


def shown(html: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="scene-data">(.*?)</script>', html)
    assert found is not None
    return json.loads(found[1])


def test_each_room_has_a_section_to_which_plan_and_table_lead() -> None:
    for room in flat().rooms:
        assert f'id="room-{room.id}"' in text()
        assert text().count(f'href="#room-{room.id}"') == 2  # of the table and of the plan


@pytest.mark.parametrize(
    "said",
    [
        "69.1",  # clear floor [m2]
        "a and b overlap by 3 cm",
        "Bathroom:</b> 0.6 m wide; at least 0.8",
        "Kitchen, Hall:</b> 6 m apart; at most 5",
        "breaks hard rules",
        "11.8 %",
        "62.0 %",
        "a balcony",
        "storeys are 2.70 m high",
        "8.2 of 10",
        "wardrobe-0 of bedroom is out of reach",
        "double door of 1.40 m to living room",
        "Hall, to the living room",
    ],
)
def test_it_says_what_the_metrics_say(said: str) -> None:
    assert said in text()


def test_the_view_has_a_scope_for_each_storey_and_room() -> None:
    data = shown(home_report(HomePage(house(), **report_parts(house()))))
    indoors = [room.id for room in house().rooms if not room.outdoor]
    wanted = ["storey:ground", "storey:upper", *(f"room:{name}" for name in indoors)]
    assert [scope["id"] for scope in data["scopes"]] == wanted
    for scope in data["scopes"]:
        for number in scope["items"]:
            wall = data["items"][number]["wall"]
            assert wall is None or 0 <= wall < len(scope["walls"])


def test_objects_of_all_rooms_are_told_apart() -> None:
    data = shown(text())
    things = {f"{room.id}/{o.id}" for room in flat().rooms if room.scene is not None for o in room.scene.objects}
    assert set(data["objects"]) == things == {i["id"] for i in data["items"] if i["kind"] == "object"}
    for scope in data["scopes"]:
        listed = {data["items"][k]["id"] for k in scope["items"] if data["items"][k]["kind"] == "object"}
        kind, _, name = scope["id"].partition(":")
        own = things if kind == "storey" else {thing for thing in things if thing.startswith(f"{name}/")}
        gone = {f"{room}/{name}" for room, names in page().hidden.items() for name in names}
        assert listed == (own - gone if kind == "storey" else own)


def test_a_home_without_metrics_or_drawings_is_shown_as_well() -> None:
    html = home_report(HomePage(Home.example("flat")))
    assert "not checked" in html and "not furnished" in html and 'id="rules"' not in html


def test_nothing_of_a_file_becomes_markup() -> None:
    bad = '<img src=x onerror="alert(1)">'
    home = Home.example("flat").with_changes(prompt=bad)
    metrics = {
        "violations": [{"kind": bad, "detail": bad}],
        "design": {"unmet": [bad]},
        "plan": {"soft": [{"rule": bad}]},
    }
    html = home_report(HomePage(home, metrics, **report_parts(home)))
    assert "<img src=x" not in html


def test_nothing_is_loaded_from_elsewhere(tmp_path) -> None:
    write_home_report(tmp_path / "report.html", page())
    html = (tmp_path / "report.html").read_text()
    assert html == text()
    assert "default-src 'none'" in html and not re.search(r'(?:src|href)="(?!data:|#)', html)
    assert set(re.findall(r'https?://[^"\s<]+', html)) <= {"http://www.w3.org/2000/svg"}
