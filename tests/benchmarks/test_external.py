"""Optimisers of other libraries take part like anyone's: they lower the energy, move what may move, and count."""

from __future__ import annotations

import importlib

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.layout import Problem, StepOptimizer
from tests.layout.made import BOX, CUP, relation, scene, table, thing
from tests.layout.research import problem_of

PLACES = {
    "optax": "optax_adam:OptaxAdam",
    "optimistix": "optimistix_bfgs:Bfgs",
    "optimistix ": "optimistix_lm:LevenbergMarquardt",
    "blackjax": "blackjax_mala:Mala",
    "evosax": "evosax_cma:CmaEs",
}
LADEN = scene([table(), CUP, BOX, thing("other")], [relation("near", "box", "other", max=0.4)])


def made(library: str) -> StepOptimizer:
    pytest.importorskip(library.strip())
    module, name = PLACES[library].split(":")
    return getattr(importlib.import_module(f"benchmarks.external.{module}"), name)()


QUICK = ("optax",)  # the others take long to compile
each = pytest.mark.parametrize(
    "library",
    [
        pytest.param(library, id=place.split(":")[1], marks=() if library in QUICK else pytest.mark.slow)
        for library, place in PLACES.items()
    ],
)


@pytest.mark.slow
@each
def test_it_runs_through_refine_and_carries_what_is_carried(library):
    optimizer = made(library)
    assert isinstance(optimizer, StepOptimizer)
    own = {"candidates": 4, "seed": 3, "device": "cpu", "explain": False}
    begin = sw.refine(LADEN, optimizer=Nothing(), **own)
    solution = sw.refine(LADEN, optimizer=optimizer, steps=8, **own)
    assert (solution.energy <= begin.energy + 1e-6).all() and solution.energy.mean() < 0.5 * begin.energy.mean()
    np.testing.assert_allclose(solution.poses[:, 1, 2], 0.75, atol=1e-3)
    away = [np.linalg.norm(found.poses[:, 1, :2] - found.poses[:, 0, :2], axis=1) for found in (begin, solution)]
    np.testing.assert_allclose(*away, atol=1e-3)


class Nothing:
    steps = 1

    def init(self, problem, poses, key):
        return poses

    def step(self, state):
        return state

    def best(self, state):
        return state


@pytest.mark.slow
@each
def test_it_counts_what_it_measures(library, monkeypatch):
    """Calls and measured layouts are those that the problem sees; scenes of two sizes in one batch."""
    optimizer, seen = made(library), []
    for name in ("measured", "taken_apart"):
        whole = getattr(Problem, name)
        monkeypatch.setattr(Problem, name, lambda *args, whole=whole: seen.append(args[1].shape[0]) or whole(*args))
    problem = sw.compile([LADEN, scene([BOX, thing("other")], [])], device="cpu")
    state = optimizer.init(problem, wp.array(problem.sample(0, 2), dtype=wp.float32, device="cpu"), 0)
    for _ in range(2):
        state = optimizer.step(state)
    best = np.asarray(optimizer.best(state))
    assert optimizer.counts(state) == (len(seen), sum(seen))
    assert best.shape == (4, 4, 4) and np.isfinite(best[problem.mask[[0, 0, 1, 1]]]).all()


@pytest.mark.slow
def test_adam_of_optax_reaches_the_built_in_one():
    """In means over 32 layouts of the same starts and as many steps; to the built-in's within a tenth."""
    problem = problem_of("dining-round")
    starts = problem.sample(0, 32)
    ours, theirs = (
        sw.refine(problem.scenes[0], init=starts, optimizer=optimizer, device="cpu", explain=False).energy.mean()
        for optimizer in (sw.layout.BuiltIn("adam"), made("optax"))
    )
    assert theirs < 1.1 * ours + 0.01 < 0.5 * problem.energy(starts).mean()
