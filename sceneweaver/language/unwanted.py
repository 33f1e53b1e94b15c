"""Which categories a word for many kinds of things, a material or a property rules out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.roles import with_role
from sceneweaver.assets.taxonomy import members
from sceneweaver.assets.wordnet import of_kind

from .vocabulary import words

BROAD = 120
"""Categories that a noun of a dictionary rules out at most; more are too many to mean ("no containers")."""


def kinds_unwanted(noun: str) -> tuple[str, ...]:
    """The categories that "no" with a noun for many kinds of things rules out; none where it is no such noun.

    Examples:
        >>> from sceneweaver.language.unwanted import kinds_unwanted
        >>> "laptop" in kinds_unwanted("computers")
        True
    """
    name = _classes().get(noun) or _classes().get(singular(noun))
    named = _of_row(words("unwanted")["classes"][name]) if name is not None else set[str]()
    below = of_kind(noun)
    return _bodies(named | below if len(below) <= BROAD and name is None else named)


def is_class(noun: str) -> bool:
    """Whether a noun is one for many kinds of things: "electronics"."""
    return noun in _classes() or singular(noun) in _classes()


@cache
def of_material(material: str) -> tuple[str, ...]:
    """The categories that are of a material whatever else is said."""
    return _bodies(_of_row(words("unwanted")["materials"][material]))


@cache
def with_property(name: str) -> tuple[str, ...]:
    """The categories that have a property: breakable, sharp ..."""
    return _bodies(_of_row(words("unwanted")["properties"][name]))


@cache
def at_place(place: str) -> tuple[str, ...]:
    """The categories that hang on a wall or from a ceiling as a rule, but for what belongs to the building."""
    apart = belongs_there(place)
    return tuple(name for name, one in categories().items() if one.mount[0] == place and name not in apart)


@cache
def belongs_there(place: str) -> frozenset[str]:
    """The categories that a bare wall or ceiling may have: fittings of the building, and what hangs at windows."""
    row = words("unwanted")["places"][place]
    return frozenset((*row["but"], *(name for group in row["but_groups"] for name in members(group))))


@cache
def _classes() -> dict[str, str]:
    """The words for each class, singular and as they are."""
    found: dict[str, str] = {}
    for name, row in words("unwanted")["classes"].items():
        for word in (name, *row["words"]):
            found.setdefault(word, name)
            found.setdefault(singular(word), name)
    return found


def _of_row(row: Mapping[str, Any]) -> set[str]:
    data = words("unwanted")
    found = {*row.get("things", ())}
    for group in row.get("groups", ()):
        found |= {*members(group)}
    for noun in row.get("kinds", ()):
        found |= of_kind(noun)
    for role in row.get("roles", ()):
        found |= with_role(role)
    for name in row.get("classes", ()):
        found |= _of_row(data["classes"][name])
    for material in row.get("of", ()):
        found |= _of_row(data["materials"][material])
    return found - {*row.get("but", ())}


def _bodies(names: Iterable[str]) -> tuple[str, ...]:
    """Those that are categories with a body, in the order of the taxonomy."""
    wanted = {*names}
    return tuple(name for name, row in categories().items() if name in wanted and row.size is not None)


__all__ = ["at_place", "belongs_there", "is_class", "kinds_unwanted", "of_material", "with_property"]
