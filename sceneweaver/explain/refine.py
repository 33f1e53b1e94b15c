"""`sceneweaver.refine`: the engine's refinement, with the reason where nothing that it found is valid."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from sceneweaver.layout import ObjectiveTerm, Progress, QualityTerm, Solution, StepOptimizer, engine
from sceneweaver.layout.devices import pick_devices
from sceneweaver.runtime.deadline import Deadline, TimeUp, ending
from sceneweaver.scene import Scene

from .remarks import remarks
from .report import explain as find_reason
from .words import free_floor_words

GRACE = 1.0  # [s] beyond a time limit in which to explain why nothing is valid
HANGS = 0.2  # [s] after which an explanation that comes to no checkpoint is broken off
PRIOR = "prior"  # the name of the starts that the learned prior draws; the engine is given their poses
WALKED_OVER = 32  # layouts that are looked at with no floor kept free


# Options of a refinement are keyword arguments with defaults of their own, hence more than ten; `refine_many` as well.
def refine(
    scene: Scene,
    *,
    candidates: int = 1024,
    seed: int = 0,
    init: str | np.ndarray = "sample",
    device: str = "auto",
    optimizer: str | StepOptimizer = "search",
    time_limit: float | None = None,
    steps: int | None = None,
    progress: Progress | None = None,
    explain: bool = True,
    snap: bool = False,
    quality: Sequence[QualityTerm] = (),
    objective: Sequence[ObjectiveTerm] = (),
    moves: int | None = None,
) -> Solution:
    """Refine many candidate layouts of a scene at once.

    Args:
        scene: what to lay out; its poses matter to ``init="current"`` and for fixed objects.
        candidates: how many layouts B to refine.
        seed: with the same seed and kind of device, the same bits.
        init: "sample" draws starts from the relations, "random" anywhere, "current" begins with the scene's poses;
            "prior" draws layouts from what was learned (`LayoutPrior`), an array [B, N, 4] of world poses
            (x, y, z, yaw) begins with those.
        device: "auto", "cpu", "cuda", "cuda:k" or "cuda:all", which splits the candidates over all GPUs.
        optimizer: a name in ``sceneweaver.optimizers.OPTIMIZERS``, that of an entry point in the group
            ``sceneweaver.optimizers``, or an object with ``init``, ``step`` and ``best``.
        time_limit: seconds after which to stop with what there is; the result says that it was cut off.
        steps: the optimiser's budget in its own work units (search: attempts, projection: tries of a candidate from
            the first feasible one on, the others: steps).
        progress: called now and then as ``progress(done, total, valid, lowest energy)``.
        explain: when nothing is valid, find out why (``solution.explanation``); takes up to 10 s. It also names soft
            relations that hold in no valid layout, and relations of your own that engine and judge see otherwise.
        snap: bring valid layouts to the exact values of their relations at the end: square to the room, flush with
            walls and neighbours, centred, chairs pushed in, as far as nothing is in the way.
        quality: terms of design quality that all valid candidates are rated by (``solution.quality``) and ranked.
        objective: terms whose weighted sum is minimised over valid layouts, see `ObjectiveTerm`: what is hard comes
            first. Valid candidates are ranked by it (``solution.objective``).
        moves: with an objective, how many moves are tried for each candidate (default: 1,500 for each object that may
            move). Of a ``time_limit`` the search for valid layouts takes half at most.

    Raises:
        InputError: an argument is out of range.
        MissingDependencyError: the device is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> solution = sw.refine(sw.Scene.example("bedroom"), candidates=8, device="cpu")
        >>> solution.poses.shape, bool((solution.status == 0).any())
        ((8, 16, 4), True)
        >>> sw.check(solution.best).valid
        True
    """
    began = time.monotonic()
    solution = engine.refine(
        scene,
        candidates=candidates,
        seed=seed,
        init=_poses(scene, candidates, seed, device) if isinstance(init, str) and init == PRIOR else init,
        device=device,
        optimizer=optimizer,
        time_limit=time_limit,
        steps=steps,
        progress=progress,
        snap=snap,
        quality=quality,
        objective=objective,
        moves=moves,
    )
    return explained(solution, began, time_limit) if explain else solution


def refine_many(
    scenes: Sequence[Scene],
    *,
    candidates: int = 64,
    seed: int = 0,
    init: str = "sample",
    device: str = "auto",
    optimizer: str | StepOptimizer = "search",
    time_limit: float | None = None,
    steps: int | None = None,
    progress: Progress | None = None,
    explain: bool = False,
    snap: bool = False,
    quality: Sequence[Sequence[QualityTerm]] | None = None,
    objective: Sequence[Sequence[ObjectiveTerm]] | None = None,
    moves: int | None = None,
) -> list[Solution]:
    """Refine many scenes in shared launches; each gets what ``refine`` would give it alone.

    Arguments and errors as for ``refine``; ``time_limit`` is for all scenes together, ``init`` is a name, and
    ``quality`` and ``objective`` have the terms of each scene.

    Examples:
        >>> import sceneweaver as sw
        >>> scenes = [sw.Scene.example("bedroom"), sw.Scene.example("study")]
        >>> [s.poses.shape[0] for s in sw.refine_many(scenes, candidates=4, device="cpu")]
        [4, 4]
    """
    began = time.monotonic()
    solutions = engine.refine_many(
        scenes,
        candidates=candidates,
        seed=seed,
        init=[_poses(scene, candidates, seed, device) for scene in scenes] if init == PRIOR else init,
        device=device,
        optimizer=optimizer,
        time_limit=time_limit,
        steps=steps,
        progress=progress,
        snap=snap,
        quality=quality,
        objective=objective,
        moves=moves,
    )
    return [explained(solution, began, time_limit) for solution in solutions] if explain else solutions


def _poses(scene: Scene, candidates: int, seed: int, device: str) -> np.ndarray:
    """Poses [B, N, 4] to begin with that the learned prior draws."""
    from sceneweaver.prior import LayoutPrior

    return LayoutPrior.load().sample(scene, candidates, seed, device=pick_devices(device)[0])


def explained(solution: Solution, began: float, time_limit: float | None) -> Solution:
    """The solution with the reason why nothing in it is valid, where that is so, and what else is odd about it.

    A run that its time limit cut off has a little more time to say why. Where that is not enough, nothing is said:
    the layouts are not lost for it.
    """
    stop = ending()
    if stop is not None and time.monotonic() >= stop():
        return solution
    lines = remarks(solution)
    if np.any(solution.status == 0):
        return replace(solution, explanation="\n".join(lines)) if lines else solution
    deadline = None if time_limit is None else max(began + time_limit, time.monotonic() + GRACE)
    clock = Deadline(math.inf if deadline is None else deadline)
    text = None
    with suppress(TimeUp), clock.enforced(patience=HANGS):
        bare = _walked_over(solution, deadline)
        if bare is not solution and np.any(bare.status == 0):
            text = f"Only without free floor are there valid layouts: {free_floor_words(solution.source.free_areas)}."
        else:
            text = find_reason(bare.source, bare, device=solution.device, seed=solution.seed, deadline=deadline)
    said = "\n".join([*lines, *([text] if text else [])])
    return replace(solution, explanation=said or None, elapsed=time.monotonic() - began)


def _walked_over(solution: Solution, deadline: float | None) -> Solution:
    """A few layouts of the scene with no floor kept free; the solution itself where none is."""
    if not solution.source.free_areas:
        return solution
    left = None if deadline is None else max(deadline - time.monotonic(), 0.1)
    bare = solution.source.model_copy(update={"free_areas": ()})
    return engine.refine(
        bare, candidates=WALKED_OVER, seed=solution.seed, device=solution.device, time_limit=left, walk=False
    )
