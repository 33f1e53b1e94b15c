"""How the floor is filled: what is covered, what lies empty, and whether one end has it all."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2

from .grade import Finding, finding, moved
from .survey import Survey

REACH = 0.6
"""Distance [m] around furniture that belongs to it: where one stands, sits and passes."""

CELLS = 4000
"""Cells of the grid that the floor is measured with, about."""

CROWDED = 0.6
"""Share of the floor under furniture from which a room is crowded."""

EMPTY = 0.14
"""Share of the floor that may lie idle in one rectangle, beyond the reach of all furniture."""

NARROW = 1.0
"""Width [m] up to which an idle strip is a way and no gap in the furniture."""

EMPTY_LEAST = 2.0
"""Area [m2] up to which an idle rectangle is no fault."""

ONE_SIDED = 0.08
"""Share of the furniture that each half of the room should have."""


@dataclass(frozen=True)
class Floor:
    """The floor as a grid: ``inside`` the room, ``taken`` by furniture, ``used`` within `REACH` of it; [rows, cols]."""

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
    used = away <= REACH
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


def measures(survey: Survey) -> dict[str, float]:
    """Shares of the floor that are covered and used, and the largest idle rectangle [m2]."""
    floor = floor_of(survey)
    free = largest_rectangle(floor.inside & ~floor.taken)[0] * floor.cell**2
    idle = _idle(survey)[0] * floor.cell**2
    return {
        "covered_share": floor.share(floor.taken),
        "used_share": floor.share(floor.used),
        "free_rectangle_m2": free,
        "empty_rectangle_m2": idle,
        "balance": _halves(floor)[0],
    }


def _idle(survey: Survey) -> tuple[int, int, int, int, int]:
    floor = floor_of(survey)
    kept = survey.__dict__.get("_idle")
    if kept is None:
        kept = survey.__dict__["_idle"] = largest_rectangle(floor.inside & ~floor.used)
    return kept


def faults(survey: Survey) -> Iterator[Finding]:
    """A crowded floor, idle corners, all the furniture at one end."""
    floor = floor_of(survey)
    covered = floor.share(floor.taken)
    sparse = survey.brief.density == "sparse" or survey.brief.only
    if covered > CROWDED:
        ids = [b.id for b in sorted(survey.standing, key=lambda b: (round(-b.size[0] * b.size[1], 4), b.id))[:3]]
        spare = _spare(survey) or ids[-1:]
        yield finding(
            "layout",
            "crowded",
            ids,
            f"furniture covers {covered:.0%} of the floor",
            f"remove {', '.join(spare)}",
            points=0.5 + 12.0 * (covered - CROWDED),
            grave=covered > CROWDED + 0.15,
            call=("remove_objects", {"ids": spare}),
        )
    cells, row, column, rows, columns = _idle(survey)
    idle = cells * floor.cell**2
    limit = max(EMPTY_LEAST, (2.0 if sparse else 1.0) * EMPTY * survey.area)
    if idle > limit and min(rows, columns) * floor.cell >= NARROW and survey.bodies:
        x, y = floor.world(row + rows / 2, column + columns / 2)
        share = idle / survey.area
        yield finding(
            "layout",
            "empty_area",
            (),
            f"{columns * floor.cell:.1f} x {rows * floor.cell:.1f} m around ({x:.1f}, {y:.1f}) lie empty, "
            f"{share:.0%} of the floor",
            "spread the furniture over the room",
            points=0.4 + 5.0 * (share - EMPTY),
            call=moved(),
        )
    least, way = _halves(floor)
    if least < ONE_SIDED and len(survey.standing) >= 4 and not sparse and survey.area > 8.0:
        yield finding(
            "layout",
            "one_sided",
            (),
            f"the {way} half of the room has {least:.0%} of the furniture",
            "spread the furniture over the room",
            points=0.6 + 6.0 * (ONE_SIDED - least),
            call=moved(),
        )


def _spare(survey: Survey) -> list[str]:
    """Furniture that the room could do without, the largest first."""
    needed = {object_id for n in survey.program.needs if n.item.need == "needed" for object_id in n.have}
    spare = [b for b in survey.standing if b.id not in needed and b.id not in survey.program.asked_of]
    return [b.id for b in sorted(spare, key=lambda b: (round(-b.size[0] * b.size[1], 4), b.id))[:2]]


def _halves(floor: Floor) -> tuple[float, str]:
    """The least share of the furniture that a half of the room has, against the floor in it; which half."""
    total = int(floor.taken.sum())
    if total == 0:
        return 0.0, "whole"
    best, name = 1.0, ""
    for axis, words in ((1, ("left", "right")), (0, ("near", "far"))):
        area = np.cumsum(floor.inside.sum(axis=1 - axis))
        cut = int(np.searchsorted(area, area[-1] / 2)) + 1
        taken = floor.taken.sum(axis=1 - axis)
        for part, word in ((taken[:cut], words[0]), (taken[cut:], words[1])):
            share = float(part.sum()) / total
            if share < best:
                best, name = share, word
    return best, name
