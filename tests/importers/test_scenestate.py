"""SceneState: column-major matrices over models that are y up, boxes, rooms from walls and holes, HSM's header."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.export.scenestate import write_scenestate
from sceneweaver.importers.categories import category_of
from tests.importers.meshes import box_obj
from tests.importers.reading import (
    changed,
    compass,
    require_error,
    rooms_of,
    things_of,
    without,
    written,
)

# An L of 5.3 x 3.9 m, counter-clockwise.
L = [(0.4, -1.0), (5.7, -1.0), (5.7, 1.2), (3.1, 1.2), (3.1, 2.9), (0.4, 2.9)]
POSES = {"bed": (1.5, 0.2, 0.0, 0.3), "desk": (4.9, 0.1, 0.0, -1.2), "lamp": (4.7, 0.3, 0.74, 2.4)}


def upright(x: float, y: float, z: float, yaw: float, scale=(1.0, 1.0, 1.0)) -> list[float]:
    """16 numbers, column by column, of a model that is y up with front +z: its z goes along the yaw, its y up."""
    c, s = math.cos(yaw), math.sin(yaw)
    columns = [(-s, c, 0.0), (0.0, 0.0, 1.0), (c, s, 0.0)]  # model x is to the left of what faces along the yaw
    flat = [v * k for column, k in zip(columns, scale, strict=True) for v in (*column, 0.0)]
    return [*flat, x, y, z, 1.0]


def document() -> dict:
    walls = []
    for k, (a, b) in enumerate(zip(L, L[1:] + L[:1], strict=True)):
        holes = []
        if k == 0:
            holes = [{"id": "d", "type": "Door", "box": {"min": [0.7, 0.0], "max": [1.6, 2.05]}}]
        if k == 1:
            holes = [{"id": "w", "type": "Window", "box": {"min": [0.5, 0.9], "max": [1.7, 2.2]}}]
        walls.append(
            {"id": f"w{k}", "type": "Wall", "roomId": "r", "height": 2.6, "points": [[*a, 0], [*b, 0]], "holes": holes}
        )
    floor = {"id": "f", "type": "Floor", "roomId": "r", "depth": 0.05, "points": [[x, y, 0] for x, y in L]}
    things = [
        {
            "id": name,
            "index": k,
            "modelId": f"test.{name}",
            "parentId": "desk" if name == "lamp" else "",
            "parentIndex": k,
            "transform": {"rows": 4, "cols": 4, "data": upright(*pose)},
        }
        for k, (name, pose) in enumerate(POSES.items())
    ]
    things[1]["transform"]["data"] = upright(*POSES["desk"], scale=(1.5, 0.5, 2.0))
    arch = {"elements": [floor, *walls], "scaleToMeters": 1, "regions": [{"id": "r", "type": "Bedroom"}]}
    head = {"version": "scene@1.0.2", "up": [0, 0, 1], "front": [0, 1, 0], "unit": 1.0, "assetSource": ["test"]}
    return {"format": "sceneState", "scene": {**head, "arch": arch, "object": things}, "selected": []}


def test_an_l_shaped_room(tmp_path):
    (room,) = rooms_of("scenestate", written(tmp_path, "s.json", document())).values()
    assert room.type == "Bedroom" and room.height == 2.6
    assert room.outline == tuple(L)
    things = things_of(room)
    for name, (x, y, z, yaw) in POSES.items():
        assert things[name].anchor == "origin"
        np.testing.assert_allclose(things[name].position, (x, y, z), atol=1e-9)
        np.testing.assert_allclose(things[name].rotation @ (1, 0, 0), compass(yaw), atol=1e-9)
        np.testing.assert_allclose(things[name].rotation @ (0, 0, 1), (0, 0, 1), atol=1e-9)
    assert things["lamp"].support == "desk" and things["bed"].support is None
    door, window = room.openings
    assert (door.kind, window.kind) == ("door", "window")
    np.testing.assert_allclose((*door.start, *door.end), (1.1, -1.0, 2.0, -1.0), atol=1e-9)
    np.testing.assert_allclose((*window.start, *window.end), (5.7, -0.5, 5.7, 0.7), atol=1e-9)
    assert (window.bottom, window.height) == (0.9, pytest.approx(1.3))


def test_meshes_give_sizes_and_centres(tmp_path):
    """x of the model is the width, y the height, z the depth; the scale is per axis of the model."""
    folder = tmp_path / "assets"
    box_obj(folder, "desk", (-0.5, 0.0, -0.2), (0.7, 1.4, 0.1))
    written(folder, "desk/data.json", {"annotations": {"category": "desk"}})
    path = written(tmp_path, "s.json", document())
    assert things_of(rooms_of("scenestate", path, folder)[""])["desk"].label == "desk"
    (scene,) = sw.read_scenes(path, assets="boxes", folder=folder)
    desk = scene.scene.object("desk")
    np.testing.assert_allclose(desk.size, (0.3 * 2.0, 1.2 * 1.5, 1.4 * 0.5), atol=1e-6)
    x, y, z, yaw = POSES["desk"]
    # the middle of the mesh lies 0.1 * 1.5 to the left and 0.05 * 2 behind the origin of the model
    forward, left = np.array(compass(yaw)), np.array(compass(yaw + math.pi / 2))
    np.testing.assert_allclose(desk.pose.position, (x, y, z) + 0.15 * left - 0.1 * forward, atol=1e-6)
    assert scene.sizes_from["desk"] == "mesh" and sw.check(scene.scene) is not None


def test_y_up_and_the_trap_of_hsm(tmp_path):
    """The same room with y up: (x, y, z) is (x, z, -y); and with a header that says so over data that is z up."""
    data = document()
    data["scene"]["up"] = {"x": 0, "y": 1, "z": 0}
    trap = written(tmp_path, "hsm.json", data)
    data = document()
    data["scene"]["up"] = [0, 1, 0]
    for element in data["scene"]["arch"]["elements"]:
        element["points"] = [[x, z, -y] for x, y, z in element["points"]]
    for thing in data["scene"]["object"]:
        flat = np.reshape(thing["transform"]["data"], (4, 4))
        flat[:, :3] = np.stack((flat[:, 0], flat[:, 2], -flat[:, 1]), axis=1)
        thing["transform"]["data"] = flat.reshape(-1).tolist()
    yup = written(tmp_path, "yup.json", data)
    for path, said in ((trap, True), (yup, False)):
        (room,) = rooms_of("scenestate", path).values()
        np.testing.assert_allclose(room.outline, L, atol=1e-9)
        for name, (x, y, z, yaw) in POSES.items():
            thing = things_of(room)[name]
            np.testing.assert_allclose(thing.position, (x, y, z), atol=1e-9)
            np.testing.assert_allclose(thing.rotation @ (1, 0, 0), compass(yaw), atol=1e-9)
        assert any("header" in note for note in room.notes) == said


def test_models_that_are_z_up_as_scenesmith_has_them(tmp_path):
    """Plain rotations about z: the front is +y of the model, so a yaw of 0.3 faces 0.3 + 90 degrees."""
    data = document()
    for thing, (x, y, z, yaw) in zip(data["scene"]["object"], POSES.values(), strict=True):
        c, s = math.cos(yaw), math.sin(yaw)
        thing["transform"] = {"data": [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, x, y, z, 1]}
    (room,) = rooms_of("scenestate", written(tmp_path, "sceneeval_state.json", data)).values()
    for name, (x, y, z, yaw) in POSES.items():
        thing = things_of(room)[name]
        np.testing.assert_allclose(thing.position, (x, y, z), atol=1e-9)
        np.testing.assert_allclose(thing.rotation @ (1, 0, 0), compass(yaw + math.pi / 2), atol=1e-9)
        np.testing.assert_allclose(thing.rotation @ (0, 0, 1), (0, 0, 1), atol=1e-9)


def test_parts_instead_of_a_matrix_units_and_the_slab(tmp_path):
    """Centimetres; a quaternion about z after the turn of +90 degrees about x; things on a slab of 5 cm."""
    data = document()
    data["scene"]["unit"] = 0.01
    for thing, (x, y, z, yaw) in zip(data["scene"]["object"], POSES.values(), strict=True):
        half = (yaw + math.pi / 2) / 2  # model z, turned by +90 degrees about x, points to -y
        r = math.sqrt(0.5)
        turn = [r * math.cos(half), r * math.sin(half), r * math.sin(half), r * math.cos(half)]
        thing["transform"] = {"translation": [100 * x, 100 * y, 100 * z + 5], "rotation": turn}
    (room,) = rooms_of("scenestate", written(tmp_path, "s.json", data)).values()
    for name, (x, y, z, yaw) in POSES.items():
        thing = things_of(room)[name]
        np.testing.assert_allclose(thing.position, (x, y, z), atol=1e-9)
        np.testing.assert_allclose(thing.rotation @ (1, 0, 0), compass(yaw), atol=1e-9)
    assert any("slab" in note for note in room.notes)


def test_two_rooms(tmp_path):
    data = document()
    more = json.loads(json.dumps(data["scene"]["arch"]["elements"]))
    for element in more:
        element["roomId"], element["points"] = "s", [[x + 20, y, z] for x, y, z in element["points"]]
    data["scene"]["arch"]["elements"] += more
    data["scene"]["object"][0]["transform"]["data"][12] += 20
    data["scene"]["object"][1]["transform"]["data"][12] += 200
    rooms = rooms_of("scenestate", written(tmp_path, "s.json", data))
    assert {name: [t.name for t in room.objects] for name, room in rooms.items()} == {"r": ["lamp"], "s": ["bed"]}
    assert any("desk" in note and "left out" in note for note in rooms["r"].notes)


def test_what_we_write_comes_back(tmp_path):
    scene = sw.Scene.example("bedroom")
    path = tmp_path / "scenestate.json"
    write_scenestate(scene, path, missing="parts")
    (back,) = sw.read_scenes(path, assets="boxes", relations=False)
    assert np.allclose(back.scene.room.outline, scene.room.outline, atol=1e-9)
    assert len(back.scene.objects) == len(scene.objects) and back.boundary == "file"
    for thing in scene.objects:
        other = back.scene.object(thing.id)
        np.testing.assert_allclose(other.pose.position, thing.pose.position, atol=1e-5)
        np.testing.assert_allclose(
            abs(np.dot(other.pose.quaternion, thing.pose.quaternion)), 1.0, atol=1e-9, err_msg=thing.id
        )
        np.testing.assert_allclose(other.size, thing.size, atol=1e-5)
        assert other.category == category_of(thing.category).category
    assert [(d.wall, round(d.offset, 6), d.width) for d in back.scene.room.doors] == [
        (d.wall, round(d.offset, 6), d.width) for d in scene.room.doors
    ]


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (json.dumps(document())[:-400], ("cut off",)),
        (changed(document(), "no", "scene", "object", 0, "transform", "data"), ("object[0].transform.data", "list")),
        (without(document(), "scene", "object", 1, "transform"), ("object[1]", "'transform' is missing")),
        (changed(document(), math.nan, "scene", "object", 1, "transform", "data", 12), ("NaN",)),
        (changed(document(), [0.0] * 16, "scene", "object", 2, "transform", "data"), ("flattens",)),
        (changed(document(), [0, 0.6, 0.8], "scene", "up"), ("axes",)),
        (
            changed(document(), {"min": [2, 0], "max": [1, 2]}, "scene", "arch", "elements", 1, "holes", 0, "box"),
            ("box",),
        ),
        ("", ("empty",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "broken.json", broken), "scenestate", *words)


def test_real_files_are_as_the_matrices_say():
    samples = Path(__file__).parent / "data" / "sceneeval_layoutvlm.json"
    (room,) = rooms_of("scenestate", samples).values()
    assert len(room.objects) == 10 and room.height == 3.0
    # the last one stands in the corner (6, 6) of the room and looks along +x, turned by 2 * 3.1416 mrad
    last = room.objects[-1]
    np.testing.assert_allclose(last.position, (5.30491304, 5.45860672, 0.0), atol=1e-6)
    np.testing.assert_allclose(last.rotation @ (1, 0, 0), compass(0.0062832), atol=1e-5)
    np.testing.assert_allclose(last.rotation @ (0, 0, 1), (0, 0, 1), atol=1e-6)


def test_a_mesh_that_is_not_taken_is_said(tmp_path):
    """A desk of 12 m: the file is read, the mesh left, and a note says why."""
    folder = tmp_path / "assets"
    box_obj(folder, "desk", (-6.0, 0.0, -0.3), (6.0, 9.0, 0.3))
    written(folder, "desk/data.json", {"annotations": {"category": "desk"}})
    data = document()
    data["scene"]["object"] = data["scene"]["object"][1:2]
    path = written(tmp_path, "s.json", data)
    (found,) = sw.read_scenes(path, assets="theirs", folder=folder, relations=False)
    assert len(found.scene.objects) == 1 and found.scene.objects[0].asset is None
    assert any("desk" in note and "not taken" in note for note in found.notes)
