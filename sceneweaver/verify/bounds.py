"""Objects that leave the room: through a wall, the ceiling or, for what hangs, the floor."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

import numpy as np

from sceneweaver.geometry.polygons import union
from sceneweaver.verify.meshes import MeshSet
from sceneweaver.verify.solids import DEPTH, Array, Body, Placed

AREA = 1e-8
"""Area in square metres of a footprint that may lie outside the outline widened by `DEPTH`."""


class Exit(NamedTuple):
    """Object ``index`` leaves the room ``through`` a wall, the ceiling or the floor, by ``amount`` metres."""

    index: int
    through: Literal["wall", "ceiling", "floor"]
    amount: float


def find(placed: Placed, meshes: MeshSet) -> list[Exit]:
    """Return each way in which an object leaves the room.

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
        mesh = meshes.get(body.item.asset)
        low, high = body.z
        if mesh is not None:
            points = body.to_world(mesh.vertices)
            low, high = float(points[:, 2].min()), float(points[:, 2].max())
            beyond = _farthest(placed, room, points)
        else:
            beyond = _leaves(placed, body, room) if body.index in suspects else 0.0
        if beyond > 0.0:
            found.append(Exit(body.index, "wall", beyond))
        if high > placed.scene.room.height + DEPTH:
            found.append(Exit(body.index, "ceiling", high - placed.scene.room.height))
        if low < -DEPTH and body.item.mount in ("wall", "ceiling"):
            found.append(Exit(body.index, "floor", -low))
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
