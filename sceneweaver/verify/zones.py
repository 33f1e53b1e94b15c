"""Space that must stay free: the hard zones of objects, and the clear spaces before doors and windows.

A part counts when it reaches more than 1 mm into the zone's height, covers more than 1e-4 m2 of it and is more than
5 mm deep in the plane. Objects that a relation ties (``ties_zones`` in the catalogue) may stand in each other's zones,
whether the relation is hard or soft.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sceneweaver.scene.catalogue import CATALOGUE
from sceneweaver.verify.measure import at_most, length
from sceneweaver.verify.overlap import ZONE_AREA, ZONE_DEPTH, overlaps
from sceneweaver.verify.report import Violation
from sceneweaver.verify.solids import Placed, Prisms


def find(placed: Placed, warnings: list[str]) -> list[Violation]:
    """Each (object, hard zone, other object) that is blocked, once, then each (opening, object).

    Objects that hang on a wall are in the way of no opening. What was not counted is said in ``warnings``.
    """
    found = []
    for owner, zone, other, depth in _blocked(placed, placed.zones, _tied(placed), warnings):
        first, second = placed.bodies[owner].id, placed.bodies[other].id
        detail = f"{second} stands {length(depth)} inside the zone {zone!r} of {first}"
        measured = at_most("depth in the zone", depth, 0.0, slack=ZONE_DEPTH)
        found.append(Violation.of("blocked_zone", (first, second), detail, measured, zone=zone))
    hanging = np.array([body.item.mount == "wall" for body in placed.bodies], dtype=bool)
    skip = np.broadcast_to(hanging, (len(placed.openings), len(hanging)))
    for _, opening, other, depth in _blocked(placed, placed.opening_zones, skip, warnings):
        name = placed.bodies[other].id
        detail = f"{name} stands {length(depth)} inside the clear space of {opening}"
        measured = at_most("depth in the clear space", depth, 0.0, slack=ZONE_DEPTH)
        found.append(Violation.of("blocked_opening", (name, opening), detail, measured))
    return found


def _tied(placed: Placed) -> np.ndarray:
    skip = np.eye(len(placed.bodies), dtype=bool)
    for relation in placed.scene.relations:
        if isinstance(relation.target, str) and CATALOGUE[relation.type].ties_zones:
            a, b = placed.by_id.get(relation.subject), placed.by_id.get(relation.target)
            if a is not None and b is not None:
                skip[a.index, b.index] = skip[b.index, a.index] = True
    return skip


def _blocked(
    placed: Placed, zones: Prisms, skip: np.ndarray, warnings: list[str]
) -> Iterator[tuple[int, str, int, float]]:
    """Owner and name of each zone, the object in it, and how deep [m]; ``skip`` [owners, objects] do not count."""
    pairs = overlaps(zones, placed.parts, skip=skip, depth=ZONE_DEPTH)
    if pairs.cut:
        warnings.append(f"over {len(pairs)} parts are in zones; no more of them were counted")
    deepest: dict[tuple[int, str, int], float] = {}
    for k in np.flatnonzero(pairs.area > ZONE_AREA):
        row = int(pairs.i[k])
        key = (int(zones.owner[row]), zones.names[row], int(placed.parts.owner[pairs.j[k]]))
        deepest[key] = max(deepest.get(key, 0.0), float(pairs.depth[k]))
    yield from ((*key, depth) for key, depth in sorted(deepest.items()))
