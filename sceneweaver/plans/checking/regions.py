"""Floors as exact sets: unions of rectangles between the coordinates that occur, all in whole millimetres.

A region is the closure of some cells of a grid whose lines are its own coordinates. Squares that fit into it are found
by their lower left corner: those corners are a closed set, made of points, open segments and open rectangles between
lines of the grid and the same lines moved by the side of the square. One place of each stands for all of it, so what
is said of fits and of ways between them is exact.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Point = tuple[int, int]
Box = tuple[int, int, int, int]
"""x0, y0, x1, y1 [mm]."""

STEP = 50
"""Largest side [mm] of the cells by which an outline with oblique walls is filled from inside."""


def is_rectilinear(outline: Sequence[Point]) -> bool:
    """Whether all walls run along x or y."""
    return all((a[0] == b[0]) != (a[1] == b[1]) for a, b in edges(outline))


def edges(outline: Sequence[Point]) -> Iterable[tuple[Point, Point]]:
    """Pairs of corners, wall by wall."""
    return zip(outline, [*outline[1:], outline[0]], strict=True)


def doubled_area(outline: Sequence[Point]) -> int:
    """Twice the area of an outline [mm2]."""
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in edges(outline)))


class Region:
    """A closed set of cells [x_i, x_i+1] x [y_j, y_j+1], ``cells[i, j]``, in millimetres."""

    def __init__(self, xs: NDArray[np.int64], ys: NDArray[np.int64], cells: NDArray[np.bool_]) -> None:
        self.xs, self.ys, self.cells = xs, ys, cells

    @classmethod
    def of_boxes(cls, boxes: Iterable[Box]) -> Region:
        """The union of some boxes."""
        listed = [box for box in boxes if box[0] < box[2] and box[1] < box[3]]
        xs = np.array(sorted({x for b in listed for x in (b[0], b[2])}), np.int64)
        ys = np.array(sorted({y for b in listed for y in (b[1], b[3])}), np.int64)
        cells = np.zeros((max(0, len(xs) - 1), max(0, len(ys) - 1)), bool)
        for x0, y0, x1, y1 in listed:
            i0, i1 = np.searchsorted(xs, (x0, x1))
            j0, j1 = np.searchsorted(ys, (y0, y1))
            cells[i0:i1, j0:j1] = True
        return cls(xs, ys, cells)

    @classmethod
    def of_outline(cls, outline: Sequence[Point]) -> Region:
        """What an outline encloses; with oblique walls the cells that lie wholly inside.

        Those cells are at most `STEP` wide and have the corners' coordinates as lines, so straight walls stay exact.
        """
        if not is_rectilinear(outline):
            return cls._filled(outline)
        xs = np.array(sorted({x for x, _ in outline}), np.int64)
        ys = np.array(sorted({y for _, y in outline}), np.int64)
        # Each wall along y flips what lies to the right of it: cells with an odd count are inside.
        flips = np.zeros((len(xs), len(ys) - 1), np.int64)
        for (ax, ay), (_, by) in edges(outline):
            if ay != by:
                j0, j1 = np.searchsorted(ys, (min(ay, by), max(ay, by)))
                flips[np.searchsorted(xs, ax), j0:j1] += 1
        return cls(xs, ys, np.cumsum(flips, axis=0)[:-1] % 2 == 1)

    @classmethod
    def _filled(cls, outline: Sequence[Point]) -> Region:
        import shapely

        polygon = shapely.Polygon(outline)
        xs, ys = (_lines({point[axis] for point in outline}) for axis in (0, 1))
        left, low = np.meshgrid(xs[:-1], ys[:-1], indexing="ij")
        right, high = np.meshgrid(xs[1:], ys[1:], indexing="ij")
        shapely.prepare(polygon)
        cells = shapely.covers(polygon, shapely.box(left, low, right, high))
        return cls(xs, ys, cells)

    @property
    def empty(self) -> bool:
        """Whether nothing is in it."""
        return not self.cells.any()

    @cached_property
    def boxes(self) -> list[Box]:
        """Disjoint boxes that it is made of: cells joined along y, then along x where they match."""
        columns: list[Box] = []
        for i in range(len(self.xs) - 1):
            column = np.flatnonzero(np.diff(np.concatenate(([False], self.cells[i], [False])).astype(np.int8)))
            for j0, j1 in column.reshape(-1, 2):
                columns.append((int(self.xs[i]), int(self.ys[j0]), int(self.xs[i + 1]), int(self.ys[j1])))
        joined: dict[tuple[int, int, int], Box] = {}
        done: list[Box] = []
        for x0, y0, x1, y1 in columns:
            before = joined.pop((x0, y0, y1), None)
            box = (x0 if before is None else before[0], y0, x1, y1)
            joined[(x1, y0, y1)] = box
        done.extend(joined.values())
        return sorted(done)

    @property
    def area(self) -> int:
        """[mm2]"""
        return int(np.diff(self.xs) @ self.cells.astype(np.int64) @ np.diff(self.ys)) if self.cells.size else 0

    @property
    def bounds(self) -> Box:
        """Of the whole."""
        i, j = np.flatnonzero(self.cells.any(1)), np.flatnonzero(self.cells.any(0))
        return int(self.xs[i[0]]), int(self.ys[j[0]]), int(self.xs[i[-1] + 1]), int(self.ys[j[-1] + 1])

    def on(self, xs: NDArray[np.int64], ys: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Which cells of a grid that has all its coordinates lie in it."""
        if not self.cells.size:
            return np.zeros((len(xs) - 1, len(ys) - 1), bool)
        i = np.searchsorted(self.xs, xs[:-1], side="right") - 1
        j = np.searchsorted(self.ys, ys[:-1], side="right") - 1
        inside = ((i >= 0) & (i < len(self.xs) - 1))[:, None] & ((j >= 0) & (j < len(self.ys) - 1))[None, :]
        return self.cells[np.clip(i, 0, len(self.xs) - 2)][:, np.clip(j, 0, len(self.ys) - 2)] & inside

    def __or__(self, other: Region) -> Region:
        return self._with(other, np.logical_or)

    def __and__(self, other: Region) -> Region:
        return self._with(other, np.logical_and)

    def __sub__(self, other: Region) -> Region:
        return self._with(other, np.greater)

    def _with(self, other: Region, op: Callable[..., NDArray[np.bool_]]) -> Region:
        xs, ys = np.union1d(self.xs, other.xs), np.union1d(self.ys, other.ys)
        if len(xs) < 2 or len(ys) < 2:
            return self
        return Region(xs, ys, op(self.on(xs, ys), other.on(xs, ys)))

    def grown(self, by: int) -> Region:
        """With everything that is at most ``by`` away along both axes."""
        return Region.of_boxes((x0 - by, y0 - by, x1 + by, y1 + by) for x0, y0, x1, y1 in self.boxes)

    def holes(self) -> Region:
        """What it encloses and is not in it."""
        if self.empty:
            return self
        outside = np.pad(~self.cells, 1, constant_values=True)
        return Region(self.xs, self.ys, ~(components(outside) == components(outside)[0, 0])[1:-1, 1:-1] & ~self.cells)

    # ---- squares

    def fits(self, side: int, xs: NDArray[np.int64], ys: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Whether the open square of ``side`` whose lower left corner is at (x, y) lies in it, for all of a grid.

        Coordinates are doubled millimetres, so that the middle between two lines is a whole number.
        """
        blocked = np.zeros((len(self.xs) + 2, len(self.ys) + 2), np.int64)
        blocked[1:, 1:] = np.cumsum(np.cumsum(np.pad(~self.cells, 1, constant_values=True), axis=0), axis=1)
        i0, i1 = self._spans(2 * self.xs, xs, 2 * side)
        j0, j1 = self._spans(2 * self.ys, ys, 2 * side)
        count = blocked[i1][:, j1] - blocked[i0][:, j1] - blocked[i1][:, j0] + blocked[i0][:, j0]
        return count == 0

    @staticmethod
    def _spans(lines: NDArray[np.int64], starts: NDArray[np.int64], length: int) -> tuple[NDArray, NDArray]:
        """First and one after the last padded cell that an open interval meets."""
        return (
            np.searchsorted(lines, starts, side="right"),
            np.searchsorted(lines, starts + length, side="left") + 1,
        )

    def corners(
        self, side: int, more_xs: Iterable[int] = (), more_ys: Iterable[int] = ()
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Places that stand for all lower left corners of squares: lines and middles between [2 mm]."""
        return _slots(self.xs, side, more_xs), _slots(self.ys, side, more_ys)

    def largest_square(self) -> int:
        """Side of the largest square along the axes that lies in it [mm]."""
        if self.empty:
            return 0
        x0, y0, x1, y1 = self.bounds
        return largest(lambda s: bool(self.fits(s, *self.corners(s)).any()), min(x1 - x0, y1 - y0))

    def largest_rectangles(self) -> list[tuple[int, int]]:
        """(width, depth) of rectangles along the axes that fit and grow no further, sides on its own lines [mm]."""
        found: set[tuple[int, int]] = set()
        for i0 in range(len(self.xs) - 1):
            column = np.ones(len(self.ys) - 1, bool)
            for i1 in range(i0 + 1, len(self.xs)):
                column &= self.cells[i1 - 1]
                if not column.any():
                    break
                runs = np.flatnonzero(np.diff(np.concatenate(([False], column, [False])).astype(np.int8)))
                for j0, j1 in runs.reshape(-1, 2):
                    found.add((int(self.xs[i1] - self.xs[i0]), int(self.ys[j1] - self.ys[j0])))
        return sorted(found)


def largest(holds: Callable[[int], bool], most: int) -> int:
    """The largest whole number up to ``most`` for which a condition holds that gets harder; 0 where none does."""
    if most <= 0 or not holds(1):
        return 0
    if holds(most):
        return most
    low, high = 1, most
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def components(cells: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Numbers, from 1, of the parts of a grid that are joined along its axes; 0 outside of them.

    Row by row: runs of cells are joined with the runs that they touch in the row before.
    """
    labels = np.zeros(cells.shape, np.int64)
    parent = [0]

    def root(k: int) -> int:
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    before: list[tuple[int, int, int]] = []
    for i in range(len(cells)):
        bounds = np.flatnonzero(np.diff(np.concatenate(([False], cells[i], [False])).astype(np.int8)))
        runs: list[tuple[int, int, int]] = []
        for low, high in bounds.reshape(-1, 2).tolist():
            touched = {root(k) for a, b, k in before if a < high and low < b}
            if touched:
                label = min(touched)
                for k in touched:
                    parent[k] = label
            else:
                label = len(parent)
                parent.append(label)
            labels[i, low:high] = label
            runs.append((low, high, label))
        before = runs
    roots = np.array([root(k) for k in range(len(parent))])
    return np.unique(roots, return_inverse=True)[1][labels]


def _lines(corners: set[int]) -> NDArray[np.int64]:
    """Coordinates of corners with lines between them, at most `STEP` apart."""
    places = sorted(corners)
    parts = [np.linspace(a, b, -(-(b - a) // STEP) + 1).round() for a, b in itertools.pairwise(places)]
    return np.unique(np.concatenate(parts)).astype(np.int64)


def _slots(lines: NDArray[np.int64], side: int, more: Iterable[int]) -> NDArray[np.int64]:
    places = np.unique(np.concatenate((2 * lines, 2 * (lines - side), 2 * np.fromiter(more, np.int64))))
    slots = np.empty(2 * len(places) - 1, np.int64)
    slots[::2] = places
    slots[1::2] = (places[1:] + places[:-1]) // 2
    return slots
