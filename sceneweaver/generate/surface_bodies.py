"""Bodies for small things: chosen from the library within given sizes, few of a kind so that it is quick."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, Library, Wish
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.knowledge.model import Range
from sceneweaver.scene import Palette

from .surface_field import Prism, Shape

VARIANTS = 3
"""Different bodies of one kind and size in a call: drawing one takes longer than placing it."""

STEP = 0.04
"""Sizes are asked for in steps [m], so that equal bodies recur."""

Sizes = tuple[Range | None, Range | None, Range | None]
OPEN: Sizes = (None, None, None)


VARIED = ("book", "standing_books", "book_stack", "magazine", "plush_toy", "picture_frame", "cushion", "laptop")
"""What people have many different ones of."""


def _variants(category: str) -> int:
    return 3 * VARIANTS if category in VARIED else VARIANTS


class Shelf:
    """The bodies of one call, drawn once each."""

    def __init__(self, library: Library, palette: Palette | None, seed: int, style: str | None = None):
        """``style`` is for a room without a palette."""
        self._library = library
        self._style = palette.style if palette is not None else style
        self._palette = palette.code if palette is not None else None
        self._room_seed = palette.seed if palette is not None else seed
        self._made: dict[Any, Asset] = {}
        self._shapes: dict[str, Shape] = {}

    def draw(
        self,
        category: str,
        dice: random.Random,
        size: Sizes = OPEN,
        limit: tuple[float, float, float] | None = None,
        look: dict[str, str] | None = None,
    ) -> Asset | None:
        """A body of a category, each extent within its range of ``size`` and, as far as it can be, under ``limit`` [m].

        None when the category's smallest is larger than the limit.
        """
        known = category_named(category, "surface").size
        if known is None:
            return None
        wanted: list[float | None] = []
        for k, usual in enumerate(known.ranges):
            most = usual[1] if limit is None else min(usual[1], limit[k])
            if most < usual[0] - 1e-9:
                return None
            low, high = size[k] or usual
            low, high = min(max(low, usual[0]), most), min(max(high, usual[0]), most)
            if size[k] is None and most == usual[1]:
                wanted.append(None)
                continue
            # what only has to fit is as large as it may be; a size that was given is drawn from its range
            value = most if size[k] is None else low + (high - low) * dice.random()
            wanted.append(max(usual[0], min(most, int(value / STEP + 1e-6) * STEP)))
        variant = dice.randrange(_variants(category))
        key = (category, variant, tuple(wanted), tuple(sorted((look or {}).items())))
        if key not in self._made:
            wish = Wish(
                size=(wanted[0], wanted[1], wanted[2]),
                style=self._style,
                palette=self._palette,
                mount="surface",
                seed=self._room_seed % 1000003 + variant,
                count=1,
            )
            known_look = {k: v for k, v in (look or {}).items() if k in ("color", "material", "style", "words")}
            self._made[key] = self._library.choose(category, 1, replace(wish, **known_look))[0]
        return self._made[key]

    def shared(self, name: str) -> random.Random:
        """A stream of its own for something that is the same wherever it is in the room."""
        return random.Random(f"{self._room_seed}/{name}")

    def shape(self, asset: Asset) -> Shape:
        """What an asset covers where it stands; nothing goes under what juts out."""
        if asset.id not in self._shapes:
            d, w, h = asset.size
            box = np.array([(-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2)])
            prisms = [Prism(counter_clockwise(p.polygon), 0.0, float(p.z[1])) for p in asset.parts]
            self._shapes[asset.id] = Shape(tuple(prisms) or (Prism(box, 0.0, h),), asset.size)
        return self._shapes[asset.id]
