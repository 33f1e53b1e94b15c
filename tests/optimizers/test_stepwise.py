"""What all step-based optimisers keep to: bits, batch-mates, the best so far, what is fixed and what is carried."""

from __future__ import annotations

import time

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.geometry.se2 import relative
from sceneweaver.optimizers import Monitor, descent, judge, run
from sceneweaver.optimizers.batch import Batch
from tests.kernels.harness import batch_of, best_options, run_energy, zoo
from tests.layout.made import BOX, relation, scene
from tests.optimizers.batches import STEPWISE, batch, layouts_of, refined

SMALL = "bedroom-small"
each = pytest.mark.parametrize("optimizer", STEPWISE)


def energy_at(what: Batch) -> np.ndarray:
    """Energies [B] of a batch's poses with every relation's best option."""
    best_options(what)
    return run_energy(what).total


@each
@pytest.mark.parametrize("start", ["given", "random"])
def test_same_seed_same_bits(device, optimizer, start):
    a, b, c = (refined(batch([SMALL], 6, device, 0.2, seed=s), optimizer, 45, start)[0] for s in (1, 1, 2))
    assert a.tobytes() == b.tobytes()
    assert optimizer == "lbfgs" or a.tobytes() != c.tobytes()
    assert np.isfinite(a).all()


@each
def test_batch_mates_change_nothing(device, optimizer):
    """Neither more candidates of the room, nor those of other rooms before them."""
    whole, energies = refined(batch([SMALL], 37, device), optimizer, 33, "random")
    few, energy = refined(batch([SMALL], 5, device), optimizer, 33, "random")
    assert few.tobytes() == whole[:5].tobytes() and (energy == energies[:5]).all()
    mixed, _ = refined(batch(["living-dining-L", SMALL], 5, device), optimizer, 33, "random")
    assert mixed[5:, : few.shape[1]].tobytes() == few.tobytes()


@each
def test_threads_change_nothing(optimizer, monkeypatch):
    several, _ = refined(batch([SMALL], 40, "cpu"), optimizer, 21, "random")
    monkeypatch.setattr("os.sched_getaffinity", lambda _pid: {0}, raising=False)
    alone, _ = refined(batch([SMALL], 40, "cpu"), optimizer, 21, "random")
    assert alone.tobytes() == several.tobytes()


@each
@pytest.mark.parametrize("steps", [1, 2, 19, 20, 21, 64])
def test_energy_never_rises_and_is_that_of_the_layout(device, optimizer, steps):
    what = batch([SMALL, "office-20"], 3, device, 0.1)
    before = energy_at(what)
    _, energy = refined(what, optimizer, steps)
    assert (energy <= before * (1 + 1e-5) + 1e-6).all()
    np.testing.assert_allclose(energy, energy_at(what), rtol=1e-4, atol=1e-5)


@each
def test_more_steps_mend_more(device, optimizer):
    before = np.median(refined(batch(["living"], 16, device, 0.1), optimizer, 5)[1])
    after = np.median(refined(batch(["living"], 16, device, 0.1), optimizer, 200)[1])
    assert after < 0.2 * before


@each
def test_some_random_starts_become_valid(device, optimizer):
    what = batch(["dining-round"], 32, device, 0.0)
    refined(what, optimizer, 600, "random")
    assert np.mean(judge(what).status == 0) > 0.2


@each
def test_a_solved_layout_stays_solved(device, optimizer):
    problem = zoo("dining-round").room
    what = batch_of([problem], [0] * 4, [problem.home] * 4, device)
    assert (energy_at(what) < 1e-6).all()
    _, energy = refined(what, optimizer, 30)
    assert (energy < 1e-6).all()


@each
def test_the_fixed_stay_and_the_carried_follow(device, optimizer):
    problem = zoo("studio-U").room
    carried = np.flatnonzero(problem.roots != np.arange(problem.size))
    still = np.flatnonzero((problem.free == 0) & (problem.roots == np.arange(problem.size)))
    assert len(carried)
    layouts = np.array(layouts_of(problem, 8, 3, 0.2))
    what = batch_of([problem], [0] * 8, list(layouts), device)
    poses, _ = refined(what, optimizer, 60)
    assert np.abs(poses[:, still] - layouts[:, still]).max(initial=0.0) < 1e-5
    poses = poses.astype(float)
    d = relative(poses, poses[:, problem.roots]) - relative(layouts, layouts[:, problem.roots])
    d[..., 3] = (d[..., 3] + np.pi) % (2 * np.pi) - np.pi
    assert np.abs(d[:, carried]).max() < 2e-4
    assert np.abs(poses - layouts).max() > 0.01


@each
def test_heights_and_other_bound_coordinates_stay(device, optimizer):
    problem = zoo(SMALL).room
    layouts = np.array(layouts_of(problem, 4))
    what = batch_of([problem], [0] * 4, list(layouts), device)
    poses, _ = refined(what, optimizer, 40)
    bound = np.flatnonzero((problem.free & 4) == 0)
    roots = bound[problem.roots[bound] == bound]
    np.testing.assert_allclose(poses[:, roots, 2], layouts[:, roots, 2], atol=1e-6)


@each
def test_time_that_runs_out(device, optimizer):
    what = batch([SMALL], 4, device, 0.1)
    before = energy_at(what)
    monitor = Monitor(4, deadline=time.monotonic() - 1.0)
    energy = run(what, optimizer, "given", 10**6, monitor).energy
    assert monitor.timed_out and np.isfinite(what.state.poses.numpy()).all()
    begun = np.isfinite(energy)  # on a CPU that is busy, pieces after the first may find no time at all
    assert begun[0] and (energy <= before * (1 + 1e-5) + 1e-6)[begun].all()


@each
def test_progress_is_told_once_for_each_candidate(device, optimizer):
    monitor = Monitor(6)
    run(batch([SMALL], 6, device, 0.05), optimizer, "given", 10, monitor)
    assert monitor.done == 6 and 0 <= monitor.valid <= 6 and np.isfinite(monitor.best)


@pytest.mark.parametrize(("relations", "chosen"), [([], 0), ([relation("against_wall", "box")], 1)])
def test_the_last_step_is_the_last(relations, chosen, monkeypatch):
    calls = []

    class Spy(descent.Launches):
        def play(self, monitor, times=1, rest=0):
            calls.append((len(self), times, rest))
            return super().play(monitor, times, rest)

    monkeypatch.setattr(descent, "Launches", Spy)
    sw.refine(scene([BOX], relations), optimizer="adam", candidates=2, steps=2 * descent.REASSIGN + 4, device="cpu")
    launches = 2 * descent.REASSIGN  # slopes and a step
    assert calls[0] == (chosen + launches, 2, chosen + 2 * 5), "one step more than asked for measures the last"
