"""The end of a run: the last touch, what physics and doors say, and the result with its numbers."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import replace

from sceneweaver.critic import Review
from sceneweaver.generate.squared import unsquared
from sceneweaver.runtime.deadline import TimeUp
from sceneweaver.verify import Report

from .changed import Start, start_of
from .executor import Executor, Outcome
from .lived_in import lived_in
from .loop import Run
from .openability import opened
from .relaxation import still_true
from .result import ModelUse, Result
from .settling import settled

LOOKED = 0.3
"""Share of the time for judgement that is kept from the last touch, to look whether doors and drawers open."""


def closed(run: Run, remarks: Sequence[str], began: float, use: Callable[[], ModelUse | None]) -> Result:
    """Take the run to its end, and its best scene to a result.

    Args:
        run: before its first step, or where it stopped.
        remarks: what was assumed of the request.
        began: when the design began, by ``time.monotonic()`` [s].
        use: what a model did in it, told when all is done; None where none had anything to do.
    """
    brief, settings = run.brief, run.settings
    executor = Executor(run.room_type, brief, settings, run.library)
    best = run.go()
    stopped = run.deadline.stop.reason
    said = [f"the work was cut off: {run.cut_off}"] if run.cut_off else []
    if not stopped and best.scene.objects:
        left = run.closing.left
        try:
            with run.closing.before(0.0 if math.isinf(left) else LOOKED * left).enforced():
                best = lived_in(best, executor, run.context(best.scene, settings.seed))
        except TimeUp:
            said.append("the room is tidier than usual: time was up")
    try:
        with run.closing.enforced():
            best, mended = opened(best, executor)
        said += mended
    except TimeUp:
        said.append("whether doors and drawers open was not looked at: time was up")
    if settings.settle:
        try:
            with run.closing.enforced():
                best, moved = settled(best, executor)
            said += moved
        except TimeUp:
            said.append("things have not settled: time was up")
    best = _seen(run, best)
    if settings.begin.room is not None:
        best = replace(best, scene=unsquared(best.scene))
    unmet = tuple(dict.fromkeys((*run.memory.unmet, *run.unmet, *_unmet(best.review))))
    models = use()
    start = _start(run, best)
    return Result(
        scene=best.scene,
        report=_complete(best.report, best.review, run, began, models, start),
        review=best.review,
        brief=brief,
        steps=run.memory.steps,
        notes=still_true(
            tuple(dict.fromkeys((*brief.notes, *remarks, *run.memory.notes, *run.notes, *said))), best.scene
        ),
        unmet=unmet,
        seconds=time.monotonic() - began,
        finished=run.memory.finished,
        broken=run.undone,
        undone=run.undone + ((f"what would have come after {stopped}",) if run.cut_off and stopped else ()),
        out=run.folder.path if run.folder else None,
        models=models,
        start=start,
    )


def _start(run: Run, best: Outcome) -> Start | None:
    """What became of the scene of somebody else that the run began with."""
    if run.origin is None:
        return None
    name = run.starting.name or str(best.scene.provenance.get("library", "library"))
    return start_of(name, run.origin, best.scene)


def _seen(run: Run, best: Outcome) -> Outcome:
    """The last scene with what a critic by vision sees of it, where it has changed since that looked."""
    if run.look is None or run.cut_off or best.review.seen is not None or run.closing.passed:
        return best
    return run.look(best)


def _unmet(review: Review) -> list[str]:
    """What the critic finds missing of the request."""
    return [fault.reason for fault in review.faults if fault.criterion == "alignment"]


def _complete(
    report: Report, review: Review, run: Run, began: float, models: ModelUse | None, start: Start | None
) -> Report:
    from importlib.metadata import version

    settings = run.settings
    scores = {"critic": review.critic, **{k: round(v, 2) for k, v in review.grades.items()}}
    if review.seen is not None:
        scores["seen"] = review.seen.summary
    steps = {f"step {s.number}": s.seconds for s in run.memory.steps}
    return replace(
        report,
        scores=scores,
        alignment=review.alignment.summary,
        seed=settings.seed,
        device=settings.device,
        candidates=settings.layouts,
        cut_off=run.cut_off or None,
        seconds={"total": round(time.monotonic() - began, 3), **steps},
        versions={**report.versions, "warp-lang": version("warp-lang")},
        models=models.to_dict() if models is not None else None,
        start=start.to_dict() if start is not None else None,
    )
