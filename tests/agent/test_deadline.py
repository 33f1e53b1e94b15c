"""Deadlines: what ends when, whoever asks for the end, and that nothing is left behind of the clock."""

from __future__ import annotations

import signal
import sys
import threading
import time
import weakref
from contextlib import suppress

import pytest

from sceneweaver.agent.deadline import NEVER, SHORTEST, Deadline, Stop
from sceneweaver.agent.interrupt import AGAIN, TimeUp


def forever() -> None:
    while True:
        time.sleep(0.005)


def soon(seconds: float = 0.1, **more) -> Deadline:
    return Deadline(time.monotonic() + seconds, **more)


@pytest.fixture(autouse=True)
def clock_is_off():
    yield
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    assert signal.getsignal(signal.SIGALRM) is signal.SIG_DFL


def test_a_margin_is_kept_and_searches_leave_time_to_judge():
    end = soon(10.0)
    assert 9.0 < end.left <= 10.0 and not end.passed
    assert 2.0 < end.before(3.0).before(4.0).left <= 3.0
    assert end.time_limit == pytest.approx(7.5, abs=0.1)
    assert end.before(11.0).passed and end.before(11.0).left == 0.0 and end.before(11.0).time_limit == SHORTEST
    assert NEVER.time_limit is None and not NEVER.passed


def test_what_asks_nothing_is_ended():
    began = time.monotonic()
    with pytest.raises(TimeUp), soon().enforced():
        forever()
    assert 0.1 <= time.monotonic() - began < 1.0


def test_what_ends_in_time_is_left_alone():
    with soon(0.1).enforced():
        pass
    time.sleep(0.2)  # nothing comes after the block


def test_grace_is_for_deadlines_and_not_for_stops():
    end = soon(0.1)
    with end.enforced(lambda: 5.0):
        time.sleep(0.2)
    assert end.passed
    stop = Stop(allowance=0.0)
    ask = threading.Timer(0.1, stop.request, ("SIGINT",))
    ask.start()
    began = time.monotonic()
    with pytest.raises(TimeUp), Deadline(stop=stop).enforced(lambda: 5.0):
        forever()
    ask.join()
    assert time.monotonic() - began < 1.0 and stop.reason == "SIGINT"


def test_a_stop_leaves_time_for_the_files_and_its_first_reason_stays():
    stop = Stop(allowance=5.0)
    end, work = Deadline(stop=stop), Deadline(stop=stop).before(5.0)
    stop.request("SIGTERM")
    stop.request("SIGINT")
    assert stop.reason == "SIGTERM" and work.passed and 4.0 < end.left <= 5.0


def test_it_is_not_raised_in_a_finaliser_where_it_would_be_lost():
    class Slow:
        def __del__(self) -> None:
            time.sleep(0.3)

    def use() -> None:
        slow = Slow()
        del slow
        forever()

    began = time.monotonic()
    with pytest.raises(TimeUp), soon().enforced():
        use()
    assert 0.3 <= time.monotonic() - began < 1.0


def test_what_cleans_up_after_it_is_not_interrupted():
    done = []
    with pytest.raises(TimeUp), soon().enforced():
        try:
            forever()
        finally:
            until = time.monotonic() + 2 * AGAIN
            while time.monotonic() < until:
                try:
                    time.sleep(0.01)
                    raise OSError
                except OSError:
                    time.sleep(0.01)
            done.append(1)
    assert done


def test_one_that_a_callback_lost_comes_again_and_nothing_is_said_of_it(capsys):
    class Thing:
        pass

    thing = Thing()
    watched = weakref.ref(thing, lambda _: time.sleep(0.3))
    before = sys.unraisablehook
    with pytest.raises(TimeUp), soon().enforced():
        del thing
        assert watched() is None
        forever()
    assert sys.unraisablehook is before and "TimeUp" not in capsys.readouterr().err


def test_one_that_was_lost_comes_again():
    with pytest.raises(TimeUp), soon().enforced():
        with suppress(TimeUp):
            forever()
        forever()


def test_the_clock_of_others_is_left_alone():
    rung = []
    signal.signal(signal.SIGALRM, lambda *_: rung.append(1))
    try:
        with soon(0.05).enforced():
            time.sleep(0.1)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        time.sleep(0.1)
    finally:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    assert rung == [1]


def test_other_threads_ask_for_themselves():
    ended = []

    def work() -> None:
        with soon(0.05).enforced():
            time.sleep(0.2)
        ended.append(1)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join(5.0)
    assert ended == [1]
