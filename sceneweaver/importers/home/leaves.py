"""How doors are hung: into which room and on which side, so that leaves swing freely and do not meet."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

import shapely

from sceneweaver.geometry.walls import Wall
from sceneweaver.home import Home, HomeDoor, place_in

STEPS = 16
"""Corners of a quarter of a circle."""

SWEEPS = 12
"""Times that each door is looked at again."""


@dataclass(frozen=True, eq=False)
class _Way:
    """A way to hang a door: the room it opens into, the side, what its leaves sweep, whether a wall is in their way."""

    door: HomeDoor
    swept: Any
    blocked: bool


def hang(home: Home, free: Collection[str]) -> tuple[HomeDoor, ...]:
    """The doors of a home, those of ``free`` hung so that as few leaves as possible meet walls or other leaves.

    A door keeps how it is hung where that is as good; else the other side of its opening, else the other room. The
    door of an entrance opens into the home. Doors between rooms and their order are as before.
    """
    floors = {room.id: shapely.Polygon(room.outline) for room in home.rooms}
    swinging = [d for d in home.doors if d.opens_into is not None and d.kind in ("hinged", "double")]
    ways = {d.id: _ways(home, d, floors) if d.id in free else [_way(home, d, floors)] for d in swinging}
    chosen = {d.id: ways[d.id][0] for d in swinging}
    for _ in range(SWEEPS):
        changed = False
        for door in swinging:
            rest = [w for name, w in chosen.items() if name != door.id]
            best = min(range(len(ways[door.id])), key=lambda k: (_faults(ways[door.id][k], rest), k))
            if ways[door.id][best] is not chosen[door.id]:
                chosen[door.id], changed = ways[door.id][best], True
        if not changed:
            break
    return tuple(chosen[d.id].door if d.id in chosen else d for d in home.doors)


def faults_of(home: Home) -> dict[str, int]:
    """How many walls and leaves are in the way of each door's leaves."""
    floors = {room.id: shapely.Polygon(room.outline) for room in home.rooms}
    hung = [_way(home, d, floors) for d in home.doors if d.opens_into is not None and d.kind in ("hinged", "double")]
    return {way.door.id: _faults(way, [w for w in hung if w is not way]) for way in hung}


def _faults(way: _Way, others: Sequence[_Way]) -> int:
    mine = way.door.opens_into
    met = sum(o.door.opens_into == mine and bool(o.swept.intersection(way.swept).area > 1e-5) for o in others)
    return 2 * way.blocked + met


def _ways(home: Home, door: HomeDoor, floors: dict[str, Any]) -> list[_Way]:
    rooms = [door.opens_into, *(r for r in (door.room, door.to) if r not in (door.opens_into, None))]
    if door.to is None:
        rooms = [door.room]
    sides = (door.hinge, "right" if door.hinge == "left" else "left")
    sides = sides[:1] if door.kind == "double" else sides
    return [
        _way(home, door.model_copy(update={"opens_into": room, "hinge": side}), floors)
        for room in rooms
        for side in sides
    ]


def _way(home: Home, door: HomeDoor, floors: dict[str, Any]) -> _Way:
    room = door.opens_into
    assert room is not None
    number, offset = place_in(home, door, room)
    wall = home.room(room).walls[number]
    if door.kind == "double":
        half = door.width / 2
        parts = [_quarter(wall, offset, half, 1), _quarter(wall, offset + door.width, half, -1)]
    elif door.hinge == "left":
        parts = [_quarter(wall, offset, door.width, 1)]
    else:
        parts = [_quarter(wall, offset + door.width, door.width, -1)]
    swept = shapely.union_all(parts)
    return _Way(door, swept, bool(swept.difference(floors[room].buffer(1e-4, join_style="mitre")).area > 1e-6))


def _quarter(wall: Wall, at: float, radius: float, way: int) -> Any:
    """The quarter of a circle that a leaf sweeps, from its hinge, as a polygon around it."""
    out = radius / math.cos(math.pi / (4 * STEPS))
    turns = [math.pi / 2 * (k + 0.5) / STEPS for k in range(STEPS)]
    arc = [wall.point(at + way * out * math.cos(t), out * math.sin(t)) for t in turns]
    ends = [wall.point(at + way * radius), wall.point(at, radius)]
    return shapely.Polygon([wall.point(at), ends[0], *arc, ends[1]])
