"""Rigid motions of the plane: the frame of an upright object, of a wall, of a grid."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from .angles import wrap_angle


@dataclass(frozen=True)
class SE2:
    """A frame at (x, y) [m], turned by ``yaw`` [rad]; as a motion it turns about the origin, then moves.

    ``axis`` is the unit vector of the frame's +x in the world.
    """

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    axis: tuple[float, float] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Work out the axis once."""
        object.__setattr__(self, "axis", (math.cos(self.yaw), math.sin(self.yaw)))

    def world(self, u: Any, v: Any) -> tuple[Any, Any]:
        """World coordinates of what is at (u, v) of the frame; floats, or arrays of one shape."""
        c, s = self.axis
        return self.x + c * u - s * v, self.y + s * u + c * v

    def local(self, x: Any, y: Any) -> tuple[Any, Any]:
        """Coordinates in the frame of what is at (x, y) of the world; floats, or arrays of one shape."""
        c, s = self.axis
        dx, dy = x - self.x, y - self.y
        return c * dx + s * dy, c * dy - s * dx

    def to_world(self, points: Any) -> Any:
        """World points [..., 2] of points [..., 2] of the frame."""
        import numpy as np

        c, s = self.axis
        return np.asarray(points, dtype=float) @ np.array(((c, s), (-s, c))) + (self.x, self.y)

    def to_local(self, points: Any) -> Any:
        """Points [..., 2] of the frame of world points [..., 2]."""
        import numpy as np

        c, s = self.axis
        return (np.asarray(points, dtype=float) - (self.x, self.y)) @ np.array(((c, -s), (s, c)))

    def inverse(self) -> SE2:
        """The motion that undoes this one: the world as seen from the frame."""
        return SE2(*self.local(0.0, 0.0), -self.yaw)

    def __matmul__(self, inner: SE2) -> SE2:
        """``inner``, a frame in this frame, as a frame in the world; the yaw is wrapped to [-pi, pi]."""
        return SE2(*self.world(inner.x, inner.y), wrap_angle(self.yaw + inner.yaw))


def relative(poses: Any, frames: Any) -> Any:
    """World poses [..., 4] (x, y, z, yaw) as seen from frames [..., 4] that stand upright; yaws in [-pi, pi]."""
    import numpy as np

    c, s = np.cos(frames[..., 3]), np.sin(frames[..., 3])
    d = poses - frames
    x, y = c * d[..., 0] + s * d[..., 1], c * d[..., 1] - s * d[..., 0]
    return np.stack([x, y, d[..., 2], wrap_angle(d[..., 3])], axis=-1)


def absolute(local: Any, frames: Any) -> Any:
    """The inverse of `relative`: world poses [..., 4] of poses [..., 4] in frames [..., 4]."""
    import numpy as np

    c, s = np.cos(frames[..., 3]), np.sin(frames[..., 3])
    x = frames[..., 0] + c * local[..., 0] - s * local[..., 1]
    y = frames[..., 1] + s * local[..., 0] + c * local[..., 1]
    return np.stack([x, y, frames[..., 2] + local[..., 2], wrap_angle(local[..., 3] + frames[..., 3])], axis=-1)
