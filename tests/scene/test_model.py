"""Every bad input gives one clear line; good input stays what it is."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest

from sceneweaver.scene import InputError, Pose, Relation, Room, Scene, SceneObject, SceneWeaverError
from sceneweaver.scene.limits import (
    MAX_CORNERS,
    MAX_DOORS,
    MAX_OBJECTS,
    MAX_PARTS,
    MAX_RELATIONS,
    MAX_SHAPES,
    MAX_WINDOWS,
)

NAN, INF = float("nan"), float("inf")
DESK, CHAIR = ("objects", 1), ("objects", 3)
SQUARE = [[0, 0], [5, 0], [5, 4], [0, 4]]
R0 = ("relations", 0)


def near(**more):
    return {"type": "near", "subject": "chair-0", "target": "desk-0", **more}


BAD = [
    # numbers
    ((*CHAIR, "size", 1), -0.5, "objects[3] 'chair-0': size[1] is -0.5; sizes are positive metres"),
    ((*CHAIR, "size", 1), 0, "objects[3] 'chair-0': size[1] is 0; sizes are positive metres"),
    ((*CHAIR, "size", 1), 1e-9, "size[1] is 1e-09; sizes are positive metres, at least 1e-06"),
    ((*CHAIR, "size", 1), 1e300, "size[1] is 1e+300; numbers are metres, at most 1e+06"),
    ((*CHAIR, "size", 1), NAN, "objects[3] 'chair-0': size[1] is NaN; numbers must be finite"),
    ((*CHAIR, "size", 1), INF, "size[1] is Infinity; numbers must be finite"),
    ((*CHAIR, "size", 1), "1", 'size[1] is "1"; give a number'),
    ((*CHAIR, "size", 1), True, "size[1] is true; give a number"),
    ((*CHAIR, "size", 1), None, "size[1] is null; give a number"),
    ((*CHAIR, "size", 1), 10**400, "size[1] is a huge number"),
    ((*CHAIR, "size"), [1, 2], "size has 2 entries; give 3"),
    ((*CHAIR, "size"), [1, 2, 3, 4], "size has 4 entries; give 3"),
    ((*CHAIR, "size"), {}, "size is an object; give a list"),
    (
        (*DESK, "pose", "position", 2),
        -INF,
        "objects[1] 'desk-0': pose.position[2] is -Infinity; numbers must be finite",
    ),
    ((*DESK, "parts", 0, "z", 1), NAN, "parts[0].z[1] is NaN"),
    ((*DESK, "parts", 1, "polygon"), [[0, 0], [1, 0], [NAN, 1]], "parts[1].polygon[2][0] is NaN"),
    ((*DESK, "zones", 0, "polygon", 2, 1), INF, "zones[0].polygon[2][1] is Infinity"),
    ((*DESK, "surfaces", 0, "z"), NAN, "surfaces[0].z is NaN"),
    ((*DESK, "attributes", "style", "era", 1), NAN, "attributes.style.era[1] is NaN; numbers must be finite"),
    (("provenance", "x"), [[INF]], "provenance.x[0][0] is Infinity; numbers must be finite"),
    (("room", "height"), NAN, "room.height is NaN"),
    (("room", "doors", 0, "offset"), NAN, "room.doors[0] 'door-0': offset is NaN"),
    ((*R0, "weight"), NAN, "relations[0] against_wall 'desk-0': weight is NaN"),
    (("relations", 1, "params", "gap", 1), NAN, "relations[1] around 'chair-0': params.gap[1] is NaN"),
    # room
    (("room", "outline"), SQUARE[::-1], "room.outline runs clockwise; reverse it and renumber the walls"),
    (("room", "outline"), [[0, 0], [5, 4], [5, 0], [0, 4]], "room.outline crosses itself: edges 0 and 2 meet"),
    (("room", "outline"), [[0, 0], [5, 0], [5, 4], [2, 0], [0, 4]], "room.outline crosses itself: edges 0 and 2 meet"),
    (("room", "outline"), [[0, 0], [5, 0]], "room.outline has 2 entries; give at least 3"),
    (("room", "outline"), [*SQUARE, [0, 0]], "room.outline[4] repeats corner 0; leave the closing corner out"),
    (("room", "outline"), [[0, 0], [5, 0], [5, 0], [0, 4]], "room.outline[2] repeats corner 1; remove one of them"),
    (("room", "outline"), [[0, 0], [5, 0], [3, 0], [0, 4]], "room.outline[1] is a spike"),
    (("room", "outline"), [[0, 0], [1, 0], [2, 0]], "is a spike"),
    (("room", "outline", 1), [5, 0, 0], "room.outline[1] has 3 entries; give 2"),
    (("room", "outline"), [[math.cos(i), math.sin(i)] for i in range(99)], "room.outline crosses itself (Self-inter"),
    (("room", "height"), -1, "room.height is -1; heights are positive metres"),
    (("room", "height"), 1.0, "room.doors[0] 'door-0': height is 2 m, but the room is 1 m high; make it lower"),
    # openings
    (("room", "doors", 0, "wall"), 4, "room.doors[0] 'door-0': wall is 4; the outline has walls 0 to 3"),
    (("room", "doors", 0, "wall"), -1, "wall is -1; walls are numbered from 0"),
    (("room", "doors", 0, "wall"), 1.0, "wall is 1.0; give a whole number"),
    (("room", "doors", 0, "wall"), True, "wall is true; give a whole number"),
    (("room", "doors", 0, "offset"), -0.01, "offset is -0.01; offsets are metres from the wall's first corner"),
    (("room", "doors", 0, "offset"), 4.2, "'door-0': offset + width is 5.1 m, but wall 0 is 5 m long"),
    (("room", "doors", 0, "width"), 0, "width is 0; widths are positive metres"),
    (("room", "doors", 0, "swing"), "in_left", 'swing is "in_left"; did you mean "in-left"?'),
    (
        ("room", "windows", 0, "sill"),
        1.4,
        "room.windows[0] 'window-0': sill + height is 2.6 m, but the room is 2.5 m high",
    ),
    (("room", "windows", 0, "sill"), -0.1, "sill is -0.1; sills are metres above the floor"),
    # ids
    (("objects", 3, "id"), "chair-1", "objects[4] 'chair-1': id is taken by objects[3]; ids are unique"),
    (("objects", 3, "id"), "door-0", "objects[3] 'door-0': id is taken by room.doors[0]"),
    (("room", "windows", 0, "id"), "door-0", "room.windows[0] 'door-0': id is taken by room.doors[0]"),
    (("objects", 3, "id"), "", 'id is ""; give at least 1 character'),
    (("objects", 3, "id"), "wall:1", 'ids that start with "wall:" mean walls'),
    (("objects", 3, "id"), "a\nb", "ids are printable"),
    (("objects", 3, "id"), " a", "ids are printable and neither start nor end with a space"),
    (("objects", 3, "id"), 3, "objects[3]: id is 3; give a string"),
    (("objects", 3, "category"), "", 'category is ""; give at least 1 character'),
    (("prompt",), "\ud800", "prompt holds half a surrogate pair"),
    (("provenance", "x"), "\ud800", "provenance.x holds half a surrogate pair"),
    # poses and shapes
    ((*DESK, "pose", "quaternion"), [0, 0, 0, 1.01], "pose.quaternion has norm 1.01; divide it by its norm"),
    ((*DESK, "pose", "quaternion"), [0, 0, 0, 0], "pose.quaternion has norm 0;"),
    ((*DESK, "pose", "quaternion"), [0, 0, 1], "pose.quaternion has 3 entries; give 4"),
    (
        (*DESK, "parts", 0, "polygon"),
        [[0, 0], [1, 0], [0.2, 0.2], [0, 1]],
        "parts[0].polygon is not convex at corner (0.2",
    ),
    ((*DESK, "parts", 0, "polygon"), [[0, 0], [1, 1]], "parts[0].polygon has 2 entries; give at least 3"),
    ((*DESK, "parts", 0, "polygon"), [[0, 0], [1, 1], [1, 0], [0, 1]], "parts[0].polygon crosses itself"),
    ((*DESK, "parts", 0, "z"), [1, 1], "parts[0].z is [1, 1]; the first must be less than the second"),
    ((*DESK, "zones", 0, "polygon"), [[0, 0], [1, 1], [1, 0], [0, 1]], "zones[0].polygon crosses itself"),
    ((*DESK, "zones", 0, "z"), [2, 1], "zones[0].z is [2, 1]"),
    ((*DESK, "zones", 0, "hard"), 1, "zones[0].hard is 1; give true or false"),
    ((*DESK, "surfaces", 0, "polygon"), [[0, 0], [1, 1], [1, 0], [0, 1]], "surfaces[0].polygon crosses itself"),
    ((*DESK, "surfaces", 0, "headroom"), 0, "surfaces[0].headroom is 0; head rooms are positive metres, or null"),
    (
        (*CHAIR, "surfaces"),
        [{"name": "a", "polygon": SQUARE, "z": 1}, {"name": "a", "polygon": SQUARE, "z": 2}],
        'surfaces[1].name "a" is taken; choose another',
    ),
    # mount and support
    ((*CHAIR, "mount"), "flor", 'mount is "flor"; did you mean "floor"?'),
    ((*CHAIR, "mount"), 5, "mount is 5; give one of: floor, wall, ceiling, surface"),
    ((*CHAIR, "mount"), "surface", "objects[3] 'chair-0': support is missing, but mount is \"surface\""),
    ((*CHAIR, "support"), {"object": "desk-0", "surface": "top"}, 'support is given, but mount is "floor"'),
    (
        ("objects", 0, "support", "object"),
        "dsk-0",
        "support.object is 'dsk-0', which is no object; did you mean 'desk-0'?",
    ),
    (
        ("objects", 0, "support", "surface"),
        "tpo",
        'surface is "tpo", which is no surface of \'tray-0\'; did you mean "top"?',
    ),
    (("objects", 0, "support", "object"), "chair-0", "which is no surface of 'chair-0'; its surfaces: none"),
    (
        ("objects", 2, "support", "object"),
        "tray-0",
        "objects[2] 'tray-0': support goes round in a circle: 'tray-0' -> 'tray-0'",
    ),
    # relations
    ((*R0, "type"), "agianst_wall", '"agianst_wall" is unknown; did you mean "against_wall"?'),
    ((*R0, "type"), "zzz", '"zzz" is unknown; known: against_wall, side_against_wall,'),
    (
        (*R0, "subject"),
        "dekc-0",
        "relations[0] against_wall 'dekc-0': subject is 'dekc-0', which is no object; did you mean",
    ),
    ((*R0, "subject"), "door-0", "subject is 'door-0', which is no object"),
    ((*R0, "target"), "wall:4", "target is 'wall:4', which is no wall of this scene; the walls are wall:0 to wall:3"),
    ((*R0, "target"), "wall:01", "target is 'wall:01'; against_wall takes \"wall:k\" or null"),
    ((*R0, "target"), "chair-0", "target is 'chair-0'; against_wall takes \"wall:k\" or null"),
    ((*R0, "target"), ["chair-0", "chair-1"], "target is ['chair-0', 'chair-1']; against_wall takes"),
    ((*R0, "target"), 5, "target is 5; give an id, a list of two ids, or null"),
    ((*R0, "target"), ["a"], "target is a list; give an id, a list of two ids, or null"),
    (R0, near(target="chiar-1"), "target is 'chiar-1', which is no object of this scene; did you mean 'chair-1'?"),
    (R0, near(target="window-0"), "target is 'window-0', which is no object"),
    (R0, near(target="chair-0"), "target is 'chair-0', the subject itself; name another object"),
    (R0, near(target=None), "target is missing; near takes the id of an object"),
    (R0, near(type="between"), "target is 'desk-0'; between takes a list of two object ids"),
    (R0, near(type="between", target=["desk-0", "desk-0"]), "target names 'desk-0' twice; name two objects"),
    (R0, near(type="between", target=["desk-0", "chair-0"]), "the subject itself"),
    (R0, near(type="between", target=["desk-0", "chair-9"]), "target[1] is 'chair-9', which is no object"),
    (R0, near(type="at_window", target=None), "target is missing; at_window takes the id of a window"),
    (R0, near(type="at_window", target="windw-0"), "which is no window of this scene; did you mean 'window-0'?"),
    (R0, near(type="away_from_door", target="dor-0"), "which is no door of this scene; did you mean 'door-0'?"),
    (R0, near(type="in_corner"), "target is 'desk-0'; in_corner takes none, set it to null"),
    (R0, near(params={"mx": 1}), 'params: unknown param "mx"; did you mean "max"?'),
    (R0, near(params={"zzz": 1}), 'params: unknown param "zzz"; known: max'),
    (R0, near(type="on_floor", target=None, params={"max": 1}), 'unknown param "max"; on_floor takes none'),
    (R0, near(params={"max": "1"}), 'params.max is "1"; give a number'),
    (R0, near(params={"max": -1}), "params.max is -1; it must be at least 0"),
    (R0, near(params=[]), "params is a list; give an object {...}"),
    (R0, near(type="facing", params={"degrees": 0}), "params.degrees is 0; it must be more than 0"),
    (R0, near(type="facing", params={"degrees": 181}), "params.degrees is 181; it must be at most 180"),
    (
        R0,
        near(type="front_against", params={"gap": [0.5, 0.3]}),
        "params.gap is [0.5, 0.3]; the first must not be more",
    ),
    (R0, near(type="front_against", params={"gap": 0.3}), "params.gap is 0.3; give a range [least, most]"),
    (R0, near(type="side_by_side", params={"gap": "tucked"}), 'params.gap is "tucked"; give a range'),
    (R0, near(type="distance", params={"min": 1}), 'params: "max" is missing; distance needs it, in m'),
    (R0, near(type="distance", params={"min": 2, "max": 1}), "params.min is 2, more than max 1; swap them"),
    (R0, near(type="around", params={"n": 2.5}), "params.n is 2.5; give a whole number"),
    (R0, near(weight=0), "weight is 0; weights are positive numbers"),
    # keys and kinds
    ((*CHAIR, "positon"), [0, 0, 0], 'objects[3] \'chair-0\': unknown key "positon"; did you mean "pose.position"?'),
    ((*CHAIR, "zone"), [], 'unknown key "zone"; did you mean "zones"?'),
    ((*CHAIR, "qqq"), 1, 'unknown key "qqq"; known keys: id, category,'),
    (("rooms",), {}, 'unknown key "rooms"; did you mean "room"?'),
    (("room", "dors"), [], 'room: unknown key "dors"; did you mean "doors"?'),
    ((*DESK, "parts", 0, "height"), 1, "objects[1] 'desk-0': parts[0]: unknown key \"height\""),
    ((*DESK, "attributes"), [], "attributes is a list; give an object {...}"),
    (("objects", 3), 5, "objects[3] is 5; give an object {...}"),
    (("objects",), {}, "objects is an object; give a list"),
    (("room",), None, "room is null; give an object {...}"),
    (
        ("dropped", 0),
        {"id": "x", "category": "y"},
        "dropped[0] 'x': \"reason\" is missing; add it (why it could not be",
    ),
]


@pytest.mark.parametrize(("path", "value", "message"), BAD, ids=[str(i) for i in range(len(BAD))])
def test_bad_input_gives_one_line(small, put, path, value, message):
    with pytest.raises(InputError) as caught:
        Scene.from_json(put(small, path, value))
    text = str(caught.value)
    assert message in text
    assert text.isprintable() and len(text) < 300, text


def test_missing_key_says_what_it_is(small):
    del small["objects"][3]["size"]
    with pytest.raises(
        InputError, match=r"^objects\[3\] 'chair-0': \"size\" is missing; add it \(depth along the front"
    ):
        Scene.from_json(small)


def test_a_misspelt_key_is_reported_rather_than_the_one_it_stands_for(small):
    small["objects"][3]["siez"] = small["objects"][3].pop("size")
    with pytest.raises(InputError, match='unknown key "siez"; did you mean "size"'):
        Scene.from_json(small)


def test_longer_circle_of_support_is_named(small):
    square = [[0, 0], [1, 0], [1, 1]]
    small["objects"][1] |= {"mount": "surface", "support": {"object": "cup-0", "surface": "rim"}}
    small["objects"][0]["surfaces"] = [{"name": "rim", "polygon": square, "z": 1}]
    with pytest.raises(
        InputError, match="circle: 'cup-0' -> 'tray-0' -> 'desk-0' -> 'cup-0'; one must stand elsewhere"
    ):
        Scene.from_json(small)


def test_long_chain_of_supports_is_fine():
    top = [{"name": "top", "polygon": [[0, 0], [1, 0], [1, 1]], "z": 1}]
    objects = [{"id": "o0", "category": "box", "size": [1, 1, 1], "surfaces": top}]
    for i in range(1, MAX_OBJECTS):
        support = {"object": f"o{i - 1}", "surface": "top"}
        more = {"id": f"o{i}", "mount": "surface", "support": support}
        objects.append({**objects[0], **more})
    scene = Scene(id="tower", room={"outline": SQUARE}, objects=objects[::-1])
    assert len(scene.objects) == MAX_OBJECTS


def test_models_made_alone_name_themselves():
    with pytest.raises(InputError, match=r"^object 'chair-0': size\[1\] is -1; sizes are positive metres$"):
        SceneObject(id="chair-0", category="chair", size=(1, -1, 1))
    with pytest.raises(InputError, match=r"^pose: quaternion has norm 2"):
        Pose(quaternion=(0, 0, 0, 2))
    with pytest.raises(InputError, match=r"^room: outline has 2 entries"):
        Room(outline=[(0, 0), (1, 0)])
    with pytest.raises(InputError, match="^relation: target is missing; near takes"):
        Relation(type="near", subject="a")
    with pytest.raises(InputError, match="^pose: yaw is Infinity"):
        Pose.from_yaw(0, 0, 0, INF)
    assert issubclass(InputError, ValueError) and issubclass(InputError, SceneWeaverError)


def test_openings_may_touch_the_ends_of_wall_and_room(small):
    small["room"]["doors"][0] |= {"offset": 5 - 0.9 + 5e-7, "height": 2.5 + 5e-7}
    assert Scene.from_json(small).room.doors[0].width == 0.9


def test_openings_in_a_slanted_last_wall(small):
    small["room"]["outline"] = [[0, 0], [4, 0], [4, 3]]
    small["room"]["doors"][0] |= {"wall": 2, "offset": 4.0, "width": 1.0}
    small["room"]["windows"] = []
    del small["relations"][5]
    assert Scene.from_json(small).room.doors[0].wall == 2


def test_collinear_corners_split_a_wall(small):
    small["room"]["outline"] = [[0, 0], [2.5, 0], [5, 0], [5, 4], [0, 4]]
    small["room"]["windows"][0]["wall"] = 3
    assert len(Scene.from_json(small).room.outline) == 5


def test_polygons_but_the_outline_are_turned_counter_clockwise(small):
    clockwise = [[0, 0], [0, 1], [1, 1], [1, 0]]
    desk = small["objects"][1]
    for key in ("parts", "zones", "surfaces"):
        desk[key][0]["polygon"] = clockwise
    obj = Scene.from_json(small).objects[1]
    for prism in (obj.parts[0], obj.zones[0], obj.surfaces[0]):
        assert prism.polygon == ((0, 0), (1, 0), (1, 1), (0, 1))


def test_zones_and_surfaces_may_be_concave(small):
    concave = [[0, 0], [1, 0], [0.2, 0.2], [0, 1]]
    small["objects"][1]["zones"][0]["polygon"] = concave
    small["objects"][1]["surfaces"][0]["polygon"] = concave
    desk = Scene.from_json(small).objects[1]
    assert desk.zones[0].polygon == desk.surfaces[0].polygon == tuple(map(tuple, concave))
    small["objects"][1]["parts"][0]["polygon"] = concave
    with pytest.raises(InputError, match="convex"):
        Scene.from_json(small)


def test_parts_have_no_limit_of_number_or_corners(small):
    ring = [[math.cos(i * math.tau / 80), math.sin(i * math.tau / 80)] for i in range(80)]
    small["objects"][1]["parts"] = [{"polygon": ring, "z": [i, i + 1]} for i in range(9)]
    assert len(Scene.from_json(small).objects[1].parts) == 9


def test_nearly_unit_quaternions_become_unit_and_stay_so():
    pose = Pose(quaternion=(0, 0, 0.7071, 0.7071))
    assert math.hypot(*pose.quaternion) == pytest.approx(1, abs=1e-15)
    assert Pose(quaternion=pose.quaternion).quaternion == pose.quaternion
    assert Pose(quaternion=(0, 0, 0, 1.0009)).quaternion == (0, 0, 0, 1)


@pytest.mark.parametrize("yaw", [0.0, 0.3, -2.9, math.pi / 2, 3.1])
def test_yaw_round_trip(yaw):
    pose = Pose.from_yaw(np.float32(1.5), np.float64(2), 0, yaw)
    assert pose.yaw == pytest.approx(yaw) and pose.position == (1.5, 2.0, 0.0)


def test_numpy_scalars_are_numbers_and_free_values_become_plain():
    obj = SceneObject(
        id="a",
        category="b",
        size=(np.float32(1), np.int64(2), 3),
        attributes={"n": np.int64(3), "t": (1, np.float32(2))},
    )
    assert obj.size == (1, 2, 3) and obj.attributes == {"n": 3, "t": [1, 2.0]}
    json.dumps(obj.attributes)
    with pytest.raises(InputError, match="attributes.x is of type set; give something that JSON can hold"):
        SceneObject(id="a", category="b", size=(1, 1, 1), attributes={"x": {1}})
    with pytest.raises(InputError, match="attributes: key 1 is not a string"):
        SceneObject(id="a", category="b", size=(1, 1, 1), attributes={1: 2})
    with pytest.raises(InputError, match=r"attributes.a: key 1 is not a string"):
        SceneObject(id="a", category="b", size=(1, 1, 1), attributes={"a": {1: 2}})
    with pytest.raises(InputError, match=r"is a huge number"):
        SceneObject(id="a", category="b", size=(1, 1, 1), attributes={"a": 10**5000})


def test_models_are_frozen(small):
    scene = Scene.from_json(small)
    with pytest.raises(ValueError, match="frozen"):
        scene.id = "other"
    with pytest.raises(ValueError, match="frozen"):
        scene.objects[0].pose.position = (0, 0, 0)


def test_params_get_their_types(small):
    relations = Scene.from_json(small).relations
    assert relations[1].params == {"gap": (0.0, 0.2)} and relations[2].params == {"max": 2.0}
    assert Relation(type="around", subject="a", target="b", params={"n": 4.0}).params == {"n": 4}
    assert type(Relation(type="around", subject="a", target="b", params={"n": 4.0}).params["n"]) is int
    assert Relation(type="front_against", subject="a", target="b", params={"gap": "tucked"}).params["gap"] == "tucked"


def test_targets():
    assert Relation(type="in_corner", subject="a").targets == ()
    assert Relation(type="near", subject="a", target="b").targets == ("b",)
    assert Relation(type="between", subject="a", target=["b", "c"]).targets == ("b", "c")


def test_solids_of_an_object_without_parts_are_its_box(small):
    scene = Scene.from_json(small)
    (box,) = scene.object("chair-0").solids
    assert box.polygon == ((-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25)) and box.z == (0, 0.9)
    assert scene.object("desk-0").solids is scene.object("desk-0").parts


def test_lookups(small):
    scene = Scene.from_json(small)
    assert scene.ids == ("cup-0", "desk-0", "tray-0", "chair-0", "chair-1")
    assert scene.index("tray-0") == 2 and scene.object("tray-0") is scene.objects[2]
    with pytest.raises(InputError, match="'chair' is no object of scene 'small'; did you mean 'chair-0'"):
        scene.object("chair")


def test_replace_poses(small):
    scene = Scene.from_json(small)
    assert scene.index("desk-0") == 1  # fills what the scene keeps, which a copy must not believe blindly
    pose = Pose.from_yaw(1, 2, 3, 0.5)
    moved = scene.replace_poses({"desk-0": pose})
    assert moved.object("desk-0").pose == pose and scene.object("desk-0").pose != pose
    assert moved.object("chair-0") is scene.object("chair-0")
    shorter = scene.model_copy(update={"objects": scene.objects[2:]})
    assert shorter.index("tray-0") == 0 and shorter.ids == ("tray-0", "chair-0", "chair-1")
    with pytest.raises(InputError, match="'desk' is no object"):
        scene.replace_poses({"desk": pose})


def test_equality_copies_and_pickles(small):
    scene, other = Scene.from_json(small), Scene.from_json(copy.deepcopy(small))
    scene.index("desk-0")
    assert scene == other and other == scene
    for same in (copy.deepcopy(scene), pickle.loads(pickle.dumps(scene)), scene.model_copy()):
        assert same == scene and same.index("tray-0") == 2
    assert Scene.model_validate(scene.model_dump()) == scene


def test_data_given_is_not_changed(small):
    before = copy.deepcopy(small)
    Scene.from_json(small)
    assert small == before


def boxes(count):
    return [{"id": f"a{i}", "category": "box", "size": [1, 1, 1]} for i in range(count)]


def doors(count, wall=0, **more):
    door = {"wall": wall, "offset": 0.1, "width": 0.5, "height": 2.0, **more}
    return [{**door, "id": f"e{i}"} for i in range(count)]


def windows(count):
    return [{**door, "id": f"f{i}", "sill": 0.1} for i, door in enumerate(doors(count, height=1.0))]


def polygon(corners):
    turns = [2 * math.pi * k / corners for k in range(corners)]
    return [[math.cos(turn), math.sin(turn)] for turn in turns]


@pytest.mark.parametrize(
    ("path", "made", "most"),
    [
        (("objects",), boxes, MAX_OBJECTS),
        (("relations",), lambda n: [{"type": "on_floor", "subject": "a0"}] * n, MAX_RELATIONS),
        (("dropped",), lambda n: [{"id": f"d{k}", "category": "box", "reason": "-"} for k in range(n)], MAX_OBJECTS),
        (("room", "doors"), doors, MAX_DOORS),
        (("room", "windows"), windows, MAX_WINDOWS),
        (("room", "outline"), polygon, MAX_CORNERS),
        (("objects", 0, "parts"), lambda n: [{"polygon": SQUARE, "z": [0, 1]}] * n, MAX_PARTS),
        (("objects", 0, "zones"), lambda n: [{"name": "z", "polygon": SQUARE, "z": [0, 1]}] * n, MAX_PARTS),
        (("objects", 0, "surfaces"), lambda n: [{"name": f"s{k}", "polygon": SQUARE, "z": 1} for k in range(n)], 64),
    ],
)
def test_a_scene_holds_so_much_at_most(path, made, most):
    scene = {
        "schema": "sceneweaver.scene/1",
        "id": "full",
        "room": {"outline": SQUARE, "height": 3.0},
        "objects": boxes(1),
    }
    *above, last = path
    inner = scene
    for key in above:
        inner = inner[key]
    inner[last] = made(most)
    Scene.from_json(copy.deepcopy(scene))
    inner[last] = made(most + 1)
    with pytest.raises(InputError, match=rf"has {most + 1} entries; give at most {most}$"):
        Scene.from_json(scene)


def test_all_shapes_of_a_scene_are_counted():
    part = {"polygon": SQUARE, "z": [0, 1]}
    objects = [{**box, "parts": [part] * MAX_PARTS} for box in boxes(MAX_SHAPES // MAX_PARTS + 1)]
    with pytest.raises(InputError, match=f"^objects: have .* parts, zones and surfaces; give at most {MAX_SHAPES}$"):
        Scene(id="full", room={"outline": SQUARE}, objects=objects)


def test_openings_of_a_wall_do_not_reach_into_each_other():
    first = doors(1)[0]
    beside, above = {**first, "id": "e1", "offset": 0.6}, {**windows(1)[0], "sill": 2.0, "height": 0.5}
    room = {"outline": SQUARE, "height": 3.0}
    assert not Room(**room, doors=[first, beside], windows=[above]).doubled
    for other in ({**first, "id": "e1", "offset": 0.4}, {**first, "id": "e1", "height": 1.5}):
        with pytest.raises(InputError, match=r"doors\[1\] 'e1': 'e0' is partly in the same place of wall 0; move one"):
            Room(**room, doors=[first, other])
    with pytest.raises(InputError, match=r"windows\[0\] 'f0': 'e0' is partly in the same place"):
        Room(**room, doors=[first], windows=[{**above, "sill": 1.5}])
    assert not Room(**room, doors=[first, {**first, "id": "e1", "wall": 1}]).doubled


def test_an_opening_that_is_listed_twice_is_told():
    room = Room(outline=SQUARE, height=3.0, doors=doors(3))
    assert [(a.id, b.id) for a, b in room.doubled] == [("e0", "e1"), ("e0", "e2"), ("e1", "e2")]


def test_finishes_are_on_walls_that_exist(small):
    small["room"]["finish"] = {"accent": {"color": "sage", "walls": [9]}}
    with pytest.raises(InputError, match=r"room\.finish\.accent\.walls: there is no wall 9; the outline has"):
        Scene.from_json(small)
    small["room"]["finish"] = {"tiles": {"color": "white", "low": 1.0, "high": 0.5}}
    with pytest.raises(InputError, match=r"tiles\.high is 0\.5, not above low"):
        Scene.from_json(small)
