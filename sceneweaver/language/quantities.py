"""Lengths and numbers as people say them, written out in figures with units before anything else is read.

"A yard and a half", "six foot four", "2m40", "turning circle 150" and "forty pairs minimum" become "1.5 yards",
"1.93 m", "2.40 m", "turning circle 150 cm" and "at least forty pairs", so that each reader of lengths and of numbers
has to know one way of writing them. What is read by pattern stands in ``lexicon/quantities.yaml``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import cache

from .alternatives import one_of
from .model import Span
from .vocabulary import NUMBERS, words

INCHES_A_FOOT = 12

CENTIMETRES, MILLIMETRES = 20, 400
"""Least bare numbers that are lengths in these units."""

HIGHEST = 12.0
"""Bare number up to which the height of a ceiling is one of metres."""

_FOOT, _INCH = 0.3048, 0.0254
_SMALL = {word: n for word, n in NUMBERS.items() if n <= 19 and word not in ("dual", "zero", "a")}
_TENS = {word: n for word, n in NUMBERS.items() if 20 <= n < 100 and n % 10 == 0}
_UNITS = {word: n for word, n in _SMALL.items() if n < 10}
_SPELT = (
    rf"(?:(?:(?:a|{one_of(_UNITS)}) hundred(?: and)? )?{one_of(_TENS)}(?:[ -]{one_of(_UNITS)})?"
    rf"|(?:(?:a|{one_of(_UNITS)}) hundred(?: and)? )?{one_of(_SMALL)}|(?:a|{one_of(_UNITS)}) hundred)"
)
_DIGITS = r"\d{1,4}(?:[.,]\d{1,3})?"
_NUMBER = rf"(?:{_DIGITS}|{_SPELT})"
_LONG = (
    r"(?:(?:centi|milli)?met(?:er|re)s?|m|cms?|mm|yards?|yds?|inch(?:es)?|feet|ft|"
    r"foot(?!\s(?:stool|rest|board|bath|spa|pedal|end|of)))\b"
)
_SQUARE = r"(?:sq(?:uare|\.)?[\s-]?(?:m|met(?:er|re)s?|f(?:ee|oo)?t)|sqm|m2)\b"
_UNIT = rf"(?:{_SQUARE}|{_LONG})"
_BEHIND = (
    r"\s{0,3}(?:[.,;:)!?]|$|"
    r"(?:tall|high|long|wide|deep|so|and|or|in|person|man|woman|x|by|off|from|at|with|on|clear|apart|to|between)\b)"
)
"""What follows a length that ends in a bare number."""

_ENDS = r"(?=\s{0,3}(?:[.,;:)!?]|$))"

_FIGURE = re.compile(r"\d+(?:\.\d+)?")

Rule = tuple[re.Pattern[str], Callable[[re.Match[str]], str | None]]
"""What is looked for, and what is written for it; None leaves it."""


def plain_quantities(text: str, origin: Sequence[int], told: dict[Span, float] | None = None) -> tuple[str, list[int]]:
    """A text in lower case with its lengths and numbers in figures with units, and where each character of it stands.

    Time grows with the length of the text.

    Args:
        text: in lower case.
        origin: where each character stands in the request.
        told: gets the number that is written for words of the request, by where they stand there.
    """
    places = list(origin)
    metric = re.search(r"\d\s?(?:m|cm|mm|met(?:er|re)s?)\b", text) is not None
    imperial = not metric and re.search(r"\d\s?(?:ft|feet|foot|'|\"|in\b|inch(?:es)?)", text) is not None
    for pattern, write in (*_rules(), *_bare_rules(imperial)):
        text, places = _written(pattern, write, text, places, told if told is not None else {})
    return text, places


def _written(
    pattern: re.Pattern[str],
    write: Callable[[re.Match[str]], str | None],
    text: str,
    places: list[int],
    told: dict[Span, float],
) -> tuple[str, list[int]]:
    """The text with what is written for each match of a pattern, and where each character of it stands."""
    letters: list[str] = []
    found: list[int] = []
    at = 0
    for m in pattern.finditer(text):
        said = write(m)
        if not said or said == m[0]:
            continue
        last = len(m[0]) - 1
        if (number := _FIGURE.search(said)) is not None:
            told[Span(places[m.start()], places[m.end() - 1] + 1)] = float(number[0])
        letters += (text[at : m.start()], said)
        found += places[at : m.start()]
        found += [places[m.start() + min(k, last)] for k in range(len(said) - 1)]
        found.append(places[m.end() - 1])
        at = m.end()
    return ("".join((*letters, text[at:])), found + places[at:]) if at else (text, places)


def spelt(number: str) -> float:
    """The value of a number in figures or in words up to a thousand."""
    if number[0].isdigit():
        return float(number.replace(",", "."))
    value = 0
    for word in re.findall(r"[a-z]+", number):
        value = max(1, value) * 100 if word == "hundred" else value + {"a": 1, "and": 0, **NUMBERS}[word]
    return float(value)


@cache
def _rules() -> tuple[Rule, ...]:
    data = words("quantities")
    least, most = one_of(data["least_behind"]), one_of(data["most_behind"])
    counted = rf"{_NUMBER} (?:(?!(?:of|and|or|to|at|in|on|min|max|not|no)\b)[a-z]+ ?){{1,3}}?"
    extent = "wide|clear|free|high|tall|long|deep"
    lengths = rf"(?:about |around |roughly )?{_DIGITS}\s?(?:{_UNIT})(?: (?:{extent}|of [a-z]+))?"
    bare = rf"(?<![\w.])\d{{2,4}}(?: (?:{extent}))?"
    rows: tuple[tuple[str, Callable[[re.Match[str]], str | None]], ...] = (
        (r"(\d{0,3}?) ?([13])⁄([248])(?!\d)", lambda m: f"{int(m[1] or 0) + int(m[2]) / int(m[3]):g}"),
        (r"(?<=[\s(])(>=|≥|=>)\s?(?=\d)", lambda m: "at least "),
        (r"(?<=[\s(])(<=|≤|=<)\s?(?=\d)", lambda m: "at most "),
        (r"(?<![\w.])(\d{1,2})m(\d\d)(?!\w|\.\d|\s?(?:cm|mm|m|inch)\b)", lambda m: f"{m[1]}.{m[2]} m"),
        (rf"\b(a|{_SPELT}|\d{{1,2}}) (?:metre|meter)s? ({one_of(_TENS)}(?:[ -]{one_of(_UNITS)})?)"
         rf"(?={_BEHIND})", lambda m: f"{_of(m[1]) + spelt(m[2]) / 100:.2f} m"),
        (rf"\b(a|an|{_NUMBER}) and a half[ -](?={_UNIT})", lambda m: f"{_of(m[1]) + 0.5:g} "),
        (rf"\b(a|an|{_NUMBER})[ -]({_LONG}) and a half\b", lambda m: f"{_of(m[1]) + 0.5:g} {m[2]}"),
        (rf"\bthree[ -]quarters of an? (?={_LONG})", lambda m: "0.75 "),
        (r"\bhalf an? (?=(?:met(?:er|re)|yard)\b)", lambda m: "0.5 "),
        (rf"\ba couple of (?={_LONG})", lambda m: "2 "),
        (rf"\ban? ({_LONG}) or two\b", lambda m: f"1 to 2 {m[1]}"),
        (rf"\b({_SPELT}) point ({one_of(_UNITS)}) (?={_UNIT})", lambda m: f"{spelt(m[1]):g}.{spelt(m[2]):g} "),
        (_FEET, _feet),
        (rf"\b({_SPELT})[ -](?={_UNIT})", _figures),
        (rf"\b(?:{one_of(data['nearly'])}) (?={_NUMBER})", lambda m: "about "),
        (rf"(?<![\w.])({_NUMBER}) or so (?={_UNIT}|[a-z])", lambda m: f"about {m[1]} "),
        (rf"(?<![\w.])(a|an|{_NUMBER})\s?({_LONG}) or so\b", lambda m: f"about {_of(m[1]):g} {m[2]}"),
        (r"\b(?:(?:a|one) )?dozen or so ", lambda m: "about 12 "),
        (r"\ba (?:clear|free) (metre|meter|yard)\b", lambda m: f"1 {m[1]} clear"),
        (r"\ba (?:good|full) (metre|meter|yard)\b", lambda m: f"1 {m[1]}"),
        (r"\b(?:an? )(yard|metre|meter)(?= (?:off|from|away|apart|between|clear|free|wide|of|behind|in front|to)\b)",
         lambda m: f"1 {m[1]}"),
        (r"(?<![\w.])(\d{1,4})(?:\+| plus)(?= ?[a-z]|\s?(?:[.,;)!]|$))(?! ?(?:years?|yrs?)\b)",
         lambda m: f"at least {m[1]}"),
        (rf"\bbetween ({_NUMBER}) and ({_NUMBER})(?= [a-z])(?! ?(?:{_UNIT}|x\b|o'clock|am\b|pm\b))", _range),
        (rf"(?<![\w.])({lengths}|{bare})(?:\s?,)? (?:{least})(?!\s?\d| {_NUMBER}\b)", lambda m: f"at least {m[1]}"),
        (rf"(?<![\w.])({lengths}|{bare})(?:\s?,)? (?:{most})(?!\s?\d| {_NUMBER}\b)", lambda m: f"at most {m[1]}"),
        (rf"(?<![\w.])({counted})(?:,? )?(?:minimum|min|at (?:the )?least|or more)(?=\s{{0,3}}(?:[.,;:)!?]|$| please))",
         lambda m: f"at least {m[1].rstrip()}"),
        (rf"(?<![\w.])({counted})(?:,? )?(?:maximum|max|at (?:the )?most|tops)(?=\s{{0,3}}(?:[.,;:)!?]|$| please))",
         lambda m: f"at most {m[1].rstrip()}"),
        (rf"(?<![\w-])(?:{one_of(_TENS)})[ -](?:{one_of(_UNITS)})(?= [a-z])", lambda m: f"{spelt(m[0]):g}"),
        (rf"\b(?:a )?(?:minimum|min\.?)(?: of)? (?={_NUMBER}[\s-][a-z])", lambda m: "at least "),
        (rf"\b(?:a )?(?:maximum|max\.?)(?: of)? (?={_NUMBER}[\s-][a-z])", lambda m: "at most "),
    )  # fmt: skip
    return tuple((re.compile(pattern), write) for pattern, write in rows)


@cache
def _bare_rules(imperial: bool) -> tuple[Rule, ...]:
    """Numbers without a unit that are lengths by what stands beside them; of inches where a request has feet alone."""
    data = words("quantities")
    measured, links, behind = one_of(data["measured"]), one_of(data["links"]), one_of(data["behind"])
    limits, on, room = one_of(data["limits"]), one_of(data["goes_on"]), one_of(data["of_room"])
    number = r"(?P<n>\d{1,4}(?:\.\d{1,2})?)"
    alone = rf"(?!\w|[.,]\d|\s?by\s?\d|\s?(?:x|×|\*|%|°|'|\"|/)\s?|\s?(?:-|to|or|and)\s?\d| (?:{_UNIT}))"
    goes_on = rf"(?=\s{{0,3}}(?:[.,;:)(!?\n]|$)| {on}\b)"

    def with_unit(m: re.Match[str]) -> str | None:
        said, unit = m[0], _unit(m["n"], m.groupdict().get("room") is not None, imperial)
        end = m.end("n") - m.start()
        return None if unit is None else f"{said[:end]} {unit}{said[end:]}"

    def as_before(m: re.Match[str]) -> str | None:
        unit = _unit(m["n"], False, imperial)
        return None if unit is None else f"{m[0]} {unit} {m['axis']}"

    rows = (
        (rf"\b(?P<room>{room})(?:(?:\s?[:=,]?\s)(?:{links}\b)?){{1,4}}{number}{alone}{goes_on}", with_unit),
        (rf"\b{measured}(?:(?:\s?[:=]?\s)(?:{links}\b)?){{1,5}}{number}{alone}{goes_on}", with_unit),
        (rf"(?<![\w.,]){number}(?=[ -]{behind}\b){alone}", with_unit),
        (rf"\b{limits} {number}{alone}{goes_on}", with_unit),
        (rf"(?<=[ -])(?P<axis>high|tall|wide|deep|long)(?P<and>,? (?:and )?(?:the )?[a-z]+ )(?P<n>\d{{2,3}}){_ENDS}",
         as_before),
    )  # fmt: skip
    return tuple((re.compile(pattern), write) for pattern, write in rows)


def _unit(number: str, of_room: bool, imperial: bool) -> str | None:
    """The unit of a length that has none, by how large it is; None where it may be no length."""
    value = float(number)
    if "." in number or (of_room and value <= HIGHEST):
        return "m" if 0.2 <= value <= HIGHEST else None
    if value < CENTIMETRES:
        return None
    if imperial:
        return "in" if value < 120 else None
    return "cm" if value < MILLIMETRES else "mm"


_REST = rf"\d{{1,2}}|{one_of([*_UNITS, 'ten', 'eleven'])}"
_FEET = (
    rf"(?<![\w.])(?P<feet>\d{{1,2}}|{one_of(_SMALL)})(?:[\s-]?(?:foot|feet|ft\.?)[\s-]|'(?=\d))(?P<rest>{_REST})"
    rf"(?:(?P<mark>\"|[\s-]?(?:in|inch|inches)\b)|(?={_BEHIND}))"
)


def _feet(m: re.Match[str]) -> str | None:
    feet, inches = spelt(m["feet"]), spelt(m["rest"])
    return None if inches >= INCHES_A_FOOT else f"{feet * _FOOT + inches * _INCH:.2f} m"


def _of(number: str) -> float:
    return 1.0 if number in ("a", "an") else spelt(number)


def _figures(m: re.Match[str]) -> str | None:
    """Numbers beyond those that every reader knows in words."""
    value = spelt(m[1])
    return f"{value:g} " if value > len(_SMALL) or " " in m[1] or "-" in m[1] else None


def _range(m: re.Match[str]) -> str | None:
    low, high = spelt(m[1]), spelt(m[2])
    return f"{low:g} to {high:g}" if low < high <= 10 * max(low, 1.0) else None


__all__ = ["plain_quantities", "spelt"]
