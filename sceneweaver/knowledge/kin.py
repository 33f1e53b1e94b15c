"""Which categories people count as one kind, from ``kin.yaml``: a loveseat and a sofa, but no armchair."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular

from .load import read_yaml


@cache
def families() -> tuple[Mapping[str, frozenset[str]], Mapping[str, tuple[str, ...]]]:
    """The families by name, and for words the names of the families that they mean."""
    data = read_yaml(resources.files(__package__ or "").joinpath("kin.yaml").read_text(encoding="utf-8"))
    unknown = sorted({c for members in data["families"].values() for c in members} - set(categories()))
    if unknown:
        raise ValueError(f"kin.yaml: {', '.join(unknown)} are no categories")
    return (
        {name: frozenset(members) for name, members in data["families"].items()},
        {word: tuple(names) for word, names in data["words"].items()},
    )


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
