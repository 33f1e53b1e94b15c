"""Pictures of meshes by ray casting, on the CPU or a GPU, without a display."""

from __future__ import annotations

import math
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import warp as wp

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.scene import InputError, MissingDependencyError

from . import raycast_kernels as raycast
from .camera import Camera

_CREASE = np.cos(np.radians(36.0))
_TEXTURES = {name: k for k, name in enumerate(("plain", "wood", "fabric", "stone", "metal", "leaf"))}
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

    With ``sparing`` only pixels where something ends or changes get all rays, the rest one: much faster for pictures
    of large plain surfaces.
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
    _check_device(device)
    pixels = width * height
    with wp.ScopedDevice(device):
        solid, keep = _solid(instances, lighting)
        lens = raycast.Lens()
        for key in ("eye", "forward", "right", "up"):
            setattr(lens, key, wp.vec3(*getattr(camera, key)))
        lens.flat = int(camera.flat)
        light = raycast.Light()
        light.sun = wp.normalize(wp.vec3(*lighting.sun))  # pyright: ignore[reportCallIssue, reportArgumentType]
        light.beam = wp.normalize(wp.vec3(*lighting.beam))  # pyright: ignore[reportCallIssue, reportArgumentType]
        for key in ("sun_color", "sky", "ground", "beam_color", "lamp_color"):
            setattr(light, key, wp.vec3(*getattr(lighting, key)))
        for key in ("softness", "reach", "bounce", "beam_softness", "beam_floor"):
            setattr(light, key, getattr(lighting, key))
        light.lamps = len(lighting.lamps)
        color, lit, shine, normal, out = (
            wp.empty(pixels, dtype=wp.vec3)  # pyright: ignore[reportArgumentType]
            for _ in range(5)
        )
        depth, objects = wp.empty(pixels, dtype=float), wp.empty(pixels, dtype=int)
        sky = wp.vec3(*lighting.background)
        period = 2 * quality.radius + 1

        one_core = wp.get_device(device).is_cpu

        def draw(which: np.ndarray, rays: int, shades: int) -> None:
            chosen = wp.array(which, dtype=int)

            def band(start: int, count: int) -> None:
                given = [solid, lens, light, sky, chosen, width, height, start, rays, shades, period]
                wp.launch(raycast.cast, count, given, [color, lit, shine, normal, depth, objects], device=device)

            _in_bands(band, len(which), one_core)

        def develop(start: int, count: int) -> None:
            wp.launch(
                raycast.develop,
                count,
                [width, height, start, quality.radius, lighting.exposure, color, lit, shine, normal, depth, objects],
                [out],
                device=device,
            )

        draw(np.arange(pixels), 1 if quality.sparing else quality.rays, quality.shades)
        if quality.sparing and quality.rays > 1:
            shape = (height, width)
            edges = _changes(
                objects.numpy().reshape(shape),
                depth.numpy().reshape(shape),
                *(a.numpy().reshape(*shape, 3) for a in (normal, color, shine)),
            )
            # Edges have fewer neighbours to be smoothed with.
            draw(np.flatnonzero(edges), quality.rays, quality.shades + 1)
        _in_bands(develop, pixels, one_core)
        rgb = (out.numpy().reshape(height, width, 3) * 255.0 + 0.5).astype(np.uint8)
        seen = objects.numpy().reshape(height, width)
        distance = np.where(seen >= 0, depth.numpy().reshape(height, width), np.float32(np.inf))
        picture = Picture(rgb, seen, distance)
    del keep
    return picture


def _changes(
    objects: np.ndarray, depth: np.ndarray, normal: np.ndarray, color: np.ndarray, shine: np.ndarray
) -> np.ndarray:
    """Where one ray is not enough, bool [H, W]: pixels that differ from one of their eight neighbours."""
    found = np.zeros(objects.shape, dtype=bool)
    height, width = objects.shape
    glow = np.minimum(shine.sum(axis=2), 3.0)
    for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here = (slice(0, height - dy), slice(max(0, -dx), width - max(0, dx)))
        there = (slice(dy, height), slice(max(0, dx), width + min(0, dx)))
        unlike = objects[here] != objects[there]
        unlike |= np.abs(depth[here] - depth[there]) > 0.02 * depth[here]
        unlike |= np.einsum("ijk,ijk->ij", normal[here], normal[there]) < 0.96
        unlike |= np.abs(color[here] - color[there]).max(axis=2) > 0.05
        unlike |= np.abs(glow[here] - glow[there]) > 0.15
        found[here] |= unlike
        found[there] |= unlike
    return found


def _in_bands(work, pixels: int, split: bool) -> None:
    """All pixels at once on a GPU; on the CPU, where a kernel has one thread, in bands over Python threads."""
    threads = os.cpu_count() or 1
    if pixels == 0:
        return
    if not split or threads == 1 or pixels < 4096:
        work(0, pixels)
        return
    work(0, 1)  # compiles and loads the kernel before there are threads
    cuts = np.linspace(0, pixels, 4 * threads + 1).astype(int)
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(lambda k: work(int(cuts[k]), int(cuts[k + 1] - cuts[k])), range(4 * threads)))


def _solid(instances: list[Instance], lighting: Lighting):
    """The world of all instances, and what must live as long as it is drawn."""
    looks, numbers = [], []
    points, local, faces, normals, look_of, grain = [], [], [], [], [], []
    if not any(len(instance.mesh.faces) for instance in instances):
        instances = [Instance(_SPECK, np.eye(4))]
    for number, instance in enumerate(instances):
        mesh, matrix = instance.mesh, _transform(instance, number)
        if not len(mesh.faces):
            continue
        corner, axis = _prepared(id(mesh), _Keep(mesh))
        start = sum(len(p) for p in points)
        points.append(mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])
        local.append(mesh.vertices)
        faces.append(mesh.faces + start)
        turned = corner @ np.linalg.inv(matrix[:3, :3])
        normals.append(turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-12))
        look_of.append(mesh.face_material + len(looks))
        grain.append(axis)
        looks += [_look(material) for material in mesh.materials]
        numbers.append(np.full(len(mesh.faces), number))
    flat = wp.array(np.concatenate(faces).reshape(-1), dtype=int)
    mesh = wp.Mesh(points=wp.array(np.concatenate(points), dtype=wp.vec3), indices=flat)
    solid = raycast.Solid()
    solid.mesh = mesh.id
    solid.normals = wp.array(np.concatenate(normals), dtype=wp.vec3)
    solid.looks = wp.array(looks, dtype=raycast.Look)
    solid.face_look = wp.array(np.concatenate(look_of), dtype=int)
    solid.face_object = wp.array(np.concatenate(numbers), dtype=int)
    solid.face_grain = wp.array(np.concatenate(grain), dtype=int)
    solid.faces = flat
    solid.local = wp.array(np.concatenate(local), dtype=wp.vec3)
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


def _check_device(device: str) -> None:
    wp.init()
    if (
        device != "cpu"
        and device not in (found.alias for found in wp.get_cuda_devices())
        and not (device == "cuda" and wp.is_cuda_available())
    ):
        raise MissingDependencyError(f'device: "{device}" is not there; use device="cpu"')


def _look(material: Material):
    look = raycast.Look()
    color = np.asarray(material.color, dtype=np.float64)
    look.color = wp.vec3(*np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4))
    look.roughness, look.metallic = material.roughness, material.metallic
    look.opacity, look.emission = material.opacity, material.emission
    look.texture = _TEXTURES[material.texture]
    return look


class _Keep:
    """A mesh as a cache's argument: equal to all, as the id beside it tells meshes apart, and kept alive by it."""

    def __init__(self, mesh: Mesh):
        self.mesh = mesh

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Keep) and other.mesh is self.mesh

    def __hash__(self) -> int:
        return id(self.mesh)


@lru_cache(maxsize=512)
def _prepared(_: int, keep: _Keep) -> tuple[np.ndarray, np.ndarray]:
    return corner_normals(keep.mesh), _grain(keep.mesh)


def corner_normals(mesh: Mesh) -> np.ndarray:
    """A unit normal for each triangle corner, [3 F, 3]: smooth over edges that bend by less than 36 degrees."""
    v, f = mesh.vertices, mesh.faces
    normal = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    unit = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-18)
    corner = f.reshape(-1)
    owner = np.repeat(np.arange(len(f)), 3)
    order = np.argsort(corner, kind="stable")
    counts = np.bincount(corner, minlength=len(v))
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    # Every pair of triangles around a vertex.
    size = counts[corner]
    mine = np.repeat(np.arange(len(corner)), size)
    step = np.arange(len(mine)) - np.repeat(np.cumsum(size) - size, size)
    other = owner[order[starts[corner[mine]] + step]]
    alike = np.einsum("ij,ij->i", unit[owner[mine]], unit[other]) > _CREASE
    total = np.zeros((len(corner), 3))
    for k in range(3):
        total[:, k] = np.bincount(mine[alike], normal[other[alike], k], len(corner))
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > 1e-18, total / np.maximum(length, 1e-18), unit[owner])


def _grain(mesh: Mesh) -> np.ndarray:
    """The axis along which a triangle's piece is longest, [F]: the way that wood grows in it."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    f = mesh.faces
    edges = np.concatenate([f[:, :2], f[:, 1:]])
    shape = (len(mesh.vertices),) * 2
    graph = coo_matrix((np.ones(len(edges), dtype=np.int8), (edges[:, 0], edges[:, 1])), shape=shape)
    count, label = connected_components(graph, directed=False)
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, label, mesh.vertices)
    np.maximum.at(high, label, mesh.vertices)
    return np.argmax(high - low, axis=1)[label[f[:, 0]]]
