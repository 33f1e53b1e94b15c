"""What doors and windows look like: frames, a closed leaf, panes of glass."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room, Window

_FRAME = Material("window frame", (0.96, 0.955, 0.94), roughness=0.5)
_LEAF = Material("door leaf", (0.80, 0.69, 0.55), roughness=0.55, texture="oak")
_HANDLE = Material("door handle", (0.72, 0.73, 0.74), roughness=0.3, metallic=1.0)
_GLASS = Material("pane", (0.80, 0.90, 0.95), roughness=0.05, opacity=0.28)

Range = tuple[float, float]
Block = tuple[Range, Range, Range, Material]  # along the wall, outward from its inner face, up [m]

_BAR = 0.05


def opening_meshes(room: Room) -> Iterator[tuple[int, str, Mesh]]:
    """Wall, a name and the mesh in the world's frame of each door and window."""
    for k, door in enumerate(room.doors):
        yield door.wall, f"door:{k}", _built(room.walls[door.wall], _door(door.offset, door.width, door.height))
    for k, window in enumerate(room.windows):
        yield window.wall, f"window:{k}", window_mesh(room, window)


def window_mesh(room: Room, window: Window) -> Mesh:
    """Frame, sill and pane of a window in the world's frame."""
    blocks = _window(window.offset, window.width, window.sill, window.height)
    return _built(room.walls[window.wall], blocks)


def _border(offset: float, width: float, low: float, high: float, deep: Range, bottom: bool) -> list[Block]:
    bar = min(_BAR, width / 4, (high - low) / 4)
    end = offset + width
    blocks: list[Block] = [
        ((offset, offset + bar), deep, (low, high), _FRAME),
        ((end - bar, end), deep, (low, high), _FRAME),
        ((offset + bar, end - bar), deep, (high - bar, high), _FRAME),
    ]
    if bottom:
        blocks.append(((offset + bar, end - bar), deep, (low, low + bar), _FRAME))
    return blocks


def _door(offset: float, width: float, height: float) -> list[Block]:
    bar = min(_BAR, width / 4, height / 4)
    middle = WALL_THICKNESS / 2
    blocks = _border(offset, width, 0.0, height, (-0.012, WALL_THICKNESS + 0.012), False)
    inner, end = offset + bar, offset + width - bar
    blocks.append(((inner, end), (middle - 0.02, middle + 0.02), (0.005, height - bar), _LEAF))
    if height > 1.3 and width > 0.5:
        blocks.append(((end - 0.16, end - 0.04), (middle - 0.065, middle - 0.05), (1.0, 1.02), _HANDLE))
        blocks.append(((end - 0.06, end - 0.04), (middle - 0.065, middle - 0.015), (1.0, 1.02), _HANDLE))
    return blocks


def _window(offset: float, width: float, sill: float, height: float) -> list[Block]:
    top = sill + height
    bar = min(_BAR, width / 4, height / 4)
    blocks = _border(offset, width, sill, top, (0.02, WALL_THICKNESS - 0.01), True)
    blocks.append(((offset - 0.03, offset + width + 0.03), (-0.05, 0.02), (sill - 0.025, sill), _FRAME))
    panes = max(1, round(width / 0.9))
    for k in range(1, panes):
        at = offset + width * k / panes
        blocks.append(((at - bar / 2, at + bar / 2), (0.03, WALL_THICKNESS - 0.02), (sill + bar, top - bar), _FRAME))
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
