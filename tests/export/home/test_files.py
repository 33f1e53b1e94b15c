"""Files of homes, read back: every object stands where its room's scene has it; names, sharing, errors."""

from __future__ import annotations

import json
import re
import struct
from importlib import import_module
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.export import export_file, export_home
from sceneweaver.export.home.built import BuiltHome
from sceneweaver.export.home.glb import home_glb
from sceneweaver.export.home.names import HomeNames
from sceneweaver.export.home.robots import home_articulations
from sceneweaver.export.home.usd import home_layer
from sceneweaver.geometry.rotations import matrix
from sceneweaver.home import Home
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.objects import SceneObject
from tests.export.home.homes import ASSETS, desk_with_mug, flat, house, load

Usd: Any = import_module("pxr.Usd")
UsdGeom: Any = import_module("pxr.UsdGeom")
UsdPhysics: Any = import_module("pxr.UsdPhysics")
UsdValidation: Any = import_module("pxr.UsdValidation")


def placed(home: Home) -> dict[str, tuple[str, SceneObject, np.ndarray]]:
    """By name in the files: room, object of its scene, and its pose in the home [4, 4]."""
    found = {}
    for room in home.rooms:
        for thing in room.scene.objects if room.scene is not None else ():
            pose = np.eye(4)
            pose[:3, :3] = matrix(thing.pose.quaternion)
            pose[:3, 3] = thing.pose.position
            pose[2, 3] += home.storey(room.storey).elevation
            found[f"{room.id}:{thing.id}"] = room.id, thing, pose
    return found


def glb_document(data: bytes) -> dict[str, Any]:
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + length])


def world_poses(document: dict[str, Any]) -> dict[str, np.ndarray]:
    """Poses of nodes by name, in a z-up frame [4, 4]."""
    up = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])
    found: dict[str, np.ndarray] = {}

    def walk(number: int, above: np.ndarray) -> None:
        node = document["nodes"][number]
        own = np.eye(4)
        own[:3, :3] = matrix(node.get("rotation", (0, 0, 0, 1)))
        own[:3, 3] = node.get("translation", (0, 0, 0))
        here = above @ own
        assert node["name"] not in found
        found[node["name"]] = up @ here @ up.T
        for child in node.get("children", ()):
            walk(child, here)

    for root in document["scenes"][0]["nodes"]:
        walk(root, np.eye(4))
    return found


@pytest.mark.parametrize("home", [flat, house], ids=["flat", "house"])
def test_a_glb_has_each_object_once_at_its_pose(home) -> None:
    document = glb_document(home_glb(BuiltHome.of(home(), load), textures=False))
    poses = world_poses(document)
    for name, (_, _, pose) in placed(home()).items():
        assert np.abs(poses[name] - pose).max() < 1e-5
    groups = {n["name"]: n for n in document["nodes"] if n.get("extras", {}).get("kind") == "room"}
    assert set(groups) == {room.id for room in home().rooms}
    for name, (room, _, _) in placed(home()).items():
        inside = [document["nodes"][k]["name"] for k in groups[room]["children"]]
        assert name in inside


def test_meshes_that_rooms_share_are_there_once() -> None:
    document = glb_document(home_glb(BuiltHome.of(flat(), load), textures=False))
    mesh = {node["name"]: node.get("mesh") for node in document["nodes"]}
    assert mesh["bedroom:mug"] == mesh["bedroom-2:mug"] == mesh["living:mug"]
    names = [m["name"] for m in document["meshes"]]
    assert len(names) == len(set(names))
    walls = [n for n in names if ":walls:" in n]
    assert walls == ["home:walls:ground"]
    built = BuiltHome.of(flat(), load)
    files = [id(row.model) for row in home_articulations(built)]
    assert len(set(files)) < len(files)


def test_a_mjcf_has_each_object_at_its_pose(tmp_path) -> None:
    mujoco: Any = import_module("mujoco")
    for home in (flat(), house("u")):
        files = export_home(home, tmp_path / home.id, "mjcf", load)
        assert files["mjcf"] == tmp_path / home.id / "home.xml"
        model = mujoco.MjModel.from_xml_path(str(files["mjcf"]))
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        for name, (_, _, pose) in placed(home).items():
            body = model.body(name).id
            assert np.abs(data.xpos[body] - pose[:3, 3]).max() < 1e-5
            assert np.abs(data.xmat[body].reshape(3, 3) - pose[:3, :3]).max() < 1e-5
        # Two geoms that touch at the start do no more than that.
        assert all(data.contact[k].dist > -1e-4 for k in range(data.ncon))
        mujoco.MjModel.from_xml_path(str(tmp_path / home.id / "home-sleep.xml"))


def test_what_is_seen_of_a_home_is_no_part_of_its_physics(tmp_path) -> None:
    mujoco: Any = import_module("mujoco")
    files = export_home(flat(), tmp_path / "out", "mjcf", load, textures=False)
    model = mujoco.MjModel.from_xml_path(str(files["mjcf"]))
    seen = [model.geom(k).name for k in range(model.ngeom) if model.geom_group[k] == 2]
    assert any(name.startswith("home:walls:ground:visual") for name in seen)
    assert any(name.startswith("bath:floor:visual") for name in seen)
    for name in seen:
        assert model.geom(name).contype[0] == model.geom(name).conaffinity[0] == 0
    for k in range(model.ngeom):
        if model.geom(k).name.startswith("home:wall:"):
            assert model.geom_group[k] == 3
    assert not [m for m in range(model.nmesh) if "ceiling" in model.mesh(m).name]


def test_a_usd_has_each_object_below_its_room(tmp_path) -> None:
    for home in (flat(), house("l")):
        layer, _ = home_layer(BuiltHome.of(home, load), textures=False)
        stage = Usd.Stage.Open(layer)
        cache, seen = UsdGeom.XformCache(), {}
        for p in stage.Traverse():
            facts = p.GetCustomDataByKey("sceneweaver")
            if facts and "mount" in facts:
                seen[facts["id"]] = p
        expected = placed(home)
        assert set(seen) == set(expected)
        for name, (room, _, pose) in expected.items():
            found = np.array(cache.GetLocalToWorldTransform(seen[name])).T
            assert np.abs(found - pose).max() < 1e-5
            group = seen[name].GetParent().GetParent()
            assert group.GetParent().GetPath() == "/World/Rooms"
            assert group.GetCustomDataByKey("sceneweaver")["id"] == room
        names = [p.GetName() for p in stage.Traverse() if p.HasAPI(UsdPhysics.RigidBodyAPI) or p.IsA(UsdPhysics.Joint)]
        assert len(names) == len(set(names))


def test_the_validators_of_usd_have_nothing_against_it(tmp_path) -> None:
    files = export_home(house("u"), tmp_path, ["usd"], load)
    stage = Usd.Stage.Open(str(files["usd"]))
    assert not stage.GetCompositionErrors()
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [error.GetErrorAsString() for error in errors] == []


def test_doors_of_a_usd_turn_or_slide() -> None:
    stage = Usd.Stage.Open(home_layer(BuiltHome.of(flat(), load), textures=False)[0])
    doors = {p.GetName(): p for p in stage.GetPrimAtPath("/World/Doors").GetChildren()}
    built = BuiltHome.of(flat(), load)
    leaves = [leaf for found in built.leaves for leaf in found]
    assert len(doors) == len(leaves) == 7
    for leaf in leaves:
        made = doors[re.sub(r"[^A-Za-z0-9_]", "_", leaf.name)]
        joint = made.GetChild("joints").GetChild(f"{made.GetName()}_joint")
        assert joint.IsA(UsdPhysics.RevoluteJoint if leaf.joint == "hinge" else UsdPhysics.PrismaticJoint)
        high = joint.GetAttribute("physics:upperLimit").Get()
        assert high == pytest.approx(np.rad2deg(leaf.limits[1]) if leaf.joint == "hinge" else leaf.limits[1], rel=1e-5)
        # It may touch what carries it, and nothing far away.
        panel = made.GetChild(f"{made.GetName()}_leaf")
        pairs = [str(t) for t in panel.GetRelationship("physics:filteredPairs").GetTargets()]
        assert any("/home_opening_" in path or "/home_pocket_" in path for path in pairs)
        assert len([p for p in pairs if "/Structure/" in p]) < 12


def test_ceilings_of_a_usd_collide_and_are_not_seen() -> None:
    stage = Usd.Stage.Open(home_layer(BuiltHome.of(flat(), load), textures=False)[0])
    ceilings = stage.GetPrimAtPath("/World/Structure/Ceilings")
    assert len(ceilings.GetChildren()) == 6
    for p in ceilings.GetChildren():
        assert UsdGeom.Imageable(p).ComputeVisibility() == "invisible"
    colliders = [
        p for p in stage.Traverse() if "home_ceiling" in str(p.GetPath()) and p.HasAPI(UsdPhysics.CollisionAPI)
    ]
    assert colliders


def test_worlds_and_robots_have_each_object_at_its_pose(tmp_path) -> None:
    home = house()
    files = export_home(home, tmp_path / "out", ["sdf", "urdf"], load)
    rows = {row["name"]: row for row in json.loads(files["urdf"].read_text())["robots"]}
    world = Xml.fromstring(files["sdf"].read_text()).find("world")
    assert world is not None
    models = {m.get("name"): m for m in world.iterfind("model")}
    assert "home" in rows
    assert "home" in models
    for name, (_, _, pose) in placed(home).items():
        assert rows[name]["position"] == pytest.approx(pose[:3, 3].tolist(), abs=1e-5)
        assert matrix(rows[name]["quaternion"]) == pytest.approx(pose[:3, :3], abs=1e-5)
        written = [float(v) for v in (models[name.replace(":", "_")].findtext("pose") or "").split()]
        assert written[:3] == pytest.approx(pose[:3, 3].tolist(), abs=1e-5)
    for row in rows.values():
        robot = Xml.fromstring((tmp_path / "out" / row["file"]).read_text())
        for mesh in robot.iter("mesh"):
            assert (tmp_path / "out" / "urdf" / str(mesh.get("filename"))).is_file()
    for uri in world.iter("uri"):
        assert (tmp_path / "out" / str(uri.text)).is_file()


def test_no_two_names_are_alike_whatever_the_ids() -> None:
    home = flat()
    moved = {"bedroom": "a", "bedroom-2": "a:b", "living": "home", "kitchen": "a_b"}
    rooms = []
    for room in home.rooms:
        scene = room.scene
        if room.id in ("bedroom", "bedroom-2", "kitchen"):
            thing = desk_with_mug(9.0, 2.0, 0.0)
            ids = {"bedroom": "b:c", "bedroom-2": "c", "kitchen": "c"}
            objects = (thing[0].model_copy(update={"id": ids[room.id]}),)
            scene = Scene(id="s", room=home.shell(room.id), objects=objects)
        rooms.append(room.model_copy(update={"id": moved.get(room.id, room.id), "scene": scene}))
    doors = [
        d.model_copy(update={k: moved.get(getattr(d, k), getattr(d, k)) for k in ("room", "to", "opens_into")})
        for d in home.doors
    ]
    windows = [w.model_copy(update={"room": moved.get(w.room, w.room)}) for w in home.windows]
    changed = Home(id="names", rooms=tuple(rooms), doors=tuple(doors), windows=tuple(windows))
    names = HomeNames.of(changed)
    assert names.home == "home_"
    found = [name for named in names.things.values() for name in named.values()]
    legal = [re.sub(r"[^A-Za-z0-9_]", "_", name) for name in found]
    assert len(set(legal)) == len(legal)
    assert {"a_b:c", "a:b:c_2", "a:b:c_3"} <= set(found)
    world_poses(glb_document(home_glb(BuiltHome.of(changed, load), textures=False)))  # asserts it of nodes


def test_an_empty_home_is_written_too(tmp_path) -> None:
    files = export_home(Home.example("flat"), tmp_path / "out", "all", load)
    assert set(files) == {"glb", "usd", "mjcf", "sdf", "urdf"}
    assert all(path.is_file() and path.name.startswith("home.") for path in files.values())


def test_equal_homes_give_equal_files(tmp_path) -> None:
    for name in ("one", "two"):
        export_home(house(), tmp_path / name, "glb,mjcf,usda", load)
    for path in (p for p in (tmp_path / "one").rglob("*") if p.is_file()):
        assert path.read_bytes() == (tmp_path / "two" / path.relative_to(tmp_path / "one")).read_bytes()


def test_what_is_wrong_is_said_in_a_line(tmp_path) -> None:
    with pytest.raises(InputError, match="'scenestate' is for single rooms; homes are written as glb, usd, usda, mjcf"):
        export_home(flat(), tmp_path / "out", ["scenestate"], load)
    with pytest.raises(InputError, match="'obj' is no format"):
        export_home(flat(), tmp_path / "out", ["obj"], load)
    assert not (tmp_path / "out").exists()
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot be made"):
        export_home(flat(), tmp_path / "file" / "out", ["glb"], load)
    with pytest.raises(InputError):
        export_home(flat(), tmp_path / "out", ["glb"], lambda name: (_ for _ in ()).throw(InputError(f"asset: {name}")))
    assert not (tmp_path / "out").exists()


def test_one_file_by_its_suffix(tmp_path) -> None:
    assert export_file(flat(), tmp_path / "a.glb", load).stat().st_size > 1000
    assert export_file(flat(), tmp_path / "a.xml", load, textures=False).stat().st_size > 1000
    with pytest.raises(InputError, match="stands for no format"):
        export_file(flat(), tmp_path / "a.blend", load)


def test_the_command_line_writes_homes(tmp_path, capsys) -> None:
    from sceneweaver.cli.app import main

    home = Home.example("flat").with_scene("bath", None)
    home.save(tmp_path / "home.json")
    out = tmp_path / "out"
    assert main(["export", str(tmp_path / "home.json"), "--format", "mjcf", "-o", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert Path(said["files"]["mjcf"]) == out / "home.xml"
    assert said["objects"] == 0
    assert main(["export", str(tmp_path / "home.json"), "-o", str(tmp_path / "one.glb")]) == 0
    assert (tmp_path / "one.glb").is_file()


def test_the_public_function(tmp_path) -> None:
    assert sw.export_home is export_home
    assert set(ASSETS) >= {o.asset for r in flat().rooms if r.scene for o in r.scene.objects if o.asset}
