"""Whole rooms as SDF and as lists of URDF robots: what stands where, what moves, and files that are all there."""

from __future__ import annotations

import json
import math
from importlib import import_module
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from sceneweaver.assets import make
from sceneweaver.export import export_scene
from sceneweaver.export.articulations import placed_articulations
from sceneweaver.export.sdf import roll_pitch_yaw, sdf
from sceneweaver.physics.leaves import leaves
from sceneweaver.scene import Door, Pose, Room, Scene, Window

mujoco: Any = import_module("mujoco")

ASSETS = {a.id: a for a in (make("fridge", 1), make("kitchen_cabinet", 1), make("armchair", 2), make("rug", 1))}
FRIDGE, CABINET, CHAIR, RUG = ASSETS.values()


def _scene() -> Scene:
    room = Room(
        outline=((0, 0), (5, 0), (5, 4), (0, 4)),
        doors=(Door(id="d/1", wall=0, offset=0.5, width=0.9, height=2.0, swing="in-left"),),
        windows=(Window(id="w", wall=2, offset=1.0, width=1.2, height=1.0, sill=0.9),),
    )
    things = (
        FRIDGE.object("fridge 1", pose=Pose.from_yaw(4.0, 1.0, 0.0, 2.0)),
        CABINET.object("cabinet", pose=Pose.from_yaw(1.0, 3.5, 0.0, -1.0)),
        CHAIR.object("chair::a", pose=Pose.from_yaw(2.5, 2.0, 0.0, 0.3)),
        CHAIR.object("chair::b", pose=Pose.from_yaw(3.5, 3.0, 0.0, 0.9)),
        RUG.object("rug", pose=Pose.from_yaw(2.5, 2.0, 0.0, 0.0)),
    )
    return Scene(id="test", room=room, objects=things)


SCENE = _scene()


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp("robots")
    export_scene(SCENE, out, ["sdf", "urdf"], ASSETS.__getitem__)
    return out


def _numbers(element: Xml.Element | None) -> np.ndarray:
    assert element is not None and element.text is not None
    return np.array(element.text.split(), dtype=float)


def test_models_stand_where_objects_do(folder) -> None:
    world = Xml.parse(folder / "scene.sdf").getroot().find("world")
    assert world is not None
    models = {m.get("name"): m for m in world.findall("model")}
    assert list(models) == ["room", "fridge_1", "cabinet", "chair__a", "chair__b", "rug"]
    for thing, model in zip(SCENE.objects, list(models.values())[1:], strict=True):
        pose = _numbers(model.find("pose"))
        np.testing.assert_allclose(pose[:3], thing.pose.position, atol=1e-11)
        turn = Rotation.from_euler("xyz", pose[3:])
        assert (turn.inv() * Rotation.from_quat(thing.pose.quaternion)).magnitude() < 1e-12
    static = {name for name, m in models.items() if m.findtext("static") == "1"}
    welded = {name for name, m in models.items() if m.find("joint[@type='fixed']") is not None}
    assert static == {"rug"} and welded == {"room", "cabinet"}
    for model in models.values():
        names = [e.get("name") for e in (*model.findall("link"), *model.findall("joint"))]
        assert len(set(names)) == len(names)
    assert not models["rug"].findall(".//collision") and models["rug"].findall(".//visual")


def test_meshes_are_there_and_joints_have_limits(folder) -> None:
    root = Xml.parse(folder / "scene.sdf").getroot()
    named = {uri.text for uri in root.iter("uri")}
    there = {f"sdf/{p.name}" for p in (folder / "sdf").iterdir() if p.suffix == ".obj"}
    assert named == there
    joints = [j for j in root.iter("joint") if j.get("type") != "fixed"]
    links = len(FRIDGE.links) + len(CABINET.links) + 1
    assert len(joints) == links >= 3
    for joint in joints:
        low, high = (float(joint.findtext(f"axis/limit/{end}") or "nan") for end in ("lower", "upper"))
        assert low < high
        np.testing.assert_allclose(np.linalg.norm(_numbers(joint.find("axis/xyz"))), 1.0, atol=1e-8)


def test_bullet_gets_static_models_and_no_world(tmp_path) -> None:
    root = Xml.fromstring(sdf(SCENE, ASSETS.__getitem__, bullet=True)["scene.sdf"])
    static = {m.get("name") for m in root.iter("model") if m.findtext("static") == "1"}
    assert static == {"room", "cabinet", "rug"}
    assert not root.findall(".//joint[@type='fixed']")
    assert all(link.findtext("contact/lateral_friction") for link in root.iter("link"))


def test_robots_of_the_list_load_in_mujoco(folder) -> None:
    said = json.loads((folder / "scene.urdf.json").read_text())
    rows = said["robots"]
    assert [r["name"] for r in rows] == ["room", *(o.id for o in SCENE.objects)]
    assert [r["fixed"] for r in rows] == [True, False, True, False, False, True]
    assert rows[3]["file"] == rows[4]["file"] and len({r["file"] for r in rows}) == 5
    for row in rows:
        model = mujoco.MjModel.from_xml_path(str(folder / row["file"]))
        solid = int((model.geom_contype > 0).sum())
        assert (solid == 0) == (row["name"] == "rug")
    room = mujoco.MjModel.from_xml_path(str(folder / "urdf" / "room.urdf"))
    (leaf,) = leaves(SCENE.room)
    assert room.njnt == 1
    np.testing.assert_allclose(room.jnt_range[0], leaf.limits, atol=1e-6)
    data = mujoco.MjData(room)
    mujoco.mj_forward(room, data)
    np.testing.assert_allclose(data.xanchor[0], leaf.position, atol=1e-6)
    # The door opens into the room: its middle is beyond the wall's inner face.
    data.qpos[0] = leaf.limits[1]
    mujoco.mj_forward(room, data)
    assert data.xipos[-1][1] > 0.3


def test_an_export_is_replaced_and_other_files_stay(folder, tmp_path) -> None:
    out = tmp_path / "out"
    for names in (["sdf", "urdf"], ["sdf", "urdf"]):
        export_scene(SCENE, out, names, ASSETS.__getitem__)
        (out / "urdf" / "my_robot.urdf").write_text("mine")
    alone = SCENE.model_copy(update={"objects": SCENE.objects[2:3]})
    export_scene(alone, out, ["sdf", "urdf"], ASSETS.__getitem__)
    assert (out / "urdf" / "my_robot.urdf").read_text() == "mine"
    left = {p.name.split("-")[0].removesuffix(".urdf") for p in (out / "urdf").rglob("*") if p.is_file()}
    assert left == {"my_robot", "room", "armchair"}


@pytest.mark.parametrize("angles", [(0, 0, 0), (0, 0, 2.5), (1.5707, 0.2, -3.0), (-0.4, math.pi / 2 - 1e-4, 0.7)])
def test_angles_are_those_of_the_rotation(angles) -> None:
    turn = Rotation.from_euler("xyz", angles)
    found = roll_pitch_yaw(tuple(turn.as_quat()))
    assert (Rotation.from_euler("xyz", found).inv() * turn).magnitude() < 1e-9


@pytest.mark.parametrize("category", ["magazine_stack", "chair"])
def test_balls_under_a_model_stand_on_its_lowest_face(category) -> None:
    """Where the underside is one face they are a quarter of the way in, off the bevels; else in its corners."""
    asset = make(category, 3)
    thing = asset.object("a", mount="floor", pose=Pose.from_yaw(1.5, 1.5, 0.0, 0.4))
    scene = Scene(id="s", room=Room.rectangle(4, 4), objects=(thing,))
    root = Xml.fromstring(sdf(scene, lambda _: asset)["scene.sdf"])
    links = [link for model in root.iter("model") if model.get("name") != "room" for link in model.iterfind("link")]
    for placed, link in zip(placed_articulations(scene, lambda _: asset)[1:], links, strict=True):
        studs = [c for c in link.iterfind("collision") if str(c.get("name")).startswith("stud")]
        at = np.array([[float(v) for v in str(c.findtext("pose")).split()[:3]] for c in studs])
        shapes = placed.model.links[0].shapes
        low = min(shape.points[:, 2].min() for shape in shapes)
        assert len(at) == 4
        assert np.allclose(at[:, 2], low + 1e-3, atol=1e-4)
        single = [shape for shape in shapes if shape.points[:, 2].min() < low + 1e-4]
        if category == "magazine_stack":
            assert len(single) == 1
            face = single[0].points[single[0].points[:, 2] < low + 1e-4][:, :2]
            assert np.ptp(at[:, 0]) < 0.85 * np.ptp(face[:, 0])
            assert np.ptp(at[:, 0]) > 0.6 * np.ptp(face[:, 0])
        else:
            assert len(single) > 1
