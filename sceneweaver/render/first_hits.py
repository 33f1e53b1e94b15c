"""First hits of the rays of several cameras on a set of triangles, on the CPU or a GPU: no light, no materials."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.runtime.threads import cores, map_threads
from sceneweaver.scene import InputError

from . import first_hit_kernels as kernels
from .camera import Camera

MAX_RAYS = 64_000_000
"""Rays of one call: pictures times pixels."""


@dataclass(frozen=True)
class Hits:
    """What the rays met: ``face`` int32 [C, H, W], -1 where nothing; ``distance`` float32 [C, H, W] along the ray [m],
    inf where nothing; ``bary`` float32 [C, H, W, 2], the shares of the first two corners of the triangle."""

    face: np.ndarray
    distance: np.ndarray
    bary: np.ndarray


class Triangles:
    """Triangles to cast rays on: ``vertices`` [V, 3] in metres, ``faces`` [F, 3]; kept for several calls."""

    def __init__(self, vertices: np.ndarray, faces: np.ndarray, device: str = "cpu") -> None:
        self.device = device
        with wp.ScopedDevice(device):
            self._mesh = wp.Mesh(
                points=wp.array(np.asarray(vertices), dtype=wp.vec3),
                indices=wp.array(np.asarray(faces).reshape(-1), dtype=int),
                bvh_leaf_size=8,
            )

    def first_hits(self, cameras: Sequence[Camera], width: int, height: int) -> Hits:
        """The first hits of one ray through the middle of each pixel of each camera's picture.

        Raises:
            InputError: there is no camera or no pixel, or more than `MAX_RAYS` rays.
        """
        rays = len(cameras) * width * height
        if min(len(cameras), width, height) < 1 or rays > MAX_RAYS:
            raise InputError(
                f"pictures: {len(cameras)} of {width} x {height} pixels; between 1 and {MAX_RAYS} rays are cast"
            )
        with wp.ScopedDevice(self.device):
            views = wp.array([_view(camera) for camera in cameras], dtype=kernels.View)
            face = wp.empty(rays, dtype=int)
            numbers = [wp.empty(rays, dtype=float) for _ in range(3)]

            def launch(start: int, count: int) -> None:
                inputs = [self._mesh.id, views, width, height, start]
                wp.launch(kernels.first_hits, count, inputs, [face, *numbers], device=self.device)

            threads = cores() if wp.get_device(self.device).is_cpu else 1
            if threads == 1 or rays < 4096:
                launch(0, rays)
            else:
                launch(0, 1)  # compiles and loads the kernel before there are threads
                cuts = np.linspace(0, rays, 4 * threads + 1).astype(int)
                map_threads(lambda k: launch(int(cuts[k]), int(cuts[k + 1] - cuts[k])), range(4 * threads), threads)
            shape = (len(cameras), height, width)
            found = face.numpy().reshape(shape)
            distance, u, v = (array.numpy().reshape(shape) for array in numbers)
        return Hits(found, np.where(found >= 0, distance, np.float32(np.inf)), np.stack([u, v], axis=-1))


def _view(camera: Camera):
    view = kernels.View()
    for key in ("eye", "forward", "right", "up"):
        setattr(view, key, wp.vec3(*getattr(camera, key)))
    view.flat = int(camera.flat)
    return view
