"""What the judge's report says, as faults: collisions, floating things, blocked ways, broken relations."""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.knowledge.small_things import left_about
from sceneweaver.verify import Violation
from sceneweaver.verify.walkable import measure

from . import kinds
from .grade import Finding, finding, moved
from .survey import Survey

WALKABLE, REACHABLE = 0.9, 0.97
"""Shares of the free floor, and of the furniture, that a person should get to."""

SLIGHT, SLIGHT_DEGREES = 1.0, 30.0
"""How far what is merely wished for of a wall, door or window may be off [m] [degrees] before anyone sees it."""

BESIDE = 0.6
"""The same [m] of a place beside something."""

NEEDED = 0.8
"""Points for each piece that the room needs, or that was asked for, which nobody gets to."""

SOLID = ("collision", "out_of_bounds", "unsupported")


def faults(survey: Survey) -> Iterator[Finding]:
    """All that the report holds against the scene."""
    for violation in survey.report.violations:
        yield from _violation(survey, violation)
    yield from _ways(survey)


def _violation(survey: Survey, v: Violation) -> Iterator[Finding]:
    ids = tuple(name for name in v.objects if name in survey.placed.by_id)
    again = moved(*ids)
    match v.kind:
        case "collision" | "out_of_bounds" | "unsupported":
            floating = v.kind == "unsupported"
            fix = "set it down on what carries it" if floating else f"lay out {' and '.join(ids)} again"
            yield finding("layout", v.kind, ids, v.detail, fix, points=2.0, grave=True, call=again)
            points = 2.0 if floating else 1.0
            yield finding("realism", v.kind, ids, v.detail, fix, points=points, grave=floating, call=again)
        case "blocked_zone" if len(ids) == 2 and _on_companion(survey, *ids):
            return
        case "blocked_zone" | "blocked_opening":
            fix = f"move {ids[-1]} out of the way" if ids else "clear the way"
            points = min(2.0, 1.2 + 2.0 * v.amount)
            yield finding("layout", v.kind, v.objects, v.detail, fix, points=points, grave=True, call=moved(*ids[-1:]))
        case "relation":
            fix = f"lay out {v.objects[0]} again so that it holds"
            yield finding("layout", "broken_relation", v.objects, v.detail, fix, call=again)
        case "soft_relation" if _slight(survey, v):
            return
        case "soft_relation":
            yield finding(
                "layout", "soft_relation", v.objects, v.detail, points=min(0.8, 0.5 * _weight(survey, v)), call=again
            )
        case "dropped":
            why = next((d.category for d in survey.scene.dropped if d.id == v.objects[0]), v.objects[0])
            fix = f"make room for the {why} and add it again"
            for criterion in ("completion", "alignment"):
                call = ("add_objects", {"objects": [{"category": why, "count": 1}]})
                yield finding(criterion, "dropped", v.objects, v.detail, fix, call=call)


def _on_companion(survey: Survey, owner: str, other: str) -> bool:
    """Whether something stands on a piece that may stand in the owner's zone, as a lamp on the nightstand of a bed."""
    base = survey.placed.by_id[other].item.support
    while base is not None:
        if frozenset((owner, base.object)) in survey.pairs:
            return True
        base = survey.placed.by_id[base.object].item.support if base.object in survey.placed.by_id else None
    return False


def _needs_no_way(survey: Survey, name: str) -> bool:
    """Whether it is one of the things that need no way: traces of life, and plants."""
    category = survey.scene.object(name).category
    return left_about(category, survey.room_type.name) or "plant_group" in kinds.groups_of(category)


def _slight(survey: Survey, v: Violation) -> bool:
    """Whether a wish that nobody stated is missed by so little that it does not show."""
    if v.relation is None or v.measurement is None or survey.scene.relations[v.relation.index].asked:
        return False
    if v.measurement.unit == "deg":
        return v.amount <= SLIGHT_DEGREES
    of_room = not any(name in survey.placed.by_id for name in v.objects[1:])
    return v.measurement.unit == "m" and v.amount <= (SLIGHT if of_room else BESIDE)


def _weight(survey: Survey, v: Violation) -> float:
    """The weight of a soft relation."""
    return survey.scene.relations[v.relation.index].weight if v.relation is not None else 1.0


def _ways(survey: Survey) -> Iterator[Finding]:
    report = survey.report
    walk, reach = report.walkable_share, report.reachable_share
    if walk is not None and walk < WALKABLE:
        yield finding(
            "layout",
            "unwalkable",
            (),
            f"{walk:.0%} of the free floor can be reached from the door",
            "lay out the room again with wider ways",
            points=0.5 + 8.0 * (WALKABLE - walk),
            grave=walk < 0.7,
            call=moved(),
        )
    if reach is not None and reach < 1.0:
        access = measure(survey.placed)
        missed = [n for n in access.unreached if not _needs_no_way(survey, n)] if access is not None else []
        reach = 1.0 - len(missed) / max(1, len([o for o in survey.scene.objects if o.mount == "floor"]))
        grave = [
            object_id for object_id in missed if survey.scene.object(object_id).intent.priority in ("asked", "needed")
        ]
        which = f", not {', '.join(missed[:4])}" if missed else ""
        if grave or reach < REACHABLE:
            yield finding(
                "functionality",
                "unreachable",
                (),
                f"{reach:.0%} of the furniture can be reached from the door{which}",
                "lay out the room again so that all furniture can be reached",
                points=0.3 + 5.0 * max(0.0, REACHABLE - reach) + NEEDED * len(grave),
                grave=reach < 0.7,
                call=moved(),
            )
