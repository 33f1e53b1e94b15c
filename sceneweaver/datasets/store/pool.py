"""Drawings that the scenes of a data set choose from: few enough that they recur, and all else of them is made once."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from sceneweaver.assets import Library
from sceneweaver.assets.materials import own_look
from sceneweaver.assets.sources import Card, ParametricSource
from sceneweaver.assets.sources.base import Wish
from sceneweaver.assets.taxonomy import resolve

LOOKS = 2
"""Ways in which the furniture of a palette follows it."""

SUITES = 4
"""Designs of fronts, handles and worktops."""

GRID = ((0.4, 0.02), (2.0, 0.05), (math.inf, 0.1))
"""Steps of depths and widths [m] up to a length [m]; what is asked in words may differ by 15 %."""

HEIGHTS = 0.02
"""Steps of heights [m]: a seat goes under a table."""

FITTED = frozenset(("curtain", "sheer_curtain", "window_blind"))
"""What is as wide as something else: it keeps its size."""


class PooledSource(ParametricSource):
    """Draws a category in few variants and on a grid of sizes.

    Sizes become smaller, never larger, so that what fits still fits. Those that words ask for, and those of fitted
    pieces such as kitchen units, stay exact.

    Args:
        variants: Drawings of a category in one size and look.
    """

    def __init__(self, variants: int):
        self.variants = variants

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """As `ParametricSource.find`, of the pool."""
        size = wish.size if _is_fitted(category, wish) else _snapped(wish.size)
        pooled = replace(
            wish,
            size=size,
            palette=_pooled_palette(category, wish.palette),
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


def _snapped(size: tuple[float | None, float | None, float | None]) -> tuple[float | None, float | None, float | None]:
    depth, width, height = size
    return _plan_step(depth), _plan_step(width), _floor(height, HEIGHTS)


def _plan_step(extent: float | None) -> float | None:
    return None if extent is None else _floor(extent, next(step for most, step in GRID if extent < most))


def _floor(extent: float | None, step: float) -> float | None:
    """The next lower multiple; thin things stay as they are."""
    if extent is None or extent < 5 * step:
        return extent
    return round(math.floor(extent / step + 1e-6) * step, 3)


def _pooled_palette(category: str, code: str | None) -> str | None:
    """The palette with one of few seeds; None for what follows none."""
    if code is None or resolve(category).body in own_look():
        return None
    colors, _, seed = code.rpartition("/")
    return f"{colors}/{int(seed) % LOOKS}"
