"""Space that must stay free: the hard zones of objects, and the clear spaces before doors and windows.

A part counts when it reaches more than 1 mm into the zone's height, covers more than 1e-4 m2 of it and is more than
5 mm deep in the plane. Objects that a relation ties (``ties_zones`` in the catalogue) may stand in each other's zones,
whether the relation is hard or soft.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sceneweaver.scene.catalogue import CATALOGUE
from sceneweaver.verify.overlap import ZONE_AREA, ZONE_DEPTH, Overlaps, overlaps
from sceneweaver.verify.solids import Placed, Prisms


class Blocked(NamedTuple):
    """Object ``other`` stands ``depth`` metres inside zone ``name`` of ``owner`` (an object, or an opening's index)."""

    owner: int
    name: str
    other: int
    depth: float


def find(placed: Placed) -> list[Blocked]:
    """Return each (object, hard zone, other object) that is blocked, once."""
    if not len(placed.zones):
        return []
    pairs = overlaps(placed.zones, placed.parts, skip=_tied(placed), depth=ZONE_DEPTH)
    return _worst(placed.zones, placed, pairs)


def find_openings(placed: Placed) -> list[Blocked]:
    """Return each (opening, object) that is blocked, once; ``owner`` is the index in `Placed.openings`.

    Objects that hang on a wall are exempt.
    """
    if not placed.openings or not placed.bodies:
        return []
    hanging = np.array([body.item.mount == "wall" for body in placed.bodies])
    skip = np.broadcast_to(hanging, (len(placed.openings), len(hanging)))
    pairs = overlaps(placed.opening_zones, placed.parts, skip=skip, depth=ZONE_DEPTH)
    return _worst(placed.opening_zones, placed, pairs)


def _tied(placed: Placed) -> np.ndarray:
    skip = np.eye(len(placed.bodies), dtype=bool)
    for relation in placed.scene.relations:
        if isinstance(relation.target, str) and CATALOGUE[relation.type].ties_zones:
            a, b = placed.by_id.get(relation.subject), placed.by_id.get(relation.target)
            if a is not None and b is not None:
                skip[a.index, b.index] = skip[b.index, a.index] = True
    return skip


def _worst(zones: Prisms, placed: Placed, pairs: Overlaps) -> list[Blocked]:
    deepest: dict[tuple[int, str, int], float] = {}
    for k in np.flatnonzero(pairs.area > ZONE_AREA):
        row = int(pairs.i[k])
        key = (int(zones.owner[row]), zones.names[row], int(placed.parts.owner[pairs.j[k]]))
        deepest[key] = max(deepest.get(key, 0.0), float(pairs.depth[k]))
    return [Blocked(*key, depth) for key, depth in sorted(deepest.items())]
