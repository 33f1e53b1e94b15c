"""Depth-first search over a grid of places with scores for constraints, as Holodeck places floor objects.

After Yang et al., "Holodeck: Language Guided Generation of 3D Embodied AI Environments" (CVPR 2024), section 3.4 and
the appendix on its depth-first solver: objects one after another, each at the points of a grid in four directions; what
leaves the room or collides is dropped, the others are ordered by the weighted share of soft constraints that they
satisfy with what stands already; the best few are gone into one after another, and when the time is over the layout
with the highest score of those that have most objects is taken. Written anew from that description.

Fairness: it sees bodies and zones as rectangles by `quarter_turns`, doors, walls, and every relation as that view says
it; the original knows eight kinds of constraints (edge, near, far, in front, beside, around, face to, centre aligned)
and treats walls as a fixed preference, so ours is told more. Here relations at walls count as the original's edge
constraint, which it keeps strictly, others as preferences. It knows no objectives, no yaw between quarter turns, and
leaves an object where it started for which no place is left; the original leaves it out. Places between points of
the grid do not exist, so narrow intervals (a gap of 7 cm at a wall) are met by grids through the walls: beside the grid
an object is tried flush with every wall.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .one_by_one import OneByOne
from .places import Places
from .quarter_turns import QuarterTurns, quarter_turns


@dataclass(frozen=True)
class HolodeckDfs(OneByOne):
    cell: float = 0.25  # [m] of the grid
    branches: int = 5  # places of an object that are gone into
    wall_bonus: float = 2.0  # weight of a relation at a wall; one to another object weighs 1
    strict_walls: bool = True  # places that miss a relation at a wall are dropped while others are left
    limit: float = 0.5  # [s]; the paper's is 30

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "cell": [0.1, 0.25, 0.5],
        "branches": [1, 5, 20],
        "wall_bonus": [1.0, 2.0],
        "strict_walls": [True, False],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        view = quarter_turns(problem, given)
        xy, turns = view.spot(given[None])
        search = _Search(self, view, xy[0], turns[0], np.random.default_rng(seed), until)
        search.go([], 0.0)
        xy, turns = search.found
        return view.placed(given[None], xy[None], turns[None])


class _Search:
    """The tree: a node is a list of bodies that stand, in ``order``."""

    def __init__(
        self,
        how: HolodeckDfs,
        view: QuarterTurns,
        xy: np.ndarray,
        turns: np.ndarray,
        rng: np.random.Generator,
        until: Callable[[], bool],
    ) -> None:
        self.how, self.view, self.rng, self.until = how, view, rng, until
        self.places = Places(view)
        self.order = self.places.order()
        self.xy, self.turns = xy.copy(), turns.copy()
        self.found, self.most, self.score = (xy.copy(), turns.copy()), -1, -np.inf
        self.full = sum(how.wall_bonus if len(w.bodies) == 1 else 1.0 for w in view.relations)

    def go(self, standing: list[int], score: float) -> bool:
        """Go on from a node; True when the search is over."""
        placed = sum(b >= 0 for b in standing)
        if (placed, score) > (self.most, self.score):
            self.most, self.score, self.found = placed, score, (self.xy.copy(), self.turns.copy())
        if len(standing) == len(self.order):
            return placed == len(self.order) and score >= self.full - 1e-9  # nothing can be better
        if self.until():
            return True
        body = self.order[len(standing)]
        here = [b for b in standing if b >= 0]
        for xy, turn, gain in self._branches(body, here):
            self.xy[body], self.turns[body] = xy, turn
            if self.go([*standing, body], score + gain):
                return True
        return self.until()

    def _branches(self, body: int, here: list[int]) -> list[tuple[np.ndarray, int, float]]:
        """The best places of a body, with their scores."""
        how, places = self.how, self.places
        spots, turns = places.grid(body, how.cell, self.rng.uniform(0, how.cell, 2), self.xy, self.turns, here)
        if not len(spots):
            return []
        at_walls, others = places.satisfied(body, spots, turns, self.xy, self.turns, here)
        if how.strict_walls and at_walls.shape[1] and at_walls.all(axis=1).any():
            keep = at_walls.all(axis=1)
            spots, turns, at_walls, others = spots[keep], turns[keep], at_walls[keep], others[keep]
        value = how.wall_bonus * at_walls.sum(axis=1) + others.sum(axis=1)
        first = np.lexsort((self.rng.random(len(value)), -value))[: how.branches]
        return [(spots[i], int(turns[i]), float(value[i])) for i in first]
