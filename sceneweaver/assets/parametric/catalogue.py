"""``make`` draws one asset, by the function that its category is registered with."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from ..asset import Asset
from ..category import categories
from ..drawing import MAKERS, Drawing, Maker, Request, asset_of
from . import families


@cache
def makers() -> dict[str, Maker]:
    """All categories that have a body, with the function that draws it."""
    for module in iter_modules(families.__path__):
        import_module(f"{families.__name__}.{module.name}")
    return MAKERS


def make(category: str, seed: int = 0, request: Request | None = None) -> Asset:
    """Draw one asset; equal arguments give equal assets.

    What a request asks in vain (a material that the category is never of) is left out.

    Raises:
        InputError: for a category that is not drawn, or a request outside the category's range.
    """
    for any_material in (False, True):
        drawing = draw(category, seed, request, any_material)
        if not drawing.finishes.lacks_material:  # else draw again, as its colour waited for it
            break
    return asset_of(drawing)


def draw(category: str, seed: int, request: Request | None, any_material: bool) -> Drawing:
    """A finished drawing.

    Raises:
        InputError: as of `make`.
    """
    check(category)
    drawing = Drawing(categories()[category], seed, request, any_material=any_material)
    makers()[category](drawing)
    return drawing


def check(category: str) -> None:
    """Raise InputError for a category that is not drawn."""
    known = makers()
    if category not in known:
        raise InputError(f"category: '{category}' is unknown{suggest(category, known)}")
