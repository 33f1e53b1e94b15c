"""How good what a run found is, by the judge: the layouts in the results are looked at again, no figure is believed."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import load_json, write_atomic
from sceneweaver.problems import ProblemCase
from sceneweaver.scene import InputError

from .results import Key, Run

CACHE = "judged.json"
AGREE = 1e-3  # relative, of what a run says of its objective and what the layout has


@dataclass(frozen=True)
class Judged:
    """What the judge says of a run.

    Attributes:
        valid: whether its layout is valid.
        objective: that of its layout; None without one, or where no layout is valid.
        quality: 0 where nothing is valid; else the best known objective divided by the layout's, at most 1, and 1 where
            being valid is all.
        fault: what of the run is not so, in one line; empty otherwise.
    """

    valid: bool
    objective: float | None
    quality: float
    fault: str = ""


def judged(run: Run, case: ProblemCase, cache: dict[str, list] | None = None) -> Judged:
    """Judge the layout of a run on a problem.

    Args:
        run: with its layout.
        case: the problem that it names.
        cache: verdicts by hash of problem and layout, which are used and added to.
    """
    if run.last("problem_hash") != case.hash:
        return Judged(False, None, 0.0, "the problem has another hash")
    data = run.last("layout")
    if not data:
        claims = run.last("valid") > 0 and not run.failed
        return Judged(False, None, 0.0, "says that something is valid and has no layout" if claims else "")
    if len(data) != 16 * len(case.scene.objects):
        return Judged(False, None, 0.0, f"its layout has {len(data)} bytes, not {16 * len(case.scene.objects)}")
    name, known = hashlib.sha256(case.hash.encode() + data).hexdigest(), cache if cache is not None else {}
    if name not in known:
        poses = np.frombuffer(data, dtype="<f4").reshape(-1, 4)
        known[name] = list(_judge(case, poses)) if np.isfinite(poses).all() else [False, None]
    valid, value = known[name]
    if not valid:
        return Judged(False, None, 0.0, "the judge finds its layout not valid")
    if value is None:
        return Judged(True, None, 1.0)
    claim, best = run.last("best_objective"), case.best_objective or 0.0
    wrong = claim is None or abs(claim - value) > AGREE * max(abs(value), 1.0)
    quality = min(best / value, 1.0) if value > 0 else 1.0
    return Judged(True, value, quality, f"says {claim} of an objective of {value:.4f}" if wrong else "")


def _judge(case: ProblemCase, poses: np.ndarray) -> tuple[bool, float | None]:
    """The verdict of a layout in which what is fixed did not move."""
    home = np.array([(*o.pose.position, o.pose.yaw) for o in case.scene.objects], dtype=np.float32)
    still = np.array([o.fixed for o in case.scene.objects], dtype=bool)
    if not np.allclose(poses[still], home[still], atol=1e-4):
        return False, None
    return case.judge(poses)


def judge_all(
    runs: Sequence[Run], cases: Mapping[str, ProblemCase], folder: Path | str | None = None
) -> dict[Key, Judged]:
    """The verdict of each run. Verdicts are kept in ``folder``, as judging takes time.

    Raises:
        InputError: a run is on a problem that is not among ``cases``.
    """
    path = None if folder is None else Path(folder) / CACHE
    cache: dict[str, list] = load_json(path) if path is not None and path.exists() else {}
    before, found = len(cache), {}
    for run in runs:
        case = cases.get(run.key[1])
        if case is None:
            raise InputError(f"{run.key[1]}: is no problem of this split; those of test need --seed-file")
        found[run.key] = judged(run, case, cache)
    if path is not None and len(cache) > before:
        write_atomic(path, json.dumps(cache, separators=(",", ":")) + "\n")
    return found


def quality_of(run: Run, case: ProblemCase) -> float:
    """The quality of a run, from 0 to 1, see `Judged`."""
    return judged(run, case).quality
