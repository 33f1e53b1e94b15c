"""The last step of a design that should be ready for a simulator: things come to rest, and what moves is said."""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.verify import openable
from sceneweaver.verify.stability import numbers, violations

from .executor import Executor, Outcome

ROUNDS = 4
"""Times that objects whose settled poses break a rule are put back."""


def settled(outcome: Outcome, executor: Executor) -> tuple[Outcome, list[str]]:
    """The outcome with the poses in which MuJoCo leaves its objects, where the scene stays valid in them.

    What moves more than a centimetre keeps its pose and is noted; what falls is a violation.

    Returns:
        The outcome, and what is to be said of it.
    """
    from sceneweaver.physics import settle, stability

    load = executor.library.load
    rest = settle(outcome.scene, load)
    notes = [f"{object_id} moves {100 * rest.moved[object_id]:.1f} cm in physics" for object_id in rest.faults]
    after, kept = executor.judged(rest.scene), set()
    for _ in range(ROUNDS):
        if after.report.valid or not outcome.report.valid:
            break
        # A body may rest a millimetre lower than its prisms do, which the judge would call sunk.
        kept |= {
            object_id for v in after.report.violations if v.hard for object_id in v.objects if object_id in rest.moved
        }
        poses = {o.id: o.pose for o in outcome.scene.objects if o.id in kept}
        after = executor.judged(rest.scene.replace_poses(poses))
    if outcome.report.valid and not after.report.valid:
        kept, after = set(rest.moved), outcome
    if kept:
        notes.append(f"{len(kept)} of {len(rest.moved)} things stay where they were put, the others have settled")
    found = stability(after.scene, load)
    fallen = violations(found["moved"])
    judged = openable.judged(after.report, after.scene, openable.measure(after.scene, load))
    report = replace(
        judged,
        valid=judged.valid and not fallen,
        stability=numbers(found),
        violations=(*judged.violations, *fallen),
    )
    return replace(after, report=report, notes=outcome.notes, unmet=outcome.unmet), notes
