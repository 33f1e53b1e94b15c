"""When a design has to be done. Its end cuts long loops off; nothing else of a design depends on the clock."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass

SHORTEST = 0.05
"""Seconds that a search gets even when time is up: a scene has to come out of it."""


@dataclass(frozen=True)
class Deadline:
    """A moment of ``time.monotonic()`` [s]; by default it never comes."""

    end: float = math.inf

    @property
    def left(self) -> float:
        """Seconds until it comes; 0 once it has."""
        return max(0.0, self.end - time.monotonic())

    @property
    def passed(self) -> bool:
        """Whether it has come; once true, it stays so."""
        return time.monotonic() >= self.end

    @property
    def time_limit(self) -> float | None:
        """What `refine` may take; None for as long as it likes."""
        return None if math.isinf(self.end) else max(SHORTEST, self.left)

    def before(self, seconds: float) -> Deadline:
        """An earlier one, which keeps so many seconds for what comes after."""
        return Deadline(self.end - seconds)


NEVER = Deadline()
