"""Repair a scene: solve it from where it is, judge what comes out, keep the better one."""

from __future__ import annotations

import math
import time
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import Report, check

from .report import Move, Repair, moves_between, notes_on
from .upright import engine_scene, put_back

if TYPE_CHECKING:
    from sceneweaver.layout import Solution

MOST, LEAST, WORK = 64, 4, 1280  # candidates: as many as WORK objects, within these bounds
TRIES = 4  # of a candidate from the first feasible one on
TRIED = 4  # layouts that are judged when none is valid
JUDGED = 0.5  # [s] beyond a time limit in which what was found is judged


def repair(
    scene: Scene,
    *,
    relations: bool = True,
    candidates: int | None = None,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
) -> Scene:
    """The scene with its objects moved as little as makes it valid; a scene that is valid is returned as it is.

    Nothing is added, dropped, resized or tilted, and fixed objects stay. When no valid layout is found, the scene
    has what the judge objects to least, which may be the scene as it was; ``sw.check`` or ``repair_report`` tell.

    Args:
        scene: a scene from anywhere: objects may overlap, float, or be outside of the room.
        relations: whether hard relations are to hold afterwards, too.
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
        scene, relations=relations, candidates=candidates, seed=seed, device=device, time_limit=time_limit
    ).scene


def repair_report(
    scene: Scene,
    *,
    relations: bool = True,
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
    began = time.monotonic()
    _check_arguments(candidates, seed, time_limit)
    before = _judge(scene, relations)
    if before.valid:
        return Repair(
            source=scene,
            scene=scene,
            before=before,
            after=before,
            moves=(),
            notes=(),
            explanation=None,
            seed=seed,
            device=None,
            seconds=time.monotonic() - began,
        )
    budget = {"candidates": candidates, "seed": seed, "device": device}
    clock = Deadline(math.inf if time_limit is None else began + time_limit)
    solution, options = _solve(scene, relations, time_limit=clock.time_limit, **budget)
    judged: list[tuple[Scene, Report, tuple[Move, ...]]] = []
    with suppress(TimeUp), clock.enforced(lambda: JUDGED):
        if relations and solution.status.min() != 0:  # where relations cannot hold, everything else still can
            options += _solve(scene, False, time_limit=clock.time_limit, explain=False, **budget)[1]
        for option in options:
            judged.append((option, _judge(option, relations), moves_between(scene, option)))
    fixed, after, moves = min([*judged, (scene, before, ())], key=_badness)
    return Repair(
        source=scene,
        scene=fixed,
        before=before,
        after=after,
        moves=moves,
        notes=notes_on(scene),
        explanation=None if after.valid else solution.explanation,
        seed=seed,
        device=solution.device,
        seconds=time.monotonic() - began,
        timed_out=solution.timed_out or len(judged) < len(options),
    )


def _solve(
    scene: Scene, relations: bool, *, candidates: int | None, explain: bool = True, **options: Any
) -> tuple[Solution, list[Scene]]:
    """Project the scene; the solution, and its best layout as a scene, or when none is valid a few to choose from."""
    from sceneweaver.explain import refine

    model, lift = engine_scene(scene, relations)
    solution = refine(
        model,
        candidates=candidates or max(LEAST, min(MOST, WORK // max(1, len(scene.objects)))),
        init="current",
        optimizer="projection",
        steps=TRIES,
        explain=explain,
        **options,
    )
    chosen = solution.order[:1]
    if solution.status[chosen[0]] != 0:  # those with the least left to mend, too
        chosen = np.unique(np.concatenate([chosen, np.argsort(solution.energy, kind="stable")[:TRIED]]))
    return solution, [put_back(scene, lift, solution.poses[i]) for i in chosen]


def _check_arguments(candidates: int | None, seed: int, time_limit: float | None) -> None:
    """Raise InputError on anything out of range, also for scenes that need no repair."""
    if candidates is not None and (not isinstance(candidates, int | np.integer) or candidates < 1):
        raise InputError(f"candidates: {candidates!r} is not a whole number of at least 1")
    if not isinstance(seed, int | np.integer) or not 0 <= seed < 2**32:
        raise InputError(f"seed: {seed!r} is not a whole number from 0 to 2**32 - 1")
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")


def _judge(scene: Scene, relations: bool) -> Report:
    if not relations:
        soft = tuple(r.model_copy(update={"hard": False}) for r in scene.relations)
        scene = scene.model_copy(update={"relations": soft})
    return check(scene)


def _badness(result: tuple[Scene, Report, tuple[Move, ...]]) -> tuple[int, float]:
    """Order of results: by how many things are wrong, then by how far objects went."""
    _, report, moves = result
    wrong = sum(v.hard for v in report.violations)
    return wrong, sum(m.distance + abs(m.rise) for m in moves)
