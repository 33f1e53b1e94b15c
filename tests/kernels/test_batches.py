"""Batches: several problems at once, padding, slices, poses that are no numbers."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.optimizers import Monitor, run
from sceneweaver.optimizers.batch import Batch
from sceneweaver.optimizers.verdict import judge
from tests.kernels.harness import (
    any_options,
    batch_of,
    best_options,
    energies,
    noisy,
    run_energy,
    scattered,
    verdict,
    zoo,
)
from tests.kernels.made import gallery

DIVERGED = 3


@pytest.fixture(scope="module")
def problems() -> list[LayoutProblem]:
    """Rooms of 11 to 24 objects, with 10 to 20 relations, and a surface without any."""
    made = compile_scene(gallery())
    rooms = [zoo(n).room for n in ("living", "bedroom-small", "studio-U", "living-dining-L")]
    return [*rooms, made.room, made.domains[0].problem]


@pytest.fixture
def mixture(problems, device) -> tuple[np.ndarray, list[np.ndarray], list[np.ndarray], Batch]:
    """Candidates of all problems in random order: problem, layout and options of each, and the batch."""
    rng = np.random.default_rng(41)
    which = rng.permutation(np.repeat(np.arange(len(problems)), 4))
    layouts = [scattered(problems[p], rng) if i % 2 else noisy(problems[p], rng, 0.01) for i, p in enumerate(which)]
    options = [any_options(problems[p], rng) for p in which]
    return which, layouts, options, batch_of(problems, which, layouts, device, options)


def test_same_numbers_as_alone(problems, mixture, device):
    which, layouts, options, batch = mixture
    together, judged = run_energy(batch), judge(batch)
    for c, p in enumerate(which):
        problem, n, r = problems[p], problems[p].size, len(problems[p].relations)
        alone = energies(problem, layouts[c][None], device, options=[options[c]])
        np.testing.assert_array_equal(together.share[c, :n], alone.share[0])
        np.testing.assert_array_equal(together.soft[c, :n], alone.soft[0])
        np.testing.assert_array_equal(together.gradient[c, :n], alone.gradient[0])
        found = verdict(problem, layouts[c][None], device)
        assert judged.status[c] == found.status[0]
        np.testing.assert_array_equal(judged.fault[c, :n], found.fault[0])
        np.testing.assert_array_equal(judged.holds[c, :r], found.holds[0, :r])


def test_best_options_same_as_alone(problems, mixture, device):
    which, layouts, _, batch = mixture
    best_options(batch)
    first = batch.keep.option_start.numpy()[batch.keep.relation_start.numpy()[:-1]]
    for c, p in enumerate(which):
        alone = batch_of([problems[p]], [0], [layouts[c]], device)
        if problems[p].relations:
            best_options(alone)
            r = len(problems[p].relations)
            mine = batch.state.options.numpy()[c, :r] - first[p]
            np.testing.assert_array_equal(mine, alone.state.options.numpy()[0, :r])


def test_padding_is_zero(problems, mixture):
    which, _, _, batch = mixture
    found, judged = run_energy(batch), judge(batch)
    for c, p in enumerate(which):
        n, r = problems[p].size, len(problems[p].relations)
        for values in (found.share, found.soft, found.gradient, judged.fault):
            assert not values[c, n:].any()
        assert judged.holds[c, r:].all()
    assert min(problems[p].size for p in which) < batch.objects


def test_slices_share_memory_and_numbers(mixture):
    *_, batch = mixture
    whole, status = run_energy(batch), judge(batch).status
    part = batch.part(5, 13)
    np.testing.assert_array_equal(run_energy(part).gradient, whole.gradient[5:13])
    np.testing.assert_array_equal(judge(part).status, status[5:13])


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_poses_that_are_no_numbers_are_diverged(device, value):
    problem = zoo("living-dining-L").room
    layouts = np.repeat(problem.home[None], 4 * problem.size + 1, axis=0)
    for c in range(4 * problem.size):
        layouts[c, c // 4, c % 4] = value
    batch = batch_of([problem], [0] * len(layouts), layouts, device)
    found = judge(batch)
    assert (found.status[:-1] == DIVERGED).all() and found.status[-1] == 0
    assert all(found.fault[c, c // 4] == DIVERGED for c in range(4 * problem.size))
    good = energies(problem, problem.home[None], device)
    np.testing.assert_array_equal(run_energy(batch).share[-1], good.share[0])  # its neighbours do not mind
    best_options(batch)


def test_everything_no_number(device):
    problem = zoo("studio-U").room
    batch = batch_of([problem], [0, 0], np.full((2, problem.size, 4), np.nan), device)
    assert (judge(batch).status == DIVERGED).all()
    best_options(batch)
    run_energy(batch)


@pytest.mark.parametrize("optimizer", ["search", "adam", "langevin", "lbfgs", "tempering", "projection"])
def test_optimisers_survive_poses_that_are_no_numbers(device, optimizer):
    problem = zoo("bedroom-small").room
    layouts = np.repeat(problem.home[None], 6, axis=0)
    layouts[0, 0, 0] = np.nan
    layouts[1, 3] = np.nan
    layouts[2, 2, 3] = np.inf
    layouts[3, -1, 2] = -np.inf
    layouts[4] = np.nan
    batch = batch_of([problem], [0] * 6, layouts, device)
    run(batch, optimizer, "given", 1 if optimizer == "search" else 20, Monitor(6))
    status = judge(batch).status
    assert status[5] == 0
    assert np.isfinite(batch.state.poses.numpy()[5]).all()
