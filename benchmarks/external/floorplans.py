"""Annealing of floor plans in a fixed outline: what B*-trees and sequence pairs have in common.

Blocks are packed towards a corner of the room; a move changes the representation, turns a block by a quarter, or (one
in twenty) takes another corner, since doors and pockets keep some free. Metropolis accepts at a temperature that falls
geometrically. The cost is that of Adya and Markov (2003) for a fixed outline, by how much the packing reaches beyond
it, with the length of the nets, and what the engine says of the rest.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Protocol

import numpy as np

from sceneweaver.layout import Problem

from .objectives import Lengths, nets_of
from .one_by_one import OneByOne
from .quarter_turns import QuarterTurns, quarter_turns


class Packing(Protocol):
    """How blocks lie relative to each other."""

    def pack(self, width: list[float], height: list[float]) -> tuple[list[float], list[float]]:
        """Lower left corners of blocks of these sizes [m]."""
        ...

    def moved(self, rng: np.random.Generator) -> Packing:
        """Another one, by one move."""
        ...


@dataclass(frozen=True)
class Floorplan(OneByOne):
    """The annealing; subclasses say which packing.

    Attributes:
        moves: of a run; more than time allows are cut off.
        hottest, coldest: temperatures, as shares of the mean change of cost at the start.
        gap: air around blocks [m].
        zones: whether a block has its hard zones with it.
        outline, energy: weights of a metre beyond the outline, and of the engine's energy [m] of the layout.
    """

    moves: int = 4000
    hottest: float = 1.0
    coldest: float = 0.002
    gap: float = 0.002
    zones: bool = True
    outline: float = 10.0
    energy: float = 1.0
    limit: float = 2.0

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "moves": [1000, 4000, 16000],
        "hottest": [0.3, 1.0, 3.0],
        "zones": [True, False],
        "outline": [3.0, 10.0, 30.0],
        "energy": [0.0, 1.0],
    }

    def configure(self, objective: Sequence[Any], seconds: float) -> Floorplan:
        """As of all; as many moves as the time is longer."""
        found = super().configure(objective, seconds)
        return replace(found, moves=max(WARM, round(self.moves * found.limit / self.limit)))

    def packing(self, blocks: int, rng: np.random.Generator) -> Packing:
        """One to begin with."""
        raise NotImplementedError

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        view, rng = quarter_turns(problem, given), np.random.default_rng(seed)
        cost = Cost(self, problem, view, given)
        now, turns = self.packing(len(view.bodies), rng), cost.turns.copy()
        corner = 0
        value = best = cost(now, turns, corner)
        found, scale, changes = cost.poses, 1.0, []
        for move in range(self.moves):
            if until() or cost.solved(best, found):
                break
            new, new_turns, new_corner, kind = now, turns, corner, rng.random()
            if kind < 0.05:
                new_corner = int(rng.integers(4))
            elif kind < 0.35:
                body = int(rng.integers(len(turns)))
                new_turns = turns.copy()
                new_turns[body] = rng.integers(len(view.bodies[body].yaws))
            else:
                new = now.moved(rng)
            temperature = scale * self.hottest * (self.coldest / self.hottest) ** (move / self.moves)
            warm = move < WARM  # everything is taken until it is known how large changes are
            most = math.inf if warm else value - temperature * math.log(1.0 - rng.random())
            after = cost(new, new_turns, new_corner, most)
            if warm:
                changes.append(abs(after - value))
                scale = float(np.mean(changes)) + 1e-9
            if after <= most:
                now, turns, corner, value = new, new_turns, new_corner, after
                if value < best:
                    best, found = value, cost.poses
        return found


WARM = 50  # moves that are all taken
ASK = 0.5  # cost [m] from which on it is asked whether a layout is valid


class Cost:
    """The cost of a packing; ``poses`` [N, 4] are those of the last one."""

    def __init__(self, how: Floorplan, problem: Problem, view: QuarterTurns, given: np.ndarray) -> None:
        self.how, self.problem, self.view, self.given = how, problem, view, given
        self.nets = nets_of(problem, how.objective)
        self.lengths = Lengths(self.nets, view)
        _, turns = view.spot(given[None])
        self.turns, self.poses = turns[0], given
        self.excess, self.asked = 0.0, math.inf
        self.boxes = []
        for body in view.bodies:
            parts = np.concatenate([body.solids, body.zones]) if how.zones else body.solids
            box = np.concatenate([parts[..., :2].min(axis=0), parts[..., 2:].max(axis=0)], axis=1)
            self.boxes.append(box + how.gap * np.array([-0.5, -0.5, 0.5, 0.5]))
        self.weight = max(1.0, 2.0 * sum(net.weight for net in self.nets))  # leaving the outline never pays

    def __call__(self, packing: Packing, turns: np.ndarray, corner: int, most: float = math.inf) -> float:
        """The cost with blocks packed to one of four corners; more than ``most`` is returned as soon as it is known."""
        boxes = [box[t] for box, t in zip(self.boxes, turns.tolist(), strict=True)]
        x, y = packing.pack([b[2] - b[0] for b in boxes], [b[3] - b[1] for b in boxes])
        x0, y0, x1, y1 = self.view.box
        wide = max((x[i] + b[2] - b[0] for i, b in enumerate(boxes)), default=0.0)
        high = max((y[i] + b[3] - b[1] for i, b in enumerate(boxes)), default=0.0)
        self.excess = max(0.0, wide + self.how.gap - (x1 - x0)) + max(0.0, high + self.how.gap - (y1 - y0))
        total = self.how.outline * self.weight * self.excess
        if total > most:
            return total
        box = np.array(boxes).reshape(-1, 4)
        low = np.stack([x, y], axis=1) + (x0, y0) + self.how.gap / 2
        high_side = np.array([x0 + x1, y0 + y1]) - low - (box[:, 2:] - box[:, :2])
        xy = np.where([corner % 2 == 1, corner >= 2], high_side, low) - box[:, :2]
        if self.nets:
            total += self.lengths(xy, turns)
            if total > most:
                return total
        self.poses = self.view.placed(self.given[None], xy[None], turns[None])[0]
        if self.how.energy:
            layout = self._carried(self.poses)
            total += self.how.energy * self.weight * float(self.problem.energy(layout)[0])
        return total

    def solved(self, value: float, poses: np.ndarray) -> bool:
        """Whether nothing is left to do: no nets, and the layout [N, 4] of that cost is valid."""
        if self.nets or value > ASK or value >= self.asked:
            return False
        self.asked = value
        return bool(self.problem.feasible(self._carried(poses))[0])

    def _carried(self, poses: np.ndarray) -> np.ndarray:
        layout = poses[None].astype(np.float32)
        if (self.problem.roots[0] == np.arange(self.problem.objects)).all():
            return layout
        return self.problem.carry(layout, like=self.given[None].astype(np.float32))
