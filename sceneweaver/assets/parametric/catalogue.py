"""``make`` draws one asset, by the function that its category is registered with."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from sceneweaver.scene import InputError
from sceneweaver.scene.messages import suggest

from ..asset import Asset
from ..category import categories
from ..drawing import MAKERS, Drawing, Maker, Request, asset_of
from ..mirror import mirrored
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
    known = makers()
    if category not in known:
        raise InputError(f"category: '{category}' is unknown{suggest(category, known)}")
    drawing = Drawing(categories()[category], seed, request)
    known[category](drawing)
    if drawing.lacks_material:  # its colour waited for it
        drawing = Drawing(categories()[category], seed, request, any_material=True)
        known[category](drawing)
    asset = asset_of(drawing)
    return mirrored(asset) if drawing.request.mirrored else asset
