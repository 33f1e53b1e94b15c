"""SAGE: bottoms in the frame of the house, 0 degrees facing +y, openings as fractions along walls."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, require_error, require_pose, rooms_of, things_of, without, written


def xyz(*values):
    return dict(zip("xyz", values, strict=True))


def wall(name, a, b, height=2.8):
    return {"id": name, "start_point": xyz(*a, 0.0), "end_point": xyz(*b, 0.0), "height": height, "thickness": 0.1}


def thing(name, kind, place, turn, size, where, room="r1", **more):
    return {
        "id": name,
        "room_id": room,
        "type": kind,
        "description": f"a {kind}",
        "position": xyz(*place),
        "rotation": xyz(0.0, 0.0, turn),
        "dimensions": dict(zip(("width", "length", "height"), size, strict=True)),
        "source": "generation",
        "source_id": f"src_{name}",
        "place_id": where,
        **more,
    }


# room r1 from (1.5, -2.0) to (5.8, 1.4); room r2 beyond its east wall
PLAN = {
    "id": "plan",
    "total_area": 20.0,
    "building_style": "modern",
    "description": "two rooms",
    "created_from_text": "a study beside a hall",
    "rooms": [
        {
            "id": "r1",
            "room_type": "study",
            "position": xyz(1.5, -2.0, 0.0),
            "dimensions": {"width": 4.3, "length": 3.4, "height": 2.8},
            "ceiling_height": 2.8,
            "walls": [
                wall("w_s", (1.5, -2.0), (5.8, -2.0)),
                wall("w_n", (1.5, 1.4), (5.8, 1.4)),
                wall("w_e", (5.8, 1.4), (5.8, -2.0)),
                wall("w_w", (1.5, -2.0), (1.5, 1.4)),
            ],
            "doors": [
                {"id": "d1", "wall_id": "w_e", "position_on_wall": 0.25, "width": 0.9, "height": 2.1, "opening": False}
            ],
            "windows": [
                {
                    "id": "v1",
                    "wall_id": "w_n",
                    "position_on_wall": 0.7,
                    "width": 1.2,
                    "height": 1.1,
                    "sill_height": 0.95,
                }
            ],
            "objects": [
                thing("o1", "desk", (3.0, -1.5, 0.0), 0.0, (1.4, 0.7, 0.75), "r1"),
                thing("o2", "bookshelf", (5.5, 0.2, 0.0), 90.0, (0.9, 0.3, 1.9), "r1"),
                thing("o3", "lamp", (3.2, -1.4, 0.75), 37.0, (0.2, 0.15, 0.4), "o1"),
                thing("o4", "painting", (2.4, 1.36, 1.3), 180.0, (0.8, 0.05, 0.6), "w_n"),
            ],
        },
        {
            "id": "r2",
            "room_type": "hall",
            "position": xyz(5.8, -2.0, 0.0),
            "dimensions": {"width": 2.0, "length": 5.1, "height": 2.8},
            "walls": [],
            "doors": [],
            "windows": [],
            "objects": [thing("o5", "bench", (6.4, 2.0, 0.0), 270.0, (1.1, 0.4, 0.45), "r2", "r2")],
        },
    ],
}
PLAN["rooms"][1]["walls"] = [wall("w2", (5.8, -2.0), (5.8, 3.1))]
PLAN["rooms"][1]["doors"] = [
    {"id": "d1", "wall_id": "w2", "position_on_wall": 0.5, "width": 0.9, "height": 2.1, "opening": True}
]


def test_poses(tmp_path):
    rooms = rooms_of("sage", written(tmp_path, "plan.json", PLAN))
    study, hall = rooms["r1"], rooms["r2"]
    assert (study.type, study.height, study.text) == ("study", 2.8, "a study beside a hall")
    things = things_of(study)
    require_pose(things["o1"], (3.0, -1.5, 0.375), (0, 1, 0))
    require_pose(things["o2"], (5.5, 0.2, 0.95), (-1, 0, 0))
    turn = math.radians(37.0)
    require_pose(things["o3"], (3.2, -1.4, 0.95), (-math.sin(turn), math.cos(turn), 0))
    require_pose(things["o4"], (2.4, 1.36, 1.6), (0, -1, 0))
    require_pose(things_of(hall)["o5"], (6.4, 2.0, 0.225), (1, 0, 0))
    assert things["o1"].size == (0.7, 1.4, 0.75)
    assert [t.mount for t in study.objects] == ["floor", "floor", "surface", "wall"]
    assert things["o3"].support == "o1"


def test_the_outline_follows_the_walls_whatever_their_order(tmp_path):
    rooms = rooms_of("sage", written(tmp_path, "plan.json", PLAN))
    assert set(rooms["r1"].outline) == {(1.5, -2.0), (5.8, -2.0), (5.8, 1.4), (1.5, 1.4)}
    x, y = np.array(rooms["r1"].outline).T
    assert abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2 == pytest.approx(4.3 * 3.4)
    np.testing.assert_allclose(rooms["r2"].outline, ((5.8, -2.0), (7.8, -2.0), (7.8, 3.1), (5.8, 3.1)))  # no ring
    assert any("ring" in note for note in rooms["r2"].notes)


def test_an_L(tmp_path):
    ring = [(1.5, -2.0), (5.8, -2.0), (5.8, 0.2), (3.1, 0.2), (3.1, 1.4), (1.5, 1.4)]
    walls = [wall(f"w{i}", a, b) for i, (a, b) in enumerate(zip(ring, ring[1:] + ring[:1], strict=True))]
    walls = [walls[3], walls[0], *(dict(w, start_point=w["end_point"], end_point=w["start_point"]) for w in walls[1:3])]
    walls += [wall("w4", ring[4], ring[5]), wall("w5", ring[5], ring[0])]
    plan = without(changed(changed(PLAN, walls, "rooms", 0, "walls"), [], "rooms", 0, "doors"), "rooms", 0, "windows")
    outline = rooms_of("sage", written(tmp_path, "plan.json", plan))["r1"].outline
    x, y = np.array(outline).T
    area = abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
    assert area == pytest.approx(4.3 * 3.4 - 2.7 * 1.2)
    assert set(outline) == set(ring)


def test_openings(tmp_path):
    rooms = rooms_of("sage", written(tmp_path, "plan.json", PLAN))
    door, window = rooms["r1"].openings
    # a quarter down the east wall, from the north: 1.4 - 0.25 * 3.4 = 0.55, half a door either way
    np.testing.assert_allclose((door.start, door.end), ((5.8, 1.0), (5.8, 0.1)), atol=1e-9)
    assert (door.kind, door.leads_to, door.height) == ("door", "r2", 2.1)
    middle = 1.5 + 0.7 * 4.3
    np.testing.assert_allclose((window.start, window.end), ((middle - 0.6, 1.4), (middle + 0.6, 1.4)), atol=1e-9)
    assert (window.kind, window.bottom, window.height) == ("window", 0.95, 1.1)
    assert [(o.kind, o.leads_to) for o in rooms["r2"].openings] == [("passage", "r1")]


def test_a_tilted_thing(tmp_path):
    """It turns about the middle of its bottom: the middle of the box is half its height along its own up."""
    plan = changed(PLAN, xyz(90.0, 0.0, 0.0), "rooms", 0, "objects", 0, "rotation")
    thing = things_of(rooms_of("sage", written(tmp_path, "plan.json", plan))["r1"])["o1"]
    require_pose(thing, (3.0, -1.5 - 0.375, 0.0), (0, 0, 1), (0, -1, 0))


def test_an_upper_floor_is_brought_down(tmp_path):
    plan = changed(PLAN, 3.0, "rooms", 0, "position", "z")
    for thing in plan["rooms"][0]["objects"]:
        thing["position"]["z"] += 3.0
    thing = things_of(rooms_of("sage", written(tmp_path, "plan.json", plan))["r1"])["o2"]
    require_pose(thing, (5.5, 0.2, 0.95), (-1, 0, 0))


def test_from_file_to_judge(tmp_path):
    made = {m.room: m.scene for m in sw.read_scenes(written(tmp_path, "plan.json", PLAN), assets="boxes")}
    report = sw.check(made["r1"])
    assert (report.collisions, report.out_of_bounds, report.unsupported) == (0, 0, 0), report
    plan = changed(PLAN, xyz(0.0, 0.0, 0.0), "rooms", 0, "objects", 1, "rotation")  # 0.9 m of shelf into the wall
    worse = next(iter(sw.read_scenes(written(tmp_path, "worse.json", plan), assets="boxes")))
    assert sw.check(worse.scene).out_of_bounds


def test_meshes_beside_the_plan(tmp_path):
    """A wedge that is high at +y, its front: in the scene it is high where the shelf faces."""
    corners = [(x, y, 0.0) for x in (-0.45, 0.45) for y in (-0.15, 0.15)] + [(-0.45, 0.15, 1.9), (0.45, 0.15, 1.9)]
    faces = [(0, 1, 3), (0, 3, 2), (1, 4, 5), (1, 5, 3), (0, 2, 5), (0, 5, 4), (0, 4, 1), (2, 3, 5)]
    lines = ["ply", "format ascii 1.0", "element vertex 6", *(f"property float {a}" for a in "xyz")]
    lines += ["element face 8", "property list uchar int vertex_indices", "end_header"]
    lines += [*(" ".join(map(str, c)) for c in corners), *("3 " + " ".join(map(str, f)) for f in faces)]
    written(tmp_path, "generation/src_o2.ply", "\n".join(lines) + "\n")
    shelf = things_of(rooms_of("sage", written(tmp_path, "plan.json", PLAN))["r1"])["o2"]
    assert shelf.mesh is not None and shelf.mesh.name == "src_o2.ply"
    world = np.array(corners) @ (shelf.rotation @ shelf.mesh_axes).T + (5.5, 0.2, 0.0)
    # at 90 degrees it faces west: the high edge is at x = 5.5 - 0.15
    np.testing.assert_allclose(world[4:, 0], 5.35, atol=1e-9)
    np.testing.assert_allclose((world[:, 1].min(), world[:, 1].max()), (-0.25, 0.65), atol=1e-9)
    outside = changed(PLAN, "../../etc/passwd", "rooms", 0, "objects", 1, "source_id")
    assert things_of(rooms_of("sage", written(tmp_path, "outside.json", outside))["r1"])["o2"].mesh is None
    made = next(iter(sw.read_scenes(tmp_path / "plan.json", assets="theirs")))
    assert made.sizes_from["o2"] == "file"


def test_broken_files(tmp_path):
    text = written(tmp_path, "whole.json", PLAN).read_text()
    thing = ("rooms", 0, "objects", 1)
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(PLAN, "90", *thing, "rotation", "z"), ("rooms[0].objects[1].rotation.z", "number")),
        ("missing.json", without(PLAN, *thing, "dimensions", "height"), ("objects[1].dimensions", "'height'")),
        ("nan.json", changed(PLAN, float("nan"), *thing, "position", "x"), ("objects[1].position.x", "NaN")),
        ("empty.json", "", ("empty",)),
        ("fraction.json", changed(PLAN, 1.7, "rooms", 0, "doors", 0, "position_on_wall"), ("position_on_wall", "1.7")),
        ("none.json", changed(PLAN, [], "rooms"), ("rooms", "at least one")),
    ):
        require_error(written(tmp_path, name, data), "sage", *words)
