"""SceneWeaver: bottoms, radians, a front of +x, and a floor that may lie at the walls' half thickness."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written

ROOM = "newroom_0-0"
BED, DESK, LAMP = "BedFactory(1382).bbox_placeholder(51)", "DeskFactory(77).spawn_asset(3)", "4471_lamp"


def layout(floor=0.0):
    return {
        "objects": {
            BED: {
                "location": [1.52, 1.3, floor],
                "rotation": [0.0, 0.0, 0.3],
                "size": [2.05, 1.45, 0.55],
                "parent": [[ROOM, "onfloor"]],
            },
            DESK: {
                "location": [4.31, 1.9, floor],
                "rotation": [0.0, 0.0, -1.2],
                "size": [0.65, 1.25, 0.74],
                "parent": [[ROOM, "onfloor"], [ROOM, "side_against_wall"]],
            },
            LAMP: {
                "location": [4.25, 1.85, floor + 0.74],
                "rotation": [0.0, 0.0, 2.4],
                "size": [0.18, 0.22, 0.41],
                "parent": [[DESK, "ontop"]],
            },
            "chair_0": {
                "location": [3.2, 3.0, floor],
                "rotation": [0.0, 0.0, -1.57],
                "size": [0.5, 0.55, 0.9],
                "parent": [[ROOM, "onfloor"], [DESK, "front_against"]],
            },
            "clock": {
                "location": [2.2, 3.975 - (0.14 if floor else 0.0), floor + 1.6],
                "rotation": [0.0, 0.0, -1.57],
                "size": [0.05, 0.3, 0.3],
                "parent": [[ROOM, "against_wall"]],
            },
        },
        "structure": {
            "entrance": {"location": [0.6, 0.0, floor], "rotation": [0.0, 0.0, 0.0], "size": [0.92, 0.12, 2.08]},
            "window": {"location": [5.1, 2.2, floor + 1.5], "rotation": [0.0, 0.0, 1.5708], "size": [1.3, 0.1, 1.2]},
        },
        "roomsize": [5.1, 4.0],
    }


def require_things(room):
    things = things_of(room)
    require_pose(things[BED], (1.52, 1.3, 0.275), compass(0.3))
    require_pose(things[DESK], (4.31, 1.9, 0.37), compass(-1.2))
    require_pose(things[LAMP], (4.25, 1.85, 0.945), compass(2.4))
    require_pose(things["chair_0"], (3.2, 3.0, 0.45), compass(-1.57))
    assert things[BED].size == (2.05, 1.45, 0.55)
    assert [things[n].label for n in (BED, DESK, LAMP, "chair_0")] == ["Bed", "Desk", "lamp", "chair"]
    assert (things[LAMP].support, things[LAMP].mount) == (DESK, "surface")
    assert [things[n].mount for n in (BED, DESK, "chair_0", "clock")] == ["floor", "floor", "floor", "wall"]
    assert things["chair_0"].keep["parent"] == [[ROOM, "onfloor"], [DESK, "front_against"]]


def test_poses(tmp_path):
    (room,) = rooms_of("sceneweaver", written(tmp_path, "layout_3.json", layout())).values()
    require_things(room)
    assert room.outline == ((0.0, 0.0), (5.1, 0.0), (5.1, 4.0), (0.0, 4.0))
    assert room.height is None
    door, window = room.openings
    np.testing.assert_allclose((door.start, door.end), ((0.14, 0.0), (1.06, 0.0)), atol=1e-9)
    assert (door.kind, door.bottom, door.height) == ("door", 0.0, 2.08)
    np.testing.assert_allclose((window.start, window.end), ((5.1, 1.55), (5.1, 2.85)), atol=1e-5)
    assert (window.kind, window.height) == ("window", 1.2)
    assert window.bottom == pytest.approx(0.9)


def test_a_floor_at_half_the_thickness_of_the_walls(tmp_path):
    """As the executor writes it: the floor at 0.14 m, and walls of that within the room's size."""
    (room,) = rooms_of("sceneweaver", written(tmp_path, "layout_3.json", layout(0.14))).values()
    require_things(room)
    np.testing.assert_allclose(room.outline, ((0.14, 0.14), (4.96, 0.14), (4.96, 3.86), (0.14, 3.86)))
    assert any("0.14" in note for note in room.notes)


def test_a_placement_of_a_tool(tmp_path):
    """By category and number, degrees about z, a height only where it is not the floor's."""
    data = {
        "Room type": "bedroom",
        "Roomsize": [3.2, 4.4, 2.7],
        "Placement": {
            "bed": {"1": {"position": [1.05, 1.5], "rotation": 0, "size": [2.1, 1.8, 0.6]}},
            "nightstand": {
                "1": {"position": [0.3, 0.3], "rotation": 270, "size": [0.5, 0.45, 0.6], "parent": ["bed", "1", "x"]}
            },
        },
        "Placement of small furniture": {
            "book": {
                "2": {
                    "position": [0.2, 0.25, 0.6],
                    "rotation": 40,
                    "size": [0.15, 0.2, 0.04],
                    "parent": ["nightstand", "1", "on"],
                }
            }
        },
    }
    (room,) = rooms_of("sceneweaver", written(tmp_path, "placement.json", data)).values()
    assert (room.type, room.height) == ("bedroom", 2.7)
    things = things_of(room)
    require_pose(things["1_bed"], (1.05, 1.5, 0.3), (1, 0, 0))
    require_pose(things["1_nightstand"], (0.3, 0.3, 0.3), (0, -1, 0))
    require_pose(things["2_book"], (0.2, 0.25, 0.62), compass(math.radians(40)))
    assert (things["2_book"].support, things["2_book"].label) == ("1_nightstand", "book")


def test_position_for_location_and_no_structure(tmp_path):
    data = without(layout(), "structure")
    for item in data["objects"].values():
        item["position"] = item.pop("location")
    (room,) = rooms_of("sceneweaver", written(tmp_path, "layout_0.json", data)).values()
    require_things(room)


def test_three_angles(tmp_path):
    """Blender's XYZ: about fixed x, then y, then z."""
    angles = 0.2, -0.4, 1.1
    c, s = np.cos(angles), np.sin(angles)
    front = np.array((c[2] * c[1], s[2] * c[1], -s[1]))  # the first column of Rz Ry Rx
    up = np.array((c[2] * s[1] * c[0] + s[2] * s[0], s[2] * s[1] * c[0] - c[2] * s[0], c[1] * c[0]))
    data = changed(layout(), list(angles), "objects", BED, "rotation")
    (room,) = rooms_of("sceneweaver", written(tmp_path, "layout_1.json", data)).values()
    require_pose(things_of(room)[BED], np.array((1.52, 1.3, 0.0)) + 0.275 * up, front, up)


def test_from_file_to_judge(tmp_path):
    (made,) = sw.read_scenes(written(tmp_path, "layout_3.json", layout()), assets="boxes")
    assert (len(made.scene.room.doors), len(made.scene.room.windows)) == (1, 1)
    report = sw.check(made.scene)
    assert (report.collisions, report.out_of_bounds, report.unsupported) == (0, 0, 0), report
    moved = changed(layout(), [1.6, 0.7, 0.0], "objects", BED, "location")
    (worse,) = sw.read_scenes(written(tmp_path, "layout_4.json", moved), assets="boxes")
    assert sw.check(worse.scene).out_of_bounds


def test_broken_files(tmp_path):
    whole = layout()
    text = written(tmp_path, "whole.json", whole).read_text()
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(whole, "big", "objects", DESK, "size"), ("size", "list")),
        ("missing.json", without(whole, "objects", DESK, "size"), (DESK, "'size' is missing")),
        ("nan.json", changed(whole, float("nan"), "objects", BED, "rotation", 2), ("rotation[2]", "NaN")),
        ("empty.json", "", ("empty",)),
        ("flat.json", changed(whole, 0.0, "objects", BED, "size", 1), ("size", "above 0")),
        ("none.json", {"roomsize": [4, 5]}, ("'objects' is missing",)),
    ):
        require_error(written(tmp_path, name, data), "sceneweaver", *words)


def test_a_folder_is_the_last_step_of_a_run(tmp_path):
    for step in (0, 2, 10):
        data = changed(layout(), [1.52, 1.3 + step / 100, 0.0], "objects", BED, "location")
        written(tmp_path, f"run/record_scene/layout_{step}.json", data)
    written(tmp_path, "run/record_scene/layout_9.txt", "no layout")
    (room,) = rooms_of("sceneweaver", tmp_path / "run" / "record_scene").values()
    require_pose(things_of(room)[BED], (1.52, 1.4, 0.275), compass(0.3))
    assert room.name == "layout_10"
    assert any("2 earlier steps" in note for note in room.notes)
    assert len(list(sw.read_scenes(tmp_path / "run", assets="boxes"))) == 1
