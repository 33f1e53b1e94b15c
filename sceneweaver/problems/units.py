"""Units of furniture that fill a cell: a box, an L with what stands in its notch, a round table, seats at a table.

Every unit gets a `Spot`: a cell, the direction it faces and how much of either side of the cell it may take.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .cells import Box, Cell, NoFit, split

Json = dict[str, Any]

SEAT = (0.45, 0.45, 0.46, 0.85)  # depth, width, height of the seat and of the back [m]
TUCKED = 0.12  # [m] that a seat stands under its table
TABLE = (0.74, 0.04)  # height of a table and thickness of its top [m]
LEG = 0.06
GAP = 0.02  # [m] behind what stands at a wall
ZONE_HEIGHT = 1.8
BOARD = 0.03


@dataclass
class Draft:
    """A scene while it is made: objects and relations as JSON, and poses (x, y, z, yaw)."""

    rng: np.random.Generator
    side: float
    """Share of either side of a cell that may be taken."""
    thing_side: float
    """The same for things on a surface."""
    sill: tuple[Box, float] | None = None
    """A floor area where nothing is taller than some height."""
    objects: list[Json] = field(default_factory=list)
    relations: list[Json] = field(default_factory=list)
    poses: list[tuple[float, float, float, float]] = field(default_factory=list)
    at_wall: list[str] = field(default_factory=list)
    """Ids of what stands with its back to a wall."""

    def relate(self, kind: str, subject: str, target: str | None = None, **params: Any) -> None:
        """Add a hard relation."""
        relation = {"type": kind, "subject": subject, "target": target, "params": params, "hard": True}
        self.relations.append(relation)

    def span(self, length: float, share: float | None = None) -> float:
        """The part of a cell's side that is taken, with room for air at both ends."""
        taken = round((share or self.side) * length, 3)
        if taken > length - 0.012 or taken < 0.03:
            raise NoFit("no room for air around a unit")
        return taken

    def back(self, wall: bool, slack: float) -> float:
        """Distance of the back from the cell's edge: close to it at a wall, anywhere else."""
        return min(GAP, slack / 2) if wall else float(self.rng.uniform(0.35, 0.65)) * slack


class Spot:
    """A cell that a unit fills, as seen along the direction that the unit faces: u from the back, v from the right.

    ``whole`` are depth and width of the cell, ``depth`` and ``width`` what of them may be taken [m]; ``wall`` says
    whether the unit stands with its back to a wall.
    """

    def __init__(self, draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
        self.draft, self.rng, self.cell, self.facing, self.wall = draft, draft.rng, cell, facing, wall
        self.whole = cell.local(facing)
        self.depth, self.width = (draft.span(side) for side in self.whole)

    def corner(self, wall: bool = False) -> tuple[float, float]:
        """Where what is taken begins (u, v), ``wall``: close to the wall."""
        (a, b), draft = self.whole, self.draft
        return draft.back(wall, a - self.depth), draft.back(False, b - self.width)

    def middle(self) -> tuple[float, float]:
        """The middle (u, v) of what is taken."""
        u, v = self.corner(self.wall)
        return u + self.depth / 2, v + self.width / 2

    def height(self, low: float, high: float) -> float:
        """A height [m] for what stands here, below a window's sill where there is one."""
        height = float(self.rng.uniform(low, high))
        if self.draft.sill is not None:
            (x0, y0, x1, y1), most = self.draft.sill
            box = self.cell.box
            if box[0] < x1 and x0 < box[2] and box[1] < y1 and y0 < box[3]:
                height = min(height, most - 0.05)
        return height

    def add(
        self, kind: str, at: tuple[float, float], size: Any, turn: int = 0, *, back: bool = False, **more: Any
    ) -> str:
        """Put an object with its middle at (u, v), turned by quarters from where the unit faces.

        ``back``: it is what stands at the wall, where there is one.
        """
        x, y = self.cell.world(self.facing, *at)
        object_id = f"{kind}-{len(self.draft.objects)}"
        size = [round(float(s), 3) for s in size]
        self.draft.objects.append({"id": object_id, "category": kind, "size": size, **more})
        yaw = math.remainder((self.facing + turn) * math.pi / 2, 2 * math.pi)
        self.draft.poses.append((round(x, 4), round(y, 4), 0.0, yaw))
        if back and self.wall:
            self.draft.at_wall.append(object_id)
        return object_id

    def add_seat(self, at: tuple[float, float], turn: int) -> str:
        """Put a seat somewhere."""
        return self.add("chair", at, (SEAT[0], SEAT[1], SEAT[3]), turn, parts=seat_parts())


Fill = Callable[[Spot], None]
"""Puts a unit on a spot."""


def rectangle(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    """Corners, rounded to 0.1 mm."""
    return [[round(float(x), 4), round(float(y), 4)] for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]


def centred(x: float, y: float, depth: float, width: float) -> list[list[float]]:
    """The corners of a rectangle around a point."""
    return rectangle(x - depth / 2, y - width / 2, x + depth / 2, y + width / 2)


def box(spot: Spot) -> None:
    """One box."""
    size = (spot.depth, spot.width, spot.height(0.4, 2.0))
    spot.add("crate", spot.middle(), size, back=True)


def cabinet(spot: Spot) -> None:
    """A box with a hard zone before it, both within the cell."""
    whole, width = spot.depth, spot.width
    depth = round(whole * float(spot.rng.uniform(0.5, 0.65)), 3)
    u, v = spot.corner(spot.wall)
    zone = {"name": "front", "polygon": rectangle(depth / 2, -width / 2, whole - depth / 2, width / 2)}
    zones = [{**zone, "z": [0, ZONE_HEIGHT], "hard": True}]
    size = (depth, width, spot.height(0.7, 2.0))
    spot.add("cabinet", (u + depth / 2, v + width / 2), size, back=True, zones=zones)


def corner_piece(spot: Spot) -> None:
    """An L of two prisms, and a box in its notch."""
    depth, width = spot.depth, spot.width
    u0, v0 = spot.corner(spot.wall)
    back, side = (round(s * float(spot.rng.uniform(0.4, 0.55)), 3) for s in (depth, width))
    left = spot.rng.random() < 0.5
    arm = (width / 2 - side, width / 2) if left else (-width / 2, side - width / 2)
    height = spot.height(0.6, 0.9)
    plans = (-depth / 2, -width / 2, back - depth / 2, width / 2), (back - depth / 2, arm[0], depth / 2, arm[1])
    parts = [{"polygon": rectangle(*plan), "z": [0, round(height, 3)]} for plan in plans]
    at = (u0 + depth / 2, v0 + width / 2)
    spot.add("corner-sofa", at, (depth, width, height), back=True, parts=parts)
    air = 0.012
    size = (depth - back - 2 * air, width - side - 2 * air, spot.height(0.3, 0.5))
    if min(size) < 0.1:
        raise NoFit("the notch is too small")
    v = v0 + (width - side) / 2 if left else v0 + side + (width - side) / 2
    spot.add("side-table", (u0 + back + (depth - back) / 2, v), size)


def octagon(spot: Spot) -> None:
    """A prism with eight corners."""
    a, b = spot.whole
    size = min(spot.depth, spot.width)
    k = size / 2 * math.tan(math.pi / 8)
    r = size / 2
    ring = [(r, -k), (r, k), (k, r), (-k, r), (-r, k), (-r, -k), (-k, -r), (k, -r)]
    height = round(spot.height(0.4, 0.75), 3)
    parts = [{"polygon": [[round(x, 4), round(y, 4)] for x, y in ring], "z": [0, height]}]
    at = (float(spot.rng.uniform(0.45, 0.55)) * (a - size) + size / 2, (b - size) / 2 + size / 2)
    spot.add("round-table", at, (size, size, height), parts=parts)


def table_parts(depth: float, width: float) -> list[Json]:
    """A top on four legs."""
    height, top = TABLE
    legs = (LEG - depth) / 2, (depth - LEG) / 2, (LEG - width) / 2, (width - LEG) / 2
    parts: list[Json] = [{"polygon": centred(0.0, 0.0, depth, width), "z": [height - top, height]}]
    parts += [{"polygon": centred(x, y, LEG, LEG), "z": [0, height - top]} for x in legs[:2] for y in legs[2:]]
    return parts


def seat_parts() -> list[Json]:
    """A seat with a back."""
    depth, width, seat, top = SEAT
    return [
        {"polygon": rectangle(-depth / 2, -width / 2, depth / 2, width / 2), "z": [0, seat]},
        {"polygon": rectangle(-depth / 2, -width / 2, 0.05 - depth / 2, width / 2), "z": [seat, top]},
    ]


def _add_table(spot: Spot, kind: str, at: tuple[float, float], depth: float, turn: int = 0, back: bool = False) -> str:
    """A table as wide as the spot allows."""
    size = (depth, spot.width, TABLE[0])
    return spot.add(kind, at, size, turn, back=back, parts=table_parts(depth, spot.width))


def _add_row(spot: Spot, table: str, u: float, v0: float, count: int, turn: int) -> None:
    """Seats in a row along a table; ``u`` is where their middles are."""
    if spot.width / count < SEAT[1] + 0.04 + 2 * LEG / count:
        raise NoFit("the seats do not fit beside each other")
    for k in range(count):
        seat = spot.add_seat((u, v0 + LEG + (spot.width - 2 * LEG) * (k + 0.5) / count), turn)
        spot.draft.relate("front_against", seat, table)


def table(spot: Spot, seats: int) -> None:
    """A table with seats on its two long sides, all within the cell."""
    whole, width = spot.depth, spot.width
    out = SEAT[0] - TUCKED
    depth = round(whole - 2 * out, 3)
    if depth < 2 * TUCKED + 0.3:
        raise NoFit("no room for a table between its seats")
    u0, v0 = spot.corner()
    name = _add_table(spot, "table", (u0 + whole / 2, v0 + width / 2), depth)
    _add_row(spot, name, u0 + SEAT[0] / 2, v0, seats // 2, 0)
    _add_row(spot, name, u0 + whole - SEAT[0] / 2, v0, seats - seats // 2, 2)


def desk(spot: Spot) -> None:
    """A desk with a seat before it."""
    whole, width = spot.depth, spot.width
    depth = round(whole - SEAT[0] + TUCKED, 3)
    if depth < 0.4 or width < SEAT[1] + 2 * LEG + 0.04:
        raise NoFit("no room for a desk and its seat")
    u0, v0 = spot.corner(spot.wall)
    name = _add_table(spot, "desk", (u0 + depth / 2, v0 + width / 2), depth, back=True)
    seat = spot.add_seat((u0 + whole - SEAT[0] / 2, v0 + width / 2), 2)
    spot.draft.relate("front_to_front", seat, name)


def twin_desks(spot: Spot) -> None:
    """Two desks back to back, each with its seat."""
    whole, width, v = spot.depth, spot.width, spot.whole[1] / 2
    depth = round((whole - 2 * (SEAT[0] - TUCKED) - 0.012) / 2, 3)
    if depth < 0.4 or width < SEAT[1] + 2 * LEG + 0.04:
        raise NoFit("no room for two desks and their seats")
    u0 = spot.draft.back(False, spot.whole[0] - whole)
    names = []
    for turn in (0, 2):
        desk_at, seat_at = (
            (u0 + (whole - u if turn == 0 else u), v) for u in (SEAT[0] - TUCKED + depth / 2, SEAT[0] / 2)
        )
        names.append(_add_table(spot, "desk", desk_at, depth, turn))
        spot.draft.relate("front_to_front", spot.add_seat(seat_at, turn + 2), names[-1])
    spot.draft.relate("back_to_back", names[1], names[0])


def laden(spot: Spot, boards: int, things: int) -> None:
    """A table (one board) or a shelf of several boards, with so many things on all of them."""
    depth, width = spot.depth, spot.width
    if min(depth, width) < 0.3:
        raise NoFit("the supporter is too small")
    at = spot.middle()
    if boards == 1:
        parts, height, kind = table_parts(depth, width), TABLE[0], "table"
        tops, room = [TABLE[0]], None
    else:
        room, kind = 0.4, "shelf"
        tops = [round(0.3 + k * (room + BOARD), 3) for k in range(boards)]
        height = round(tops[-1] + room + BOARD, 3)
        inner = width / 2 - BOARD
        slab = rectangle(-depth / 2, -inner, depth / 2, inner)
        parts = [{"polygon": slab, "z": [round(z - BOARD, 3), z]} for z in (*tops, height)]
        sides = [rectangle(-depth / 2, y, depth / 2, y + BOARD) for y in (-width / 2, inner)]
        parts += [{"polygon": side, "z": [0, height]} for side in sides]
    inset = 0.04
    polygon = rectangle(inset - depth / 2, inset - width / 2, depth / 2 - inset, width / 2 - inset)
    surfaces = [{"name": f"board-{k}", "polygon": polygon, "z": z, "headroom": room} for k, z in enumerate(tops)]
    name = spot.add(kind, at, (depth, width, height), back=True, parts=parts, surfaces=surfaces)
    for k, z in enumerate(tops):
        count = things // boards + (k < things % boards)
        if count:
            support = {"object": name, "surface": f"board-{k}"}
            _add_things(spot, at, support, z, (depth - 2 * inset, width - 2 * inset), count)


def _add_things(spot: Spot, at: tuple[float, float], support: Json, z: float, size: Any, count: int) -> None:
    """Boxes side by side on a surface at height ``z`` [m], whose middle is at (u, v)."""
    draft, rng, (depth, width) = spot.draft, spot.rng, size
    for x0, y0, x1, y1 in split((0.0, 0.0, depth, width), list(rng.uniform(0.7, 1.3, count)), rng):
        dx, dy = (draft.span(side, draft.thing_side) for side in (x1 - x0, y1 - y0))
        u = x0 + draft.back(False, x1 - x0 - dx) + dx / 2 - depth / 2
        v = y0 + draft.back(False, y1 - y0 - dy) + dy / 2 - width / 2
        turn = int(rng.integers(4))
        plan = (dx, dy) if turn % 2 == 0 else (dy, dx)
        high = float(rng.uniform(0.06, 0.3))
        spot.add("thing", (at[0] + u, at[1] + v), (*plan, high), turn, mount="surface", support=support)
        x, y, _, yaw = draft.poses[-1]
        draft.poses[-1] = (x, y, z, yaw)


@dataclass(frozen=True)
class Unit:
    """What a family puts into cells: how many objects it has, its floor in proportion to others', what fills it."""

    objects: int
    area: float
    fill: Fill
