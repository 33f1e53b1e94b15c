"""Rooms with many objects."""

import numpy as np
import pytest

import sceneweaver as sw
from tests.layout.made import zoo


@pytest.mark.parametrize(("name", "candidates"), [("restaurant-60", 8), ("library-100", 4), ("hall-300", 2)])
def test_random_starts_become_valid(name, candidates):
    solution = sw.refine(zoo(name), init="random", candidates=candidates, seed=1, device="cpu")
    assert np.mean(solution.status == 0) >= 0.5
    for i in np.flatnonzero(solution.status == 0):
        assert sw.check(solution.scene(int(i)), walkable=False).valid


@pytest.mark.parametrize("optimizer", ["adam", "langevin", "lbfgs", "tempering"])
def test_every_optimizer_takes_large_rooms(optimizer):
    options = {"init": "random", "candidates": 2, "optimizer": optimizer, "device": "cpu", "explain": False}
    first, later = (sw.refine(zoo("library-100"), steps=steps, **options) for steps in (1, 20))
    assert np.isfinite(later.poses).all()
    assert (later.energy < 0.95 * first.energy).all()
