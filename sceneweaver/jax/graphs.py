"""Measurements on a GPU as CUDA graphs, on a stream of our own.

Memory that Warp frees is in order with its own streams, not with XLA's, which are of another kind. So what allocates
runs on a stream of ours, which waits for XLA's and which XLA's waits for.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from functools import cache
from weakref import WeakKeyDictionary

import warp as wp

from sceneweaver.layout import Problem

Measure = Callable[[wp.array, wp.array], Sequence[wp.array]]
MOST = 8  # graphs that a problem keeps

_GRAPHS: WeakKeyDictionary[Problem, OrderedDict[tuple, Graph | None]] = WeakKeyDictionary()


@cache
def _stream(device: str) -> wp.Stream:
    return wp.Stream(device)


def own_stream(device: str) -> AbstractContextManager:
    """On a GPU our own stream, in order with the one that XLA calls us on before and after."""
    return nullcontext() if device == "cpu" else wp.ScopedStream(_stream(device), sync_enter=True, sync_exit=True)


class Graph:
    """A measurement of layouts of one shape, recorded between buffers of its own, as XLA's are elsewhere every time.

    What is allocated while it is recorded belongs to the graph; tables belong to the problem, which outlives it.
    """

    def __init__(self, measured: Measure, inputs: Sequence[wp.array], outputs: Sequence[wp.array]) -> None:
        """Record; the kernels have to be loaded."""
        self._inputs, self._outputs = [wp.empty_like(x) for x in inputs], [wp.empty_like(x) for x in outputs]
        with wp.ScopedCapture(force_module_load=False) as capture:
            _copy(measured(*self._inputs), self._outputs)
        assert capture.graph is not None
        self._graph = capture.graph

    def run(self, inputs: Sequence[wp.array], outputs: Sequence[wp.array]) -> None:
        """Measure the inputs into the outputs."""
        _copy(inputs, self._inputs)
        wp.capture_launch(self._graph)
        _copy(self._outputs, outputs)


def measure(problem: Problem, measured: Measure, inputs: Sequence[wp.array], outputs: Sequence[wp.array]) -> None:
    """Measure ``inputs`` into ``outputs`` by a method of the problem: on a GPU from the second time on as a graph."""
    if problem.device == "cpu":
        _copy(measured(*inputs), outputs)
        return
    graphs = _GRAPHS.setdefault(problem, OrderedDict())
    key = (measured.__name__, *(x.shape for x in inputs))
    with own_stream(problem.device):
        if key not in graphs:  # loads the kernels
            graphs[key] = None
            _copy(measured(*inputs), outputs)
            return
        counts = problem.energy_calls, problem.evaluations
        graph = graphs[key] = graphs[key] or Graph(measured, inputs, outputs)
        graphs.move_to_end(key)
        while len(graphs) > MOST:
            wp.synchronize_device(problem.device)  # the oldest may be under way
            graphs.popitem(last=False)
        graph.run(inputs, outputs)
        problem.energy_calls, problem.evaluations = counts[0] + 1, counts[1] + inputs[0].shape[0]


def _copy(values: Sequence[wp.array], into: Sequence[wp.array]) -> None:
    for there, here in zip(into, values, strict=True):
        wp.copy(there, here)
