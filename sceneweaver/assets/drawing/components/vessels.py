"""Hollow things that stay open: bowls, basins, tubs, baskets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ... import shapes
from ..box import Box, Vec3
from ..drawing import Drawing, Look
from ..rooms import lofted_room


def oval(
    box: Box, z: float, power: float = 2.0, back: float | None = None, middle: float | None = None, count: int = 32
) -> np.ndarray:
    """A level ring [count, 3] that fills the plan of a box: an ellipse, or what lies between it and a rectangle.

    Args:
        box: What it fills.
        z: Its height [m].
        power: Of the superellipse: 2 is an ellipse, 6 a box with round corners.
        back: The power of its back half where that differs.
        middle: Depth at which it is widest; the middle of the box unless told, as of an egg that is blunt behind.
        count: Its points.
    """
    angle = np.arange(count) * (2 * np.pi / count)
    c, s = np.cos(angle), np.sin(angle)
    c[np.abs(c) < 1e-9] = 0.0
    p = np.where(c >= 0, power, back or power)
    x, y = box.center[0] if middle is None else middle, box.center[1]
    u, v = np.sign(c) * np.abs(c) ** (2 / p), np.sign(s) * np.abs(s) ** (2 / p)
    return np.c_[x + np.where(c >= 0, box.x[1] - x, x - box.x[0]) * u, y + box.width / 2 * v, np.full(count, z)]


def perimeter(box: Box, radius: float, shares: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points [N, 2] by shares of the way around a plan with round corners, counter-clockwise, and unit vectors out."""
    ring = shapes.rectangle(box.x, box.y, 0.0, radius, 8)[:, :2]
    ring = np.concatenate([ring, ring[:1]])
    run = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(ring, axis=0), axis=1))])
    points = np.stack([np.interp(shares * run[-1], run, ring[:, k]) for k in (0, 1)], axis=1)
    along = np.roll(points, -1, axis=0) - np.roll(points, 1, axis=0)
    return points, np.c_[along[:, 1], -along[:, 0]] / np.linalg.norm(along, axis=1, keepdims=True)


def vessel(
    d: Drawing,
    outer: Sequence[np.ndarray],
    inner: Sequence[np.ndarray],
    material: Look,
    staves: int | Sequence[int] = 16,
    split: tuple[int, int] | None = None,
    inside: str | None = "inside",
) -> None:
    """A hollow body: rings [K, 3] up outside, then down inside. Its parts are a floor and staves, so it stays open.

    Args:
        d: The drawing.
        outer: Rings from the bottom up.
        inner: Rings from the rim down to the floor inside.
        material: What it is of.
        staves: How many parts its wall has, or the points of the rings where they end.
        split: An outer and an inner ring where the staves of a bellied body are cut in two.
        inside: Name of its interior; None: it is the outer skin of another vessel.
    """
    rings = [*outer, *inner]
    n = len(rings[0])
    ends = range(0, n + 1, max(1, n // staves)) if isinstance(staves, int) else staves
    hulls = shapes.staved_hulls(outer, inner, list(ends), split)
    d.add(shapes.lofted(rings), material, hulls)
    if inside:
        room, round_plan = lofted_room(inner)
        if not d.upright:  # a drum that lies is as wide as its widest ring
            points = np.concatenate(inner)[:, :2]
            low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
            room = room.to(x=(low[0], high[0]), y=(low[1], high[1]))
        d.interior(inside, room, oval=round_plan and d.upright)


def bowl(
    d: Drawing,
    box: Box,
    outer: Sequence[Sequence[float]],
    inner: Sequence[Sequence[float]],
    material: Look,
    power: float = 2.0,
    staves: int = 16,
    split: tuple[int, int] | None = None,
    inside: str | None = "inside",
) -> None:
    """A `vessel` of `oval` rings in the middle of a box: shares of its depth and width, a height [m], a power."""
    sides = []
    for rows in (outer, inner):
        plans = [(box.place(row[0] * box.depth, row[1] * box.width), *row[2:]) for row in rows]
        sides.append([oval(plan, z, own[0] if own else power, count=2 * staves) for plan, z, *own in plans])
    vessel(d, sides[0], sides[1], material, staves, split, inside)


def bottle(d: Drawing, box: Box, material: Look) -> Box:
    """A bottle with round shoulders and a neck that fills a box."""
    return d.turned(box, [(1.0, 0.0), (1.0, 0.6), (0.85, 0.68), (0.42, 0.82), (0.42, 1.0)], material, 12)


CORNERS = (0, 3, 4, 7, 8, 11, 12, 15, 16)
"""Where the staves of a vessel of `shapes.rectangle` rings end: one for each corner and one for each side."""


def drain(d: Drawing, at: Vec3, radius: float = 0.03) -> None:
    """A drain with its strainer on a floor at a point."""
    d.cylinder(Box.sized(2 * radius, 2 * radius, 0.003, at).inset(bottom=-0.001), "chrome", segments=16)
    d.cylinder(Box.sized(1.2 * radius, 1.2 * radius, 0.0045, at), "black steel", segments=12)


def basin(d: Drawing, box: Box, material: Look, radius: float = 0.03, lip: float = 0.015, wall: float = 0.005) -> Box:
    """A basin let into a top: the box is the hole, and its rim lies 1.5 mm proud on the top around it; with a drain.

    Returns the room inside.
    """
    floor, rim = box.inset(x=0.025, y=0.025), box.inset(x=-lip, y=-lip)
    top, bottom = box.z[1], box.z[0]
    outer = [(floor, bottom, 0.05), (box, top, radius), (rim, top, 0.02), (rim, top + 0.0015, 0.02)]
    inner = [(box.inset(x=wall, y=wall), top + 0.0015, radius), (floor.inset(x=0.006, y=0.006), bottom + 0.008, 0.05)]
    out, inside = ([shapes.rectangle(b.x, b.y, z, r) for b, z, r in rings] for rings in (outer, inner))
    vessel(d, out, inside, material, CORNERS)
    x, y, _ = box.center
    drain(d, (x, y, bottom + 0.008))
    return floor.inset(x=0.006, y=0.006, bottom=0.008)


def tub(d: Drawing, box: Box, material: Look, wall: float = 0.01, lean: float = 0.0, floor: float | None = None) -> Box:
    """Four walls on a floor, narrower at its bottom by ``lean`` at each side; returns the room inside."""
    low = box.inset(x=lean, y=lean)
    floor = max(wall, 0.02 * box.height) if floor is None else floor  # what falls far falls through less
    d.box(low.bottom(floor), material, bevel=0.0)
    for side, less in (("front", 0.0), ("back", 0.0), ("left", wall), ("right", wall)):
        ends = [getattr(b.inset(x=less), side)(wall) for b in (low, box)]
        d.hull([(x, y, b.z[k]) for k, b in enumerate(ends) for x in b.x for y in b.y], material)
    room = low.inset(x=wall, y=wall, bottom=floor)
    d.interior("inside", room)
    return room


def open_box(
    d: Drawing,
    box: Box,
    material: Look,
    wall: float,
    lean: float = 0.0,
    floor: float = 0.01,
    name: str | None = "inside",
    core: float | None = None,
) -> Box:
    """Four walls on a floor, each a part; narrower at its bottom by ``lean`` at each side. Its floor is a surface.

    ``core`` is how thick a wall is drawn, in the middle of its collision part, where weave covers it [m]. Returns the
    room inside.
    """
    low = box.inset(x=lean, y=lean)
    with d.part("floor"):
        d.box(low.bottom(floor), material, bevel=0.002)
    for side in ("front", "back", "left", "right"):
        with d.part(f"wall {side}"):
            drawn = []
            for thick in (core or wall, wall):
                less = (wall - thick) / 2
                slabs = [getattr(b.inset(x=less, y=less), side)(thick) for b in (low, box)]
                ends = [[(x, y, b.z[k]) for x in b.x for y in b.y] for k, b in enumerate(slabs)]
                drawn.append(shapes.hull(np.array([*ends[0], *ends[1]])))
            d.add(drawn[0], material, drawn[1:])
    room = low.inset(x=wall + 0.004, y=wall + 0.004, bottom=floor)
    d.interior(name or "inside", room)
    if name:
        d.surface(name, room.bottom(0.0))
    return room
