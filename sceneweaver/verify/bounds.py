"""Objects that leave the room: through a wall, the ceiling or, for what hangs, the floor."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.geometry.polygons import union
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.verify.measure import at_most, length
from sceneweaver.verify.meshes import MeshSet
from sceneweaver.verify.report import Violation
from sceneweaver.verify.solids import DEPTH, Array, Body, Placed

AREA = 1e-8
"""Area in square metres of a footprint that may lie outside the outline widened by `DEPTH`."""


def find(placed: Placed, meshes: MeshSet) -> list[Violation]:
    """One violation for each object that leaves the room, however many ways it does.

    An object is outside when more than `AREA` of its footprint lies outside the outline widened by 1 mm, or when it is
    more than 1 mm above the ceiling; for objects on walls and ceilings also below the floor (all others must stand on
    something, which `support` judges). Where a mesh is known, its vertices take the place of the footprint and the top.
    """
    import shapely

    room = shapely.buffer(placed.floor, DEPTH, join_style="mitre")
    shapely.prepare(room)
    inside = shapely.covers(room, placed.parts.polygons)
    suspects = set(placed.parts.owner[~inside].tolist())
    found = []
    for body in placed.bodies:
        checkpoint()
        mesh = meshes.get(body.item.asset)
        low, high = body.z
        if mesh is not None:
            points = body.to_world(mesh.vertices)
            low, high = float(points[:, 2].min()), float(points[:, 2].max())
            beyond = _farthest(placed, room, points)
        else:
            beyond = _leaves(placed, body, room) if body.index in suspects else 0.0
        above = high - placed.scene.room.height
        ways = []
        if beyond > 0.0:
            ways.append((beyond, "reach out of the room", f"reaches {length(beyond)} out of the room"))
        if above > DEPTH:
            ways.append((above, "height above the ceiling", f"rises {length(above)} above the ceiling"))
        if low < -DEPTH and body.item.mount in ("wall", "ceiling"):
            ways.append((-low, "depth below the floor", f"sinks {length(-low)} into the floor"))
        if ways:
            amount, quantity, _ = max(ways, key=lambda way: way[0])
            detail = f"{body.id} {' and '.join(text for *_, text in ways)}"
            measured = at_most(quantity, amount, 0.0, slack=DEPTH)
            found.append(Violation.of("out_of_bounds", (body.id,), detail, measured))
    return found


def _farthest(placed: Placed, room: Any, points: Array) -> float:
    """Distance [m] from the outline to the farthest of ``points`` that is not in ``room``; 0.0 when all are."""
    import shapely

    flat: Any = shapely.points(points[:, :2])
    outside = flat[~shapely.covers(room, flat)]
    return float(shapely.distance(placed.floor, outside).max()) if len(outside) else 0.0


def _leaves(placed: Placed, body: Body, room: Any) -> float:
    """How far the footprint of ``body`` is outside [m]; 0.0 when too little of it is to count."""
    import shapely

    foot = union(placed.footprint(body))
    outside = shapely.difference(foot, room)
    area = float(shapely.area(outside))
    return (_beyond(placed, foot) or area**0.5) if area > AREA else 0.0


def _beyond(placed: Placed, shape: Any) -> float:
    """Largest distance [m] of a vertex of ``shape`` out of the room, or of a corner of the room into ``shape``."""
    import shapely

    corners = shapely.points(np.asarray(placed.scene.room.outline, dtype=float))
    beyond = shapely.distance(placed.floor, shapely.points(shapely.get_coordinates(shape))).max()
    into = np.where(shapely.contains(shape, corners), shapely.distance(corners, shapely.boundary(shape)), 0.0).max()
    return float(max(beyond, into))
