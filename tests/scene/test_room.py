"""Rooms by constructors: outlines, walls by name, doors and windows along them."""

from __future__ import annotations

import pytest

from sceneweaver.scene import InputError, Room


def test_a_rectangle():
    room = Room.rectangle(4, 5, height=2.6, kind="bedroom")
    assert room.outline == ((0, 0), (4, 0), (4, 5), (0, 5)) and room.height == 2.6 and room.type == "bedroom"
    assert [room.wall(name) for name in ("south", "east", "north", "west", 2, "wall:3")] == [0, 1, 2, 3, 2, 3]


@pytest.mark.parametrize("corner", ["south-west", "south-east", "north-east", "north-west"])
def test_an_l_lacks_its_corner(corner):
    import shapely

    room = Room.l_shape(5, 4, cut=(2, 1), corner=corner)
    floor = shapely.Polygon(room.outline)
    x, y = (0.1 if "west" in corner else 4.9), (0.1 if "south" in corner else 3.9)
    assert floor.area == pytest.approx(18) and len(room.outline) == 6 and floor.bounds == (0, 0, 5, 4)
    assert not floor.covers(shapely.Point(x, y))
    for name in ("south", "east", "north", "west"):
        wall = room.walls[room.wall(name)]
        same = [w.length for w in room.walls if w.outward == wall.outward]
        assert wall.length == max(same) and len(same) <= 2


def test_openings_stand_along_their_wall():
    room = Room.rectangle(4, 5)
    first, middle, last = (room.with_door("north", at=at).doors[0] for at in (0, 0.5, 1))
    assert [d.offset for d in (first, middle, last)] == pytest.approx([0, 1.55, 3.1])
    both = room.with_door("south").with_door("east", width=0.8, swing="out").with_window(3, sill=0.5, name="view")
    assert [d.id for d in both.doors] == ["door-0", "door-1"] and both.doors[1].swing == "out"
    assert both.windows[0].id == "view" and both.windows[0].sill == 0.5 and room.doors == ()


WRONG = [
    (lambda: Room.rectangle(4, 0), "room: outline"),
    (lambda: Room.rectangle("4", 5, height=-1), "room: height is -1"),
    (lambda: Room.polygon("abc"), "outline is"),
    (lambda: Room.polygon([(0, 0), (0, 1), (1, 1)]), "runs clockwise"),
    (lambda: Room.l_shape(4, 5, cut=(4, 1)), "cut is"),
    (lambda: Room.l_shape(4, 5, cut=1), "cut is 1; give width and depth of what is missing"),
    (lambda: Room.l_shape("4", 5, cut=(1, 1)), "give metres"),
    (lambda: Room.l_shape(4, 5, cut=(1, 1), corner="north"), "corner is"),
    (lambda: Room.rectangle(4, 5).with_door("up"), 'there is no wall "up"'),
    (lambda: Room.rectangle(4, 5).with_door("wall:4"), "there is no wall"),
    (lambda: Room.rectangle(4, 5).with_door(True), "there is no wall"),
    (lambda: Room.rectangle(4, 5).with_window(0, at=-0.1), "window: at is -0.1"),
    (lambda: Room.rectangle(4, 5).with_window(0, width=4.5), "window: width is 4.5 m, but wall 0 is 4 m long"),
    (lambda: Room.rectangle(4, 5).with_window(0, height=3.0), "sill + height"),
    (lambda: Room.polygon([(0, 0), (2, 0), (1, 2)]).wall("north"), "there is no wall"),
]


@pytest.mark.parametrize("call, text", WRONG, ids=[text for _, text in WRONG])
def test_errors_are_one_line(call, text):
    with pytest.raises(InputError) as error:
        call()
    assert text in str(error.value) and "\n" not in str(error.value)
