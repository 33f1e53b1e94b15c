"""Homes on the server: planned, furnished room by room, judged, drawn, exported; and what is refused."""

from __future__ import annotations

import base64
import io
import json
import os
import threading
from pathlib import Path

import pytest
from PIL import Image

import sceneweaver as sw
from sceneweaver.mcp import build_server
from sceneweaver.mcp.limits import MOST_PLANS, Limits
from tests.mcp.driving import children, connected, in_good_order, wait_for

FAST = {"steps": 1, "candidates": 8, "clutter": 0.0}

PROGRAMME = {
    "rooms": [
        {"id": "hall", "type": "entrance_hall", "area": 5},
        {"id": "bed", "type": "guest_room", "area": 14},
        {"id": "store", "type": "storage_room", "area": 3},
        {"id": "wc", "type": "guest_toilet", "area": 2.4},
    ],
    "adjacencies": [["hall", "bed"], ["hall", "store"], {"a": "hall", "b": "wc", "kind": "door"}],
}

WRONG = [
    ("plan_home", {}),
    ("plan_home", {"prompt": "   "}),
    ("plan_home", {"programme": "palace"}),
    ("plan_home", {"programme": {"rooms": []}}),
    ("plan_home", {"programme": {"rooms": [{"id": "a", "type": "throne_room"}]}}),
    ("plan_home", {"programme": PROGRAMME, "profile": "royal"}),
    ("plan_home", {"programme": PROGRAMME, "count": 0}),
    ("plan_home", {"programme": PROGRAMME, "count": MOST_PLANS + 1}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"width": 8}}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"width": 8, "depht": 7}}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"width": 8, "depth": 7, "closed": 3}}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"width": -8, "depth": 7}}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"outline": [[0, 0], [1, 1]], "open_walls": []}}),
    ("plan_home", {"programme": PROGRAMME, "envelope": {"width": 2.5, "depth": 2.5}, "plans": 8}),
    ("plan_home", {"programme": PROGRAMME, "plans": 0}),
    ("plan_home", {"programme": PROGRAMME, "time_limit": 1e9}),
    ("design_home", {}),
    ("design_home", {"prompt": ""}),
    ("design_home", {"prompt": "  "}),
    ("design_home", {"prompt": "a flat", "profile": "royal"}),
    ("design_home", {"prompt": "a flat", "formats": ["obj"]}),
    ("design_home", {"prompt": "a flat", "folder": "../flat"}),
    ("design_home", {"prompt": "a flat", "folder": "folder"}),
    ("design_home", {"prompt": "a flat", "clutter": 2}),
    ("open_home", {}),
    ("open_home", {"name": "palace"}),
    ("open_home", {"name": "broken.json"}),
    ("open_home", {"name": "folder"}),
    ("open_home", {"name": "/etc/passwd"}),
    ("furnish_home", {"home": "h99"}),
    ("furnish_home", {"home": "s1"}),
    ("furnish_home", {"home": "h1", "requests": {}}),
    ("furnish_home", {"home": "h1", "requests": {"ballroom": ""}}),
    ("furnish_home", {"home": "h1", "requests": {"hall": 3}}),
    ("furnish_home", {"home": "h1", "requests": {"hall": ""}, "version": 99}),
    ("check_home", {"home": "h99"}),
    ("check_home", {"home": "h1", "robot_radius": 0}),
    ("check_home", {"home": "h1", "profile": "royal"}),
    ("render_home", {"home": "h1", "views": []}),
    ("render_home", {"home": "h1", "views": ["cellar"]}),
    ("render_home", {"home": "h1", "views": ["walk_99"]}),
    ("render_home", {"home": "h1", "name": "plan.exe"}),
    ("export_home", {"home": "h1", "formats": []}),
    ("export_home", {"home": "h1", "formats": ["dwg"]}),
    ("export_home", {"home": "h1", "folder": "folder"}),
    ("open_room", {"home": "h1", "room": "ballroom"}),
    ("open_room", {"home": "h1", "room": "hall"}),
    ("put_room", {"home": "h1", "room": "hall", "scene": "s1"}),
    ("put_room", {"home": "h1", "room": "hall", "scene": "s99"}),
    ("undo", {"scene": "h1"}),
    ("move", {"scene": "h1", "object": "bed", "by": [1, 1]}),
    ("close", {"scene": "h99"}),
]


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """A server in this process with the example flat as h1 and the bedroom as s1, and its folder."""
    folder = tmp_path_factory.mktemp("homes")
    (folder / "broken.json").write_text('{"schema": "sceneweaver.home/1", ')
    (folder / "folder").mkdir()
    (folder / "folder/diary.txt").write_text("mine")
    server = build_server(folder, device="cpu")
    with connected(server) as driver:
        driver.call("open_home", name="flat")
        driver.call("open", name="bedroom")
        yield driver, folder
    server.service.workers.close()


@pytest.fixture(scope="module")
def planned(served):
    """Two plans of a small programme."""
    return served[0].call("plan_home", programme=PROGRAMME, plans=32, count=2, seed=1)


@pytest.fixture(scope="module")
def furnished(served, planned):
    """Its store room furnished, in the second plan where there is one."""
    version = planned["options"][-1]["version"]
    requests = {"store": "a store room with one shelf"}
    return served[0].call("furnish_home", home=planned["home"], requests=requests, version=version, **FAST)


@pytest.mark.parametrize(("tool", "arguments"), WRONG, ids=lambda value: value if isinstance(value, str) else "")
def test_bad_input_is_one_line_and_changes_nothing(served, tool, arguments):
    driver, folder = served
    before, files = driver.read("home://h1"), sorted(folder.rglob("*"))
    versions = len(driver.call("list_scenes")["homes"])
    line = driver.refused(tool, **arguments)
    assert str(folder) not in line and "unexpected" not in line, line
    assert driver.read("home://h1") == before and sorted(folder.rglob("*")) == files
    assert len(driver.call("list_scenes")["homes"]) == versions


def test_a_handle_of_the_other_kind_is_told_from_one_that_is_not_there(served):
    driver, _ = served
    assert "it is a home" in driver.refused("render", scene="h1")
    assert "it is a scene" in driver.refused("render_home", home="s1")
    assert "open are" in driver.refused("render_home", home="h99")


def test_plans_to_choose_from_are_versions_of_one_home(served, planned):
    driver, _ = served
    assert planned["valid"] and planned["version"] == 1 and planned["found"] >= len(planned["options"])
    assert [option["version"] for option in planned["options"]] == list(range(1, len(planned["options"]) + 1))
    costs = [option["cost"] for option in planned["options"]]
    assert costs[0] <= min(costs) + 2.0  # walls that are short for furniture count beside the rules
    homes = [sw.Home.loads(driver.read(f"home://{planned['home']}/{o['version']}")) for o in planned["options"]]
    assert {room.id for room in homes[0].rooms} == {"hall", "bed", "store", "wc"}
    assert len({home.dumps() for home in homes}) == len(homes)
    assert all(room["objects"] is None for room in planned["rooms"])


def test_one_room_is_furnished_and_the_others_stay(served, planned, furnished):
    driver, _ = served
    assert [one["room"] for one in furnished["furnished"]] == ["store"] and not furnished["furnished"][0]["failed"]
    assert {room["id"] for room in furnished["rooms"] if room["objects"]} == {"store"}
    assert furnished["version"] > len(planned["options"])
    again = driver.call("furnish_home", home=planned["home"], requests={"wc": ""}, **FAST)
    homes = [sw.Home.loads(driver.read(f"home://{planned['home']}/{v['version']}")) for v in (furnished, again)]
    assert homes[1].room("store").scene == homes[0].room("store").scene
    assert homes[1].room("wc").scene is not None and homes[0].room("wc").scene is None
    assert again["valid"] == sw.check_home(homes[1]).valid


def test_a_room_is_taken_out_edited_and_put_back(served, furnished):
    driver, _ = served
    home, shelf = furnished["home"], None
    scene = driver.call("open_room", home=home, room="store", version=furnished["version"])
    shelf = next(o["id"] for o in scene["objects"] if "shelf" in o["category"])
    after = driver.call("remove", scene=scene["scene"], object=shelf, cascade=True)
    assert after["difference"]["removed"]
    put = driver.call("put_room", home=home, room="store", scene=scene["scene"], version=furnished["version"])
    now = sw.Home.loads(driver.read(f"home://{home}/{put['version']}")).room("store").scene
    assert shelf not in now.ids
    assert driver.call("close", scene=scene["scene"])["scene"] == scene["scene"]


def test_the_judge_follows_base_and_profile(served):
    driver, _ = served
    found = driver.call("check_home", home="h1")
    assert found["valid"] and found["plan_valid"] is None and found["entrance"] == "front-door"
    wide = driver.call("check_home", home="h1", robot_radius=0.6)
    assert not wide["valid"] and wide["blocked_doors"] and wide["violations"]
    accessible = driver.call("check_home", home="h1", profile="accessible")
    assert accessible["plan_valid"] is False and any("accessible" in line for line in accessible["violations"])
    report = json.loads(driver.read("report://h1"))
    assert report["report"]["valid"] and report["review"] is None


def test_a_plan_is_drawn_and_saved(served):
    driver, folder = served
    answer = driver.tell("render_home", home="h1", views=["plan", "plan_ground"], width=400, name="pictures/plan.png")
    assert not answer.is_error, answer.content[0].text
    images = [base64.b64decode(each.data) for each in answer.content if each.type == "image"]
    told = answer.structured_content["pictures"]
    assert [each["view"] for each in told] == ["plan_ground"] and told[0]["file"] is not None
    assert (folder / told[0]["file"]).read_bytes() == images[0]
    with Image.open(io.BytesIO(images[0])) as picture:
        assert picture.width == 400 and len(picture.convert("RGB").getcolors(10**6)) > 30


def test_an_export_can_be_opened_again(served):
    driver, folder = served
    formats = ["home", "plan", "report", "glb"]
    exported = driver.call("export_home", home="h1", formats=formats, folder="out/flat", textures=False)
    files = {"home": "home.json", "plan_ground": "plan_ground.svg", "report": "report.html", "glb": "home.glb"}
    assert exported["files"] == files and "room-kitchen" in (folder / "out/flat/report.html").read_text()
    assert all((folder / "out/flat" / name).stat().st_size for name in exported["files"].values())
    listed = driver.call("list_scenes")
    assert "out/flat/home.json" in listed["home_files"] and "out/flat/home.json" not in listed["files"]
    assert {"flat"} == {*listed["home_examples"]} and "flat-2-bedrooms" in listed["programmes"]
    again = driver.call("open_home", name="out/flat")
    assert sw.Home.loads(driver.read(again["resource"])) == sw.Home.example("flat")
    assert driver.call("close", scene=again["home"])["versions"] == 1


def test_a_room_is_not_designed_in_the_folder_of_a_home_and_the_other_way_round(served):
    driver, folder = served
    for name, state, schema in (("a", "run.json", "home-run/1"), ("b", "state.json", "run/1")):
        (folder / "runs" / name).mkdir(parents=True)
        (folder / "runs" / name / state).write_text(json.dumps({"schema": f"sceneweaver.{schema}"}))
    assert "holds other things" in driver.refused("design", prompt="a study", folder="runs/a")
    assert "holds other things" in driver.refused("design_home", prompt="a flat", folder="runs/b")


def test_homes_are_kept_up_to_a_bound(tmp_path):
    server = build_server(tmp_path, device="cpu", limits=Limits(scenes=1))
    with connected(server) as driver:
        driver.call("open_home", name="flat")
        assert "close one first" in driver.refused("open_home", name="flat")
        driver.call("open", name="study")  # scenes are counted for themselves
        driver.call("close", scene="h1")
        assert driver.call("open_home", name="flat")["home"] == "h2"
    server.service.workers.close()


@pytest.mark.slow
def test_a_cancelled_design_takes_the_processes_of_its_rooms_along(tmp_path):
    server = build_server(tmp_path, device="cpu", limits=Limits(seconds=1800))
    rooms = threading.Event()
    with connected(server) as driver:
        options = {"prompt": "a two-bedroom flat", "folder": "flat", "steps": 50, "time_limit": 1700}
        call = driver.begin("design_home", lambda *each: "valid plans" in each[2] and rooms.set(), **options)
        assert rooms.wait(400)
        wait_for(grandchildren, 200)
        below = grandchildren()
        call.cancel()
        wait_for(lambda: not [pid for pid in below if Path(f"/proc/{pid}").exists()])
        wait_for(lambda: in_good_order(tmp_path))
        assert driver.call("list_scenes")["homes"] == []
        assert (tmp_path / "flat/plan.json").is_file()  # a run in this folder goes on from there
    server.service.workers.close()


def grandchildren():
    """What the processes that this one has started for servers have started: those that furnish rooms."""
    return [pid for child in children(os.getpid()) for pid in children(child)]


@pytest.mark.slow
def test_a_home_is_designed_into_a_folder_and_goes_on_there(tmp_path):
    server = build_server(tmp_path, device="cpu", limits=Limits(seconds=1800))
    heard = []
    options = {"prompt": "a one-bedroom flat", "plans": 64, "folder": "flat", "seed": 1, "time_limit": 1700, **FAST}
    with connected(server) as driver:
        answer = driver.begin("design_home", lambda *each: heard.append(each), **options).result(1780)
        assert not answer.is_error, answer.content[0].text
        made = answer.structured_content
        assert made["files"][:2] == ["home.json", "metrics.json"] and (tmp_path / "flat/plan.svg").is_file()
        assert {one["room"] for one in made["furnished"]} == {r["id"] for r in made["rooms"] if r["objects"]}
        assert len(heard) > len(made["furnished"]) and in_good_order(tmp_path)
        again = driver.call("design_home", **options)
        assert again["rooms"] == made["rooms"] and any("went on from the plan" in line for line in again["log"])
        assert "holds other things" in driver.refused("design", prompt="a study", folder="flat")
    server.service.workers.close()
