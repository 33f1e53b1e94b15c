"""The same conversation over stdio and over streamable HTTP."""

from __future__ import annotations

import base64
import io
import json
import re
import threading

import pytest
from PIL import Image

import sceneweaver as sw
from tests.mcp.driving import LONG, connected, in_good_order, wait_for

TOOLS = {
    *("design", "open", "list_scenes", "close", "move", "turn", "resize", "add", "remove", "relate", "unrelate"),
    *("edit", "undo", "redo", "diff", "refine", "repair", "check", "explain", "render", "export", "list_furniture"),
    *("plan_home", "design_home", "open_home", "furnish_home", "check_home", "render_home", "export_home"),
    *("open_room", "put_room"),
}


def test_every_tool_is_listed_with_its_schemas(site):
    tools = site.driver.portal.call(site.driver.client.list_tools).tools
    assert {tool.name for tool in tools} == TOOLS
    for tool in tools:
        assert tool.description and tool.output_schema and tool.input_schema["additionalProperties"] is False, tool.name


def test_a_design_reports_its_steps_and_leaves_its_files(site):
    assert site.room["valid"] and site.room["version"] == 1
    assert [message for *_, message in site.heard][-1].startswith("step 1 of 1: init_prior kept")
    values = [done for done, *_ in site.heard]
    assert values == sorted(set(values))
    kept = sw.Scene.load(site.folder / "rooms/store/scene.json")
    assert kept.ids == tuple(o["id"] for o in site.room["objects"])


def test_the_desk_is_moved_undone_done_again_and_compared(site):
    call, handle = site.driver.call, site.room["scene"]
    here = next(o for o in site.room["objects"] if o["id"] == site.desk)["position"]
    moved = call("move", scene=handle, object=site.desk, by=[0.05, 0.05])
    assert moved["valid"] and moved["version"] == 2
    assert site.desk in [each["id"] for each in moved["difference"]["moved"]]
    assert call("undo", scene=handle)["version"] == 1
    scene = sw.Scene.loads(site.driver.read(f"scene://{handle}"))
    assert scene.object(site.desk).pose.position == pytest.approx(here, abs=1e-3)
    assert call("redo", scene=handle)["version"] == 2
    told = call("diff", scene=handle, before=1, after=2)["difference"]
    assert told == moved["difference"] and not told["added"] and not told["room"]
    assert call("undo", scene=handle)["version"] == 1


def test_the_judge_and_the_resources_agree(site):
    handle = site.room["scene"]
    checked = site.driver.call("check", scene=handle)
    assert checked["valid"] and checked["violations"] == [] and checked["counts"]["collisions"] == 0
    report = json.loads(site.driver.read(checked["resource"]))
    assert report["report"]["valid"] and report["review"]["grades"]
    assert sw.check(sw.Scene.loads(site.driver.read(f"scene://{handle}/1"))).valid
    listed = site.driver.portal.call(site.driver.client.list_resources).resources
    assert {f"scene://{handle}", f"report://{handle}"} <= {str(each.uri) for each in listed}
    templates = site.driver.portal.call(site.driver.client.list_resource_templates).resource_templates
    of_homes = {"home://{home}", "home://{home}/{version}"}
    of_scenes = {"scene://{scene}", "scene://{scene}/{version}", "report://{scene}"}
    assert {t.uri_template for t in templates} == of_scenes | of_homes


def test_a_picture_comes_through_and_is_saved(site):
    answer = site.driver.tell("render", scene=site.room["scene"], views=["plan"], width=400, name="pictures/plan.png")
    assert not answer.is_error, answer.content[0].text
    image = next(each for each in answer.content if each.type == "image")
    data = base64.b64decode(image.data)
    with Image.open(io.BytesIO(data)) as picture:
        assert image.mime_type == "image/png" and picture.format == "PNG" and picture.width == 400
        assert len(picture.convert("RGB").getcolors(10**6)) > 50
    assert (site.folder / "pictures/plan.png").read_bytes() == data


def test_an_export_can_be_opened_again(site):
    options = {"scene": site.room["scene"], "formats": ["scene", "mjcf"], "folder": "out/store", "textures": False}
    exported = site.driver.call("export", **options)
    assert exported["files"] == {"scene": "scene.json", "mjcf": "scene.xml"}
    assert (site.folder / "out/store/scene.xml").read_text().startswith("<mujoco")
    assert site.driver.call("export", **options)["folder"] == "out/store"  # its own files are replaced
    again = site.driver.call("open", name="out/store")
    assert again["objects"] == site.room["objects"]
    assert [each["scene"] for each in site.driver.call("list_scenes")["open"]] == [site.room["scene"], again["scene"]]
    assert site.driver.call("close", scene=again["scene"])["versions"] == 1
    assert "not open" in site.driver.refused("check", scene=again["scene"])


def test_names_that_lead_out_are_refused(site):
    (site.folder / "elsewhere").symlink_to("/")
    for name in ("../x.png", "/tmp/x.png", "elsewhere/tmp/x.png"):
        line = site.driver.refused("render", scene=site.room["scene"], name=name)
        assert line.startswith("name: ") and not re.search(r"[^']/(home|root|work)/", line), line


def test_an_error_is_one_line_and_the_server_goes_on(site):
    assert "no object of scene" in site.driver.refused("move", scene=site.room["scene"], object="throne", by=[1, 0])
    assert "unknown" in site.driver.refused("juggle").lower()
    assert site.driver.call("list_furniture", words="desk")["furniture"][0]["category"] == "desk"


def test_two_clients_share_scenes(http_site):
    stays, handle = http_site.driver, http_site.room["scene"]
    with connected(http_site.address) as other:
        assert handle in [each["scene"] for each in other.call("list_scenes")["open"]]
        last = max(stays.call("list_scenes")["open"][0]["versions"])
        options = {"scene": handle, "object": http_site.desk, "degrees": 5, "exact": True}
        turns = [driver.begin("turn", **options) for driver in (other, stays)]
        assert sorted(turn.result(60).structured_content["version"] for turn in turns) == [last + 1, last + 2]
    assert stays.call("undo", scene=handle)["version"] == last + 1


def test_a_cancelled_design_ends_and_the_server_goes_on(site):
    begun = threading.Event()
    before = site.driver.call("list_scenes")["open"]
    call = site.driver.begin("design", lambda *_: begun.set(), folder="big", **LONG)
    assert begun.wait(60)
    assert site.driver.call("list_scenes")["open"] == before  # it answers meanwhile
    call.cancel()
    wait_for(lambda: (site.folder / "big/scene.json").exists() and in_good_order(site.folder))
    assert site.driver.call("list_scenes")["open"] == before


@pytest.mark.slow
def test_a_client_that_leaves_takes_its_work_along(http_site):
    begun = threading.Event()
    with connected(http_site.address) as leaves:
        leaves.begin("design", lambda *_: begun.set(), folder="left", **LONG)
        assert begun.wait(60)
    wait_for(lambda: (http_site.folder / "left/scene.json").exists() and in_good_order(http_site.folder))
    assert "bed" in http_site.driver.tell("list_furniture", words="bed").content[0].text
