"""How a room is filled: empty floor, empty shelves, and how many small things there are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.knowledge.design_rules import design_rules, limit

from .. import kinds
from ..finish import supports
from ..grade import Finding
from ..rows import UNITS
from ..space import floor_of
from ..survey import Survey
from .bath import BASINS, BATHS, SHOWERS
from .breach import breach
from .clearance import OPENED
from .focus import HOME
from .measure import strip

HOMELIKE = HOME | frozenset(
    ("bedroom", "childrens_room", "nursery", "teen_bedroom", "dining_room", "study", "bathroom", "kitchen")
)
"""Rooms in which free floor has to be a way."""

GYMS = frozenset(("gym", "home_gym", "yoga_studio"))
"""Rooms in which people need free floor."""

SHELVES = frozenset(
    ("bookcase", "low_bookcase", "cube_shelf", "ladder_shelf", "display_cabinet", "library_shelf", "corner_shelf")
) | frozenset(("toy_shelf", "metal_shelf", "pantry_shelf", "tv_stand", "wall_shelf"))

STOOD_AT = OPENED | UNITS | BASINS | BATHS | SHOWERS
"""What someone uses who stands before it."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for how full a room is."""
    lean = bool(survey.brief.only) or survey.brief.density == "sparse"
    if not lean:
        yield from _floor(survey)
        yield from _shelves(survey)
        yield from _small(survey)


def largest_allowed(room: str) -> float:
    """Side [m] of the largest free square that is no fault in a kind of room."""
    kind = "side" if room in HOMELIKE - {"kitchen"} else "gym" if room in GYMS else "public"
    return limit("no_empty_floor", kind)


def free_square(survey: Survey) -> tuple[float, tuple[float, float]]:
    """Side [m] of the largest square of floor, along the walls, with nothing on it; and its middle (x, y) [m]."""
    from scipy.ndimage import distance_transform_cdt

    floor = floor_of(survey)
    free = np.pad(floor.inside & ~floor.taken & ~_worked_on(survey), 1)
    if not free.any():
        return 0.0, (0.0, 0.0)
    distances: Any = distance_transform_cdt(free, metric="chessboard")
    steps = distances[1:-1, 1:-1]
    row, column = np.unravel_index(int(np.argmax(steps)), steps.shape)
    return 2 * int(steps.max()) * floor.cell, floor.world(row + 0.5, column + 0.5)


def _worked_on(survey: Survey) -> NDArray[np.bool_]:
    """The floor of a home on which one enters, or stands to use something: a mask like those of `Floor`."""
    import shapely

    depth = limit("no_empty_floor", "stand")
    floor = floor_of(survey)
    if survey.room_type.name not in HOMELIKE:
        return np.zeros_like(floor.inside)
    areas = [shapely.Polygon(zone) for zone in survey.placed.opening_zones.xy[: len(survey.placed.doors)]]
    areas += [strip(body, "front", depth, 1.0) for body in survey.on_floor(STOOD_AT)]
    rows, columns = np.indices(floor.inside.shape)
    x, y = floor.world(rows + 0.5, columns + 0.5)
    return np.asarray(shapely.contains_xy(shapely.union_all(areas), x, y))


def _floor(survey: Survey) -> Iterator[Finding]:
    most = largest_allowed(survey.room_type.name)
    side, (x, y) = free_square(survey)
    if side > most:
        yield breach(
            "no_empty_floor",
            (),
            f"a square of {side:.1f} m around ({x:.1f}, {y:.1f}) is empty",
            measured=side,
            allowed=(None, most),
            weight=min(2.0, side / most),
            suggestion="spread the furniture over the room, or add a group there",
        )


def _shelves(survey: Survey) -> Iterator[Finding]:
    least = limit("shelves_filled", "things")
    for body in supports(survey):
        if body.item.category not in SHELVES:
            continue
        things = len(survey.carried.get(body.id, ()))
        if things < min(least, 2.0 * len(body.item.surfaces)):
            yield breach(
                "shelves_filled",
                (body.id,),
                f"{things} things stand in {body.id}",
                measured=float(things),
                allowed=(least, None),
                suggestion=f"fill {body.id}",
                call=("add_crowd", {"supports": [body.id]}),
            )


def _small(survey: Survey) -> Iterator[Finding]:
    wanted = design_rules()["enough_small_things"].limits.get(survey.room_type.name)
    if wanted is None:
        return
    things = [b for b in survey.bodies if b.item.mount == "surface"]
    if len(things) < wanted:
        bases = [b.id for b in supports(survey) if kinds.carries(b.item.category)]
        yield breach(
            "enough_small_things",
            (),
            f"{len(things)} small things; such a room has at least {wanted:.0f}",
            measured=float(len(things)),
            allowed=(wanted, None),
            weight=1.0 - len(things) / wanted,
            suggestion="put more on tables and shelves",
            call=("add_tabletop", {"supports": bases}) if bases else None,
        )
