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
from . import cache_kernels, develop_kernels, filter_kernels, ray_kernels, view_kernels, world_kernels
from .cache import build_cache
from .lights import DirectLights, Lights
from .rays import MAX_RAYS, check_device, launch, lens_of, load_kernels
from .world import bounds_of, collect, direct_lights_on, lights_on, seen_of, triangles_on, world_on

DRAFT = (view_kernels, filter_kernels, develop_kernels)
"""The kernels of pictures in plain light."""

TRACED = (*DRAFT, cache_kernels)
"""The kernels of all other pictures."""


def kernel_modules() -> list[wp.Module]:
    """The modules of pictures and data passes, to be compiled ahead."""
    return [wp.get_module(module.__name__) for module in (*TRACED, ray_kernels)]


_CONTRAST = 1.22
_DIRECT_SPACING = 2  # of the pixels for which plain light is cast
_OUTSIDE = 2.4  # what the horizon is at most, as white is 1: photographers balance what is outside with the room

_WHITE = 0.47
"""Value, before tone mapping, of white paint in the middling light of a picture."""

_PAINT = 0.82
_EVERY = 5  # pixel that is looked at


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
    levels: int = 5
    rays: int = 6
    plain_rays: int = 1

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value < (0 if field.name == "levels" else 1):
                raise InputError(f"quality.{field.name}: {value} is too few")

    @classmethod
    def draft(cls) -> Quality:
        """For a quick look."""
        return cls(windows=3, lamps=2, bounces=4, suns=2, spacing=2, levels=4, rays=4)

    @classmethod
    def normal(cls) -> Quality:
        """To show."""
        return cls()

    @classmethod
    def fine(cls) -> Quality:
        """For a front page."""
        return cls(windows=12, lamps=8, bounces=24, suns=8, levels=4, rays=16, plain_rays=4)


@dataclass(frozen=True)
class TracedPicture:
    """What a camera saw, [H, W] each.

    ``rgb`` uint8 [H, W, 3] is exposed and tone mapped, ``linear`` float32 [H, W, 3] is neither. Of the first surface in
    the middle of a pixel: ``instance`` int32 is its number or -1, ``distance`` float32 [m] that along the ray, inf for
    nothing. More about surfaces tells `sceneweaver.render.passes`.
    """

    rgb: np.ndarray
    linear: np.ndarray
    instance: np.ndarray
    distance: np.ndarray


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
        load_kernels(device, *(DRAFT if isinstance(self._lights, DirectLights) else TRACED))
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
            self._cache, patches = build_cache(self._world, lamps, geometry, low, high, self._lights.cell)
            self._light = lights_on(self._lights, shining + patches, low, high)

    def picture(self, camera: Camera, width: int, height: int, quality: Quality | None = None) -> TracedPicture:
        """What a camera sees; equal input gives equal pictures on one kind of device.

        Args:
            camera: From where.
            width: Width of the picture in pixels.
            height: Its height in pixels.
            quality: How carefully; None: `Quality.normal`.

        Raises:
            InputError: a picture without pixels or one that is too large.
        """
        if width < 1 or height < 1 or width * height > MAX_RAYS:
            raise InputError(f"picture: {width} x {height} pixels; between 1 and {MAX_RAYS} are drawn")
        with wp.ScopedDevice(self._device):
            return self._picture(camera, width, height, quality or Quality.normal())

    def _picture(self, camera: Camera, width: int, height: int, quality: Quality) -> TracedPicture:
        lights, lens, pixels = self._lights, lens_of(camera, width, height), width * height
        spacing = _DIRECT_SPACING if isinstance(lights, DirectLights) else quality.spacing
        grid = filter_kernels.Grid()
        grid.columns, grid.rows = -(-width // spacing), -(-height // spacing)
        count = grid.columns * grid.rows
        grid.eye, grid.spread = lens.eye, 2.0 * float(np.linalg.norm(camera.up)) / grid.rows
        grid.point, grid.normal = _vectors(2, count)
        grid.key = wp.empty(count, dtype=int)
        layers = self._smooth_light(lens, grid, quality)
        film = develop_kernels.Film()
        film.rays, film.plain_rays = quality.rays, quality.plain_rays
        if isinstance(lights, DirectLights):
            film.exposure, film.contrast, film.balance = lights.exposure, 1.0, wp.vec3(1.0)
        else:
            film.contrast = _CONTRAST
            film.exposure, balance = exposed(layers.soft.numpy(), grid.key.numpy(), lights.adapted)
            film.exposure *= lights.level
            film.balance = wp.vec3(*balance)
            if lights.enclosed:
                self._light.view = wp.vec3(*(min(lights.view, _OUTSIDE / film.exposure) / balance))
        edge = wp.empty(count, dtype=wp.uint8)  # pyright: ignore[reportArgumentType]
        launch(develop_kernels.find_edges, count, [grid], [edge])
        made = develop_kernels.Picture()
        made.rgb, made.linear = _vectors(2, pixels)
        made.distance, made.instance = wp.empty(pixels, dtype=float), wp.empty(pixels, dtype=int)
        before = [self._world, self._light, self._cache, lens, film, grid]
        launch(develop_kernels.develop, pixels, before, [layers, edge, made])
        seen = made.instance.numpy().reshape(height, width)
        distance = np.where(seen >= 0, made.distance.numpy().reshape(height, width), np.float32(np.inf))
        rgb, linear = (a.numpy().reshape(height, width, 3) for a in (made.rgb, made.linear))
        return TracedPicture((rgb * 255.0 + 0.5).astype(np.uint8), linear, seen, distance)

    def _smooth_light(self, lens: Any, grid: Any, quality: Quality) -> Any:
        """The layers of light where pixels are lit; fills ``grid``."""
        count = grid.columns * grid.rows
        layers, other = filter_kernels.Layers(), filter_kernels.Layers()
        for some in (layers, other):
            some.soft, some.sun, some.gloss, some.toward = _vectors(4, count)
        kinds: tuple[Any, ...] = (float, wp.vec2, wp.vec2)
        variance, guide, next_guide = (wp.empty(count, dtype=kind) for kind in kinds)
        rays = view_kernels.Counts()
        rays.bounces, rays.suns = quality.bounces, quality.suns
        if isinstance(self._lights, Lights):
            # Without windows their rays go to the lamps.
            rays.windows = quality.windows
            rays.lamps = quality.lamps + (0 if self._lights.portals else quality.windows)
        before = [self._world, self._light, self._cache, lens, rays, wp.array(hilbert_order(), dtype=int)]
        launch(view_kernels.light_pixels, count, before, [grid, layers, variance])
        launch(filter_kernels.find_guide, count, [grid], [layers, variance, other, guide])
        layers.soft, layers.gloss, other.soft, other.gloss = other.soft, other.gloss, layers.soft, layers.gloss
        if quality.levels:
            launch(filter_kernels.smooth_sun, count, [grid], [layers.sun, other.sun])
            layers.sun = other.sun
        for level in range(quality.levels):
            launch(filter_kernels.smooth, count, [grid, 2**level], [layers, guide, other, next_guide])
            other.sun = layers.sun
            layers, other, guide, next_guide = other, layers, next_guide, guide
        return layers


def trace(
    instances: Sequence[Instance],
    camera: Camera,
    width: int,
    height: int,
    *,
    lights: Lights | DirectLights | None = None,
    quality: Quality | None = None,
    device: str = "cpu",
) -> TracedPicture:
    """One picture of instances; see `Tracer`, which draws several of one scene faster."""
    return Tracer(instances, lights, device).picture(camera, width, height, quality)


def _vectors(number: int, count: int) -> list[wp.array]:
    kind: Any = wp.vec3
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


def exposed(soft: np.ndarray, key: np.ndarray, adapted: float = Lights.adapted) -> tuple[float, np.ndarray]:
    """Exposure, and the gains of red, green and blue [3].

    Args:
        soft: Light without that of the sun, over pi, RGB [N, 3].
        key: Negative where nothing is seen [N].
        adapted: Share of the colour of the light that an eye gets used to.
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
    gains = (mean @ (0.2126, 0.7152, 0.0722) / np.maximum(mean, 1e-9)) ** adapted
    return _WHITE / (_PAINT * level), gains
