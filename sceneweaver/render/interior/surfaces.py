"""Floor and walls as plain faces whose patterns come from their materials."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_vertices, ring_faces
from sceneweaver.geometry.shell import FLOOR_THICKNESS, wall_pieces
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import Room

from ..room_blocks import Builder
from ..room_finish import Finishes
from ..room_shell import add_wall
from ..room_walls import add_panels
from .mouldings import Plane, plate, rectangle

_PAPER, _TILE = 0.001, 0.004  # thickness [m]


def floor_plane(look: Material, plan: np.ndarray) -> Mesh:
    """The floor slab with its top at z = 0, the pattern of its material along the longest edge of its plan [N, 2]."""
    import manifold3d

    triangles = np.asarray(manifold3d.triangulate([np.asarray(plan, dtype=float)]), dtype=np.int32)
    n = len(plan)
    faces = np.concatenate([triangles + n, triangles[:, ::-1], ring_faces(0, n, n)]).astype(np.int32)
    vertices = prism_vertices(plan, (-FLOOR_THICKNESS, 0.0))
    longest = max(walls_of(plan), key=lambda wall: round(wall.length, 6))
    uv = np.stack(longest.coordinates(vertices[:, :2].T), axis=1)[faces].astype(np.float32)
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(vertices, faces, zeros, zeros, (look,), uv)


def add_wall_faces(builder: Builder, room: Room, wall: Wall, look: Finishes) -> None:
    """A wall with its paint or paper, and its tiles or panels."""
    add_wall(builder, room, wall, room.height, look)
    kind, band, accent = look.accented(wall.index), look.tiled(wall.index), look.looks.accent
    if kind == "paper" and accent is not None:
        _facing(builder, room, wall, (0.0, room.height), _PAPER, replace(accent, texture="stripes"))
    elif kind == "panelling" and accent is not None:
        add_panels(builder, room, wall, accent, room.height)
    if band is not None and look.looks.tiles is not None:
        _facing(builder, room, wall, band, _TILE, look.looks.tiles)


def _facing(builder: Builder, room: Room, wall: Wall, z: tuple[float, float], thick: float, material: Material) -> None:
    """A thin layer on the parts of a wall between two heights [m] that are no openings."""
    plane = Plane.on_wall(wall)
    for along, (low, high), opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height):
        low, high = max(low, z[0]), min(high, z[1])
        if opening is None and high - low > 1e-3:
            plate(builder, plane, rectangle(along, (low, high)), (0.0, thick), material)
