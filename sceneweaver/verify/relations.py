"""Whether a relation holds, and if not, what is off and by how much.

Types of the catalogue are judged by the rows of `sceneweaver.rules` and the judge's own measures
(`sceneweaver.verify.measures`); types that users register bring a function of their own.
"""

from __future__ import annotations

from collections.abc import Callable

from sceneweaver.io import InputError
from sceneweaver.scene import Relation
from sceneweaver.scene.catalogue import BUILT_IN, CATALOGUE
from sceneweaver.verify.case import Case
from sceneweaver.verify.measure import HOLDS, Judgement, fails
from sceneweaver.verify.measures import judge_ways
from sceneweaver.verify.solids import Placed
from sceneweaver.verify.support import rest

Judge = Callable[[Case], "Judgement | bool"]

JUDGES: dict[str, Judge] = {}
"""The judges of registered relation types."""


def judge_relation(placed: Placed, relation: Relation) -> Judgement:
    """Judge one relation of the scene. A relation of an object that was dropped does not hold."""
    spec, function = CATALOGUE.get(relation.type), JUDGES.get(relation.type)
    if spec is None or not (spec.ways or function):
        raise InputError(
            f"relation type {relation.type!r} has no judge; give it one with sceneweaver.verify.register_judge"
        )
    kind, target = spec.target_kind, relation.target
    named = {"object": (target,), "objects": target or ()}.get(kind, ())
    for name in (relation.subject, *named):
        if name not in placed.by_id:
            return fails(f"{name} is not in the scene")
    case = Case.of(placed, relation)
    if function is None:
        held = next((row for way in spec.ways for row in way.rows if row.measure == "carried"), None)
        return judge_ways(case) if held is None else _on_surface(case, held.of == "inner")
    judgement = function(case)
    if isinstance(judgement, Judgement):
        return judgement
    return HOLDS if judgement else fails("does not hold")


def nearly_holds(placed: Placed, relation: Relation, slack: float) -> bool:
    """Whether a relation holds, or each measure of it that can be a little off is so by ``slack`` [m] at most.

    Degrees are compared with lengths as the judge does it, 0.5 m for a radian.
    """
    judgement = judge_relation(placed, relation)
    return judgement.holds or (judgement.worst is not None and judgement.worst.weight <= slack)


def register_judge(relation_type: str, function: Judge) -> None:
    """Judge relations of a registered type with ``function``: Case -> Judgement, or a bool."""
    if relation_type in BUILT_IN:
        raise InputError(f"relation type {relation_type!r} is built in; its judge cannot be replaced")
    JUDGES[relation_type] = function


def _on_surface(case: Case, inner: bool) -> Judgement:
    """Subject rests on a surface of the target: the one that its support names, or any when it names none; of ``inner``
    ones only those with a head room count."""
    item, other = case.subject.item, case.other
    if item.support is not None and item.support.object != other.id:
        return fails(f"stands on {item.support.object}")
    surfaces = [
        s
        for s in other.item.surfaces
        if (item.support is None or s.name == item.support.surface) and (s.headroom is not None or not inner)
    ]
    rests = [(rest(case.placed, case.subject, other, s), s.name) for s in surfaces]
    if any(r.ok for r, _ in rests):
        return HOLDS
    if not rests:
        return fails(f"{other.id} has no {'inner ' if inner else ''}surface for it")
    nearest, name = min(rests, key=lambda found: found[0].worst.excess)
    return Judgement(False, nearest.text(f"{name} of {other.id}"), nearest.worst)
