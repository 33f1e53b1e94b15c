"""Left and right through MCP: whose they are has to be said, and is what the engine, the judge and the file go by."""

from __future__ import annotations

import math

import pytest

import sceneweaver as sw
from sceneweaver.mcp import build_server
from tests.layout.made import room
from tests.mcp.driving import connected

TURNED = math.radians(90.0)  # the front of the desk is +y: its own left is -x


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sides")
    desk = sw.SceneObject(
        id="desk", category="desk", size=(0.7, 1.4, 0.75), pose=sw.Pose.from_yaw(2.5, 2.0, 0.0, TURNED)
    )
    plant = sw.SceneObject(
        id="plant", category="plant", size=(0.4, 0.4, 1.2), pose=sw.Pose.from_yaw(2.5, 3.4, 0.0, 0.0)
    )
    sw.Scene(id="study", room=room(), objects=(desk, plant)).save(folder / "study.json")
    built = build_server(folder, device="cpu")
    with connected(built) as driver:
        yield driver
    built.service.workers.close()


@pytest.mark.parametrize(
    ("kind", "frame", "side"),
    [("left_of", "own", -1), ("left_of", "viewer", 1), ("right_of", "own", 1), ("right_of", "viewer", -1)],
)
def test_it_stands_on_the_side_that_was_meant(server, kind, frame, side):
    handle = server.call("open", name="study.json")["scene"]
    related = server.call("relate", scene=handle, subject="plant", type=kind, target="desk", frame=frame)
    scene = sw.Scene.loads(server.read(f"scene://{handle}"))
    assert related["valid"] and sw.check(scene).valid
    (stated,) = scene.relations
    assert (stated.type, stated.params["frame"]) == (kind, frame)
    desk, plant = scene.object("desk"), scene.object("plant")
    x, y = (b - a for a, b in zip(desk.pose.position[:2], plant.pose.position[:2], strict=True))
    angle = desk.pose.yaw - TURNED  # the engine may turn the desk as well
    assert side * (x * math.cos(angle) + y * math.sin(angle)) > 0.7
    server.call("close", scene=handle)


@pytest.mark.parametrize("kind", ["left_of", "right_of"])
def test_without_a_frame_it_is_refused(server, kind):
    handle = server.call("open", name="study.json")["scene"]
    line = server.refused("relate", scene=handle, subject="plant", type=kind, target="desk")
    assert "frame" in line and "viewer" in line
    assert not sw.Scene.loads(server.read(f"scene://{handle}")).relations
    server.call("close", scene=handle)
