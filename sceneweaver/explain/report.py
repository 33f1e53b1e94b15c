"""The explanation of a solution, from its cause and the time that there was to find it."""

from __future__ import annotations

import time

import numpy as np

from sceneweaver.layout import Solution
from sceneweaver.scene import Scene

from .causes import find_causes
from .conflicts import Conflicts
from .findings import hints, most_unmet
from .search import Search
from .study import OutOfTime, Study

LONGEST = 10.0  # [s] that an explanation may take
RESERVE = 0.3  # [s] of it kept for the last words


def explain(scene: Scene, solution: Solution, *, device: str, seed: int, deadline: float | None = None) -> str | None:
    """Why no candidate of a refinement is valid: one to about six lines of plain English; None when one is valid.

    Args:
        scene: what was refined.
        solution: what came of it.
        device: where to run the small refinements, as for ``refine``.
        seed: their seed.
        deadline: when to be back, in the time of ``time.monotonic()``; it never takes much longer than 10 s anyway.
    """
    if np.any(solution.status == 0):
        return None
    start = time.monotonic()
    end = start + LONGEST if deadline is None else min(deadline, start + LONGEST)
    until = end - min(RESERVE, 0.1 * (end - start))
    if until - start < 0.02:
        return "\n".join([*_timed_out(solution, False), most_unmet(scene, solution)])
    study = Study(scene, solution, device, until)
    search = Search(study, seed)
    proved = False
    try:
        lines, proved = find_causes(Conflicts(search))
        if not lines:
            lines = ["No single cause was found.", *hints(study)]
        if search.cut:
            lines.append(f"Looking further was stopped after {time.monotonic() - start:.1f} s.")
    except OutOfTime as cut:
        lines = [f"Looking for the cause was stopped after {time.monotonic() - start:.1f} s.", *cut.lines]
        lines += hints(study) if time.monotonic() < end else [most_unmet(scene, solution)]
    return "\n".join([*_timed_out(solution, proved), *lines])


def _timed_out(solution: Solution, proved: bool) -> list[str]:
    if not solution.timed_out:
        return []
    proof = "but more time would not have helped" if proved else "which is no proof that there is none"
    return [f"The time limit stopped the run after {solution.elapsed:.1f} s, before any layout was valid, {proof}."]
