"""Deadlines: what ends when, whoever asks for the end, and that nothing is left behind of the clock."""

from __future__ import annotations

import importlib
import signal
import sys
import threading
import time
from contextlib import suppress

import pytest
from pydantic import TypeAdapter
from pydantic_core import core_schema

import sceneweaver as sw
from sceneweaver.runtime.deadline import HASTE, NEVER, PATIENCE, SHORTEST, Deadline, Stop, TimeUp, checkpoint
from sceneweaver.runtime.threads import map_threads


def working() -> None:
    """Work that never ends by itself, with checkpoints."""
    while True:
        time.sleep(0.005)
        checkpoint()


def hanging(seconds: float = 60.0) -> None:
    """Work that comes to no checkpoint."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        sum(range(100))


def soon(seconds: float = 0.1, **more) -> Deadline:
    return Deadline(time.monotonic() + seconds, **more)


@pytest.fixture(autouse=True)
def clock_is_off(capfd):
    yield
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    assert signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
    checkpoint()  # no block is left
    assert not capfd.readouterr().err


def test_a_margin_is_kept_and_searches_leave_time_to_judge():
    end = soon(10.0)
    assert 9.0 < end.left <= 10.0 and not end.passed
    assert 2.0 < end.before(3.0).before(4.0).left <= 3.0
    assert end.time_limit == pytest.approx(7.5, abs=0.1)
    assert end.before(11.0).passed and end.before(11.0).left == 0.0 and end.before(11.0).time_limit == SHORTEST
    assert NEVER.time_limit is None and not NEVER.passed


def test_a_checkpoint_ends_the_block_in_time_and_nothing_comes_after():
    end = soon()
    with pytest.raises(TimeUp) as ended, end.enforced():
        working()
    assert end.passed and ended.traceback[-1].name == "checkpoint", "not broken off by the alarm"
    with soon(0.05).enforced():
        pass
    time.sleep(0.1)


def test_one_that_was_lost_comes_again():
    with pytest.raises(TimeUp), soon().enforced():
        with suppress(TimeUp):
            working()
        working()


def test_grace_is_for_deadlines_and_not_for_stops():
    end = soon(0.1)
    with end.enforced(lambda: 5.0):
        time.sleep(0.2)
        checkpoint()
    assert end.passed
    stop = Stop(allowance=0.0)
    ask = threading.Timer(0.1, stop.request, ("SIGINT",))
    ask.start()
    with pytest.raises(TimeUp), Deadline(stop=stop).enforced(lambda: 60.0):
        working()
    ask.join()
    assert time.monotonic() < stop.end + 60.0 and stop.reason == "SIGINT"


def test_a_stop_leaves_time_for_the_files_and_its_first_reason_stays():
    stop = Stop(allowance=5.0)
    end, work = Deadline(stop=stop), Deadline(stop=stop).before(5.0)
    stop.request("SIGTERM")
    stop.request("SIGINT")
    assert stop.reason == "SIGTERM" and work.passed and 4.0 < end.left <= 5.0


def test_a_block_ends_with_the_one_around_it():
    with pytest.raises(TimeUp), soon().enforced(), NEVER.enforced():
        working()
    with NEVER.enforced():
        with pytest.raises(TimeUp), soon().enforced():
            working()
        checkpoint()


@pytest.mark.parametrize("how", ["deadline", "stop of another thread"])
def test_what_comes_to_no_checkpoint_is_broken_off(how):
    began, stop = time.monotonic(), Stop(allowance=0.0)
    if how == "deadline":
        end = soon(stop=stop)
    else:
        end = Deadline(stop=stop)
        threading.Timer(0.1, stop.request, ("SIGINT",)).start()
    with pytest.raises(TimeUp), end.enforced():
        hanging()  # it would end after a minute, without an error
    assert time.monotonic() - began > (PATIENCE if how == "deadline" else HASTE)


def test_a_model_is_built_as_a_whole():
    """Pydantic turns what is raised while it builds a model into an error of its own."""

    class Slow:
        @classmethod
        def __get_pydantic_core_schema__(cls, source: type, handler: object) -> core_schema.CoreSchema:
            hanging(PATIENCE + 0.5)
            return core_schema.any_schema()

    with pytest.raises(TimeUp), soon().enforced():
        built = TypeAdapter(Slow)
        working()
    assert built.validate_python(3) == 3


def test_a_module_is_imported_as_a_whole(tmp_path, monkeypatch):
    lines = ("import time", f"until = time.monotonic() + {PATIENCE + 0.5}", "while time.monotonic() < until: pass", "")
    (tmp_path / "slow_to_import.py").write_text("\n".join(lines) + "whole = True\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(TimeUp), soon().enforced():
        importlib.import_module("slow_to_import")
        working()
    assert sys.modules.pop("slow_to_import").whole


def test_the_clock_of_others_is_left_alone():
    rung = []
    signal.signal(signal.SIGALRM, lambda *_: rung.append(1))
    try:
        with pytest.raises(TimeUp), soon(0.05).enforced():
            working()
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        time.sleep(0.1)
    finally:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    assert rung == [1]


def test_each_thread_has_its_own_block():
    ended = []

    def work() -> None:
        with suppress(TimeUp), soon(0.05).enforced():
            working()
        ended.append(1)

    with NEVER.enforced():
        thread = threading.Thread(target=work)
        thread.start()
        thread.join(5.0)
        checkpoint()
    assert ended == [1]


def test_threads_are_done_with_what_they_began_and_begin_nothing_else():
    begun, done = [], []

    def work(k: int) -> None:
        begun.append(k)
        time.sleep(0.2)
        done.append(k)

    with pytest.raises(TimeUp), soon().enforced():
        map_threads(work, range(20), 2)
    count = len(done)
    assert sorted(begun) == sorted(done) and 2 <= count <= 6
    time.sleep(0.4)
    assert len(done) == count


def test_threads_return_in_order_and_pass_on_what_they_raise():
    def work(k: int) -> int:
        time.sleep(0.02 * (3 - k))
        return k

    assert map_threads(work, range(4), 4) == [0, 1, 2, 3]
    with pytest.raises(ZeroDivisionError):
        map_threads(lambda k: 1 // k, [1, 0, 1], 2)


def test_a_search_ends_with_the_block_that_it_runs_in(capfd):
    scene = sw.Scene.example("bedroom")
    sw.refine(scene, candidates=2, device="cpu", explain=False)  # loads the kernels
    capfd.readouterr()  # Warp's greeting
    end = soon(0.5)
    with suppress(TimeUp), end.enforced():
        assert sw.refine(scene, candidates=2**14, init="random", device="cpu", explain=False).timed_out
    assert end.passed
