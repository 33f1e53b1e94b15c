"""Where a picture is taken from."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Camera:
    """A camera in the world: ``forward`` is a unit vector.

    ``right`` and ``up`` span half the picture at distance 1; of a flat camera (no perspective), half of it in metres.
    """

    eye: tuple[float, float, float]
    forward: tuple[float, float, float]
    right: tuple[float, float, float]
    up: tuple[float, float, float]
    flat: bool = False

    @classmethod
    def look_at(cls, eye, target, fov: float = 0.6, aspect: float = 1.0) -> Camera:
        """A perspective camera; ``fov`` [rad] is the whole vertical angle, ``aspect`` width over height."""
        forward, right, up = _axes(np.asarray(eye, dtype=float), np.asarray(target, dtype=float))
        half = math.tan(fov / 2)
        eye, forward, right, up = _tuples(eye, forward, right * half * aspect, up * half)
        return cls(eye, forward, right, up)

    @classmethod
    def orthographic(cls, eye, target, height: float, aspect: float = 1.0) -> Camera:
        """A camera without perspective whose picture is ``height`` metres high."""
        forward, right, up = _axes(np.asarray(eye, dtype=float), np.asarray(target, dtype=float))
        return cls(*_tuples(eye, forward, right * height / 2 * aspect, up * height / 2), flat=True)

    @classmethod
    def framing(cls, low, high, direction, fov: float = 0.5, aspect: float = 1.0, margin: float = 1.08) -> Camera:
        """A perspective camera that looks along ``direction`` and holds the box from ``low`` to ``high`` just so."""
        low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
        corners = np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1)
                            for k in (0, 1)])  # fmt: skip
        target = (low + high) / 2
        forward, right, up = _axes(np.zeros(3), np.asarray(direction, dtype=float))
        half = math.tan(fov / 2)
        for _ in range(3):
            rel = corners - target
            along, across, tall = rel @ forward, rel @ right, rel @ up
            need = np.maximum(np.abs(across) / (half * aspect), np.abs(tall) / half) * margin
            distance = float(np.max(need - along))
            # Centre what is seen: perspective makes near corners larger than far ones.
            depth = distance + along
            u, v = across / depth, tall / depth
            target = target + right * (u.max() + u.min()) / 2 * distance + up * (v.max() + v.min()) / 2 * distance
        eye = target - forward * distance
        eye, forward, right, up = _tuples(eye, forward, right * half * aspect, up * half)
        return cls(eye, forward, right, up)


def _axes(eye: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    forward = target - eye
    forward = forward / np.linalg.norm(forward)
    # Straight down, the top of the picture is +y.
    upward = np.array([0.0, 0.0, 1.0]) if abs(forward[2]) < 0.9999 else np.array([0.0, 1.0, 0.0])
    right = np.cross(forward, upward)
    right = right / np.linalg.norm(right)
    return forward, right, np.cross(right, forward)


def _tuples(*vectors) -> list[tuple[float, float, float]]:
    return [(float(v[0]), float(v[1]), float(v[2])) for v in vectors]
