"""Which walls and corners of a room a request names."""

from __future__ import annotations

from collections.abc import Callable

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.recesses import beside_forward, between_forward, set_back, set_forward, sides_of
from sceneweaver.rules.stated import number
from sceneweaver.scene import Room

COMPASS = {"north": (0.0, 1.0), "south": (0.0, -1.0), "east": (1.0, 0.0), "west": (-1.0, 0.0)}


def _bays(room: Room) -> list[int]:
    """The backs of bays: of what stands back and has a window in one of its walls."""
    walls, lit = room.walls, {window.wall for window in room.windows}
    return [k for k in set_back(walls) if lit & {k, *(side.index for side in sides_of(k, walls))}]


def _niches(room: Room) -> list[int]:
    """The backs of niches, and the walls beside a chimney breast."""
    bays = _bays(room)
    return [k for k in (*set_back(room.walls), *beside_forward(room.walls)) if k not in bays]


PARTS: dict[str, Callable[[Room], list[int]]] = {
    "niche": _niches,
    "bay": _bays,
    "breast": lambda room: set_forward(room.walls),
    "beside_breast": lambda room: beside_forward(room.walls),
    "breast_opening": lambda room: between_forward(room.walls),
}
"""Parts of walls that are made by the outline, and which walls are theirs."""


def direction_of(name: str, room: Room) -> tuple[float, float] | None:
    """Unit vector out of the room through the wall of that name: a compass point, or as one sees it who comes in by
    the first door (left, right, far, opposite, back, near, front); "long-0" and "long-1" are the two long ones,
    "short-0" and "short-1" the others; None for another name."""
    x, y = room.walls[room.doors[0].wall if room.doors else 0].inward
    ahead, behind = (x, y), (-x, -y)
    seen = {"far": ahead, "opposite": ahead, "back": ahead, "near": behind, "front": behind}
    sides = [max(p[k] for p in room.outline) - min(p[k] for p in room.outline) for k in (0, 1)]
    over, along = ((0.0, 1.0), (1.0, 0.0)) if sides[0] >= sides[1] else ((1.0, 0.0), (0.0, 1.0))
    for k, sign in enumerate((1.0, -1.0)):
        seen[f"long-{k}"], seen[f"short-{k}"] = ((sign * way[0], sign * way[1]) for way in (over, along))
    return (seen | {"left": (-y, x), "right": (y, -x)} | COMPASS).get(name)


def walls_meant(name: str, room: Room) -> list[int]:
    """The walls that a name means, by their numbers: a side as seen from the door or by compass, "side" (left and
    right), "long" and "short" (the ends), "window" and "door" (walls with one), one of `PARTS`, a number; every wall
    for "".

    "left+far" are the two walls of a corner. A name that is unknown means no wall.
    """
    if "+" in name:
        return [k for part in name.split("+") for k in walls_meant(part, room)]
    walls = room.walls
    if name == "":
        return [wall.index for wall in walls]
    if name.isdigit():
        return [int(name)] if int(name) < len(walls) else []
    if name in ("window", "door"):
        there = {opening.wall for opening in (room.windows if name == "window" else room.doors)}
        return [wall.index for wall in walls if wall.index in there]
    if name in ("long", "short"):
        return _by_length(name, room)
    if name in PARTS:
        return PARTS[name](room)
    if name == "side":
        return [*walls_meant("left", room), *walls_meant("right", room)]
    way = direction_of(name, room)
    return [wall.index for wall in walls if way is not None and dot(wall.outward, way) > number("same_wall")]


def _by_length(name: str, room: Room) -> list[int]:
    """The walls along the longer side of a room, or those across it; all of a room with equal sides. Short pieces of
    wall beside a notch are neither."""
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    sides = (max(xs) - min(xs), max(ys) - min(ys))
    if max(sides) <= (1 + number("square")) * min(sides):
        wanted = (0, 1)
    else:
        wanted = (sides.index(max(sides) if name == "long" else min(sides)),)
    found = []
    for wall in room.walls:
        axis = 0 if abs(wall.along[0]) > abs(wall.along[1]) else 1
        if axis in wanted and wall.length >= number("whole_wall") * sides[axis]:
            found.append(wall.index)
    return found
