"""Which function draws which category, and ``make``, which runs it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from sceneweaver.scene import InputError
from sceneweaver.scene.messages import suggest

from ..asset import Asset
from ..category import categories
from .builder import Builder, Request

Maker = Callable[[Builder], None]

_makers: dict[str, Maker] = {}


def draws(*names: str) -> Callable[[Maker], Maker]:
    """Register a function that draws these categories with a builder."""

    def register(maker: Maker) -> Maker:
        for name in names:
            if name in _makers:
                raise ValueError(f"two functions draw {name}")
            _makers[name] = maker
        return maker

    return register


@cache
def makers() -> dict[str, Maker]:
    """All categories that have a body, with the function that draws it."""
    from . import families

    for module in iter_modules(families.__path__):
        import_module(f"{families.__name__}.{module.name}")
    return _makers


def make(category: str, seed: int = 0, request: Request | None = None) -> Asset:
    """Draw one asset; equal arguments give equal assets.

    Raises:
        InputError: for a category that is not drawn, or a request outside the category's range.
    """
    known = makers()
    if category not in known:
        raise InputError(f"category: '{category}' is unknown{suggest(category, known)}")
    builder = Builder(categories()[category], seed, request)
    known[category](builder)
    return builder.finish()
