"""Rooms of more than 40 objects, where only objects in cells nearby are looked at: same numbers as with all pairs."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.batch import make_batch
from sceneweaver.optimizers import Monitor, judge, load_poses, run
from sceneweaver.optimizers.batch import Batch
from tests.kernels.harness import (
    LARGE,
    any_options,
    batch_of,
    best_options,
    noisy,
    run_energy,
    scattered,
    use_cells,
    zoo,
)


def layouts_of(name: str, rng: np.random.Generator, count: int) -> list[np.ndarray]:
    """Anywhere in the room and out of it, and near the room's own layout."""
    problem = zoo(name).room
    far = [scattered(problem, rng) + rng.normal(size=(problem.size, 4)) * (3.0, 3.0, 0.0, 0.0) for _ in range(2)]
    return far + [noisy(problem, rng, 0.1) for _ in range(count - 2)]


def fresh(name: str, layouts: list[np.ndarray], device: str) -> Batch:
    """A batch as the engine makes it."""
    batch = make_batch([zoo(name).room], np.zeros(len(layouts), dtype=int), device)
    load_poses(batch, np.array(layouts))
    return batch


def assert_lists_end(batch: Batch) -> None:
    """A new state either has no cells or empty ones: lists that run in circles would hang the device."""
    head = batch.state.cell_head.numpy()
    assert head.shape[1] == 1 or (head == -1).all()


@pytest.mark.parametrize("name", LARGE)
def test_cells_change_nothing(device, name):
    rng = np.random.default_rng(51)
    problem, layouts = zoo(name).room, layouts_of(name, rng, 6)
    options = [any_options(problem, rng) for _ in layouts]
    batch = batch_of([problem], [0] * len(layouts), layouts, device, options)
    every = run_energy(batch)
    near = run_energy(use_cells(batch))
    np.testing.assert_allclose(near.share, every.share, rtol=1e-5, atol=1e-5)
    np.testing.assert_allclose(near.soft, every.soft, rtol=1e-5, atol=1e-5)
    np.testing.assert_allclose(near.gradient, every.gradient, rtol=1e-4, atol=1e-4)


def test_crowds_and_small_rooms_in_one_batch(device):
    rng = np.random.default_rng(52)
    problems = [zoo(n).room for n in ("bedroom-small", "restaurant-60", "library-100", "living-dining-L")]
    which = [0, 1, 2, 3] * 3
    layouts = [scattered(problems[p], rng) for p in which]
    batch = batch_of(problems, which, layouts, device)
    best_options(batch)
    every = run_energy(batch)
    near = run_energy(use_cells(batch))
    np.testing.assert_allclose(near.share, every.share, rtol=1e-5, atol=1e-5)


def test_new_state_of_a_crowd_is_ready_for_use(device):
    rng = np.random.default_rng(53)
    layouts = layouts_of("restaurant-60", rng, 4)
    batch = fresh("restaurant-60", layouts, device)
    assert_lists_end(batch)
    best_options(batch)
    found = run_energy(batch)
    other = batch_of([zoo("restaurant-60").room], [0] * 4, layouts, device)
    best_options(other)
    np.testing.assert_allclose(found.share, run_energy(other).share, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize(
    ("optimizer", "budget"), [("adam", 12), ("langevin", 12), ("lbfgs", 12), ("tempering", 12), ("search", 1)]
)
def test_optimisers_know_the_energy_of_a_crowd(device, optimizer, budget):
    """The energy that an optimiser tells for a layout that it could not solve is the layout's energy."""
    rng = np.random.default_rng(54)
    problem = zoo("restaurant-dense").room
    layouts = [noisy(problem, rng, 0.3, rigid=True) for _ in range(6)]
    batch = fresh("restaurant-dense", layouts, device)
    assert_lists_end(batch)
    outcome = run(batch, optimizer, "given", budget, Monitor(6))
    unsolved = judge(batch).status != 0
    final = batch.state.poses.numpy().astype(float)
    other = batch_of([problem], [0] * 6, list(final), device)
    if optimizer == "search":  # its relations take the best option wherever they are looked at
        best_options(other)
    else:
        other.state.options = batch.state.options
    np.testing.assert_allclose(outcome.energy[unsolved], run_energy(other).total[unsolved], rtol=1e-3, atol=1e-3)
