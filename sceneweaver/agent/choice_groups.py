"""Terms of design quality for groups: seats around a sofa, beds with their own, machines in rows, pieces of a kind."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from itertools import combinations

from sceneweaver.critic import kinds
from sceneweaver.critic.design.axes import CORNERED, FLANKING
from sceneweaver.critic.design.focus import HOME
from sceneweaver.critic.design.gym import CARDIO, MATS
from sceneweaver.critic.design.seating import ARMCHAIRS, FOOTRESTS, LOW_TABLES
from sceneweaver.critic.design.workplaces import BLOCKS
from sceneweaver.critic.groups import ALL_BEDS, ANCHORS, FOCI, HUNG, REACH, RUGS, SEATS
from sceneweaver.knowledge.design_rules import limit
from sceneweaver.layout import QualityTerm
from sceneweaver.scene import SceneObject

from .choice_rules import Rules

LOOKING = kinds.LOUNGE - {"bean_bag"}
"""Seats with a direction to look in."""

IN_ROWS = BLOCKS | frozenset(("bookcase", "pantry_shelf"))

LAMPS = frozenset(("pendant", "chandelier", "ceiling_light"))

OFF = 0.3
"""Distance [m] beyond what is allowed at which something off its axis loses all points."""


def terms(rules: Rules) -> Iterator[QualityTerm]:
    """The terms of all groups of a scene."""
    for sofa in rules.of_kind(kinds.SOFAS):
        yield from _sofa(rules, sofa)
    yield from _seats(rules)
    for bed in rules.of_kind(kinds.BEDS):
        yield from _bed(rules, bed)
    for base in rules.of_kind(kinds.BEDS, kinds.SOFAS):
        yield from _flanks(rules, base)
    yield from _lamps(rules)
    yield from _sets(rules)
    yield from _apart(rules)


def _axis(rules: Rules, rule: str, base: SceneObject, o: SceneObject) -> Iterator[QualityTerm]:
    yield from rules.term(rule, "lateral", base.id, o.id, high=limit(rule, "offset"), span=OFF)


def _around(rules: Rules, sofa: SceneObject) -> list[SceneObject]:
    """A sofa and its coffee tables."""
    tables = rules.tied(sofa, kinds.COFFEE)
    if not tables and len(rules.of_kind(kinds.SOFAS)) == 1:
        tables = rules.of_kind(kinds.COFFEE)
    return [sofa, *tables]


def _sofa(rules: Rules, sofa: SceneObject) -> Iterator[QualityTerm]:
    """What shares a sofa's axis, and its table's distance."""
    middle = _around(rules, sofa)
    low, high = (limit("coffee_table_distance", name) for name in ("low", "high"))
    for table in middle[1:]:
        if sofa.category not in CORNERED:
            yield from _axis(rules, "table_on_sofa_axis", sofa, table)
        yield from rules.term("coffee_table_distance", "gap", sofa.id, table.id, low=low, high=high, span=0.2)
    rugs = [rug for rug in rules.of_kind(RUGS) if any(rug in rules.tied(o, RUGS) for o in middle)]
    under = limit("rug_under_front_legs", "under")
    for rug in rugs:
        yield from rules.term("rug_under_front_legs", "gap", rug.id, sofa.id, high=-under, span=0.2)
        if sofa.category not in CORNERED:
            yield from _axis(rules, "rug_on_sofa_axis", sofa, rug)
    if sofa.category not in CORNERED:
        for focus in rules.of_kind(FOCI)[:1]:
            yield from _axis(rules, "focus_on_sofa_axis", sofa, focus)
        for picture in rules.tied(sofa, HUNG):
            yield from _axis(rules, "picture_on_bed_axis", sofa, picture)


def _seats(rules: Rules) -> Iterator[QualityTerm]:
    """Where the seats of groups look, and that none stands alone."""
    foci = rules.of_kind(FOCI)
    sees, back = (math.radians(limit(rule, "angle")) for rule in ("seat_sees_focus", "back_to_focus"))
    reach, angle = limit("armchair_in_group", "distance"), math.radians(limit("armchair_in_group", "angle"))
    for seat in rules.of_kind(SEATS):
        if seat.mount != "floor":
            continue
        if rules.room in HOME and seat.category in LOOKING:
            for focus in foci[:1]:
                below = [o.id for o in rules.tied(focus, kinds.WALL_BACKED)]
                yield from rules.term("seat_sees_focus", "bearing", seat.id, focus.id, high=sees, span=0.5)
                yield from rules.term("back_to_focus", "bearing", seat.id, focus.id, high=back - 0.2, span=0.2)
                yield from rules.term(
                    "focus_unblocked",
                    "screened",
                    *(seat.id, focus.id, *below),
                    high=0.02,
                    span=0.1,
                    height=limit("focus_unblocked", "eye"),
                )
        tables = rules.tied(seat, kinds.COFFEE)
        if seat.category not in ANCHORS:
            for table in tables[:1]:
                yield from rules.term("armchair_in_group", "gap", seat.id, table.id, high=reach, span=0.5)
                if seat.category in LOOKING:
                    yield from rules.term("armchair_in_group", "bearing", seat.id, table.id, high=angle, span=0.5)
    yield from _alone(rules)
    for focus in foci:
        stand = [o.id for o in rules.tied(focus, kinds.WALL_BACKED)]
        clear = limit("before_focus", "clear")
        others = [*stand, *rules.movable]
        yield from rules.term("before_focus", "clear", focus.id, *others, low=clear, span=clear, high=1e5)


def _alone(rules: Rules) -> Iterator[QualityTerm]:
    """Footrests before no seat, sofas and benches without a table, side tables off the arms of their seats."""
    reach, ahead = limit("seat_in_a_group", "reach"), limit("table_beside_seat", "ahead")
    served = rules.of_kind(kinds.COFFEE, ALL_BEDS, kinds.LOUNGE, ("dressing_table", "vanity"))
    tables = rules.of_kind(LOW_TABLES, kinds.SEATED_AT - {"desk"})
    for wanted, near in ((FOOTRESTS, served), (ANCHORS, tables)):
        for o in rules.of_kind(wanted):
            others = [other.id for other in near if other.id != o.id]
            if o.mount == "floor" and others:
                yield from rules.term("seat_in_a_group", "nearest", o.id, *others, high=reach, span=0.3)
    if rules.room in HOME:  # an armchair of its own stays out of the group that it would not fit
        group = rules.of_kind(kinds.SOFAS, kinds.COFFEE)
        for o in rules.of_kind(ARMCHAIRS):
            if group and not rules.tied(o, kinds.COFFEE):
                others = [other.id for other in group]
                yield from rules.term("armchair_in_group", "nearest", o.id, *others, low=REACH, span=0.3)
    for table in rules.of_kind(("side_table",)):
        for seat in rules.tied(table, kinds.LOUNGE)[:1]:
            yield from rules.term("table_beside_seat", "ahead", seat.id, table.id, low=-ahead, high=ahead, span=0.2)


def _bed(rules: Rules, bed: SceneObject) -> Iterator[QualityTerm]:
    """What shares a bed's axis."""
    for rug in rules.tied(bed, RUGS):
        yield from _axis(rules, "rug_on_bed_axis", bed, rug)
    for picture in rules.tied(bed, HUNG):
        yield from _axis(rules, "picture_on_bed_axis", bed, picture)
    for lamp in rules.tied(bed, LAMPS):
        yield from _axis(rules, "pendant_on_bed_axis", bed, lamp)


def _flanks(rules: Rules, base: SceneObject) -> Iterator[QualityTerm]:
    """Two of a kind beside a bed or a sofa."""
    pairs: dict[str, list[str]] = defaultdict(list)
    for o in rules.tied(base, FLANKING):
        pairs[o.category].append(o.id)
    for pair in pairs.values():
        if len(pair) == 2:
            most = limit("pairs_mirrored", "offset")
            yield from rules.term("pairs_mirrored", "mirrored", *pair, base.id, high=most, span=OFF)


def _lamps(rules: Rules) -> Iterator[QualityTerm]:
    """Lamps over the middle of their tables."""
    most = limit("lamp_over_table", "offset")
    for lamp in rules.of_kind(LAMPS):
        for table in rules.tied(lamp, kinds.SEATED_AT, kinds.COFFEE)[:1]:
            if len(rules.tied(table, LAMPS)) > 1:
                continue  # a row of lamps has its middle elsewhere
            for kind, low in (("lateral", None), ("ahead", -most)):
                yield from rules.term(
                    "lamp_over_table", kind, table.id, lamp.id, low=low, high=most, span=0.5, share=0.5
                )


def _sets(rules: Rules) -> Iterator[QualityTerm]:
    """Pieces of a kind that belong side by side: lockers, mats, machines."""
    kinds_: dict[str, list[SceneObject]] = defaultdict(list)
    for o in rules.of_kind(IN_ROWS, MATS, CARDIO):
        if o.mount == "floor":
            kinds_[o.category].append(o)
    gap = limit("machines_in_rows", "gap")
    for category, pieces in kinds_.items():
        for o in pieces if len(pieces) > 1 else ():
            others = [other.id for other in pieces if other is not o]
            if category in MATS:
                most = limit("mats_together", "gap")
                yield from rules.term("mats_together", "nearest", o.id, *others, high=most, span=0.5)
            elif category in CARDIO:
                yield from rules.term("machines_in_rows", "nearest", o.id, *others, high=gap, span=0.5)
            else:
                most = limit("row_contiguous", "gap")
                yield from rules.term("row_contiguous", "nearest", o.id, *others, high=most, span=0.3)
        if category in CARDIO:
            yield from _row(rules, pieces)
    clear = limit("cardio_clear_behind", "clear")
    for o in rules.of_kind(("treadmill",)):
        yield from rules.term("cardio_clear_behind", "clear", o.id, *rules.movable, low=clear, span=clear, side=2)
    sights = [w.id for w in rules.scene.room.windows]
    sights += [o.id for o in rules.of_kind(("tv", "wall_mirror")) if o.category == "tv" or o.size[1] > 1.5]
    for o in rules.of_kind(CARDIO) if sights else ():
        angle = math.radians(limit("cardio_view", "angle"))
        yield from rules.term("cardio_view", "bearing", o.id, *sights, high=angle, span=0.3)


def _row(rules: Rules, pieces: list[SceneObject]) -> Iterator[QualityTerm]:
    """Machines abreast of the first of their kind, all the same way."""
    angle, off = math.radians(limit("machines_in_rows", "angle")), limit("machines_in_rows", "offset")
    for o in pieces[1:]:
        first = pieces[0].id
        yield from rules.term("machines_in_rows", "turned", first, o.id, high=angle, span=0.2)
        yield from rules.term("machines_in_rows", "ahead", first, o.id, low=-off, high=off, span=OFF)


def _apart(rules: Rules) -> Iterator[QualityTerm]:
    """Tables and desks of different groups that touch."""
    least = 3 * limit("pieces_apart", "gap")
    tables = [o for o in rules.of_kind(kinds.SEATED_AT) if o.mount == "floor"]
    for a, b in combinations(tables[:12], 2):
        if a.category != b.category and b.id not in rules.ties.get(a.id, ()):
            yield from rules.term("pieces_apart", "gap", a.id, b.id, low=least, span=least)
