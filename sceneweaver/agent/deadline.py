"""When a design has to be done. Its end cuts long work off; nothing else of a design depends on the clock."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace

from .interrupt import Interrupt, look_again

SHORTEST = 0.05
"""Seconds that a search gets even when time is up: a scene has to come out of it."""

SEARCH = 0.75
"""Share of the time left that a search gets."""


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

    def request(self, reason: str) -> None:
        """Ask; the first reason stays."""
        self.end = min(self.end, time.monotonic() + self.allowance)
        self.reason = self.reason or reason
        look_again()


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

    def enforced(self, grace: Callable[[], float] = float, packages: Iterable[str] = ()) -> Interrupt:
        """A block that ends by `TimeUp` once time is up, at a line of ours or of ``packages``: see `Interrupt`.

        What asks the deadline itself has some seconds of ``grace`` more to end in good order, none unless given, and
        none when a stop is asked for.
        """
        return Interrupt(lambda: self.moment, lambda: 0.0 if self.stop.reason else grace(), packages)


NEVER = Deadline()
"""A deadline that does not come."""
