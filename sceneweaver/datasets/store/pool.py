"""Drawings that the scenes of a data set choose from: few enough that they recur, and all else of them is made once."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from sceneweaver.assets import Library, categories
from sceneweaver.assets.materials import own_look
from sceneweaver.assets.sources import Card, ParametricSource
from sceneweaver.assets.sources.base import Wish
from sceneweaver.assets.sources.parametric import keep_drawings
from sceneweaver.assets.taxonomy import resolve

SUITES = 4
"""Designs of fronts, handles and worktops."""

GRID = ((0.4, 0.02), (2.0, 0.05), (math.inf, 0.1))
"""Steps of depths and widths [m] up to a length [m]; what is asked in words may differ by 15 %."""

HEIGHTS = ((math.inf, 0.02),)
"""Steps of heights [m]: a seat goes under a table."""

HUNG = ((0.4, 0.02), (math.inf, 0.1))
"""Steps of all extents of what hangs on a wall."""

NARROW = 4
"""Steps that the usual range of an extent has at least."""

MEMORY = 384 * 2**20
"""Drawings that a process keeps [bytes]."""

FITTED = frozenset(("curtain", "sheer_curtain", "window_blind"))
"""What is as wide as something else: it keeps its size."""


Size = tuple[float | None, float | None, float | None]
Range = tuple[float, float]
Grid = Sequence[Range]
"""Steps [m], each up to an extent [m]."""


class PooledSource(ParametricSource):
    """Draws a category in few variants and on a grid of sizes.

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
        size = wish.size if _is_fitted(body, wish) else _snapped(body, wish.size)
        pooled = replace(
            wish,
            size=size,
            palette=_pooled_palette(body, wish.palette),
            suite=None if wish.suite is None else wish.suite % SUITES,
            count=1,
        )
        for k in range(wish.count):
            yield from super().find(category, replace(pooled, seed=(wish.seed + k) % self.variants))


def dataset_library(variants: int) -> Library:
    """The library that the scenes of a data set draw on; nothing of this user's own is in it.

    Args:
        variants: Drawings of a category in one size and look.
    """
    return Library([PooledSource(variants)])


def _is_fitted(category: str, wish: Wish) -> bool:
    return wish.beyond or wish.suite is not None or category in FITTED


def _snapped(category: str, size: Size) -> Size:
    known = categories()[category]
    grids = (HUNG, HUNG, HUNG) if known.mount[0] == "wall" else (GRID, GRID, HEIGHTS)
    ranges = known.size.ranges if known.size is not None else ((0.0, math.inf),) * 3
    depth, width, height = (_floor(*row) for row in zip(size, grids, ranges, strict=True))
    return depth, width, height


def _floor(extent: float | None, grid: Grid, usual: Range) -> float | None:
    """The next lower multiple of a step, of the finest one where the usual range is narrow; thin things stay."""
    if extent is None:
        return None
    step = next(step for most, step in grid if extent < most)
    if usual[1] - usual[0] < NARROW * step:
        step = grid[0][1]
    return extent if extent < 5 * step else round(math.floor(extent / step + 1e-6) * step, 3)


def _pooled_palette(category: str, code: str | None) -> str | None:
    """The palette without its seed; None for what follows none."""
    if code is None or category in own_look():
        return None
    return code.rpartition("/")[0] + "/0"
