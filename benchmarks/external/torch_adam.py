"""Adam of PyTorch on the energy, with a cosine rate and annealed noise; the best of each layout is kept."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import torch
import warp as wp

import sceneweaver.torch as swt
from sceneweaver.layout import Problem

INNER = 20  # steps of Adam in one of the protocol


@dataclass
class Walk:
    problem: Problem
    like: Any  # Warp array [B, N, 4]: where it began
    x: torch.Tensor
    free: torch.Tensor
    adam: torch.optim.Adam
    rate: torch.optim.lr_scheduler.CosineAnnealingLR
    random: torch.Generator
    best: torch.Tensor
    lowest: torch.Tensor
    steps: int = 0


@dataclass(frozen=True)
class TorchAdam:
    rate: float = 0.12  # [m] and [rad]
    noise: float = 0.06
    steps: int = 20

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"rate": [0.03, 0.12, 0.3], "noise": [0.0, 0.06, 0.2]}

    def init(self, problem: Problem, poses: Any, key: int) -> Walk:
        given = wp.to_torch(poses).reshape(*poses.shape[:2], 4)
        x = given.clone().requires_grad_()
        free = swt.free(problem, x.device)[problem.scene_of(len(x))]
        adam = torch.optim.Adam([x], lr=self.rate, betas=(0.9, 0.99), eps=1e-6)
        rate = torch.optim.lr_scheduler.CosineAnnealingLR(adam, INNER * self.steps, eta_min=0.005 * self.rate)
        random = torch.Generator(x.device).manual_seed(key)
        lowest = torch.full((len(x),), torch.inf, device=x.device)
        return Walk(problem, poses, x, free, adam, rate, random, given.clone(), lowest)

    def step(self, state: Walk) -> Walk:
        total = INNER * self.steps
        for _ in range(INNER):
            state.adam.zero_grad()
            energy = swt.energy(state.problem, state.x)
            energy.sum().backward()
            with torch.no_grad():
                better = energy < state.lowest
                state.best[better], state.lowest = state.x[better], torch.minimum(energy, state.lowest)
                state.x.grad *= state.free
                state.adam.step()
                noise = self.noise * max(0.0, 1 - state.steps / (0.6 * total))
                drawn = torch.randn(state.x.shape, generator=state.random, device=state.x.device)
                state.x += noise * drawn * state.free
            state.rate.step()
            state.steps += 1
        with torch.no_grad():  # once a step is enough: what is carried does not pull on its root
            state.x.copy_(torch.as_tensor(state.problem.carry(state.x.detach().contiguous(), like=state.like)))
        return state

    def best(self, state: Walk) -> torch.Tensor:
        return state.best
