"""Parallel tempering: both Metropolis rules leave their distributions as they are; replicas belong to candidates."""

from __future__ import annotations

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels.tempering import FIRST, GROUP, LANGEVIN, accept, exchange, make_moves
from sceneweaver.optimizers.descent import new_gradients, threads
from sceneweaver.optimizers.tempering import REPLICAS, ladder_of, parts, replicate
from tests.kernels.harness import batch_of, zoo
from tests.optimizers.batches import batch

ROOM = "bedroom-small"


@pytest.fixture
def made(device):
    """Many candidates with their replicas, a ladder and random streams."""
    problem, count = zoo(ROOM).room, 8192
    what = batch_of([problem], [0] * count, np.repeat(problem.home[None], count, axis=0), device)
    what.state.rng.assign(np.random.default_rng(0).integers(2**32, size=count, dtype=np.uint32))
    ladder = ladder_of(what, 0.2)
    return what, replicate(what, ladder.rung), ladder


def by_rung(ladder, values: np.ndarray) -> np.ndarray:
    """Values [candidate, rung] from those of rows; fails unless each candidate holds every rung once."""
    rung = ladder.rung.numpy().reshape(-1, REPLICAS)
    np.testing.assert_array_equal(np.sort(rung, axis=1), np.broadcast_to(np.arange(REPLICAS), rung.shape))
    return np.take_along_axis(values.reshape(-1, REPLICAS), np.argsort(rung, axis=1), axis=1)


def test_replicas_are_copies_with_streams_of_their_own(made):
    what, rows, ladder = made
    poses = rows.state.poses.numpy().reshape(what.size, REPLICAS, -1, 4)
    assert (poses == what.state.poses.numpy()[:, None]).all()
    assert len(np.unique(rows.state.rng.numpy())) > 0.999 * rows.size
    assert (by_rung(ladder, np.tile(np.arange(REPLICAS), what.size)) == np.arange(REPLICAS)).all()


def test_exchanges_keep_the_distribution_of_every_rung(made):
    """Where all energies are equally dense, those at temperature T are exponential with mean T, and stay so."""
    what, rows, ladder = made
    temperature = ladder.temperature.numpy()
    energy = np.random.default_rng(1).exponential(np.tile(temperature, what.size)).astype(np.float32)
    ladder.energy.assign(energy)
    ladder.total.assign(energy)
    went = np.zeros(REPLICAS - 1)
    before = ladder.rung.numpy().copy()
    for _ in range(6):
        wp.launch(exchange, what.size, [REPLICAS, rows.state], [ladder], device=what.device)
        after = ladder.rung.numpy().copy()
        for k in range(REPLICAS - 1):
            went[k] += np.mean((before == k) & (after == k + 1)) * REPLICAS
        before = after
        found = by_rung(ladder, energy)
        np.testing.assert_allclose(found.mean(axis=0), temperature, rtol=0.06)
        np.testing.assert_allclose(np.median(found, axis=0), temperature * np.log(2), rtol=0.08)
    assert (went / 3 > 0.1).all() and (went / 3 < 0.9).all()
    assert (ladder.clock.numpy() == 6).all()


def test_the_best_of_all_replicas_is_noted(made):
    what, rows, ladder = made
    energy = np.random.default_rng(2).uniform(1.0, 2.0, rows.size).astype(np.float32)
    ladder.energy.assign(energy)
    ladder.total.assign(energy)
    for again in (1, 0):  # the second time nothing is better than what is known
        wp.launch(exchange, what.size, [REPLICAS, rows.state], [ladder], device=what.device)
        better = ladder.better.numpy().reshape(-1, REPLICAS)
        assert (better.sum(axis=1) == again).all()
    np.testing.assert_array_equal(ladder.lowest.numpy(), energy.reshape(-1, REPLICAS).min(axis=1))


@pytest.mark.parametrize("adjusted", [True, False])
def test_langevin_steps_keep_their_distribution(made, adjusted):
    """In a bowl of stiffness k, coordinates at temperature T have variance T / k, and keep it; taking every step (the
    unadjusted algorithm) widens it, so that the test would notice."""
    what, rows, ladder = made
    device, stiffness, step_size, coordinates = what.device, 20.0, 0.045, 3
    rung = ladder.rung.numpy()
    temperature = ladder.temperature.numpy()[rung][:, None]
    rng = np.random.default_rng(3)
    x = rng.normal(size=(rows.size, coordinates)) * np.sqrt(temperature / stiffness)
    ladder.energy.assign(0.5 * stiffness * np.sum(x**2, axis=1))
    ladder.step_size.fill_(step_size)
    measured = new_gradients(rows)

    def vectors(values: np.ndarray) -> np.ndarray:
        full = np.zeros((rows.objects, rows.size, 4), dtype=np.float32)
        full[0, :, :coordinates] = values
        return full

    accepted = np.zeros(rows.size)
    for k in range(12):
        d = rng.normal(size=x.shape) * np.sqrt(2 * step_size * temperature) - step_size * stiffness * x
        y = x + d
        shares = np.zeros((rows.objects, rows.size), dtype=np.float32)
        shares[0] = 0.5 * stiffness * np.sum(y**2, axis=1)
        measured.share.assign(shares)
        measured.gradient.assign(vectors(stiffness * y))
        ladder.gradient.assign(vectors(stiffness * x))
        ladder.step.assign(vectors(d))
        ladder.move.fill_(LANGEVIN)
        ladder.clock.fill_(10**8 + k)  # the step size hardly adapts any more
        wp.launch(accept, rows.size, [rows.problems, REPLICAS, 0.0, rows.state, measured], [ladder], device=device)
        yes = ladder.accepted.numpy() == 1
        accepted += yes
        x = np.where(yes[:, None], y, x) if adjusted else y
    variance = np.array([np.var(x[rung == k]) * stiffness for k in range(REPLICAS)]) / ladder.temperature.numpy()
    if adjusted:
        np.testing.assert_allclose(variance, 1.0, rtol=0.05)
        assert 0.3 < accepted.mean() / 12 < 0.95
        np.testing.assert_allclose(ladder.energy.numpy(), 0.5 * stiffness * np.sum(x**2, axis=1), rtol=1e-3, atol=1e-6)
    else:
        assert (variance > 1.3).all()


@pytest.mark.parametrize("group", [False, True])
def test_a_jump_moves_one_object_or_its_group_as_one(device, group):
    problem = zoo(ROOM).room
    what = batch([ROOM], 32, device, 0.05)
    ladder = ladder_of(what, 0.2)
    rows = replicate(what, ladder.rung)
    tables = rows.keep
    start, members = tables.group_start.numpy(), tables.group.numpy()
    root = max(range(problem.size), key=lambda i: start[i + 1] - start[i])
    together = set(members[start[root] : start[root + 1]].tolist())
    carried = {i for i in range(problem.size) if problem.roots[i] == root}
    ladder.move.fill_(root + (int(GROUP) if group else 0))
    proposal = rows.scratch()
    inputs = [rows.problems, REPLICAS, new_gradients(rows)]
    wp.launch(make_moves, threads(rows, rows.objects), inputs, [ladder, rows.state, proposal], device=device)
    before, after = rows.state.poses.numpy(), proposal.poses.numpy()
    moved = set(np.flatnonzero(np.abs(after - before)[..., :2].max(axis=(0, 2)) > 1e-3).tolist())
    assert len(together) > 1 and moved == (together if group else carried)
    x0, y0, x1, y1 = problem.region.box
    at = after[:, root]
    assert (at[:, 0] >= x0).all() and (at[:, 0] <= x1).all() and (at[:, 1] >= y0).all() and (at[:, 1] <= y1).all()
    assert np.ptp(at[:, 0]) > 0.8 * (x1 - x0)
    np.testing.assert_array_equal(after[..., 2], before[..., 2])
    for i in moved:
        d, e = after[:, i, :2] - after[:, root, :2], before[:, i, :2] - before[:, root, :2]
        np.testing.assert_allclose(np.hypot(*d.T), np.hypot(*e.T), atol=1e-4)


def test_a_start_is_taken_as_it_is(made):
    what, rows, ladder = made
    assert (ladder.move.numpy() == FIRST).all()
    measured = new_gradients(rows)
    measured.share.fill_(3.0)
    wp.launch(accept, rows.size, [rows.problems, REPLICAS, 0.5, rows.state, measured], [ladder], device=what.device)
    assert (ladder.accepted.numpy() == 1).all()
    np.testing.assert_allclose(ladder.energy.numpy(), 3.0 * rows.objects)
    moves = ladder.move.numpy()
    assert 0.4 < np.mean(moves != LANGEVIN) < 0.55, "half jump, unless no object that may was found"


@pytest.mark.parametrize("steps", [1, 2, 3, 4, 39, 400, 5000])
def test_parts_are_all_of_the_budget(steps):
    lead, tempered, polish = parts(steps)
    assert lead + tempered + polish == steps and min(lead, polish) >= 0 and tempered > 0
