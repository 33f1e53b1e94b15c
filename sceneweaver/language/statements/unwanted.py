"""What must not be there by what it is made of, by what it is like, or by where it would hang."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache, partial

from ..model import Exclusion
from ..parsed import Parsed
from ..source import Source
from ..unwanted import at_place, of_material, with_property
from ..vocabulary import words
from .phrases import one_of

_ENDS = (
    r"(?=\s*(?:$|[.,;:!?)]|"
    r"(?:and|or|nor|but|except|please|at all|anywhere|whatsoever|in|on|for|apart|besides|though)\b))"
)
"""What stands after the name of a material that is meant by itself, and not said of what follows."""

_LINK = r"(?:\s*,?\s*(?:and|or|nor)\s+|\s*,\s*)(?:no\s+)?"


def unwanted(source: Source, parsed: Parsed) -> None:
    """Read materials, properties and places that a room is to be without; they go out of the source."""

    def materials(match: re.Match[str]) -> str:
        for name in _named("materials", match["list"]):
            named = tuple(words("unwanted")["materials"][name]["named"])
            add(match, f"nothing of {name}", of_material(name), materials=named)
        return ""

    def properties(match: re.Match[str]) -> str:
        for name in _named("properties", match["list"]):
            add(match, f"nothing {name}", with_property(name))
        return ""

    def places(match: re.Match[str]) -> str:
        (name,) = _named("places", match["list"])
        add(match, f"nothing on the {name}", at_place(name), mount=name)
        return f"on the {name} is " if match["but"] else ""

    def add(match: re.Match[str], said: str, names: tuple[str, ...], **more: object) -> None:
        span = source.span(*match.span())
        parsed.unwanted.append(Exclusion(words=said, categories=names, span=span, **more))  # type: ignore[arg-type]

    readers: tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], str]], ...] = (
        (_places(), places),
        (_list_of("materials", "before_material", _ENDS), materials),
        (_list_of("properties", "before_property", r"\b(?!-)"), properties),
    )
    for pattern, read in readers:
        source.blank(pattern, partial(read))


def _named(section: str, listed: str) -> Iterator[str]:
    """The materials, properties or places that a list names."""
    for word in re.split(_LINK, listed):
        yield from (name for name, row in words("unwanted")[section].items() if word in row["words"])


@cache
def _list_of(section: str, before: str, after: str) -> re.Pattern[str]:
    """One of some words after a negation, or several of them."""
    one = one_of([word for row in words("unwanted")[section].values() for word in row["words"]])
    negation = one_of(words("unwanted")[before])
    return re.compile(rf"\b{negation}\s+(?P<list>{one}\b(?:{_LINK}{one}\b)*){after}")


@cache
def _places() -> re.Pattern[str]:
    data = words("unwanted")
    places = one_of([word for row in data["places"].values() for word in row["words"]])
    before, but = one_of(data["before_place"]), one_of(data["except"])
    return re.compile(
        rf"\b{before}\s+(?:(?:the|any|all|our|my|its|these|those|bare|white|of)\s+){{0,3}}"
        rf"(?P<list>{places})\b(?:\s*,?\s*(?P<but>{but})\b)?"
        r"(?!\s+(?:between|beside|behind|above|by|near|next)\b)"
    )
