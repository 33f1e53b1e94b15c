"""Which categories people count as one kind, from ``kin.yaml``: a loveseat and a sofa, but no armchair."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib import resources
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import members

from .load import read_yaml


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
    data = read_yaml(resources.files(__package__ or "").joinpath("kin.yaml").read_text(encoding="utf-8"))
    named = {c for part in ("families", "only_for") for names in data[part].values() for c in names}
    unknown = sorted((named - set(categories())) | (set(data["only_for"]) - set(data["families"])))
    if unknown:
        raise ValueError(f"kin.yaml: {', '.join(unknown)} are no categories or families")
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
