"""The light in a room: soft daylight from above, a beam of sun through its windows, and its lamps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.shell import WALL_THICKNESS, wall_pieces
from sceneweaver.scene import Room, Window

from .caster import Instance, Lighting
from .room_blocks import Builder, wall_block

_LEAST_GLOW = 0.3  # emission from which on a material is a lamp's
_MOST_LAMPS = 48
_BLIND = Material("shutter", (0.0, 0.0, 0.0))

_DAY: dict[str, Any] = {
    "sky": (0.68, 0.695, 0.725),
    "ground": (0.36, 0.335, 0.31),
    "background": (0.80, 0.79, 0.775),
    "reach": 1.6,
    "bounce": 0.62,
    "exposure": 1.06,
}
"""What all pictures of rooms have in common: an even daylight from all sides before a light ground."""


def corner_light(room: Room, way: np.ndarray, cut: set[int], things: Sequence[Instance]) -> Lighting:
    """The light of a picture from a corner in the direction ``way`` [2] (unit, from the room to the camera)."""
    left = np.array([-way[1], way[0]])
    key = 0.66 * way + 0.34 * left
    walls = list(range(len(room.outline)))
    # Best is a window that is seen; sun also comes through those of the walls that are cut away.
    more = _beam(room, [k for k in walls if k not in cut]) or _beam(room, walls)
    return Lighting(
        sun=(float(key[0]), float(key[1]), 1.15),
        softness=0.075,
        sun_color=(0.62, 0.58, 0.53) if more else (0.68, 0.64, 0.58),
        lamps=lamps_of(things),
        **_DAY,
        **more,
    )


def top_light(room: Room, things: Sequence[Instance]) -> Lighting:
    """The light of a picture from straight above: the sun stands high, so that walls throw short shadows."""
    return Lighting(
        sun=(-0.30, 0.34, 1.3),
        softness=0.07,
        sun_color=(0.72, 0.68, 0.62),
        lamps=lamps_of(things),
        **_DAY,
        **_beam(room, list(range(len(room.outline)))),
    )


def lamps_of(things: Sequence[Instance]) -> tuple[tuple[float, float, float, float], ...]:
    """A small light in the middle of what glows of each thing, by its area; the strongest when there are many."""
    found = []
    for one in things:
        mesh = one.mesh
        glowing = np.array([m.emission >= _LEAST_GLOW for m in mesh.materials], dtype=bool)
        faces = mesh.faces[glowing[mesh.face_material]] if len(mesh.faces) else mesh.faces
        if not len(faces):
            continue
        corners = (mesh.vertices @ one.transform[:3, :3].T + one.transform[:3, 3])[faces]
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        x, y, z = np.average(corners.mean(axis=1), axis=0, weights=np.maximum(area, 1e-9))
        power = 0.16 * min(1.0, math.sqrt(float(area.sum()) / 0.12))
        found.append((round(float(x), 5), round(float(y), 5), round(float(z), 5), power))
    return tuple(sorted(found, key=lambda lamp: (-lamp[3], lamp))[:_MOST_LAMPS])


def _beam(room: Room, walls: Sequence[int]) -> dict:
    """The sun through the windows of the wall of ``walls`` with the most glass; nothing without windows."""
    glass = {k: 0.0 for k in walls}
    for window in room.windows:
        if window.wall in glass:
            glass[window.wall] += window.width * window.height
    best = max(glass, key=lambda k: (round(glass[k], 6), -k), default=None)
    if best is None or glass[best] <= 0:
        return {}
    wall = room.walls[best]
    # A little aslant, so that bars and curtains draw lines that run into the room.
    slant = np.array(wall.outward) + 0.42 * np.array(wall.along)
    slant = slant / np.linalg.norm(slant)
    height = math.tan(math.radians(36.0))
    return {
        "beam": (float(slant[0]), float(slant[1]), height),
        "beam_softness": 0.022,
        "beam_floor": -0.02,
        "beam_color": (2.1, 1.72, 1.25),
        "shutters": _shutters(room),
    }


def _shutters(room: Room) -> Mesh:
    """Full walls and a ceiling, so that the sun comes in by the windows alone."""
    builder = Builder()
    for wall in room.walls:
        for (a, b), z, opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height):
            # Doors are shut to the sun; of a wall's pieces only the gaps of windows stay open.
            if not isinstance(opening, Window):
                reach_a = a - (WALL_THICKNESS if a <= 1e-6 else 0.0)
                reach_b = b + (WALL_THICKNESS if b >= wall.length - 1e-6 else 0.0)
                builder.prism(wall_block(wall, (reach_a, reach_b), (0.01, WALL_THICKNESS)), z, _BLIND)
    outline = np.asarray(room.outline, dtype=float)
    low, high = outline.min(axis=0) - 1.0, outline.max(axis=0) + 1.0
    # The ceiling may be larger than the room: it only holds off sun from above.
    roof = np.array([(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])])
    builder.prism(roof, (room.height + 0.02, room.height + 0.05), _BLIND)
    mesh = builder.mesh()
    assert mesh is not None
    return mesh
