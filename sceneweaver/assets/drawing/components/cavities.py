"""The insides of appliances: rooms with round edges that open to the front, and wire racks in them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ... import shapes
from ..box import Box, Interval
from ..drawing import Drawing, Look

FORWARD = (1.0, 0.0, 0.0)
"""The way out of what is open in front."""


def compartments(d: Drawing, rooms: Sequence[Box], name: str = "inside") -> None:
    """Interiors that open to the front, from the lowest: what boards make of a cupboard."""
    for k, room in enumerate(rooms):
        d.interior(f"{name}-{k}", room, entry=FORWARD)


def cavity(
    d: Drawing, box: Box, material: Look, wall: float = 0.03, radius: float = 0.01, inside: str | None = "inside"
) -> Box:
    """A box open in front, with round edges along its depth, as an oven or a fridge; returns the room inside.

    Its collision parts are its five walls, as boxes. ``inside`` is the name of its interior; None: boards or racks cut
    it up, or it is the outer skin of another one.
    """
    room = box.inset(y=wall, z=wall, back=wall)
    rings = []
    for own, depths, r in ((box, (0.0, box.depth), radius), (room, (box.depth, wall), 0.001)):
        rings += [shapes.rectangle((-own.z[1], -own.z[0]), own.y, z, r) for z in depths]
    skin, faces = shapes.lofted(rings)
    points = np.c_[box.x[0] + skin[:, 2], skin[:, 1], -skin[:, 0]]  # the rings lie across x, one corner is up
    between = box.inset(y=wall)
    walls = (box.left(wall), box.right(wall), between.top(wall), between.bottom(wall), room.back(-wall))
    d.add((points, faces), material, [shapes.box(*_spans(own)) for own in walls])
    if inside:
        d.interior(inside, room, entry=FORWARD)
    return room


def rack(d: Drawing, box: Box, material: Look = "chrome", pitch: float = 0.05, wire: float = 0.005) -> Box:
    """A level wire shelf under the top of a box: a frame, and wires from back to front about ``pitch`` apart.

    It is one collision part.
    """
    level = box.top(wire)
    d.add(shapes.box(*_spans(level.front(wire))), material, [shapes.box(*_spans(level))])
    count = max(2, round(level.width / pitch) - 1)
    step = level.width / (count + 1)
    x, y, z = level.anchor("bottom right")
    with d.no_colliders():
        for bar in (level.back(wire), level.left(wire), level.right(wire)):
            d.box(bar, material, bevel=0.0)
        with d.along((x, y + step, z), (x, y + level.width - step, z), count):
            d.box(Box.sized(level.depth, 0.6 * wire, wire), material, bevel=0.0)
    return box


def _spans(box: Box) -> tuple[Interval, Interval, Interval]:
    return box.x, box.y, box.z
