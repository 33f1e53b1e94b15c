"""The patterns of the library, and the names that textures go by."""

from __future__ import annotations

from functools import cache

from . import patterns as _modules  # noqa: F401  (its modules enter their patterns)
from .patterns.two_colors import two_colored
from .registry import ENTRIES, Kind, Pattern

OLD_NAMES = {"wood": "oak", "fabric": "weave", "stone": "granite", "metal": "brushed"}
"""What assets of earlier versions call their textures."""


@cache
def patterns() -> dict[str, Pattern]:
    """All patterns of the library by name."""
    return dict(sorted(ENTRIES.items()))


def found(texture: str) -> Pattern | None:
    """The pattern that a texture's name stands for, or None."""
    return patterns().get(OLD_NAMES.get(texture, texture)) or two_colored(texture)


def kind_of(texture: str) -> Kind:
    """The coarse class of a texture; "plain" for what the library does not know."""
    entry = found(texture)
    return "plain" if entry is None else entry.kind
