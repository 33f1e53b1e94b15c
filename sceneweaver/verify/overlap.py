"""Which prisms overlap and how deeply: a broad phase by bounding boxes, then exact arithmetic on all pairs at once.

Depth in the plane is the least translation along an edge normal of either polygon (separating axis theorem; exact for
convex polygons); depth of two upright prisms is the smaller of that and their overlap in z.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.verify.solids import DEPTH, Array, Prisms

ZONE_DEPTH = 5e-3
"""Depth in metres up to which a solid may reach into a zone."""

MOST_PAIRS = 20_000
"""Pairs that are found at most: what is wrong with a heap is clear by then."""

CHUNK = 64
"""Prisms that are looked up at a time, between two looks at the clock: a heap of objects does not fill the memory."""

ZONE_AREA = 1e-4
"""Area in square metres up to which a solid may cover a zone."""


@dataclass(frozen=True, eq=False)
class Overlaps:
    """Pairs of row ``i`` of one set and ``j`` of the other: ``depth`` in the plane, ``rise`` in z [m], ``area``.

    ``cut``: there may be more than the `MOST_PAIRS` that were found.
    """

    i: NDArray[np.intp]
    j: NDArray[np.intp]
    depth: Array
    rise: Array
    area: Array
    cut: bool = False

    def __len__(self) -> int:
        return len(self.i)


def _reach(a: Prisms, b: Prisms, i: NDArray[np.intp], j: NDArray[np.intp]) -> Array:
    """Least translation of pairs (i, j) along the edge normals of ``a`` [m]."""
    normals, real = a.normals
    other = np.einsum("pvd,pad->pav", b.xy[j], normals[i])
    low, high = a.spans
    reach = np.minimum(high[i] - other.min(axis=2), other.max(axis=2) - low[i])
    reach[~real[i]] = np.inf
    return reach.min(axis=1)


def overlaps(a: Prisms, b: Prisms, *, skip: NDArray[np.bool_] | None = None, depth: float = DEPTH) -> Overlaps:
    """Return the pairs of ``a`` x ``b`` that overlap by more than ``depth`` in the plane and `DEPTH` in z.

    With ``a is b`` each pair is listed once and pairs of one owner are left out. ``skip`` [owners of a, owners of b]
    masks out pairs by their owners. Of more than `MOST_PAIRS` the first of them are found.
    """
    import shapely

    none = np.empty(0, dtype=np.intp)
    found, count = [Overlaps(none, none, np.empty(0), np.empty(0), np.empty(0))], 0
    if not len(a) or not len(b):
        return found[0]
    tree, boxes = shapely.STRtree(shapely.box(*b.boxes.T)), shapely.box(*a.boxes.T)
    for start in range(0, len(boxes), CHUNK):
        checkpoint()
        i, j = tree.query(boxes[start : start + CHUNK])
        some = _of_boxes(a, b, i + start, j, skip, depth)
        found.append(some)
        count += len(some)
        if count > MOST_PAIRS:
            break
    columns = (np.concatenate([getattr(some, name) for some in found]) for name in ("i", "j", "depth", "rise", "area"))
    return Overlaps(*(column[:MOST_PAIRS] for column in columns), cut=count > MOST_PAIRS)


def _of_boxes(
    a: Prisms, b: Prisms, i: NDArray[np.intp], j: NDArray[np.intp], skip: NDArray[np.bool_] | None, depth: float
) -> Overlaps:
    """Those of the pairs (i, j), whose bounding boxes meet, that overlap."""
    import shapely

    rise = np.minimum(a.z[i, 1], b.z[j, 1]) - np.maximum(a.z[i, 0], b.z[j, 0])
    keep = rise > DEPTH
    if a is b:
        keep &= (i < j) & (a.owner[i] != b.owner[j])
    if skip is not None:
        keep &= ~skip[a.owner[i], b.owner[j]]
    i, j, rise = i[keep], j[keep], rise[keep]
    sunk = np.minimum(_reach(a, b, i, j), _reach(b, a, j, i)) if len(i) else np.empty(0)
    keep = sunk > depth
    i, j, rise, sunk = i[keep], j[keep], rise[keep], sunk[keep]
    area = shapely.area(shapely.intersection(a.polygons[i], b.polygons[j])) if len(i) else np.empty(0)
    return Overlaps(i, j, sunk, rise, area)
