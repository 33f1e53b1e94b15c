"""Choices of a drawing: sizes, proportions and details, each drawn from the seed by its name."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from functools import cached_property
from typing import TypeVar

import numpy as np

from sceneweaver.scene import InputError

from ..category import Category
from .box import Box
from .request import Request, Size

T = TypeVar("T")


class Choices:
    """What is chosen for one asset: equal category, seed and request give equal choices.

    Choices are drawn by name, so that a new one leaves the others as they were.
    """

    def __init__(self, category: Category, seed: int, request: Request | None = None):
        if category.size is None:
            raise InputError(f"category: '{category.name}' is a group of others; name one of them")
        self.category = category
        self.request = request or Request()
        self.seed = seed

    @cached_property
    def size(self) -> Size:
        """Depth along the front, width, height [m].

        Raises:
            InputError: one is asked for that the category cannot have.
        """
        return self._even(Size(*(self._extent(k) for k in range(3))))

    @property
    def bounds(self) -> Box:
        """The box to fill, standing on z = 0 about the origin."""
        return Box.sized(*self.size)

    def _rng(self, name: str, matched: bool = False) -> np.random.Generator:
        """``matched``: drawn alike by all pieces of a suite, where this is one of a suite."""
        key = [zlib.crc32(self.category.name.encode()), self.seed]
        if matched and self.request.suite is not None:
            key = [zlib.crc32(b"suite"), self.request.suite]
        return np.random.Generator(np.random.PCG64([*key, zlib.crc32(name.encode())]))

    def pick(self, name: str, options: Sequence[T], matched: bool = False) -> T:
        """One of the options; ``matched``: the same for all pieces of a suite."""
        return options[int(self._rng(name, matched).integers(len(options)))]

    def uniform(self, name: str, low: float, high: float) -> float:
        """A number between two others."""
        return float(self._rng(name).uniform(low, high))

    def integer(self, name: str, low: int, high: int) -> int:
        """A whole number from ``low`` to ``high``, both included."""
        return int(self._rng(name).integers(low, high + 1))

    def chance(self, name: str, share: float, matched: bool = False) -> bool:
        """True in that share of the seeds; ``matched``: the same for all pieces of a suite."""
        return bool(self._rng(name, matched).uniform() < share)

    @property
    def in_suite(self) -> bool:
        """Whether it is one of several pieces that match."""
        return self.request.suite is not None

    def _extent(self, axis: int) -> float:
        assert self.category.size is not None
        name = ("depth", "width", "height")[axis]
        low, high = self.category.size.ranges[axis]
        asked = self.request.size[axis]
        if asked is None:
            return low if low == high else round(self.uniform(f"size {name}", low, high), 3)
        least, most = self.category.size.built[axis]
        if not least - 1e-6 <= asked <= most + 1e-6:
            raise InputError(f"size: {self.category.words} has a {name} of {low:g} to {high:g} m, not {asked:g} m")
        return float(asked)

    def _even(self, size: Size) -> Size:
        """The size with two equal sides where a round or square thing was asked for, as near as its ranges allow.

        They are those in plan, or of what hangs on a wall those of its front.
        """
        axes = self.outline_axes
        if self.request.shape not in ("round", "square") or any(self.request.size[k] is not None for k in axes):
            return size
        assert self.category.size is not None
        (a0, a1), (b0, b1) = (self.category.size.ranges[k] for k in axes)
        side = min(max(size[axes[0]], b0), a1) if max(a0, b0) <= min(a1, b1) else min(a1, b1)
        if side < 0.5 * max(a0, b0):  # a square pipe would be another thing
            return size
        return Size(*(side if k in axes else size[k] for k in range(3)))

    @property
    def outline_axes(self) -> tuple[int, int]:
        """The axes of the outline that a shape is said of."""
        return (1, 2) if self.category.mount[0] == "wall" else (0, 1)
