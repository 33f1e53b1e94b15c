"""Other rooms for the same things: as many walls and openings, other proportions, and what plainly does not fit."""

from __future__ import annotations

import pytest
import shapely

from sceneweaver.assets import make
from sceneweaver.brief import Grounded, SceneGraph
from sceneweaver.knowledge import room_type
from sceneweaver.scene import Door, Room
from sceneweaver.tools.prior_program import Wanted
from sceneweaver.tools.prior_rooms import larger_rooms, may_hold, other_rooms
from sceneweaver.tools.prior_shell import shell

KIND = room_type("living_room")


def area(room: Room) -> float:
    return float(shapely.Polygon(room.outline).area)


@pytest.mark.parametrize("shape", [None, "L"])
def test_other_rooms_have_the_same_walls_and_openings(shape):
    brief = SceneGraph(text="", shape=shape)
    base = shell(KIND, brief, 24.0, 3)[0]
    rooms = other_rooms(KIND, brief, base, 24.0, 3, False, 6)
    assert len({room.outline for room in rooms}) == len(rooms) == 6
    assert len({(room.doors[0].offset, room.windows[0].wall) for room in rooms}) > 2
    for room in (*rooms, *larger_rooms(KIND, brief, base, 24.0, 3)):
        assert len(room.outline) == len(base.outline) and len(room.doors) == len(base.doors)
        assert [(w.id, w.width, w.sill) for w in room.windows] == [(w.id, w.width, w.sill) for w in base.windows]


def test_a_size_that_was_given_stays():
    brief = SceneGraph(text="", size=(6.0, 4.0))
    base = shell(KIND, brief, 24.0, 0)[0]
    rooms = other_rooms(KIND, brief, base, 24.0, 0, True, 5)
    assert rooms and all(room.outline == base.outline for room in rooms)


def test_larger_rooms_are_larger():
    brief = SceneGraph(text="")
    base = shell(KIND, brief, 20.0, 0)[0]
    assert all(area(room) > 1.3 * area(base) for room in larger_rooms(KIND, brief, base, 20.0, 0))


def wanted(category: str) -> Wanted:
    asset = make(category, seed=0)
    return Wanted(None, category, asset, 0, 0, id=f"{category}-0")


def room(width: float, depth: float, offset: float = 0.2) -> Room:
    door = Door(id="door-0", wall=0, offset=offset, width=0.9, height=2.0)
    return Room(outline=((0, 0), (width, 0), (width, depth), (0, depth)), doors=(door,))


def test_what_plainly_does_not_fit():
    things = [wanted("floor_lamp"), wanted("sofa"), wanted("tv")]
    lamp = [
        Grounded("r", "in_corner", "floor_lamp-0"),
        Grounded("r", "near_door", "floor_lamp-0", "door", {"max": 0.4}),
    ]
    width = max(things[0].asset.size[:2])
    assert not may_hold(room(6, 4, offset=0.2), things, lamp) or width < 0.15
    assert may_hold(room(6, 4, offset=width + 0.2), things, lamp)
    apart = [Grounded("r", "distance", "sofa-0", "floor_lamp-0", {"min": 4.0, "max": 9.0})]
    assert may_hold(room(6, 4), things, apart) and not may_hold(room(4, 4), things, apart)
    middle = [
        Grounded("r", "in_middle", "sofa-0"),
        Grounded("r", "distance", "tv-0", "sofa-0", {"min": 0.3, "max": 1.3}),
    ]
    assert may_hold(room(9, 4), things, middle) and not may_hold(room(9, 8), things, middle)
    assert not may_hold(room(6, 4), things, [Grounded("r", "at_window", "sofa-0", "window")])
