"""SceneSmith: rooms around the origin, w first in quaternions, fronts along +y, boxes off the origin of the model."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written

LENGTH, WIDTH = 5.2, 3.6  # x, y
POSES = {"bed_0": (1.1, -0.4, 0.0, 0.3), "desk_0": (-1.6, 0.7, 0.0, -1.2), "mug_0": (-1.5, 0.9, 0.74, 2.4)}
BOXES = {
    "bed_0": ((-0.8, -1.0, 0.0), (0.8, 1.1, 0.5)),
    "desk_0": ((-0.5, -0.4, 0.0), (0.9, 0.2, 0.74)),
    "mug_0": ((-0.04, -0.05, -0.01), (0.05, 0.05, 0.09)),
}


def thing(name, x, y, z, yaw):
    low, high = BOXES[name]
    return {
        "object_id": name,
        "object_type": "manipuland" if name == "mug_0" else "furniture",
        "name": name[:-2],
        "description": f"a {name[:-2]}",
        "transform": {"translation": [x, y, z], "rotation_wxyz": [math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2)]},
        "sdf_path": f"assets/{name}/{name}.sdf",
        "geometry_path": f"assets/{name}/{name}.glb",
        "support_surfaces": [{"surface_id": f"S_{name}"}],
        "placement_info": {"parent_surface_id": "S_desk_0" if name == "mug_0" else "floor", "rotation_2d": yaw},
        "bbox_min": list(low),
        "bbox_max": list(high),
        "immutable": False,
        "scale_factor": 1.3,
        "metadata": {},
    }


def state():
    opening = {
        "opening_id": "door_1",
        "opening_type": "door",
        "wall_direction": "north",
        "center_world": [1.25, 1.8, 1.05],
        "width": 0.9,
        "sill_height": 0.0,
        "height": 2.1,
        "wall_start": [2.6, 1.8],
        "wall_end": [-2.6, 1.8],
        "position_along_wall": 0.9,
    }
    window = {**opening, "opening_id": "win", "opening_type": "window", "sill_height": 0.8, "height": 1.2}
    window |= {"wall_start": [-2.6, -1.8], "wall_end": [2.6, -1.8], "position_along_wall": 1.5, "width": 1.3}
    geometry = {"sdf_path": "room.sdf", "walls": [], "length": LENGTH, "width": WIDTH, "wall_height": 2.5}
    wall = {"object_id": "north_wall", "object_type": "wall", "transform": {}}
    return {
        "room_geometry": {**geometry, "openings": [opening, window]},
        "objects": {**{name: thing(name, *pose) for name, pose in POSES.items()}, "north_wall": wall},
        "text_description": "a small bedroom",
    }


def require_poses(room, dx=0.0, dy=0.0):
    things = things_of(room)
    assert set(things) == set(POSES)
    for name, (x, y, z, yaw) in POSES.items():
        low, high = BOXES[name]
        mx, my, mz = ((a + b) / 2 for a, b in zip(low, high, strict=True))
        c, s = math.cos(yaw), math.sin(yaw)
        centre = (x + c * mx - s * my + dx, y + s * mx + c * my + dy, z + mz)
        require_pose(things[name], centre, compass(yaw + math.pi / 2))
        w, d, h = (b - a for a, b in zip(low, high, strict=True))
        np.testing.assert_allclose(things[name].size, (d, w, h), atol=1e-9)
    assert things["mug_0"].support == "desk_0" and things["bed_0"].support is None


def test_a_room(tmp_path):
    (room,) = rooms_of("scenesmith", written(tmp_path, "scene_state.json", state())).values()
    require_poses(room)
    assert room.text == "a small bedroom" and room.height == 2.5
    np.testing.assert_allclose(room.outline, [(-2.6, -1.8), (2.6, -1.8), (2.6, 1.8), (-2.6, 1.8)], atol=1e-9)
    door, window = room.openings
    np.testing.assert_allclose((*door.start, *door.end), (1.7, 1.8, 0.8, 1.8), atol=1e-9)
    np.testing.assert_allclose((*window.start, *window.end), (-1.1, -1.8, 0.2, -1.8), atol=1e-9)
    assert (door.kind, window.kind, window.bottom) == ("door", "window", 0.8)


def house():
    placed = [{"room_id": "bed", "position": [7.0, -3.0], "width": LENGTH, "depth": WIDTH, "walls": []}]
    return {"layout": {"placed_rooms": placed, "rooms": []}, "rooms": {"bed": state(), "other": state()}}


def test_a_house(tmp_path):
    rooms = rooms_of("scenesmith", written(tmp_path, "house_state.json", house()))
    require_poses(rooms["bed"], 7.0 + LENGTH / 2, -3.0 + WIDTH / 2)
    np.testing.assert_allclose(rooms["bed"].outline[0], (7.0, -3.0), atol=1e-9)
    np.testing.assert_allclose(rooms["bed"].openings[0].start, (7.0 + LENGTH / 2 + 1.7, -3.0 + WIDTH), atol=1e-9)
    require_poses(rooms["other"])
    assert any("layout" in note for note in rooms["other"].notes)


def test_end_to_end(tmp_path):
    (found,) = sw.read_scenes(written(tmp_path, "scene_state.json", state()), assets="boxes")
    assert [o.category for o in found.scene.objects][:2] == ["bed", "desk"]
    assert set(found.sizes_from.values()) == {"file"} and sw.check(found.scene) is not None


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (json.dumps(state())[:-300], ("cut off",)),
        ("", ("empty",)),
        (changed(state(), [1, 2], "objects"), ("objects", "object")),
        (without(state(), "objects", "desk_0", "transform"), ("objects.desk_0", "'transform' is missing")),
        (changed(state(), math.nan, "objects", "bed_0", "transform", "translation", 0), ("NaN",)),
        (changed(state(), [0, 0, 0, 0], "objects", "bed_0", "transform", "rotation_wxyz"), ("length 0",)),
        (changed(state(), "wide", "room_geometry", "width"), ("room_geometry.width",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "scene_state.json", broken), "scenesmith", *words)
