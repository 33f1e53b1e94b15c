"""What measures give: readings of rooms, doors, stairs or the plan, by the name of the measure."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from ..profile import MEASURES, Rule
from .facts import PlanFacts


@dataclass(frozen=True)
class Reading:
    """One value of a measure.

    Attributes:
        rooms: ids of what it is about.
        value: in the measure's unit, exactly.
        what: names value and subject in a line, such as "bath: shorter side"; of faults the whole line.
        unit: of the value in that line; None where ``what`` is the whole line.
    """

    rooms: tuple[str, ...]
    value: Fraction
    what: str
    unit: str | None = None


Measure = Callable[[PlanFacts, Rule], Iterable[Reading]]
_MEASURES: dict[str, Measure] = {}


def measure(name: str) -> Callable[[Measure], Measure]:
    """Register what a row's ``measure`` names."""
    if name not in MEASURES:
        raise ValueError(f"{name} is no measure of profiles")

    def register(function: Measure) -> Measure:
        _MEASURES[name] = function
        return function

    return register


def measures() -> Mapping[str, Measure]:
    """All measures by name."""
    return _MEASURES


def fault(rooms: Iterable[str], line: str) -> Reading:
    """A reading of something that must not be."""
    return Reading(tuple(rooms), Fraction(1), line)


def number(value: Fraction, unit: str) -> str:
    """A value for a line, rounded to what the unit needs."""
    if unit == "m":
        return f"{float(value):.3f} m"
    if unit == "m2":
        return f"{float(value):.2f} m2"
    if unit == "%":
        return f"{float(value) * 100:.1f} %"
    return f"{float(value):.4g}{' ' + unit if unit else ''}"


def broken(readings: Iterable[Reading], rule: Rule) -> Iterator[tuple[Reading, Fraction, str]]:
    """The readings that break a row, with how far they are out and one line."""
    least = None if rule.least is None else Fraction(repr(rule.least))
    most = None if rule.most is None else Fraction(repr(rule.most))
    for reading in readings:
        for bound, excess, word in (
            (least, None if least is None else least - reading.value, "at least"),
            (most, None if most is None else reading.value - most, "at most"),
        ):
            if bound is None or excess is None or excess <= 0:
                continue
            line = reading.what
            if reading.unit is not None:
                line = f"{line} is {number(reading.value, reading.unit)}; {word} {number(bound, reading.unit)}"
            yield reading, excess, line
