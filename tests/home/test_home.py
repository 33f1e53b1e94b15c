"""Homes: what they refer to, the shells of their rooms, walls in plan, files."""

from __future__ import annotations

import json
import math
from typing import Any, cast

import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import sceneweaver as sw
from sceneweaver.home import Home, HomeDoor, HomeRoom, Stair, Storey, wall_openings, wall_polygons


def rectangle(x0: float, y0: float, x1: float, y1: float) -> tuple[tuple[float, float], ...]:
    return (x0, y0), (x1, y0), (x1, y1), (x0, y1)


@pytest.fixture
def flat() -> Home:
    return Home.example("flat")


def changed(home: Home, path: str, value: object) -> dict:
    """The home's data with one value changed: "doors.0.to"."""
    data = home.to_json()
    *head, last = [int(k) if k.isdigit() else k for k in path.split(".")]
    node: Any = data
    for key in head:
        node = node[key]
    node[last] = value
    return data


def test_a_home_comes_back_from_its_file(flat, tmp_path):
    flat.save(tmp_path / "home.json")
    assert Home.load(tmp_path / "home.json") == flat


def test_a_door_is_at_the_same_place_in_both_rooms(flat):
    """The middle of each opening, carried through the wall by hand, is the middle in the other room."""
    for door in flat.doors:
        if door.to is None:
            continue
        here = flat.room(door.room).walls[door.wall]
        other = next(d for d in flat.shell(door.to).doors if d.id == door.id)
        there = flat.room(door.to).walls[other.wall]
        a, b = here.point(door.offset + door.width / 2), there.point(other.offset + other.width / 2)
        assert math.dist(a, b) == pytest.approx(0.1, abs=1e-9)
        assert (b[0] - a[0], b[1] - a[1]) == pytest.approx((here.outward[0] * 0.1, here.outward[1] * 0.1), abs=1e-9)


def test_a_leaf_swings_into_one_room(flat):
    seen = {d.id: [] for d in flat.doors}
    for room in flat.rooms:
        for door in flat.shell(room.id).doors:
            seen[door.id].append(door.swing)
    assert sorted(seen["door-bath"]) == ["in-left", "out"]
    assert sorted(seen["door-kitchen"]) == ["slide", "slide"]
    assert seen["front-door"] == ["in-left"]


def test_walls_fill_what_rooms_leave_of_the_whole(flat):
    (wall,) = wall_polygons(flat, "ground")
    rooms = sum(shapely.Polygon(r.outline).area for r in flat.rooms)
    assert wall.bounds == pytest.approx((0, 0, 10.4, 7.9))
    assert wall.area + rooms == pytest.approx(10.4 * 7.9)
    assert len(wall.interiors) == len(flat.rooms)


def test_openings_lie_in_walls_and_reach_through_them(flat):
    (wall,) = wall_polygons(flat, "ground")
    for found in wall_openings(flat, "ground"):
        piece = shapely.Polygon(found.corners)
        assert piece.exterior.is_ccw
        assert wall.buffer(1e-6).contains(piece)
        assert piece.area == pytest.approx(found.opening.width * found.thickness)
        cut = shapely.difference(wall, piece.buffer(1e-6))
        assert cut.area == pytest.approx(wall.area - piece.area, abs=1e-4)


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("rooms.1.storey", "attic", "rooms[1] 'living': storey is 'attic'"),
        ("rooms.1.outline.0.0", 0.30005, "grid of 1 mm, round it to 0.3"),
        ("rooms.1.id", "hall", "is there before"),
        ("doors.1.room", "lving", "did you mean 'living'"),
        ("doors.1.to", "attic", "give another room, or null"),
        ("doors.1.to", "bath", "no wall of 'bath'"),
        ("doors.1.wall", 4, "has walls 0 to 3"),
        ("doors.1.opens_into", "bath", "give a room of the door"),
        ("doors.1.offset", 3.5, "offset + width is 4.9 m"),
        ("doors.1.width", -1, "width"),
        ("windows.0.id", "front-door", "is there before"),
        ("schema", "sceneweaver.home/9", "this version reads"),
        ("rooms", [], "rooms"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(flat, path, value, said):
    with pytest.raises(sw.InputError) as error:
        Home.from_json(changed(flat, path, value))
    assert said in str(error.value).replace('"', "'") and "\n" not in str(error.value)


def test_the_scene_of_a_room_has_the_room_of_the_home(flat):
    scene = sw.Scene(id="bath", room=flat.shell("bath"))
    home = flat.with_scene("bath", scene)
    assert Home.loads(home.dumps()) == home
    elsewhere = sw.Scene(id="bath", room=sw.Room.rectangle(1.6, 2.1))
    with pytest.raises(sw.InputError, match="the outline differs"):
        flat.with_scene("bath", elsewhere)
    other = scene.room.model_copy(update={"doors": (scene.room.doors[0].model_copy(update={"width": 0.7}),)})
    with pytest.raises(sw.InputError, match="width of door 'door-bath' is 0.7, not 0.8"):
        flat.with_scene("bath", scene.model_copy(update={"room": other}))


def test_storeys_are_joined_by_stairs_alone():
    outline = rectangle(0, 0, 1.1, 4)
    rooms = tuple(HomeRoom(id=f"stairs-{k}", type="stairs", storey=f"s{k}", outline=outline) for k in (0, 1))
    storeys = Storey(id="s0"), Storey(id="s1", elevation=3.0)
    stair = Stair(
        id="stair", lower="stairs-0", upper="stairs-1", outline=outline, up=(0, 1), width=1.0, risers=16, going=0.25
    )
    home = Home(id="house", storeys=storeys, rooms=rooms, stairs=(stair,))
    assert home.graph()["stairs-0"] == [("stairs-1", "stair")]
    with pytest.raises(sw.InputError, match="only stairs join storeys"):
        home.with_changes(doors=(HomeDoor(id="d", room="stairs-0", wall=0, offset=0, width=0.8, to="stairs-1"),))
    with pytest.raises(sw.InputError, match="at least 2.7, over the one below"):
        home.with_changes(storeys=(Storey(id="s0"), Storey(id="s1", elevation=2.0)))
    with pytest.raises(sw.InputError, match="lies on the storey over the lower one"):
        home.with_changes(stairs=(stair.model_copy(update={"lower": "stairs-1", "upper": "stairs-0"}),))


@settings(max_examples=30, deadline=None)
@given(st.integers(100, 400), st.integers(0, 2000), st.integers(600, 1500))
def test_offsets_from_either_side_add_up(thickness: int, offset: int, width: int):
    """Of two walls that face each other over the same length, the offsets and the width fill the length."""
    t, o, w = thickness / 1000, offset / 1000, width / 1000
    a = HomeRoom(id="a", storey="ground", outline=rectangle(0, 0, 4, 3))
    b = HomeRoom(id="b", storey="ground", outline=rectangle(0, round(3 + t, 3), 4, 6))
    home = Home(id="two", rooms=(a, b), doors=(HomeDoor(id="d", room="a", wall=2, offset=o, width=w, to="b"),))
    (door,) = home.shell("b").doors
    assert door.wall == 0
    assert door.offset + o + w == pytest.approx(4.0, abs=1e-6)


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"schema": "sceneweaver.scene/1"}', json.dumps({"schema": "sceneweaver.home/1"})]
)
def test_what_is_no_home_is_refused(text):
    with pytest.raises(sw.InputError) as error:
        Home.loads(text)
    assert "\n" not in str(error.value)


def test_doors_find_the_wall_that_rooms_share():
    """A hall along two rooms: each door lies in what both have of the wall."""
    home = Home.of_rooms({"hall": (0, 0, 1.2, 7), "bath": (1.3, 0, 3, 2.4), "bedroom": (1.3, 2.5, 5, 7)})
    home = home.with_door("hall", None, wall="south").with_door("bath", "hall", at=0).with_door("hall", "bedroom", at=1)
    assert [(d.room, d.wall, d.offset, d.opens_into) for d in home.doors] == [
        ("hall", 0, 0.15, "hall"),
        ("bath", 3, 0.0, "hall"),
        ("hall", 1, 6.1, "bedroom"),
    ]
    assert home.entrances == home.doors[:1]
    home = home.with_window("bedroom", "north", width=2, at=1)
    assert (home.windows[0].id, home.windows[0].wall, home.windows[0].offset) == ("window-0", 2, pytest.approx(1.7))
    for wrong, said in [
        (lambda: home.with_door("bath", "bedroom", width=2.0), "share 1.7 m of wall"),
        (lambda: home.with_door("hall", None), "needs wall"),
        (lambda: home.with_door("hall", "bath", at=2), "at is 2"),
        (lambda: home.with_window("bath", "north", width=3), "1.7 m of wall"),
        (lambda: home.with_door("hall", "kitchen"), "is no room of home"),
        (lambda: Home.of_rooms({"hall": (1, 0, 0, 7)}), "least x"),
        (lambda: Home.of_rooms({"hall": cast("Any", (1, 2))}), "four numbers"),
    ]:
        with pytest.raises(sw.InputError, match=said):
            wrong()
