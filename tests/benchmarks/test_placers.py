"""The placers among the other optimisers: they lower the energy, and all rivals can be named."""

from __future__ import annotations

import importlib
import importlib.util

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from benchmarks.external import RIVALS
from sceneweaver.bench.entries import find_methods
from sceneweaver.layout import StepOptimizer
from tests.layout.research import problem_of

PLACERS = {"momentum": 60, "annealing": 40, "greedy": 12, "numpy descent": 1}


def test_all_rivals_have_a_place():
    methods = find_methods(["benchmarks.external:RIVALS"])
    assert [method.name for method in methods] == list(RIVALS)
    for label, place in RIVALS.items():
        module, _, name = place.partition(":")
        if "torch" not in label or importlib.util.find_spec("torch"):
            assert callable(getattr(importlib.import_module(module), name))


@pytest.mark.slow
@pytest.mark.parametrize("name", PLACERS)
def test_a_placer_lowers_the_energy(name):
    problem = problem_of("bedroom-small")
    (method,) = find_methods([f"x={RIVALS[name]}"])
    optimizer, given = method.make(), problem.sample(3, 6)
    assert isinstance(optimizer, StepOptimizer)
    before, calls, layouts = problem.energy(given), problem.energy_calls, problem.evaluations
    state = optimizer.init(problem, wp.array(given, dtype=wp.float32, device="cpu"), 0)
    for _ in range(PLACERS[name]):
        state = optimizer.step(state)
    assert problem.energy_calls > calls and problem.evaluations > layouts or name == "numpy descent"
    best = np.asarray(optimizer.best(state))
    assert best.shape == given.shape and np.median(problem.energy(best)) < 0.7 * np.median(before)
    np.testing.assert_array_equal(best[..., 2], given[..., 2])


def test_torch_adam_lowers_the_energy():
    pytest.importorskip("torch")
    problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
    from benchmarks.external.torch_adam import TorchAdam

    optimizer, given = TorchAdam(steps=5), problem.sample(3, 6)
    state = optimizer.init(problem, wp.array(given, dtype=wp.float32, device="cpu"), 0)
    for _ in range(5):
        state = optimizer.step(state)
    assert np.median(problem.energy(optimizer.best(state)).numpy()) < 0.5 * np.median(problem.energy(given))
