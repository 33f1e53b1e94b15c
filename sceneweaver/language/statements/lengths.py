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
UNIT = re.compile(_UNIT)
"""A unit of length at the beginning of a text."""

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


_MOST = (
    r"(?:at\s+(?:the\s+very\s+)?most|no\s+more\s+than|not\s+more\s+than|max(?:imum)?\.?(?:\s+of)?|up\s+to|under|below|"
)
_MOST += r"less\s+than|(?:no|not)\s+(?:higher|taller|wider|deeper|longer|bigger)\s+than)"
_LEAST = (
    r"(?:at\s+(?:the\s+very\s+)?least|no\s+less\s+than|not\s+less\s+than|min(?:imum)?\.?(?:\s+of)?|over|more\s+than|"
)
_LEAST += r"a\s+minimum\s+of)"
_SOFT = (
    r"(?:about|around|approximately|approx\.?|ca\.?|circa|roughly|some|nearly|almost|maybe|exactly|just|only|say|good)"
)

BOUNDED = (
    rf"(?:(?:(?P<most>{_MOST})|(?P<least>{_LEAST})|(?P<soft>{_SOFT}))\s{{1,2}}){{0,2}}"
    rf"(?:(?:between|from)\s{{1,2}}(?P<from>{_NUMBER})\s{{0,2}}(?P<unit0>{_UNIT})?\s{{1,2}}(?:and|to)\s{{1,2}}"
    rf"(?P<to>{_NUMBER})\s{{0,2}}-?\s{{0,2}}(?P<unit1>{_UNIT})"
    rf"|(?P<low>{_NUMBER})(?:\s{{0,2}}(?:-|to|or)\s{{0,2}}(?P<high>{_NUMBER}))?\s{{0,2}}-?\s{{0,2}}(?P<unit>{_UNIT})"
    rf"(?:\s{{0,2}}(?P<rest>\d{{1,2}})(?:\s{{0,2}}(?:cm\b|in\b|inch(?:es)?\b|\"))?(?!\s?\w|[.,x]\d))?)"
)
"""A pattern of one length or of two ends of it, with what bounds it; its groups are what `bounded_length` reads."""


def bounded_length(found: re.Match[str]) -> tuple[float | None, float | None, bool]:
    """The least and the largest length [m] that `BOUNDED` matched, the same twice for one; whether it is vague."""
    if found["from"]:
        unit = found["unit1"]
        return _value(found["from"], found["unit0"] or unit), _value(found["to"], unit), False
    low = _value(found["low"], found["unit"])
    if found["rest"] and found["unit"].startswith(("m", "f", "'")):
        low += float(found["rest"]) * (0.01 if found["unit"].startswith("m") else INCH)
    high = _value(found["high"], found["unit"]) if found["high"] else low
    low, high = round(low, 4), round(high, 4)
    if found["most"]:
        return None, high, False
    return (low, None, False) if found["least"] else (low, high, bool(found["soft"]))


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

__all__ = ["BOUNDED", "LENGTH", "PLAIN", "UNIT", "bounded_length", "length_of", "plain_length"]
