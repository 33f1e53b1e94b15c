"""Which function draws which category."""

from __future__ import annotations

from collections.abc import Callable

from .drawing import Drawing

Maker = Callable[[Drawing], None]

MAKERS: dict[str, Maker] = {}
"""The functions by category; complete when all modules of ``families`` have been imported."""


def draws(*names: str) -> Callable[[Maker], Maker]:
    """Register a function that draws these categories with a builder."""

    def register(maker: Maker) -> Maker:
        for name in names:
            if name in MAKERS:
                raise ValueError(f"two functions draw {name}")
            MAKERS[name] = maker
        return maker

    return register
