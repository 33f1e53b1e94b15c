"""Pairs of things at sample poses, for residuals of the user's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .user import WIDTH

RANDOM, CLOSE, SAME = 160, 80, 16  # pairs of poses: anywhere, near each other and often square, coincident


@dataclass(frozen=True)
class Samples:
    """Pairs of things: poses [K, 4] (x, y, z, yaw) and sizes [K, 3] of both, and params [K, 4]."""

    a: np.ndarray
    b: np.ndarray
    size_a: np.ndarray
    size_b: np.ndarray
    params: np.ndarray

    def words(self, k: int) -> str:
        """The poses of a pair."""
        a, b = (f"({', '.join(f'{v:.3g}' for v in pose[k])})" for pose in (self.a, self.b))
        return f"a at {a}, b at {b} (x, y, z, yaw)"


def anywhere(count: int, seed: int) -> Samples:
    """Random pairs of poses, for things and params of the same sizes."""
    rng = np.random.default_rng(seed)
    a, b = (_poses(rng, count) for _ in "ab")
    size_a, size_b = (
        np.tile(np.array(size, dtype=np.float32), (count, 1)) for size in ((0.6, 0.8, 0.9), (0.5, 1.1, 0.7))
    )
    return Samples(a, b, size_a, size_b, np.full((count, WIDTH), 0.5, dtype=np.float32))


def pairs_of(params: Sequence[float], pairs: bool) -> Samples:
    """Pairs of things of many sizes: anywhere, close to each other and often square, and at the same pose.

    Without ``pairs`` there is no second thing: its pose and size are 0, as the engine has it.
    """
    rng, count = np.random.default_rng(0), RANDOM + CLOSE + SAME
    a, b = (_poses(rng, count) for _ in "ab")
    a[RANDOM:] = b[RANDOM:]
    a[RANDOM : RANDOM + CLOSE, :3] += rng.normal(0.0, (0.7, 0.7, 0.2), (CLOSE, 3))
    a[RANDOM::2, 3] = b[RANDOM::2, 3] = 0.0
    a[RANDOM : RANDOM + CLOSE : 4, 3] = 0.5 * np.pi
    a[:, 2] = np.abs(a[:, 2])
    size_a, size_b = (rng.uniform(0.2, 1.5, (count, 3)).astype(np.float32) for _ in "ab")
    if not pairs:
        b, size_b = np.zeros_like(b), np.zeros_like(size_b)
    row = np.array([*params, *[0.0] * (WIDTH - len(params))], dtype=np.float32)
    return Samples(a, b, size_a, size_b, np.tile(row, (count, 1)))


def _poses(rng: np.random.Generator, count: int) -> np.ndarray:
    return rng.uniform((-3.0, -3.0, 0.0, -np.pi), (3.0, 3.0, 2.0, np.pi), (count, 4)).astype(np.float32)
