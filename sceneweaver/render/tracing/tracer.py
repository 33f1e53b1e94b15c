"""Pictures with the light of the real world: several bounces, sun and sky by the windows, lamps, gloss and mirrors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.scene import InputError

from ..camera import Camera
from ..caster import Instance, check_device
from ..raycast_kernels import Lens
from . import develop_kernels, filter_kernels, view_kernels
from .bands import launch
from .cache import build_cache
from .exposure import exposed
from .lights import Lights
from .world import bounds_of, collect, lights_on, seen_of, world_on

_MAX_PIXELS = 64_000_000
_OUTSIDE = 2.4  # what the horizon is at most, as white is 1: photographers balance what is outside with the room


@dataclass(frozen=True)
class TraceQuality:
    """Rays of each kind at a pixel that is lit, and how many pixels there are to one that is.

    ``windows``, ``lamps``, ``bounces`` and ``suns`` are rays to the sky, to lamps, to other surfaces and to the sun;
    every ``spacing``-th pixel of each row and column is lit. ``levels`` is how often the light is smoothed, each time
    over twice the distance. ``rays`` are those of a pixel where something ends.
    """

    windows: int = 4
    lamps: int = 3
    bounces: int = 4
    suns: int = 2
    spacing: int = 1
    levels: int = 3
    rays: int = 6
    plain_rays: int = 1

    def __post_init__(self) -> None:
        least = {"levels": 0}
        for field in fields(self):
            value = getattr(self, field.name)
            if value < least.get(field.name, 1):
                raise InputError(f"quality.{field.name}: {value} is too few")

    @classmethod
    def draft(cls) -> TraceQuality:
        """For a quick look."""
        return cls(windows=3, lamps=2, bounces=4, suns=2, spacing=2, levels=3, rays=4)

    @classmethod
    def normal(cls) -> TraceQuality:
        """To show."""
        return cls()

    @classmethod
    def fine(cls) -> TraceQuality:
        """For a front page."""
        return cls(windows=12, lamps=8, bounces=24, suns=8, levels=3, rays=16, plain_rays=4)


@dataclass(frozen=True)
class TracedPicture:
    """What was seen, [H, W] each.

    ``rgb`` uint8 [H, W, 3] is exposed and tone mapped, ``linear`` float32 [H, W, 3] is neither. Of the first surface in
    the middle of a pixel: ``instance`` int32 is its number or -1, ``distance`` float32 [m] that along the ray and
    ``depth`` that along the camera's axis, inf for nothing; ``position`` and ``normal`` float32 [H, W, 3] in the
    world's frame, the normal turned to the camera; ``albedo`` float32 [H, W, 3] its linear base colour.
    """

    rgb: np.ndarray
    linear: np.ndarray
    instance: np.ndarray
    distance: np.ndarray
    depth: np.ndarray
    position: np.ndarray
    normal: np.ndarray
    albedo: np.ndarray


class Tracer:
    """A scene on a device, ready for any number of cameras: meshes, maps, and the light of its surfaces.

    Args:
        instances: What is drawn.
        lights: What lights it; see `interior_lights`.
        device: Where it is drawn: "cpu" or "cuda:0".

    Raises:
        InputError: nothing to draw, too much of it, or a transform that cannot be undone.
        MissingDependencyError: a GPU that is not there.
    """

    def __init__(self, instances: Sequence[Instance], lights: Lights | None = None, device: str = "cpu") -> None:
        check_device(device)
        self._device, self._lights = device, lights or Lights()
        geometry = collect(instances, self._lights)
        low, high = bounds_of(geometry.corners)
        if self._lights.room is not None:
            low, high = np.maximum(low, self._lights.room[0]), np.minimum(high, self._lights.room[1])
        with wp.ScopedDevice(device):
            self._world, self._keep = world_on(geometry)
            shining = seen_of(self._world, geometry.emitters)
            lamps = lights_on(self._lights, shining, low, high)
            self._cache, patches = build_cache(self._world, lamps, geometry, low, high)
            self._light = lights_on(self._lights, shining + patches, low, high)

    def picture(
        self,
        camera: Camera,
        width: int,
        height: int,
        quality: TraceQuality | None = None,
        deadline: float | None = None,
    ) -> TracedPicture:
        """What a camera sees; equal input gives equal pictures on one kind of device.

        Args:
            camera: From where.
            width: Width of the picture in pixels.
            height: Its height in pixels.
            quality: How carefully; None: `TraceQuality.normal`.
            deadline: A time of ``time.monotonic`` after which it is given up.

        Raises:
            InputError: a picture without pixels or one that is too large.
            TimeoutError: the deadline has passed.
        """
        if width < 1 or height < 1 or width * height > _MAX_PIXELS:
            raise InputError(f"picture: {width} x {height} pixels; between 1 and {_MAX_PIXELS} are drawn")
        quality = quality or TraceQuality.normal()
        lens = Lens()
        for key in ("eye", "forward", "right", "up"):
            setattr(lens, key, wp.vec3(*getattr(camera, key)))
        lens.flat = int(camera.flat)
        with wp.ScopedDevice(self._device):
            return self._picture(camera, lens, width, height, quality, deadline)

    def _picture(
        self, camera: Camera, lens, width: int, height: int, quality: TraceQuality, deadline: float | None
    ) -> TracedPicture:
        columns, rows = -(-width // quality.spacing), -(-height // quality.spacing)
        count, pixels = columns * rows, width * height
        scene = [self._world, self._light, self._cache]
        eye, spread = lens.eye, 2.0 * float(np.linalg.norm(camera.up)) / rows
        (noisy,) = _empty(1, count, wp.vec4)
        guide, guide2 = _empty(2, count, wp.vec2)
        soft, sun, sun2, gloss, gloss2, toward, toward2, point, normal = _empty(9, count, wp.vec3)
        key = wp.empty(count, dtype=int)
        surface = [point, normal, key]
        order = wp.array(hilbert_order(), dtype=int)
        # Without windows their rays go to the lamps.
        more = 0 if self._lights.portals else quality.windows
        rays = [quality.windows, quality.lamps + more, quality.bounces, quality.suns]
        launch(
            view_kernels.light_pixels,
            count,
            [*scene, lens, order, width, height, quality.spacing, *rays],
            [],
            [noisy, sun, gloss2, toward, *surface],
            deadline,
        )
        before = [columns, rows, eye, spread]
        found = [soft, gloss, guide]
        launch(filter_kernels.find_guide, count, before, [noisy, gloss2, *surface], found, deadline)
        if quality.levels:
            launch(filter_kernels.smooth_sun, count, before, [sun, *surface], [sun2], deadline)
            sun = sun2
        (soft2,) = _empty(1, count, wp.vec3)
        for level in range(quality.levels):
            launch(
                filter_kernels.smooth,
                count,
                [columns, rows, 2**level, eye, spread],
                [guide, soft, gloss, toward, *surface],
                [soft2, gloss2, toward2, guide2],
                deadline,
            )
            soft, soft2, gloss, gloss2, toward, toward2 = soft2, soft, gloss2, gloss, toward2, toward
            guide, guide2 = guide2, guide
        film = develop_kernels.Film()
        film.exposure, balance = exposed(soft.numpy(), key.numpy())
        film.balance = wp.vec3(*balance)
        if self._lights.enclosed:
            self._light.view = wp.vec3(*(min(self._lights.view, _OUTSIDE / film.exposure) / balance))
        film.rays, film.plain_rays = quality.rays, quality.plain_rays
        (edge,) = _empty(1, count, wp.uint8)
        launch(develop_kernels.find_edges, count, before, [sun, *surface], [edge], deadline)
        rgb, linear, albedo, first_normal = _empty(4, pixels, wp.vec3)
        depth, instance = wp.empty(pixels, dtype=float), wp.empty(pixels, dtype=int)
        launch(
            develop_kernels.develop,
            pixels,
            [*scene, lens, film, width, height, columns, rows],
            [soft, sun, gloss, toward, *surface, edge],
            [rgb, linear, albedo, first_normal, depth, instance],
            deadline,
        )
        shape = (height, width)
        seen = instance.numpy().reshape(shape)
        distance = np.where(seen >= 0, depth.numpy().reshape(shape), np.float32(np.inf))
        shown = (rgb.numpy().reshape(*shape, 3) * 255.0 + 0.5).astype(np.uint8)
        images = [a.numpy().reshape(*shape, 3) for a in (linear, first_normal, albedo)]
        position, planar = _places(camera, distance)
        return TracedPicture(shown, images[0], seen, distance, planar, position, images[1], images[2])


def trace(
    instances: Sequence[Instance],
    camera: Camera,
    width: int,
    height: int,
    *,
    lights: Lights | None = None,
    quality: TraceQuality | None = None,
    device: str = "cpu",
    deadline: float | None = None,
) -> TracedPicture:
    """One picture of instances; see `Tracer`, which draws several of one scene faster."""
    return Tracer(instances, lights, device).picture(camera, width, height, quality, deadline)


def _empty(number: int, count: int, kind: Any) -> list[wp.array]:
    return [wp.empty(count, dtype=kind) for _ in range(number)]


def _places(camera: Camera, distance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """World points [H, W, 3] at distances along the rays [H, W], and their depths along the camera's axis [H, W]."""
    height, width = distance.shape
    u = (2 * (np.arange(width, dtype=np.float32) + 0.5) / width - 1)[None, :, None]
    v = (1 - 2 * (np.arange(height, dtype=np.float32) + 0.5) / height)[:, None, None]
    vectors = (np.asarray(getattr(camera, key), dtype=np.float32) for key in ("eye", "forward", "right", "up"))
    eye, forward, right, up = vectors
    axis = np.cross(up, right)
    axis = axis / np.linalg.norm(axis)
    origin, way = eye, forward + right * u + up * v
    if camera.flat:
        origin, way = eye + right * u + up * v, forward + 0.0 * (u + v)
    way = way / np.linalg.norm(way, axis=2, keepdims=True)
    found = np.isfinite(distance)
    step = np.where(found, distance, 0.0)[..., None]
    depth = np.where(found, ((origin - eye) + way * step) @ axis, np.inf)
    return (origin + way * step).astype(np.float32), depth.astype(np.float32)


@cache
def hilbert_order(side: int = 64) -> np.ndarray:
    """The place of each pixel of a square along a Hilbert curve, int32 [side * side]."""
    y, x = (a.ravel() for a in np.mgrid[0:side, 0:side])
    place = np.zeros(side * side, dtype=np.int64)
    s = side // 2
    while s:
        rx, ry = (x & s) > 0, (y & s) > 0
        place += s * s * ((3 * rx) ^ ry)
        flip = ~ry & rx
        x, y = np.where(flip, side - 1 - x, x), np.where(flip, side - 1 - y, y)
        x, y = np.where(ry, x, y), np.where(ry, y, x)
        s //= 2
    return place.astype(np.int32)
