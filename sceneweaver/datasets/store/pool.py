"""Drawings that the scenes of a data set choose from: few enough that they recur, and all else of them is made once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, lru_cache

from sceneweaver.assets import Asset, Library, categories
from sceneweaver.assets.looks import read_words
from sceneweaver.assets.materials import STYLES, own_look
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.sources import Card, ParametricSource
from sceneweaver.assets.sources.base import Wish
from sceneweaver.assets.sources.parametric import keep_drawings
from sceneweaver.assets.taxonomy import resolve

SUITES = 4
"""Designs of fronts, handles and worktops."""

RATIOS = {"surface": (1.25, 1.25), "wall": (1.2, 1.2), "floor": (1.15, 1.03), "ceiling": (1.15, 1.03)}
"""About how much larger a size of a category is than the next smaller one, by what holds it: depth and width; height.

Heights of furniture are fine: a seat goes under a table, a lamp hangs close above it.
"""

FINE_RATIO = 1.1
"""How much larger a size of what has to reach exactly so far is than the next smaller one, in depth and width."""

MEMORY = 384 * 2**20
"""Drawings that a process keeps [bytes]."""

CHOICES = 2**15
"""Wishes of which a process remembers what was chosen."""

Size = tuple[float | None, float | None, float | None]


class PooledSource(ParametricSource):
    """Draws a category in few variants and sizes, as a shop has them.

    Sizes become smaller, never larger, so that what fits still fits. Those that words ask for, and those of fitted
    pieces such as kitchen units, stay exact.

    Args:
        variants: Drawings of a category in one size and look.
    """

    def __init__(self, variants: int):
        self.variants = variants
        keep_drawings(MEMORY)

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """As `ParametricSource.find`, of the pool."""
        body = resolve(category, wish.mount).body
        pooled = replace(
            wish,
            size=wish.size if _is_fitted(body, wish) else offered(body, wish.size),
            palette=_pooled_palette(body, wish.palette),
            style=wish.style if _shows_style(body, wish) else None,
            suite=None if wish.suite is None else wish.suite % SUITES,
            count=1,
        )
        for k in range(wish.count):
            yield from super().find(category, replace(pooled, seed=(wish.seed + k) % self.variants))


class PooledLibrary(Library):
    """A library of a pool, whose things are of the style that they are chosen for where they look alike in all."""

    def __init__(self, source: PooledSource):
        super().__init__([source])
        self._variants = source.variants
        self._first = lru_cache(maxsize=CHOICES)(self._first_choice)

    def __reduce__(self) -> tuple[Callable[[int], Library], tuple[int]]:
        """Another process takes its own, of as many variants."""
        return dataset_library, (self._variants,)

    def choose(self, noun: str, count: int = 1, wish: Wish | None = None, same: bool = True) -> list[Asset]:
        """As `Library.choose`; what is drawn once for all styles says the wanted one of itself."""
        if same:
            made = [self.load(self._first(noun, wish or Wish()))] * count
        else:
            made = super().choose(noun, count, wish, same)
        style = None if wish is None else wish.style or read_words(wish.words).style
        return [asset.of_style(style) for asset in made] if style in STYLES else made

    def _first_choice(self, noun: str, wish: Wish) -> str:
        """The id of what suits a wish best: a pool always has the same for it."""
        return super().choose(noun, 1, wish)[0].id


@cache
def dataset_library(variants: int) -> Library:
    """The library that the scenes of a data set draw on; nothing of this user's own is in it. A process has one.

    Args:
        variants: Drawings of a category in one size and look.
    """
    return PooledLibrary(PooledSource(variants))


def _is_fitted(category: str, wish: Wish) -> bool:
    in_a_row = wish.suite is not None and not has_role(category, "suite_match")
    return wish.beyond or in_a_row or has_role(category, "window_cover")


def _shows_style(category: str, wish: Wish) -> bool:
    """Whether a drawing depends on the style: by its form, or by finishes that are asked for and not the palette's."""
    if has_role(category, "drawn_by_style") or wish.color is not None or wish.material is not None:
        return True
    return wish.palette is None and category not in own_look()


def offered(category: str, size: Size) -> Size:
    """The largest size [m] that a category comes in that is above none of the wanted extents.

    None stays None; what is less than usual becomes the least usual; what is as deep as wide is so in all its sizes.
    """
    found = [None if extent is None else _floor(extent, sizes_of(category, k)) for k, extent in enumerate(size)]
    depth, width, height = found
    if depth is not None and width is not None and sizes_of(category, 0) == sizes_of(category, 1):
        depth = width = min(depth, width)
    return depth, width, height


def _floor(extent: float, sizes: tuple[float, ...]) -> float:
    return max((one for one in sizes if one <= extent + 1e-6), default=sizes[0])


def ratio_of(category: str, axis: int) -> float:
    """About how much larger a size of a category is along an axis (depth, width, height) than the next smaller one."""
    if axis < 2 and has_role(category, "fine_sized"):
        return FINE_RATIO
    return RATIOS[categories()[category].mount[0]][axis == 2]


@cache
def sizes_of(category: str, axis: int) -> tuple[float, ...]:
    """The extents [m] along an axis (depth, width, height) that a category comes in, over its usual range."""
    known = categories()[category]
    if known.size is None:
        raise ValueError(f"{category} is a group of others")
    low, high = known.size.ranges[axis]
    steps = round(math.log(high / low) / math.log(ratio_of(category, axis)))
    between = (low * (high / low) ** (k / steps) for k in range(1, steps))
    return tuple(sorted({low, *(max(low, _round(extent, fine=axis == 2)) for extent in between), high}))


def _round(extent: float, fine: bool) -> float:
    """A number as makers like them [m]: 1.4 rather than 1.407."""
    unit = 0.05 if extent >= 0.5 and not fine else 0.01 if extent >= 0.1 else 0.001
    return round(math.floor(extent / unit + 1e-6) * unit, 3)


def _pooled_palette(category: str, code: str | None) -> str | None:
    """The palette without its seed; None for what follows none."""
    if code is None or category in own_look():
        return None
    return code.rpartition("/")[0] + "/0"
