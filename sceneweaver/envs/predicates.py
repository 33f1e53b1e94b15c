"""When a task is done: geometry alone, no contacts. Arrays may have any leading dimensions, which broadcast.

Poses are [..., 7]: position [m] and a unit quaternion (w, x, y, z), as MuJoCo has them.
"""

from __future__ import annotations

import numpy as np

Array = np.ndarray

FACING = np.pi / 6
"""[rad] off its bearing to a thing, at most, a base looks at it."""

LEVEL = 0.02
"""[m] off the height of a surface, at most, a thing rests on it."""

_NEXT, _LAST = [1, 2, 0], [2, 0, 1]  # axes after and before each


def to_local(poses: Array, points: Array) -> Array:
    """World points [..., 3] in the frames of poses [..., 7]."""
    return rotate(poses[..., 3:] * np.array([1.0, -1, -1, -1]), points - poses[..., :3])


def to_world(poses: Array, points: Array) -> Array:
    """Points [..., 3] in the frames of poses [..., 7] as world points."""
    return rotate(poses[..., 3:], points) + poses[..., :3]


def rotate(quaternions: Array, vectors: Array) -> Array:
    """Vectors [..., 3] turned by unit quaternions [..., 4], real part first."""
    w, axis = quaternions[..., :1], quaternions[..., 1:]
    return vectors + 2 * _cross(axis, _cross(axis, vectors) + w * vectors)


def turned(vector: Array, angle: float) -> Array:
    """A vector of the plane [2] turned by ``angle`` [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def _cross(a: Array, b: Array) -> Array:
    """As `numpy.cross`, many times as quick for a few vectors."""
    return a[..., _NEXT] * b[..., _LAST] - a[..., _LAST] * b[..., _NEXT]


def product(a: Array, b: Array) -> Array:
    """The rotation b followed by a, quaternions [..., 4], real part first."""
    w, x, y, z = np.moveaxis(np.asarray(a, dtype=float), -1, 0)
    p, q, r, s = np.moveaxis(np.asarray(b, dtype=float), -1, 0)
    parts = (
        w * p - x * q - y * r - z * s,
        w * q + x * p + y * s - z * r,
        w * r - x * s + y * p + z * q,
        w * s + x * r - y * q + z * p,
    )
    return np.stack(parts, axis=-1)


def open_share(position: Array | float, open_end: Array | float) -> Array:
    """How far joints are open: 0 closed, 1 at the end ``open_end`` of their range."""
    return np.clip(np.asarray(position) / np.asarray(open_end), 0.0, 1.0)


def is_inside(point: Array, pose: Array, low: Array, high: Array, oval: Array | bool = False) -> Array:
    """Whether world points [..., 3] are in boxes ``low`` to ``high`` [..., 3] of frames ``pose`` [..., 7].

    Of an ``oval`` one only the upright elliptic cylinder in the box counts.
    """
    share = (to_local(pose, point) - (low + high) / 2) / np.maximum((high - low) / 2, 1e-9)
    within = (np.abs(share) <= 1).all(axis=-1)
    return within & (~np.asarray(oval) | ((share[..., :2] ** 2).sum(axis=-1) <= 1))


def is_on(bottom: Array, pose: Array, low: Array, high: Array, z: Array | float, tolerance: float = LEVEL) -> Array:
    """Whether the lowest points of things [..., 3] lie on surfaces: over their plan ``low`` to ``high`` [..., 2] and at
    most ``tolerance`` [m] off their height ``z`` in the frame ``pose`` [..., 7].
    """
    local = to_local(pose, bottom)
    over = ((local[..., :2] >= low) & (local[..., :2] <= high)).all(axis=-1)
    return over & (np.abs(local[..., 2] - z) <= tolerance)


def is_near(point: Array, other: Array, within: Array | float) -> Array:
    """Whether points [..., 3] are at most ``within`` [m] from others."""
    return np.linalg.norm(np.asarray(point) - other, axis=-1) <= within


def bearing_off(base: Array, point: Array) -> Array:
    """By how much [rad] bases [..., 3] (x, y, yaw) look past points [..., 2], 0 to pi."""
    bearing = np.arctan2(point[..., 1] - base[..., 1], point[..., 0] - base[..., 0])
    return np.abs((bearing - base[..., 2] + np.pi) % (2 * np.pi) - np.pi)


def faces(base: Array, point: Array, within: float = FACING) -> Array:
    """Whether bases [..., 3] (x, y, yaw) look at points [..., 2] to ``within`` [rad]."""
    return bearing_off(base, point) <= within


def distance_to_box(point: Array, pose: Array, low: Array, high: Array) -> Array:
    """Distance [m] in the plane from points [..., 2] to the plans of upright boxes in frames ``pose`` [..., 7]."""
    flat = np.concatenate([point, np.broadcast_to(pose[..., 2:3], (*point.shape[:-1], 1))], axis=-1)
    local = to_local(pose, flat)[..., :2]
    gap = np.maximum(np.maximum(low[..., :2] - local, local - high[..., :2]), 0.0)
    return np.linalg.norm(gap, axis=-1)
