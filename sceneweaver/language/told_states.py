"""What words about states and looks of parts say of things: for who draws them, and for who measures them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from sceneweaver.assets.looks import roles_of_detail
from sceneweaver.assets.states import State, state_of

from .model import Attribute

_DETAIL = re.compile(r"(?P<look>.+) (?P<part>[a-z]+)")

_CONTENT = re.compile(r"(?: of| with)? (?:of|with) .*$")
"""What is in a vessel, behind how full it is."""

PULLED_OUT = "pulled out by"
"""What an attribute says of seats that are not pushed in, before how far [m] they are."""

LAID_FOR = "laid for"
"""What an attribute says of a table with a place laid for each of so many, before their number (0: not told)."""

EACH_OF = "each of"
"""What an attribute says of things that have several colours between them, before these."""

PARTS = ("drawer", "door", "lid")
"""Parts that words about a state may begin with: "drawer pulled out"."""


def state_as_told(category: str, told: Attribute) -> State | None:
    """What an attribute says of things of a category; the words may name the part: "drawer pulled out"."""
    part, _, rest = told.value.partition(" ")
    if part.rstrip("s") in PARTS:
        return state_of(category, rest, part.rstrip("s"))
    return state_of(category, told.value) or state_of(category, _CONTENT.sub("", told.value))


def posture_as_told(state: State, told: Attribute) -> str | None:
    """The posture of a state: of several parts where the words speak of them."""
    return state.several if state.several and told.value.partition(" ")[0].endswith("s") else state.posture


def pulled_as_told(told: Attribute) -> float | None:
    """How far [m] a seat is to be from its table; None where nothing of that is said."""
    words, _, far = told.value.rpartition(" ")
    return float(far) if told.kind == "state" and words == PULLED_OUT else None


def colors_as_told(told: Attribute) -> tuple[str, ...]:
    """The colours that things have between them, each its own; none where nothing of that is said."""
    return tuple(told.value.removeprefix(f"{EACH_OF} ").split(", ")) if told.value.startswith(EACH_OF) else ()


def detail_as_told(told: Attribute) -> tuple[str, str] | None:
    """The part, by the name that drawings know, and the look that an attribute says it has: ("top", "black marble")."""
    found = _DETAIL.fullmatch(told.value) if told.kind == "part" else None
    return (found["part"], found["look"]) if found is not None and roles_of_detail(found["part"]) else None


def words_of_whole(attributes: Iterable[Attribute]) -> str:
    """The words that are said of all of the things, as they are: of no part, no state, and not of some of them."""
    return " ".join(
        told.words
        for told in attributes
        if told.kind != "state" and told.count is None and detail_as_told(told) is None and not colors_as_told(told)
    )


__all__ = [
    "EACH_OF",
    "LAID_FOR",
    "PULLED_OUT",
    "colors_as_told",
    "detail_as_told",
    "posture_as_told",
    "pulled_as_told",
    "state_as_told",
    "words_of_whole",
]
