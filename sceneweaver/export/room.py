"""The room as closed meshes in the world's frame: a floor slab, and a wall with its openings for each edge."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.scene import Room

WALL_THICKNESS = 0.1
"""Thickness of the walls [m]; they stand outside the outline."""

FLOOR_THICKNESS = 0.05
"""Thickness of the floor slab [m], under z = 0."""

WALL = Material("wall paint", (0.925, 0.912, 0.885), roughness=0.95)
FLOOR = Material("floor", (0.74, 0.62, 0.48), roughness=0.7, texture="wood")

Plan = list[tuple[float, float]]

_LONGEST_MITRE = 4.0  # in wall thicknesses; at sharper corners the walls end straight


def floor_mesh(room: Room) -> Mesh:
    """The floor slab under room and walls, its top at z = 0."""
    from manifold3d import CrossSection, FillRule, Manifold

    plans = [room.outline, *(wall_plan(room, k) for k in range(len(room.outline)))]
    section = CrossSection([np.asarray(plans[0])], FillRule.Positive)
    for plan in plans[1:]:
        section = section + CrossSection([np.asarray(plan)], FillRule.Positive)
    slab = Manifold.extrude(section, FLOOR_THICKNESS).translate((0.0, 0.0, -FLOOR_THICKNESS))
    return _mesh(slab, FLOOR)


def wall_mesh(room: Room, wall: int) -> Mesh:
    """Wall ``wall``, from the floor to the ceiling, with a hole for each of its doors and windows."""
    from manifold3d import CrossSection, FillRule, Manifold

    body = Manifold.extrude(CrossSection([np.asarray(wall_plan(room, wall))], FillRule.Positive), room.height)
    start, along, outward = wall_frame(room, wall)
    turn = math.degrees(math.atan2(along[1], along[0]))
    for offset, width, low, high in openings(room, wall):
        # A hole that ends at the floor or the ceiling is cut a little beyond, so that no film of wall is left.
        low, high = (-0.1 if low <= 1e-6 else low), (room.height + 0.1 if high >= room.height - 1e-6 else high)
        hole = Manifold.cube((width, 4 * WALL_THICKNESS, high - low)).translate((offset, -3 * WALL_THICKNESS, low))
        body = body - hole.rotate((0.0, 0.0, turn)).translate((*start, 0.0))
    return _mesh(body, WALL)


def openings(room: Room, wall: int) -> list[tuple[float, float, float, float]]:
    """Offset along the wall, width, lower and upper end [m] of the doors and windows of a wall."""
    doors = [(d.offset, d.width, 0.0, d.height) for d in room.doors if d.wall == wall]
    return doors + [(w.offset, w.width, w.sill, w.sill + w.height) for w in room.windows if w.wall == wall]


def wall_frame(room: Room, wall: int) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
    """First corner of a wall [m], the unit vector along it and the one out of the room."""
    (ax, ay), (bx, by) = room.outline[wall], room.outline[(wall + 1) % len(room.outline)]
    length = math.hypot(bx - ax, by - ay)
    ux, uy = (bx - ax) / length, (by - ay) / length
    return (ax, ay), (ux, uy), (uy, -ux)


def wall_plan(room: Room, wall: int) -> Plan:
    """The wall from above, counter-clockwise: four corners, mitred with the walls beside it."""
    outline = room.outline
    n = len(outline)
    a, b = outline[wall], outline[(wall + 1) % n]
    before, after = _outer(outline, wall), _outer(outline, (wall + 1) % n)
    _, (ux, uy), (nx, ny) = wall_frame(room, wall)
    straight_a = (a[0] + nx * WALL_THICKNESS, a[1] + ny * WALL_THICKNESS)
    straight_b = (b[0] + nx * WALL_THICKNESS, b[1] + ny * WALL_THICKNESS)
    outer_a, outer_b = before or straight_a, after or straight_b
    if (outer_b[0] - outer_a[0]) * ux + (outer_b[1] - outer_a[1]) * uy < 1e-3:
        # A short wall between two corners that lean towards each other: mitred, it would turn over.
        outer_a, outer_b = straight_a, straight_b
    return [a, outer_a, outer_b, b]


def _outer(outline: Sequence[tuple[float, float]], corner: int) -> tuple[float, float] | None:
    """Where the outer faces of the two walls at a corner meet; None where that is too far off."""
    n = len(outline)
    (px, py), (x, y), (qx, qy) = outline[corner - 1], outline[corner], outline[(corner + 1) % n]
    one, two = math.hypot(x - px, y - py), math.hypot(qx - x, qy - y)
    n1 = ((y - py) / one, -(x - px) / one)
    n2 = ((qy - y) / two, -(qx - x) / two)
    share = 1 + n1[0] * n2[0] + n1[1] * n2[1]
    if share < 2 / _LONGEST_MITRE**2:
        return None
    return (x + (n1[0] + n2[0]) / share * WALL_THICKNESS, y + (n1[1] + n2[1]) / share * WALL_THICKNESS)


def _mesh(body, material: Material) -> Mesh:
    """The arrays of a manifold; float64 where the library has them."""
    raw = body.to_mesh64()
    faces = np.asarray(raw.tri_verts, dtype=np.int32)
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(np.asarray(raw.vert_properties, dtype=float)[:, :3], faces, zeros, zeros, (material,))


__all__ = [
    "FLOOR",
    "FLOOR_THICKNESS",
    "WALL",
    "WALL_THICKNESS",
    "floor_mesh",
    "openings",
    "wall_frame",
    "wall_mesh",
    "wall_plan",
]
