"""Room inside vessels: jars, stands and tubs whose cavity the drawing knows take what a request puts into them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sceneweaver.assets import Asset, Library, Wish
from sceneweaver.assets.body import Interior
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.scene import InputError, Part, Surface

INSIDE = "inside"
"""The name of the surface within a vessel."""

LEAST = 0.02
"""Least side [m] of a cavity."""

OVAL = 0.7
"""Share of the sides of an oval cavity that a rectangle in it has."""

PARTS = 8
"""Most prisms of one body."""


def hollow(asset: Asset) -> Asset:
    """A vessel with a surface in its cavity, of which its prisms keep clear; as it is where it has no cavity that opens
    to the top."""
    rooms = [room for room in asset.interiors if room.link == 0 and room.entry[2] > 0.9]
    if not rooms or any(surface.name == INSIDE for surface in asset.surfaces):
        return asset
    room = max(rooms, key=_volume)
    share = OVAL if room.oval else 1.0
    low, high = np.array(room.low), np.array(room.high)
    middle, half = (low + high) / 2, share * (high - low) / 2
    x, y = (float(middle[k] - half[k]) for k in (0, 1)), (float(middle[k] + half[k]) for k in (0, 1))
    (x0, y0), (x1, y1) = tuple(x), tuple(y)
    floor = float(low[2])
    if min(x1 - x0, y1 - y0) < LEAST:
        return asset
    parts = [piece for part in asset.parts for piece in _around(part, (x0, y0, x1, y1), floor)]
    if len(parts) > PARTS:
        return asset
    ring = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return replace(asset, parts=tuple(parts), surfaces=(*asset.surfaces, Surface(name=INSIDE, polygon=ring, z=floor)))


def upright(asset: Asset, category: str, wish: Wish | None, library: Library) -> Asset:
    """A long thing on its end, as brushes are in a jar and pans on a hook; as it is where it is tall already or has no
    such body."""
    depth, width, height = asset.size
    if height >= max(depth, width) or wish is None or wish.posture is not None:
        return asset
    posture = "on_back" if depth >= width else "on_side"
    try:
        made = library.choose(category, 1, replace(wish, size=asset.size, posture=posture, beyond=True))[0]
    except InputError:
        return asset
    return replace(made, category=asset.category)


def _volume(room: Interior) -> float:
    return float(np.prod(np.array(room.high) - np.array(room.low)))


def _around(part: Part, box: tuple[float, float, float, float], floor: float) -> list[Part]:
    """A prism without what of it is over the floor of a cavity: a slab below, and what is left beside it."""
    import shapely

    low, high = part.z
    ground = shapely.Polygon(part.polygon)
    if high <= floor + 1e-6 or not ground.intersects(shapely.box(*box)):
        return [part]
    found = [part.model_copy(update={"z": (low, floor)})] if low < floor - 1e-4 else []
    x0, y0, x1, y1 = ground.bounds
    a, b, c, d = box
    strips = ((x0, y0, a, y1), (c, y0, x1, y1), (a, y0, c, b), (a, d, c, y1))
    for strip in strips:
        if strip[2] - strip[0] < 1e-4 or strip[3] - strip[1] < 1e-4:
            continue
        piece = ground.intersection(shapely.box(*strip))
        if piece.geom_type == "Polygon" and piece.area > 1e-7:
            ring = counter_clockwise(shapely.get_coordinates(piece)[:-1])
            z = (max(low, floor), high)
            found.append(part.model_copy(update={"polygon": tuple((float(u), float(v)) for u, v in ring), "z": z}))
    return found


__all__ = ["INSIDE", "hollow", "upright"]
