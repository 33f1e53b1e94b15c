"""Sizes of objects against the usual ones of their categories."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sceneweaver.assets.category import Sizes
from sceneweaver.assets.taxonomy import category_named, resolve
from sceneweaver.scene import Scene

_ROUNDING = 1e-6


class Sized(NamedTuple):
    """How many objects are of known categories, how many of them of usual size, and the sum of what they are off."""

    known: int
    usual: int
    off: float


def sizes_of(scene: Scene, left_out: Sequence[str] = ()) -> Sized:
    """Compare the objects of a scene, but for some ids, with the ranges of the taxonomy; bodies that merely stand for
    a noun tell nothing."""
    known, usual, off = 0, 0, 0.0
    for obj in scene.objects:
        if obj.id in left_out or resolve(obj.category, obj.mount).generic:
            continue
        size = category_named(obj.category, obj.mount).size
        if size is None:
            continue
        ratios = log_ratios(obj.size, size)
        known += 1
        usual += bool((ratios <= _ROUNDING).all())
        off += float(ratios.mean())
    return Sized(known, usual, off)


def log_ratios(extents: Sequence[float], usual: Sizes) -> np.ndarray:
    """By how much depth, width and height [m] lie outside of their usual ranges, as absolute logarithms [3].

    Examples:
        >>> from sceneweaver.assets import categories
        >>> usual = categories()["bed"].size
        >>> float(log_ratios((2 * usual.depth[1], usual.width[0], usual.height[1]), usual).round(3)[0])
        0.693
    """
    given = np.asarray(extents, dtype=float)
    low, high = np.array(usual.ranges, dtype=float).T
    high[1] = max(high[1], usual.longest or 0.0)  # what is built to the length of its place
    return np.maximum(np.maximum(np.log(low / given), np.log(given / high)), 0.0)
