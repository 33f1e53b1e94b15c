"""What small objects share: open and closed vessels with what is in them, boxes that things are put into, finishes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...drawing import PROUD, Box, Drawing, Look

OPEN = "open"
"""The shape asked of a box that things are put into: without a lid, with a surface inside."""

BARE = "bare"
"""The shape asked of what others hang from: without what usually hangs there."""

CERAMICS = "white ceramic, cream ceramic, blue ceramic, grey ceramic, terracotta"
PLASTICS = "white plastic, pink plastic, mint plastic, lilac plastic, blue plastic, clear plastic, orange plastic"
CLOTHS = "navy fabric, grey fabric, charcoal fabric, green fabric, mustard fabric, rust fabric, red fabric, blue fabric"

GOLDEN = 2.39996
"""The angle [rad] by which each of many things turns on from the one before, as seeds in a sunflower do."""

Profile = Sequence[tuple[float, float]]
"""(radius, height) from bottom to top, as shares of a box: see `Drawing.turned`."""


def stretch_of(profile: Profile, low: float, high: float, less: float = 0.0) -> list[tuple[float, float]]:
    """A rising profile between two heights, its radii smaller by a share."""
    radii, heights = [p[0] for p in profile], [p[1] for p in profile]
    levels = [low, *[z for z in heights if low < z < high], high]
    return [(max(0.0, float(np.interp(z, heights, radii)) - less), z) for z in levels]


def wrap(d: Drawing, box: Box, profile: Profile, low: float, high: float, look: Look, layer: int = 0) -> None:
    """A printed label around a turned body between two heights [shares]; a higher ``layer`` lies on a lower one."""
    proud = PROUD + 0.00005 * layer
    with d.no_colliders():
        d.turned(box.inset(x=-proud, y=-proud), stretch_of(profile, low, high), look)


def filling(d: Drawing, box: Box, profile: Profile, low: float, high: float, look: Look, wall: float = 0.003) -> None:
    """What fills a vessel between two heights [shares], inside of its wall [m]."""
    with d.no_colliders():
        d.turned(box, stretch_of(profile, low, high, 2 * wall / box.width), look)


def open_vessel(
    d: Drawing,
    box: Box,
    profile: Profile,
    look: Look,
    wall: float = 0.003,
    floor: float = 0.08,
    drink: Look | None = None,
    level: float = 0.7,
    staves: int = 0,
    holds: bool = True,
) -> None:
    """A turned vessel that is open above.

    Args:
        d: The drawing.
        box: What it fills.
        profile: Its outside.
        look: What it is of.
        wall: Its thickness [m].
        floor: Height of the floor inside, as a share.
        drink: What is in it, if anything.
        level: How high that stands, as a share.
        staves: Of how many parts its wall is at least, however shallow it is.
        holds: Whether there is room in it; else it is full of what is drawn in it.
    """
    inner = stretch_of(profile, floor, profile[-1][1], 2 * wall / box.width)
    d.turned(box, [*profile, *inner[::-1], (0.0, floor)], look, hollow=True, holds=holds, staves=staves)
    if drink is not None:
        filling(d, box, profile, floor + 0.002, level, drink, 1.1 * wall)


def pump(d: Drawing, neck: float, top: float, reach: float, look: Look) -> None:
    """A pump on a bottle's neck at a height, up to another, its spout to the front."""
    collar = Box.sized(0.032, 0.032, top - neck, (0.0, 0.0, neck))
    d.turned(collar, [(1.0, 0.0), (1.0, 0.2), (0.38, 0.2), (0.38, 0.72), (0.82, 0.72), (0.76, 1.0)], look, 16)
    spout = ((0.0, 0.006, 0.012, 0.002), (reach, 0.004, 0.014, 0.006))
    d.hull([(x, s * y, top - z) for x, y, *levels in spout for s in (-1, 1) for z in levels], look)


def spread(count: int, radius: float) -> list[tuple[float, float]]:
    """So many places spread evenly over a disc about the frame's origin, from its middle outward."""
    steps = [(GOLDEN * k, radius * ((k + 0.5) / count) ** 0.5) for k in range(count)]
    return [(q * np.cos(a), q * np.sin(a)) for a, q in steps]
