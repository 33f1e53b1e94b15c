"""What makes a kind of room complete: ``complete.yaml``."""

from __future__ import annotations

from functools import cache
from importlib import resources

from pydantic import Field

from sceneweaver.assets import categories
from sceneweaver.scene.base import FrozenModel

from .load import read_yaml, room_types


class Expected(FrozenModel):
    """Something that people look for in a kind of room."""

    rooms: frozenset[str]
    what: frozenset[str] = Field(description="Categories of which any will do")
    why: str = Field(description="What is missed, in words")
    count: int = Field(default=1, ge=1)
    where: frozenset[str] = Field(default=frozenset(), description="Asked only beside one of these; empty: always")


@cache
def expected_of(room: str) -> tuple[Expected, ...]:
    """What people look for in a kind of room."""
    return tuple(row for row in _rows() if room in row.rooms)


@cache
def _rows() -> tuple[Expected, ...]:
    """All rows; ValueError where one names a room or category that is unknown."""
    data = read_yaml(resources.files(__package__ or "").joinpath("complete.yaml").read_text(encoding="utf-8"))
    rows = tuple(Expected(**row) for row in data)
    unknown = {room for row in rows for room in row.rooms} - set(room_types())
    unknown |= {name for row in rows for name in row.what | row.where} - set(categories())
    if unknown:
        raise ValueError(f"complete.yaml: {', '.join(sorted(unknown))} is no kind of room or category")
    return rows
