"""Ways: how wide the widest one from the doors to a thing is."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2
from sceneweaver.verify.solids import Body, Opening

from ..space import floor_of
from ..survey import Survey
from .measure import middle
from .query import listed
from .registry import measure

Cells = NDArray[np.float64]

Shape = tuple[NDArray[np.intp], NDArray[np.intp]]
"""Rows and columns of cells."""

ENTRY = 0.6
"""Distance [m] around the middle of a door's inside within which a way begins."""

NARROWER = (0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2)
"""Widths [m] that are tried where the wanted one leads nowhere."""


class Plan:
    """The floor as a grid with the distance [m] of each cell from walls and furniture, and from ways of a width."""

    def __init__(self, survey: Survey) -> None:
        floor = floor_of(survey)
        self.cell, self.origin, self.frame = floor.cell, np.asarray(floor.origin), SE2(yaw=floor.turn)
        self.clear = self._distance(floor.inside & ~floor.taken)
        self.entries = self._cells(np.array([middle(door, 0.5) for door in survey.placed.doors]))
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
        rows, columns = self._cells(_dense(outline, self.cell)).T
        return rows, columns

    def reached(self, width: float, cells: tuple[NDArray[np.intp], NDArray[np.intp]], within: float) -> bool:
        """Whether a way of a width [m] comes within a distance [m], beyond half of it, of some cells."""
        return bool((self.away(width)[cells] <= within + width / 2).any())


def _dense(outline: NDArray[np.float64], step: float) -> NDArray[np.float64]:
    """Points [n, 2] along a closed outline at most two steps [m] apart."""
    ends = np.roll(outline, -1, axis=0)
    counts = np.array(
        [1 + int(math.dist(a, b) / (2 * step)) for a, b in zip(outline.tolist(), ends.tolist(), strict=True)]
    )
    edge = np.repeat(np.arange(len(outline)), counts)
    number = np.arange(len(edge)) - np.repeat(np.cumsum(counts) - counts, counts)
    return outline[edge] + (ends - outline)[edge] * number[:, None] / counts[edge, None]


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
def widest_way(survey: Survey, things: Any, within: float) -> float:
    """Width [m] of the widest of some ways to a thing, the least of several; 0 where there is none."""
    return min(_widest(survey, thing, within) for thing in listed(things))


def _widest(survey: Survey, thing: Body | Opening, within: float) -> float:
    shape = _shape(survey, thing)
    return next((w for w in NARROWER if _plan(survey).reached(w, shape, within)), 0.0)


@measure
def ways_to(survey: Survey, things: list[Body], within: float) -> list[float]:
    """The widths [m] of the ways to some things, each once."""
    return list(dict.fromkeys(_widest(survey, thing, within) for thing in listed(things)))
