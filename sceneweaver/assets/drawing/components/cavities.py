"""The insides of appliances: rooms with round edges that open to the front, and wire racks in them."""

from __future__ import annotations

import math

from ... import shapes
from ..box import Box
from ..drawing import Drawing, Look
from .vessels import CORNERS, vessel


def cavity(d: Drawing, box: Box, material: Look, wall: float = 0.03, radius: float = 0.01) -> Box:
    """A box open in front, with round edges along its depth, as an oven or a fridge; returns the room inside."""
    deep = box.depth
    across, up = box.y, (-box.z[1], -box.z[0])
    less, low = (across[0] + wall, across[1] - wall), (up[0] + wall, up[1] - wall)
    inside = max(0.5 * radius, radius - wall)
    with d.at(box.x[0], pitch=math.pi / 2):  # +z is forward, and +x down
        outer = [shapes.rectangle(up, across, z, radius) for z in (0.0, deep)]
        inner = [shapes.rectangle(low, less, z, inside) for z in (deep, wall)]
        vessel(d, outer, inner, material, CORNERS)
    return box.inset(y=wall, z=wall, back=wall)


def rack(d: Drawing, box: Box, material: Look = "chrome", pitch: float = 0.05, wire: float = 0.005) -> Box:
    """A level wire shelf under the top of a box: a frame, and wires from back to front about ``pitch`` apart."""
    level = box.top(wire)
    for bar in (level.front(wire), level.back(wire), level.left(wire), level.right(wire)):
        d.box(bar, material, bevel=0.0)
    count = max(2, round(level.width / pitch) - 1)
    step = level.width / (count + 1)
    x, y, z = level.anchor("bottom right")
    with d.along((x, y + step, z), (x, y + level.width - step, z), count):
        d.box(Box.sized(level.depth, 0.6 * wire, wire), material, bevel=0.0)
    return box
