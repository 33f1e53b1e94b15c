"""Other rooms for the same things, where the request leaves the room to us: other proportions, doors, window walls."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from sceneweaver.geometry.angles import cross
from sceneweaver.knowledge import RoomType
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.language.wall_names import PARTS, walls_meant
from sceneweaver.scene import Relation, Room

from .program import Wanted
from .relations import free_corners, wall_named
from .shell import shell

TRIED = 24
"""Shells that are drawn; of those in which all may be placed the first few are laid out."""

SCALES = (1.0, 1.0, 1.06, 0.9, 1.12, 1.2, 1.06)
"""Factors on the floor of a room whose size is ours, taken in turn."""

LARGER = (1.2, 1.45, 1.75)
"""Factors on the floor where something that was asked for has no place: what fits in none of them, a hall of mostly
empty floor would not hold better either."""

BESIDE_DOOR = 0.05
"""Length [m] of wall beside a door that something between it and the corner needs beyond its own width."""

CORNER = 0.3
"""Length [m] of wall that what stands at the next wall takes at a convex corner, on average."""

SEEN = ("near", "right", "far", "left")
"""Walls by where they are as seen from the door."""

Span = tuple[float, float]


def other_rooms(
    room_type: RoomType, brief: SceneGraph, base: Room, area: float, seed: int, fixed: bool, count: int
) -> list[Room]:
    """Rooms like one, of its size where that is given, all different."""
    found: list[Room] = []
    for vary in range(1, TRIED + 1):
        scale = 1.0 if fixed else SCALES[vary % len(SCALES)]
        room = shell(room_type, brief, area * scale, seed, vary, base)[0]
        if len(room.windows) == len(base.windows) and len(room.doors) == len(base.doors) and room not in found:
            found.append(room)
        if len(found) == count:
            break
    return found


def larger_rooms(room_type: RoomType, brief: SceneGraph, base: Room, area: float, seed: int) -> list[Room]:
    """Rooms with more floor and with the openings of one."""
    rooms = (shell(room_type, brief, area * scale, seed, vary, base)[0] for vary, scale in enumerate(LARGER, 1))
    return [room for room in rooms if len(room.windows) == len(base.windows)]


def may_hold(room: Room, wanted: Sequence[Wanted], rows: Sequence[Grounded]) -> bool:
    """Whether nothing that is quick to see speaks against a room: its corners, the walls at its doors, its length."""
    size = {one.id: one.asset.size for one in wanted}
    cornered = {row.subject for row in rows if row.type == "in_corner"}
    if len(cornered) > free_corners(room):
        return False
    if any(row.type == "at_window" for row in rows) and not room.windows:
        return False
    for row in rows:
        beside = row.type == "near_door" and row.subject in cornered and float(row.params.get("max") or 0.0) < 0.6
        if beside and not _between_door_and_corner(room, max(size[row.subject][:2])):
            return False
    middle = {row.subject for row in rows if row.type == "in_middle"}
    hung = {one.id for one in wanted if one.mount == "wall"}
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    shortest, longest = sorted((max(xs) - min(xs), max(ys) - min(ys)))
    for row in rows:
        if row.type == "distance" and row.subject in size and isinstance(row.target, str) and row.target in size:
            pair = {row.subject, row.target}
            most = (
                float(row.params.get("max") or 60.0) + max(max(size[i][:2]) for i in pair & middle)
                if pair & middle
                else 0.0
            )
            if pair & middle and pair & hung and 0.5 * shortest > most:
                return False  # from the middle of the room to its walls
            least = float(row.params.get("min") or 0.0)
            if least + min(size[row.subject][:2]) + min(size[row.target][:2]) > longest:
                return False
    return True


def same_walls(room: Room, base: Room, relations: Iterable[Relation]) -> bool:
    """Whether the walls that relations name by number are the same ones in another room, as seen from the door."""
    named = {r.target for r in relations if isinstance(r.target, str) and r.target.startswith("wall:")}
    alike = all(wall_named(side, room) == wall_named(side, base) for side in SEEN)
    turned = bool(_only_long(base)) and _only_long(base).isdisjoint(_only_long(room)) and bool(_only_long(room))
    parts = all(walls_meant(part, room) == walls_meant(part, base) for part in PARTS)
    return not named or (alike and parts and not turned)


def _only_long(room: Room) -> set[int]:
    """The long walls of a room that is longer than wide."""
    return set(walls_meant("long", room)) - set(walls_meant("short", room))


def walls_hold(room: Room, wanted: Sequence[Wanted]) -> bool:
    """Whether the walls are long enough, between doors and for tall things windows too, for all that stands at them.

    What is tall goes first, then the widest, each into the shortest stretch that holds it.
    """
    sill = min((w.sill for w in room.windows), default=math.inf)
    whole, free = _stretches(room)
    for one in sorted(wanted, key=lambda w: (w.asset.size[2] <= sill, -w.wall)):
        if not one.wall:
            continue
        tall = one.asset.size[2] > sill
        fits = [k for k in (free if tall else whole) if (free if tall else whole)[k] >= one.wall]
        if not fits:
            return False
        best = min(fits, key=lambda k: (free if tall else whole)[k])
        if tall:
            free[best] -= one.wall
        whole[best[:2]] -= one.wall
    return True


def _stretches(room: Room) -> tuple[dict[tuple[int, ...], float], dict[tuple[int, ...], float]]:
    """Lengths [m] of wall between doors and corners, by wall and number, and those of their parts between windows."""
    walls, whole, free = room.walls, dict[tuple[int, ...], float](), dict[tuple[int, ...], float]()
    for wall in walls:
        before, after = walls[wall.index - 1], walls[(wall.index + 1) % len(walls)]
        low = CORNER if cross(before.along, wall.along) > 0 else 0.0
        high = wall.length - (CORNER if cross(wall.along, after.along) > 0 else 0.0)
        doors = sorted((d.offset, d.offset + d.width) for d in room.doors if d.wall == wall.index)
        panes = sorted((w.offset, w.offset + w.width) for w in room.windows if w.wall == wall.index)
        for k, (a, b) in enumerate(_between(low, high, doors)):
            whole[wall.index, k] = b - a
            free |= {(wall.index, k, j): d - c for j, (c, d) in enumerate(_between(a, b, panes))}
    return whole, free


def _between(low: float, high: float, gaps: Sequence[Span]) -> list[Span]:
    """What is left of an interval without some others, in order."""
    found: list[Span] = []
    for start, end in [*gaps, (high, high)]:
        if min(start, high) > low:
            found.append((low, min(start, high)))
        low = max(low, end)
    return found


def _between_door_and_corner(room: Room, width: float) -> bool:
    """Whether there is so much wall [m] between some door and a corner next to it, and not much more."""
    for door in room.doors:
        wall = room.walls[door.wall]
        for free in (door.offset, wall.length - door.offset - door.width):
            if width + BESIDE_DOOR <= free <= width + 0.6:
                return True
    return False
