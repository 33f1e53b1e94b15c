"""Measures of what the judge says: its violations, and how much of the room one gets to."""

from __future__ import annotations

from sceneweaver.verify import Violation
from sceneweaver.verify.solids import Body
from sceneweaver.verify.walkable import measure as access

from ..design.registry import measure
from ..survey import Survey


@measure
def violations(survey: Survey, kind: str) -> list[Violation]:
    """The violations of a kind."""
    return [v for v in survey.report.violations if v.kind == kind]


@measure
def there(survey: Survey, v: Violation) -> list[str]:
    """The ids of the objects of a violation that are in the scene."""
    return [name for name in v.objects if name in survey.placed.by_id]


@measure
def violates(survey: Survey, kind: str, *things) -> bool:
    """Whether the judge says of some things together, bodies or openings, that they violate something."""
    names = frozenset(t.id if isinstance(t, Body) else t.item.id for t in things)
    return names in survey.violated.get(kind, ())


@measure
def carried_by_companion(survey: Survey, v: Violation) -> bool:
    """Whether what is in a zone stands on a piece that may be there, as a lamp on the nightstand of a bed."""
    names = there(survey, v)
    if len(names) != 2:
        return False
    owner, other = names
    base = survey.placed.by_id[other].item.support
    while base is not None:
        if frozenset((owner, base.object)) in survey.pairs:
            return True
        base = survey.placed.by_id[base.object].item.support if base.object in survey.placed.by_id else None
    return False


@measure
def slight(survey: Survey, v: Violation, of_room: float, of_things: float, angle: float) -> bool:
    """Whether a wish that nobody stated is missed by no more than a distance [m], or an angle [deg]."""
    if v.relation is None or v.measurement is None or survey.scene.relations[v.relation.index].asked:
        return False
    if v.measurement.unit == "deg":
        return v.amount <= angle
    things = any(name in survey.placed.by_id for name in v.objects[1:])
    return v.measurement.unit == "m" and v.amount <= (of_things if things else of_room)


@measure
def weight_of(survey: Survey, v: Violation) -> float:
    """The weight of a soft relation."""
    return survey.scene.relations[v.relation.index].weight if v.relation is not None else 1.0


@measure
def left_out(survey: Survey, v: Violation) -> str:
    """The category of what was left out of the scene."""
    return next((d.category for d in survey.scene.dropped if d.id == v.objects[0]), v.objects[0])


# ---- ways ------------------------------------------------------------------------------------------------------------


@measure
def all_reached(survey: Survey) -> bool:
    """Whether a robot gets to all furniture, or it is not known to what it does."""
    share = survey.report.reachable_share
    return share is None or share >= 1.0


@measure
def unreached(survey: Survey) -> list[Body]:
    """The furniture that a robot does not get to."""
    found = None if all_reached(survey) else access(survey.placed)
    return [survey.placed.by_id[name] for name in found.unreached] if found is not None else []
