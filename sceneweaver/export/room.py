"""The room as closed meshes in the world's frame: a floor slab, and a wall with its openings for each edge.
Leaves of doors are in their own frames."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.placed import parts_mesh
from sceneweaver.assets.room_looks import room_looks, wall_look
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS, heights, wall_plan
from sceneweaver.physics.leaves import Leaf
from sceneweaver.scene import Part, Room

_LEAF = Material("door leaf", (0.82, 0.74, 0.62), roughness=0.6, texture="oak")
_HANDLE = Material("door handle", (0.62, 0.62, 0.63), roughness=0.35, metallic=1.0)


def floor_mesh(room: Room) -> Mesh:
    """The floor slab under room and walls, its top at z = 0."""
    from manifold3d import CrossSection, FillRule, Manifold

    walls = room.walls
    plans = [room.outline, *(wall_plan(walls, k) for k in range(len(walls)))]
    section = CrossSection([np.asarray(plans[0])], FillRule.Positive)
    for plan in plans[1:]:
        section = section + CrossSection([np.asarray(plan)], FillRule.Positive)
    slab = Manifold.extrude(section, FLOOR_THICKNESS).translate((0.0, 0.0, -FLOOR_THICKNESS))
    return manifold_mesh(slab, room_looks(room).floor)


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
    return manifold_mesh(body, wall_look(room, wall))


def leaf_mesh(leaf: Leaf) -> Mesh:
    """The leaf of a door and its handles, in the leaf's frame."""
    parts = []
    for center, half in leaf.boxes:
        (x0, y0, z0), (x1, y1, z1) = np.subtract(center, half).tolist(), np.add(center, half).tolist()
        parts.append(Part.model_construct(polygon=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), z=(z0, z1)))
    mesh = parts_mesh(parts, _LEAF)
    which = np.repeat(np.minimum(np.arange(len(parts)), 1), len(mesh.faces) // len(parts)).astype(np.int32)
    return Mesh(mesh.vertices, mesh.faces, which, mesh.face_link, (_LEAF, _HANDLE)[: which.max() + 1])


def manifold_mesh(body, material: Material) -> Mesh:
    """The arrays of a manifold; float64 where the library has them."""
    raw = body.to_mesh64()
    faces = np.asarray(raw.tri_verts, dtype=np.int32)
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(np.asarray(raw.vert_properties, dtype=float)[:, :3], faces, zeros, zeros, (material,))
