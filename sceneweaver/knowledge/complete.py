"""What makes a kind of room complete: ``complete.yaml``."""

from __future__ import annotations

from functools import cache

from pydantic import Field

from sceneweaver.assets import categories
from sceneweaver.scene.base import FrozenModel

from .load import check_known, data_of, room_types


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
    rows = tuple(Expected(**row) for row in data_of("complete.yaml"))
    check_known("complete.yaml", (room for row in rows for room in row.rooms), room_types(), "kind of room")
    check_known("complete.yaml", (name for row in rows for name in row.what | row.where), categories())
    return rows
