"""Units of furniture that fill a cell: a box, an L with what stands in its notch, a round table, seats at a table.

Every unit gets a cell, the direction it faces and the share of either side of the cell that it may take.
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

    def add(
        self, cell: Cell, facing: int, kind: str, at: tuple[float, float], turn: int, size: Any, **more: Any
    ) -> str:
        """Put an object with its middle at ``at`` of a cell, turned by quarters from where the cell faces."""
        x, y = cell.world(facing, *at)
        object_id = f"{kind}-{len(self.objects)}"
        size = [round(float(s), 3) for s in size]
        self.objects.append({"id": object_id, "category": kind, "size": size, **more})
        yaw = math.remainder((facing + turn) * math.pi / 2, 2 * math.pi)
        self.poses.append((round(x, 4), round(y, 4), 0.0, yaw))
        return object_id

    def relate(self, kind: str, subject: str, target: str | None = None, **params: Any) -> None:
        """Add a hard relation."""
        relation = {"type": kind, "subject": subject, "target": target, "params": params, "hard": True}
        self.relations.append(relation)

    def height(self, cell: Cell, low: float, high: float) -> float:
        """A height [m] for what stands in a cell, below a window's sill where there is one."""
        height = float(self.rng.uniform(low, high))
        if self.sill is not None:
            (x0, y0, x1, y1), most = self.sill
            if cell.box[0] < x1 and x0 < cell.box[2] and cell.box[1] < y1 and y0 < cell.box[3]:
                height = min(height, most - 0.05)
        return height

    def span(self, length: float, share: float | None = None) -> float:
        """The part of a cell's side that is taken, with room for air at both ends."""
        taken = round((share or self.side) * length, 3)
        if taken > length - 0.012 or taken < 0.03:
            raise NoFit("no room for air around a unit")
        return taken

    def back(self, wall: bool, slack: float) -> float:
        """Distance of the back from the cell's edge: close to it at a wall, anywhere else."""
        return min(GAP, slack / 2) if wall else float(self.rng.uniform(0.35, 0.65)) * slack


def rectangle(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    """Corners, rounded to 0.1 mm."""
    return [[round(float(x), 4), round(float(y), 4)] for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]


def centred(x: float, y: float, depth: float, width: float) -> list[list[float]]:
    """The corners of a rectangle around a point."""
    return rectangle(x - depth / 2, y - width / 2, x + depth / 2, y + width / 2)


def _middle(draft: Draft, cell: Cell, facing: int, depth: float, width: float, wall: bool) -> tuple[float, float]:
    a, b = cell.local(facing)
    return draft.back(wall, a - depth) + depth / 2, draft.back(False, b - width) + width / 2


def box(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """One box."""
    a, b = cell.local(facing)
    depth, width = draft.span(a), draft.span(b)
    size = (depth, width, draft.height(cell, 0.4, 2.0))
    name = draft.add(cell, facing, "crate", _middle(draft, cell, facing, depth, width, wall), 0, size)
    draft.at_wall += [name] if wall else []


def cabinet(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """A box with a hard zone before it, both within the cell."""
    a, b = cell.local(facing)
    whole, width = draft.span(a), draft.span(b)
    depth = round(whole * float(draft.rng.uniform(0.5, 0.65)), 3)
    u = draft.back(wall, a - whole)
    v = draft.back(False, b - width)
    zone = {"name": "front", "polygon": rectangle(depth / 2, -width / 2, whole - depth / 2, width / 2)}
    zones = [{**zone, "z": [0, ZONE_HEIGHT], "hard": True}]
    size = (depth, width, draft.height(cell, 0.7, 2.0))
    name = draft.add(cell, facing, "cabinet", (u + depth / 2, v + width / 2), 0, size, zones=zones)
    draft.at_wall += [name] if wall else []


def corner_piece(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """An L of two prisms, and a box in its notch."""
    a, b = cell.local(facing)
    depth, width = draft.span(a), draft.span(b)
    u0, v0 = draft.back(wall, a - depth), draft.back(False, b - width)
    back, side = (round(s * float(draft.rng.uniform(0.4, 0.55)), 3) for s in (depth, width))
    left = draft.rng.random() < 0.5
    arm = (width / 2 - side, width / 2) if left else (-width / 2, side - width / 2)
    height = draft.height(cell, 0.6, 0.9)
    parts = [
        {"polygon": rectangle(-depth / 2, -width / 2, back - depth / 2, width / 2), "z": [0, round(height, 3)]},
        {"polygon": rectangle(back - depth / 2, arm[0], depth / 2, arm[1]), "z": [0, round(height, 3)]},
    ]
    at = (u0 + depth / 2, v0 + width / 2)
    name = draft.add(cell, facing, "corner-sofa", at, 0, (depth, width, height), parts=parts)
    draft.at_wall += [name] if wall else []
    air = 0.012
    size = (depth - back - 2 * air, width - side - 2 * air, draft.height(cell, 0.3, 0.5))
    if min(size) < 0.1:
        raise NoFit("the notch is too small")
    v = v0 + (width - side) / 2 if left else v0 + side + (width - side) / 2
    draft.add(cell, facing, "side-table", (u0 + back + (depth - back) / 2, v), 0, size)


def octagon(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """A prism with eight corners."""
    a, b = cell.local(facing)
    size = min(draft.span(a), draft.span(b))
    k = size / 2 * math.tan(math.pi / 8)
    r = size / 2
    ring = [(r, -k), (r, k), (k, r), (-k, r), (-r, k), (-r, -k), (-k, -r), (k, -r)]
    height = round(draft.height(cell, 0.4, 0.75), 3)
    parts = [{"polygon": [[round(x, 4), round(y, 4)] for x, y in ring], "z": [0, height]}]
    at = (float(draft.rng.uniform(0.45, 0.55)) * (a - size) + size / 2, (b - size) / 2 + size / 2)
    draft.add(cell, facing, "round-table", at, 0, (size, size, height), parts=parts)


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


def _seats(draft: Draft, cell: Cell, facing: int, table: str, u: float, v0: float, width: float, count: int, turn: int):
    """Seats in a row along a table; ``u`` is where their middles are."""
    pitch = width / count
    if pitch < SEAT[1] + 0.04 + 2 * LEG / count:
        raise NoFit("the seats do not fit beside each other")
    for k in range(count):
        at = (u, v0 + LEG + (width - 2 * LEG) * (k + 0.5) / count)
        seat = draft.add(cell, facing, "chair", at, turn, (SEAT[0], SEAT[1], SEAT[3]), parts=seat_parts())
        draft.relate("front_against", seat, table)


def table(seats: int) -> Callable[[Draft, Cell, int, bool], None]:
    """A table with seats on its two long sides, all within the cell."""

    def fill(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
        a, b = cell.local(facing)
        whole, width = draft.span(a), draft.span(b)
        out = SEAT[0] - TUCKED
        depth = round(whole - 2 * out, 3)
        if depth < 2 * TUCKED + 0.3:
            raise NoFit("no room for a table between its seats")
        u0, v0 = draft.back(False, a - whole), draft.back(False, b - width)
        at = (u0 + whole / 2, v0 + width / 2)
        name = draft.add(cell, facing, "table", at, 0, (depth, width, TABLE[0]), parts=table_parts(depth, width))
        near, far = seats // 2, seats - seats // 2
        _seats(draft, cell, facing, name, u0 + SEAT[0] / 2, v0, width, near, 0)
        _seats(draft, cell, facing, name, u0 + whole - SEAT[0] / 2, v0, width, far, 2)

    return fill


def desk(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """A desk with a seat before it."""
    a, b = cell.local(facing)
    whole, width = draft.span(a), draft.span(b)
    depth = round(whole - SEAT[0] + TUCKED, 3)
    if depth < 0.4 or width < SEAT[1] + 2 * LEG + 0.04:
        raise NoFit("no room for a desk and its seat")
    u0, v0 = draft.back(wall, a - whole), draft.back(False, b - width)
    at = (u0 + depth / 2, v0 + width / 2)
    name = draft.add(cell, facing, "desk", at, 0, (depth, width, TABLE[0]), parts=table_parts(depth, width))
    draft.at_wall += [name] if wall else []
    size = (SEAT[0], SEAT[1], SEAT[3])
    seat = draft.add(cell, facing, "chair", (u0 + whole - SEAT[0] / 2, v0 + width / 2), 2, size, parts=seat_parts())
    draft.relate("front_to_front", seat, name)


def twin_desks(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
    """Two desks back to back, each with its seat."""
    a, b = cell.local(facing)
    whole, width = draft.span(a), draft.span(b)
    depth = round((whole - 2 * (SEAT[0] - TUCKED) - 0.012) / 2, 3)
    if depth < 0.4 or width < SEAT[1] + 2 * LEG + 0.04:
        raise NoFit("no room for two desks and their seats")
    u0, v = draft.back(False, a - whole), b / 2
    names = []
    for turn in (0, 2):

        def at(u: float, turn: int = turn) -> tuple[float, float]:
            return (u0 + (whole - u if turn == 0 else u), v)

        u = SEAT[0] - TUCKED + depth / 2
        size = (depth, width, TABLE[0])
        names.append(draft.add(cell, facing, "desk", at(u), turn, size, parts=table_parts(depth, width)))
        size = (SEAT[0], SEAT[1], SEAT[3])
        seat = draft.add(cell, facing, "chair", at(SEAT[0] / 2), turn + 2, size, parts=seat_parts())
        draft.relate("front_to_front", seat, names[-1])
    draft.relate("back_to_back", names[1], names[0])


def laden(boards: int, things: int) -> Callable[[Draft, Cell, int, bool], None]:
    """A table (one board) or a shelf of several boards, with so many things on all of them."""

    def fill(draft: Draft, cell: Cell, facing: int, wall: bool) -> None:
        a, b = cell.local(facing)
        depth, width = draft.span(a), draft.span(b)
        if min(depth, width) < 0.3:
            raise NoFit("the supporter is too small")
        at = _middle(draft, cell, facing, depth, width, wall)
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
        size = (depth, width, height)
        name = draft.add(cell, facing, kind, at, 0, size, parts=parts, surfaces=surfaces)
        draft.at_wall += [name] if wall else []
        counts = [things // boards + (k < things % boards) for k in range(boards)]
        for k, count in enumerate(counts):
            if count:
                _things(
                    draft, cell, facing, at, name, f"board-{k}", tops[k], (depth - 2 * inset, width - 2 * inset), count
                )

    return fill


def _things(
    draft: Draft, cell: Cell, facing: int, at: Any, below: str, surface: str, z: float, size: Any, count: int
) -> None:
    """Boxes side by side on a surface."""
    depth, width = size
    for x0, y0, x1, y1 in split((0.0, 0.0, depth, width), list(draft.rng.uniform(0.7, 1.3, count)), draft.rng):
        dx, dy = (draft.span(side, draft.thing_side) for side in (x1 - x0, y1 - y0))
        u = x0 + draft.back(False, x1 - x0 - dx) + dx / 2 - depth / 2
        v = y0 + draft.back(False, y1 - y0 - dy) + dy / 2 - width / 2
        turn = int(draft.rng.integers(4))
        box_size = (dx, dy) if turn % 2 == 0 else (dy, dx)
        support = {"object": below, "surface": surface}
        high = float(draft.rng.uniform(0.06, 0.3))
        where = (at[0] + u, at[1] + v)
        draft.add(cell, facing, "thing", where, turn, (*box_size, high), mount="surface", support=support)
        x, y, _, yaw = draft.poses[-1]
        draft.poses[-1] = (x, y, z, yaw)


@dataclass(frozen=True)
class Unit:
    """What a family puts into cells: how many objects it has, its floor in proportion to others', what fills it."""

    objects: int
    area: float
    fill: Callable[[Draft, Cell, int, bool], None]
