"""Pictures of meshes by ray casting, on the CPU or a GPU, without a display."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.textures import uv_of
from sceneweaver.runtime.threads import cores, map_threads
from sceneweaver.scene import InputError, MissingDependencyError

from . import raycast_kernels as raycast
from . import raycast_world as world
from . import smoothing_kernels as smoothing
from .camera import Camera
from .maps import MapTable
from .mesh_shading import prepared

_SPACING = 2  # of the pixels for which light is cast where surfaces are plain
_MAX_PIXELS = 64_000_000


@dataclass(frozen=True)
class Instance:
    """A mesh somewhere in the world; ``transform`` is 4x4, from its frame to the world's."""

    mesh: Mesh
    transform: np.ndarray


_SPECK = Mesh(
    np.array([[0, 0, -1e6], [1e-3, 0, -1e6], [0, 1e-3, -1e6]]),
    np.array([[0, 1, 2]]),
    np.zeros(1, int),
    np.zeros(1, int),
    (Material("none", (0, 0, 0)),),
)
"""Far below everything: stands for nothing where there must be a mesh."""


@dataclass(frozen=True)
class Lighting:
    """Sun and sky, in linear light; ``sun`` points toward it, ``reach`` is how far occlusion is looked for [m].

    ``bounce`` is how much light near surfaces throw back in their own colour (0: a plain share of the sky's).
    ``beam`` is a second sun that shines past ``shutters`` only, a mesh that nobody sees, and on nothing below the
    height ``beam_floor`` [m]; when it is black there is none.
    ``lamps`` are small lights (x, y, z [m], power) in one colour; they reach 3 m and throw no shadows.
    """

    sun: tuple[float, float, float] = (0.55, -0.35, 0.75)
    softness: float = 0.08
    sun_color: tuple[float, float, float] = (1.25, 1.16, 1.02)
    sky: tuple[float, float, float] = (0.78, 0.82, 0.88)
    ground: tuple[float, float, float] = (0.46, 0.43, 0.40)
    background: tuple[float, float, float] = (0.86, 0.86, 0.85)
    reach: float = 1.5
    exposure: float = 0.92
    bounce: float = 0.0
    beam: tuple[float, float, float] = (0.0, 0.0, 1.0)
    beam_softness: float = 0.02
    beam_color: tuple[float, float, float] = (0.0, 0.0, 0.0)
    beam_floor: float = -math.inf
    shutters: Mesh | None = None
    lamps: tuple[tuple[float, float, float, float], ...] = ()
    lamp_color: tuple[float, float, float] = (1.0, 0.78, 0.52)


@dataclass(frozen=True)
class Quality:
    """Rays a pixel, shade rays a ray, and the radius [pixels] over which diffuse light is smoothed (0: not at all).

    With ``sparing`` only pixels where something ends or changes get all rays, the rest one, and of four on a plain
    surface one gets light: much faster for pictures of large plain surfaces.
    """

    rays: int = 6
    shades: int = 2
    radius: int = 2
    sparing: bool = False

    @classmethod
    def draft(cls) -> Quality:
        """For a quick look."""
        return cls(rays=3, shades=2, radius=2, sparing=True)

    @classmethod
    def normal(cls) -> Quality:
        """For a report."""
        return cls(rays=5, shades=2, radius=3, sparing=True)

    @classmethod
    def fine(cls) -> Quality:
        """For a front page."""
        return cls(rays=12, shades=3, radius=3)


@dataclass(frozen=True)
class Picture:
    """What was seen: ``rgb`` uint8 [H, W, 3].

    ``objects`` int32 [H, W] is the instance in the middle of the pixel, or -1; ``depth`` float32 [H, W] its distance
    from the camera along the ray [m], or inf.
    """

    rgb: np.ndarray
    objects: np.ndarray
    depth: np.ndarray


def cast(
    instances: list[Instance],
    camera: Camera,
    width: int,
    height: int,
    *,
    lighting: Lighting | None = None,
    quality: Quality | None = None,
    device: str = "cpu",
) -> Picture:
    """Draw instances.

    Raises:
        InputError: for a picture without pixels, or one that is too large; a quality that draws nothing; a sun without
            direction; a transform that is not finite, flattens its mesh, or is not 4x4.
        MissingDependencyError: a GPU that is not there.
    """
    if width < 1 or height < 1 or width * height > _MAX_PIXELS:
        raise InputError(f"picture: {width} x {height} pixels; between 1 and {_MAX_PIXELS} are drawn")
    lighting, quality = lighting or Lighting(), quality or Quality()
    if quality.rays < 1 or quality.shades < 1 or quality.radius < 0:
        raise InputError("quality: at least 1 ray, 1 shade and a radius of 0")
    if not 0 < np.linalg.norm(lighting.sun) < np.inf:
        raise InputError(f"lighting.sun: {lighting.sun} is no direction")
    check_device(device)
    pixels = width * height
    with wp.ScopedDevice(device):
        solid, keep = _solid(instances, lighting)
        lens = raycast.Lens()
        for key in ("eye", "forward", "right", "up"):
            setattr(lens, key, wp.vec3(*getattr(camera, key)))
        lens.flat = int(camera.flat)
        light = world.Light()
        light.sun = wp.normalize(wp.vec3(*lighting.sun))  # pyright: ignore[reportCallIssue, reportArgumentType]
        light.beam = wp.normalize(wp.vec3(*lighting.beam))  # pyright: ignore[reportCallIssue, reportArgumentType]
        for key in ("sun_color", "sky", "ground", "beam_color", "lamp_color"):
            setattr(light, key, wp.vec3(*getattr(lighting, key)))
        for key in ("softness", "reach", "bounce", "beam_softness", "beam_floor"):
            setattr(light, key, getattr(lighting, key))
        light.lamps = len(lighting.lamps)
        background = wp.vec3(*lighting.background)
        color, gloss, glint, shine, normal, ambient, sun, smooth_ambient, smooth_sun, out = (
            wp.empty(pixels, dtype=wp.vec3)  # pyright: ignore[reportArgumentType]
            for _ in range(10)
        )
        depth, objects, faces = (wp.empty(pixels, dtype=kind) for kind in (float, int, int))
        looks, surface = [color, gloss, glint, shine], [normal, depth, objects]
        rays, shades, radius = quality.rays, quality.shades, quality.radius

        def launch(kernel, count: int, before: list, after: list, found: list) -> None:
            """A kernel over ``count`` threads; the number of the first stands between ``before`` and ``after``."""
            _in_bands(
                lambda start, size: wp.launch(kernel, size, [*before, start, *after], found, device=device),
                count,
                wp.get_device(device).is_cpu,
            )

        def illuminate(chosen: np.ndarray, apart: int, period: int, around: int, suns: int) -> None:
            before = [solid, lens, light, wp.array(chosen, dtype=int), width, height]
            launch(
                raycast.illuminate,
                len(chosen),
                before,
                [apart, period, around, suns, *surface, faces],
                [ambient, sun],
            )

        launch(raycast.cast, pixels, [solid, lens, light, background, width, height], [], [*looks, *surface, faces])
        seen = objects.numpy().reshape(height, width)
        edges = np.ones((height, width), dtype=bool)
        if quality.sparing:
            edge = wp.empty(pixels, dtype=wp.uint8)  # pyright: ignore[reportArgumentType]
            launch(smoothing.find_edges, pixels, [width, height], [color, shine, *surface], [edge])
            edges = edge.numpy().reshape(height, width) > 0
        sparse = quality.sparing and radius >= _SPACING
        spacing = _SPACING if sparse else 1
        share, dense = _shares(edges & (seen >= 0), seen >= 0, spacing)
        if sparse:
            # On plain surfaces one pixel of a block has rays for all of it.
            illuminate(np.flatnonzero((share > 0) & ~edges), spacing, radius + 1, spacing * shades, spacing)
            illuminate(np.flatnonzero((share > 0) & edges), 1, 2 * radius + 1, shades + 1, spacing)
        else:
            often = 1 if quality.sparing else rays
            illuminate(np.flatnonzero(share), 1, 2 * radius + 1, often * shades, often)
        blocks = [wp.array(a.reshape(-1), dtype=wp.uint8) for a in (share, dense)]
        chosen = np.flatnonzero(share)
        launch(
            smoothing.smooth,
            len(chosen),
            [wp.array(chosen, dtype=int), width, height],
            [radius + spacing - 1, spacing, *blocks, ambient, sun, *surface],
            [smooth_ambient, smooth_sun],
        )
        launch(
            smoothing.develop,
            pixels,
            [width, height],
            [spacing, lighting.exposure, blocks[0], *looks, *surface, smooth_ambient, smooth_sun],
            [out],
        )
        if rays > 1:
            chosen = wp.array(np.flatnonzero(edges), dtype=int)
            launch(
                raycast.refine,
                len(chosen),
                [solid, lens, light, background, chosen, width, height],
                [rays, lighting.exposure, *looks, smooth_ambient, smooth_sun, *surface],
                [out],
            )
        rgb = (out.numpy().reshape(height, width, 3) * 255.0 + 0.5).astype(np.uint8)
        distance = np.where(seen >= 0, depth.numpy().reshape(height, width), np.float32(np.inf))
        picture = Picture(rgb, seen, distance)
    del keep
    return picture


def _shares(edges: np.ndarray, seen: np.ndarray, spacing: int) -> tuple[np.ndarray, np.ndarray]:
    """For how many pixels the light of each one stands, uint8 [H, W], and in which blocks several have some, uint8.

    Args:
        edges: Pixels that need light of their own [H, W].
        seen: Pixels that show anything [H, W].
        spacing: Side of a block; of the others the first pixel of each stands for all.
    """
    share = edges.astype(np.uint8)
    first = share[::spacing, ::spacing]
    pad = [(0, -n % spacing) for n in share.shape]
    rows, columns = first.shape
    own = np.pad(share, pad).reshape(rows, spacing, columns, spacing).sum(axis=(1, 3), dtype=np.uint8) - first
    first[:] = np.where(seen[::spacing, ::spacing], spacing * spacing - own, 0)
    return share, (own > 0).astype(np.uint8)


def _in_bands(work, pixels: int, split: bool) -> None:
    """All pixels at once on a GPU; on the CPU, where a kernel has one thread, in bands over Python threads."""
    threads = cores()
    if pixels == 0:
        return
    if not split or threads == 1 or pixels < 4096:
        work(0, pixels)
        return
    work(0, 1)  # compiles and loads the kernel before there are threads
    cuts = np.linspace(0, pixels, 4 * threads + 1).astype(int)
    map_threads(lambda k: work(int(cuts[k]), int(cuts[k + 1] - cuts[k])), range(4 * threads), threads)


def _solid(instances: list[Instance], lighting: Lighting):
    """The world of all instances, and what must live as long as it is drawn."""
    looks, numbers = [], []
    points, faces, normals, look_of, places = [], [], [], [], []
    table = MapTable()
    if not any(len(instance.mesh.faces) for instance in instances):
        instances = [Instance(_SPECK, np.eye(4))]
    for number, instance in enumerate(instances):
        mesh, matrix = instance.mesh, _transform(instance, number)
        if not len(mesh.faces):
            continue
        corner = prepared(mesh)
        start = sum(len(p) for p in points)
        points.append(mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])
        faces.append(mesh.faces + start)
        turned = corner @ np.linalg.inv(matrix[:3, :3])
        normals.append(turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-12))
        look_of.append(mesh.face_material + len(looks))
        places.append(uv_of(mesh).reshape(-1, 2))
        looks += [_look(material, table) for material in mesh.materials]
        numbers.append(np.full(len(mesh.faces), number))
    flat = wp.array(np.concatenate(faces).reshape(-1), dtype=int)
    mesh = wp.Mesh(points=wp.array(np.concatenate(points), dtype=wp.vec3), indices=flat, bvh_leaf_size=8)
    solid = world.Solid()
    solid.mesh = mesh.id
    solid.normals = wp.array(np.concatenate(normals), dtype=wp.vec3)
    solid.looks = wp.array(looks, dtype=world.Look)
    solid.face_look = wp.array(np.concatenate(look_of), dtype=int)
    solid.face_object = wp.array(np.concatenate(numbers), dtype=int)
    solid.uvs = wp.array(np.concatenate(places), dtype=wp.vec2)
    solid.patterns, solid.colors = table.rows, table.colors
    shutters = lighting.shutters or _SPECK
    behind = wp.Mesh(
        points=wp.array(shutters.vertices, dtype=wp.vec3), indices=wp.array(shutters.faces.reshape(-1), dtype=int)
    )
    solid.shutters = behind.id
    solid.lamps = wp.array(np.asarray(lighting.lamps or ((0.0, 0.0, 0.0, 0.0),), dtype=np.float32), dtype=wp.vec4)
    return solid, (mesh, behind)


def _transform(instance: Instance, number: int) -> np.ndarray:
    matrix = np.asarray(instance.transform, dtype=np.float64)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or abs(np.linalg.det(matrix[:3, :3])) < 1e-12:
        raise InputError(f"instances[{number}].transform: not a finite 4x4 matrix that can be undone")
    return matrix


def check_device(device: str) -> None:
    """MissingDependencyError for a device that is not there."""
    wp.init()
    if (
        device != "cpu"
        and device not in (found.alias for found in wp.get_cuda_devices())
        and not (device == "cuda" and wp.is_cuda_available())
    ):
        raise MissingDependencyError(f'device: "{device}" is not there; use device="cpu"')


def _look(material: Material, table: MapTable):
    look = world.Look()
    color = np.asarray(material.color, dtype=np.float64)
    look.color = wp.vec3(*np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4))
    look.roughness, look.metallic = material.roughness, material.metallic
    look.opacity, look.emission = material.opacity, material.emission
    look.pattern, look.gain, _ = table.add(material.texture)
    return look
