"""Dimension chains around a plan: the clear lengths of the rooms along each side, and the whole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely

from sceneweaver.home import Home, HomeRoom

from .. import palette
from ..canvas import Point, Text, text_width
from ..shapes import Bounds, Plan
from .plan_walls import LINE

Side = Literal["south", "north", "west", "east"]

_PAIRS: tuple[tuple[Side, Side], ...] = (("south", "north"), ("west", "east"))

FIRST, SECOND = 44.0, 84.0
"""How far [units] the chain of rooms and that of the whole lie from the plan."""

_SLASH = 5.5  # half the length of the strokes at the ends of a dimension [units]
_LEAST = 1e-3


@dataclass(frozen=True)
class Chain:
    """Places [m] along a side between which there are dimensions, in order, and which of these are clear rooms."""

    side: Side
    at: tuple[float, ...]
    rooms: tuple[bool, ...]


def room_chain(home: Home, storey: str, side: Side, whole: Bounds) -> Chain:
    """The rooms that lie first behind a side of a storey: from face to face, and the walls between."""
    rooms = [room for room in home.rooms_of(storey) if not room.outdoor] or list(home.rooms_of(storey))
    # Through the wall between two rooms one looks at a third: that is no room of the side.
    spans = [(a, b) for a, b in _spans(rooms, side) if b - a > home.walls.outer + _LEAST]
    low, high = (whole.x0, whole.x1) if side in ("south", "north") else (whole.y0, whole.y1)
    at, clear = [low], []
    for a, b in spans:
        if a - at[-1] > _LEAST:
            at.append(a)
            clear.append(False)
        at.append(b)
        clear.append(True)
    if high - at[-1] > _LEAST:
        at.append(high)
        clear.append(False)
    return Chain(side, tuple(round(value, 4) for value in at), tuple(clear))


def _spans(rooms: Sequence[HomeRoom], side: Side) -> list[tuple[float, float]]:
    """The stretches along a side on which one and the same room comes first."""
    axis = 0 if side in ("south", "north") else 1
    sign = 1.0 if side in ("south", "west") else -1.0
    cuts = np.unique(np.round([point[axis] for room in rooms for point in room.outline], 4))
    floors = [shapely.Polygon(room.outline) for room in rooms]
    found: list[list[float]] = []
    before = -1
    for a, b in zip(cuts, cuts[1:], strict=False):
        middle, best, first = (a + b) / 2, -1, np.inf
        beam = shapely.LineString([(middle, -1e4), (middle, 1e4)] if axis == 0 else [(-1e4, middle), (1e4, middle)])
        for k, floor in enumerate(floors):
            hit = floor.intersection(beam)
            if hit.is_empty or hit.length < _LEAST:
                continue
            x0, y0, x1, y1 = hit.bounds
            near = (y0 if axis == 0 else x0) if sign > 0 else -(y1 if axis == 0 else x1)
            if near < first - _LEAST:
                first, best = near, k
        if best >= 0 and best == before and abs(found[-1][1] - a) < _LEAST:
            found[-1][1] = float(b)
        elif best >= 0:
            found.append([float(a), float(b)])
        before = best
    return [(a, b) for a, b in found]


def draw_dimensions(plan: Plan, home: Home, storey: str, whole: Bounds, bare: Bounds) -> None:
    """The chains of rooms on all sides (once where two sides agree), and the whole at the bottom and at the left.

    Args:
        plan: What is drawn on.
        home: The home.
        storey: Which storey of it.
        whole: What the chains lie around [m].
        bare: The building without balconies, whose length the whole is [m].
    """
    for side, other in _PAIRS:
        chain, far = room_chain(home, storey, side, bare), room_chain(home, storey, other, bare)
        _draw_chain(plan, chain, whole, FIRST)
        ends = (bare.x0, bare.x1) if side == "south" else (bare.y0, bare.y1)
        _draw_chain(plan, Chain(side, ends, (True,)), whole, SECOND)
        if far.at != chain.at:
            _draw_chain(plan, far, whole, FIRST)


def far_sides(home: Home, storey: str, bare: Bounds) -> tuple[bool, bool]:
    """Whether there is a chain on the north and on the east side."""
    north, east = (
        room_chain(home, storey, far, bare).at != room_chain(home, storey, near, bare).at for near, far in _PAIRS
    )
    return north, east


def _draw_chain(plan: Plan, chain: Chain, whole: Bounds, away: float) -> None:
    unit, level = plan.unit, chain.side in ("south", "north")
    edge = {"south": whole.y0, "north": whole.y1, "west": whole.x0, "east": whole.x1}[chain.side]
    out = 1.0 if chain.side in ("south", "east") else -1.0  # in pixels
    base = plan.point((0.0, edge))[1] if level else plan.point((edge, 0.0))[0]
    at = base + out * away * unit

    def spot(value: float, across: float) -> Point:
        return (plan.point((value, 0.0))[0], across) if level else (across, plan.point((0.0, value))[1])

    color = palette.mixed(LINE, palette.PAPER, 0.15)
    ends = [spot(value, at) for value in chain.at]
    plan.line((ends[0], ends[-1]), color, 0.9)
    slash = _SLASH * unit
    for value, (x, y) in zip(chain.at, ends, strict=True):
        plan.line((spot(value, base + out * 12 * unit), spot(value, at + out * 7 * unit)), (*LINE, 70), 0.7)
        plan.line(((x - slash, y + slash), (x + slash, y - slash)), LINE, 1.6)
    size = plan.font_size(14 if away == FIRST else 15)
    for (a, b), clear in zip(zip(chain.at, chain.at[1:], strict=False), chain.rooms, strict=True):
        text = f"{b - a:.2f}"
        if (b - a) * plan.scale < text_width(text, size) + (6 if clear else 8) * unit:
            continue
        x, y = spot((a + b) / 2, at)
        gap = 0.72 * size
        place = (x, y - gap) if level else (x - gap, y)
        tone = LINE if clear else palette.MUTED
        plan.text(Text((text,), place, size, tone, upright=not level, bold=away == SECOND))
