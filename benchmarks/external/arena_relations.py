"""Adam on losses of relations between boxes along the axes, positions only, as Isaac Lab Arena's relation solver.

Its documented defaults (600 steps, rate 0.01, linear losses, shared volume of boxes at a large slope) with the losses
of `benchmarks.rivals.torch_positions`, written from a description: relations at a side (a half plane, a band, a
distance) are hinges, and so are distances, walls and corners.

Fairness: yaw never changes, so a candidate whose start is turned wrongly can not become valid, and starts here are
drawn at any yaw where no relation says one; boxes along the axes are larger than turned bodies; which wall or side is
meant is settled by the start. It knows nothing of zones, doors, facing, alignment, or objectives. ``square`` turns
starts to the nearest quarter of the room first, which its own users do by hand.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import torch

from benchmarks.rivals.torch_positions import Placement
from benchmarks.rivals.torch_support import pick
from benchmarks.starts import movable
from sceneweaver.layout import Problem

from .one_by_one import Solving
from .quarter_turns import quarter_turns

INNER = 20  # steps of Adam in one of the protocol


@dataclass(frozen=True)
class ArenaRelations:
    rate: float = 0.01  # [m]
    square: bool = True
    polish: bool = False  # give the end to the engine's projection
    steps: int = 30
    seconds: float = math.inf  # of processor time, two thirds of which are for the descent where it is polished

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"rate": [0.003, 0.01, 0.03], "square": [True, False]}

    def configure(self, objective: Sequence[Any], seconds: float) -> ArenaRelations:
        """The optimiser for a budget [s]; it knows no objectives."""
        return replace(self, seconds=seconds)

    def init(self, problem: Problem, poses: Any, key: int) -> Solving:
        given = np.asarray(poses.numpy(), dtype=np.float32)
        begin = given.copy()
        if self.square:
            view = quarter_turns(problem)
            begin = problem.carry(view.placed(given, *view.spot(given.astype(float))).astype(np.float32), like=given)
        torch.set_num_threads(1)  # of tensors this small: more cost processor time and save none
        scene, device = problem.scenes[0], pick(problem.device)
        floor = movable(scene)
        p = torch.tensor(begin[:, floor, :2], dtype=torch.float32, device=device, requires_grad=True)
        adam = torch.optim.Adam([p], lr=self.rate)
        notes = {
            "loss": Placement(scene, begin, problem.device),
            "p": p,
            "adam": adam,
            "floor": floor,
            "began": time.process_time(),
        }
        notes["began"] = time.process_time()
        return Solving(problem, begin, begin.copy(), key, notes=notes)

    def step(self, state: Solving) -> Solving:
        p, adam = state.notes["p"], state.notes["adam"]
        for _ in range(INNER if len(state.notes["floor"]) else 0):
            adam.zero_grad()
            state.notes["loss"](p).backward()
            adam.step()
        state.poses[:, state.notes["floor"], :2] = p.detach().cpu().numpy()
        state.turn += 1
        late = time.process_time() - state.notes["began"] > 2 / 3 * self.seconds
        if self.polish and (state.turn == self.steps or late):
            layouts = state.problem.carry(state.poses, like=state.given)
            state.poses, state.notes["polished"] = state.problem.project(layouts), True
        return state

    def done(self, state: Solving) -> bool:
        """Whether it was polished."""
        return "polished" in state.notes

    def best(self, state: Solving) -> np.ndarray:
        return state.poses

    def counts(self, state: Solving) -> tuple[int, int]:
        return INNER * state.turn, INNER * state.turn * len(state.given)
