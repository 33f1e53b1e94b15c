"""Small refinements of parts of a scene, which tell what has a layout and what seems to have none."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence

import numpy as np

from sceneweaver.layout import refine_many
from sceneweaver.scene import Scene

from .study import OutOfTime, Study

CHUNK = 48  # parts that are tested at once

Effort = tuple[int, int]  # candidates, attempts
QUICK, FIRM, FEW_SURE, SURE = range(4)
# Of a test, by the kind of device: a GPU takes many candidates as fast as few.
EFFORTS: dict[str, tuple[Effort, ...]] = {
    "cpu": ((32, 1), (32, 3), (64, 3), (64, 5)),
    "cuda": ((256, 1), (1024, 1), (1024, 2), (2048, 2)),
}
FEW = 4  # objects up to which FEW_SURE is sure
CROWD = 40  # objects from which on a test stays quick


class Search:
    """Tests which parts of a studied scene have a layout, and remembers the outcomes."""

    def __init__(self, study: Study, seed: int) -> None:
        self.study, self.seed = study, seed
        self.cut = False
        self.possible: list[frozenset[int]] = []
        self.impossible: list[frozenset[int]] = []

    def solvable(self, scenes: Sequence[Scene], effort: int) -> list[bool]:
        """Which scenes a small refinement finds a valid layout for; raises OutOfTime when the clock cuts it off."""
        left = self.study.until - time.monotonic()
        if left <= 0:
            raise OutOfTime
        candidates, steps = EFFORTS["cpu" if self.study.device == "cpu" else "cuda"][effort]
        solutions = refine_many(
            scenes,
            candidates=candidates,
            seed=(self.seed + 7919 * steps + candidates) % 2**32,
            device=self.study.device,
            steps=steps,
            time_limit=left,
        )
        found = [bool(np.any(s.status == 0)) for s in solutions]
        if not all(found) and any(s.timed_out for s in solutions):
            raise OutOfTime
        return found

    def known(self, part: frozenset[int]) -> bool | None:
        """What earlier tests and the solution's candidates say about a closed part."""
        if any(part <= other for other in self.possible) or self._witnessed(part):
            return True
        return False if any(other <= part for other in self.impossible) else None

    def _witnessed(self, part: frozenset[int]) -> bool:
        """Whether some candidate of the solution has a closed part in order."""
        units = [e for e in part if e < len(self.study.units)]
        bad = self.study.unmet[:, units].any(axis=1) | self.study.fault[:, sorted(self.study.objects_of(part))].any(
            axis=1
        )
        return not bad.all()

    def note(self, part: frozenset[int], can: bool) -> None:
        """Remember the outcome of a test."""
        if can:
            self.impossible = [p for p in self.impossible if not p <= part]
        (self.possible if can else self.impossible).append(part)

    def can(self, parts: Sequence[Iterable[int]]) -> list[bool]:
        """Whether each part has a layout, as far as a search tells: first a quick one, then a firmer one."""
        closed = [self.study.closed(p) for p in parts]
        for effort in (QUICK, FIRM):
            ask = [p for p in dict.fromkeys(closed) if self.known(p) is None]
            for some in (ask[i : i + CHUNK] for i in range(0, len(ask), CHUNK)):
                scenes = [self.study.scene_of(p, guides=effort == FIRM) for p in some]
                for part, can in zip(some, self.solvable(scenes, effort), strict=True):
                    if can or effort == FIRM or len(self.study.objects_of(part)) > CROWD:
                        self.note(part, can)
        return [bool(self.known(p)) for p in closed]

    def surely_not(self, part: Iterable[int]) -> bool:
        """Whether even a long search finds no layout for a part that a shorter one found none for."""
        closed = self.study.closed(part)
        few = len(self.study.objects_of(closed)) <= FEW
        try:
            found = self.solvable([self.study.scene_of(closed, guides=True)], FEW_SURE if few else SURE)[0]
        except OutOfTime:
            self.cut = True
            return True
        self.note(closed, found)
        return not found
