"""The clock of a command: what it needs is done in time or ends with one line, what it can do without is left out."""

from __future__ import annotations

import contextlib
import math
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NoReturn, TypeVar

import typer

from sceneweaver.runtime.deadline import Deadline, TimeUp, stoppable
from sceneweaver.scene import Scene, SceneWeaverError

from .exit_codes import UNFINISHED

LEAST = 0.8
"""Seconds that what a command is about gets, however late it is: something has to come out of it."""

LEAST_EXTRA = 0.4
"""The same of what it can do without."""

PATIENT = 2.0
"""Times as long as a search may take, that it gets to come to its end."""

PER_OBJECT = 2e-3
"""Seconds that it takes to judge and draw an object, about."""

MOST_KEPT = 0.4
"""Share of the time left that is kept for what comes after at most."""

Found = TypeVar("Found")


class OutOfTime(SceneWeaverError):
    """Time was up before there was anything to write."""

    exit_code = UNFINISHED


@dataclass
class Clock:
    """When a command has to end: after its time limit, or soon after a signal.

    Attributes:
        deadline: that moment.
        seconds: the time limit; None: there is none.
        left_out: what there was no time for.
    """

    deadline: Deadline
    seconds: float | None
    left_out: list[str]

    def for_search(self, keep: float) -> float | None:
        """Seconds that a search may take, so that ``keep`` [s] are left for what comes after; None: no limit."""
        if self.seconds is None:
            return None
        return max(LEAST, self.deadline.left - min(keep, MOST_KEPT * self.deadline.left))

    def needed(self, what: str, work: Callable[[], Found]) -> Found:
        """What ``work`` returns, which gets twice `LEAST` seconds, however late it is.

        Raises:
            OutOfTime: time was up before it was done; ``what`` names it. A signal ends the process as ever.
        """
        began, end = time.monotonic(), self.deadline
        try:
            with end.enforced(lambda: max(0.0, began + PATIENT * LEAST - end.moment)):
                return work()
        except TimeUp:
            pass
        self.over(what)

    def over(self, what: str) -> NoReturn:
        """End a command that has nothing to write, as `needed` does."""
        reason = self.deadline.stop.reason
        if reason == signal.SIGINT.name:
            raise KeyboardInterrupt
        if reason:
            sys.exit(128 + signal.Signals[reason])
        raise OutOfTime(f"{what}: {self.seconds:g} s were not enough; give more with --time-limit")

    def extra(self, what: str, work: Callable[[], object]) -> bool:
        """Whether ``work``, which the command can do without, was done in time; else it is said what was left out.

        What comes after something that was left out is not begun.
        """
        began, end = time.monotonic(), self.deadline
        if self.left_out and end.passed:
            self.left_out.append(what)
            return False
        try:
            with end.enforced(lambda: max(0.0, began + LEAST_EXTRA - end.moment)):
                work()
            return True
        except TimeUp:
            self.left_out.append(what)
            return False

    def code(self, code: int) -> int:
        """The exit code: the one given, or that of a command that was cut off before it was whole."""
        return UNFINISHED if self.left_out else code

    def tell(self) -> None:
        """Say what was left out, on a line of its own."""
        if self.left_out:
            why = self.deadline.stop.reason or f"{self.seconds:g} s are over"
            typer.echo(f"  left out ({why}): {', '.join(self.left_out)}")


def keep_for(scene: Scene) -> float:
    """Seconds to keep for judging a scene, writing it and drawing its plan."""
    return 2 * LEAST_EXTRA + PER_OBJECT * len(scene.objects)


@contextlib.contextmanager
def clock(seconds: float | None, began: float) -> Iterator[Clock]:
    """The clock of a command that may take so many seconds from ``began`` on, by ``time.monotonic()``.

    While the block runs, Ctrl-C and SIGTERM ask it to end with what there is, within the allowance of their `Stop`.
    """
    with stoppable() as stop:
        yield Clock(Deadline(began + (math.inf if seconds is None else seconds), stop=stop), seconds, [])
