"""When things came into use and went out of it, from ``since.yaml``: what a room of another time cannot have."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType

from sceneweaver.assets import categories

from .load import check_known, data_of


@cache
def since() -> Mapping[str, int]:
    """The year from which on there is a thing, by category; what is not here was always there."""
    found = {name: int(year) for year, names in data_of("since.yaml")["since"].items() for name in names}
    check_known("since.yaml", found, categories())
    return MappingProxyType(found)


@cache
def until() -> Mapping[str, int]:
    """The year up to which rooms have a thing by themselves, by category."""
    found = {name: int(year) for year, names in data_of("since.yaml")["until"].items() for name in names}
    check_known("since.yaml", found, categories())
    return MappingProxyType(found)


def is_too_young(category: str, year: int) -> bool:
    """Whether a thing came into use after a year."""
    return since().get(category, year) > year


@cache
def out_of_time(year: int) -> frozenset[str]:
    """The categories that a room of a year does not have by itself: those to come, and those out of use."""
    gone = {name for name, last in until().items() if last < year}
    return frozenset(gone | {name for name, first in since().items() if first > year})


def form_of(category: str, gone: frozenset[str]) -> str | None:
    """What was called the same in a time that does not have a thing: a television of 1962; None where nothing was."""
    rows: Mapping[str, list[str]] = data_of("since.yaml")["forms"]
    return next((c for c in rows.get(category, ()) if c not in gone), None) if category in gone else None


def stand_in(names: Iterable[str], banned: frozenset[str]) -> tuple[str, ...]:
    """What does the work of some things in a room that may not have them; nothing where there is no such thing.

    Args:
        names: categories, the usual one first.
        banned: what the room does not have.
    """
    rows: Mapping[str, list[str]] = data_of("since.yaml")["instead"]
    found: list[str] = []
    for name in names:
        found += [other for other in rows.get(name, ()) if other not in banned]
    return tuple(dict.fromkeys(found))
