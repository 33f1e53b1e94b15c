"""Measures of free room: depths before sides, empty floor, light on the floor, ways from the doors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2
from sceneweaver.rules.design import room_groups
from sceneweaver.verify.solids import Body, Opening

from ..space import floor_of
from ..survey import Survey
from .measure import MOVED_ASIDE, clear_depth, middle, strip
from .query import kind_set, listed
from .registry import Reading, measure

Cells = NDArray[np.float64]

Shape = tuple[NDArray[np.intp], NDArray[np.intp]]
"""Rows and columns of cells."""

LIT_POINTS = 300
"""Points of the floor at which its light is measured, about."""

ENTRY = 0.6
"""Distance [m] around the middle of a door's inside within which a way begins."""

# ---- before sides ----------------------------------------------------------------------------------------------------


@measure
def clear(
    survey: Survey, o: Body, side: str, most: float, low: float | None = None, but: Body | None = None
) -> Reading:
    """Free depth [m] before a side up to ``most``, and what ends it (None: a wall).

    Seats that are moved aside do not end it, or with ``low`` all that is lower than that, nor does ``but``.
    """

    def passes(b: Body) -> bool:
        return b is but or (b.item.category in MOVED_ASIDE if low is None else b.z[1] < low)

    kept, key = survey.__dict__.setdefault("_clear", {}), (o.index, side, most, low, but and but.index)
    if key not in kept:
        kept[key] = Reading.of(*clear_depth(survey, o, side, most, passes))
    return kept[key]


# ---- the floor -------------------------------------------------------------------------------------------------------


@measure
def free_square(survey: Survey, stand: float) -> Reading:
    """Side [m] of the largest square of floor, along the walls, with nothing on it; and its middle (x, y) [m]."""
    from scipy.ndimage import distance_transform_cdt

    floor = floor_of(survey)
    free = np.pad(floor.inside & ~floor.taken & ~_worked_on(survey, stand), 1)
    if not free.any():
        return Reading.of(0.0, (0.0, 0.0))
    distances: Any = distance_transform_cdt(free, metric="chessboard")
    steps = distances[1:-1, 1:-1]
    row, column = np.unravel_index(int(np.argmax(steps)), steps.shape)
    return Reading.of(2 * int(steps.max()) * floor.cell, floor.world(row + 0.5, column + 0.5))


def _worked_on(survey: Survey, depth: float) -> NDArray[np.bool_]:
    """The floor of a home on which one enters, or stands to use something: a mask like those of `Floor`."""
    import shapely

    floor = floor_of(survey)
    if survey.room_type.name not in room_groups()["homelike"]:
        return np.zeros_like(floor.inside)
    areas = [shapely.Polygon(zone) for zone in survey.placed.opening_zones.xy[: len(survey.placed.doors)]]
    used = kind_set("opened washbasin bathtub shower kitchen_unit")
    areas += [strip(body, "front", depth, 1.0) for body in survey.on_floor(used)]
    rows, columns = np.indices(floor.inside.shape)
    x, y = floor.world(rows + 0.5, columns + 0.5)
    return np.asarray(shapely.contains_xy(shapely.union_all(areas), x, y))


@measure
def unlit(survey: Survey, lamps: Sequence[Body], reach: float) -> float:
    """Share of the floor that is farther from any lamp than a distance [m]."""
    floor = floor_of(survey)
    rows, columns = np.nonzero(floor.inside)
    pick = slice(None, None, max(1, len(rows) // LIT_POINTS))
    x, y = floor.world(rows[pick] + 0.5, columns[pick] + 0.5)
    centres = np.array([b.centre for b in lamps])
    farther = np.hypot(x[:, None] - centres[:, 0], y[:, None] - centres[:, 1]).min(axis=1) > reach
    return float(farther.mean())


# ---- ways ------------------------------------------------------------------------------------------------------------


class Plan:
    """The floor as a grid with the distance [m] of each cell from walls and furniture, and from ways of a width."""

    def __init__(self, survey: Survey) -> None:
        floor = floor_of(survey)
        self.cell, self.origin, self.frame = floor.cell, np.asarray(floor.origin), SE2(yaw=floor.turn)
        self.clear = self._distance(floor.inside & ~floor.taken)
        self.entries = self._cells(np.array([middle(door, 0.5) for door in survey.placed.doors]).reshape(-1, 2))
        self._away: dict[float, Cells] = {}

    def _distance(self, cells: NDArray[np.bool_]) -> Cells:
        """Distance [m] of each cell from the nearest one that is none of some cells, or beyond the grid."""
        from scipy.ndimage import distance_transform_edt

        return np.asarray(distance_transform_edt(np.pad(cells, 1)))[1:-1, 1:-1] * self.cell

    def _cells(self, points: NDArray[np.float64]) -> NDArray[np.intp]:
        """Row and column [n, 2] of points [n, 2]; those beyond the grid at its edge."""
        uv = (self.frame.to_local(points) - self.origin) / self.cell
        return np.clip(uv[:, ::-1].astype(int), 0, np.array(self.clear.shape) - 1)

    def away(self, width: float) -> Cells:
        """Distance [m] of each cell from where someone who needs a width [m] gets to from a door."""
        from scipy.ndimage import distance_transform_edt, label

        if width not in self._away:
            labelled: Any = label(self.clear >= width / 2, structure=np.ones((3, 3)))
            regions, count = labelled
            near = int(ENTRY / self.cell)
            entered = np.zeros(count + 1, dtype=bool)
            for row, column in self.entries:
                box = regions[max(0, row - near) : row + near + 1, max(0, column - near) : column + near + 1]
                entered[box] = True
            entered[0] = False
            reached = entered[regions]
            far = np.full(regions.shape, np.inf)
            self._away[width] = np.asarray(distance_transform_edt(~reached)) * self.cell if reached.any() else far
        return self._away[width]

    def along(self, outline: NDArray[np.float64]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Rows and columns of cells along a closed outline [n, 2] [m]."""
        import shapely

        ring = shapely.linestrings(np.vstack((outline, outline[:1])))
        rows, columns = self._cells(shapely.get_coordinates(shapely.segmentize(ring, 2 * self.cell))).T
        return rows, columns

    def reached(self, width: float, cells: tuple[NDArray[np.intp], NDArray[np.intp]], within: float) -> bool:
        """Whether a way of a width [m] comes within a distance [m], beyond half of it, of some cells."""
        return bool((self.away(width)[cells] <= within + width / 2).any())


def _plan(survey: Survey) -> Plan:
    kept = survey.__dict__.get("_plan")
    if kept is None:
        kept = survey.__dict__["_plan"] = Plan(survey)
    return kept


def _shape(survey: Survey, thing: Body | Opening, front_only: bool = False) -> Shape:
    """The cells along a body, along its front alone, or along an opening."""
    plan = _plan(survey)
    if isinstance(thing, Opening):
        return plan.along(np.array(thing.wall.strip(thing.item.offset, thing.item.width, 0.0, 0.05)))
    if not front_only:
        return plan.along(np.array(thing.corners))
    (x, y), (nx, ny), half = thing.face("front")
    half *= 0.7
    return plan.along(np.array([(x - ny * half, y + nx * half), (x + ny * half, y - nx * half)]))


@measure
def reached(survey: Survey, thing: Body | Opening, width: float, within: float, front_only: bool = False) -> bool:
    """Whether a way of a width [m] comes within a distance [m], beyond half of it, of a thing or of its front."""
    return _plan(survey).reached(width, _shape(survey, thing, front_only), within)


@measure
def widest_way(survey: Survey, things: Any, within: float, widths: Sequence[float]) -> float:
    """The widest [m] of some ways, widest first, that leads to a thing, the least of several; 0 where none does."""
    shapes = [_shape(survey, thing) for thing in listed(things)]
    return min(next((w for w in widths if _plan(survey).reached(w, s, within)), 0.0) for s in shapes)
