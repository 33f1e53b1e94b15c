"""A condition as numbers: measurements, the interval that each must lie in, what to say when it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

TOLERANCE = 1e-3
"""Slack in metres at both ends of an interval of lengths."""

ARM = 0.5
"""Arm in metres by which angles are compared with lengths: 1 degree weighs as much as 9 mm."""


ROUNDING = 1e-9
"""Metres or degrees by which measurements may be off in relations that the oracle (tests/oracle) does not define.

Round numbers, such as six chairs at an octagonal table, 15 degrees off its edges, then hold however the room is turned.
"""


class Measurement(NamedTuple):
    """One quantity: ``value`` must lie in [``low`` - ``slack``, ``high`` + ``slack``]; ``unit`` is m or deg."""

    quantity: str
    value: float
    low: float
    high: float
    unit: str = "m"
    slack: float = 0.0

    def ok(self, rounding: float = 0.0) -> bool:
        """Whether the value lies in the interval, slack included."""
        slack = self.slack + rounding
        return self.low - slack <= self.value <= self.high + slack

    @property
    def excess(self) -> float:
        """How far the value is from the interval without its slack, in its own unit."""
        return max(self.low - self.value, self.value - self.high, 0.0)

    @property
    def weight(self) -> float:
        """The excess as a length [m], degrees taken on `ARM`."""
        return self.excess if self.unit == "m" else math.radians(self.excess) * ARM

    def __str__(self) -> str:
        places = _places(self)
        value = f"{_number(self.value, places)} {self.unit}"
        low, high = (_number(x, max(2, places)) for x in (self.low, self.high))
        if self.low == -math.inf:
            allowed = f"at most {high} m" if self.unit == "m" else f"allowed {high}"
        elif self.high == math.inf:
            allowed = f"at least {low} {self.unit}"
        else:
            allowed = f"allowed {low} to {high} {self.unit}"
        return f"{self.quantity} {value}, {allowed}"


Measurements = Sequence[Measurement]
"""Measurements that must all lie in their intervals."""


class Judgement(NamedTuple):
    """Whether a condition ``holds``; else the ``text`` that says why not, and the ``worst`` measurement if any."""

    holds: bool
    text: str = ""
    worst: Measurement | None = None


HOLDS = Judgement(True)


def at_most(quantity: str, value: float, high: float, unit: str = "m", slack: float = 0.0) -> Measurement:
    """Return the measurement with ``value <= high + slack``."""
    return Measurement(quantity, value, -math.inf, high, unit, slack)


def at_least(quantity: str, value: float, low: float, unit: str = "m", slack: float = 0.0) -> Measurement:
    """Return the measurement with ``value >= low - slack``."""
    return Measurement(quantity, value, low, math.inf, unit, slack)


def fails(text: str) -> Judgement:
    """Return the judgement of a condition that cannot hold, with the reason."""
    return Judgement(False, text)


def judge(alternatives: Iterable[Measurements], otherwise: str, rounding: float = 0.0) -> Judgement:
    """Return whether all measurements of some alternative are in order; if not, speak of the one that is least off.

    Without any alternative the text is ``otherwise``.
    """
    best: list[Measurement] | None = None
    least = math.inf
    for measurements in alternatives:
        failing = [m for m in measurements if not m.ok(rounding)]
        if not failing:
            return HOLDS
        total = sum(m.weight for m in failing)
        if best is None or total < least:
            best, least = failing, total
    if best is None:
        return fails(otherwise)
    return Judgement(False, "; ".join(map(str, best)), max(best, key=lambda m: m.weight))


def length(metres: float) -> str:
    """Return a length for a sentence: millimetres below 1 cm, centimetres below 1 m, else metres."""
    size = abs(metres)
    if size < 0.01:
        return f"{size * 1000:.1f} mm"
    return f"{size * 100:.1f} cm" if size < 1.0 else f"{size:.2f} m"


def _places(m: Measurement) -> int:
    """Decimals that show the value to be outside its interval."""
    for places in range(1 if m.unit == "deg" else 2, 9):
        shown = round(m.value, places)
        if shown < m.low or shown > m.high:
            return places
    return 9


def _number(value: float, places: int) -> str:
    text = f"{value:.{places}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
