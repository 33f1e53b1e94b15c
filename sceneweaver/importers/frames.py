"""Between the frames of other systems and ours: handedness, up axis, fronts, angles, matrices.

Ours: right-handed, z up, metres, yaw counter-clockwise about +z, an object's front along +x of its own frame.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

Array = np.ndarray

Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From right-handed y up (glTF, 3D-FRONT, Habitat) to z up: (x, y, z) becomes (x, -z, y). A rotation."""

UNITY = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""From left-handed y up (Unity, AI2-THOR) to ours: (x, y, z) becomes (x, z, y). A reflection."""

AXES = {
    "x": (1.0, 0.0, 0.0),
    "-x": (-1.0, 0.0, 0.0),
    "y": (0.0, 1.0, 0.0),
    "-y": (0.0, -1.0, 0.0),
    "z": (0.0, 0.0, 1.0),
    "-z": (0.0, 0.0, -1.0),
}


def points(frame: Array, values: Sequence[Sequence[float]] | Array) -> Array:
    """Points [n, 3] of another frame in ours."""
    return np.asarray(values, dtype=float) @ frame.T


def rotation(frame: Array, other: Array) -> Array:
    """A rotation [3, 3] between vectors of another frame as one between vectors of ours; reflections are undone."""
    return frame @ np.asarray(other, dtype=float) @ frame.T


def yaw_matrix(yaw: float) -> Array:
    """The rotation [3, 3] by ``yaw`` [rad] counter-clockwise about +z."""
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def yaw_of(matrix: Array) -> float:
    """Direction [rad] in (-pi, pi] in which a rotation [3, 3] turns +x, seen from above."""
    return math.atan2(float(matrix[1, 0]), float(matrix[0, 0]))


def facing(front: str, up: str = "z") -> Array:
    """The rotation [3, 3] from a model's own frame to an object's: its ``front`` becomes +x, its ``up`` becomes +z.

    Both are one of `AXES`; with ``m`` the matrix of the model in the room, the object's rotation is
    ``m @ facing(front, up).T``.
    """
    x, z = np.array(AXES[front]), np.array(AXES[up])
    return np.stack((x, np.cross(z, x), z))


def quaternion_matrix(quaternion: Sequence[float], order: str = "xyzw") -> Array:
    """The rotation [3, 3] of a quaternion of any length above 0, written x, y, z, w or w, x, y, z."""
    q = np.asarray(quaternion, dtype=float)
    w, x, y, z = q if order == "wxyz" else q[[3, 0, 1, 2]]
    n = w * w + x * x + y * y + z * z
    if not n > 0 or not math.isfinite(n):
        raise ValueError("a quaternion of length 0")
    s = 2.0 / n
    return np.array(
        [
            [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)],
        ]
    )


def matrix_quaternion(matrix: Array) -> tuple[float, float, float, float]:
    """The unit quaternion (x, y, z, w) of a rotation [3, 3]; upright ones have x = y = 0 exactly."""
    m = np.asarray(matrix, dtype=float)
    if abs(m[2, 2] - 1.0) < 1e-9:
        half = yaw_of(m) / 2
        return 0.0, 0.0, math.sin(half), math.cos(half)
    from scipy.spatial.transform import Rotation

    x, y, z, w = (float(v) for v in Rotation.from_matrix(m).as_quat(canonical=True))
    return x, y, z, w


def euler_matrix(degrees: Sequence[float], order: str = "xyz") -> Array:
    """The rotation [3, 3] of angles [degrees] about fixed axes, in the order given (lower case), as scipy has it."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_euler(order, [float(v) for v in degrees], degrees=True).as_matrix()


def affine(values: Sequence[float] | Array, *, column_major: bool = False) -> tuple[Array, Array, Array]:
    """Translation [3], rotation [3, 3] and scale [3] of a 4 x 4 matrix given as 16 numbers or four rows.

    Raises:
        ValueError: it is no such matrix, singular, or sheared by more than 1 %.
    """
    m = np.asarray(values, dtype=float)
    if m.size != 16 or not np.isfinite(m).all():
        raise ValueError("a matrix needs 16 finite numbers")
    m = m.reshape(4, 4)
    m = m.T if column_major else m
    linear = m[:3, :3]
    scale = np.linalg.norm(linear, axis=0)
    if scale.min() < 1e-9:
        raise ValueError("a matrix that flattens its object")
    turn = linear / scale
    if np.abs(turn.T @ turn - np.eye(3)).max() > 0.01:
        raise ValueError("a matrix that shears its object")
    if np.linalg.det(turn) < 0:
        raise ValueError("a matrix that mirrors its object")
    u, _, vt = np.linalg.svd(turn)
    return m[:3, 3].copy(), u @ vt, scale
