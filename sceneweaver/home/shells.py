"""Rooms of a home as rooms of scenes: where the doors of the other side lie in a room's own walls."""

from __future__ import annotations

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote
from sceneweaver.scene import Room
from sceneweaver.scene.room import Door, Swing, Window

from .content import HomeContent
from .limits import THICKEST
from .parts import HomeDoor

ALONG, ROUNDED = 1e-6, 6
"""How far [m] the ends of an opening may lie over those of the wall behind, and decimals of an offset."""


FACING = -1 + 2e-5
"""Cosine of walls that face each other, at most: slanted ones whose corners lie on the grid of 1 mm are not parallel to
the last digit."""


def room_shell(home: HomeContent, room_id: str) -> Room:
    """See `Home.shell`."""
    room = home.room(room_id)
    doors = []
    for door in home.doors_of(room_id):
        wall, offset = place_in(home, door, room_id)
        doors.append(
            Door(
                id=door.id,
                wall=wall,
                offset=offset,
                width=door.width,
                height=door.height,
                swing=swing_in(door, room_id),
            )
        )
    windows = [
        Window(id=w.id, wall=w.wall, offset=w.offset, width=w.width, sill=w.sill, height=w.height)
        for w in home.windows
        if w.room == room_id
    ]
    return Room(
        type=room.type,
        outline=room.outline,
        height=home.storey_of(room_id).height,
        doors=tuple(doors),
        windows=tuple(windows),
    )


def swing_in(door: HomeDoor, room_id: str) -> Swing:
    """How a door opens as seen from one of its rooms."""
    if door.kind in ("sliding", "open"):
        return "slide"
    if door.opens_into == room_id:
        return "in-left" if door.hinge == "left" else "in-right"
    return "out"


def place_in(home: HomeContent, door: HomeDoor, room_id: str) -> tuple[int, float]:
    """Number of the wall of a room that a door goes through, and the offset [m] of the opening along it.

    Raises:
        InputError: the wall of the other room does not lie behind the opening.
    """
    if room_id == door.room:
        return door.wall, door.offset
    here = home.room(door.room).walls[door.wall]
    first, last = here.point(door.offset), here.point(door.offset + door.width)
    best: tuple[float, int, float] | None = None
    for wall in home.room(room_id).walls:
        turned = wall.along[0] * here.along[0] + wall.along[1] * here.along[1]
        if turned > FACING:  # walls of two rooms that face each other run in opposite directions
            continue
        (low, near), (high, _) = wall.coordinates(last), wall.coordinates(first)
        if low < -ALONG or high > wall.length + ALONG or not -ALONG <= -near <= THICKEST:
            continue
        found = (-near, wall.index, round(max(0.0, low), ROUNDED))
        best = found if best is None else min(best, found)
    if best is None:
        raise InputError(
            f"door {quote(door.id)}: behind it lies no wall of {quote(room_id)} within {THICKEST:g} m over its whole "
            f"width; move the door along wall {door.wall} of {quote(door.room)}"
        )
    return best[1], best[2]
