"""A condition as numbers: measured quantities, the interval that each must lie in, what to say when it does not."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

TOLERANCE = 1e-3
"""Slack in metres at both ends of an interval of lengths."""

ARM = 0.5
"""Arm in metres by which angles are compared with lengths: 1 degree weighs as much as 9 mm."""


ROUNDING = 1e-9
"""Metres or degrees by which terms may be off in relations that the oracle (tests/oracle) does not define.

Round numbers, such as six chairs at an octagonal table, 15 degrees off its edges, then hold however the room is turned.
"""


class Term(NamedTuple):
    """One quantity: ``value`` must lie in [``low`` - ``slack``, ``high`` + ``slack``]; ``unit`` is m or deg."""

    name: str
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
        return f"{self.name} {value}, {allowed}"


Terms = Sequence[Term]
"""Terms that must all hold."""


class Verdict(NamedTuple):
    """Whether a condition ``holds``; else how far off it is (``excess`` in ``unit``) and the ``text`` that says so."""

    holds: bool
    excess: float = 0.0
    unit: str = "m"
    text: str = ""


HOLDS = Verdict(True)


def at_most(name: str, value: float, high: float, unit: str = "m", slack: float = 0.0) -> Term:
    """Return the term ``value <= high + slack``."""
    return Term(name, value, -math.inf, high, unit, slack)


def at_least(name: str, value: float, low: float, unit: str = "m", slack: float = 0.0) -> Term:
    """Return the term ``value >= low - slack``."""
    return Term(name, value, low, math.inf, unit, slack)


def no(text: str) -> Verdict:
    """Return the verdict of a condition that cannot hold, with the reason."""
    return Verdict(False, 0.0, "m", text)


def judge(alternatives: Iterable[Terms], otherwise: str, rounding: float = 0.0) -> Verdict:
    """Return whether all terms of some alternative hold; if not, speak of the one that is least off.

    ``excess`` is that of the worst failing term in its own unit. Without any alternative the text is ``otherwise``.
    """
    best: list[Term] | None = None
    least = math.inf
    for terms in alternatives:
        failing = [term for term in terms if not term.ok(rounding)]
        if not failing:
            return HOLDS
        total = sum(term.weight for term in failing)
        if best is None or total < least:
            best, least = failing, total
    if best is None:
        return no(otherwise)
    worst = max(best, key=lambda term: term.weight)
    return Verdict(False, worst.excess, worst.unit, "; ".join(map(str, best)))


def length(metres: float) -> str:
    """Return a length for a sentence: millimetres below 1 cm, centimetres below 1 m, else metres."""
    size = abs(metres)
    if size < 0.01:
        return f"{size * 1000:.1f} mm"
    return f"{size * 100:.1f} cm" if size < 1.0 else f"{size:.2f} m"


def _places(term: Term) -> int:
    """Decimals that show the value to be outside its interval."""
    for places in range(1 if term.unit == "deg" else 2, 9):
        shown = round(term.value, places)
        if shown < term.low or shown > term.high:
            return places
    return 9


def _number(value: float, places: int) -> str:
    text = f"{value:.{places}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
