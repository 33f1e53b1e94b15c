"""What doors and windows look like: frames and panes of glass, and the leaves that open."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.scene import Door, Room, Window

from .room import leaf_mesh

_FRAME = Material("window frame", (0.96, 0.955, 0.94), roughness=0.5)
_GLASS = Material("pane", (0.80, 0.90, 0.95), roughness=0.05, opacity=0.28)

Range = tuple[float, float]
Block = tuple[Range, Range, Range, Material]  # along the wall, outward from its inner face, up [m]

_BAR = 0.05
_TRIM = 0.009  # by which a door's frame stands before the wall: a leaf that slides passes at 0.01


def opening_meshes(room: Room) -> Iterator[tuple[int, str, Mesh]]:
    """Wall, a name and the mesh in the world's frame of what stands still of each door and window."""
    for k, door in enumerate(room.doors):
        wall = room.walls[door.wall]
        yield door.wall, f"door:{k}", _built(wall, _door(wall, door, room.height))
    for k, window in enumerate(room.windows):
        yield window.wall, f"window:{k}", window_mesh(room, window)


def door_leaves(room: Room) -> Iterator[tuple[int, Leaf, Mesh]]:
    """Wall, the leaf and its mesh, closed and in the leaf's frame, of each door."""
    for door, leaf in zip(room.doors, leaves(room), strict=True):
        yield door.wall, leaf, leaf_mesh(leaf)


def window_mesh(room: Room, window: Window, thickness: float = WALL_THICKNESS) -> Mesh:
    """Frame, sill and pane of a window in the world's frame, in a wall of that thickness [m]."""
    blocks = _window(window.offset, window.width, window.sill, window.height, thickness)
    return _built(room.walls[window.wall], blocks)


def _border(offset: float, width: float, low: float, high: float, deep: Range) -> list[Block]:
    bar = min(_BAR, width / 4, (high - low) / 4)
    end = offset + width
    return [
        ((offset, offset + bar), deep, (low, high), _FRAME),
        ((end - bar, end), deep, (low, high), _FRAME),
        ((offset + bar, end - bar), deep, (high - bar, high), _FRAME),
        ((offset + bar, end - bar), deep, (low, low + bar), _FRAME),
    ]


def _door(wall: Wall, door: Door, ceiling: float) -> list[Block]:
    """A frame on both faces of the wall around the opening, which the leaf fills when it is closed."""
    start, end = door.offset, door.offset + door.width
    left, right = max(start - _BAR, min(start, 0.0)), min(end + _BAR, max(end, wall.length))
    top = min(door.height + _BAR, max(ceiling, door.height))
    blocks: list[Block] = []
    for deep in ((-_TRIM, 0.0), (WALL_THICKNESS, WALL_THICKNESS + _TRIM)):
        bars = (((left, start), (0.0, top)), ((end, right), (0.0, top)), ((start, end), (door.height, top)))
        blocks += [(along, deep, up, _FRAME) for along, up in bars if min(along[1] - along[0], up[1] - up[0]) > 1e-6]
    return blocks


def _window(offset: float, width: float, sill: float, height: float, thickness: float) -> list[Block]:
    top = sill + height
    bar = min(_BAR, width / 4, height / 4)
    blocks = _border(offset, width, sill, top, (0.02, thickness - 0.01))
    blocks.append(((offset - 0.03, offset + width + 0.03), (-0.05, 0.02), (sill - 0.025, sill), _FRAME))
    panes = max(1, round(width / 0.9))
    for k in range(1, panes):
        at = offset + width * k / panes
        blocks.append(((at - bar / 2, at + bar / 2), (0.03, thickness - 0.02), (sill + bar, top - bar), _FRAME))
    blocks.append(((offset + bar, offset + width - bar), (0.05, 0.056), (sill + bar, top - bar), _GLASS))
    return blocks


def _built(wall: Wall, blocks: list[Block]) -> Mesh:
    materials = tuple(dict.fromkeys(block[3] for block in blocks))
    vertices, faces, kinds = [], [], []
    for (s0, s1), (t0, t1), z, material in blocks:
        points, triangles = prism_mesh(wall.strip(s0, s1 - s0, -t1, -t0), z)
        faces.append(triangles + len(points) * len(kinds))
        vertices.append(points)
        kinds.append(materials.index(material))
    face_material = np.repeat(np.asarray(kinds, dtype=np.int32), len(faces[0]))
    return Mesh(np.concatenate(vertices), np.concatenate(faces), face_material, np.zeros_like(face_material), materials)
