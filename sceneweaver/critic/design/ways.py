"""Clear ways: from the door to windows and groups, and to what is used."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2
from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..space import floor_of
from ..survey import Survey
from .breach import breach
from .measure import applies, clear_depth, middle, named, names

Cells = NDArray[np.float64]

ENTRY = 0.6
"""Distance [m] around the middle of a door's inside within which a way begins."""

REACH = 0.4
"""Distance [m] from a way beyond half its width at which what a way leads to is reached."""

ACROSS = 1.3
"""The same [m] for a window, across the furniture below it."""

GRID = 0.1
"""Width [m] that a way may lack, as the floor is measured on a grid."""

NARROWER = (0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2)
"""Widths [m] that are tried where the wanted one leads nowhere."""

BODY = 0.5
"""Width [m] that a person needs to get to a thing, in the way of light seats or not."""

GOALS = (
    kinds.BEDS
    | kinds.SOFAS
    | kinds.DESKS
    | kinds.DINING
    | named("wardrobe fridge stove toilet vanity double_vanity corner_shower shower bathtub freestanding_bathtub")
)
"""What a way should lead to."""

BINS = named("laundry_hamper pedal_bin trash_can wastebasket recycling_bin")
"""What things are thrown into."""

STEPPED_ON = 0.15
"""Distance [m] beyond half of a person's width from which something on the floor is stepped on."""

WEDGED = 0.06
"""Gap [m] on either side up to which something is wedged between others."""

USED = named(
    "laundry_hamper pedal_bin trash_can wastebasket recycling_bin low_bookcase bookcase pouf armchair loveseat"
    " activity_table kids_table toy_chest toy_shelf cube_shelf scale wardrobe dresser desk filing_cabinet cabinet"
    " water_cooler coat_rack wine_rack locker"
)
"""What people walk up to."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for ways."""
    if survey.placed.doors and survey.standing:
        plan = Plan(survey)
        yield from _ways(survey, plan)
        yield from _unreached(survey, plan)


# ---- ways ------------------------------------------------------------------------------------------------------------


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


def _ways(survey: Survey, plan: Plan) -> Iterator[Finding]:
    if not applies(survey, "way_to_group", "way_to_window"):
        return
    width = limit("way_to_group", "width")
    groups: dict[float, list[Body]] = {}
    for body in survey.of_kind(GOALS):
        if body.item.mount != "floor":
            continue
        shape = plan.along(np.array(body.corners))
        if not plan.reached(width - GRID, shape, REACH):
            groups.setdefault(_widest(plan, shape, REACH), []).append(body)
    for wide, bodies in groups.items():
        yield breach(
            "way_to_group",
            (b.id for b in bodies),
            f"the way from the door to {names(bodies)} is {wide:g} m wide",
            measured=wide,
            allowed=(width, None),
            weight=0.5 if wide >= 0.6 else 1.0,
            suggestion=f"clear a way {width:g} m wide from the door to {names(bodies)}",
        )
    width, narrow = limit("way_to_window", "width"), {}
    for window in survey.placed.windows:
        shape = plan.along(np.array(window.wall.strip(window.item.offset, window.item.width, 0.0, 0.05)))
        if not plan.reached(width - GRID, shape, ACROSS):
            narrow[window.item.id] = _widest(plan, shape, ACROSS)
    if narrow:
        wide = min(narrow.values())
        yield breach(
            "way_to_window",
            narrow,
            f"the way from the door to {', '.join(narrow)} is {wide:g} m wide",
            measured=wide,
            allowed=(width, None),
            weight=0.5 if wide >= 0.6 else 1.0,
        )


def _widest(plan: Plan, shape: tuple[NDArray[np.intp], NDArray[np.intp]], within: float) -> float:
    return next((w for w in NARROWER if plan.reached(w, shape, within)), 0.0)


def _unreached(survey: Survey, plan: Plan) -> Iterator[Finding]:
    rule = design_rules()["reachable"]
    if not rule.applies(survey.room_type.name):
        return
    for body in survey.on_floor(USED):
        if body.item.category in BINS and (hidden := _hidden(survey, body)):
            yield breach(
                "reachable",
                (body.id, *hidden),
                f"{body.id} is {'under' if len(hidden) == 1 else 'wedged between'} {' and '.join(hidden)}",
                suggestion=f"move {body.id} to where it can be reached",
            )
            continue
        sides = np.array(body.corners)
        if body.item.category in kinds.WALL_BACKED:
            face = body.face("front")
            x, y = face.centre
            nx, ny = face.normal
            half = 0.7 * face.half
            sides = np.array([(x - ny * half, y + nx * half), (x + ny * half, y - nx * half)])
        near = STEPPED_ON if body.item.category == "scale" else rule.limits["gap"] - 0.1
        if not plan.reached(BODY, plan.along(sides), near):
            yield breach(
                "reachable",
                (body.id,),
                f"nobody who needs {BODY:g} m gets to {body.id}",
                suggestion=f"move {body.id} to where it can be reached",
            )


def _hidden(survey: Survey, body: Body) -> list[str]:
    """The table above a bin, or what it is wedged between: another thing and a wall, or two things."""
    import shapely

    box = survey.boxes[body.index]
    for other, _ in survey.near(body, 0.0):
        if other.item.category in kinds.DINING and shapely.area(box & survey.boxes[other.index]) > 0.5 * box.area:
            return [other.id]
    if body.item.category != "laundry_hamper":
        return []  # a bin stands well between others
    found = []
    for side in ("left", "right"):
        gap, other = clear_depth(survey, body, side, 0.3, lambda b: b.z[1] < 0.6 * body.z[1])
        if gap > WEDGED:
            return []
        found.append("the wall" if other is None else other.id)
    return [] if found[0] == found[1] else found
