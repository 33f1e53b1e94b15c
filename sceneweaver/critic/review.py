"""The symbolic critic: every check over one scene, and the grades that come of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from . import asked, design, own
from . import checks as checks  # whose measures rows call
from .grade import Finding, grades
from .model import Fault, Review
from .survey import Survey
from .totals import measures
from .traits import traits_of

CHECKS: tuple[Callable[[Survey], Iterator[Finding]], ...] = (design.other_faults, design.faults, own.faults)
"""All checks but those of the request; each gives what it finds in a survey. Without objects only the first is done."""

MOST, MOST_ASKED = 8, 64
"""Faults of one kind that are listed one by one; of what was asked for."""


def review_scene(scene: Scene, report: Report, room_type: RoomType, brief: SceneGraph, *, rules: bool = True) -> Review:
    """Grade a scene as a critical visitor would, from its symbols alone: no picture and no model is needed.

    Args:
        scene: the scene, in metres.
        report: what ``sceneweaver.verify.check(scene)`` says about it.
        room: the kind of room that it should be.
        brief: the request, read.
        rules: whether the design rules are checked, and not the older checks alone.

    Returns:
        Grades 0 to 10 for realism, functionality, layout, completion and alignment; every fault with numbers and,
        where one can mend it, a call of a tool; what was measured; and what became of each item of the request.
    """
    survey = Survey.of(scene, report, room_type, brief)
    carried_out = [check for check in CHECKS if rules or check is not design.faults][: None if scene.objects else 1]
    found = [f for check in carried_out for f in check(survey)]
    found = [f for f in found if not _turned_as_asked(survey, f)]
    items = asked.measured(survey, [f.fault for f in found])
    found += asked.findings(items)
    ranked = sorted(found, key=lambda f: (f.cap is None, -f.fault.points))
    faults = _short([f.fault for f in ranked])
    told = asked.alignment(items)
    traits = traits_of(survey)
    return Review(
        grades=grades(found, told, traits),
        faultless=grades((), None, traits),
        faults=faults,
        measures=measures(survey),
        alignment=told,
    )


def _turned_as_asked(survey: Survey, found: Finding) -> bool:
    """Whether a fault is about what the request wants to face something of its choice."""
    if found.fault.kind != "wrong_orientation":
        return False
    facing = (said.subject for said in survey.brief.relations if said.type == "facing")
    return any(b.id in found.fault.objects for name in facing for b in survey.standing_for(name))


def _short(faults: Sequence[Fault]) -> tuple[Fault, ...]:
    """The faults, of those of one kind the first `MOST` (or `MOST_ASKED`) singly and the rest in one."""
    kept: list[Fault] = []
    rest: dict[tuple[str, str], list[Fault]] = {}
    count: Counter[tuple[str, str]] = Counter()
    for fault in faults:
        key = (fault.criterion, fault.kind)
        count[key] += 1
        most = MOST_ASKED if fault.criterion == "alignment" else MOST
        if count[key] < most or (count[key] == most and sum((f.criterion, f.kind) == key for f in faults) == most):
            kept.append(fault)
        else:
            rest.setdefault(key, []).append(fault)
    for more in rest.values():
        ids = tuple(dict.fromkeys(object_id for f in more for object_id in f.objects))
        points = round(sum(f.points for f in more), 3)
        reason = f"{len(more)} more of this kind, such as: {more[0].reason}"
        kept.append(more[0].model_copy(update={"objects": ids, "reason": reason, "points": points}))
    return tuple(kept)
