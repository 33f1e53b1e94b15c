"""Repair scenes: solve them from where they are, judge what comes out, keep the best."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.runtime.deadline import Deadline
from sceneweaver.scene import InputError, Scene

from .report import Repair, notes_on
from .solving import Budget, Work, judged, lay_out_anew, mend
from .staying import let_stay
from .taking_out import take_out

AGAIN = 8  # times as many candidates for a scene that stays invalid, and of which nothing proves that it is


def repair(
    scene: Scene,
    *,
    relations: bool = True,
    soft: bool = False,
    drop: bool = False,
    candidates: int | None = None,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
) -> Scene:
    """The scene with its objects moved as little as makes it valid; a scene that is valid is returned as it is.

    Nothing is added, resized or tilted, nothing is taken out unless ``drop`` says so, and fixed objects stay. What
    stands on an object moves along with it. When no valid layout is found, the scene
    has what the judge objects to least, which may be the scene as it was; ``sw.check`` or ``repair_report`` tell.

    Args:
        scene: a scene from anywhere: objects may overlap, float, or be outside of the room.
        relations: whether hard relations are to hold afterwards, too.
        soft: whether soft relations that hold are to go on holding as far as they can, and those that nearly hold
            (30 cm) are to be mended; one of the first is worth 1 m of movement, one of the others 10 cm.
        drop: whether objects may be taken out where nothing valid was found with all of them: as few as it takes, the
            smallest of those. Fixed ones stay.
        candidates: how many repairs to choose from (default: 4 to 64, fewer the more objects there are).
        seed: with the same seed and kind of device, the same result.
        device: "auto", "cpu", "cuda" or "cuda:k".
        time_limit: seconds after which to stop with what there is.

    Raises:
        InputError: an argument is out of range.
        MissingDependencyError: the device is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> broken = scene.replace_poses({"plant": sw.Pose.from_yaw(9.0, 0.0, 0.0, 0.0)})
        >>> sw.check(sw.repair(broken, device="cpu")).valid
        True
    """
    return repair_report(
        scene,
        relations=relations,
        soft=soft,
        drop=drop,
        candidates=candidates,
        seed=seed,
        device=device,
        time_limit=time_limit,
    ).scene


def repair_report(
    scene: Scene,
    *,
    relations: bool = True,
    soft: bool = False,
    drop: bool = False,
    candidates: int | None = None,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
) -> Repair:
    """Repair a scene as `repair` does, and say what was wrong, who moved and what is still unmet.

    Arguments and errors as for `repair`.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> broken = scene.replace_poses({"plant": sw.Pose.from_yaw(9.0, 0.0, 0.0, 0.0)})
        >>> repaired = sw.repair_report(broken, device="cpu")
        >>> repaired.valid, "plant" in [move.id for move in repaired.moves]
        (True, True)
    """
    return repair_many(
        [scene],
        relations=relations,
        soft=soft,
        drop=drop,
        candidates=candidates,
        seed=seed,
        device=device,
        time_limit=time_limit,
    )[0]


def repair_many(
    scenes: Sequence[Scene],
    *,
    relations: bool = True,
    soft: bool = False,
    drop: bool = False,
    candidates: int | None = None,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
    explain: bool = True,
) -> list[Repair]:
    """Repair many scenes in shared launches, different rooms side by side; each as `repair_report` does it alone.

    Arguments and errors as for `repair`; ``time_limit`` is for all scenes together. ``explain`` says of scenes that
    stay invalid why, which takes up to 10 s each. ``Repair.seconds`` is each scene's equal share.

    Examples:
        >>> import sceneweaver as sw
        >>> scenes = [sw.Scene.example("bedroom"), sw.Scene.example("study")]
        >>> [done.valid for done in sw.repair_many(scenes, device="cpu")]
        [True, True]
    """
    began = time.monotonic()
    _check_arguments(candidates, seed, time_limit)
    work = [Work.on(scene, relations, soft) for scene in scenes]
    broken = [each for each in work if not each.before.valid]
    budget = Budget(candidates, seed, device)
    clock = Deadline(math.inf if time_limit is None else began + time_limit)
    mend(broken, budget, clock)
    proofs = {id(each): _proof(each) for each in broken if not each.best.report.valid}
    again = [each for each in broken if not each.best.report.valid and not proofs.get(id(each)) and not clock.passed]
    more = replace(budget, times=AGAIN, seed=(seed + 1) % 2**32)
    mend(again, more, clock)
    again = [each for each in again if not each.best.report.valid and not clock.passed]
    lay_out_anew(again, more, clock)
    if soft:
        let_stay(broken, budget, clock)
    if drop:
        for each in broken:
            if not each.best.report.valid:
                take_out(each, budget, clock)
    reasons = {}
    for each in broken if explain else ():
        if not each.best.report.valid or each.best.taken_out:
            reasons[id(each)] = proofs.get(id(each)) or _reason(each, began, time_limit)
    seconds = (time.monotonic() - began) / max(1, len(work))
    return [_outcome(each, seed, seconds, reasons.get(id(each)), proofs.get(id(each))) for each in work]


def _outcome(work: Work, seed: int, seconds: float, explanation: str | None, proof: str | None) -> Repair:
    best, solution = work.best, work.solution
    return Repair(
        source=work.scene,
        scene=best.scene,
        before=work.before,
        after=work.before if best.scene is work.scene else judged(best.scene, work.relations),
        moves=best.moves,
        notes=() if solution is None else notes_on(work.scene),
        explanation=explanation,
        seed=seed,
        device=None if solution is None else solution.device,
        seconds=seconds,
        timed_out=solution is not None and (solution.timed_out or work.unjudged),
        proof=proof if explanation else None,
        taken_out=best.taken_out,
        held=tuple(work.scene.relations[k] for k in sorted(work.held)),
        lost=tuple(work.scene.relations[k] for k in sorted(best.lost)),
        nearly=tuple(work.scene.relations[k] for k in sorted(work.wishes - work.held)),
        unmended=tuple(work.scene.relations[k] for k in sorted(best.unmet)),
    )


def _proof(work: Work) -> str | None:
    """Why no layout of a scene is valid, where arithmetic proves it."""
    from sceneweaver.explain import certificate

    solution = work.solution
    return None if solution is None else certificate(solution.source, solution, device=solution.device)


def _reason(work: Work, began: float, time_limit: float | None) -> str | None:
    """Why nothing valid was found, as searches tell it."""
    from sceneweaver.explain.refine import explained

    return None if work.solution is None else explained(work.solution, began, time_limit).explanation


def _check_arguments(candidates: int | None, seed: int, time_limit: float | None) -> None:
    """Raise InputError on anything out of range, also for scenes that need no repair."""
    if candidates is not None and (not isinstance(candidates, int | np.integer) or candidates < 1):
        raise InputError(f"candidates: {candidates!r} is not a whole number of at least 1")
    if not isinstance(seed, int | np.integer) or not 0 <= seed < 2**32:
        raise InputError(f"seed: {seed!r} is not a whole number from 0 to 2**32 - 1")
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")
