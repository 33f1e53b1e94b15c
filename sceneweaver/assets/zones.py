"""The room that a category needs on the sides from which it is used."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from sceneweaver.scene import Zone

from .body import Hull, Link
from .category import Category

ZONE_HEIGHT = 1.8
"""Height [m] of access zones: a person."""

HEAD = 0.6
"""Length [m] beside the head of a bed that needs no way: a nightstand with a lamp stands there."""

STEP = 0.03
"""Height [m] at which access zones begin: mats and thresholds are stepped on."""

OPENING_ROLES = frozenset(("door", "drawer", "lid"))
"""Roles of links whose way is kept free."""

_POSITIONS = 10  # of a link that are looked at from closed to open
_LITTLE = 0.03  # [m] by which something may open beyond its box and its zones


def access_zones(category: Category, size: tuple[float, ...], but: Container[str] = ()) -> tuple[Zone, ...]:
    """One hard zone for each side with a clearance, except the sides in ``but``; ``size`` is (depth, width, height).

    Those of what hangs on walls reach down to the floor: who uses a board stands before it.
    """
    head = HEAD if category.parent == "bed_group" else 0.0
    low = hung_at(category)
    return tuple(_zone(side, depth, size, head, low) for side, depth in category.clearance.items() if side not in but)


def opening_zones(
    hulls: Sequence[Hull], links: Sequence[Link], zones: Sequence[Zone], size: tuple[float, ...], *, laden: bool
) -> tuple[Zone, ...]:
    """Hard zones for what doors, drawers and lids sweep before and above a piece, where its ``zones`` do not have it.

    One before it and one above, each as high and as wide as the links that need it, and no wider than the piece: so
    neighbours in a row are in no one's way. None is above what is ``laden``: things that stand there have to be taken
    off anyway.
    """
    d, w, h = size
    front: list[np.ndarray] = []
    top: list[np.ndarray] = []
    for number, link in enumerate(links, start=1):
        points = [hull.vertices for hull in hulls if hull.link == number]
        if link.role not in OPENING_ROLES or link.joint == "free" or not points:
            continue
        low, high = _swept(link, np.concatenate(points))
        low[1], high[1] = np.clip((low[1], high[1]), -w / 2, w / 2)
        if high[0] > d / 2 + _LITTLE and not _kept_free(zones, d / 2, low, high):
            front.append(np.stack([low, high]))
        if high[2] > h + _LITTLE and not laden:
            top.append(np.stack([low, high]))
    found = []
    if front:
        low, high = np.min([b[0] for b in front], axis=0), np.max([b[1] for b in front], axis=0)
        found.append(_box_zone("opening", (d / 2, high[0]), (low[1], high[1]), (max(low[2], STEP), high[2])))
    if top:
        low, high = np.min([b[0] for b in top], axis=0), np.max([b[1] for b in top], axis=0)
        x = np.clip((low[0], high[0]), -d / 2, d / 2)
        found.append(_box_zone("opening-top", x, (low[1], high[1]), (h, high[2])))
    return tuple(found)


def _swept(link: Link, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner [3] of the box of points [N, 3] of a link on its way."""
    from scipy.spatial.transform import Rotation

    low, high = link.limits
    ways, axis = np.linspace(0.0, high if abs(high) >= abs(low) else low, _POSITIONS), np.array(link.axis)
    if link.joint == "slide":
        path = points + ways[:, None, None] * axis
    else:
        turns = Rotation.from_rotvec(ways[:, None] * axis).as_matrix()
        path = (points - link.anchor) @ turns.transpose(0, 2, 1) + link.anchor
    return path.min(axis=(0, 1)), path.max(axis=(0, 1))


def _kept_free(zones: Sequence[Zone], front: float, low: np.ndarray, high: np.ndarray) -> bool:
    """Whether a hard zone has all of a swept box that is before the front [m]."""
    for zone in zones:
        xy = np.array(zone.polygon)
        (x0, y0), (x1, y1) = xy.min(axis=0) - _LITTLE, xy.max(axis=0) + _LITTLE
        top = min(high[2], ZONE_HEIGHT)  # nothing stands above that and not in the zone
        tall = zone.z[0] - STEP < low[2] + _LITTLE and zone.z[1] > top - _LITTLE
        if zone.hard and x0 <= front and x1 >= high[0] and y0 <= low[1] and y1 >= high[1] and tall:
            return True
    return False


def _box_zone(name: str, x: Any, y: Any, z: Any) -> Zone:
    (x0, x1), (y0, y1), (z0, z1) = ((round(float(a), 4), round(float(b), 4)) for a, b in (x, y, z))
    return Zone(name=name, polygon=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), z=(z0, z1), hard=True)


def cleared(zones: Iterable[Zone], clear: Mapping[Any, float], size: tuple[float, ...], low: float) -> tuple[Zone, ...]:
    """Zones with other depths [m] for some sides, 0: none; ``low`` is the height [m] at which the thing hangs."""
    kept = [zone for zone in zones if zone.name not in clear]
    return (*kept, *(_zone(side, depth, size, 0.0, low) for side, depth in clear.items() if depth > 0.0))


def hung_at(category: Category) -> float:
    """The least height [m] at which things of a category hang on a wall; 0 for what stands."""
    return category.bottom[0] if category.bottom is not None and category.mount[0] == "wall" else 0.0


def _zone(side: str, depth: float, size: tuple[float, ...], head: float, low: float) -> Zone:
    """``head`` metres at the back of the left and right side are left out."""
    d, w, h = size
    boxes = {
        "front": ((d / 2, d / 2 + depth), (-w / 2, w / 2)),
        "back": ((-d / 2 - depth, -d / 2), (-w / 2, w / 2)),
        "left": ((-d / 2 + head, d / 2), (w / 2, w / 2 + depth)),
        "right": ((-d / 2 + head, d / 2), (-w / 2 - depth, -w / 2)),
        "top": ((-d / 2, d / 2), (-w / 2, w / 2)),
    }
    (x0, x1), (y0, y1) = boxes[side]
    z = (h, h + depth) if side == "top" else (STEP - low, ZONE_HEIGHT - low)
    return Zone(name=side, polygon=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), z=z, hard=True)
