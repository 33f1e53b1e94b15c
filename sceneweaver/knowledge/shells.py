"""What shells of rooms are like by group of rooms: shapes, kinds of windows, radiators: ``shells.yaml``."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

from .load import data_of
from .palettes import groups_of


class Windows(FrozenModel):
    """Kinds of windows and how often each is, in the groups that have several."""

    groups: tuple[str, ...]
    kinds: Mapping[str, float]


class Radiators(FrozenModel):
    """What hangs below windows, and in which share of the rooms of some groups."""

    what: str
    share: float = Field(ge=0, le=1)
    groups: tuple[str, ...]


class Shells(FrozenModel):
    """The file; ``least`` is the floor [m2] from which on a room may have a shape."""

    shapes: Mapping[str, Mapping[str, float]]
    least: Mapping[str, float]
    windows: Windows
    radiators: Radiators


@cache
def shells() -> Shells:
    """What the file says."""
    return Shells(**data_of("shells.yaml"))


def first_group(room: str) -> str:
    """The group that decides about the shell of a kind of room."""
    return groups_of(room)[0]
