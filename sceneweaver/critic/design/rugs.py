"""Whether rugs belong to something: under the front legs of a sofa, beyond a table and its chairs, square."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..groups import ALL_BEDS, RUGS, SEATS, groups_of
from ..survey import Survey
from .breach import breach
from .focus import HOME

UNDER = 0.02
"""Area [m2] of a piece over a rug from which on the rug is under it."""

OWNERS = SEATS | ALL_BEDS | kinds.COFFEE | kinds.DINING | frozenset(("activity_table", "train_table", "play_mat"))
"""What a rug may belong to."""

ALONE = frozenset(("runner_rug",))
"""Rugs that lie alone, as in a hall or before a sink."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Rugs that are too small for their group, or belong to none."""
    yield from _tables(survey)
    yield from _belonging(survey)
    if survey.room_type.name in HOME:
        yield from _front_legs(survey)


def _tables(survey: Survey) -> Iterator[Finding]:
    """Rugs under a table that end before its chairs do."""
    import shapely

    groups, beyond = groups_of(survey), limit("rug_beyond_table", "beyond")
    for group in groups.tables:
        for rug in groups.rugs:
            if groups.overlap(rug, group.table) < 0.5 * group.table.size[0] * group.table.size[1]:
                continue
            shape = _shape(survey, rug)
            off = [s for s in group.seats if shape.intersection(survey.boxes[s.index]).area < 0.9 * _area(survey, s)]
            edge = float(shapely.distance(shape.exterior, survey.boxes[group.table.index]))
            if off and edge < beyond - 0.05:
                yield breach(
                    "rug_beyond_table",
                    (rug.id, group.table.id, *(s.id for s in off)),
                    f"{rug.id} reaches {edge:.2f} m beyond {group.table.id}: {len(off)} chairs stand off it",
                    measured=edge,
                    allowed=(beyond, None),
                    suggestion=f"take a larger rug for {group.table.id}",
                )


def _shape(survey: Survey, rug: Body):
    """The rug in plan [m]."""
    return survey.footprint(rug)


def _area(survey: Survey, body: Body) -> float:
    return float(survey.boxes[body.index].area)


def _belonging(survey: Survey) -> Iterator[Finding]:
    """Rugs under nothing, rugs askew, and rugs that reach under what is none of their group."""
    most = limit("rug_in_a_group", "angle")
    groups = groups_of(survey)
    for rug in survey.on_floor(RUGS - ALONE):
        under = [b for b in survey.standing if b is not rug and groups.overlap(rug, b) > UNDER]
        owners = [b for b in under if b.item.category in OWNERS]
        near = [b for b, _ in survey.near(rug, 0.4) if b.item.category in OWNERS | kinds.DESKS]
        reasons, others = [], []
        if not owners and not near:
            reasons.append("lies under nothing that it could belong to")
        angle = math.degrees(float(survey.wall_angles[rug.index]))
        if angle > most and rug.item.category != "round_rug":
            reasons.append(f"is turned {angle:.0f} degrees against the walls")
        if owners:
            others = [b for b in under if b.item.category in kinds.WALL_BACKED | {"reception_desk", "bar_counter"}]
            if others:
                reasons.append(f"reaches under {', '.join(b.id for b in others[:3])}")
        if _at_door(survey, rug):
            reasons.append("lies where the door opens")
        if reasons:
            yield breach(
                "rug_in_a_group",
                (rug.id, *(b.id for b in others[:3])),
                f"{rug.id} {' and '.join(reasons)}",
                measured=angle,
                allowed=(None, most),
                suggestion=f"lay {rug.id} square under its group",
            )


def _at_door(survey: Survey, rug: Body) -> bool:
    """Whether a rug lies within the way that a door needs to open."""
    import shapely

    shape = survey.boxes[rug.index]
    return any(shapely.Polygon(door.polygon).intersection(shape).area > UNDER for door in survey.placed.doors)


def _front_legs(survey: Survey) -> Iterator[Finding]:
    """Rugs of a seating group that end before the front legs of its sofa."""
    groups, least = groups_of(survey), limit("rug_under_front_legs", "under")
    for group in groups.seatings:
        if group.rug is None or group.anchor.item.category not in kinds.SOFAS:
            continue
        strip = groups.overlap(group.rug, group.anchor) / group.anchor.size[1]
        if strip < least:
            yield breach(
                "rug_under_front_legs",
                (group.rug.id, group.anchor.id),
                f"{group.rug.id} ends before the front legs of {group.anchor.id}",
                measured=strip,
                allowed=(least, None),
                suggestion=f"lay {group.rug.id} under the front legs of {group.anchor.id}",
            )
