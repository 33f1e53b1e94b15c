"""Which function draws which category."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Literal

from .drawing import Drawing

Maker = Callable[[Drawing], None]

MAKERS: dict[str, Maker] = {}
"""The functions by category; complete when all modules of ``families`` have been imported."""


def draws(*names: str, whole: bool = False, even: Literal["box", "round", "cube"] = "box") -> Callable[[Maker], Maker]:
    """Register a function that draws these categories.

    Args:
        names: The categories.
        whole: What it draws outside of parts of its own is one part, and all is stretched to its size at the end.
        even: Which sides of that size are equal: see `Drawing.even`.
    """

    def register(maker: Maker) -> Maker:
        @wraps(maker)
        def draw_whole(d: Drawing) -> None:
            with d.part("body"):
                maker(d)
            d.fit(d.even(even).size)

        for name in names:
            if name in MAKERS:
                raise ValueError(f"two functions draw {name}")
            MAKERS[name] = draw_whole if whole else maker
        return maker

    return register
