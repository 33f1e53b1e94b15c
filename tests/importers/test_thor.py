"""AI2-THOR houses: a left-handed frame, clockwise angles, holes in walls, corners in centimetres with a buffer."""

from __future__ import annotations

import gzip
import json
import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import (
    changed,
    compass,
    require_error,
    require_pose,
    rooms_of,
    things_of,
    without,
    written,
)

# From allenai/ai2thor (Apache-2.0), ai2thor/tests/data/arm/procthor_train_1.json, and the boxes of its assets from
# allenai/procthor (Apache-2.0), procthor/databases/asset-database.json; shortened.
KITCHEN = {
    "doors": [
        {
            "assetId": "Doorframe_Double_5",
            "id": "door|2|3",
            "room0": "room|3",
            "room1": "room|2",
            "wall0": "wall|3|8.77|5.26|15.78|5.26",
            "wall1": "wall|2|8.77|5.26|15.78|5.26",
            "holePolygon": [
                {"x": 1.0606274069260788, "y": 0, "z": 0},
                {"x": 3.000963634343071, "y": 2.0956013202667236, "z": 0},
            ],
            "assetPosition": {"x": 2.0276009268101287, "y": 1.0478006601333618, "z": 0},
        }
    ],
    "metadata": {"schema": "1.0.0", "roomSpecId": "12-room-3-bed"},
    "objects": [
        {
            "assetId": "Countertop_L_4x4",
            "children": [
                {
                    "assetId": "Book_17",
                    "id": "Book|surface|2|0",
                    "kinematic": False,
                    "position": {"x": 9.096155166625977, "y": 0.9640293717384338, "z": 1.0974888801574707},
                    "rotation": {"x": -0.0, "y": 90.0, "z": -0.0},
                }
            ],
            "id": "CounterTop|2|0",
            "kinematic": True,
            "position": {"x": 9.40160042476654, "y": 0.46919119358062744, "z": 0.6366437911987305},
            "rotation": {"x": 0, "y": 90, "z": 0},
        },
        {
            "assetId": "Fridge_5",
            "id": "Fridge|2|1",
            "kinematic": True,
            "position": {"x": 15.40279503440857, "y": 0.8463026285171509, "z": 2.204727741956711},
            "rotation": {"x": 0, "y": 270, "z": 0},
        },
        {
            "assetId": "Houseplant_18",
            "id": "HousePlant|2|2|0",
            "kinematic": False,
            "position": {"x": 8.93080417733744, "y": 0.42520612478256226, "z": 2.8418986715687},
            "rotation": {"x": 0, "y": 11.153481437455142, "z": 0},
        },
    ],
    "proceduralParameters": {"receptacleHeight": 0.7},
    "rooms": [
        {
            "floorPolygon": [
                {"x": x, "y": 0, "z": z}
                for x, z in (
                    (8.767, 0.0),
                    (8.767, 5.26),
                    (15.781, 5.26),
                    (15.781, 1.753),
                    (14.028, 1.753),
                    (14.028, 0.0),
                )
            ],
            "id": "room|2",
            "roomType": "Kitchen",
        },
        {
            "floorPolygon": [
                {"x": x, "y": 0, "z": z} for x, z in ((8.767, 5.26), (8.767, 8.767), (15.781, 8.767), (15.781, 5.26))
            ],
            "id": "room|3",
            "roomType": "LivingRoom",
        },
    ],
    "walls": [
        {
            "id": "wall|3|8.77|5.26|15.78|5.26",
            "roomId": "room|3",
            "polygon": [
                {"x": x, "y": y, "z": 5.26} for x, y in ((15.781, 0), (8.767, 0), (15.781, 2.6135), (8.767, 2.6135))
            ],
        },
        {
            "id": "wall|2|14.03|0.00|14.03|1.75",
            "roomId": "room|2",
            "polygon": [  # the upper corners first, as some walls have them
                {"x": 14.028, "y": y, "z": z} for y, z in ((2.6135, 0.0), (2.6135, 1.753), (0, 0.0), (0, 1.753))
            ],
        },
    ],
    "windows": [
        {
            "assetId": "Window_Hung_48x44",
            "id": "window|2|1",
            "room0": "room|2",
            "room1": "room|2",
            "wall0": "wall|2|14.03|0.00|14.03|1.75",
            "wall1": "wall|exterior|14.03|0.00|14.03|1.75",
            "holePolygon": [
                {"x": 0.04993898307930689, "y": 0.6693971004626098, "z": 0},
                {"x": 1.2664995852674172, "y": 1.9420564320227447, "z": 0},
            ],
            "assetPosition": {"x": 0.6669672976995633, "y": 1.3060478713652435, "z": 0},
        }
    ],
}

ASSETS = {
    "Fridge": [{"assetId": "Fridge_5", "boundingBox": {"x": 0.85345548, "y": 1.69260526, "z": 0.70640993}}],
    "CounterTop": [{"assetId": "Countertop_L_4x4", "boundingBox": {"x": 1.22328758, "y": 0.93838239, "z": 1.21920085}}],
    "HousePlant": [{"assetId": "Houseplant_18", "boundingBox": {"x": 0.23464394, "y": 0.85041225, "z": 0.24502055}}],
}


def test_a_kitchen_of_procthor(tmp_path):
    """The fridge has its back at the east wall, as its asset's box says; the counter stands in the corner."""
    written(tmp_path, "assets/asset-database.json", ASSETS)
    rooms = rooms_of("ai2thor", written(tmp_path, "house.json", KITCHEN), tmp_path / "assets")
    kitchen = rooms["room|2"]
    assert kitchen.type == "Kitchen"
    assert kitchen.height == pytest.approx(2.6135)
    things = things_of(kitchen)
    fridge = things["Fridge|2|1"]
    require_pose(fridge, (15.40279503, 2.20472774, 0.84630263), (-1, 0, 0))
    assert fridge.size == pytest.approx((0.70640993, 0.85345548, 1.69260526))
    back = fridge.position[0] + fridge.size[0] / 2
    assert 15.781 - 0.05 < back < 15.781
    assert 2 * fridge.position[2] == pytest.approx(fridge.size[2], abs=1e-4)
    require_pose(things["CounterTop|2|0"], (9.40160042, 0.63664379, 0.46919119), (1, 0, 0))
    angle = math.radians(11.153481437455142)
    require_pose(
        things["HousePlant|2|2|0"], (8.93080418, 2.84189867, 0.42520612), (math.sin(angle), math.cos(angle), 0)
    )
    book = things["Book|surface|2|0"]
    assert (book.support, book.mount, book.size) == ("CounterTop|2|0", "surface", None)
    assert book.label == "Book"
    assert not rooms["room|3"].objects


def test_a_scaled_thing(tmp_path):
    """Factors along Unity's axes: x is the width, y the height, z the depth."""
    written(tmp_path, "assets/asset-database.json", ASSETS)
    house = changed(KITCHEN, {"x": 2.0, "y": 0.5, "z": 1.5}, "objects", 1, "scale")
    rooms = rooms_of("ai2thor", written(tmp_path, "house.json", house), tmp_path / "assets")
    size = things_of(rooms["room|2"])["Fridge|2|1"].size
    assert size == pytest.approx((0.70640993 * 1.5, 0.85345548 * 2, 1.69260526 / 2))


def test_holes_count_from_the_first_corner_of_their_wall(tmp_path):
    rooms = rooms_of("ai2thor", written(tmp_path, "house.json", KITCHEN))
    (door,) = rooms["room|3"].openings
    np.testing.assert_allclose(door.start, (15.781 - 1.0606274069, 5.26), atol=1e-9)
    np.testing.assert_allclose(door.end, (15.781 - 3.0009636343, 5.26), atol=1e-9)
    assert (door.kind, door.leads_to, door.bottom) == ("passage", "room|2", 0.0)  # a frame has no leaf
    assert door.height == pytest.approx(2.0956013202667236)
    openings = {o.name: o for o in rooms["room|2"].openings}
    assert openings["door|2|3"].leads_to == "room|3"
    window = openings["window|2|1"]
    np.testing.assert_allclose((window.start, window.end), ((14.028, 0.04993898), (14.028, 1.26649959)), atol=1e-8)
    assert window.bottom == pytest.approx(0.6693971)
    assert window.height == pytest.approx(1.9420564320 - 0.6693971005)


def test_doors_turn_away_from_their_first_room(tmp_path):
    """The wall of room 3 runs west along its south side, so that its left is outside: in room 2."""
    leaf = changed(KITCHEN, "Doorway_Double_2", "doors", 0, "assetId")
    rooms = rooms_of("ai2thor", written(tmp_path, "house.json", leaf))
    (there,) = rooms["room|3"].openings
    here = next(o for o in rooms["room|2"].openings if o.kind == "door")
    assert (there.swing, here.swing) == ("out", None)


def test_the_older_schema(tmp_path):
    old = without(KITCHEN, "metadata")
    for hole in (old["doors"][0], old["windows"][0]):
        low, high = hole.pop("holePolygon")
        hole["boundingBox"] = {"min": low, "max": high}
        hole["assetOffset"] = {"x": 0.04, "y": -0.01, "z": 0}
        del hole["assetPosition"]
    before = rooms_of("ai2thor", written(tmp_path, "new.json", KITCHEN))
    after = rooms_of("ai2thor", written(tmp_path, "old.json", old))
    assert {n: r.openings for n, r in before.items()} == {n: r.openings for n, r in after.items()}


def reflected(x: float, y: float, z: float) -> np.ndarray:
    """Unity's rotation by angles [degrees], between our axes: each a turn about a mirrored axis the other way round."""

    def turn(axis, degrees):
        c, s = math.cos(math.radians(-degrees)), math.sin(math.radians(-degrees))
        k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
        return np.eye(3) + s * k + (1 - c) * k @ k  # Rodrigues

    # Unity applies z first, then x, then y; its axes x, y, z are ours x, z, y
    return turn((0, 0, 1), y) @ turn((1, 0, 0), x) @ turn((0, 1, 0), z)


@pytest.mark.parametrize("angles", [(0, 17.2, 0), (0, -68.8, 0), (0, 137.5, 0), (20, 50, 0), (-15, 250, 33)])
def test_turns_of_a_left_handed_frame(tmp_path, angles):
    """Against matrices by Rodrigues: at 0 a thing faces their +z, our +y."""
    house = changed(KITCHEN, dict(zip("xyz", angles, strict=True)), "objects", 1, "rotation")
    thing = things_of(rooms_of("ai2thor", written(tmp_path, "house.json", house))["room|2"])["Fridge|2|1"]
    expected = reflected(*angles)
    require_pose(thing, (15.40279503, 2.20472774, 0.84630263), expected @ (0, 1, 0), expected @ (0, 0, 1))
    if angles[0] == angles[2] == 0:
        require_pose(thing, (15.40279503, 2.20472774, 0.84630263), compass(math.pi / 2 - math.radians(angles[1])))


# An L-shaped office as Holodeck writes it: (x, z) in metres, corners of things in centimetres with 10 cm added.


def corners(centre, sides, turn):
    """Corners [cm] in (x, z), with the buffer, of a thing of (width, depth) turned clockwise from +z."""
    w, d = sides[0] * 100 + 10, sides[1] * 100 + 10
    a = math.radians(turn)
    front, right = np.array((math.sin(a), math.cos(a))), np.array((math.cos(a), -math.sin(a)))
    ends = [(i * w / 2) * right + (j * d / 2) * front for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return [list(np.array(centre) * 100 + e) for e in [*ends, ends[0]]]


def placed(name, asset, centre, turn, up, room="office", **more):
    return {
        "assetId": asset,
        "id": name if "|" in name else f"{name} ({room})",
        "position": {"x": centre[0], "y": up, "z": centre[1]},
        "rotation": {"x": 0, "y": turn, "z": 0},
        "roomId": room,
        **more,
    }


DESK_ITEM = placed(
    "desk-0",
    "aaa",
    (1.3, 3.9),
    90,
    0.37,
    vertices=corners((1.3, 3.9), (1.5, 0.7), 90),
    object_name="desk-0",
    kinematic=True,
)
SHELF_ITEM = placed(
    "bookshelf-1",
    "bbb",
    (3.2, 0.5),
    217.5,
    0.9,
    vertices=corners((3.2, 0.5), (0.8, 0.3), 217.5),
    object_name="bookshelf-1",
)
PAINTING = placed("painting-0", "ccc", (0.03, 2.2), 90, 1.6, vertices=[[0, 180], [6, 180], [6, 260], [0, 260]])
LAMP = placed("desk lamp-0|desk-0 (office)", "ddd", (1.2, 4.1), 30, 0.95)
OFFICE = {
    "query": "an office with an L",
    "wall_height": 2.7,
    "proceduralParameters": {},
    "rooms": [
        {
            "id": "office",
            "roomType": "office",
            "vertices": [[0, 0], [0, 5], [3, 5], [3, 2], [5, 2], [5, 0]],
            "floorPolygon": [{"x": x, "y": 0, "z": z} for x, z in ((0, 0), (0, 5), (3, 5), (3, 2), (5, 2), (5, 0))],
        }
    ],
    "walls": [
        {
            "id": "wall|office|north|0",
            "roomId": "office",
            "segment": [[0, 5], [3, 5]],
            "polygon": [{"x": x, "y": y, "z": 5} for x, y in ((0, 0), (0, 2.7), (3, 2.7), (3, 0))],
        }
    ],
    "doors": [
        {
            "assetId": "Doorway_6",
            "id": "door|0|exterior|office",
            "room0": "exterior",
            "room1": "office",
            "wall0": "wall|office|north|0|exterior",
            "wall1": "wall|office|north|0",
            "holePolygon": [{"x": 0.4, "y": 0, "z": 0}, {"x": 1.35, "y": 2.1, "z": 0}],
            "doorSegment": [[2.6, 5.0], [1.65, 5.0]],
        }
    ],
    "windows": [],
    "open_walls": {"segments": [[[5, 2], [5, 0]]], "openWallBoxes": []},
    "objects": [DESK_ITEM, SHELF_ITEM, PAINTING, LAMP],
    "floor_objects": [DESK_ITEM, SHELF_ITEM],
    "wall_objects": [PAINTING],
    "small_objects": [LAMP],
}


def test_an_office_of_holodeck(tmp_path):
    (room,) = rooms_of("ai2thor", written(tmp_path, "an_office.json", OFFICE)).values()
    assert (room.text, room.height) == ("an office with an L", 2.7)
    assert room.outline == ((0, 0), (0, 5), (3, 5), (3, 2), (5, 2), (5, 0))
    things = things_of(room)
    desk, shelf = things["desk-0 (office)"], things["bookshelf-1 (office)"]
    require_pose(desk, (1.3, 3.9, 0.37), (1, 0, 0))
    assert desk.size == pytest.approx((0.7, 1.5, 0.74))  # without the buffer, from centimetres
    turn = math.radians(217.5)
    require_pose(shelf, (3.2, 0.5, 0.9), (math.sin(turn), math.cos(turn), 0))
    assert shelf.size == pytest.approx((0.3, 0.8, 1.8))
    assert (desk.label, shelf.label, desk.mount) == ("desk", "bookshelf", "floor")
    painting, lamp = things["painting-0 (office)"], things["desk lamp-0|desk-0 (office)"]
    assert (painting.mount, painting.size, painting.label) == ("wall", None, "painting")
    assert (lamp.support, lamp.mount, lamp.label) == ("desk-0 (office)", "surface", "desk lamp")
    door, gap = room.openings
    assert (door.kind, door.start, door.end) == ("door", (2.6, 5.0), (1.65, 5.0))  # not by its hole
    assert (gap.kind, gap.start, gap.end) == ("passage", (5, 2), (5, 0))


def test_boxes_of_objathor(tmp_path):
    """Of an asset's own annotation, or of corners."""
    written(
        tmp_path,
        "assets/ccc/annotations.json",
        {
            "thor_metadata": {
                "assetMetadata": {
                    "boundingBox": {"min": {"x": -0.5, "y": 0.0, "z": -0.02}, "max": {"x": 0.4, "y": 0.6, "z": 0.03}}
                }
            }
        },
    )
    with gzip.open(tmp_path / "assets" / "ddd.json.gz", "wt") as file:
        json.dump({"assetMetadata": {"boundingBox": {"x": 0.2, "y": 0.5, "z": 0.15}}}, file)
    (room,) = rooms_of("ai2thor", written(tmp_path, "office.json", OFFICE), tmp_path / "assets").values()
    things = things_of(room)
    assert things["painting-0 (office)"].size == pytest.approx((0.05, 0.9, 0.6))
    assert things["desk lamp-0|desk-0 (office)"].size == pytest.approx((0.15, 0.2, 0.5))


def test_houses_a_line(tmp_path):
    path = tmp_path / "train.jsonl.gz"
    with gzip.open(path, "wt") as file:
        file.writelines(json.dumps(house) + "\n" for house in (KITCHEN, OFFICE))
    rooms = rooms_of("ai2thor", path)
    assert list(rooms) == ["house 1 room|2", "house 1 room|3", "house 2 office"]
    made = list(sw.read_scenes(path, assets="boxes", room="house 2 office"))
    assert [m.scene.room.type for m in made] == ["office"]
    with gzip.open(path, "at") as file:
        file.write('{"rooms": [}\n')
    assert len(list(sw.read_scenes(path, assets="boxes", on_error=(lines := []).append))) >= 2
    assert len([line for line in lines if "line 3" in line]) == 1


def test_early_houses_whose_ids_tell_no_type(tmp_path):
    """There the database of assets says what a thing is, or else the name of the asset."""
    written(tmp_path, "assets/asset-database.json", ASSETS)
    house = json.loads(json.dumps(KITCHEN))
    counter = house["objects"][0]
    counter["id"], counter["children"][0]["id"] = "2|0", "small|2|0"
    file = written(tmp_path, "house.json", house)
    things = things_of(rooms_of("ai2thor", file, tmp_path / "assets")["room|2"])
    assert (things["2|0"].label, things["small|2|0"].label) == ("CounterTop", "Book_17")
    things = things_of(rooms_of("ai2thor", file)["room|2"])
    assert things["2|0"].label == "Countertop_L_4x4"


def test_from_file_to_judge(tmp_path):
    """What is apart in the file is apart in the scene; moved into each other, the judge finds it."""
    boxes = {"ccc": (0.9, 0.6, 0.05), "ddd": (0.2, 0.42, 0.15)}
    data = {name: {"boundingBox": dict(zip("xyz", box, strict=True))} for name, box in boxes.items()}
    written(tmp_path, "assets/assets.json", data)
    office = written(tmp_path, "office.json", OFFICE)
    (made,) = sw.read_scenes(office, assets="boxes", folder=tmp_path / "assets")
    report = sw.check(made.scene)
    assert (report.collisions, report.out_of_bounds, report.unsupported) == (0, 0, 0), report
    assert {o.id: o.support.object for o in made.scene.objects if o.support} == {
        "desk lamp-0|desk-0 (office)": "desk-0 (office)"
    }
    shelf = changed(OFFICE, {"x": 1.3, "y": 0.9, "z": 3.7}, "objects", 1, "position")
    (worse,) = sw.read_scenes(written(tmp_path, "worse.json", shelf), assets="boxes", folder=tmp_path / "assets")
    assert sw.check(worse.scene).collisions


def test_broken_files(tmp_path):
    text = written(tmp_path, "whole.json", KITCHEN).read_text()
    for name, data, words in (
        ("cut.json", text[:-40], ("cut off",)),
        ("type.json", changed(KITCHEN, [1, 2, 3], "objects", 1, "position"), ("objects[1].position", "object")),
        ("missing.json", without(KITCHEN, "objects", 0, "children", 0, "position", "y"), ("children[0]", "'y'")),
        ("nan.json", changed(KITCHEN, float("nan"), "objects", 1, "rotation", "y"), ("rotation.y", "NaN")),
        ("empty.json", "", ("empty",)),
        ("rooms.json", changed(KITCHEN, [], "rooms"), ("rooms", "at least one")),
        ("floor.json", changed(KITCHEN, [], "rooms", 0, "floorPolygon"), ("rooms[0].floorPolygon", "3 corners")),
    ):
        require_error(written(tmp_path, name, data), "ai2thor", *words)
    metres = changed(OFFICE, [[0.5, 3], [2, 3], [2, 4], [0.5, 4]], "objects", 0, "vertices")
    require_error(written(tmp_path, "metres.json", metres), "ai2thor", "objects[0].vertices", "cm")
