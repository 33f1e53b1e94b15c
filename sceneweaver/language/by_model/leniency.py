"""What small models write and mean: null for an empty list, one value for a list of one, numbers as text.

Only what can mean one thing is mended; the rest stays as it is, for the type of the field to refuse.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

ABSENT = ("", "null", "none", "nil", "n/a", "na", "unknown", "unspecified", "not specified")
"""Words for nothing."""

AT_LEAST = 4
"""How many more than the least there may be where no most is given."""

_RANGE = re.compile(r"\s*(\d+)\s*(?:-|–|to|\.\.)\s*(\d+)\s*")
_DECIMAL = re.compile(r"\s*([+-]?\d+)(?:[.,](\d+))?\s*")
_LENGTH = re.compile(r"\s*([+-]?[\d.,]+)\s*(m|metres?|meters?|cm|mm)\s*", re.IGNORECASE)
_UNITS = {"m": 1.0, "c": 0.01, "mm": 0.001}


def listed(value: Any) -> Any:
    """A list: of nothing for null, of one for a single value, of what JSON in a string says."""
    value = from_json(value)
    if value is None or (isinstance(value, str) and value.strip().lower() in ABSENT):
        return []
    if isinstance(value, (list, tuple)):
        return [item for item in value if item is not None]
    return [value]


def absent(value: Any) -> Any:
    """None for the words that mean nothing was said."""
    return None if isinstance(value, str) and value.strip().lower() in ABSENT else value


def text(value: Any) -> Any:
    """Text without blanks around it; null is none, a list of one text is that."""
    value = value[0] if isinstance(value, list) and len(value) == 1 else value
    return "" if value is None else value.strip() if isinstance(value, str) else value


def number(value: Any) -> Any:
    """A number that was written as text: "2.5", "2,5"; three digits after a comma may be thousands and stay text."""
    value = absent(value)
    if isinstance(value, str) and (found := _DECIMAL.fullmatch(value)):
        whole, rest = found.groups()
        if rest is None:
            return int(whole)
        return value if "," in value and len(rest) == 3 else float(f"{whole}.{rest}")
    return "a truth value" if isinstance(value, bool) else value


def metres(value: Any) -> Any:
    """A length in metres, also "90 cm"."""
    if isinstance(value, str) and (found := _LENGTH.fullmatch(value)):
        plain, unit = number(found[1]), found[2].lower()
        if isinstance(plain, (int, float)):
            return round(plain * _UNITS["mm" if unit == "mm" else unit[0]], 6)
    return number(value)


def count(value: Any) -> Any:
    """Least and most: of "3", 3, [3], "2-4" or {"min": 2, "max": 4}."""
    value = number(from_json(value))
    if isinstance(value, str) and (found := _RANGE.fullmatch(value)):
        return [int(found[1]), int(found[2])]
    if isinstance(value, dict):
        ends = [value.get(low, value.get(other)) for low, other in (("min", "least"), ("max", "most"))]
        value = ends if len(value) <= 2 else value
    if isinstance(value, (list, tuple)):
        ends = [number(end) for end in value]
        if not ends or all(end is None for end in ends):
            return None
        if len(ends) == 2 and ends[0] is None:
            ends[0] = min(1, ends[1]) if isinstance(ends[1], int) else None
        if len(ends) == 2 and ends[1] is None:
            ends[1] = ends[0] + AT_LEAST if isinstance(ends[0], int) else None
        return ends * 2 if len(ends) == 1 else ends
    if isinstance(value, float) and not value.is_integer():
        return value
    return [value, value] if isinstance(value, (int, float)) else value


def term(options: Iterable[str], also: Mapping[str, str] | None = None) -> Callable[[Any], Any]:
    """A word of a vocabulary, however its words are joined and spelt: "Next to" is next_to, "colour" is color.

    Other words for the same are in ``also``.
    """
    known = {**(also or {}), **{_plain(option): option for option in options}}

    def mended(value: Any) -> Any:
        value = absent(value)
        return known.get(_plain(value).replace("colour", "color"), value) if isinstance(value, str) else value

    return mended


def _plain(word: str) -> str:
    return re.sub(r"[\s_\-]+", "_", word.strip().lower())


def from_json(value: Any) -> Any:
    """What a string holds that is itself JSON, which some servers make of lists and objects in arguments."""
    if not isinstance(value, str) or value.strip()[:1] not in ("[", "{"):
        return value
    try:
        return json.loads(value)
    except (ValueError, RecursionError):
        return value


Text = Annotated[str, BeforeValidator(text)]
Number = Annotated[float, BeforeValidator(number), Field(allow_inf_nan=False)]
Metres = Annotated[float, BeforeValidator(metres), Field(allow_inf_nan=False)]
Whole = Annotated[int, BeforeValidator(number)]
Count = Annotated[
    Annotated[tuple[int, ...], Field(min_length=2, max_length=2)] | None, BeforeValidator(count)
]  # a schema that all servers know: no item of a list has a type of its own
Listed = BeforeValidator(listed)
Flag = Annotated[bool, BeforeValidator(lambda value: False if absent(value) is None else value)]
"""Types of fields: text, numbers, metres, counts of least and most, lists (in `Annotated`), truth values."""
