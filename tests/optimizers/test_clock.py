"""A search looks at the clock between and within rounds; what it is not told depends on no clock."""

from __future__ import annotations

import importlib
import math
import signal
import sys
import threading
import time
from functools import partial

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.kernels import load
from sceneweaver.layout import engine
from sceneweaver.layout.batch import make_batch
from sceneweaver.layout.compile import compile_scene
from sceneweaver.optimizers import OPTIMIZERS, Monitor, load_poses, run
from sceneweaver.optimizers.base import GRACE, FunctionOptimizer
from sceneweaver.optimizers.run import PIECE, cpu_threads, judge_in_time, on_threads
from sceneweaver.optimizers.search import search_blocks
from sceneweaver.runtime.deadline import Deadline, Stop, TimeUp, ending, stoppable

pytestmark = pytest.mark.filterwarnings("error")


@pytest.fixture(scope="module")
def bedroom():
    scene = compile_scene(sw.Scene.example("bedroom"))
    load("cpu", "bookkeeping", "verdict", "walk", *OPTIMIZERS["search"].modules_on("cpu"))
    load("cpu", *OPTIMIZERS["projection"].modules_on("cpu"))
    return scene


def batch_of(scene, candidates: int):
    batch = make_batch([scene.room], np.zeros(candidates, dtype=int), "cpu")
    load_poses(batch, np.repeat(scene.room.home[None], candidates, axis=0))
    return batch


@pytest.mark.parametrize("optimizer", ["search", "projection"])
def test_kernels_that_are_broken_off_leave_what_there_was(bedroom, optimizer):
    batch = batch_of(bedroom, 4)
    before = batch.state.poses.numpy().copy()
    monitor = Monitor(4)
    monitor.break_off()
    energy = OPTIMIZERS[optimizer](batch, "given", None, monitor).energy
    assert monitor.expired() and np.isfinite(batch.state.poses.numpy()).all()
    if optimizer == "search":  # what is in order was not searched at all
        np.testing.assert_array_equal(energy, 0.0)
    np.testing.assert_allclose(batch.state.poses.numpy(), before, atol=1e-6)


def test_a_round_that_is_broken_off_is_no_best(bedroom):
    batch = batch_of(bedroom, 4)
    monitor = Monitor(4)
    monitor.break_off()
    blocks = search_blocks(batch, "random", None, monitor, True)
    with pytest.raises(StopIteration) as ended:
        next(blocks)  # one round, of which nothing is done
        next(blocks)
    assert np.isposinf(ended.value.value.energy).all()


def test_who_waits_looks_at_the_clock_while_a_piece_works(monkeypatch):
    """However long a piece takes, the look does not wait for it."""
    monitor, looked, release = Monitor(2, deadline=time.monotonic() - 10.0), [], threading.Event()
    watch = Monitor.watch

    def watched(self, began):
        looked.append(began)
        watch(self, began - GRACE)
        if self.broken_off:
            release.set()

    monkeypatch.setattr(Monitor, "watch", watched)
    monkeypatch.setattr(importlib.import_module("sceneweaver.optimizers.run"), "TICK", 0.001)
    on_threads(lambda rows: release.wait(60.0), [(0, 1)], monitor)
    assert looked and release.is_set() and monitor.timed_out


def test_pieces_that_there_is_no_time_for_are_not_begun(bedroom, monkeypatch):
    begun, kept = [], OPTIMIZERS["projection"]

    def first(batch, start, budget, monitor):
        begun.append(batch.size)
        monitor.break_off()
        return kept(batch, start, 1, Monitor(batch.size))

    monkeypatch.setenv("OMP_NUM_THREADS", "1")
    monkeypatch.setitem(OPTIMIZERS, "search", FunctionOptimizer(first, ("search",), ()))
    batch = batch_of(bedroom, 40 * PIECE)
    energy = run(batch, "search", "given", None, Monitor(batch.size)).energy
    assert begun == [PIECE]
    assert np.isfinite(energy[:PIECE]).all() and np.isposinf(energy[PIECE:]).all()


def test_what_is_not_judged_in_time_counts_as_at_fault(bedroom):
    batch = batch_of(bedroom, 4 * PIECE)
    monitor = Monitor(batch.size)
    assert (judge_in_time(batch, monitor).status == 0).all()
    monitor.break_off()
    status = judge_in_time(batch, monitor).status
    assert (status[:PIECE] == 0).all() and (status[PIECE:] == 1).all()


def test_an_error_of_the_caller_ends_the_pieces(monkeypatch):
    monitor, begun = Monitor(8), []

    def work(rows):
        begun.append(rows)
        while not monitor.broken_off:
            time.sleep(0.001)

    def interrupted(self, began):
        raise KeyboardInterrupt

    monkeypatch.setattr(Monitor, "watch", interrupted)
    with pytest.raises(KeyboardInterrupt):
        on_threads(work, [(k, k + 1) for k in range(2 * cpu_threads())], monitor)
    assert 1 <= len(begun) <= cpu_threads()


def test_pieces_are_done_side_by_side(monkeypatch):
    monkeypatch.setattr(sys.modules["sceneweaver.optimizers.run"], "cpu_threads", lambda: 2)
    both = threading.Barrier(2)
    on_threads(lambda _: both.wait(60), [(0, 1), (1, 2)], Monitor(2))  # one alone would wait for the other


def test_a_search_hears_of_a_stop_that_is_asked_for_later():
    """The deadline is no number that is taken at the beginning."""
    scene, asked = sw.Scene.example("bedroom"), []
    with stoppable() as stop:

        def progress(*_):
            if not asked:
                asked.append(1)
                signal.raise_signal(signal.SIGTERM)

        with Deadline(stop=stop).enforced():
            solution = sw.refine(scene, candidates=64 * PIECE, device="cpu", explain=False, progress=progress)
    assert solution.timed_out and stop.reason == "SIGTERM" and solution.poses.shape[0] == 64 * PIECE


@pytest.mark.parametrize("limit", [None, 600.0])
def test_a_deadline_that_does_not_come_changes_nothing(limit):
    scene = sw.Scene.example("bedroom")
    free = engine.refine(scene, candidates=40, seed=4, device="cpu")
    with Deadline(math.inf if limit is None else time.monotonic() + limit).enforced():
        timed = engine.refine(scene, candidates=40, seed=4, device="cpu")
    assert not timed.timed_out
    np.testing.assert_array_equal(free.poses, timed.poses)
    np.testing.assert_array_equal(free.status, timed.status)


def test_searches_end_when_a_stop_is_asked_for_and_blocks_after_its_allowance():
    stop = Stop(allowance=100.0)
    assert ending() is None
    with Deadline(stop=stop).enforced():
        assert ending() is None, "nothing ends it"
    stop.heard = True
    with Deadline(stop=stop).enforced(partial(float, 5.0)):
        told = ending()
        assert told() == math.inf
        stop.request("SIGTERM")
        assert told() <= time.monotonic() < stop.end
    with pytest.raises(TimeUp), Deadline(time.monotonic() - 1.0).enforced():
        assert ending()() < time.monotonic()
        raise TimeUp


def test_a_reason_that_takes_too_long_costs_no_layouts(monkeypatch):
    module = importlib.import_module("sceneweaver.explain.refine")

    def late(*_, **__):
        raise TimeUp

    monkeypatch.setattr(module, "find_reason", late)
    scene = sw.Scene.example("bedroom")
    heap = scene.model_copy(update={"room": sw.Room.rectangle(1.5, 1.5), "relations": ()})
    solution = sw.refine(heap, candidates=2, steps=1, device="cpu")
    assert (solution.status != 0).all() and solution.explanation is None
