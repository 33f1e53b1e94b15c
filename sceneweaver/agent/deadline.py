"""When a design has to be done. Its end cuts long work off; nothing else of a design depends on the clock."""

from __future__ import annotations

import math
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from types import FrameType

SHORTEST = 0.05
"""Seconds that a search gets even when time is up: a scene has to come out of it."""

SEARCH = 0.75
"""Share of the time left that a search gets."""

AGAIN = 0.5
"""Seconds after which the clock is looked at once more: `TimeUp` may be lost in a callback from C."""


class TimeUp(BaseException):
    """Raised inside `Deadline.enforced` when time is up. No ``Exception``: nothing on the way takes it for a fault."""


@dataclass
class Stop:
    """Asks a running design to end early; a signal handler may do so.

    Attributes:
        allowance: seconds from the request until all files have to be written.
        end: that moment of ``time.monotonic()`` [s]; it never comes until it is asked for.
        reason: who asked, such as "SIGTERM"; empty until then.
    """

    allowance: float = 2.0
    end: float = math.inf
    reason: str = ""
    enforcing: bool = False

    def request(self, reason: str) -> None:
        """Ask; the first reason stays."""
        self.end = min(self.end, time.monotonic() + self.allowance)
        self.reason = self.reason or reason
        if self.enforcing:
            signal.setitimer(signal.ITIMER_REAL, 1e-3, AGAIN)


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

    @contextmanager
    def enforced(self, grace: Callable[[], float] = float) -> Iterator[None]:
        """Raise `TimeUp` in the block once time is up, wherever it is just then.

        The block must leave nothing half done that matters. What asks the deadline itself has some seconds of
        ``grace`` more to end in good order, none unless given, and none when a stop is asked for. Threads other than
        the main one, and processes that use the alarm clock for something else, are left alone.
        """
        if not _alarm_is_free():
            yield
            return

        def expire(number: int, frame: FrameType | None) -> None:
            left = self.moment + (0.0 if self.stop.reason else grace()) - time.monotonic()
            if _unwinding():
                return
            if left > 0 or _finalising(frame):
                signal.setitimer(signal.ITIMER_REAL, min(max(left, 0.01), AGAIN), AGAIN)
            elif self.stop.enforcing:
                raise TimeUp

        report_lost = sys.unraisablehook

        def stay_quiet(lost: sys.UnraisableHookArgs) -> None:
            """Say nothing of a `TimeUp` that a callback has lost: it comes again."""
            if lost.exc_type is not TimeUp:
                report_lost(lost)

        def disarm() -> None:
            self.stop.enforcing = False
            sys.unraisablehook = report_lost
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.signal(signal.SIGALRM, signal.SIG_DFL)

        try:
            signal.signal(signal.SIGALRM, expire)
            self.stop.enforcing, sys.unraisablehook = True, stay_quiet
            if not math.isinf(self.moment):
                signal.setitimer(signal.ITIMER_REAL, max(1e-3, self.left), AGAIN)
            try:
                yield
            finally:
                disarm()
        except TimeUp:  # it may have come while the clock was being stopped
            disarm()
            raise


def _alarm_is_free() -> bool:
    return (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
        and signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    )


def _unwinding() -> bool:
    """Whether a `TimeUp` is on its way already: what waits for threads on that way must not be interrupted."""
    error = sys.exc_info()[1]
    while error is not None and not isinstance(error, TimeUp):
        error = error.__context__
    return error is not None


def _finalising(frame: FrameType | None) -> bool:
    """Whether an exception would be lost here: in a finaliser."""
    while frame is not None and frame.f_code.co_name != "__del__":
        frame = frame.f_back
    return frame is not None


NEVER = Deadline()
"""A deadline that does not come."""
