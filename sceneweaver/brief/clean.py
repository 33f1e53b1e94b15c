"""The text of a request in plain lower-case words, and the measures of its room taken out of it."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field

LONGEST = 20_000
"""Characters that are read; a longer request is cut there, with a note."""

FOOT, INCH = 0.3048, 0.0254
SQUARE_FOOT = FOOT**2

_NUMBER = r"(\d+(?:[.,]\d+)?)"
_LENGTH = r"(meters?|metres?|m|cm|centimet(?:er|re)s?|feet|foot|ft|')"
_BY = r"\s*(?:x|×|by|\*)\s*"
_SQUARE = re.compile(
    _NUMBER + r"\s*-?\s*(m2|m²|sqm|sq\.?\s*m(?:et(?:er|re)s?)?|square[\s-]?met(?:er|re)s?|square[\s-]?m|"
    r"sq\.?\s*ft\.?|sqft|square[\s-]?f(?:ee|oo)t|ft2|ft²)(?![a-z])"
)
_SIDES = re.compile(
    _NUMBER
    + r"\s*"
    + _LENGTH
    + r"?"
    + _BY
    + _NUMBER
    + r"\s*"
    + _LENGTH
    + r"?(?:"
    + _BY
    + _NUMBER
    + r"\s*"
    + _LENGTH
    + r"?)?(?![\w])"
)
_AXIS = r"\s*(?:long|wide|deep|broad|in\s+length|in\s+width)"
_LONG_WIDE = re.compile(
    _NUMBER + r"\s*" + _LENGTH + _AXIS + r"\s*(?:and|by|x|×|,)\s*" + _NUMBER + r"\s*" + _LENGTH + _AXIS + r"(?![a-z])"
)
_CEILING = re.compile(
    r"(?:" + _NUMBER + r"\s*-?\s*" + _LENGTH + r"\s*-?\s*(?:high|tall)?\s*-?\s*ceilings?"
    r"|ceilings?\s*(?:height)?\s*(?:of|is|at|:)?\s*" + _NUMBER + r"\s*" + _LENGTH + r"(?:\s*high)?"
    r"|(?:room\s+)?height\s*(?:of|is|:)?\s*" + _NUMBER + r"\s*" + _LENGTH + r")(?![a-z])"
)
_DIGITS = {
    word: n
    for n, word in enumerate(
        ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"], start=1
    )
}
_SPELT = re.compile(
    r"\b(" + "|".join(_DIGITS) + r")\b(?=\s*-?\s*(?:by|x|square|sq|m|met(?:er|re)s?|feet|foot|ft|cm)\b)"
)
_FAR = re.compile(_NUMBER + r"\s*(?:km|kilomet(?:er|re)s?|miles?)\b")
_BARE = re.compile(r"(?<![\w.])" + _NUMBER + _BY + _NUMBER + r"(?![\w.]|\s*(?:cm|mm|in)\b)")
_ENDLESS = re.compile(r"\d{10,}")
_TAG = re.compile(r"<[^<>]{0,200}>")
_LETTERS = {"‘": "'", "’": "'", "“": '"', "”": '"', "–": "-", "—": ", ", "…": ". ", "\u00a0": " ", "²": "2"}


@dataclass
class Cleaned:
    """Words that are left, and what the measures said: sides and height [m], area [m2]."""

    text: str
    size: tuple[float, float] | None = None
    area: float | None = None
    height: float | None = None
    sides: list[tuple[float, ...]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def clean(text: str) -> Cleaned:
    """Lower case, without control characters and markup, and without the room's measures."""
    notes: list[str] = []
    if len(text) > LONGEST:
        notes.append(f"only the first {LONGEST} of {len(text)} characters were read")
        text = text[:LONGEST]
    for letter, plain in _LETTERS.items():
        text = text.replace(letter, plain)
    text = unicodedata.normalize("NFKC", text).lower()
    found = Cleaned("", notes=notes)
    text = "".join(c if c.isprintable() or c in "\n\t" else " " for c in text)
    text = _TAG.sub(" ", text).replace("§", " ")
    text = _ENDLESS.sub(lambda m: _endless(m, found), text)
    text = re.sub(r"([^\n]{60})[ \t]*\n(?=[a-z])", r"\1 ", text)  # a long line that was wrapped
    text = re.sub(r"[\n;:!?•*]+|\s-\s", " . ", text)
    text = _SPELT.sub(lambda m: str(_DIGITS[m[1]]), text)
    text = _FAR.sub(lambda m: _too_far(m, found), text)
    text = _CEILING.sub(lambda m: _ceiling(m, found), text)
    text = _SQUARE.sub(lambda m: _square(m, found), text)
    text = _LONG_WIDE.sub(r"\1 \2 x \3 \4", text)
    text = _SIDES.sub(lambda m: _sides(m, found), text)
    if not found.sides:
        text = _BARE.sub(lambda m: _bare(m, found), text)
    found.text = text
    return found


def metres(number: str, unit: str | None) -> float:
    """A length in metres."""
    value = float(number.replace(",", "."))
    if unit and unit.startswith(("cm", "centi")):
        return value / 100
    if unit and (unit.startswith("f") or unit == "'"):
        return value * FOOT
    return value


def _ceiling(m: re.Match[str], found: Cleaned) -> str:
    groups = [g for g in m.groups() if g]
    found.height = metres(groups[0], groups[1])
    return " , "


def _square(m: re.Match[str], found: Cleaned) -> str:
    value = float(m[1].replace(",", "."))
    found.area = value * (SQUARE_FOOT if "f" in m[2] else 1.0)
    return " "


def _sides(m: re.Match[str], found: Cleaned) -> str:
    unit = m[6] or m[4] or m[2]
    if unit is None:  # two bare numbers are sides only when a room may have them
        return m[0]
    values = [metres(m[1], m[2] or unit), metres(m[3], m[4] or unit), *([metres(m[5], m[6] or unit)] if m[5] else [])]
    found.sides.append(tuple(round(v, 4) for v in values))
    return f" §{len(found.sides) - 1} "


def _endless(m: re.Match[str], found: Cleaned) -> str:
    found.notes.append(f"'{m[0][:10]}...' is no number that a room has; it was left out")
    return " "


def _too_far(m: re.Match[str], found: Cleaned) -> str:
    found.notes.append(f"'{m[0]}' is no measure of a room; it was left open")
    return " "


def _bare(m: re.Match[str], found: Cleaned) -> str:
    """Sides without a unit are metres when a room may have them."""
    a, b = metres(m[1], None), metres(m[2], None)
    if not (min(a, b) >= 1.5 and max(a, b) <= 40):
        return m[0]
    found.size = (max(a, b), min(a, b))
    found.notes.append(f"'{m[0].strip()}' was read as metres")
    return " "


def check(found: Cleaned) -> None:
    """Measures that no room has are left out, with a note."""
    if found.size is not None and (min(found.size) < 0.8 or max(found.size) > 100):
        found.notes.append(f"a room of {found.size[0]:g} x {found.size[1]:g} m cannot be made; its size was left open")
        found.size = None
    if found.area is not None and not 1.0 <= found.area <= 3000:
        found.notes.append(f"a floor of {found.area:g} m2 cannot be made; its size was left open")
        found.area = None
    if found.height is not None and not 1.8 <= found.height <= 12:
        found.notes.append(f"a ceiling at {found.height:g} m cannot be made; its height was left open")
        found.height = None
