"""What a room looks like to who comes in: signatures by which rooms are told apart, whichever way they are turned."""

from __future__ import annotations

from typing import NamedTuple

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room, Scene

SIDE, RISE = 0.5, 0.1
"""Lengths and heights [m] that are told apart."""

AT_WALL = 0.35
"""Distance [m] of a back from its wall up to which a piece stands at it."""

LEAST = 0.2
"""Floor [m2] from which on a piece counts for the layout."""


class Shell(NamedTuple):
    """The shape of a room as seen from its door."""

    corners: int
    sides: tuple[float, float]
    area: float
    height: float
    door: str
    windows: tuple[str, ...]


def shell_signature(room: Room) -> Shell:
    """Corners, sides, height, and the places of door and windows."""
    ahead, beside = _axes(room)
    across = [dot(p, beside) for p in room.outline]
    along = [dot(p, ahead) for p in room.outline]
    sides = (_to(max(across) - min(across), SIDE), _to(max(along) - min(along), SIDE))
    door = room.doors[0] if room.doors else None
    placed = "none" if door is None else _third(door.offset + door.width / 2, room.walls[door.wall])
    windows = sorted(
        f"{side_of(room, room.walls[w.wall])} {_third(w.offset + w.width / 2, room.walls[w.wall])}"
        f" {'low' if w.sill < 0.6 else 'high' if w.sill > 1.1 else 'usual'}"
        for w in room.windows
    )
    area = round(signed_area(room.outline), 1)
    return Shell(len(room.outline), sides, area, _to(room.height, RISE), placed, tuple(windows))


def openings(room: Room) -> str:
    """Where door and windows are, in words: the door on its wall, the windows by their walls."""
    signature = shell_signature(room)
    return f"{signature.door}; {', '.join(signature.windows) or 'none'}"


def layout_signature(scene: Scene) -> str:
    """For each larger piece on the floor the wall at its back and the third of it, or where it stands free."""
    found = []
    for obj in scene.objects:
        if obj.mount != "floor" or obj.size[0] * obj.size[1] < LEAST:
            continue
        frame = obj.pose.frame
        back = frame.world(-obj.size[0] / 2, 0.0)
        walls = [w for w in scene.room.walls if dot(frame.axis, w.inward) > 0.9]
        near = [w for w in walls if abs(w.coordinates(back)[1]) < AT_WALL and 0 < w.coordinates(back)[0] < w.length]
        if near:
            where = f"{side_of(scene.room, near[0])} {_third(near[0].coordinates(back)[0], near[0])}"
        else:
            ahead, beside = _axes(scene.room)
            where = f"free {_to(dot((frame.x, frame.y), beside), 1.0):g} {_to(dot((frame.x, frame.y), ahead), 1.0):g}"
        found.append(f"{obj.category} {where}")
    return "; ".join(sorted(found))


def side_of(room: Room, wall: Wall) -> str:
    """Which way a wall is as seen by who comes in: left, right, far or near."""
    ahead, beside = _axes(room)
    sides = {"far": dot(wall.outward, ahead), "near": -dot(wall.outward, ahead)}
    sides |= {"right": dot(wall.outward, beside), "left": -dot(wall.outward, beside)}
    return max(sides, key=lambda name: round(sides[name], 3))


def _axes(room: Room) -> tuple[tuple[float, float], tuple[float, float]]:
    """Unit vectors ahead and to the right of who comes in."""
    x, y = room.walls[room.doors[0].wall].inward if room.doors else (0.0, 1.0)
    return (x, y), (y, -x)


def _third(offset: float, wall: Wall) -> str:
    """The third of a wall, as who looks at it from inside sees it: its first corner is at the right."""
    return ("right", "middle", "left")[min(2, max(0, int(3 * offset / wall.length)))]


def _to(value: float, step: float) -> float:
    return round(round(value / step) * step, 2)
