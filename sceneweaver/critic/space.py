"""The floor as a grid: what is covered, and what is in use."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2
from sceneweaver.rules.faults import number

from .survey import Survey

CELLS = 4000
"""Cells of the grid that the floor is measured with, about."""


@dataclass(frozen=True)
class Floor:
    """The floor as a grid: ``inside`` the room, ``taken`` by furniture, ``used`` within reach of it; [rows, cols]."""

    cell: float
    inside: NDArray[np.bool_]
    taken: NDArray[np.bool_]
    used: NDArray[np.bool_]
    turn: float
    origin: tuple[float, float]

    def share(self, mask: NDArray[np.bool_]) -> float:
        """Share of the room that a mask covers."""
        return float((mask & self.inside).sum()) / max(1, int(self.inside.sum()))

    def world(self, row: Any, column: Any) -> tuple[Any, Any]:
        """The point [m] of a position in the grid; floats, or arrays of one shape."""
        u, v = self.origin[0] + column * self.cell, self.origin[1] + row * self.cell
        return SE2(yaw=self.turn).world(u, v)


def floor_of(survey: Survey) -> Floor:
    """Measure the floor in the directions of the longest wall."""
    kept = survey.__dict__.get("_floor")
    if kept is None:
        kept = survey.__dict__["_floor"] = _measure(survey)
    return kept


def _measure(survey: Survey) -> Floor:
    import shapely
    from scipy.ndimage import distance_transform_edt

    frame = SE2(yaw=survey.axis)
    outline = frame.to_local(survey.scene.room.outline)
    low, high = outline.min(axis=0), outline.max(axis=0)
    cell = max(0.06, math.sqrt(survey.area / CELLS))
    shape = np.maximum(1, np.ceil((high - low) / cell)).astype(int)
    us, vs = (low[k] + (np.arange(shape[k]) + 0.5) * cell for k in (0, 1))
    grid_u, grid_v = np.meshgrid(us, vs)
    room = shapely.Polygon(outline)
    shapely.prepare(room)
    inside = np.asarray(shapely.contains_xy(room, grid_u, grid_v))
    taken = np.zeros_like(inside)
    parts = survey.placed.parts
    stands = np.zeros(len(survey.bodies), dtype=bool)
    stands[[b.index for b in survey.standing]] = True
    _fill(taken, frame.to_local(parts.xy[stands[parts.owner]]), us, vs)
    away = np.asarray(distance_transform_edt(~taken)) * cell if taken.any() else np.full(inside.shape, np.inf)
    used = away <= number("used")
    _fill(used, frame.to_local(survey.placed.opening_zones.xy[: len(survey.placed.doors)]), us, vs)
    return Floor(cell, inside, taken & inside, used & inside, frame.yaw, (float(low[0]), float(low[1])))


def _fill(mask: NDArray[np.bool_], polygons: NDArray[np.float64], us: NDArray, vs: NDArray) -> None:
    """Set the cells whose centres lie in some of convex counter-clockwise polygons [n, k, 2]."""
    if not len(polygons):
        return
    (u0, v0), (u1, v1) = polygons.min(axis=1).T, polygons.max(axis=1).T
    left, low = np.searchsorted(us, u0), np.searchsorted(vs, v0)
    wide, tall = np.searchsorted(us, u1) - left, np.searchsorted(vs, v1) - low
    count = np.maximum(wide, 0) * np.maximum(tall, 0)
    which = np.repeat(np.arange(len(polygons)), count)
    within = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    rows, columns = low[which] + within // wide[which], left[which] + within % wide[which]
    u, v = us[columns][:, None], vs[rows][:, None]
    edges = np.roll(polygons, -1, axis=1) - polygons
    (x, y), (dx, dy) = np.moveaxis(polygons[which], -1, 0), np.moveaxis(edges[which], -1, 0)
    inside = (dx * (v - y) - dy * (u - x) >= -1e-9).all(axis=1)
    mask[rows[inside], columns[inside]] = True


def largest_rectangle(free: NDArray[np.bool_]) -> tuple[int, int, int, int, int]:
    """The largest all-true rectangle: cells, first row, first column, rows, columns."""
    best = (0, 0, 0, 0, 0)
    heights = np.zeros(free.shape[1] + 1, dtype=int)
    wider = np.append((free[1:] | ~free[:-1]).all(axis=1), False)
    for r in range(free.shape[0]):
        heights[:-1] = np.where(free[r], heights[:-1] + 1, 0)
        if wider[r]:  # what ends here goes on in the next row
            continue
        steps = [0, *(np.flatnonzero(heights[1:] != heights[:-1]) + 1).tolist()]
        stack: list[tuple[int, int]] = []
        for k, h in zip(steps, heights[steps].tolist(), strict=True):
            start = k
            while stack and stack[-1][1] >= h:
                start, tall = stack.pop()
                if tall * (k - start) > best[0]:
                    best = (tall * (k - start), r - tall + 1, start, tall, k - start)
            stack.append((start, h))
    return best
