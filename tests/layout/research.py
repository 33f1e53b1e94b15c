"""Problems and poses to try the public face of the engine with."""

from __future__ import annotations

import os
from functools import cache

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver import problems
from sceneweaver.layout import Problem
from tests.kernels.harness import ROOMS, ZOO, noisy, scattered
from tests.kernels.harness import zoo as compiled

DEVICE = os.environ.get("SCENEWEAVER_TEST_DEVICE", "cpu")  # of problems that JAX and PyTorch look at: cpu or cuda:0
KNEE = 0.05  # [m] of the penalties
FEW = ("dining-round", "living-dining-L")  # round tables; a room whose outside is no box


def rooms(mark, few: tuple[str, ...] = FEW) -> list:
    """All zoo rooms, and 20 of the frozen problems, of all families; all but a few bear the mark."""
    names = problems.names()
    chosen = [names[k] for k in np.linspace(0, len(names) - 1, 20).astype(int)]
    return [name if name in few else pytest.param(name, marks=mark) for name in (*ROOMS, *chosen)]


@cache
def problem_of(*names: str) -> Problem:
    """The problem of zoo rooms, or of frozen problems."""
    scenes = [problems.load(name).scene if "/" in name else sw.Scene.load(ZOO / f"{name}.json") for name in names]
    return sw.compile(scenes if len(names) > 1 else scenes[0], device=DEVICE)


def poses_of(name: str, count: int, seed: int = 0) -> np.ndarray:
    """Poses [B, N, 4] float32 of a room: half of them near the scene's own or the witness, half scattered."""
    if "/" in name:
        case, half = problems.load(name), -(-count // 2)
        near = case.start("perturbed" if case.witness is not None else "sample", half, seed)
        return np.stack([near, case.start("random", half, seed)], axis=1).reshape(-1, *near.shape[1:])[:count]
    problem, rng = compiled(name).room, np.random.default_rng(seed)
    layouts = [scattered(problem, rng) if i % 2 else noisy(problem, rng, 0.1) for i in range(count)]
    return np.stack(layouts).astype(np.float32)


def check_differences(residuals, poses: np.ndarray, gradient: np.ndarray, count: int, least: float) -> None:
    """Compare a gradient [N, 4] at poses [N, 4] with central differences by some coordinates, to 1e-3.

    Away from kinks, in a share of at least ``least``: where central differences over two steps agree, and forward and
    backward ones are apart by half as much over half the step, as a curve's are. A kink off the middle fails the first,
    one near the middle the second. ``residuals`` gives those of poses [K, N, 4]. Their sum in float64 is the energy
    without what float32 loses in it: in a hall that is a thousand metres.
    """
    coordinates = np.argwhere(np.abs(gradient) > 0)
    coordinates = coordinates[np.random.default_rng(0).permutation(len(coordinates))[:count]]
    (found, bend), (twice, bend_twice) = (differences(residuals, poses, coordinates, step) for step in (2e-3, 4e-3))
    wanted = gradient[tuple(coordinates.T)]
    scale = 1.0 + np.abs(wanted)
    smooth = (np.abs(found - twice) <= 5e-4 * scale) & (np.abs(bend_twice - 2 * bend) <= 2e-3 * scale)
    np.testing.assert_array_less(np.abs(found - wanted)[smooth], 1e-3 * scale[smooth])
    assert smooth.mean() > least and smooth.sum() >= 3


def differences(residuals, poses: np.ndarray, coordinates: np.ndarray, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Central differences of the energy by coordinates [K, 2], and by how much forward and backward ones are apart.

    In the steps that float32 takes.
    """
    moved = np.repeat(poses[None], 2 * len(coordinates) + 1, axis=0)
    rows, (obj, axis) = np.arange(len(coordinates)), coordinates.T
    for sign in (0, 1):
        moved[2 * rows + sign, obj, axis] += np.float32(step * (1 - 2 * sign))
    ends = np.stack([moved[2 * rows + sign, obj, axis] for sign in (0, 1)]).astype(np.float64)
    values = np.sum(np.asarray(residuals(moved), dtype=np.float64) ** 2, axis=1) / (2 * KNEE)
    ahead, behind = values[2 * rows], values[2 * rows + 1]
    middle = poses[obj, axis].astype(np.float64)
    forward, backward = (ahead - values[-1]) / (ends[0] - middle), (values[-1] - behind) / (middle - ends[1])
    return (ahead - behind) / (ends[0] - ends[1]), forward - backward
