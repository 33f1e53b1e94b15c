"""I-Design: clockwise angles from north, length across the front."""

from __future__ import annotations

import math

import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written

X, Y, H = 4.6, 3.1, 2.45
EMPTY = {"room_layout_elements": [], "objects_in_room": []}


def item(name: str, place, size, angle, **more):
    return {
        "new_object_id": name,
        "position": dict(zip("xyz", place, strict=True)),
        "size_in_meters": dict(zip(("length", "width", "height"), size, strict=True)),
        "rotation": {"z_angle": angle},
        "placement": EMPTY,
        **more,
    }


SCENE = [
    item("bed_1", (1.1, 0.95, 0.3), (1.6, 1.9, 0.6), 0.0, is_on_the_floor=True, style="Modern", material="Wood"),
    item("desk_1", (4.2, 2.0, 0.37), (1.3, 0.6, 0.74), 270.0, is_on_the_floor=True, facing="west_wall"),
    item(
        "lamp_1",
        (4.25, 1.6, 0.94),
        (0.2, 0.25, 0.4),
        90.0,
        is_on_the_floor=False,
        placement={
            "room_layout_elements": [],
            "objects_in_room": [{"object_id": "desk_1", "preposition": "on", "is_adjacent": True}],
        },
    ),
    item(
        "painting_1",
        (2.0, 3.08, 1.5),
        (0.9, 0.04, 0.6),
        180.0,
        is_on_the_floor=False,
        placement={
            "room_layout_elements": [{"layout_element_id": "north_wall", "preposition": "on"}],
            "objects_in_room": [],
        },
    ),
    {"new_object_id": "chair_1", "size_in_meters": {"length": 0.5, "width": 0.5, "height": 0.9}, "placement": EMPTY},
    item("south_wall", (X / 2, 0.0, H / 2), (X, 0.0, H), 0.0, itemType="wall"),
    item("middle of the room", (X / 2, Y / 2, 0.0), (X, Y, 0.0), 0.0, itemType="floor"),
    item("ceiling", (X / 2, Y / 2, H), (X, Y, 0.0), 0.0, itemType="ceiling"),
]


def test_poses(tmp_path):
    (room,) = rooms_of("idesign", written(tmp_path, "scene_graph.json", SCENE)).values()
    assert room.outline == ((0.0, 0.0), (X, 0.0), (X, Y), (0.0, Y))
    assert room.height == H
    things = things_of(room)
    assert set(things) == {"bed_1", "desk_1", "lamp_1", "painting_1"}
    require_pose(things["bed_1"], (1.1, 0.95, 0.3), (0, 1, 0))  # 0: north
    require_pose(things["desk_1"], (4.2, 2.0, 0.37), (-1, 0, 0))  # 270: west
    require_pose(things["lamp_1"], (4.25, 1.6, 0.94), (1, 0, 0))  # 90: east
    require_pose(things["painting_1"], (2.0, 3.08, 1.5), (0, -1, 0))  # 180: south
    assert things["bed_1"].size == (1.9, 1.6, 0.6)  # depth is their width
    assert things["desk_1"].size == (0.6, 1.3, 0.74)
    assert (things["lamp_1"].support, things["lamp_1"].mount) == ("desk_1", "surface")
    assert (things["painting_1"].mount, things["bed_1"].mount) == ("wall", "floor")
    assert any("chair_1" in note and "left out" in note for note in room.notes)


@pytest.mark.parametrize("angle", [17.0, -69.0, 137.5])
def test_any_angle(tmp_path, angle):
    """Clockwise from north: the front is (sin, cos)."""
    path = written(tmp_path, "scene_graph.json", [item("sofa_1", (1.0, 2.0, 0.4), (2.0, 0.9, 0.8), angle), SCENE[-1]])
    (room,) = rooms_of("idesign", path).values()
    turn = math.radians(angle)
    require_pose(room.objects[0], (1.0, 2.0, 0.4), (math.sin(turn), math.cos(turn), 0.0))
    require_pose(room.objects[0], (1.0, 2.0, 0.4), compass(math.pi / 2 - turn))


def test_footprints_lie_in_the_room_and_are_judged(tmp_path):
    """At 270 degrees a desk of 1.3 x 0.6 m fills 0.6 m of x: with the two exchanged it would be in the wall."""
    (made,) = sw.read_scenes(written(tmp_path, "scene_graph.json", SCENE), assets="boxes")
    report = sw.check(made.scene)
    assert not report.out_of_bounds, report
    moved = changed(SCENE, 4.5, 1, "position", "x")
    (worse,) = sw.read_scenes(written(tmp_path, "moved.json", moved), assets="boxes")
    assert sw.check(worse.scene).out_of_bounds


def test_a_room_without_its_priors(tmp_path):
    (room,) = rooms_of("idesign", written(tmp_path, "graph.json", {"objects_in_room": SCENE[:2]})).values()
    assert room.outline is None
    assert len(room.objects) == 2


def test_broken_files(tmp_path):
    text = written(tmp_path, "whole.json", SCENE).read_text()
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(SCENE, "wide", 0, "size_in_meters", "length"), ("[0].size_in_meters.length", "number")),
        ("missing.json", without(SCENE, 1, "position", "z"), ("[1].position", "'z' is missing")),
        ("nan.json", changed(SCENE, float("nan"), 1, "rotation", "z_angle"), ("z_angle", "NaN")),
        ("empty.json", "", ("empty",)),
        ("object.json", {"new_object_id": 3}, ("objects_in_room",)),
    ):
        require_error(written(tmp_path, name, data), "idesign", *words)
