"""The patterns by name: who draws each, how many metres it covers, and how it lies on a piece."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from .relief import Relief

Kind = Literal["plain", "wood", "fabric", "stone", "metal", "leaf"]

Draw = Callable[[int], Relief]


@dataclass(frozen=True)
class Pattern:
    """A pattern: ``size`` are the metres that its maps cover along u and v, ``pixels`` the side of the maps.

    With ``grain`` u follows the longest way of each piece, as wood grows; else it is level and v is up. ``kind`` is the
    coarse class for those who draw no maps.
    """

    name: str
    size: tuple[float, float]
    draw: Draw
    kind: Kind = "plain"
    grain: bool = False
    pixels: int = 512


ENTRIES: dict[str, Pattern] = {}
"""All patterns whose modules have been imported."""


def pattern(
    name: str,
    size: tuple[float, float],
    *,
    kind: Kind = "plain",
    grain: bool = False,
    pixels: int = 512,
) -> Callable[[Draw], Draw]:
    """Enters the function that draws a pattern, from pixels of the side to its relief."""

    def enter(draw: Draw) -> Draw:
        add(Pattern(name, size, draw, kind, grain, pixels))
        return draw

    return enter


def add(entry: Pattern) -> None:
    """Enter a pattern; ValueError when the name is taken."""
    if entry.name in ENTRIES:
        raise ValueError(f"texture: '{entry.name}' is there already")
    ENTRIES[entry.name] = entry
