"""When work has to be done, and how it ends in time.

Work ends cooperatively. Long loops ask their `Deadline` (``passed``, ``left``); what is called from many places and
does not know the deadline, such as the loading of an asset, calls `checkpoint`, which ends the innermost block of
``with deadline.enforced():`` by `TimeUp` once its time is up. Only a library that does not come back is broken off in
the middle, `PATIENCE` seconds later, by the alarm clock of the process.
"""

from __future__ import annotations

import contextlib
import math
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import FrameType

SHORTEST = 0.05
"""Seconds that a search gets even when time is up: a scene has to come out of it."""

SEARCH = 0.75
"""Share of the time left that a search gets."""

PATIENCE = 1.0
"""Seconds after the end of a block in which it has to come to a checkpoint."""

HASTE = 0.3
"""The same [s] when a stop is asked for."""

AGAIN = 0.5
"""Seconds after which the alarm rings once more, where nothing could be broken off or `TimeUp` was lost."""

WHOLE = frozenset(
    ("_frozen_importlib", "importlib", "threading", "concurrent", "weakref", "contextlib", "warp", "pydantic")
)
"""Packages whose calls are never broken off: an exception in one breaks more than the call."""

HANDLERS = ("__enter__", "__exit__", "__del__")
"""Functions that are never broken off."""

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class TimeUp(BaseException):
    """Raised in a block whose time is up. No ``Exception``: nothing on the way takes it for a fault."""


@dataclass
class Stop:
    """Asks running work to end early; a signal handler or another thread may do so.

    Attributes:
        allowance: seconds from the request until all files have to be written.
        end: that moment of ``time.monotonic()`` [s]; it never comes until it is asked for.
        asked: when it was asked for [s].
        reason: who asked, such as "SIGTERM"; empty until then.
        heard: whether signals ask for it, see `stoppable`.
        ready: whether there is something to end with; where there is not, a signal ends the process at once.
    """

    allowance: float = 1.5
    end: float = math.inf
    asked: float = math.inf
    reason: str = ""
    heard: bool = False
    ready: bool = True

    def request(self, reason: str) -> None:
        """Ask; the first reason stays."""
        self.asked = min(self.asked, time.monotonic())
        self.end = min(self.end, self.asked + self.allowance)
        self.reason = self.reason or reason
        _set_alarm()


@dataclass(frozen=True)
class Deadline:
    """A moment of ``time.monotonic()`` [s], or an earlier one when a stop is asked for; by default it never comes.

    ``margin`` [s] is kept for what comes after.
    """

    end: float = math.inf
    margin: float = 0.0
    stop: Stop = field(default_factory=Stop)

    @property
    def moment(self) -> float:
        """When it comes, by ``time.monotonic()`` [s]."""
        return min(self.end, self.stop.end) - self.margin

    @property
    def left(self) -> float:
        """Seconds until it comes; 0 once it has."""
        return max(0.0, self.moment - time.monotonic())

    @property
    def passed(self) -> bool:
        """Whether it has come; once true, it stays so."""
        return time.monotonic() >= self.moment

    @property
    def time_limit(self) -> float | None:
        """Seconds that `refine` may take, as its layouts have to be judged as well; None for as long as it likes."""
        return None if math.isinf(self.moment) else max(SHORTEST, SEARCH * self.left)

    def before(self, seconds: float) -> Deadline:
        """An earlier one, which keeps so many seconds for what comes after."""
        return replace(self, margin=self.margin + seconds)

    def enforced(self, grace: Callable[[], float] = float, patience: float = PATIENCE) -> _Block:
        """A ``with`` block that ends by `TimeUp` at the first `checkpoint` after this deadline, or one around it.

        What asks the deadline itself has some seconds of ``grace`` more to end in good order, none unless given, and
        none when a stop is asked for. What calls no checkpoint is broken off in the middle after ``patience`` [s], in
        the main thread of a process that does not use the alarm clock for something else.
        """
        return _Block(self, grace, patience)


NEVER = Deadline()
"""A deadline that does not come."""


def checkpoint() -> None:
    """End the block of a deadline that runs here, if its time is up; work that takes long calls this in its loops.

    Raises:
        TimeUp: the deadline of a block around this call has passed.
    """
    if time.monotonic() >= end_of_block():
        raise TimeUp


def end_of_block() -> float:
    """When a `checkpoint` here ends the block of a deadline, by ``time.monotonic()`` [s]; never outside of one."""
    block = _BLOCK.get()
    return math.inf if block is None else block.end


def ending() -> Callable[[], float] | None:
    """What tells any thread when searches in the block that runs here end, by ``time.monotonic()`` [s].

    That is the end of the block, or the moment in which a stop is asked for: what is found by then has to be written.
    None outside of a block, and where nothing ends it: no deadline, and no signal that asks for a stop.
    """
    block = _BLOCK.get()
    return block.ending if block is not None and (block.may_stop or block.end < math.inf) else None


class _Block:
    """A block under a deadline, which knows the one around it."""

    def __init__(self, deadline: Deadline, grace: Callable[[], float], patience: float) -> None:
        self._deadline, self._grace, self._patience = deadline, grace, patience
        self._outer: _Block | None = None
        self._rings = False  # whether it has set the alarm clock going
        self.frame: FrameType | None = None

    def __enter__(self) -> None:
        self._outer, self.frame = _BLOCK.get(), sys._getframe(1)
        _BLOCK.set(self)
        self._rings = _alarm_is_free()
        if self._rings:
            signal.signal(signal.SIGALRM, _rung)
        _set_alarm()

    def __exit__(self, *_: object) -> None:
        self.frame = None
        _BLOCK.set(self._outer)
        if self._rings:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.signal(signal.SIGALRM, signal.SIG_DFL)
        else:
            _set_alarm()

    @property
    def late(self) -> float:
        """When it is broken off, by ``time.monotonic()`` [s]."""
        return self.end + (min(self._patience, HASTE) if self._deadline.stop.reason else self._patience)

    @property
    def end(self) -> float:
        """When a checkpoint ends it, by ``time.monotonic()`` [s]."""
        own = self._deadline.moment
        if own < math.inf and not self._deadline.stop.reason:
            own += self._grace()
        return own if self._outer is None else min(own, self._outer.end)

    def ending(self) -> float:
        """When searches end, see the function of this name."""
        end = min(self.end, self._deadline.stop.asked)
        return end if self._outer is None else min(end, self._outer.ending())

    @property
    def may_stop(self) -> bool:
        """Whether a signal can end it."""
        return self._deadline.stop.heard or (self._outer is not None and self._outer.may_stop)


_BLOCK: ContextVar[_Block | None] = ContextVar("deadline", default=None)
"""The innermost block that runs in this thread."""


def _alarm_is_free() -> bool:
    return (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
        and signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    )


def _set_alarm() -> None:
    """Set the alarm clock for the innermost block of the main thread.

    A thread that asks for a stop does not see that block, so it lets the alarm ring at once, to be set by the handler.
    """
    if signal.getsignal(signal.SIGALRM) is not _rung:  # others use it, or there is no block
        return
    if threading.current_thread() is not threading.main_thread():
        signal.setitimer(signal.ITIMER_REAL, 1e-3, AGAIN)
        return
    block = _BLOCK.get()
    late = math.inf if block is None else block.late - time.monotonic()
    signal.setitimer(signal.ITIMER_REAL, *((0.0,) if math.isinf(late) else (max(1e-3, late), AGAIN)))


def _rung(number: int, frame: FrameType | None) -> None:
    """Break off what runs, unless that has time left or must be done as a whole; then the alarm rings again."""
    block = _BLOCK.get()
    if block is None or time.monotonic() < block.late:
        _set_alarm()
    elif not _leaving() and _may_break(frame, block.frame):
        raise TimeUp


def _may_break(frame: FrameType | None, block: FrameType | None) -> bool:
    """Whether no call from the block down to what runs has to be done as a whole."""
    while frame is not None and frame is not block:
        package = str(frame.f_globals.get("__name__", "")).partition(".")[0]
        if package in WHOLE or frame.f_code.co_name in HANDLERS:
            return False
        frame = frame.f_back
    return frame is not None


def _leaving() -> bool:
    """Whether a `TimeUp` is on its way already, or a generator is being closed, where one would be lost."""
    error = sys.exc_info()[1]
    while error is not None:
        if isinstance(error, TimeUp | GeneratorExit):
            return True
        error = error.__cause__ or error.__context__
    return False


@contextlib.contextmanager
def stoppable(ready: bool = True) -> Iterator[Stop]:
    """A stop that Ctrl-C and SIGTERM ask for while the block runs; a second signal ends the process at once, and so
    does the first until the stop is ``ready``.

    Only the main thread hears of them.
    """
    stop = Stop(ready=ready)
    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    stop.heard = True
    before = {number: signal.getsignal(number) for number in SIGNALS}

    def ask(number: int, frame: FrameType | None) -> None:
        for each, handler in before.items():
            signal.signal(each, handler)
        if not stop.ready:
            signal.raise_signal(number)
        stop.request(signal.Signals(number).name)

    try:
        for number in SIGNALS:
            if before[number] is not signal.SIG_IGN:  # as a shell leaves Ctrl-C for what runs in the background
                signal.signal(number, ask)
        yield stop
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def process_began() -> float:
    """When this process began, by ``time.monotonic()`` [s]: a time limit counts what it took to start as well."""
    try:
        ticks = float(Path("/proc/self/stat").read_text().rpartition(")")[2].split()[19])
        return time.monotonic() - max(0.0, time.clock_gettime(time.CLOCK_BOOTTIME) - ticks / os.sysconf("SC_CLK_TCK"))
    except (OSError, ValueError, IndexError, AttributeError):  # no Linux
        return time.monotonic()
