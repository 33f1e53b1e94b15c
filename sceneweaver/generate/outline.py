"""Outlines of rooms: rectangles, and rooms with a corner gone, a bay or a wing, of one floor area."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass, replace

from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.shells import first_group, shells

Point = tuple[float, float]

SMALLEST, LARGEST = 1.5, 60.0
"""Sides [m] of a room that are built at least and at most; what was asked is brought in between, with a note."""

AREA_SHARE = {"L": 0.80, "T": 0.75, "U": 0.835}
"""Share of the box of a room that its floor is."""

IN_ROWS = frozenset(("rectangle", "notch"))
"""Shapes of rooms whose furniture stands in grids: anything else would break them up."""


@dataclass(frozen=True)
class Plan:
    """An outline, the walls that a door may be in, and the wall of a bay, if there is one."""

    shape: str
    corners: tuple[Point, ...]
    entries: tuple[int, ...]
    bay: int | None = None


def drawn_shape(room_type: RoomType, area: float, rng: random.Random) -> str:
    """A shape for a room of such a floor area [m2]."""
    shares, least = shells().shapes[first_group(room_type.name)], shells().least
    gridded = any(item.row == "grid" for item in room_type.items)
    names = [n for n in shares if area >= least[n] and (not gridded or n in IN_ROWS)]
    return rng.choices(names, [shares[n] for n in names])[0]


def outline(shape: str, width: float, depth: float, rng: random.Random) -> Plan:
    """A room of some shape in about ``width`` times ``depth`` [m]; counter-clockwise, its least corner at (0, 0).

    A notch, a cut corner and a bay keep the area of that box, the shapes that a request may name the box itself.
    """
    plan = _DRAWN[shape](width, depth, rng)
    return mirrored(plan) if plan.shape in ("L", "notch", "cut", "bay") and rng.random() < 0.5 else plan


def asked_outline(shape: str, width: float, depth: float, rng: random.Random) -> Plan:
    """A room of a shape and of sides [m] that a request leaves no choice about; one comes in by wall 0, at y = 0."""
    return replace(_DRAWN[shape](width, depth, rng), entries=(0,))


def winged(width: float, depth: float, wing: tuple[float, float]) -> Plan:
    """A main part of sides [m] with another one at the left end of its far side: the first of its sides lies along."""
    along, out = wing if wing[0] < width else (wing[1], wing[0])
    top = depth + out
    corners = ((0.0, 0.0), (width, 0.0), (width, depth), (along, depth), (along, top), (0.0, top))
    return Plan("L", corners, (0,))


def sides_of(shape: str, area: float, aspect: float) -> tuple[float, float]:
    """Sides [m] of the box of a room with a floor area [m2] and a proportion."""
    depth = math.sqrt(area / AREA_SHARE.get(shape, 1.0) / aspect)
    return depth * aspect, depth


def turned(plan: Plan, quarters: int) -> Plan:
    """The plan turned by quarter turns, counter-clockwise, its least corner at (0, 0) and its lowest one first."""
    points = list(plan.corners)
    for _ in range(quarters % 4):
        points = [(-y, x) for x, y in points]
    left, low = min(x for x, _ in points), min(y for _, y in points)
    points = [(x - left, y - low) for x, y in points]
    n = len(points)
    first = min(range(n), key=lambda k: (round(points[k][1], 6), points[k][0]))
    image = {k: (k - first) % n for k in range(n)}
    return Plan(
        plan.shape,
        tuple(points[first:] + points[:first]),
        tuple(sorted(image[k] for k in plan.entries)),
        None if plan.bay is None else image[plan.bay],
    )


def _rectangle(w: float, d: float, rng: random.Random) -> Plan:
    return Plan("rectangle", ((0, 0), (w, 0), (w, d), (0, d)), (0, 1, 2, 3))


def _l(w: float, d: float, rng: random.Random) -> Plan:
    x = rng.uniform(0.5, 0.62)
    x, y = x * w, (1 - (1 - AREA_SHARE["L"]) / (1 - x)) * d
    return Plan("L", ((0, 0), (w, 0), (w, y), (x, y), (x, d), (0, d)), (0, 1, 4, 5))


def _t(w: float, d: float, rng: random.Random) -> Plan:
    a, b, c = 0.25 * w, 0.75 * w, 0.5 * d
    return Plan("T", ((a, 0), (b, 0), (b, c), (w, c), (w, d), (0, d), (0, c), (a, c)), (0,))


def _u(w: float, d: float, rng: random.Random) -> Plan:
    a, b, c = 0.35 * w, 0.65 * w, 0.45 * d
    return Plan("U", ((0, 0), (w, 0), (w, d), (b, d), (b, c), (a, c), (a, d), (0, d)), (0,))


def _round(w: float, d: float, rng: random.Random) -> Plan:
    r = min(w, d) / 2
    turn = [2 * math.pi * (k + 0.5) / 12 - math.pi / 2 - 2 * math.pi / 12 for k in range(12)]
    return Plan("round", tuple((r + r * math.cos(t), r + r * math.sin(t)) for t in turn), (0,))


def _notch(w: float, d: float, rng: random.Random) -> Plan:
    """A corner that a shaft or a chimney takes; the door is not beside it."""
    x = min(rng.uniform(0.5, 1.1), 0.3 * w)
    y = min(rng.uniform(0.4, 0.9), 0.3 * d)
    d += x * y / w
    return Plan("notch", ((0, 0), (w, 0), (w, d - y), (w - x, d - y), (w - x, d), (0, d)), (0, 1, 5))


def _cut(w: float, d: float, rng: random.Random) -> Plan:
    """A corner cut off at 45 degrees."""
    c = min(rng.uniform(0.6, 1.1), 0.3 * w, 0.3 * d)
    d += c * c / 2 / w
    return Plan("cut", ((0, 0), (w, 0), (w, d - c), (w - c, d), (0, d)), (0, 1, 4))


def _bay(w: float, d: float, rng: random.Random) -> Plan:
    """A bay in the wall across, with square or slanted sides; a rectangle where the wall is too short for one."""
    wide, deep = rng.uniform(2.1, 2.7), rng.uniform(0.45, 0.65)
    slant = rng.choice((0.0, 0.3))
    wide += 2 * slant
    if w < wide + 0.9:
        return _rectangle(w, d, rng)
    start = rng.choice((0.5, 0.5, rng.uniform(0.1, 0.9))) * (w - wide - 0.4) + 0.2
    d -= (wide - slant) * deep / w
    top = ((start + wide, d), (start + wide - slant, d + deep), (start + slant, d + deep), (start, d))
    return Plan("bay", ((0, 0), (w, 0), (w, d), *top, (0, d)), (0, 1, 7), bay=4)


_DRAWN: dict[str, Callable[[float, float, random.Random], Plan]] = {
    "rectangle": _rectangle,
    "L": _l,
    "T": _t,
    "U": _u,
    "round": _round,
    "notch": _notch,
    "cut": _cut,
    "bay": _bay,
}


def mirrored(plan: Plan) -> Plan:
    """The plan as a mirror shows it; wall i becomes wall n - 2 - i, so that wall 0 stays at y = 0."""
    n, width = len(plan.corners), max(x for x, _ in plan.corners)
    corners = tuple((width - x, y) for x, y in reversed(plan.corners))
    corners = corners[-2:] + corners[:-2]
    image = {k: (n - k) % n for k in range(n)}
    entries = tuple(sorted(image[k] for k in plan.entries))
    return Plan(plan.shape, corners, entries, None if plan.bay is None else image[plan.bay])
