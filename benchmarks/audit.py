"""Whatever the engine calls valid, the judge must call valid."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.judging import Judge, Opinion, place, share
from benchmarks.results import Result
from sceneweaver.layout import Solution

KEPT = 10  # scenes written out for each label


@dataclass(frozen=True)
class Audit:
    """Candidates that the engine calls valid, and what the judge says about ``judged`` of them."""

    valid: np.ndarray
    judged: np.ndarray
    opinions: list[Opinion]

    @property
    def exceptions(self) -> int:
        """How many the judge calls invalid; must be 0."""
        return sum(not o.valid for o in self.opinions)

    @property
    def agreed(self) -> list[int]:
        """Indices of the candidates that the judge calls valid as well."""
        return [int(i) for i, o in zip(self.judged, self.opinions, strict=True) if o.valid]

    @property
    def soft(self) -> float | None:
        """Share of soft relations that hold."""
        return share([o.soft for o in self.opinions])


def spread(indices: np.ndarray, most: int | None) -> np.ndarray:
    """At most so many of the indices, evenly spread."""
    if most is None or len(indices) <= most:
        return indices
    return indices[np.linspace(0, len(indices) - 1, most).round().astype(int)]


def audit(solution: Solution, judge: Judge, result: Result, label: str, out: Path, most: int | None = None) -> Audit:
    """Judge what is called valid (at most so many of it); contradictions are failures of the result.

    The first few are written to ``out/contradictions`` as scene files.
    """
    valid = np.flatnonzero(solution.status == 0)
    judged = spread(valid, most)
    opinions = judge(solution.source, solution.poses[judged])
    wrong = [(int(i), o) for i, o in zip(judged, opinions, strict=True) if not o.valid]
    for kept, (i, o) in enumerate(wrong):
        name = f"{label.replace(' ', '-')}-{i}.json"
        result.failures.append(f"{label}, candidate {i}: status valid, but {o.reason}")
        if kept < KEPT:
            folder = out / "contradictions"
            folder.mkdir(parents=True, exist_ok=True)
            place(solution.source, solution.poses[i]).save(folder / name)
    return Audit(valid, judged, opinions)
