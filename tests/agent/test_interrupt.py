"""Where a block is ended when its time is up, and where not: what is begun elsewhere is done as a whole, in silence."""

from __future__ import annotations

import ctypes
import importlib
import signal
import sys
import threading
import time
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

import pytest

import sceneweaver as sw
from sceneweaver.agent.interrupt import PATIENCE, Interrupt, TimeUp
from sceneweaver.scene.threads import map_threads

LONG = 0.3
"""Seconds that something takes which begins before the end of a block and is done after it."""

LIBRARY = f"""
import time
done = []
def work(seconds={LONG}):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        sum(range(100))
    done.append(1)
"""


def soon(seconds: float = 0.1, packages: tuple[str, ...] = ()) -> Interrupt:
    end = time.monotonic() + seconds
    return Interrupt(lambda: end, packages=packages)


def busy(seconds: float = LONG) -> None:
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        sum(range(100))


def forever() -> None:
    while True:
        busy(0.01)


@pytest.fixture(autouse=True)
def nothing_is_left_behind(capfd):
    before = sys.unraisablehook
    yield
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0) and signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
    assert sys.unraisablehook is before and sys.gettrace() is None
    said = capfd.readouterr()
    assert not said.err and not said.out


@pytest.fixture
def library() -> ModuleType:
    module = ModuleType("some_library")
    exec(compile(LIBRARY, "some_library.py", "exec"), module.__dict__)
    return module


class Thing:
    """What a weak reference can point to."""


def in_a_weakref_callback() -> None:
    thing = Thing()
    watched = weakref.ref(thing, lambda _: busy())
    del thing
    assert watched() is None


def in_a_callback_from_c() -> None:
    kind = ctypes.PYFUNCTYPE(None)
    kind(busy)()


def in_a_finaliser() -> None:
    class Slow:
        def __del__(self) -> None:
            busy()

    Slow()


def in_a_generator_that_is_closed() -> None:
    def items() -> Iterator[int]:
        try:
            yield 1
        finally:
            busy()

    given = items()
    next(given)
    del given


def in_a_thread() -> None:
    thread = threading.Thread(target=busy)
    thread.start()
    thread.join()


def in_a_sort() -> None:
    sorted(range(3), key=lambda k: (busy(LONG / 3), k)[1])


@pytest.mark.parametrize(
    "place",
    [
        in_a_weakref_callback,
        in_a_callback_from_c,
        in_a_finaliser,
        in_a_generator_that_is_closed,
        in_a_thread,
        in_a_sort,
    ],
)
def test_it_ends_soon_and_without_a_word(place):
    began = time.monotonic()
    with pytest.raises(TimeUp), soon():
        place()
        forever()
    assert 0.1 <= time.monotonic() - began < 2.0


def test_a_library_is_done_before_the_block_ends_at_the_next_line(library):
    after = []
    with pytest.raises(TimeUp), soon():
        library.work()
        after.append(1)
    assert library.done == [1] and not after


def test_in_a_loop_that_is_nearly_always_in_a_library_it_ends_after_one_round(library):
    with pytest.raises(TimeUp), soon(0.1):
        while True:
            library.work(0.15)
    assert library.done == [1]


def test_where_lines_are_watched_already_it_is_polled(library):
    sys.settrace(lambda *_: None)
    try:
        with pytest.raises(TimeUp), soon():
            while True:
                library.work(0.02)
                busy(0.05)
    finally:
        sys.settrace(None)


def test_a_module_is_imported_as_a_whole(tmp_path, monkeypatch):
    (tmp_path / "slow_to_import.py").write_text(f"import time\ntime.sleep({LONG})\nwhole = True\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(TimeUp), soon():
        importlib.import_module("slow_to_import")
        forever()
    assert sys.modules.pop("slow_to_import").whole


def test_what_a_context_manager_does_at_its_end_is_done_as_a_whole(library):
    done = []

    @contextmanager
    def tidy() -> Iterator[None]:
        try:
            yield
        finally:
            busy()
            done.append(1)

    with pytest.raises(TimeUp), soon(), tidy():
        library.work()
        forever()
    with pytest.raises(TimeUp), soon():
        with tidy():
            pass
        forever()
    assert done == [1, 1]


def test_the_end_of_a_with_in_which_a_library_works_is_never_skipped(library):
    ended = []

    class Held:
        def __enter__(self) -> None:
            pass

        def __exit__(self, *_: object) -> None:
            ended.append(1)

    with pytest.raises(TimeUp), soon():
        with Held():
            library.work()
        forever()
    assert ended == [1]


def test_a_tool_of_another_package_is_ended_where_the_block_names_it(library):
    with pytest.raises(TimeUp), soon(packages=("some_library",)):
        library.work(5.0)
    assert not library.done


def test_a_library_that_does_not_come_back_is_ended_in_the_middle(library):
    began = time.monotonic()
    with pytest.raises(TimeUp), soon():
        library.work(60.0)
    assert PATIENCE < time.monotonic() - began < PATIENCE + 3.0 and not library.done


def test_a_block_that_is_done_is_not_ended_afterwards(library):
    with soon():
        library.work()
    busy(2 * LONG)


def test_threads_are_done_with_what_they_began_and_begin_nothing_else():
    begun, done = [], []

    def work(k: int) -> None:
        begun.append(k)
        time.sleep(LONG)
        done.append(k)

    with pytest.raises(TimeUp), soon():
        map_threads(work, range(20), 2)
    count = len(done)
    assert sorted(begun) == sorted(done) and 2 <= count <= 6
    time.sleep(2 * LONG)
    assert len(done) == count


def test_threads_return_in_order_and_pass_on_what_they_raise():
    def work(k: int) -> int:
        time.sleep(0.02 * (3 - k))
        return k

    assert map_threads(work, range(4), 4) == [0, 1, 2, 3]
    with pytest.raises(ZeroDivisionError):
        map_threads(lambda k: 1 // k, [1, 0, 1], 2)


def test_a_search_over_several_threads_is_ended(capfd):
    scene = sw.Scene.example("bedroom")
    sw.refine(scene, candidates=2, device="cpu", explain=False)  # loads the kernels
    capfd.readouterr()  # Warp's greeting
    began = time.monotonic()
    with pytest.raises(TimeUp), soon(0.5):
        sw.refine(scene, candidates=2**16, init="random", device="cpu", explain=False)
    assert time.monotonic() - began < 5.0
