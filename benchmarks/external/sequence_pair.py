"""Simulated annealing of a sequence pair (Murata et al. 1996) in a fixed outline, in Python.

What fifty lines of a textbook do: two orders of the blocks, packed by longest paths; a move exchanges two blocks in one
order or in both, or turns one; wire length plus what reaches out of the outline is annealed with a geometric schedule
over the time there is. The temperature begins at the mean change of a random walk. The packing is centred in the
outline at the end, which changes no net. Blocks and nets only: it knows nothing of rooms, zones or relations.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from benchmarks.blocks import BlockProblem

HOT, COLD = 1.0, 1e-3  # of the mean change of a move
OUTSIDE = 8.0  # what a metre outside costs, in mean changes
SAMPLES = 200
CLOCK = 50  # moves between two looks at the clock


@dataclass(frozen=True)
class Packed:
    """The best packing inside the outline: wire length [m] (infinite: none), poses [N, 4], and moves tried."""

    length: float
    poses: np.ndarray
    moves: int


def reach(order: list[int], place: list[int], size: list[float], corner: list[float]) -> float:
    """Set the corners of all blocks along one axis by longest paths; how far they reach."""
    count = len(order)
    front = [0.0] * count
    for block in order:
        p = place[block]
        at = corner[block] = front[p]
        end = at + size[block]
        while p < count and front[p] < end:
            front[p] = end
            p += 1
    return front[-1]


def anneal(problem: BlockProblem, seed: int, seconds: float, clock: Callable[[], float] = time.perf_counter) -> Packed:
    """Anneal for so long by a clock [s]."""
    rng = np.random.default_rng(seed)
    count, side = len(problem.sizes), problem.side
    first, second = ([int(i) for i in rng.permutation(count)] for _ in range(2))
    place = [0] * count
    for p, block in enumerate(second):
        place[block] = p
    wide, high = (list(map(float, problem.sizes[:, axis])) for axis in range(2))
    turned = [False] * count
    one, other = problem.nets.T
    x, y = [0.0] * count, [0.0] * count

    def cost() -> tuple[float, float]:
        over = max(reach(first, place, wide, x) - side, 0.0) + max(reach(first[::-1], place, high, y) - side, 0.0)
        u, v = np.array(x) + 0.5 * np.array(wide), np.array(y) + 0.5 * np.array(high)
        return float(np.abs(u[one] - u[other]).sum() + np.abs(v[one] - v[other]).sum()), over

    def move() -> tuple[int, int, int]:
        what = int(draws.pop())
        i, j = int(draws.pop() * 0.1 * count), int(draws.pop() * 0.1 * count)
        apply(what, i, j)
        return what, i, j

    def apply(what: int, i: int, j: int) -> None:
        a, b = first[i], first[j]
        if what < 3:
            wide[a], high[a], turned[a] = high[a], wide[a], not turned[a]
        if 3 <= what < 5 or what >= 7:
            first[i], first[j] = b, a
        if what >= 5:
            place[a], place[b] = place[b], place[a]

    draws: list[float] = []
    length, over = cost()
    heat, moves, began, past = 0.0, 0, clock(), 0.0
    best, best_poses = math.inf, np.zeros((count, 4))
    while past < 1.0:
        if len(draws) < 4:
            draws = list(10.0 * rng.random(4 * CLOCK))
            past = (clock() - began) / seconds
        done = move()
        now, out = cost()
        change = now - length
        if moves < SAMPLES:
            heat += abs(change) / SAMPLES
        change += OUTSIDE * heat * (out - over)
        temperature = max(heat * HOT * (COLD / HOT) ** past, 1e-9)
        moves += 1
        if change <= 0.0 or 0.1 * draws.pop() < math.exp(-change / temperature):
            length, over = now, out
            if over <= 0.0 and length < best:
                best, best_poses = length, _poses(x, y, wide, high, turned, side)
        else:
            apply(*done)
    return Packed(best, best_poses, moves)


def _poses(x, y, wide, high, turned, side: float) -> np.ndarray:
    """Poses of the blocks, centred in the outline."""
    low, size = np.stack([x, y], axis=-1), np.stack([wide, high], axis=-1)
    spare = 0.5 * (side - (low + size).max(axis=0))
    yaw = np.where(turned, math.pi / 2, 0.0)[:, None]
    return np.concatenate([low + 0.5 * size + spare, np.zeros_like(yaw), yaw], axis=-1)
