"""The room that a category needs on the sides from which it is used."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from typing import Any

from sceneweaver.scene import Zone

from .category import Category

ZONE_HEIGHT = 1.8
"""Height [m] of access zones: a person."""

HEAD = 0.6
"""Length [m] beside the head of a bed that needs no way: a nightstand with a lamp stands there."""

STEP = 0.03
"""Height [m] at which access zones begin: mats and thresholds are stepped on."""


def access_zones(category: Category, size: tuple[float, ...], but: Container[str] = ()) -> tuple[Zone, ...]:
    """One hard zone for each side with a clearance, except the sides in ``but``; ``size`` is (depth, width, height).

    Those of what hangs on walls reach down to the floor: who uses a board stands before it.
    """
    head = HEAD if category.parent == "bed_group" else 0.0
    low = hung_at(category)
    return tuple(_zone(side, depth, size, head, low) for side, depth in category.clearance.items() if side not in but)


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
