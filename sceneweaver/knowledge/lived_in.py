"""What lies on the floor beside furniture in a room that is lived in: ``lived_in.yaml``."""

from __future__ import annotations

from functools import cache
from importlib import resources
from typing import Literal

from pydantic import Field, field_validator

from sceneweaver.assets import categories
from sceneweaver.scene.base import FrozenModel

from .load import read_yaml
from .model import Range
from .small_things import rooms_named

CLUTTER = 0.4
"""How lived-in a room is by default: from 0, a show room, to 1."""

Side = Literal["front", "back", "left", "right"]


class Trace(FrozenModel):
    """One kind of trace that people leave in a room."""

    what: tuple[str, ...] = Field(description="Things, one of which is drawn")
    beside: tuple[str, ...] = Field(description="Categories or groups of furniture that they lie beside, or door")
    sides: tuple[Side, ...] = ("front",)
    rooms: tuple[str, ...] = Field(default=(), description="Kinds of rooms; none: all")
    clutter: float = Field(ge=0, le=1, description="Clutter from which on there are such traces")
    chance: float = Field(default=1.0, ge=0, le=1)
    count: int = Field(default=1, ge=1)
    gap: Range = (0.03, 0.2)
    turn: float = Field(default=20.0, description="Most the yaw strays at full clutter [degrees]")

    @field_validator("what")
    @classmethod
    def _on_floor(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        for name in value:
            if name not in categories():
                raise ValueError(f"{name} is no category")
        return value

    @field_validator("rooms")
    @classmethod
    def _named(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(sorted(rooms_named(value)))


@cache
def traces() -> tuple[Trace, ...]:
    """All traces, in the order of the file."""
    data = read_yaml(resources.files(__package__ or "").joinpath("lived_in.yaml").read_text(encoding="utf-8"))
    return tuple(Trace(**row) for row in data)


@cache
def left_about(category: str, room: str) -> bool:
    """Whether people leave such a thing on the floor of a kind of room."""
    return any(category in t.what and (not t.rooms or room in t.rooms) for t in traces())
