"""Which small things belong to which kind of room, and how many of a kind it has at most: ``small_things.yaml``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.scene import InputError

from .load import read_yaml


def belongs(category: str, room: str) -> bool:
    """Whether people have a thing in a kind of room when nobody asks for it."""
    rooms = _rooms_of().get(category)
    return rooms is None or room in rooms


def most_of(category: str, room: str) -> int | None:
    """How many of a thing a kind of room has at most when nobody asks for more; None: as many as there is room for."""
    return _most().get(category) if belongs(category, room) else 0


def rooms_named(names: Iterable[str]) -> frozenset[str]:
    """The kinds of rooms of some groups of ``small_things.yaml`` and kinds of rooms."""
    groups = _data()["groups"]
    return frozenset(room for name in names for room in groups.get(name, (name,)))


@cache
def _rooms_of() -> Mapping[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for row in _data()["belongs"]:
        rooms = rooms_named(row["rooms"])
        for category in row["what"]:
            found[_known(category)] = rooms | found.get(category, frozenset())
    return MappingProxyType(found)


@cache
def _most() -> Mapping[str, int]:
    return MappingProxyType({_known(c): int(count) for count, names in _data()["most"].items() for c in names})


def _known(category: str) -> str:
    if category not in categories():
        raise InputError(f"small_things.yaml: {category} is no category")
    return category


@cache
def _data() -> Mapping[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("small_things.yaml").read_text(encoding="utf-8"))
