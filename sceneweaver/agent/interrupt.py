"""Ends a block when its time is up, at a place where nothing is left half done.

An exception that a signal raises in the middle of a library may be lost in a callback, or leave behind a module that is
imported by half, or memory that native code holds on to. So the signal only says that time is up, and `TimeUp` is
raised where our own code, called by our own code alone, comes to a next line.
"""

from __future__ import annotations

import math
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from dis import opname
from types import CodeType, FrameType, TracebackType
from typing import Any

AGAIN = 0.5
"""Seconds after which the clock is looked at once more: `TimeUp` may be lost in a callback."""

POLL = 0.01
"""The same where a debugger watches the lines, so that we cannot."""

PATIENCE = 1.0
"""Seconds that a library gets to come back to us. After that the block ends in the middle of it."""

WHOLE = frozenset(("_frozen_importlib", "importlib", "threading", "concurrent", "weakref", "contextlib", "warp"))
"""Packages of which each call is done as a whole however long it takes: an exception breaks more than the call."""

HANDLERS = ("__enter__", "__exit__", "__del__")
"""Functions of which each has to be done as a whole."""

STATEMENT = ("LOAD_FAST", "LOAD_GLOBAL", "LOAD_NAME", "LOAD_DEREF", "PUSH_NULL", "FOR_ITER")
"""How instructions are called that begin statements and nothing else."""


class TimeUp(BaseException):
    """Raised in a block whose time is up. No ``Exception``: nothing on the way takes it for a fault."""


@dataclass
class Interrupt:
    """A ``with`` block that ends by `TimeUp` once ``end()`` has passed, at a line of ``packages``.

    Nothing happens in threads other than the main one and in processes that use the alarm clock for something else.
    What the block calls in other packages has `PATIENCE` to come to its end first; imports and finalisers have all the
    time that they take.

    Attributes:
        end: the moment of ``time.monotonic()`` [s]; where it changes while the block runs, call `look_again`.
        grace: how many seconds after that it may still end by itself.
        packages: top-level packages in which to end, besides this one and that of the block.
    """

    end: Callable[[], float]
    grace: Callable[[], float] = float
    packages: Iterable[str] = ()
    _frame: FrameType | None = field(default=None, init=False)
    _own: frozenset[str] = field(default=frozenset(), init=False)

    def __enter__(self) -> None:
        if not _alarm_is_free():
            return
        frame = sys._getframe(1)
        self._own = frozenset((_package(frame), __name__.partition(".")[0], *self.packages))
        self._report = sys.unraisablehook
        signal.signal(signal.SIGALRM, self._rung)
        self._frame, sys.unraisablehook = frame, self._lost
        self.arm()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._frame is not None:
            self._disarm()

    def arm(self) -> None:
        """Set the alarm clock to the end."""
        if self._frame is not None and (left := self.end() - time.monotonic()) < math.inf:
            _ring(max(1e-3, left))

    def _disarm(self) -> None:
        self._frame = None  # from here on nothing is raised
        _ring(0.0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        sys.unraisablehook = self._report
        if sys.gettrace() is _no_trace:
            sys.settrace(None)

    def _rung(self, number: int, frame: FrameType | None) -> None:
        if self._frame is None or _cleaning_up():
            return None
        if (left := self.end() + self.grace() - time.monotonic()) > 0:
            return _ring(min(left, AGAIN))
        safe = self._innermost(frame)
        if safe is None:  # the block was left without a word
            return self._disarm()
        if safe is frame or (left < -PATIENCE and self._may_break(frame)):
            raise TimeUp
        return self._watch(safe) if sys.gettrace() in (None, _no_trace) else _ring(POLL)

    def _innermost(self, frame: FrameType | None) -> FrameType | None:
        """The last frame from the block on up to which all are our own; None when the block does not run."""
        frames: list[FrameType] = []
        while frame is not None and frame is not self._frame:
            frames.append(frame)
            frame = frame.f_back
        for inner in reversed(frames) if frame is not None else ():
            if _package(inner) not in self._own or inner.f_code.co_name in HANDLERS:
                break
            frame = inner
        return frame

    def _may_break(self, frame: FrameType | None) -> bool:
        """Whether nothing from here down to the block has to be done as a whole."""
        while frame is not None and frame is not self._frame:
            if _package(frame) in WHOLE or frame.f_code.co_name in HANDLERS:
                return False
            frame = frame.f_back
        return True

    def _watch(self, frame: FrameType) -> None:
        """Raise `TimeUp` as soon as this frame comes to its next line, or to its end."""

        def step(frame: FrameType, event: str, value: Any) -> Callable[..., Any] | None:
            here = event == "return" or (event == "line" and _begins(frame.f_code, frame.f_lasti))
            if not here or _cleaning_up():
                return step
            frame.f_trace = None
            sys.settrace(None)
            if self._frame is not None:
                raise TimeUp
            return None

        frame.f_trace = step
        sys.settrace(_no_trace)

    def _lost(self, lost: sys.UnraisableHookArgs) -> None:
        """Say nothing of a `TimeUp` that a callback has lost: it comes again."""
        if not any(isinstance(error, TimeUp) for error in _causes(lost.exc_value)):
            self._report(lost)


def look_again() -> None:
    """Tell a block that runs that its end has changed; a signal handler may do so."""
    handler = signal.getsignal(signal.SIGALRM)
    running = getattr(handler, "__self__", None)
    if isinstance(running, Interrupt):
        running.arm()


def _no_trace(frame: FrameType, event: str, value: Any) -> None:
    """New frames are not watched."""


def _ring(seconds: float) -> None:
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN if seconds else 0.0)


def _package(frame: FrameType) -> str:
    return str(frame.f_globals.get("__name__", "")).partition(".")[0]


def _begins(code: CodeType, at: int) -> bool:
    """Whether an instruction surely begins a statement.

    It may also begin to leave a ``with``, with an exception or without, and one raised there skips its ``__exit__``.
    """
    return at >= 0 and opname[code.co_code[at]].startswith(STATEMENT)


def _cleaning_up() -> bool:
    """Whether a `TimeUp` is on its way already, or a generator is being closed, where one would be lost."""
    return any(isinstance(error, TimeUp | GeneratorExit) for error in _causes(sys.exc_info()[1]))


def _causes(error: BaseException | None) -> Iterator[BaseException]:
    """An error and those while whose handling it came up."""
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__


def _alarm_is_free() -> bool:
    return (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
        and signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    )
