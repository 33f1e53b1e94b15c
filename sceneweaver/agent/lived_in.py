"""A last touch: walls and what may carry small things are not bare, and a finished room gets traces of life."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.generate.finish import accented
from sceneweaver.generate.quantity import is_detailed, is_plain
from sceneweaver.scene.edits import Add, AnyEdit, Relate, SetPose, apply_all
from sceneweaver.tools.add_clutter import AddClutter
from sceneweaver.tools.add_crowd import AddCrowd
from sceneweaver.tools.add_tabletop import AddTabletop
from sceneweaver.tools.add_wall_objects import AddWallObjects
from sceneweaver.tools.base import Context, Tool
from sceneweaver.verify import check

from .executor import Executor, Outcome

TOUCHES: tuple[tuple[Tool, ...], ...] = ((AddWallObjects(), AddTabletop(), AddCrowd()), (AddClutter(),))
"""Tools of the last touches, those of a touch together: a shelf that is hung is filled; each touch is kept or not."""

ROUNDS = 4
"""Times that edits which break a rule, or which the critic finds fault with, are taken back before the room stays as it
is."""

WORSE = 0.1
"""Points of the mean grade that a room may lose by a touch."""

DONE = "clutter"
"""Key of the provenance that says how lived-in a room has been made."""


def lived_in(outcome: Outcome, executor: Executor, context: Context) -> Outcome:
    """The outcome with things on bare walls and on all that was left bare, chairs askew and things on the floor; the
    accent wall is that behind the main piece."""
    brief = context.brief
    if not outcome.report.valid or DONE in outcome.scene.provenance or is_plain(brief):
        return outcome
    for tools in TOUCHES[:1] if is_detailed(brief) else TOUCHES:
        outcome = _touched(outcome, executor, context, tools)
    provenance = {**outcome.scene.provenance, DONE: context.clutter}
    told = brief.finish_of("accent")
    scene = accented(outcome.scene) if told is None or told.where == "any" else outcome.scene
    return replace(outcome, scene=scene.model_copy(update={"provenance": provenance}))


def _touched(outcome: Outcome, executor: Executor, context: Context, tools: Sequence[Tool]) -> Outcome:
    """The outcome with what some tools propose, less what breaks a rule; unchanged where it would be worse."""
    edits: list[AnyEdit] = []
    scene = outcome.scene
    for tool in tools:
        found = tool.propose(replace(context, scene=scene, inputs={})).edits
        scene, _ = apply_all(scene, found)
        edits += found
    for _ in range(ROUNDS):
        if not edits:
            return outcome
        scene, _ = apply_all(outcome.scene, edits)
        report = check(scene)
        if report.valid:
            after = replace(executor.judged(scene, report), notes=outcome.notes, unmet=outcome.unmet)
            if after.review.unmet <= outcome.review.unmet and after.review.total >= outcome.review.total - WORSE:
                return after
            wrong = {name for fault in after.review.faults for name in fault.objects}
        else:
            wrong = {name for v in report.violations if v.hard for name in v.objects}
        kept = _without(edits, wrong)
        edits = kept if len(kept) < len(edits) else []
    return outcome


def _without(edits: Sequence[AnyEdit], ids: set[str]) -> list[AnyEdit]:
    """The edits that neither add nor move any of some objects, nor add what stands on one or relates to it."""
    gone = {e.object.id for e in edits if isinstance(e, Add)} & ids
    while (
        more := {
            e.object.id
            for e in edits
            if isinstance(e, Add) and e.object.support is not None and e.object.support.object in gone
        }
        - gone
    ):
        gone |= more
    return [e for e in edits if not _concerns(e, gone | ids, gone)]


def _concerns(edit: AnyEdit, moved: set[str], gone: set[str]) -> bool:
    if isinstance(edit, Add):
        return edit.object.id in gone
    if isinstance(edit, Relate):
        return bool({edit.relation.subject, *edit.relation.targets} & gone)
    return isinstance(edit, SetPose) and edit.id in moved
