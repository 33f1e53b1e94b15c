"""Cameras as others write them down: a matrix K in pixels, and poses as Blender and OpenCV have them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.scene import InputError

from .camera import Camera

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
    except (TypeError, ValueError, ZeroDivisionError) as error:
        raise InputError(f"{name}: makes no camera ({error})") from None


def _camera(k: np.ndarray, pose: np.ndarray, width: int, height: int) -> Camera:
    if k.shape != (3, 3) or pose.shape != (4, 4) or not (np.isfinite(k).all() and np.isfinite(pose).all()):
        raise ValueError("K is no finite 3 x 3 matrix, or the pose no 4 x 4 one")
    turn = pose[:3, :3]
    if not np.allclose(turn @ turn.T, np.eye(3), atol=1e-4) or np.linalg.det(turn) < 0:
        raise ValueError("the pose is no rotation")
    fx, fy, cx, cy = k[0, 0], k[1, 1], k[0, 2], k[1, 2]
    if not (fx > 0 and fy > 0 and width > 0 and height > 0):
        raise ValueError("fx, fy, width and height have to be above 0")
    x, y, z = turn.T
    right, up = x * (width / 2 / fx), -y * (height / 2 / fy)
    forward = z + x * ((width / 2 - cx) / fx) + y * ((height / 2 - cy) / fy)
    eye, forward, right, up = ((float(v[0]), float(v[1]), float(v[2])) for v in (pose[:3, 3], forward, right, up))
    return Camera(eye, forward, right, up)
