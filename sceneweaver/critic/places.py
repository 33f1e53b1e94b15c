"""The parts of a room that requests name: walls, windows, doors, corners.

A place is "wall", "window", "door", "corner", "ceiling", "floor" or "room", a wall with the name of a side as well
("wall:left"). Walls, windows and doors are seen from within the room.
"""

from __future__ import annotations

import math

from sceneweaver.geometry.angles import cross
from sceneweaver.geometry.walls import Wall
from sceneweaver.language.wall_names import walls_meant
from sceneweaver.rules.stated import number
from sceneweaver.verify.stated import Segment

from .survey import Survey


def segments(survey: Survey, place: str) -> list[Segment]:
    """The walls, windows or doors that a place names."""
    room = survey.scene.room
    if place.startswith("wall"):
        wanted = walls_meant(place.partition(":")[2], room)
        return [whole(wall, room.height) for wall in survey.placed.walls if wall.index in wanted]
    openings = {"window": survey.placed.windows, "door": survey.placed.doors}.get(place, ())
    return [Segment(o.item.id, o.wall, o.item.offset, o.item.offset + o.item.width, o.z) for o in openings]


def whole(wall: Wall, height: float = math.inf) -> Segment:
    """A wall in full."""
    return Segment(f"wall:{wall.index}", wall, 0.0, wall.length, (0.0, height))


def corners(survey: Survey, name: str = "") -> list[tuple[Wall, Wall]]:
    """The two walls of each convex corner of the room; of a round room there are none.

    A ``name`` is that of one wall of the corner, or of both: "far", "left+far".
    """
    walls = survey.placed.walls
    pairs = ((walls[w.index - 1], w) for w in walls)
    found = [(before, wall) for before, wall in pairs if cross(before.along, wall.along) > number("corner")]
    for part in name.split("+") if name else ():
        named = walls_meant(part, survey.scene.room)
        found = [pair for pair in found if any(wall.index in named for wall in pair)]
    return found
