"""The plain light of pictures from above: soft daylight, a beam of sun through the windows, and lamps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from sceneweaver.scene import Room

from .instances import Instance
from .tracing import DirectLights
from .tracing.lights import most_glass, portals_of, slant_of

_LEAST_GLOW = 0.3  # emission from which on a material is a lamp's
_MOST_LAMPS = 48
_PANE = 0.9  # depth of panes in their walls, in shares of these: before what shines behind them

_DAY: dict[str, Any] = {
    "sky": (0.68, 0.695, 0.725),
    "ground": (0.36, 0.335, 0.31),
    "background": (0.80, 0.79, 0.775),
    "reach": 1.6,
    "bounce": 0.62,
    "exposure": 1.06,
}
"""What all pictures of rooms have in common: an even daylight from all sides before a light ground."""


def corner_light(room: Room, way: np.ndarray, cut: set[int], things: Sequence[Instance]) -> DirectLights:
    """The light of a picture from a corner in the direction ``way`` [2] (unit, from the room to the camera)."""
    left = np.array([-way[1], way[0]])
    key = 0.66 * way + 0.34 * left
    walls = list(range(len(room.outline)))
    # Best is a window that is seen; sun also comes through those of the walls that are cut away.
    more = _beam(room, [k for k in walls if k not in cut]) or _beam(room, walls)
    return DirectLights(
        sun=(float(key[0]), float(key[1]), 1.15),
        softness=0.075,
        sun_color=(0.62, 0.58, 0.53) if more else (0.68, 0.64, 0.58),
        glows=glows_of(things),
        **_DAY,
        **more,
    )


def top_light(room: Room, things: Sequence[Instance]) -> DirectLights:
    """The light of a picture from straight above: the sun stands high, so that walls throw short shadows."""
    return DirectLights(
        sun=(-0.30, 0.34, 1.3),
        softness=0.07,
        sun_color=(0.72, 0.68, 0.62),
        glows=glows_of(things),
        **_DAY,
        **_beam(room, list(range(len(room.outline)))),
    )


def glows_of(things: Sequence[Instance]) -> tuple[tuple[float, float, float, float], ...]:
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


def _beam(room: Room, walls: Sequence[int]) -> dict[str, Any]:
    """The sun through the windows of the wall of ``walls`` with the most glass; nothing without windows."""
    wall = most_glass(room, walls)
    if wall is None:
        return {}
    x, y, z = slant_of(wall)
    return {
        "beam": (x, y, z),
        "beam_softness": 0.022,
        "beam_floor": -0.02,
        "beam_color": (2.1, 1.72, 1.25),
        "portals": portals_of(room, _PANE),
    }
