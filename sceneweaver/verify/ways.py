"""How wide a way over the floor is: the widest disc that gets from where it begins to where it ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from sceneweaver.scene import CATALOGUE, FreeArea
from sceneweaver.verify.grid import CELL, Grid
from sceneweaver.verify.solids import Body, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

WIDEST = 3.0
"""Width from which on no more is measured [m]."""

ARRIVED = 0.3
"""How far from a thing or a door the edge of the disc is there [m]."""

PIECE = 0.25
"""Plan from which on a thing is one that ways lead to where none is named [m2]; rugs aside."""

MOST_PIECES = 24
"""How many of these, the largest, are looked at."""

LOW, HIGH = 0.03, 1.9
"""Heights between which a solid part is in the way [m]."""

MOST_CELLS = 2_000_000
"""Cells up to which ways are measured."""

_STEPS = 8
_SEATS = CATALOGUE.with_role("seat")


def widest_way(placed: Placed, area: FreeArea) -> tuple[float | None, tuple[str, ...]]:
    """The width [m] of the widest disc that gets along a path, and the ids of where a disc of its width does not get.

    The disc is moved over the centres of cells, so that its width is right to a cell. None where the path names nothing
    that is there, or the room is too large.
    """
    ground = _Ground.of(placed)
    if ground is None:
        return None, ()
    starts, ends = _ends(placed, area)
    if not starts or not ends:
        return None, ()
    low, high = 0.0, WIDEST
    for _ in range(_STEPS):
        width = (low + high) / 2
        low, high = (low, width) if ground.missed(starts, ends, width) else (width, high)
    missed = ground.missed(starts, ends, area.size[0]) if low < area.size[0] - CELL else ()
    return low, missed


class _Ground:
    """The floor of a scene as its ways are measured on it; found once for all of them.

    Attributes:
        room: of each cell, how far [m] what is in the way is from its centre.
    """

    def __init__(self, placed: Placed, grid: Grid) -> None:
        from scipy.ndimage import distance_transform_edt

        self._placed, self._grid = placed, grid
        parts = placed.parts
        rows = (parts.z[:, 0] < HIGH) & (parts.z[:, 1] > LOW)
        self._free = grid.inside() & ~grid.covered(grid.spans(grid.to_grid(parts.xy[rows]), 1e-3))
        self.room = np.asarray(distance_transform_edt(np.pad(self._free, 1)))[1:-1, 1:-1] * CELL - CELL / 4
        self._away: dict[str, NDArray[np.float64]] = {}
        self._regions: dict[float, tuple[NDArray[np.int32], int]] = {}

    @classmethod
    def of(cls, placed: Placed) -> _Ground | None:
        """That of a scene; None where it is too large."""
        kept = placed.__dict__
        if "_ground" not in kept:
            grid = Grid(placed)
            kept["_ground"] = None if grid.cells > MOST_CELLS else cls(placed, grid)
        return kept["_ground"]

    def away(self, name: str) -> NDArray[np.float64]:
        """As `_distance`."""
        if name not in self._away:
            self._away[name] = _distance(self._grid, self._placed, name, self._free)
        return self._away[name]

    def missed(self, starts: list[str], ends: list[str], width: float) -> tuple[str, ...]:
        """Where a disc of some width does not get."""
        from scipy.ndimage import label

        if width not in self._regions:
            self._regions[width] = label(self.room >= width / 2 - 1e-6)  # pyright: ignore[reportArgumentType]
        regions, count = self._regions[width]
        near = width / 2 + ARRIVED
        entered = np.zeros(count + 1, dtype=bool)
        for name in starts:
            entered[regions[self.away(name) <= near]] = True
        entered[0] = False  # what is in the way
        return tuple(name for name in ends if not entered[regions[self.away(name) <= near]].any())


def forget_ground(placed: Placed) -> None:
    """Let go of what ways of a scene share: megabytes, and of no use once all of them are measured."""
    placed.__dict__.pop("_ground", None)


def _ends(placed: Placed, area: FreeArea) -> tuple[list[str], list[str]]:
    """Names of the doors and things that a path begins at, and of those that it leads to."""
    doors = [door.item.id for door in placed.doors]
    known = {*doors, *placed.by_id}
    named = [name for name in area.targets if name in known]
    others = [name for name in area.others if name in known]
    if area.targets or area.others:
        return (named, others) if area.others else (named[:1], named[1:])
    tucked = {relation.subject for relation in placed.scene.relations if relation.type in _SEATS}
    things = [
        body
        for body in placed.bodies
        if body.item.mount == "floor"
        and body.size[0] * body.size[1] >= PIECE
        and body.id not in tucked
        and body.z[1] > LOW
    ]
    largest = sorted(things, key=lambda body: -body.size[0] * body.size[1])[:MOST_PIECES]
    return doors, [*doors[1:], *(body.id for body in largest)]


def _distance(grid: Grid, placed: Placed, name: str, free: NDArray[np.bool_]) -> NDArray[np.float64]:
    """The way [m] of free cells to a door or to the footprint of a thing, or of what is tied to it (the chairs of a
    table, the table before a sofa), in steps to eight and four neighbours by turns; infinite beyond what the widest
    disc reaches."""
    if name in placed.by_id:
        shapes = np.concatenate([placed.parts.xy[placed.part_rows(body)] for body in _tied(placed, name)])
    else:
        opening = next(door for door in placed.doors if door.item.id == name)
        shapes = np.array([opening.polygon[:2]])  # the sill: the side of its clear space that is in the wall
    held = grid.covered(grid.spans(grid.to_grid(np.asarray(shapes, dtype=float)), CELL))
    steps = np.where(held, 0.0, np.inf)
    reach = round((WIDEST / 2 + ARRIVED) / CELL)
    rows, columns = (np.flatnonzero(held.any(axis=axis)) for axis in (1, 0))
    if not rows.size:
        return steps
    near = tuple(slice(max(0, at[0] - reach), at[-1] + reach + 1) for at in (rows, columns))
    held, ground, away = held[near], free[near] | held[near], steps[near]
    for step in range(1, reach + 1):
        grown = _grown(held, diagonally=step % 2 == 1) & ground
        away[grown & ~held] = step * CELL
        held = grown
    return steps


def _grown(held: NDArray[np.bool_], diagonally: bool) -> NDArray[np.bool_]:
    """Cells, and those beside them."""
    across = held.copy()
    across[1:] |= held[:-1]
    across[:-1] |= held[1:]
    along = across if diagonally else held
    grown = across.copy()
    grown[:, 1:] |= along[:, :-1]
    grown[:, :-1] |= along[:, 1:]
    return grown


def _tied(placed: Placed, name: str) -> list[Body]:
    """A thing with what relations tie to it."""
    names = {name}
    for relation in placed.scene.relations:
        if isinstance(relation.target, str) and CATALOGUE[relation.type].ties_zones:
            pair = {relation.subject, relation.target}
            names |= pair if name in pair else set()
    return [placed.by_id[one] for one in sorted(names) if one in placed.by_id]
