"""Triangles on a device, the first hits of rays of cameras on them, and kernels over many threads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.runtime.compiling import load, start_warp
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.runtime.threads import cores, map_threads
from sceneweaver.scene import InputError, MissingDependencyError

from ..camera import Camera
from . import ray_kernels

MAX_RAYS = 64_000_000
"""Rays of one call, or pixels of one picture."""

_BANDS = 8  # to a thread: between them a time limit is looked at


@dataclass(frozen=True)
class Hits:
    """What the rays met: ``face`` int32 [C, H, W], -1 where nothing; ``distance`` float32 [C, H, W] along the ray [m],
    inf where nothing; ``bary`` float32 [C, H, W, 2], the shares of the first two corners of the triangle."""

    face: np.ndarray
    distance: np.ndarray
    bary: np.ndarray


class Triangles:
    """Triangles to cast rays on: ``vertices`` [V, 3] in metres, ``faces`` [F, 3], of which the first ``opaque`` hide
    what is behind them (None: all).

    Attributes:
        meshes: Both kinds as a struct for kernels; valid as long as this object lives.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray, device: str = "cpu", opaque: int | None = None) -> None:
        self.device = device
        first, rest = np.split(np.asarray(faces), [len(faces) if opaque is None else opaque])
        if not len(first):  # a speck far below everything: a kernel needs some mesh
            vertices = np.concatenate([vertices, [(0, 0, -1e6), (1e-3, 0, -1e6), (0, 1e-3, -1e6)]])
            first = len(vertices) - 3 + np.arange(3)
        self.meshes = ray_kernels.Meshes()
        with wp.ScopedDevice(device):
            points = wp.array(np.asarray(vertices), dtype=wp.vec3)
            self._kept = [_mesh(points, first)]
            self.meshes.solid = self._kept[0].id
            self.meshes.clear_start, self.meshes.clear_count = len(faces) - len(rest), len(rest)
            if len(rest):
                self._kept.append(_mesh(points, rest))
                self.meshes.clear = self._kept[1].id

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
            lenses = wp.array([lens_of(camera, width, height) for camera in cameras], dtype=ray_kernels.Lens)
            face, distance = wp.empty(rays, dtype=int), wp.empty(rays, dtype=float)
            bary = wp.empty(rays, dtype=wp.vec2)  # pyright: ignore[reportArgumentType]
            launch(ray_kernels.first_hits, rays, [self.meshes, lenses], [face, distance, bary])
            shape = (len(cameras), height, width)
            found, far = face.numpy().reshape(shape), distance.numpy().reshape(shape)
            return Hits(found, np.where(found >= 0, far, np.float32(np.inf)), bary.numpy().reshape(*shape, 2))


def _mesh(points: wp.array, faces: np.ndarray) -> wp.Mesh:
    return wp.Mesh(points=points, indices=wp.array(faces.reshape(-1), dtype=int), bvh_leaf_size=4)


def lens_of(camera: Camera, width: int, height: int) -> Any:
    """A camera with the size of its picture in pixels, as a struct for kernels."""
    lens = ray_kernels.Lens()
    for key in ("eye", "forward", "right", "up"):
        setattr(lens, key, wp.vec3(*getattr(camera, key)))
    lens.flat, lens.width, lens.height = int(camera.flat), width, height
    return lens


def check_device(device: str) -> None:
    """MissingDependencyError for a device that is not there."""
    start_warp()
    known = {"cpu", *(found.alias for found in wp.get_cuda_devices())}
    if device not in known and not (device == "cuda" and wp.is_cuda_available()):
        raise MissingDependencyError(f'device: "{device}" is not there; use device="cpu"')


def load_kernels(device: str, *modules: ModuleType) -> int:
    """Compile and load modules of kernels ahead of their first launch; returns how many were compiled."""
    return load(device, [wp.get_module(module.__name__) for module in modules])


def launch(kernel: Any, count: int, before: list, after: list) -> None:
    """Run a kernel over ``count`` threads; the number of the first stands between its arguments.

    At once on a GPU; on the CPU, where a kernel has one thread, in bands over Python threads.
    """
    checkpoint()
    if count == 0:
        return
    device = wp.get_device()
    load(str(device), [kernel.module])
    threads = cores()
    if not device.is_cpu or count < 4096:
        wp.launch(kernel, count, [*before, 0, *after], device=device)
        return
    wp.launch(kernel, 1, [*before, 0, *after], device=device)  # what Warp does once, before there are threads
    cuts = np.linspace(0, count, _BANDS * threads + 1).astype(int)

    def work(k: int) -> None:
        size = int(cuts[k + 1] - cuts[k])
        wp.launch(kernel, size, [*before, int(cuts[k]), *after], device=device)

    map_threads(work, range(_BANDS * threads), threads)
