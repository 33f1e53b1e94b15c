"""Problems and poses to try the public face of the engine with."""

from __future__ import annotations

import os
from functools import cache

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import Problem
from tests.kernels.harness import ROOMS, ZOO, noisy, scattered
from tests.kernels.harness import zoo as compiled

DEVICE = os.environ.get("SCENEWEAVER_TEST_DEVICE", "cpu")  # of problems that JAX and PyTorch look at: cpu or cuda:0
KNEE = 0.05  # [m] of the penalties
FEW = ("bedroom-small", "dining-round", "living-dining-L")  # boxes; round tables; a room whose outside is no box


def rooms(mark) -> list:
    """All zoo rooms; those that take long bear the mark."""
    return [name if name in FEW else pytest.param(name, marks=mark) for name in ROOMS]


@cache
def problem_of(*names: str) -> Problem:
    """The problem of zoo rooms."""
    scenes = [sw.Scene.load(ZOO / f"{name}.json") for name in names]
    return sw.compile(scenes if len(names) > 1 else scenes[0], device=DEVICE)


def poses_of(name: str, count: int, seed: int = 0) -> np.ndarray:
    """Poses [B, N, 4] float32 of a zoo room: half of them scattered, half near the scene's own."""
    problem, rng = compiled(name).room, np.random.default_rng(seed)
    layouts = [scattered(problem, rng) if i % 2 else noisy(problem, rng, 0.1) for i in range(count)]
    return np.stack(layouts).astype(np.float32)


def check_differences(residuals, poses: np.ndarray, gradient: np.ndarray, count: int, least: float) -> None:
    """Compare a gradient [N, 4] at poses [N, 4] with differences by some coordinates, to 1e-3.

    Where differences over two steps agree, that is away from kinks: in a share of at least ``least``. ``residuals``
    gives those of poses [K, N, 4]. Their sum in float64 is the energy without what float32 loses in it: in a hall
    that is a thousand metres.
    """
    coordinates = np.argwhere(np.abs(gradient) > 0)
    coordinates = coordinates[np.random.default_rng(0).permutation(len(coordinates))[:count]]
    found, twice = (differences(residuals, poses, coordinates, step) for step in (2e-3, 4e-3))
    wanted = gradient[tuple(coordinates.T)]
    smooth = np.abs(found - twice) <= 5e-4 * (1.0 + np.abs(wanted))
    np.testing.assert_array_less(np.abs(found - wanted)[smooth], 1e-3 * (1.0 + np.abs(wanted))[smooth])
    assert smooth.mean() > least and smooth.sum() >= 3


def differences(residuals, poses: np.ndarray, coordinates: np.ndarray, step: float) -> np.ndarray:
    """Central differences of the energy by some coordinates [K, 2], in the steps that float32 takes."""
    moved = np.repeat(poses[None], 2 * len(coordinates), axis=0)
    rows = np.arange(len(coordinates))
    moved[2 * rows, coordinates[:, 0], coordinates[:, 1]] += np.float32(step)
    moved[2 * rows + 1, coordinates[:, 0], coordinates[:, 1]] -= np.float32(step)
    ends = moved[:, coordinates[:, 0].repeat(2), coordinates[:, 1].repeat(2)].astype(np.float64)
    along = ends[2 * rows, 2 * rows] - ends[2 * rows + 1, 2 * rows + 1]
    values = np.sum(np.asarray(residuals(moved), dtype=np.float64) ** 2, axis=1) / (2 * KNEE)
    return (values[2 * rows] - values[2 * rows + 1]) / along
