"""Scenes that are nearly the same: their large furniture stands alike.

Two scenes are near-duplicates when, in frames of their rooms, the extents of the rooms differ by at most 20 cm and the
large furniture can be paired such that the two of each pair are of one category, at most 10 cm and 15 degrees apart,
and differ in depth and width by at most 10 cm.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.cluster.hierarchy import DisjointSet
from scipy.optimize import linear_sum_assignment
from scipy.spatial import KDTree

from .fingerprint import Layout

APART, TURNED = 0.10, math.radians(15.0)
"""How far two things of a pair may be apart [m] and turned against each other [rad]."""

EXTENTS = 2 * APART
"""How much the extents of two rooms may differ [m]: as if each of two opposite walls stood elsewhere."""

CHUNK = 1024
"""Layouts whose neighbours are looked for at once."""


def near_duplicates(a: Layout, b: Layout) -> bool:
    """Whether the large furniture of two rooms stands alike."""
    if a.categories != b.categories:
        return False
    extents, boxes = next(a.views())
    names = np.array(a.categories)
    other_kind = names[:, None] != names[None, :]
    for other_extents, other in b.views():
        if np.abs(extents - other_extents).max() > EXTENTS:
            continue
        apart = np.hypot(*np.moveaxis(boxes[:, None, :2] - other[None, :, :2], -1, 0))
        turned = np.abs((boxes[:, None, 2] - other[None, :, 2] + math.pi) % (2 * math.pi) - math.pi)
        larger = np.abs(boxes[:, None, 3:] - other[None, :, 3:]).max(axis=-1)
        unlike = other_kind | (apart > APART) | (turned > TURNED) | (larger > APART)
        if unlike.all(axis=1).any():
            continue
        rows, columns = linear_sum_assignment(unlike)
        if not unlike[rows, columns].any():
            return True
    return False


def join_near_duplicates(sets: DisjointSet, layouts: Sequence[tuple[int, str, Layout]]) -> None:
    """Join the scenes that are near-duplicates, and those that hang together by others that are.

    Args:
        sets: over all scenes.
        layouts: number, signature and layout of each scene that may be one.
    """
    first: dict[str, int] = {}
    kinds: dict[tuple[str, ...], list[tuple[int, Layout]]] = {}
    for number, signature, layout in layouts:
        if signature in first:  # in the same cells of 5 cm and 15 degrees
            sets.merge(first[signature], number)
        else:
            first[signature] = number
            kinds.setdefault(layout.categories, []).append((number, layout))
    for same in kinds.values():
        _join_neighbours(sets, same)


def smallest(sets: DisjointSet) -> np.ndarray:
    """The smallest number of the set of each of the numbers 0 to N - 1, shape [N]."""
    names = np.empty(len(sets), dtype=np.int64)
    for members in sets.subsets():
        names[list(members)] = min(members)
    return names


def _join_neighbours(sets: DisjointSet, layouts: Sequence[tuple[int, Layout]]) -> None:
    """Join near-duplicates among layouts with the same categories; only near embeddings are compared."""
    if len(layouts) < 2:
        return
    points = np.array([layout.embedding for _, layout in layouts], dtype=float).reshape(len(layouts), -1)
    if not points.shape[1]:  # empty rooms
        points = np.zeros((len(layouts), 1))
    tree = KDTree(points)
    for start in range(0, len(layouts), CHUNK):
        near = tree.query_ball_point(points[start : start + CHUNK], APART + 1e-3, p=math.inf)
        for i, candidates in enumerate(near, start):
            for j in sorted(candidates):
                a, b = layouts[i], layouts[j]
                if i < j and not sets.connected(a[0], b[0]) and near_duplicates(a[1], b[1]):
                    sets.merge(a[0], b[0])
