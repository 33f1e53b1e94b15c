"""HSM's own state: y up, bottoms, clockwise angles, doors by place or as cut-outs."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, require_error, require_pose, rooms_of, things_of, without, written

POSES = {"bed_1": (1.5, 0.0, 0.8, 20.0), "desk_1": (4.4, 0.0, 2.6, -110.0), "lamp_1": (4.5, 0.74, 2.7, 200.0)}
SIZES = {"bed_1": (1.6, 0.5, 2.0), "desk_1": (1.2, 0.74, 0.6), "lamp_1": (0.2, 0.4, 0.25)}


def state():
    things = {
        str(k): {
            "name": name,
            "position": list(POSES[name][:3]),
            "dimensions": list(SIZES[name]),
            "rotation": POSES[name][3],
            "mesh_path": f"data/hssd/{name}.glb",
            "obj_type": "small" if name == "lamp_1" else "large",
            "parent_name": "desk_1" if name == "lamp_1" else None,
            "id": k,
        }
        for k, name in enumerate(POSES)
    }
    things["1"]["optimized_world_pos"] = [4.6, 0.0, 2.5]
    return {
        "scene_state_version": 1,
        "room_desc": "a bedroom with a desk",
        "room_type": "bedroom",
        "room_vertices": [[0, 0], [5.5, 0], [5.5, 2.0], [5.0, 3.4], [0, 3.4]],
        "door_location": [2.0, 0.0],
        "window_location": [{"location": [0.0, 1.5], "width": 1.1, "height": 1.3, "bottom_height": 0.8}],
        "object_specs": {"0": {"id": 0, "name": "double bed", "description": "a wide bed"}},
        "scene_objects": things,
        "motifs": [],
    }


def test_a_room(tmp_path):
    (room,) = rooms_of("hsm", written(tmp_path, "hsm_scene_state.json", state())).values()
    assert (room.type, room.text) == ("bedroom", "a bedroom with a desk")
    assert room.outline == ((0, 0), (5.5, 0), (5.5, 2.0), (5.0, 3.4), (0, 3.4))
    things = things_of(room)
    for name, (x, up, z, angle) in POSES.items():
        w, h, d = SIZES[name]
        place = (4.6, 2.5, h / 2) if name == "desk_1" else (x, z, up + h / 2)
        require_pose(things[name], place, (math.sin(math.radians(angle)), math.cos(math.radians(angle)), 0))
        assert things[name].size == (d, w, h)
    assert things["lamp_1"].support == "desk_1" and things["bed_1"].label == "double bed"
    door, window = room.openings
    np.testing.assert_allclose(sorted((door.start[0], door.end[0])), (1.55, 2.45), atol=1e-9)
    np.testing.assert_allclose(sorted((window.start[1], window.end[1])), (0.95, 2.05), atol=1e-9)
    assert (window.bottom, window.height) == (0.8, 1.3)


def test_end_to_end(tmp_path):
    (found,) = sw.read_scenes(written(tmp_path, "hsm_scene_state.json", state()), assets="boxes")
    assert [o.category for o in found.scene.objects] == ["bed", "desk", "table_lamp"]
    assert sw.check(found.scene).unsupported == 0


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (json.dumps(state())[:-200], ("cut off",)),
        ("", ("empty",)),
        (changed(state(), "no", "scene_objects"), ("scene_objects",)),
        (without(state(), "scene_objects", "1", "dimensions"), ("'dimensions' is missing",)),
        (changed(state(), math.nan, "scene_objects", "0", "position", 1), ("NaN",)),
        (changed(state(), [[0, 0], [1, 1]], "room_vertices"), ("corners",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "hsm_scene_state.json", broken), "hsm", *words)
