"""Where a picture is taken from, and cameras as others write them down: K in pixels, poses of Blender and OpenCV."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.io import reason
from sceneweaver.scene import InputError


@dataclass(frozen=True)
class Camera:
    """A camera in the world: ``forward`` leads to the middle of the picture at distance 1 along the optical axis.

    It is the axis itself, a unit vector, unless the lens is shifted. ``right`` and ``up`` span half the picture at that
    distance; of a flat camera (no perspective), half of it in metres.
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
    def level(cls, eye, yaw: float, fov: float, aspect: float = 1.0, shift: float = 0.0) -> Camera:
        """A perspective camera that looks level, so that upright lines are upright in the picture.

        Args:
            eye: Where it is [3] in metres.
            yaw: Direction of its optical axis [rad].
            fov: The whole horizontal angle [rad].
            aspect: Width over height.
            shift: How far the lens is shifted, in half heights of the picture: above 0 it shows more of the ceiling.

        Raises:
            InputError: ``eye``, ``yaw`` or ``shift`` is not finite, or ``fov`` is not between 0 and pi.
        """
        _check_lens(fov, aspect)
        eye = np.asarray(eye, dtype=float)
        if eye.shape != (3,) or not np.isfinite([*eye, yaw, shift]).all():
            raise InputError(f"camera: eye {eye.tolist()}, yaw {yaw} and shift {shift} are not all finite")
        half = math.tan(fov / 2)
        axis = np.array([math.cos(yaw), math.sin(yaw), 0.0])
        right, up = np.array([axis[1], -axis[0], 0.0]) * half, np.array([0.0, 0.0, half / aspect])
        eye, forward, right, up = _tuples(eye, axis + shift * up, right, up)
        return cls(eye, forward, right, up)

    def rays(self, width: int, height: int) -> np.ndarray:
        """Unit vectors [height, width, 3] of the rays through the middles of the pixels."""
        way = np.broadcast_to(np.asarray(self.forward), (height, width, 3))
        way = way if self.flat else way + self._across(width, height)
        return way / np.linalg.norm(way, axis=-1, keepdims=True)

    def origins(self, width: int, height: int) -> np.ndarray:
        """Where those rays begin, [height, width, 3] or [3] in metres."""
        eye = np.asarray(self.eye)
        return eye + self._across(width, height) if self.flat else eye

    def project(self, points: np.ndarray) -> np.ndarray:
        """Where points [N, 3] are in the picture, [N, 3]: to the right and up in -1..1, and depth along the axis [m].

        Points behind a perspective camera have a negative depth.
        """
        axis, right, up = self.axis, np.asarray(self.right), np.asarray(self.up)
        rel = np.asarray(points, dtype=float) - np.asarray(self.eye)
        depth = rel @ axis
        scale = np.ones_like(depth) if self.flat else np.where(np.abs(depth) < 1e-12, 1e-12, depth)
        middle = np.zeros(3) if self.flat else np.asarray(self.forward)
        u, v = (rel @ side / scale - middle @ side for side in (right / (right @ right), up / (up @ up)))
        return np.stack([u, v, depth], axis=1)

    def _across(self, width: int, height: int) -> np.ndarray:
        x = 2 * (np.arange(width) + 0.5) / width - 1
        y = 1 - 2 * (np.arange(height) + 0.5) / height
        return x[None, :, None] * np.asarray(self.right) + y[:, None, None] * np.asarray(self.up)

    @property
    def axis(self) -> np.ndarray:
        """Unit vector [3] along the optical axis."""
        across = np.cross(self.up, self.right)
        return across / np.linalg.norm(across)

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


MAX_SIDE = 8192
"""Most pixels along a side of a picture."""

SENSOR = 36.0
"""Width of 35 mm film [mm], for which focal lengths are given."""

_FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


@dataclass(frozen=True)
class Shot:
    """A camera with a name and the size of its pictures [pixels]."""

    name: str
    camera: Camera
    width: int
    height: int

    @property
    def k(self) -> np.ndarray:
        """The matrix K [3, 3] in pixels; (0, 0) is the outer corner of the upper left pixel, (0.5, 0.5) its middle.

        The third column holds the optical centre, which is not the middle of the picture where the lens is shifted.
        """
        camera = self.camera
        right, up, forward = (np.asarray(v) for v in (camera.right, camera.up, camera.forward))
        fx, fy = self.width / 2 / np.linalg.norm(right), self.height / 2 / np.linalg.norm(up)
        cx = self.width / 2 * (1 - forward @ right / (right @ right))
        cy = self.height / 2 * (1 + forward @ up / (up @ up))
        return np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])

    @property
    def camera_to_world(self) -> np.ndarray:
        """The pose [4, 4] with Blender's axes of a camera: x to the right, y up, z backward."""
        pose = np.eye(4)
        right, up = np.asarray(self.camera.right), np.asarray(self.camera.up)
        pose[:3, 0], pose[:3, 1] = right / np.linalg.norm(right), up / np.linalg.norm(up)
        pose[:3, 2], pose[:3, 3] = -self.camera.axis, self.camera.eye
        return pose

    @property
    def camera_to_world_opencv(self) -> np.ndarray:
        """The pose [4, 4] with OpenCV's axes: x to the right, y down, z forward."""
        return self.camera_to_world @ _FLIP

    def to_dict(self) -> dict[str, Any]:
        """Everything for a JSON file; `shot_from` reads it."""
        k = self.k
        opencv = self.camera_to_world_opencv
        return {
            "name": self.name,
            "width": self.width,
            "height": self.height,
            "fx": k[0, 0],
            "fy": k[1, 1],
            "cx": k[0, 2],
            "cy": k[1, 2],
            "K": k.tolist(),
            "optical_centre": k[:2, 2].tolist(),
            "focal_length_mm": k[0, 0] * SENSOR / self.width,
            "sensor_width_mm": SENSOR,
            "shift_x": (self.width / 2 - k[0, 2]) / self.width,
            "shift_y": (k[1, 2] - self.height / 2) / self.width,
            "position": list(self.camera.eye),
            "camera_to_world_blender": self.camera_to_world.tolist(),
            "camera_to_world_opencv": opencv.tolist(),
            "world_to_camera_opencv": np.linalg.inv(opencv).tolist(),
        }


def shot_from(data: Any, name: str, width: int, height: int) -> Shot:
    """A camera from JSON data.

    Args:
        data: Either ``K`` (or ``fx, fy, cx, cy``) with ``camera_to_world_opencv`` or ``camera_to_world_blender``; or
            ``eye`` and ``target`` [m] with ``fov``, the whole horizontal angle in degrees (60). It may have a ``name``,
            ``width`` and ``height``.
        name: Its name if it has none.
        width: Width of its pictures [pixels] if it has none.
        height: Their height.

    Raises:
        InputError: something is missing or makes no camera; the text begins with ``name``.
    """
    if not isinstance(data, dict):
        raise InputError(f"{name}: is no object with eye and target, or K and camera_to_world_opencv")
    try:
        label = str(data.get("name", name))
        width, height = int(data.get("width", width)), int(data.get("height", height))
        if not (0 < width <= MAX_SIDE and 0 < height <= MAX_SIDE):
            raise ValueError(f"width and height have to be from 1 to {MAX_SIDE} pixels")
        if "eye" in data or "target" in data:
            angle = math.radians(float(data.get("fov", 60.0)))
            aspect = width / height
            upright = 2 * math.atan(math.tan(angle / 2) / aspect)
            return Shot(label, Camera.look_at(data["eye"], data["target"], upright, aspect), width, height)
        k = data["K"] if "K" in data else [[data["fx"], 0, data["cx"]], [0, data["fy"], data["cy"]], [0, 0, 1]]
        if "camera_to_world_opencv" in data:
            pose = np.asarray(data["camera_to_world_opencv"], dtype=float)
        else:
            pose = np.asarray(data["camera_to_world_blender"], dtype=float) @ _FLIP
        return Shot(label, _camera(np.asarray(k, dtype=float), pose, width, height), width, height)
    except KeyError as error:
        raise InputError(f"{name}: has no {error}; give eye and target, or K and camera_to_world_opencv") from None
    except (TypeError, ValueError, ArithmeticError) as error:  # also an infinite number of pixels
        raise InputError(f"{name}: makes no camera ({reason(error)})") from None


def _camera(k: np.ndarray, pose: np.ndarray, width: int, height: int) -> Camera:
    if k.shape != (3, 3) or pose.shape != (4, 4) or not (np.isfinite(k).all() and np.isfinite(pose).all()):
        raise ValueError("K is no finite 3 x 3 matrix, or the pose no 4 x 4 one")
    turn = pose[:3, :3]
    if not np.allclose(turn @ turn.T, np.eye(3), atol=1e-4) or np.linalg.det(turn) < 0:
        raise ValueError("the pose is no rotation")
    fx, fy, cx, cy = k[0, 0], k[1, 1], k[0, 2], k[1, 2]
    if not (fx > 0 and fy > 0):
        raise ValueError("fx and fy have to be above 0")
    x, y, z = turn.T
    right, up = x * (width / 2 / fx), -y * (height / 2 / fy)
    forward = z + x * ((width / 2 - cx) / fx) + y * ((height / 2 - cy) / fy)
    eye, forward, right, up = ((float(v[0]), float(v[1]), float(v[2])) for v in (pose[:3, 3], forward, right, up))
    return Camera(eye, forward, right, up)
