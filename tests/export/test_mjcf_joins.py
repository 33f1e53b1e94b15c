"""The MJCF of a room among others: names, sites, and a robot that joins it."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.export import FORMATS, export_scene
from sceneweaver.export.mjcf import mjcf, write_mjcf
from sceneweaver.geometry.rotations import rotate
from sceneweaver.physics.vertices import MOST_VERTICES, fewer_vertices
from sceneweaver.scene import Door, InputError, Pose, Room, Scene, Support

mujoco: Any = import_module("mujoco")

ASSETS = {a.id: a for a in (make("filing_cabinet", 1), make("kitchen_cabinet", 2), make("rug", 1), make("mug", 2))}
CABINET, KITCHEN, RUG, MUG = ASSETS.values()
ROBOT = """
<mujoco model="robot">
 <compiler angle="{angle}"/>
 <default><geom rgba="1 0 0 1" group="1"/></default>
 <worldbody><body name="arm" pos="2 2 1">
  <joint name="elbow" range="0 {limit}"/><geom name="hand" size="0.1"/>
 </body></worldbody>
 <actuator><position name="drive" joint="elbow" kp="5"/></actuator>
</mujoco>
"""


@pytest.fixture(scope="module")
def scene() -> Scene:
    room = Room.polygon([(0, 0), (4, 0), (4, 4), (0, 4)], height=2.6)
    room = room.model_copy(update={"doors": (Door(id="in/out", wall=0, offset=0.5, width=0.9, height=2.0),)})
    top = CABINET.surfaces[0]
    objects = (
        CABINET.object("files/1", pose=Pose.from_yaw(2, 2, 0, 0.7)),
        KITCHEN.object("unit", pose=Pose.from_yaw(2, 3.65, 0, -np.pi / 2)),
        RUG.object("rug", pose=Pose.from_yaw(2, 2, 0, 0.1)),
        MUG.object("mug", pose=Pose.from_yaw(2, 2, top.z, 0), support=Support(object="files/1", surface=top.name)),
    )
    return Scene(id="s", room=room, objects=objects)


@pytest.fixture(scope="module")
def path(scene, tmp_path_factory) -> Path:
    return write_mjcf(scene, tmp_path_factory.mktemp("out") / "s", ASSETS.__getitem__)


def test_every_name_is_legal_and_there_once(path) -> None:
    text = path.read_text()
    assert not re.search(r'name="[^"]*/', text) and "<compiler" not in text
    model = mujoco.MjModel.from_xml_path(str(path))
    names = [model.geom(k).name for k in range(model.ngeom)]
    assert all(names) and len(set(names)) == len(names)
    for name in ("files-1:part:0", "files-1:visual:0", "files-1.drawer-0:handle:0", "room:wall:0:part:0", "room:floor"):
        assert name in names
    assert {"room:top", "room:eye-door", "room:eye-corner"} <= {model.camera(k).name for k in range(model.ncam)}
    files = re.findall(r'file="([^"]*)"', text)
    assert "vertex=" not in text and all((path.parent / name).is_file() for name in files)
    used = {str(p.relative_to(path.parent)) for p in path.parent.rglob("*.*") if p.suffix in (".obj", ".png")}
    assert used == set(files)


def test_the_keyframe_is_the_scene(path) -> None:
    model = mujoco.MjModel.from_xml_path(str(path))
    assert np.array_equal(model.key("start").qpos, model.qpos0)


def test_sites_lie_where_the_asset_says(path) -> None:
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    pose = Pose.from_yaw(2, 2, 0, 0.7)

    def world(point) -> np.ndarray:
        return np.array(rotate(pose.quaternion, point)) + pose.position

    assert CABINET.grasps and CABINET.interiors
    for grasp in CABINET.grasps:
        site = data.site(f"files-1.{CABINET.links[grasp.link - 1].name}:grasp:{grasp.name}")
        frame = site.xmat.reshape(3, 3)
        assert np.allclose(site.xpos, world(grasp.position), atol=1e-6)
        assert np.allclose(frame[:, 2], rotate(pose.quaternion, grasp.approach), atol=1e-6)
        assert np.allclose(frame[:, 1], rotate(pose.quaternion, grasp.closing), atol=1e-6)
    for inside in CABINET.interiors:
        name = f"files-1.{CABINET.links[inside.link - 1].name}:interior:{inside.name}"
        assert np.allclose(data.site(name).xpos, world(np.add(inside.low, inside.high) / 2), atol=1e-6)
        assert np.allclose(2 * model.site(name).size, np.subtract(inside.high, inside.low), atol=1e-6)
    door = data.site("room:spawn:in-out")
    assert np.allclose(door.xpos, (0.95, 0.45, 0), atol=1e-6) and np.allclose(door.xmat.reshape(3, 3)[:, 0], (0, 1, 0))


def _checked(model) -> None:
    """The room and the robot are both what they were."""
    named = {model.joint(k).name.split(":")[-1]: k for k in range(model.njnt)}
    for asset, object_id in ((KITCHEN, "unit"), (CABINET, "files-1")):
        for link in asset.links:
            found = next(k for name, k in named.items() if name.endswith(f"{object_id}.{link.name}"))
            assert np.allclose(model.jnt_range[found], link.limits, atol=1e-6)
    elbow = next(k for k in range(model.njnt) if model.joint(k).name.endswith("elbow"))
    assert model.jnt_range[elbow] == pytest.approx((0, np.pi / 2), abs=1e-5)
    hand = next(k for k in range(model.ngeom) if model.geom(k).name.endswith("hand"))
    assert model.geom_group[hand] == 1 and model.geom_rgba[hand, 0] == 1, "defaults of the room hold for the room alone"
    cabinet = next(k for k in range(model.ngeom) if model.geom(k).name.endswith("unit:part:0"))
    assert model.geom_group[cabinet] == 3
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 20)
    assert np.isfinite(data.qpos).all() and np.abs(data.qvel).max() < 1


@pytest.mark.filterwarnings("ignore:Attach conflict")  # options are those of the parent, and MuJoCo says so
@pytest.mark.parametrize(("angle", "limit"), [("radian", np.pi / 2), ("degree", 90)])
def test_a_room_and_a_robot_are_attached_to_each_other(path, angle, limit) -> None:
    for child_first in (False, True):
        robot = mujoco.MjSpec.from_string(ROBOT.format(angle=angle, limit=limit))
        room = mujoco.MjSpec.from_file(str(path))
        parent, other = (room, robot) if child_first else (robot, room)
        parent.attach(other, prefix="other:", frame=parent.worldbody.add_frame())
        _checked(parent.compile())


def test_a_robot_is_included(path) -> None:
    (path.parent / "robot.xml").write_text(ROBOT.format(angle="degree", limit=90))
    for names in (("robot.xml", "scene.xml"), ("scene.xml", "robot.xml")):
        whole = path.parent / "whole.xml"
        whole.write_text("<mujoco>" + "".join(f'<include file="{name}"/>' for name in names) + "</mujoco>")
        _checked(mujoco.MjModel.from_xml_path(str(whole)))


def test_rugs_touch_what_is_not_on_the_floor(path) -> None:
    model = mujoco.MjModel.from_xml_path(str(path))

    def touch(one: str, two: str) -> bool:
        a, b = model.geom(one), model.geom(two)
        return bool((a.contype[0] & b.conaffinity[0]) | (b.contype[0] & a.conaffinity[0]))

    rug, cabinet, drawer = "rug:part:0", "files-1:part:0", "files-1.drawer-0:part:0"
    assert not touch(rug, cabinet) and not touch(rug, drawer) and not touch(rug, "room:door:in-out:part:0")
    for other in ("mug:part:0", "room:floor", "room:wall:0:part:0"):
        assert touch(rug, other) and touch(cabinet, other) and touch(drawer, other)
    assert touch(cabinet, "unit:part:0")


def test_hulls_have_few_vertices_within_the_whole_one() -> None:
    turn = 2 * np.pi * np.arange(60) / 60
    rings = [np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(60, z)]) for r, z in ((0.1, 0), (0.13, 0.2))]
    points = np.concatenate(rings)
    found = fewer_vertices(points)
    assert len(found) == MOST_VERTICES and {tuple(p) for p in found} <= {tuple(p) for p in points}
    for z, radius, count, narrower in ((0.0, 0.1, 8, 9e-3), (0.2, 0.13, 20, 1.5e-3)):
        level = found[found[:, 2] == z]
        assert len(level) == 8 if z == 0 else len(level) >= count, "a few corners to stand on, a top as wide as before"
        corners = np.sort(np.arctan2(level[:, 1], level[:, 0]))
        gap = np.diff(np.append(corners, corners[0] + 2 * np.pi)).max()
        assert radius * (1 - np.cos(gap / 2)) < narrower
    cube = np.array([(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    assert np.array_equal(fewer_vertices(cube), cube)


def test_what_is_at_rest_sleeps(path) -> None:
    text = (path.parent / "scene-sleep.xml").read_text()
    assert "sleep=" in text and "sleep=" not in path.read_text(), "older versions refuse it"
    model = mujoco.MjModel.from_xml_path(str(path.parent / "scene-sleep.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 250)
    assert model.ntree > 2 and (data.tree_asleep >= 0).all()


def test_each_client_has_its_file(scene, tmp_path) -> None:
    whole = mjcf(scene, ASSETS.__getitem__, textures=False)
    for client in FORMATS["mjcf"].clients:
        mine = mjcf(scene, ASSETS.__getitem__, textures=False, client=client)
        model = mujoco.MjModel.from_xml_string(mine.xml, mine.files)
        other = mujoco.MjModel.from_xml_string(whole.xml, whole.files)
        for name in (
            "jnt_range",
            "geom_contype",
            "geom_conaffinity",
            "geom_group",
            "body_mass",
            "site_pos",
            "geom_rgba",
        ):
            assert np.allclose(getattr(model, name), getattr(other, name), atol=1e-6), (client, name)
    text = mjcf(scene, ASSETS.__getitem__, textures=False, client="robosuite").xml
    assert "childclass" not in text and "<default" not in text
    with pytest.raises(InputError, match="export: 'mjcf:unreal' is no format; clients of mjcf are mujoco, robosuite"):
        export_scene(scene, tmp_path / "x", ["mjcf:unreal"])
    with pytest.raises(InputError, match="'mjcf' and 'mjcf:drake' are one file, scene.xml; choose one"):
        export_scene(scene, tmp_path / "x", ["mjcf", "mjcf:drake"])
    files = export_scene(scene, tmp_path / "x", ["mjcf:mujoco"], ASSETS.__getitem__, textures=False)
    assert "sleep=" in files["mjcf:mujoco"].read_text() and files["mjcf:mujoco"].name == "scene.xml"


def test_what_could_be_taken_is_welded_on_demand(tmp_path) -> None:
    asset = make("fruit_bowl", 1)
    assert any(link.joint == "free" for link in asset.links)
    room = Room.polygon([(0, 0), (2, 0), (2, 2), (0, 2)], height=2.4)
    scene = Scene(id="s", room=room, objects=(asset.object("bowl", mount="floor"),))
    masses = []
    for welded in (False, True):
        files = export_scene(scene, tmp_path / str(welded), ["mjcf"], {asset.id: asset}.__getitem__, welded=welded)
        model = mujoco.MjModel.from_xml_path(str(files["mjcf"]))
        free = int((model.jnt_type == mujoco.mjtJoint.mjJNT_FREE).sum())
        assert free == (1 if welded else 1 + sum(link.joint == "free" for link in asset.links))
        masses.append(sum(float(model.body_mass[k]) for k in range(model.nbody) if "bowl" in model.body(k).name))
    assert masses == pytest.approx([asset.mass] * 2, rel=1e-6)
