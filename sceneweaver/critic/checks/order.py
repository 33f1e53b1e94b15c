"""Measures of order: backs at walls, axes along walls, usual heights, equals in rows."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from sceneweaver.assets import categories
from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from ..design.registry import measure
from ..groups import groups_of
from ..seats import seat_like, table_of
from ..survey import QUARTER, Survey

ELSEWHERE = {"back_to_back", "centered_on", "front_to_front", "around", "side_by_side", "leftright_to_leftright"}
"""Relations of a room's item that put its instances anywhere but at a wall."""

# ---- walls -----------------------------------------------------------------------------------------------------------


@measure
def in_ring(survey: Survey, sofa: Body) -> bool:
    """Whether a sofa stands around a table with a wider one, which makes the group and has the wall."""
    groups = groups_of(survey).seatings
    return any(g.table is not None and sofa in g.seats and sofa is not g.anchor for g in groups)


@measure
def belongs_to_wall(survey: Survey, o: Body) -> bool:
    """Whether nothing says that a body stands elsewhere than at a wall: the room's items, or the request."""
    asked = survey.program.asked_of.get(o.id)
    if any(
        r.subject == asked and {"middle", "window", "corner"} & {t.partition(":")[0] for t in r.targets}
        for r in survey.brief.relations
    ):
        return False
    name = survey.program.item_of.get(o.id)
    item = survey.room_type.item(name) if name is not None else None
    if item is None or (not item.place and item.row is None):
        return True
    if item.row == "grid":
        return False
    types = {p.type for p in item.place}
    return bool(types & CATALOGUE.with_role("edge") - {"side_against_wall"}) or not types & ELSEWHERE


@measure
def backed(survey: Survey, o: Body, gap: float, past: float, behind: float) -> bool:
    """Whether something large on the floor is within a gap [m] behind a body: another's back, a console, a divider.

    Its middle is more than ``behind`` [m] beyond the back; boxes are looked for ``past`` [m] farther out.
    """
    (x, y), (nx, ny), half = o.face("back")
    for other, away in survey.near(o, gap + past):
        if other.item.mount != "floor" or away > gap:
            continue
        dx, dy = other.position[0] - x, other.position[1] - y
        if dx * nx + dy * ny > behind and abs(dy * nx - dx * ny) < half and max(other.size[:2]) > half:
            return True
    return False


@measure
def wall_axes(survey: Survey) -> int:
    """How many directions the walls have, modulo a quarter turn."""
    return len(survey.wall_axes)


@measure
def off_axes(survey: Survey, o: Body) -> float:
    """Least angle [deg] between the axes of a body and those of the walls, or of the table that it is a seat of."""
    best = float(survey.wall_angles[o.index])
    table = table_of(survey, o) if has_role(o.item.category, "upright_seat") else None
    if table is not None and "round" not in table.item.category:
        best = min(best, abs(wrap_angle(o.yaw - table.yaw, QUARTER)))
    return math.degrees(best)


class Heights(NamedTuple):
    """From where to where the lower end of something on a wall usually is [m]."""

    low: float
    high: float


@measure
def usual_heights(survey: Survey, o: Body, ceiling: float) -> Heights:
    """Where the lower end of a body on a wall usually is: by its item of the room, its category, and its intent.

    Of what says none of these anything up to a ceiling [m] is usual."""
    name = survey.program.item_of.get(o.id)
    given = survey.room_type.item(name).hung(o.size[2]) if name else None
    row = categories().get(o.item.category)
    low, high = given or (row.bottom if row and row.bottom else (0.0, ceiling))
    if (meant := o.item.intent.mounting_height) is not None:
        low, high = min(low, meant[0]), max(high, meant[1])
    return Heights(low, high)


# ---- rows ------------------------------------------------------------------------------------------------------------


@measure
def sets_of_equals(survey: Survey) -> list[tuple[Body, ...]]:
    """What stands, by category, and seats by their table; no plants, and no seats without a table."""
    sets: dict[tuple[str, str | None], list[Body]] = defaultdict(list)
    for body in survey.standing:
        seat = seat_like(body)
        table = table_of(survey, body) if seat else None
        if not has_role(body.item.category, "tall_plant") and not (seat and table is None):
            sets[body.item.category, table.id if table else None].append(body)
    return [tuple(bodies) for bodies in sets.values()]


class Offset(NamedTuple):
    """How far [m] one body is out of line with another."""

    one: Body
    other: Body
    offset: float


@measure
def out_of_line(
    survey: Survey, bodies: Sequence[Body], least: float, most: float, reach: float, angle: float, along: float,
    beside: float,
) -> list[Offset]:  # fmt: skip
    """Near neighbours of one direction, up to an angle [deg], that nearly stand in line: off by ``least`` to ``most``.

    Neighbours are from ``along`` to ``reach`` [m] on, and up to ``beside`` [m] off. Seats at one table are compared
    side by side only: how far each is pushed in. Things of different sizes are in line where fronts or backs are.
    """
    centres = np.array([b.centre for b in bodies])
    yaws = np.array([b.yaw for b in bodies])
    halves = np.array([b.size[:2] for b in bodies]) / 2
    seats = seat_like(bodies[0]) and table_of(survey, bodies[0]) is not None
    found = []
    for body in bodies:
        ahead, aside = body.frame.to_local(centres).T
        same = np.abs(wrap_angle(yaws - body.yaw, QUARTER)) < math.radians(angle)
        if seats:
            same &= np.cos(yaws - body.yaw) > 0.5
        turned = np.abs(np.cos(yaws - body.yaw)) < 0.5
        for k, (on, across) in enumerate(((aside, ahead), (ahead, aside))[: 1 if seats else 2]):
            mates = np.flatnonzero(same & (on > along) & (on < reach) & (np.abs(across) < beside))
            if not len(mates):
                continue
            j = int(mates[np.argmin(on[mates])])
            wider = float(halves[j, 1 - k if turned[j] else k]) - body.size[k] / 2
            off = min(abs(float(across[j]) + edge * wider) for edge in (-1, 0, 1))  # a front, the middle or a back
            if least < off < most:
                found.append(Offset(body, bodies[j], off))
    return found


@measure
def pair_ids(_: Survey, pairs: Iterable[Offset]) -> list[str]:
    """The ids of all that some pairs are about, sorted."""
    return sorted({b.id for pair in pairs for b in pair[:2]})
