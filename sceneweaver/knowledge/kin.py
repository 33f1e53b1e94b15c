"""What categories are to each other, from ``kin.yaml``: of one kind (a loveseat and a sofa, but no armchair), fit to
serve for each other, at home in one kind of place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache, lru_cache
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.taxonomy import members

from .load import check_known, data_of


@cache
def families() -> tuple[Mapping[str, frozenset[str]], Mapping[str, tuple[str, ...]]]:
    """The families by name, and for words the names of the families that they mean."""
    data = _file()
    return (
        {name: frozenset(names) for name, names in data["families"].items()},
        {word: tuple(names) for word, names in data["words"].items()},
    )


@cache
def _file() -> Mapping[str, Any]:
    data = data_of("kin.yaml")
    lists = [*data["families"].values(), *data["only_for"].values(), *data["places"].values()]
    lists += [
        *data["stand_ins"],
        *data["interchangeable"],
        *data["anywhere"].values(),
        *data["other_meanings"].values(),
        data["sets"],
    ]
    check_known("kin.yaml", (c for names in lists for c in names), categories())
    check_known("kin.yaml", data["only_for"], data["families"], "family")
    return data


@cache
def kin(category: str, noun: str = "") -> frozenset[str]:
    """The categories of the same kind as one that is called by a noun, itself among them."""
    known, words = families()
    word = singular(noun.lower())
    names = words.get(word, ())
    if not names and word != category.replace("_", " "):
        names = words.get(word.rpartition(" ")[2], ())
    found = {category, *(c for members in known.values() if category in members for c in members)}
    return frozenset(found.union(*(known[name] for name in names)))


def excluded_kinds(unwanted: Iterable[str]) -> frozenset[str]:
    """All categories that a room does not have when it is to have none of some.

    Those are all of their kinds, the members of groups among them, and what is there for one of them alone: a
    television stand where no television is wanted.

    Args:
        unwanted: categories and groups.
    """
    found = {name for word in unwanted for name in (*kin(word), *members(word))}
    known, _ = families()
    return frozenset(found.union(*(names for of, names in _file()["only_for"].items() if known[of] & found)))


@cache
def may_stand_in(category: str) -> frozenset[str]:
    """The categories that may serve where this one is meant: those of its kind and its stand-ins, itself included."""
    return kin(category).union(*(names for names in _file()["stand_ins"] if category in names))


@cache
def interchangeable(category: str) -> frozenset[str]:
    """The categories that are one more of what a person names by this one, itself included."""
    return frozenset((category,)).union(*(names for names in _file()["interchangeable"] if category in names))


def is_several(category: str, noun: str) -> bool:
    """Whether one thing of a category is several of what a noun names: a rail of hooks, no "coat rack"."""
    return category in _file()["sets"] and noun.lower().split()[-1] not in _file()["words_of_sets"]


def other_meanings(noun: str) -> frozenset[str]:
    """The categories that a general word is part of the name of, and that nobody means by the word alone."""
    return frozenset(_file()["other_meanings"].get(singular(noun.lower()), ()))


@lru_cache(maxsize=4096)
def serves(category: str, wanted: tuple[str, ...]) -> int:
    """How well a category serves where some categories or groups are meant: 2 it is one, 1 it may stand in, 0 not."""
    if category in wanted or any(category in members(name) for name in wanted):
        return 2
    return int(any(category in may_stand_in(name) for name in wanted))


@cache
def is_one(category: str, wanted: str, noun: str) -> bool:
    """Whether a person would call a category by a noun that was read as another one, and not a stand-in for it.

    A folding table is a "table"; it is none where a massage table is meant.
    """
    if wanted not in categories() or categories()[wanted].parent is None:  # of anything at all
        return True
    if serves(category, (wanted,)) == 2 or category in interchangeable(wanted):
        return True
    return wanted == resolve(noun).category and category in kin(wanted, noun)


@cache
def at_home_in(place: str) -> frozenset[str]:
    """The categories that belong to one kind of place alone."""
    return frozenset(_file()["places"][place])


@cache
def place_of(category: str) -> str | None:
    """The kind of place that a category belongs to alone; None when it may be anywhere."""
    for place, names in _file()["places"].items():
        if category in names:
            return place
    return "bathroom" if "sanitary" in groups_above(category) else None


def neighbouring(place: str, other: str) -> bool:
    """Whether things of one kind of place are sometimes found in another."""
    return sorted((place, other)) in _file()["neighbours"]


def fits_anywhere(category: str) -> bool:
    """Whether no room is strange for a category."""
    anywhere = _file()["anywhere"]
    return category in anywhere["categories"] or not groups_above(category).isdisjoint(anywhere["groups"])
