"""A floor grid in the frame of the room's longest wall, and the exact rows of cells covered by widened convex shapes.

The frame turns with the room, so a turned room is judged on the same cells. Cells are squares of `CELL` metres and
stand for their centres.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sceneweaver.verify.solids import Array, Placed

CELL = 0.05
"""Side of a cell in metres."""

TIE = 1e-9
"""Length in metres by which spans are shortened, so that a centre just at the radius is never in them."""


@dataclass(frozen=True, eq=False)
class Spans:
    """Runs of cells: in ``row``, columns ``first`` to ``last`` (left out), of shape ``shape``; none is empty."""

    shape: NDArray[np.intp]
    row: NDArray[np.intp]
    first: NDArray[np.intp]
    last: NDArray[np.intp]


class Grid:
    """Cells over the bounding box of the outline in the frame of its longest wall."""

    def __init__(self, placed: Placed) -> None:
        """Lay the grid over the room."""
        longest = max(wall.length for wall in placed.walls)
        wall = next(w for w in placed.walls if w.length >= longest - 1e-6)
        self._start = np.asarray(wall.start)
        self._axes = np.array([wall.along, wall.inward])
        self.outline = self.to_grid(np.asarray(placed.scene.room.outline, dtype=float))
        low, high = self.outline.min(axis=0), self.outline.max(axis=0)
        self._origin = np.floor(np.round(low / CELL, 6)) * CELL
        columns, rows = np.ceil(np.round((high - self._origin) / CELL, 6)).astype(int)
        self.shape = (int(rows), int(columns))

    @property
    def cells(self) -> int:
        """Number of cells."""
        return self.shape[0] * self.shape[1]

    def to_grid(self, points: Array) -> Array:
        """Return world ``points`` [..., 2] in the frame of the grid [m]."""
        return (points - self._start) @ self._axes.T

    def to_world(self, cells: NDArray[np.bool_]) -> Array:
        """Return the centres [n, 2] of the cells of ``cells`` in the world [m]."""
        rows, columns = np.nonzero(cells)
        return (self._origin + (np.stack([columns, rows], axis=1) + 0.5) * CELL) @ self._axes + self._start

    def nearest(self, cells: NDArray[np.bool_], point: Array, within: float) -> tuple[int, int] | None:
        """Return (row, column) of the cell of ``cells`` nearest to ``point`` (grid's frame), if ``within`` metres."""
        rows, columns = np.nonzero(cells)
        if not len(rows):
            return None
        centres = self._origin + (np.stack([columns, rows], axis=1) + 0.5) * CELL
        away = np.hypot(*(centres - point).T)
        best = int(away.argmin())
        return (int(rows[best]), int(columns[best])) if away[best] <= within else None

    def inside(self) -> NDArray[np.bool_]:
        """Return which cell centres lie inside the outline, by counting the walls to their left."""
        a, b = self.outline, np.roll(self.outline, -1, axis=0)
        y = self._heights(np.arange(self.shape[0]))[:, None]
        crosses = (a[:, 1] > y) != (b[:, 1] > y)
        rise = np.where(a[:, 1] == b[:, 1], 1.0, b[:, 1] - a[:, 1])
        x = a[:, 0] + (y - a[:, 1]) / rise * (b[:, 0] - a[:, 0])
        row, wall = np.nonzero(crosses)
        flips = np.zeros((self.shape[0], self.shape[1] + 1), dtype=int)
        np.add.at(flips, (row, self._column(x[row, wall])), 1)
        return (np.cumsum(flips, axis=1)[:, :-1] % 2).astype(bool)

    def covered(self, spans: Spans) -> NDArray[np.bool_]:
        """Return which cells lie in some span."""
        edges = np.zeros((self.shape[0], self.shape[1] + 1), dtype=int)
        np.add.at(edges, (spans.row, spans.first), 1)
        np.add.at(edges, (spans.row, spans.last), -1)
        return np.cumsum(edges, axis=1)[:, :-1] > 0

    def touches(self, cells: NDArray[np.bool_], spans: Spans, count: int) -> NDArray[np.bool_]:
        """Return for each of ``count`` shapes whether one of its spans holds a cell of ``cells``."""
        sums = np.concatenate([np.zeros((self.shape[0], 1), dtype=int), np.cumsum(cells, axis=1)], axis=1)
        held = sums[spans.row, spans.last] > sums[spans.row, spans.first]
        out = np.zeros(count, dtype=bool)
        out[spans.shape[held]] = True
        return out

    def spans(self, shapes: Sequence[Array] | Array, radius: float) -> Spans:
        """Return the cells whose centres are nearer than ``radius`` to convex shapes, exactly.

        ``shapes`` are the corners, in order, of convex polygons, segments or points in the frame of the grid; an array
        [n, v, 2] may repeat corners. In each row the widened shape covers one interval. Its ends are found among the
        discs about the corners and the edges moved out by ``radius`` to either side.
        """
        if not len(shapes):
            none = np.empty(0, dtype=np.intp)
            return Spans(none, none, none, none)
        corners = shapes if isinstance(shapes, np.ndarray) else padded(shapes)
        y0, y1 = corners[..., 1].min(axis=1) - radius + TIE, corners[..., 1].max(axis=1) + radius - TIE
        first = np.clip(self._row(y0), 0, self.shape[0])
        rows = np.clip(self._row(y1), 0, self.shape[0]) - first
        shape = np.repeat(np.arange(len(corners)), rows)
        row = np.arange(len(shape)) - np.repeat(np.cumsum(rows) - rows, rows) + first[shape]
        low, high = _interval(corners, shape, self._heights(row)[:, None], radius)
        start, stop = self._column(low + TIE), self._column(high - TIE)
        keep = start < stop
        return Spans(shape[keep], row[keep], start[keep], stop[keep])

    def _heights(self, rows: NDArray[np.intp]) -> Array:
        return self._origin[1] + (rows + 0.5) * CELL

    def _row(self, y: Array) -> NDArray[np.intp]:
        """First row whose centre is at or above ``y``."""
        return np.ceil((y - self._origin[1]) / CELL - 0.5).astype(int)

    def _column(self, x: Array) -> NDArray[np.intp]:
        """First column whose centre is at or right of ``x``, within the grid's width."""
        return np.clip(np.ceil((x - self._origin[0]) / CELL - 0.5), 0, self.shape[1]).astype(int)


def padded(shapes: Sequence[Array]) -> Array:
    """Polygons as one array [n, v, 2], where short ones repeat their last corner."""
    most = max(map(len, shapes))
    return np.stack([np.concatenate([s, np.repeat(s[-1:], most - len(s), axis=0)]) for s in shapes])


def _interval(shapes: Array, which: NDArray[np.intp], y: Array, radius: float) -> tuple[Array, Array]:
    """Ends in x of widened convex shapes at heights ``y`` [k, 1]; low > high where a shape is not met [m].

    ``shapes`` [n, v, 2] are their corners, ``which`` [k] says the shape of each height.
    """
    next_corners = np.roll(shapes, -1, axis=1)
    edges = next_corners - shapes
    sizes = np.hypot(edges[..., 0], edges[..., 1])
    long_enough = sizes > 1e-12
    normals = np.stack([edges[..., 1], -edges[..., 0]], axis=-1) / np.where(long_enough, sizes, 1.0)[..., None] * radius
    corners, real = shapes[which], long_enough[which]
    half = np.sqrt(np.maximum(radius**2 - (y - corners[..., 1]) ** 2, 0.0))
    met = np.abs(y - corners[..., 1]) <= radius
    low = np.where(met, corners[..., 0] - half, np.inf).min(axis=1)
    high = np.where(met, corners[..., 0] + half, -np.inf).max(axis=1)
    for side in (normals, -normals):
        starts, ends = (shapes + side)[which], (next_corners + side)[which]
        ax, ay, bx, by = starts[..., 0], starts[..., 1], ends[..., 0], ends[..., 1]
        crosses = real & (ay != by) & (np.minimum(ay, by) <= y) & (y <= np.maximum(ay, by))
        x = ax + (y - ay) / np.where(crosses, by - ay, 1.0) * (bx - ax)
        low = np.minimum(low, np.where(crosses, x, np.inf).min(axis=1))
        high = np.maximum(high, np.where(crosses, x, -np.inf).max(axis=1))
    return low, high
