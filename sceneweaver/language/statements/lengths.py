"""Lengths as people type them: 1.2 m, 120cm, 3 ft 6, 36", four feet, half a metre, 50-60 cm."""

from __future__ import annotations

import re

from ..source import INCH, metres

_COUNTED = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_WORDS = {"half a": 0.5, "an": 1.0, "a": 1.0, **{word: float(k) for k, word in enumerate(_COUNTED, 1)}}
_NUMBER = rf"(?:\d{{1,4}}(?:[.,]\d{{1,3}})?(?:\s?1/2)?|(?:{'|'.join(_WORDS)})(?=\s|-))"
_UNIT = (
    r"(?:(?:centi|milli)?met(?:er|re)s?\b|m\b|cms?\b|mm\b|foot\b|feet\b|ft\b\.?|yards?\b|inch(?:es)?\b|"
    r"in\b(?!\s+(?:front|between|the|a|each|every|any|all|my|our)\b)|'(?!\w)|\"(?!\w))"
)
_ABOUT = (
    r"(?:(?:at\s+(?:the\s+very\s+)?least|no\s+less\s+than|not\s+less\s+than|a\s+minimum\s+of|minimum(?:\s+of)?|min\.?|"
    r"more\s+than|over|about|around|approximately|approx\.?|ca\.?|circa|roughly|say|maybe|perhaps|some|of|a\s+good|"
    r"at\s+minimum|is|be|:|,)\s{0,3}){0,4}"
)

LENGTH = (
    rf"{_ABOUT}(?P<low>{_NUMBER})(?:\s{{0,2}}(?:-|to|or)\s{{0,2}}(?P<most>{_NUMBER}))?\s{{0,2}}-?\s{{0,2}}"
    rf"(?P<unit>{_UNIT})(?:\s{{0,2}}(?P<rest>\d{{1,2}})(?:\s{{0,2}}(?:cm\b|in\b|inch(?:es)?\b|\")|"
    r"(?=\s{0,3}(?:[.,;)]|$|wide|clear|free|between|around|in\s+between|of|on|all))))?"
)
"""A pattern of one length, with what softens it; its groups are what `length_of` reads. """


PLAIN = rf"{_NUMBER}\s{{0,2}}-?\s{{0,2}}{_UNIT}"
"""A pattern of one length with nothing around it, without groups; `plain_length` reads it."""


def _value(number: str, unit: str) -> float:
    half = number.endswith("1/2")
    plain = number.removesuffix("1/2").strip()
    return metres(str(_WORDS.get(plain, plain)), unit) + (0.5 * metres("1", unit) if half else 0.0)


def length_of(found: re.Match[str]) -> tuple[float, float | None]:
    """The length [m] that `LENGTH` matched, and the largest where a range was given."""
    unit, rest = found["unit"], found["rest"]
    low = _value(found["low"], unit)
    if rest and unit.startswith(("m", "f", "'")):
        low += float(rest) * (0.01 if unit.startswith("m") else INCH)
    most = _value(found["most"], unit) if found["most"] else None
    return round(low, 4), round(most, 4) if most is not None else None


def plain_length(text: str) -> float:
    """The length [m] that `PLAIN` matched."""
    found = _PLAIN.fullmatch(text.strip())
    assert found is not None
    return round(_value(found[1], found[2]), 4)


_PLAIN = re.compile(rf"({_NUMBER})\s{{0,2}}-?\s{{0,2}}({_UNIT})")

__all__ = ["LENGTH", "PLAIN", "length_of", "plain_length"]
