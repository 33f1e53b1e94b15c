"""SceneState JSON and its models, read with json, numpy and trimesh as SceneEval does it."""

from __future__ import annotations

import io
import json
import math
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from scipy.spatial import KDTree

from sceneweaver.assets import make
from sceneweaver.export import glb_bytes
from sceneweaver.export.names import model_name
from sceneweaver.export.scenestate import scenestate, write_scenestate
from sceneweaver.knowledge.library import load_scene
from sceneweaver.scene import Door, InputError, Part, Pose, Room, Scene, SceneObject, Support, Window

Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)

ROOM = Room(
    type="study",
    outline=((0, 0), (5, 0.6), (5, 3), (3, 3), (3, 4), (0, 4)),
    height=2.6,
    doors=(
        Door(id="door-0", wall=0, offset=0.5, width=0.9, height=2.0),
        Door(id="door-1", wall=5, offset=0.3, width=0.8, height=2.1, swing="out"),
    ),
    windows=(
        Window(id="window-0", wall=1, offset=0.9, width=1.2, sill=0.9, height=1.2),
        Window(id="window-1", wall=4, offset=1.5, width=0.6, sill=1.0, height=0.7),
    ),
)
ASSETS = {a.id: a for a in (make("desk", 3), make("table_lamp", 1), make("armchair", 2), make("mug", 2))}
DESK, LAMP, CHAIR, MUG = ASSETS.values()


def _unit(*q: float) -> tuple[float, float, float, float]:
    x, y, z, w = (np.array(q) / np.linalg.norm(q)).tolist()
    return x, y, z, w


def _scene() -> Scene:
    top = DESK.surfaces[0]
    d, w, h = DESK.size
    scaled = DESK.object("desk, scaled").model_copy(
        update={"size": (d * 1.2, w * 0.7, h * 1.1), "pose": Pose(position=(4, 2, 0.1), quaternion=_unit(2, -1, 3, 9))}
    )
    parts = (
        Part(polygon=((-0.3, -0.2), (0.3, -0.2), (0, 0.4)), z=(0, 0.5)),
        Part(polygon=((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)), z=(0.5, 0.8)),
    )
    objects = (
        MUG.object(
            "mug.1", pose=Pose.from_yaw(1.0, 1.5, top.z, 0.3), support=Support(object="desk é/1", surface=top.name)
        ),
        DESK.object("desk é/1", pose=Pose.from_yaw(1.0, 1.5, 0.0, 2.1)),
        scaled,
        LAMP.object("lamp", mount="floor", pose=Pose.from_yaw(0.4, 3.5, 0.0, -0.7)),
        CHAIR.object("chair", pose=Pose(position=(2.0, 2.0, 0.1), quaternion=_unit(0.2, -0.1, 0.3, 0.9))),
        SceneObject(
            id="plinth",
            category="Plinth, red!",
            size=(0.6, 0.6, 0.8),
            parts=parts,
            pose=Pose.from_yaw(2.0, 0.9, 0.0, 1.0),
        ),
        SceneObject(id="plain", category="box", size=(0.3, 0.4, 0.5), pose=Pose.from_yaw(0.5, 3.0, 0.0, 0.4)),
    )
    return Scene(id="s", prompt="p", room=ROOM, objects=objects)


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> tuple[Scene, dict[str, Any], Path]:
    scene = _scene()
    path = write_scenestate(scene, tmp_path_factory.mktemp("out") / "scene_0.json", ASSETS.__getitem__, models=True)
    return scene, json.loads(path.read_text(encoding="utf-8"))["scene"], path.parent


def _placed(entry: dict[str, Any], folder: Path) -> np.ndarray:
    """World vertices of an object: its model through its matrix, as SceneEval's reader puts it."""
    source, name = entry["modelId"].split(".")
    assert source == "sceneweaver"
    mesh: Any = trimesh.load(folder / "models" / name / f"{name}.glb", force="mesh", process=False)
    mesh.apply_transform(np.asarray(entry["transform"]["data"]).reshape(4, 4).T)
    return np.asarray(mesh.vertices)


def _same_points(one: np.ndarray, other: np.ndarray, tolerance: float) -> None:
    """Every point of each is one of the other's: with textures, corners have vertices of their own."""
    for a, b in ((one, other), (other, one)):
        assert KDTree(a).query(b)[0].max() < tolerance


def test_world_vertices_are_those_of_the_glb(written) -> None:
    scene, state, folder = written
    loaded: Any = trimesh.load(
        io.BytesIO(glb_bytes(scene, ASSETS.__getitem__)), file_type="glb", process=False, merge_primitives=True
    )
    assert [entry["id"] for entry in state["object"]] == list(scene.ids)
    for entry in state["object"]:
        matrix, name = loaded.graph[entry["id"]]
        expected = trimesh.transform_points(loaded.geometry[name].vertices, Z_UP @ matrix)
        _same_points(_placed(entry, folder), expected, 2e-6)


def _points_of(loaded: Any, object_id: str) -> np.ndarray:
    """The vertices of an object and of its doors and drawers in the world, z up."""
    nodes = [object_id, *(n for n in loaded.graph.nodes if n.startswith(f"{object_id}."))]
    found = [loaded.graph[node] for node in nodes]
    return np.concatenate(
        [trimesh.transform_points(loaded.geometry[name].vertices, Z_UP @ matrix) for matrix, name in found if name]
    )


def test_a_real_room(tmp_path) -> None:
    scene = load_scene("bathroom-1")
    path = write_scenestate(scene, tmp_path / "scene.json", models=True)
    state = json.loads(path.read_text(encoding="utf-8"))["scene"]
    data = io.BytesIO(glb_bytes(scene, textures=False))
    loaded: Any = trimesh.load(data, file_type="glb", process=False, merge_primitives=True)
    for entry in state["object"]:
        _same_points(_placed(entry, tmp_path), _points_of(loaded, entry["id"]), 5e-6)
    named = {entry["modelId"].split(".")[1] for entry in state["object"]}
    assert {p.name for p in (tmp_path / "models").iterdir()} == named
    assert len(named) == len({o.asset for o in scene.objects}) < len(scene.objects)


def test_the_matrix_is_what_its_parts_make(written) -> None:
    for entry in written[1]["object"]:
        t = entry["transform"]
        matrix = np.asarray(t["data"]).reshape(t["cols"], t["rows"]).T
        x, y, z, w = t["rotation"]
        turn = trimesh.transformations.quaternion_matrix((w, x, y, z))
        made = trimesh.transformations.translation_matrix(t["translation"]) @ turn @ np.diag([*t["scale"], 1.0])
        np.testing.assert_allclose(matrix, made, atol=1e-12)
        assert np.linalg.det(matrix[:3, :3]) > 0, "nothing is mirrored"


def test_front_and_up_of_models(written) -> None:
    scene, state, _ = written
    for thing, entry in zip(scene.objects, state["object"], strict=True):
        turn = np.asarray(entry["transform"]["data"]).reshape(4, 4).T[:3, :3]
        if thing.pose.quaternion[0] == thing.pose.quaternion[1] == 0:
            front = turn @ (0, 0, 1)
            np.testing.assert_allclose(front, (math.cos(thing.pose.yaw), math.sin(thing.pose.yaw), 0), atol=1e-9)
            np.testing.assert_allclose(turn @ (0, 1, 0), (0, 0, 1), atol=1e-9)


def test_boxes_hold_the_vertices_tightly(written) -> None:
    scene, state, folder = written
    for thing, entry in zip(scene.objects, state["object"], strict=True):
        box = entry["obb"]
        axes = np.asarray(box["normalizedAxes"]).reshape(3, 3)
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-9)
        local = (_placed(entry, folder) - box["centroid"]) @ axes.T
        if thing.id != "plinth":  # its parts do not fill its box
            np.testing.assert_allclose(local.max(axis=0), np.asarray(box["axesLengths"]) / 2, atol=2e-5)
            np.testing.assert_allclose(local.min(axis=0), -np.asarray(box["axesLengths"]) / 2, atol=2e-5)


def test_header_ids_and_parents(written) -> None:
    scene, state, folder = written
    assert (state["version"], state["up"], state["front"], state["unit"]) == ("scene@1.0.2", [0, 0, 1], [0, 1, 0], 1.0)
    whole = json.loads((folder / "scene_0.json").read_text(encoding="utf-8"))
    assert whole["format"] == "sceneState"
    assert whole == scenestate(scene, ASSETS.__getitem__)
    entries = {entry["id"]: entry for entry in state["object"]}
    assert [entry["index"] for entry in state["object"]] == list(range(len(scene.objects)))
    assert (entries["mug.1"]["parentId"], entries["mug.1"]["parentIndex"]) == ("desk é/1", 1)
    assert (entries["chair"]["parentId"], entries["chair"]["parentIndex"]) == ("", -1)
    assert entries["desk é/1"]["modelId"] == entries["desk, scaled"]["modelId"], "an asset is one model"
    names = {entry["modelId"].split(".")[1] for entry in state["object"]}
    assert {p.name for p in (folder / "models").iterdir()} == names and len(names) == 6
    assert all(set(name) <= set("abcdefghijklmnopqrstuvwxyz0123456789_-") for name in names)
    data = json.loads((folder / "models" / model_name(DESK.id, "desk") / "data.json").read_text(encoding="utf-8"))
    assert data["annotations"]["category"] == "desk" and data["annotations"]["description"]
    assert not [n for n in os.listdir(folder) if n.endswith(".tmp")]


def test_model_names_differ_for_ids_that_look_alike() -> None:
    ids = ["parametric:desk?seed=1", "parametric:desk?seed=11", "parametric:desk?seed=1 ", "x/desk.1", "x/desk/1"]
    assert len({model_name(object_id, "desk") for object_id in ids}) == len(ids)
    assert model_name("a", "../é. .") == model_name("a", "é") and "." not in model_name("a", "../x.y")


def _inside(solid: Any, point: np.ndarray) -> bool:
    """Whether the triangles go round a point: their solid angles make a full one."""
    a, b, c = np.moveaxis(np.asarray(solid.triangles) - point, 1, 0)
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    under = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
    return bool(np.arctan2((a * np.cross(b, c)).sum(1), under).sum() > np.pi)


def test_walls_with_their_holes(written) -> None:
    scene, state, _ = written
    arch = state["arch"]
    assert arch["version"] == "arch@1.0.2" and arch["scaleToMeters"] == 1
    kinds = [e["type"] for e in arch["elements"]]
    assert kinds == ["Floor", "Ceiling"] + ["Wall"] * 6
    assert all(arch["elements"][k]["type"] == "Wall" for k in arch["regions"][0]["walls"])
    assert len({e["id"] for e in arch["elements"]}) == 8
    floor, ceiling = (np.asarray(e["points"]) for e in arch["elements"][:2])
    np.testing.assert_allclose(floor[:, :2], ROOM.outline)
    assert (floor[:, 2] == 0).all() and (ceiling[:, 2] == ROOM.height).all()
    loaded: Any = trimesh.load(io.BytesIO(glb_bytes(scene, ASSETS.__getitem__)), file_type="glb")
    holes = {}
    for k, wall in enumerate(arch["elements"][2:]):
        a, b = np.asarray(wall["points"])
        along = (b - a) / np.linalg.norm(b - a)
        outward = np.cross(along, (0, 0, 1)) * 0.05  # the room is on the left
        matrix, name = loaded.graph[f"room:wall:{k}"]
        solid = loaded.geometry[name].copy().apply_transform(Z_UP @ matrix)
        for hole in wall["holes"]:
            low, high = np.asarray(hole["box"]["min"]), np.asarray(hole["box"]["max"])
            holes[hole["id"]] = (k, hole["type"])
            middle, inset, beyond = (low + high) / 2, 0.02, 0.02
            probes = [middle, low + inset, high - inset, (low[0] - beyond, middle[1]), (high[0] + beyond, middle[1])]
            probes.append((middle[0], high[1] + beyond))
            found = [_inside(solid, a + along * s + outward + (0, 0, t)) for s, t in probes]
            assert found == [False, False, False, True, True, True], hole["id"]
    assert holes == {"door-0": (0, "Door"), "door-1": (5, "Door"), "window-0": (1, "Window"), "window-1": (4, "Window")}


def test_a_thousand_objects_share_one_model(tmp_path) -> None:
    objects = [MUG.object(f"m{k}", mount="floor", pose=Pose.from_yaw(k % 40, k // 40, 0, k)) for k in range(1000)]
    room = Room(outline=((-1, -1), (41, -1), (41, 26), (-1, 26)))
    scene = Scene(id="many", room=room, objects=tuple(objects))
    path = write_scenestate(scene, tmp_path / "s.json", ASSETS.__getitem__, models=True)
    assert len(json.loads(path.read_text())["scene"]["object"]) == 1000
    assert len(os.listdir(tmp_path / "models")) == 1


def test_scenes_of_one_folder_share_their_models(tmp_path) -> None:
    whole = _scene()
    few = whole.model_copy(update={"objects": whole.objects[3:]})
    write_scenestate(few, tmp_path / "scene_0.json", ASSETS.__getitem__, models=True)
    before = {p.name for p in (tmp_path / "models").iterdir()}
    for _ in range(2):
        write_scenestate(whole, tmp_path / "scene_1.json", ASSETS.__getitem__, models=True)
    after = {p.name for p in (tmp_path / "models").iterdir()}
    assert before < after and sorted(os.listdir(tmp_path)) == ["models", "scene_0.json", "scene_1.json"]
    write_scenestate(whole, tmp_path / "scene_2.json", ASSETS.__getitem__)
    assert {p.name for p in (tmp_path / "models").iterdir()} == after


def test_missing_meshes(tmp_path) -> None:
    scene = _scene()

    def load(object_id: str):
        if object_id == CHAIR.id:
            raise InputError(f"asset: no source has '{object_id}'")
        return ASSETS[object_id]

    with pytest.raises(InputError, match=r"^objects\[4\]\.asset: no source has"):
        write_scenestate(scene, tmp_path / "s.json", load, models=True)
    assert os.listdir(tmp_path) == []
    state = scenestate(scene, load, missing="parts")["scene"]
    assert "collision parts" in state["object"][4]["note"] and "note" not in state["object"][3]

    bare = {name: getattr(CHAIR.mesh, name)[:0] for name in ("faces", "face_material", "face_link")}
    empty = replace(CHAIR, mesh=replace(CHAIR.mesh, **bare))
    with pytest.raises(InputError, match=r"^objects\[4\]\.asset: '.*' has no mesh; "):
        scenestate(scene, {**ASSETS, CHAIR.id: empty}.__getitem__)
    with pytest.raises(InputError, match=r"^objects\[4\]\.asset: '.*' has no mesh; "):
        glb_bytes(scene, {**ASSETS, CHAIR.id: empty}.__getitem__)


@pytest.mark.parametrize("where", ["missing/s.json", "file/s.json", "folder", "s\0.json"])
def test_places_that_cannot_be_written(tmp_path, where) -> None:
    (tmp_path / "file").write_text("x")
    (tmp_path / "folder").mkdir()
    with pytest.raises(InputError) as caught:
        write_scenestate(_scene(), tmp_path / where, ASSETS.__getitem__, models=True)
    assert str(caught.value).startswith("path: ") and "\n" not in str(caught.value)
    assert sorted(os.listdir(tmp_path)) == ["file", "folder"] and not os.listdir(tmp_path / "folder")


def test_a_failure_half_way_leaves_the_old_file(tmp_path, monkeypatch) -> None:
    path = tmp_path / "s.json"
    path.write_text("old")
    real = os.replace

    def full(source, target, **folders):
        if os.path.basename(target) == path.name:
            raise OSError(28, "No space left on device")
        real(source, target, **folders)

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(InputError, match="No space left"):
        write_scenestate(_scene(), path, ASSETS.__getitem__, models=True)
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["s.json"]
