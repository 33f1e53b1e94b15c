"""Pictures of meshes: with the light of the real world and all its bounces, or in plain light for a draft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.scene import InputError

from ..camera import Camera
from ..instances import Instance
from . import develop_kernels, filter_kernels, view_kernels, world_kernels
from .cache import build_cache
from .lights import DirectLights, Lights
from .rays import MAX_RAYS, check_device, launch, lens_of
from .world import bounds_of, collect, direct_lights_on, lights_on, seen_of, triangles_on, world_on

_CONTRAST = 1.22
_DIRECT_SPACING = 2  # of the pixels for which plain light is cast
_OUTSIDE = 2.4  # what the horizon is at most, as white is 1: photographers balance what is outside with the room

_WHITE = 0.47
"""Value, before tone mapping, of white paint in the middling light of a picture."""

_PAINT = 0.82
_EVERY = 5  # pixel that is looked at
_ADAPTED = 0.65  # share of the colour of the light that an eye gets used to


@dataclass(frozen=True)
class Quality:
    """Rays of each kind at a pixel that is lit, and how many pixels there are to one that is.

    ``windows``, ``lamps``, ``bounces`` and ``suns`` are rays to the sky, to lamps, to other surfaces and to the sun;
    every ``spacing``-th pixel of each row and column is lit. ``levels`` is how often the light is smoothed, each time
    over twice the distance. ``rays`` are those of a pixel where something ends, ``plain_rays`` of all others. Of
    plain light, which is even, every other pixel gets some, by ``bounces`` rays around and ``suns`` to the sun.
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
    def draft(cls) -> Quality:
        """For a quick look."""
        return cls(windows=3, lamps=2, bounces=4, suns=2, spacing=2, levels=3, rays=4)

    @classmethod
    def normal(cls) -> Quality:
        """To show."""
        return cls()

    @classmethod
    def fine(cls) -> Quality:
        """For a front page."""
        return cls(windows=12, lamps=8, bounces=24, suns=8, levels=3, rays=16, plain_rays=4)


@dataclass(frozen=True)
class TracedPicture:
    """What a camera saw, [H, W] each.

    ``rgb`` uint8 [H, W, 3] is exposed and tone mapped, ``linear`` float32 [H, W, 3] is neither. Of the first surface in
    the middle of a pixel: ``instance`` int32 is its number or -1, ``distance`` float32 [m] that along the ray, inf for
    nothing; ``normal`` float32 [H, W, 3] is turned to the camera, ``albedo`` float32 [H, W, 3] its linear base colour.
    """

    camera: Camera
    rgb: np.ndarray
    linear: np.ndarray
    instance: np.ndarray
    distance: np.ndarray
    normal: np.ndarray
    albedo: np.ndarray

    @property
    def position(self) -> np.ndarray:
        """World points float32 [H, W, 3] of the first surfaces; where nothing is seen, where the ray begins."""
        height, width = self.distance.shape
        step = np.where(np.isfinite(self.distance), self.distance, 0.0)[..., None]
        return (self.camera.origins(width, height) + self.camera.rays(width, height) * step).astype(np.float32)

    @property
    def depth(self) -> np.ndarray:
        """Their distances along the camera's axis, float32 [H, W] in metres; inf for nothing."""
        depth = (self.position - np.asarray(self.camera.eye)) @ self.camera.axis
        return np.where(np.isfinite(self.distance), depth, np.inf).astype(np.float32)


class Tracer:
    """A scene on a device, ready for any number of cameras: meshes, maps, and the light of its surfaces.

    Args:
        instances: What is drawn.
        lights: What lights it; see `interior_lights`. `DirectLights` make a draft: no bounces, and no radiance cache.
        device: Where it is drawn: "cpu" or "cuda:0".

    Raises:
        InputError: nothing to draw, too much of it, or a transform that cannot be undone.
        MissingDependencyError: a GPU that is not there.
    """

    def __init__(
        self, instances: Sequence[Instance], lights: Lights | DirectLights | None = None, device: str = "cpu"
    ) -> None:
        check_device(device)
        self._device, self._lights = device, lights or Lights()
        geometry = collect(instances, self._lights)
        self._triangles = triangles_on(geometry, device)
        with wp.ScopedDevice(device):
            self._world = world_on(geometry, self._triangles)
            if isinstance(self._lights, DirectLights):
                self._light, self._cache = direct_lights_on(self._lights), world_kernels.Cache()
                return
        low, high = bounds_of(geometry.corners)
        if self._lights.room is not None:
            low, high = np.maximum(low, self._lights.room[0]), np.minimum(high, self._lights.room[1])
        with wp.ScopedDevice(device):
            shining = seen_of(self._world, geometry.emitters)
            lamps = lights_on(self._lights, shining, low, high)
            self._cache, patches = build_cache(self._world, lamps, geometry, low, high)
            self._light = lights_on(self._lights, shining + patches, low, high)

    def picture(
        self,
        camera: Camera,
        width: int,
        height: int,
        quality: Quality | None = None,
        deadline: float | None = None,
    ) -> TracedPicture:
        """What a camera sees; equal input gives equal pictures on one kind of device.

        Args:
            camera: From where.
            width: Width of the picture in pixels.
            height: Its height in pixels.
            quality: How carefully; None: `Quality.normal`.
            deadline: A time of ``time.monotonic`` after which it is given up.

        Raises:
            InputError: a picture without pixels or one that is too large.
            TimeoutError: the deadline has passed.
        """
        if width < 1 or height < 1 or width * height > MAX_RAYS:
            raise InputError(f"picture: {width} x {height} pixels; between 1 and {MAX_RAYS} are drawn")
        quality = quality or Quality.normal()
        with wp.ScopedDevice(self._device):
            return self._picture(camera, width, height, quality, deadline)

    def _picture(
        self, camera: Camera, width: int, height: int, quality: Quality, deadline: float | None
    ) -> TracedPicture:
        lights, lens, pixels = self._lights, lens_of(camera), width * height
        spacing = _DIRECT_SPACING if isinstance(lights, DirectLights) else quality.spacing
        grid = filter_kernels.Grid()
        grid.columns, grid.rows = -(-width // spacing), -(-height // spacing)
        count = grid.columns * grid.rows
        grid.eye, grid.spread = lens.eye, 2.0 * float(np.linalg.norm(camera.up)) / grid.rows
        grid.point, grid.normal = _empty(2, count, wp.vec3)
        grid.key = wp.empty(count, dtype=int)
        light = self._smooth_light(lens, width, height, spacing, grid, quality, deadline)
        film = develop_kernels.Film()
        film.rays, film.plain_rays = quality.rays, quality.plain_rays
        if isinstance(lights, DirectLights):
            film.exposure, film.contrast, film.balance = lights.exposure, 1.0, wp.vec3(1.0)
        else:
            film.contrast = _CONTRAST
            film.exposure, balance = exposed(light[0].numpy(), grid.key.numpy())
            film.balance = wp.vec3(*balance)
            if lights.enclosed:
                self._light.view = wp.vec3(*(min(lights.view, _OUTSIDE / film.exposure) / balance))
        (edge,) = _empty(1, count, wp.uint8)
        launch(develop_kernels.find_edges, count, [grid], [], [edge], deadline)
        rgb, linear, albedo, normal = _empty(4, pixels, wp.vec3)
        depth, instance = wp.empty(pixels, dtype=float), wp.empty(pixels, dtype=int)
        launch(
            develop_kernels.develop,
            pixels,
            [self._world, self._light, self._cache, lens, film, grid, width, height],
            [*light, edge],
            [rgb, linear, albedo, normal, depth, instance],
            deadline,
        )
        shape = (height, width)
        seen = instance.numpy().reshape(shape)
        distance = np.where(seen >= 0, depth.numpy().reshape(shape), np.float32(np.inf))
        shown = (rgb.numpy().reshape(*shape, 3) * 255.0 + 0.5).astype(np.uint8)
        linear, normal, albedo = (a.numpy().reshape(*shape, 3) for a in (linear, normal, albedo))
        return TracedPicture(camera, shown, linear, seen, distance, normal, albedo)

    def _smooth_light(
        self,
        lens: Any,
        width: int,
        height: int,
        spacing: int,
        grid: Any,
        quality: Quality,
        deadline: float | None,
    ) -> list[wp.array]:
        """Light without the sun's, that, gloss and the direction of light where pixels are lit; fills ``grid``."""
        count = grid.columns * grid.rows
        noisy, *guides = *_empty(1, count, wp.vec4), *_empty(2, count, wp.vec2)
        soft, soft2, sun, sun2, gloss, gloss2, toward, toward2 = _empty(8, count, wp.vec3)
        order = wp.array(hilbert_order(), dtype=int)
        rays = [0, 0, quality.bounces, quality.suns]
        if isinstance(self._lights, Lights):
            # Without windows their rays go to the lamps.
            rays[:2] = quality.windows, quality.lamps + (0 if self._lights.portals else quality.windows)
        launch(
            view_kernels.light_pixels,
            count,
            [self._world, self._light, self._cache, lens, order, width, height, spacing, *rays],
            [],
            [noisy, sun, gloss2, toward, grid.point, grid.normal, grid.key],
            deadline,
        )
        launch(filter_kernels.find_guide, count, [grid], [noisy, gloss2], [soft, gloss, guides[0]], deadline)
        if quality.levels:
            launch(filter_kernels.smooth_sun, count, [grid], [sun], [sun2], deadline)
            sun = sun2
        for level in range(quality.levels):
            launch(
                filter_kernels.smooth,
                count,
                [grid, 2**level],
                [guides[0], soft, gloss, toward],
                [soft2, gloss2, toward2, guides[1]],
                deadline,
            )
            soft, soft2, gloss, gloss2, toward, toward2 = soft2, soft, gloss2, gloss, toward2, toward
            guides.reverse()
        return [soft, sun, gloss, toward]


def trace(
    instances: Sequence[Instance],
    camera: Camera,
    width: int,
    height: int,
    *,
    lights: Lights | DirectLights | None = None,
    quality: Quality | None = None,
    device: str = "cpu",
    deadline: float | None = None,
) -> TracedPicture:
    """One picture of instances; see `Tracer`, which draws several of one scene faster."""
    return Tracer(instances, lights, device).picture(camera, width, height, quality, deadline)


def _empty(number: int, count: int, kind: Any) -> list[wp.array]:
    return [wp.empty(count, dtype=kind) for _ in range(number)]


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


def exposed(soft: np.ndarray, key: np.ndarray) -> tuple[float, np.ndarray]:
    """Exposure, and the gains of red, green and blue [3].

    Args:
        soft: Light without that of the sun, over pi, RGB [N, 3].
        key: Negative where nothing is seen [N].
    """
    soft, key = soft[::_EVERY], key[::_EVERY]
    seen = key >= 0
    if not seen.any():
        return 1.0, np.ones(3)
    light = soft[seen].astype(np.float64)
    bright = light @ (0.2126, 0.7152, 0.0722)
    lit = bright > 1e-6
    if not lit.any():
        return 1.0, np.ones(3)
    low, high = np.quantile(bright[lit], (0.1, 0.9))
    middling = lit & (bright >= low) & (bright <= high)
    level = float(np.exp(np.log(bright[middling]).mean()))
    mean = light[middling].mean(axis=0)
    gains = (mean @ (0.2126, 0.7152, 0.0722) / np.maximum(mean, 1e-9)) ** _ADAPTED
    return _WHITE / (_PAINT * level), gains
