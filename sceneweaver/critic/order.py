"""Whether things stand in order: backs at walls, axes along walls, pictures and screens where they belong."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.assets import categories
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge.small_things import left_about
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding, moved, related
from .groups import groups_of
from .needs import table_of
from .survey import QUARTER, Survey

BACK_GAP = 0.15
"""Gap [m] between the back of a large thing and its wall that passes; curtains and skirting take some."""

SOFA_GAP = 0.6
"""The same for sofas, which may stand off a wall."""

LOFTY = 30.0
"""Floor [m2] from which a sofa may stand free, as between two parts of a large room."""

STRAIGHT, CROOKED = math.radians(1.5), math.radians(8.0)
"""Angles [rad] between which a thing looks as if it should have been parallel to a wall."""

HEIGHT_SLACK = 0.3
"""How far [m] beyond its usual heights something may hang."""

ABOVE = 0.6
"""Height [m] over a piece of furniture up to which something hangs by that piece and not by the floor."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Disorder."""
    yield from _away_from_walls(survey)
    yield from _crooked(survey)
    yield from _heights(survey)
    yield from _off_centre(survey)


# ---- walls -----------------------------------------------------------------------------------------------------------


def _away_from_walls(survey: Survey) -> Iterator[Finding]:
    for body in survey.of_kind(kinds.WALL_BACKED, kinds.SOFAS):
        if body.item.mount != "floor" or not _belongs_to_wall(survey, body):
            continue
        sofa = body.item.category in kinds.SOFAS
        most = SOFA_GAP if sofa else BACK_GAP
        if sofa and (survey.area > LOFTY or _in_a_ring(survey, body)):
            continue
        back = survey.back_wall(body)
        if back is not None and back[1] <= most and math.degrees(back[2]) <= 20:
            continue
        if _backed(survey, body, most) or _in_corner(survey, body):
            continue
        gap = back[1] if back else math.inf
        reason = (
            f"the back of {body.id} is {gap:.2f} m from the wall behind it"
            if back
            else (f"no wall is behind {body.id}")
        )
        yield finding(
            "layout",
            "away_from_wall",
            (body.id,),
            reason,
            f"put {body.id} with its back against a wall",
            points=1.0 if sofa else 1.5,
            call=related("against_wall", body.id),
        )


def _in_a_ring(survey: Survey, sofa: Body) -> bool:
    """Whether a sofa stands around a table with a wider one, which makes the group and has the wall."""
    groups = groups_of(survey).seatings
    return any(g.table is not None and sofa in g.seats and sofa is not g.anchor for g in groups)


def _belongs_to_wall(survey: Survey, body: Body) -> bool:
    """Whether nothing says that it stands elsewhere: the room's items, or the request."""
    asked = survey.program.asked_of.get(body.id)
    if any(r.subject == asked and {"middle", "window", "corner"} & set(r.targets) for r in survey.brief.relations):
        return False
    name = survey.program.item_of.get(body.id)
    if name is None:
        return True
    item = survey.room_type.item(name)
    if not item.place and item.row is None:
        return True
    if item.row == "grid":
        return False
    free = {"back_to_back", "centered_on", "front_to_front", "around", "side_by_side", "leftright_to_leftright"}
    types = {p.type for p in item.place}
    return bool(types & CATALOGUE.with_role("edge") - {"side_against_wall"}) or not types & free


def _backed(survey: Survey, body: Body, most: float) -> bool:
    """Whether something large stands close behind it: another shelf's back, a console table, a divider."""
    (x, y), (nx, ny), half = body.face("back")
    for other, gap in survey.near(body, most + 0.05):
        if other.item.mount != "floor" or gap > most:
            continue
        dx, dy = other.position[0] - x, other.position[1] - y
        if dx * nx + dy * ny > 0.02 and abs(dy * nx - dx * ny) < half and max(other.size[:2]) > half:
            return True
    return False


def _in_corner(survey: Survey, body: Body) -> bool:
    """Whether it stands across a corner of the room, as corner pieces do."""
    return "corner" in body.item.category and float(survey.wall_gaps[body.index]) < 0.1


# ---- angles ----------------------------------------------------------------------------------------------------------


def _axis_gap(survey: Survey, body: Body) -> float:
    """Least angle [rad] between a body and the walls, or the table that it belongs to."""
    best = float(survey.wall_angles[body.index])
    if seat := kinds.upright_seat(body.item.category):
        table = table_of(survey, body)
        if table is not None and "round" not in table.item.category and seat:
            best = min(best, abs(wrap_angle(body.yaw - table.yaw, QUARTER)))
    return best


def _crooked(survey: Survey) -> Iterator[Finding]:
    if len(survey.wall_axes) > 3:
        return  # a round room has no axes
    slight: list[tuple[str, float]] = []
    grave: list[tuple[Body, float]] = []
    for body in survey.standing:
        row = categories().get(body.item.category)
        d, w, _ = body.size
        round_ = abs(d - w) < 0.03 * max(d, w) and (row is None or not row.sides)
        if round_ or "round" in body.item.category or body.item.category in kinds.TALL_PLANTS:
            continue
        if left_about(body.item.category, survey.room_type.name):
            continue
        angle = _axis_gap(survey, body)
        if kinds.upright_seat(body.item.category):
            table = table_of(survey, body)
            if table is None or "round" in table.item.category or table.item.category == "conference_table":
                continue
        if STRAIGHT < angle < CROOKED:
            slight.append((body.id, math.degrees(angle)))
        elif angle >= CROOKED and (
            body.item.category in kinds.WALL_BACKED | kinds.BEDS | kinds.LONG_BEDS | kinds.SOFAS | kinds.DESKS
            or body.item.category in kinds.DINING
        ):
            grave.append((body, math.degrees(angle)))
    # one call for all: turned one by one they meet their neighbours that are askew as well
    call = ("update_rotation", {"ids": [*(b.id for b, _ in grave), *(i for i, _ in slight)], "square": True})
    for body, degrees in grave:
        yield finding(
            "layout",
            "askew",
            (body.id,),
            f"{body.id} is turned {degrees:.0f} degrees against the walls",
            f"turn {body.id} parallel to a wall",
            points=0.8 + min(1.2, 0.7 * body.size[0] * body.size[1]),
            call=call,
        )
    for body_id, degrees in slight:
        yield finding(
            "layout",
            "crooked",
            (body_id,),
            f"{body_id} is {degrees:.1f} degrees off the direction of the walls",
            f"turn {body_id} parallel to a wall",
            points=0.2 + 0.06 * degrees,
            call=call,
        )


# ---- heights ---------------------------------------------------------------------------------------------------------


def _heights(survey: Survey) -> Iterator[Finding]:
    for body in survey.bodies:
        if body.item.mount != "wall":
            continue
        low, high = _usual_heights(survey, body)
        bottom = body.z[0]
        if low - HEIGHT_SLACK <= bottom <= high + HEIGHT_SLACK or _over_furniture(survey, body):
            continue
        yield finding(
            "layout",
            "odd_height",
            (body.id,),
            f"{body.id} hangs {bottom:.2f} m above the floor; usual are {low:.2f} to {high:.2f} m",
            f"hang {body.id} at {(low + high) / 2:.2f} m",
            call=moved(body.id),
        )


def _usual_heights(survey: Survey, body: Body) -> tuple[float, float]:
    item = survey.program.item_of.get(body.id)
    given = survey.room_type.item(item).hung(body.size[2]) if item else None
    row = categories().get(body.item.category)
    low, high = given or (row.bottom if row and row.bottom else (0.0, 10.0))
    if (meant := body.item.intent.mounting_height) is not None:
        low, high = min(low, meant[0]), max(high, meant[1])
    return low, high


def _over_furniture(survey: Survey, body: Body) -> bool:
    """Whether it hangs a little over something that stands at its wall."""
    for other, _ in survey.near(body, 0.3):
        if other.item.mount in ("floor", "surface") and 0.0 <= body.z[0] - other.z[1] <= ABOVE:
            return True
    return False


def _off_centre(survey: Survey) -> Iterator[Finding]:
    """Screens on a wall that hang beside their stand."""
    for tv in survey.of_kind(("tv",)):
        if tv.item.mount != "wall":
            continue
        for stand, _ in survey.near(tv, 0.6):
            if stand.item.category != "tv_stand":
                continue
            _, aside = stand.local(tv.centre)
            if abs(aside) > 0.25 * stand.size[1]:
                yield finding(
                    "layout",
                    "off_centre",
                    (tv.id, stand.id),
                    f"{tv.id} hangs {abs(aside):.2f} m beside the middle of {stand.id}",
                    f"hang {tv.id} over the middle of {stand.id}",
                    call=related("above", tv.id, stand.id),
                )
            break
