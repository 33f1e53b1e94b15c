"""What hangs on the free walls of a kind of room, and how many of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources

from .load import read_yaml
from .palettes import groups_of


def wall_things(room: str) -> Mapping[str, float]:
    """Categories that hang on free walls of a kind of room, each with how often it is taken."""
    data = _data()
    return data["rooms"].get(room) or data["kinds"][groups_of(room)[0]]


def most_on_walls(category: str) -> int | None:
    """How many of a thing hang in a room at most; None: as many as there is room for."""
    return _data()["most"].get(category)


@cache
def _data() -> Mapping:
    return read_yaml(resources.files(__package__ or "").joinpath("wall_things.yaml").read_text(encoding="utf-8"))
