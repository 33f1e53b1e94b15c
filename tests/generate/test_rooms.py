"""Other rooms for the same things: as many walls and openings, other proportions, and what plainly does not fit."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import shapely

from sceneweaver.assets import make
from sceneweaver.generate.program import Wanted
from sceneweaver.generate.rooms import larger_rooms, may_hold, other_rooms, same_walls, walls_hold
from sceneweaver.generate.shell import shell
from sceneweaver.knowledge import room_type
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import Door, Relation, Room, Window

KIND = room_type("living_room")


def area(room: Room) -> float:
    return float(shapely.Polygon(room.outline).area)


@pytest.mark.parametrize("shape", [None, "L"])
def test_other_rooms_have_the_same_openings(shape):
    brief = SceneGraph(text="", shape=shape)
    base = shell(KIND, brief, 24.0, 3)[0]
    rooms = other_rooms(KIND, brief, base, 24.0, 3, False, 6)
    assert len({room.outline for room in rooms}) == len(rooms) == 6
    assert len({(room.doors[0].offset, room.windows[0].wall) for room in rooms}) > 2
    for room in (*rooms, *larger_rooms(KIND, brief, base, 24.0, 3)):
        assert len(room.doors) == len(base.doors) and room.height == base.height
        assert [(w.id, w.width, w.sill) for w in room.windows] == [(w.id, w.width, w.sill) for w in base.windows]
        assert shape is None or len(room.outline) == 6


def test_a_size_that_was_given_stays():
    brief = SceneGraph(text="", size=(6.0, 4.0))
    base = shell(KIND, brief, 24.0, 0)[0]
    rooms = other_rooms(KIND, brief, base, 24.0, 0, True, 5)
    assert rooms and all(room.outline == base.outline for room in rooms)


def test_larger_rooms_are_larger():
    brief = SceneGraph(text="")
    base = shell(KIND, brief, 20.0, 0)[0]
    grown = [area(room) / area(base) for room in larger_rooms(KIND, brief, base, 20.0, 0)]
    assert grown[0] > 1.1 and grown == sorted(grown) and grown[-1] < 2.0


def test_walls_that_a_relation_names_are_the_same_in_other_rooms():
    base = room(6, 4)
    turned = base.model_copy(update={"doors": (base.doors[0].model_copy(update={"wall": 1}),)})
    far = Relation(type="against_wall", subject="sofa-0", target="wall:2")
    assert same_walls(turned, base, [Relation(type="against_wall", subject="sofa-0")])
    assert same_walls(room(5, 5), base, [far]) and not same_walls(turned, base, [far])


def test_what_stands_at_walls_needs_walls_between_doors_and_tall_things_between_windows():
    sofas = [placed(2.2, 0.8), placed(2.2, 0.8)]
    assert walls_hold(room(3, 3), sofas)
    assert not walls_hold(room(2.4, 2.4), sofas)
    window = Window(id="window-0", wall=2, offset=0.8, width=1.4, sill=0.9, height=1.2)
    lit = [window.model_copy(update={"id": f"window-{k}", "wall": k}) for k in (1, 2, 3)]
    dark = room(3, 3)
    bright = dark.model_copy(update={"windows": tuple(lit)})
    wardrobe = [placed(1.9, 2.1)]
    assert walls_hold(dark, wardrobe) and not walls_hold(bright, wardrobe)
    assert walls_hold(bright, sofas)


def placed(width: float, height: float) -> Any:
    """Something of that width and height [m] that stands against a wall."""
    return SimpleNamespace(wall=width, asset=SimpleNamespace(size=(0.6, width, height)))


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
