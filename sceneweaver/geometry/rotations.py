"""Rotations of space as unit quaternions (x, y, z, w); MuJoCo and USD have w first, see `wxyz`.

One quaternion is plain arithmetic, in the order of scipy's ``Rotation`` so that both agree in every bit; that takes
about 20 us a call, so arrays of them and all else are left to it. Quaternions may be of any length above zero.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

Quaternion = tuple[float, float, float, float]
Vector = tuple[float, float, float]


def from_yaw(yaw: float) -> Quaternion:
    """The rotation by ``yaw`` [rad] about +z."""
    return 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)


def yaw_of(quaternion: Sequence[float]) -> float:
    """Direction [rad] in (-pi, pi] in which a unit quaternion turns +x, seen from above."""
    x, y, z, w = quaternion
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def tilt_of(quaternion: Sequence[float]) -> float:
    """Angle [rad] between +z and where a unit quaternion turns it."""
    x, y, _, _ = quaternion
    return math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y))))


def is_upright(quaternion: Sequence[float], tolerance: float = 1e-9) -> bool:
    """Whether x and y of a quaternion are at most ``tolerance``, which is half the tilt that it allows [rad]."""
    return abs(quaternion[0]) <= tolerance and abs(quaternion[1]) <= tolerance


def wxyz(quaternion: Sequence[float]) -> Quaternion:
    """A quaternion (x, y, z, w) with its real part first."""
    x, y, z, w = quaternion
    return w, x, y, z


def xyzw(quaternions: Any) -> Any:
    """Quaternions [..., 4] (w, x, y, z) with their real parts last, as an array."""
    import numpy as np

    return np.roll(np.asarray(quaternions, dtype=float), -1, axis=-1)


def multiply(a: Sequence[float], b: Sequence[float]) -> Quaternion:
    """The rotation b followed by a."""
    (ax, ay, az, aw), (bx, by, bz, bw) = _unit(a), _unit(b)
    cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    x, y, z = aw * bx + bw * ax + cx, aw * by + bw * ay + cy, aw * bz + bw * az + cz
    return _unit((x, y, z, aw * bw - ax * bx - ay * by - az * bz))


def inverse(quaternion: Sequence[float]) -> Quaternion:
    """The opposite rotation of a unit quaternion."""
    x, y, z, w = quaternion
    return -x, -y, -z, w


def rotate(quaternion: Sequence[float], vector: Sequence[float]) -> Vector:
    """A vector [3] turned."""
    import numpy as np

    x, y, z = (_matrix(quaternion) @ np.asarray(vector, dtype=float)).tolist()
    return x, y, z


def matrix(quaternions: Any) -> Any:
    """Rotation matrices [..., 3, 3] of quaternions [..., 4]."""
    import numpy as np

    given = np.asarray(quaternions, dtype=float)
    if given.ndim == 1:
        return _matrix(given.tolist())
    return _rotation(given.reshape(-1, 4)).as_matrix().reshape(*given.shape[:-1], 3, 3)


def from_matrix(turn: Any) -> Quaternion:
    """The rotation of a rotation matrix [3, 3]."""
    from scipy.spatial.transform import Rotation

    return _four(Rotation.from_matrix(turn))


def euler(angles: Any, axes: str = "XYZ") -> Any:
    """The matrix [3, 3] of turns [rad] one after the other about moving axes (capitals) or fixed ones."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_euler(axes, angles).as_matrix()


def transform(poses: Any, points: Any) -> Any:
    """World points [..., 3] of points [..., 3] in the frames of poses [..., 7]: x, y, z and a quaternion of any length.

    What is not finite stays so, as the poses of a simulation that diverged.
    """
    import numpy as np

    axis, w = poses[..., 3:6], poses[..., 6:7]
    turned = np.cross(axis, np.cross(axis, points) + w * points)
    return points + 2 * turned / (poses[..., 3:] ** 2).sum(-1, keepdims=True) + poses[..., :3]


def _unit(quaternion: Sequence[float]) -> Quaternion:
    x, y, z, w = map(float, quaternion)
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if length == 0.0:
        raise ValueError("a quaternion of length 0 is no rotation")
    return x / length, y / length, z / length, w / length


def _matrix(quaternion: Sequence[float]) -> Any:
    """The rotation matrix [3, 3] of one quaternion."""
    import numpy as np

    x, y, z, w = _unit(quaternion)
    xx, yy, zz, ww = x * x, y * y, z * z, w * w
    xy, zw, xz, yw, yz, xw = x * y, z * w, x * z, y * w, y * z, x * w
    return np.array(
        (
            (xx - yy - zz + ww, 2 * (xy - zw), 2 * (xz + yw)),
            (2 * (xy + zw), -xx + yy - zz + ww, 2 * (yz - xw)),
            (2 * (xz - yw), 2 * (yz + xw), -xx - yy + zz + ww),
        )
    )


def _rotation(quaternion: Any) -> Any:
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(quaternion)


def _four(rotation: Any) -> Quaternion:
    x, y, z, w = rotation.as_quat().tolist()
    return x, y, z, w
