"""Leaves as quarters of a disc, compared exactly, against points by the hundred thousand."""

from __future__ import annotations

import random

import numpy as np
import pytest

from sceneweaver.plans.checking.quarters import Quarter


def inside(quarter: Quarter, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    dx, dy = x - quarter.hinge[0], y - quarter.hinge[1]
    return (dx * quarter.way[0] > 0) & (dy * quarter.way[1] > 0) & (dx**2 + dy**2 < quarter.radius**2)


def points(box: tuple[int, int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    """200 x 200 points within a box."""
    x, y = (np.linspace(box[k], box[k + 2], 202)[1:-1] for k in (0, 1))
    return np.meshgrid(x, y)  # type: ignore[return-value]


def some(rng: random.Random) -> Quarter:
    way = rng.choice((-1, 1)), rng.choice((-1, 1))
    return Quarter((rng.randrange(-12, 13), rng.randrange(-12, 13)), rng.randrange(3, 12), way)


@pytest.mark.parametrize("seed", range(4))
def test_two_quarters_meet_where_points_lie_in_both(seed: int):
    rng = random.Random(seed)
    met = apart = 0
    while met < 40 or apart < 8:
        a, b = some(rng), some(rng)
        (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.box, b.box
        shared = max(ax0, bx0), max(ay0, by0), min(ax1, bx1), min(ay1, by1)
        if shared[0] >= shared[2] or shared[1] >= shared[3]:
            assert not a.meets(b)
            continue
        x, y = points(shared)
        expected = bool((inside(a, x, y) & inside(b, x, y)).any())
        assert a.meets(b) == b.meets(a) == expected, (a, b)
        met, apart = met + expected, apart + (not expected)


def test_a_quarter_meets_a_box_where_points_lie_in_both():
    rng = random.Random(7)
    found = [0, 0]
    for _ in range(400):
        quarter = some(rng)
        x, y = rng.randrange(-15, 12), rng.randrange(-15, 12)
        box = (x, y, x + rng.randrange(1, 10), y + rng.randrange(1, 10))
        expected = bool(inside(quarter, *points(box)).any())
        assert quarter.meets_box(box) == expected, (quarter, box)
        found[expected] += 1
    assert min(found) > 25


@pytest.mark.parametrize(("gap", "meets"), [(0, False), (1, True), (-1, False)])
def test_leaves_that_touch_do_not_meet(gap: int, meets: bool):
    """Two doors of 0.8 m face each other over a hall of 1.6 m: their arcs touch at one point."""
    left = Quarter((0, 0), 800, (1, 1))
    right = Quarter((1600 - gap, 0), 800, (-1, 1))
    assert left.meets(right) == right.meets(left) == meets


def test_arcs_that_touch_over_the_diagonal():
    """Hinges 5000 mm apart, 3000 and 4000 along the axes: arcs of 2000 and 3000 mm touch, with 1 mm more they meet."""
    near = Quarter((0, 0), 2000, (1, 1))
    assert not near.meets(Quarter((3000, 4000), 3000, (-1, -1)))
    assert near.meets(Quarter((3000, 4000), 3001, (-1, -1)))
