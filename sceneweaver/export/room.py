"""The room as closed meshes in the world's frame: a floor slab, and a wall with its openings for each edge."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.room_looks import room_looks, wall_look
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS, heights, wall_plan
from sceneweaver.scene import Room


def floor_mesh(room: Room) -> Mesh:
    """The floor slab under room and walls, its top at z = 0."""
    from manifold3d import CrossSection, FillRule, Manifold

    walls = room.walls
    plans = [room.outline, *(wall_plan(walls, k) for k in range(len(walls)))]
    section = CrossSection([np.asarray(plans[0])], FillRule.Positive)
    for plan in plans[1:]:
        section = section + CrossSection([np.asarray(plan)], FillRule.Positive)
    slab = Manifold.extrude(section, FLOOR_THICKNESS).translate((0.0, 0.0, -FLOOR_THICKNESS))
    return _mesh(slab, room_looks(room).floor)


def wall_mesh(room: Room, wall: int) -> Mesh:
    """Wall ``wall``, from the floor to the ceiling, with a hole for each of its doors and windows."""
    from manifold3d import CrossSection, FillRule, Manifold

    walls = room.walls
    body = Manifold.extrude(CrossSection([np.asarray(wall_plan(walls, wall))], FillRule.Positive), room.height)
    turn = math.degrees(walls[wall].yaw)
    for opening in room.openings_of(wall):
        low, high = heights(opening)
        # A hole that ends at the floor or the ceiling is cut a little beyond, so that no film of wall is left.
        low, high = (-0.1 if low <= 1e-6 else low), (room.height + 0.1 if high >= room.height - 1e-6 else high)
        hole = Manifold.cube((opening.width, 4 * WALL_THICKNESS, high - low))
        hole = hole.translate((opening.offset, -3 * WALL_THICKNESS, low))
        body = body - hole.rotate((0.0, 0.0, turn)).translate((*walls[wall].start, 0.0))
    return _mesh(body, wall_look(room, wall))


def _mesh(body, material: Material) -> Mesh:
    """The arrays of a manifold; float64 where the library has them."""
    raw = body.to_mesh64()
    faces = np.asarray(raw.tri_verts, dtype=np.int32)
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(np.asarray(raw.vert_properties, dtype=float)[:, :3], faces, zeros, zeros, (material,))
