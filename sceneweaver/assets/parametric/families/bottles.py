"""Bottles, standing in cabinets and lying in racks."""

from __future__ import annotations

from ... import shapes
from ...drawing import Box, Drawing
from ...drawing.drawing import Look


def bottle(d: Drawing, radius: float, height: float, glass: Look, cap: Look, label: bool = False) -> None:
    """A bottle with a capped neck that stands at the frame's origin; its collision part is one hull."""
    neck = 0.38 * radius
    body = shapes.lathe([(radius, 0.0), (radius, 0.62 * height), (neck, 0.8 * height), (neck, 0.9 * height)], 12)
    top = shapes.frustum(1.05 * neck, 1.05 * neck, (0.88 * height, height), 12)
    d.add(body, glass, [shapes.lathe([(radius, 0.0), (radius, 0.62 * height), (1.05 * neck, height)], 12)])
    with d.no_colliders():
        d.add(top, cap, [])
        if label:
            wide = 2 * radius + 0.0006
            d.cylinder(Box.sized(wide, wide, 0.3 * height, (0.0, 0.0, 0.16 * height)), "paper", segments=12)
