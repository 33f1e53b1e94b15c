"""Where a picture is taken from."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import InputError


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
        """A perspective camera; ``fov`` [rad] is the whole vertical angle, ``aspect`` width over height.

        Raises:
            InputError: ``eye`` and ``target`` are one point or not finite, or ``fov`` is not between 0 and pi.
        """
        _check_lens(fov, aspect)
        forward, right, up = _axes(np.asarray(eye, dtype=float), np.asarray(target, dtype=float))
        half = math.tan(fov / 2)
        eye, forward, right, up = _tuples(eye, forward, right * half * aspect, up * half)
        return cls(eye, forward, right, up)

    @classmethod
    def orthographic(cls, eye, target, height: float, aspect: float = 1.0) -> Camera:
        """A camera without perspective whose picture is ``height`` metres high.

        Raises:
            InputError: ``eye`` and ``target`` are one point or not finite, or ``height`` is not above 0.
        """
        if not (math.isfinite(height) and height > 0):
            raise InputError(f"camera.height: {height} is not a number of metres above 0")
        _check_lens(1.0, aspect)
        forward, right, up = _axes(np.asarray(eye, dtype=float), np.asarray(target, dtype=float))
        return cls(*_tuples(eye, forward, right * height / 2 * aspect, up * height / 2), flat=True)

    @classmethod
    def framing(cls, low, high, direction, fov: float = 0.5, aspect: float = 1.0, margin: float = 1.08) -> Camera:
        """A perspective camera that looks along ``direction`` and holds the box from ``low`` to ``high`` just so."""
        _check_lens(fov, aspect)
        low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
        corners = np.array(
            [[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        )
        return cls.holding(corners, direction, fov, aspect, margin)

    @classmethod
    def holding(
        cls, points: np.ndarray, direction, fov: float = 0.5, aspect: float = 1.0, margin: float = 1.08
    ) -> Camera:
        """A perspective camera that looks along ``direction`` and holds ``points`` [N, 3] just so, in the middle."""
        _check_lens(fov, aspect)
        target = (points.min(axis=0) + points.max(axis=0)) / 2
        forward, right, up = _axes(np.zeros(3), np.asarray(direction, dtype=float))
        half = math.tan(fov / 2)
        distance = 0.0
        for _ in range(6):
            rel = points - target
            along, across, tall = rel @ forward, rel @ right, rel @ up
            need = np.maximum(np.abs(across) / (half * aspect), np.abs(tall) / half) * margin
            distance = float(np.max(need - along))
            # Centre what is seen: perspective makes near points larger than far ones.
            depth = distance + along
            u, v = across / depth, tall / depth
            target = target + right * (u.max() + u.min()) / 2 * distance + up * (v.max() + v.min()) / 2 * distance
        eye = target - forward * distance
        eye, forward, right, up = _tuples(eye, forward, right * half * aspect, up * half)
        return cls(eye, forward, right, up)


def _axes(eye: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    if eye.shape != (3,) or target.shape != (3,):
        raise InputError("camera: eye and target have 3 coordinates each")
    forward = target - eye
    length = float(np.linalg.norm(forward))
    if not (math.isfinite(length) and length > 0):
        raise InputError(f"camera.target: {target.tolist()} gives no direction from the eye at {eye.tolist()}")
    forward = forward / length
    # Straight down, the top of the picture is +y.
    upward = np.array([0.0, 0.0, 1.0]) if abs(forward[2]) < 0.9999 else np.array([0.0, 1.0, 0.0])
    right = np.cross(forward, upward)
    right = right / np.linalg.norm(right)
    return forward, right, np.cross(right, forward)


def _check_lens(fov: float, aspect: float) -> None:
    if not 0 < fov < math.pi:
        raise InputError(f"camera.fov: {fov} rad is not between 0 and pi")
    if not (math.isfinite(aspect) and aspect > 0):
        raise InputError(f"camera.aspect: {aspect} is not a number above 0")


def _tuples(*vectors) -> list[tuple[float, float, float]]:
    return [(float(v[0]), float(v[1]), float(v[2])) for v in vectors]
