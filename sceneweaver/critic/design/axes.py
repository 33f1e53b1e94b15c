"""Whether what belongs together shares an axis: sofa, table, rug and screen; bed, rug, picture and pendant; pairs."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..groups import HUNG, groups_of
from ..survey import Survey
from .breach import breach

CORNERED = frozenset(("sectional_sofa", "chaise_longue"))
"""Seats without an axis of their own: their table stands before the longer side."""

STAND_REACH = 0.6
"""Gap [m] up to which a screen on the wall belongs to the stand before it."""

STANDS = frozenset(("tv_stand", "sideboard", "media_console", "low_bookcase"))

FLANKING = frozenset(("nightstand", "side_table", "floor_lamp", "tripod_lamp"))
"""What stands in pairs beside a bed or a sofa."""


def faults(survey: Survey) -> Iterator[Finding]:
    """What is off an axis that it should share."""
    yield from _sofas(survey)
    yield from _screens(survey)
    yield from _beds(survey)
    yield from _pairs(survey)


def _off(rule: str, body: Body, base: Body, aside: float, axis: str) -> Iterator[Finding]:
    """A breach where a body is too far off an axis."""
    most = limit(rule, "offset")
    if abs(aside) > most:
        yield breach(
            rule,
            (body.id, base.id),
            f"{body.id} is {abs(aside):.2f} m off the axis of {axis}",
            measured=abs(aside),
            allowed=(None, most),
            suggestion=f"put {body.id} on the axis of {axis}",
        )


def _sofas(survey: Survey) -> Iterator[Finding]:
    for group in groups_of(survey).seatings:
        sofa = group.anchor
        if sofa.item.category not in kinds.SOFAS - CORNERED or len(group.seats) == 1 and group.table is None:
            continue
        for rule, body in (
            ("table_on_sofa_axis", group.table),
            ("rug_on_sofa_axis", group.rug),
            ("focus_on_sofa_axis", group.focus),
        ):
            if body is not None:
                yield from _off(rule, body, sofa, sofa.local(body.centre)[1], sofa.id)
    for sofa in survey.of_kind(kinds.SOFAS):
        yield from _hung(survey, sofa, [])


def _screens(survey: Survey) -> Iterator[Finding]:
    for screen in survey.of_kind(("tv", "tv_on_stand")):
        stand = None
        if screen.item.support is not None:
            stand = survey.placed.by_id.get(screen.item.support.object)
        elif screen.item.mount == "wall":
            stand = next((b for b, _ in survey.near(screen, STAND_REACH) if b.item.category in STANDS), None)
        if stand is not None and stand.item.category in STANDS and stand.size[1] > screen.size[1]:
            yield from _off("screen_on_stand_axis", screen, stand, stand.local(screen.centre)[1], stand.id)


def _beds(survey: Survey) -> Iterator[Finding]:
    for group in groups_of(survey).sleepings:
        bed, rug = group.bed, group.rug
        if rug is not None and bed.item.category in kinds.BEDS and groups_of(survey).overlap(rug, bed) > 0.0:
            yield from _off("rug_on_bed_axis", rug, bed, bed.local(rug.centre)[1], bed.id)
        for pendant in group.pendants:
            yield from _off("pendant_on_bed_axis", pendant, bed, bed.local(pendant.centre)[1], bed.id)
        if bed.item.category in kinds.BEDS:
            yield from _hung(survey, bed, list(group.over))


def _hung(survey: Survey, base: Body, over: list[Body]) -> Iterator[Finding]:
    """What hangs over a bed or sofa, all of it together, off its axis."""
    half_d, half_w = base.size[0] / 2, base.size[1] / 2
    over = over or [
        b
        for b in survey.of_kind(HUNG)
        if b.item.mount == "wall"
        and -half_d - 0.4 <= base.local(b.centre)[0] < -half_d + 0.3
        and abs(base.local(b.centre)[1]) < half_w
    ]
    if over:
        sides = [base.local(b.centre)[1] + s * b.size[1] / 2 for b in over for s in (-1, 1)]
        yield from _off("picture_on_bed_axis", over[0], base, (min(sides) + max(sides)) / 2, base.id)


def _pairs(survey: Survey) -> Iterator[Finding]:
    """Two of a kind on either side of a bed or sofa that do not mirror each other."""
    most = limit("pairs_mirrored", "offset")
    for base in survey.of_kind(kinds.BEDS, kinds.SOFAS):
        flanks: dict[str, list[Body]] = defaultdict(list)
        for body, _ in survey.near(base, 0.5):
            if body.item.category in FLANKING and abs(base.local(body.centre)[1]) > base.size[1] / 2:
                flanks[body.item.category].append(body)
        for pair in flanks.values():
            if len(pair) != 2:
                continue
            (ahead, left), (ahead_2, right) = (base.local(b.centre) for b in pair)
            if left * right > 0.0:
                continue
            off = max(abs(ahead - ahead_2), abs(left + right))
            if off > most:
                yield breach(
                    "pairs_mirrored",
                    (pair[0].id, pair[1].id, base.id),
                    f"{pair[0].id} and {pair[1].id} are {off:.2f} m from mirroring each other about {base.id}",
                    measured=off,
                    allowed=(None, most),
                    suggestion=f"put {pair[0].id} and {pair[1].id} at the same distance from {base.id}",
                )
