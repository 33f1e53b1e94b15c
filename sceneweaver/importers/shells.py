"""What in a simulator's scene is the room and what stands in it: told by names, and by the boxes of walls."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from .model import SourceOpening
from .plans import along

Outline = tuple[tuple[float, float], ...]
Part = tuple[np.ndarray, np.ndarray]
"""Centre and half extents [3] of a box in the frame of its wall."""

Shell = Literal["floor", "wall", "ceiling", "door", "window", "room"]

_WORDS: dict[str, Shell] = {
    **dict.fromkeys(("floor", "floors", "ground", "groundplane", "floorplan"), "floor"),
    **dict.fromkeys(("wall", "walls"), "wall"),
    **dict.fromkeys(("ceiling", "ceilings", "roof"), "ceiling"),
    **dict.fromkeys(("door", "doors", "doorway"), "door"),
    **dict.fromkeys(("window", "windows"), "window"),
    **dict.fromkeys(("room", "arch", "architecture", "structure"), "room"),
}
_FILL = {
    "exterior",
    "interior",
    "outer",
    "inner",
    "backing",
    "left",
    "right",
    "front",
    "back",
    "north",
    "south",
    "east",
}
_FILL |= {"west", "main", "visual", "collision", "plane", "geom", "geo", "mesh", "part", "stage", "root"}
_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])|[^A-Za-z]+")


def shell_of(name: str) -> Shell | None:
    """What part of a room a name says that something is: "Wall_3", "room:wall:0", "floor_backing"; None: no part.

    Every word of it has to be one of a room or say only which: a floor_lamp and a door_mat are furniture.
    """
    words = [w for w in _CAMEL.sub(" ", name).lower().split() if len(w) > 1]
    kinds: list[Shell] = [_WORDS[w] for w in words if w in _WORDS]
    if not kinds or any(w not in _WORDS and w not in _FILL for w in words):
        return None
    named: list[Shell] = [kind for kind in kinds if kind != "room"]
    return named[0] if named else "room"


class WallShell(NamedTuple):
    """A room from its walls."""

    outline: Outline
    height: float
    openings: tuple[SourceOpening, ...]


def shell_of_walls(walls: Sequence[tuple[np.ndarray, Sequence[Part]]]) -> WallShell | None:
    """The room that we write as wall frames with boxes, one after the other.

    A wall's matrix [4, 4] puts its first corner at the origin, x along it and y into the room. Boxes fill it but for
    doors; the boxes of windows are thin.
    """
    if len(walls) < 3:
        return None
    corners = [matrix[:3, 3] for matrix, _ in walls]
    outline = tuple((float(x), float(y)) for x, y, _ in corners)
    tops = [float(centre[2] + half[2]) for _, parts in walls for centre, half in parts]
    openings: list[SourceOpening] = []
    for k, (_, parts) in enumerate(walls):
        a, b = corners[k], corners[(k + 1) % len(walls)]
        for kind, low, high, bottom, top in _holes(parts):
            start, end = along(a.tolist(), b.tolist(), low, high)
            openings.append(SourceOpening(f"{kind}_{len(openings)}", kind, start, end, bottom, top - bottom))
    return WallShell(outline, max(tops, default=0.0) or 2.7, tuple(openings))


def _holes(parts: Sequence[Part]) -> list[tuple[Literal["door", "window"], float, float, float, float]]:
    """Kind, extent along the wall, bottom and top [m] of each hole in a wall of boxes."""
    spans = [tuple(float(v) for v in (c[0] - h[0], c[0] + h[0], c[2] - h[2], c[2] + h[2], h[1])) for c, h in parts]
    found: list[tuple[Literal["door", "window"], float, float, float, float]] = []
    for low, high, bottom, top, half in spans:
        if half < 0.01:
            found.append(("window", low, high, bottom, top))
        elif bottom > 0.01 and not any(
            o[0] < high - 1e-6 and o[1] > low + 1e-6 and o[3] <= bottom + 1e-6 for o in spans
        ):
            found.append(("door", low, high, 0.0, bottom))
    return found


def opening_of(name: str, kind: Shell, points: np.ndarray) -> SourceOpening:
    """The opening that something named door or window fills, from points [n, 3] of it in the room."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    _, _, axes = np.linalg.svd(flat, full_matrices=False)
    steps = flat @ axes[0]
    middle = points[:, :2].mean(axis=0) + axes[0] * (steps.max() + steps.min()) / 2
    half = axes[0] * (steps.max() - steps.min()) / 2
    bottom, top = float(points[:, 2].min()), float(points[:, 2].max())
    (x0, y0), (x1, y1) = middle - half, middle + half
    low = 0.0 if kind == "door" else bottom
    what = "door" if kind == "door" else "window"
    return SourceOpening(name, what, (float(x0), float(y0)), (float(x1), float(y1)), low, top - low)


def rectangle_around(points: np.ndarray) -> Outline:
    """The rectangle along the axes around points [n, 2 or more], counter-clockwise."""
    (x0, y0), (x1, y1) = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    return (float(x0), float(y0)), (float(x1), float(y0)), (float(x1), float(y1)), (float(x0), float(y1))


def inner_rectangle(walls: Sequence[np.ndarray]) -> Outline | None:
    """The floor between walls along the axes, each given by points [n, 3] of it; None where it is not told.

    An outer face would make the room larger: of walls that are long in y the inner faces bound it in x, and so on.
    """
    points = np.concatenate(walls)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    bounds: dict[tuple[int, bool], float] = {}
    for wall in walls:
        low, high = wall.min(axis=0), wall.max(axis=0)
        across = int((high - low)[:2].argmin())
        after = bool((low + high)[across] / 2 > middle[across])
        face = float(low[across] if after else high[across])
        known = bounds.get((across, after), face)
        bounds[across, after] = max(known, face) if after else min(known, face)
    if len(bounds) < 4:
        return None
    x0, x1, y0, y1 = bounds[0, False], bounds[0, True], bounds[1, False], bounds[1, True]
    return ((x0, y0), (x1, y0), (x1, y1), (x0, y1)) if x0 < x1 and y0 < y1 else None


def box_along(points: np.ndarray, turn: np.ndarray) -> tuple[np.ndarray, tuple[float, float, float]]:
    """Centre [3] and size of the box of points [n, 3] along the columns of a rotation [3, 3]."""
    local = points @ turn
    low, high = local.min(axis=0), local.max(axis=0)
    d, w, h = (float(v) for v in high - low)
    return turn @ ((low + high) / 2), (d, w, h)


def upright(turn: np.ndarray, front: np.ndarray) -> np.ndarray:
    """The rotation [3, 3] of an object whose own frame is turned so: what of its axes points upwards becomes +z.

    ``front`` is the axis of its frame along which it faces; where that one points up or down, the next one does.
    Frames that lean stay as they are, with their own +z as up.
    """
    tilt = turn[2]
    k = int(np.abs(tilt).argmax())
    up = np.zeros(3)
    up[k] = np.sign(tilt[k])
    if abs(tilt[k]) < 0.99:
        up = np.array((0.0, 0.0, 1.0))
    if abs(front @ up) > 0.5:
        front = np.roll(front, 1)
    axes = np.stack((front, np.cross(up, front), up), axis=1)
    return turn @ axes
