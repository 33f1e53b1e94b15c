"""Graphs of measurements, with ones that measure in place of recorded ones: a shape has its own, and all is counted.

On a GPU (`SCENEWEAVER_TEST_DEVICE=cuda:0`) the other tests of this folder run the recorded ones.
"""

from __future__ import annotations

from contextlib import nullcontext
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

from sceneweaver.jax import graphs
from tests.layout.research import problem_of


class OnGpu:
    """A problem that says that it is on a GPU."""

    device = "cuda:0"

    def __init__(self, problem) -> None:
        self.problem, self.energy_calls, self.evaluations = problem, 0, 0

    def measured(self, poses, which):
        self.energy_calls, self.evaluations = self.energy_calls + 1, self.evaluations + poses.shape[0]
        return self.problem.measured(poses, which)


@pytest.fixture
def recorded(monkeypatch):
    shapes = []

    class Measured:
        def __init__(self, measured, inputs, outputs):
            self.measured, self.shape = measured, inputs[0].shape
            shapes.append(self.shape)

        def run(self, inputs, outputs):
            assert inputs[0].shape == self.shape
            graphs._copy(self.measured(*inputs), outputs)

    monkeypatch.setattr(graphs, "Graph", Measured)
    monkeypatch.setattr(graphs, "own_stream", lambda _: nullcontext())
    monkeypatch.setattr(graphs, "wp", SimpleNamespace(copy=wp.copy, synchronize_device=lambda _: None))
    return shapes


def test_a_shape_has_its_own_graph_from_the_second_time_on(recorded):
    if problem_of("bedroom-small").device != "cpu":
        pytest.skip("the others record graphs here")
    problem = OnGpu(problem_of("bedroom-small"))
    counts = [4, 16, 4, 16, 4, *range(1, 13), 4, 4]
    for count in counts:
        poses = problem.problem.sample(count, count)
        inputs = wp.array(poses, dtype=wp.vec4, device="cpu"), wp.zeros(count, dtype=wp.int32, device="cpu")
        energy = wp.zeros(count, dtype=wp.float32, device="cpu")
        gradient = wp.zeros(poses.shape[:2], dtype=wp.vec4, device="cpu")
        graphs.measure(problem, problem.measured, inputs, (energy, gradient))
        np.testing.assert_array_equal(energy.numpy(), problem.problem.energy(poses))
    assert recorded == [(4, 11), (16, 11)] and len(graphs._GRAPHS[problem]) == graphs.MOST
    assert (problem.energy_calls, problem.evaluations) == (len(counts), sum(counts))
