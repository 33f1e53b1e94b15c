"""Batches and runs for the tests of the optimisers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.optimizers import Batch, Monitor, run, streams
from tests.kernels.harness import batch_of, noisy, scattered, zoo

STEPWISE = ("adam", "langevin", "lbfgs", "tempering")  # a budget of these is a number of steps


def layouts_of(problem: LayoutProblem, count: int, seed: int = 0, scale: float | None = None) -> list[np.ndarray]:
    """Layouts [N, 4] at the scene's own heights: its own layout disturbed by so much, or scattered over the room."""
    rng = np.random.default_rng(seed)
    layouts = [
        scattered(problem, rng) if scale is None else noisy(problem, rng, scale, rigid=True) for _ in range(count)
    ]
    for layout in layouts:
        layout[:, 2] = problem.home[:, 2]
    return layouts


def batch(names: Sequence[str], count: int, device: str, scale: float | None = None, seed: int = 0) -> Batch:
    """``count`` candidates of each zoo room, room after room."""
    problems = [zoo(name).room for name in names]
    layouts = [layout for problem in problems for layout in layouts_of(problem, count, 7, scale)]
    made = batch_of(problems, np.repeat(np.arange(len(names)), count), layouts, device)
    made.state.rng.assign(np.tile(streams(seed, np.arange(count)), len(names)))
    return made


def refined(what: Batch, optimizer: str, steps: int, start: str = "given") -> tuple[np.ndarray, np.ndarray]:
    """Poses [B, N, 4] and energies [B] after so many steps."""
    energy = run(what, optimizer, start, steps, Monitor(what.size)).energy
    return what.state.poses.numpy(), energy
