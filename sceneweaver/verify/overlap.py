"""Which prisms overlap and how deeply: a broad phase by bounding boxes, then exact arithmetic on all pairs at once.

Depth in the plane is the least translation along an edge normal of either polygon (separating axis theorem; exact for
convex polygons); depth of two upright prisms is the smaller of that and their overlap in z.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sceneweaver.io import InputError
from sceneweaver.verify.solids import DEPTH, Array, Prisms

ZONE_DEPTH = 5e-3
"""Depth in metres up to which a solid may reach into a zone."""

MAX_PAIRS = 2_000_000
"""Pairs of bounding boxes that are looked at, both ways round: some 20 s of work."""

CHUNK = 256
"""Boxes that are looked up at a time, so that a heap of objects does not fill the memory before it is counted."""

ZONE_AREA = 1e-4
"""Area in square metres up to which a solid may cover a zone."""


@dataclass(frozen=True, eq=False)
class Overlaps:
    """Pairs of row ``i`` of one set and ``j`` of the other: ``depth`` in the plane, ``rise`` in z [m], ``area``."""

    i: NDArray[np.intp]
    j: NDArray[np.intp]
    depth: Array
    rise: Array
    area: Array

    def __len__(self) -> int:
        return len(self.i)


def _broad(a: Prisms, b: Prisms) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Pairs whose bounding boxes meet; InputError where there are more than `MAX_PAIRS`."""
    import shapely

    tree = shapely.STRtree(shapely.box(*b.boxes.T))
    boxes, found, count = shapely.box(*a.boxes.T), [], 0
    for start in range(0, len(boxes), CHUNK):
        i, j = tree.query(boxes[start : start + CHUNK])
        found.append((i + start, j))
        count += len(i)
        if count > MAX_PAIRS:
            raise InputError(f"objects: over {MAX_PAIRS} pairs of parts or zones overlap; spread the objects out")
    return np.concatenate([i for i, _ in found]), np.concatenate([j for _, j in found])


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
    masks out pairs by their owners.
    """
    import shapely

    if not len(a) or not len(b):
        none = np.empty(0, dtype=np.intp)
        return Overlaps(none, none, np.empty(0), np.empty(0), np.empty(0))
    i, j = _broad(a, b)
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
