"""The world of a picture as arrays on a device: meshes, materials, maps and lights of all instances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.assets import textures
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.scene import InputError

from ..caster import Instance
from ..maps import MapTable
from ..mesh_shading import prepared
from . import cache_kernels, light_kernels, world_kernels
from .bands import launch
from .lights import Emitters, Lights, emission_of, emitters

MAX_TRIANGLES = 20_000_000
MAX_LAMPS = 256
_OUTWARD_RAYS = 24
_HIDDEN = 0.06  # share of a face's light that leaves its lamp under which it is left out


@dataclass(frozen=True)
class Geometry:
    """All triangles in the world's frame, opaque ones first: corners [F, 3, 3] and their normals [F, 3, 3], the
    instance [F] and row of the materials' table [F] of each, texture coordinates [F, 3, 2] [m] and ``opaque``, the
    number of those that hide what is behind them."""

    corners: np.ndarray
    normals: np.ndarray
    uvs: np.ndarray
    instance: np.ndarray
    material: np.ndarray
    materials: tuple[Material, ...]
    emission: np.ndarray
    opaque: int
    emitters: Emitters


def collect(instances: Sequence[Instance], lights: Lights) -> Geometry:
    """The triangles of all instances.

    Raises:
        InputError: nothing to draw, more than `MAX_TRIANGLES`, or a transform that is not finite, not 4x4, or flat.
    """
    corners, normals, uvs, owner, look, emission, lamps = [], [], [], [], [], [], []
    materials: list[Material] = []
    if sum(len(one.mesh.faces) for one in instances) > MAX_TRIANGLES:
        raise InputError(f"instances: more than {MAX_TRIANGLES} triangles")
    for number, one in enumerate(instances):
        mesh, matrix = one.mesh, checked(one.transform, number)
        if not len(mesh.faces):
            continue
        turn = np.linalg.inv(matrix[:3, :3])
        placed = (mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])[mesh.faces]
        bent = prepared(mesh) @ turn
        bent = bent / np.maximum(np.linalg.norm(bent, axis=1, keepdims=True), 1e-12)
        area = np.linalg.norm(np.cross(placed[:, 1] - placed[:, 0], placed[:, 2] - placed[:, 0]), axis=1) / 2
        shine = emission_of(mesh, area, lights)
        bright = shine.max(axis=1)[mesh.face_material] > 0
        if bright.any():
            lamps.append((placed[bright], shine[mesh.face_material[bright]], number))
        corners.append(placed)
        normals.append(bent.reshape(-1, 3, 3))
        uvs.append(textures.uv_of(mesh))
        owner.append(np.full(len(mesh.faces), number))
        look.append(mesh.face_material + len(materials))
        materials += mesh.materials
        emission.append(shine)
    if not corners:
        raise InputError("instances: there is nothing to draw")
    lamps.sort(key=lambda lamp: -float(lamp[1].sum()))
    row = np.concatenate(look)
    clear = np.array([material.opacity < 0.999 for material in materials])[row]
    order = np.argsort(clear, kind="stable")
    return Geometry(
        np.concatenate(corners)[order],
        np.concatenate(normals)[order],
        np.concatenate(uvs)[order],
        np.concatenate(owner)[order],
        row[order],
        tuple(materials),
        np.concatenate(emission),
        int((~clear).sum()),
        emitters(lamps[:MAX_LAMPS]),
    )


def checked(transform: np.ndarray, number: int) -> np.ndarray:
    """A transform as float64 [4, 4]; InputError when it is none that can be undone."""
    matrix = np.asarray(transform, dtype=np.float64)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or abs(np.linalg.det(matrix[:3, :3])) < 1e-12:
        raise InputError(f"instances[{number}].transform: not a finite 4x4 matrix that can be undone")
    return matrix


def world_on(geometry: Geometry) -> tuple[Any, list]:
    """The world as a struct on the current device, and what must live as long as it is used."""
    world = world_kernels.World()
    first, rest = geometry.corners[: geometry.opaque], geometry.corners[geometry.opaque :]
    speck = np.array([[[0, 0, -1e6], [1e-3, 0, -1e6], [0, 1e-3, -1e6]]], dtype=float)
    kept = [_mesh(first if len(first) else speck)]
    world.solid = kept[0].id
    world.clear_start, world.clear_count = geometry.opaque, len(rest)
    if len(rest):
        kept.append(_mesh(rest))
        world.clear = kept[1].id
    table = MapTable()
    finishes = [_finish(m, e, table) for m, e in zip(geometry.materials, geometry.emission, strict=True)]
    world.normals = wp.array(geometry.normals.reshape(-1, 3), dtype=wp.vec3)
    world.uvs = wp.array(geometry.uvs.reshape(-1, 2), dtype=wp.vec2)
    world.tangents = wp.array(_tangents(geometry.corners, geometry.uvs), dtype=wp.vec3)
    world.face_finish = wp.array(geometry.material, dtype=int)
    world.face_instance = wp.array(geometry.instance, dtype=int)
    world.finishes = wp.array(finishes, dtype=world_kernels.Finish)
    world.patterns, world.colors, world.bumps = table.rows, table.colors, table.bumps
    return world, kept


def lights_on(lights: Lights, found: Emitters, low: np.ndarray, high: np.ndarray) -> Any:
    """The lights as a struct on the current device; ``low`` and ``high`` [3] are the box of the room."""
    light = light_kernels.Lights()
    light.enclosed = int(lights.enclosed)
    light.sun = wp.vec3(*(np.asarray(lights.sun) / np.linalg.norm(lights.sun)))
    for key in ("sun_color", "zenith", "horizon", "ground", "hall"):
        setattr(light, key, wp.vec3(*getattr(lights, key)))
    light.softness, light.view = lights.softness, wp.vec3(lights.view)
    light.low, light.high = wp.vec3(*low), wp.vec3(*high)
    portals = []
    for one in lights.portals:
        portal = light_kernels.Portal()
        portal.corner, portal.ex, portal.ey = wp.vec3(*one.corner), wp.vec3(*one.across), wp.vec3(*one.up)
        portal.normal = wp.vec3(*one.inward)
        portal.area = float(np.linalg.norm(one.across) * np.linalg.norm(one.up))
        portals.append(portal)
    light.portals = wp.array(portals or [light_kernels.Portal()], dtype=light_kernels.Portal)
    light.portal_count = len(portals)
    lamps = [_lamp(found, k) for k in range(len(found.start) - 1)]
    light.lamps = wp.array(lamps or [light_kernels.Lamp()], dtype=light_kernels.Lamp)
    light.lamp_count = len(lamps)
    face_type: Any = light_kernels.LampFace
    faces: Any = np.zeros(max(len(found.corners), 1), dtype=face_type.numpy_dtype())
    if len(found.corners):
        a, b, c = (found.corners[:, k] for k in range(3))
        normal = np.cross(b - a, c - a)
        faces["a"], faces["b"], faces["c"] = a, b, c
        faces["normal"] = normal / np.linalg.norm(normal, axis=1, keepdims=True)
        faces["radiance"], faces["least"] = found.radiance, found.least
        # A triangle is aimed at in proportion to what leaves its lamp.
        for start, end in pairwise(found.start):
            weight = np.cumsum(found.area[start:end] * found.visible[start:end])
            faces["share"][start:end] = weight / weight[-1]
            faces["area"][start:end] = weight[-1] / found.visible[start:end]
    light.faces = wp.array(faces, dtype=face_type)
    return light


def _lamp(found: Emitters, k: int) -> Any:
    start, end = int(found.start[k]), int(found.start[k + 1])
    corners, weight = found.corners[start:end], (found.area * found.visible)[start:end]
    middle = np.average(corners.mean(axis=1), axis=0, weights=weight)
    lamp = light_kernels.Lamp()
    lamp.middle = wp.vec3(*middle)
    lamp.radius = float(np.linalg.norm(corners.reshape(-1, 3) - middle, axis=1).max())
    lamp.flux = float((weight * found.radiance[start:end].mean(axis=1)).sum())
    lamp.start, lamp.count = start, end - start
    return lamp


def seen_of(world: Any, found: Emitters) -> Emitters:
    """Emitters with the share of the light of each that its own lamp lets out, and without those that it hides."""
    count = len(found.corners)
    if not count:
        return found
    share = wp.zeros(count, dtype=float)
    corners = wp.array(found.corners.reshape(-1, 3), dtype=wp.vec3)
    launch(cache_kernels.see_out, count, [world, corners, wp.array(found.owner, dtype=int), _OUTWARD_RAYS], [], [share])
    visible = share.numpy().astype(float)
    kept = visible > _HIDDEN
    lamp = np.repeat(np.arange(len(found.start) - 1), np.diff(found.start))[kept]
    start = np.concatenate([[0], np.cumsum(np.bincount(lamp, minlength=1))[np.unique(lamp)]]).astype(int)
    radiance, least, owner = found.radiance[kept], found.least[kept], found.owner[kept]
    return Emitters(found.corners[kept], radiance, visible[kept], least, owner, start)


def _mesh(corners: np.ndarray) -> wp.Mesh:
    indices = wp.array(np.arange(3 * len(corners)), dtype=int)
    return wp.Mesh(points=wp.array(corners.reshape(-1, 3), dtype=wp.vec3), indices=indices, bvh_leaf_size=4)


def _finish(material: Material, emission: np.ndarray, table: MapTable) -> Any:
    finish = world_kernels.Finish()
    finish.pattern, gain, rough_gain = table.add(material.texture)
    finish.color = wp.vec3(*(linear_color(material) * gain))
    finish.emission = wp.vec3(*emission)
    finish.roughness = material.roughness * rough_gain
    finish.metallic, finish.opacity = material.metallic, material.opacity
    return finish


def linear_color(material: Material) -> np.ndarray:
    """The base colour [3] in linear light."""
    color = np.asarray(material.color, dtype=np.float64)
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def _tangents(corners: np.ndarray, uvs: np.ndarray) -> np.ndarray:
    """The direction [F, 3] in which u grows on each triangle."""
    e1, e2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    d1, d2 = uvs[:, 1] - uvs[:, 0], uvs[:, 2] - uvs[:, 0]
    det = d1[:, 0] * d2[:, 1] - d2[:, 0] * d1[:, 1]
    t = (e1 * d2[:, 1:2] - e2 * d1[:, 1:2]) * np.sign(det)[:, None]
    t = np.where(np.linalg.norm(t, axis=1, keepdims=True) > 1e-12, t, e1)
    return t / np.maximum(np.linalg.norm(t, axis=1, keepdims=True), 1e-12)


def bounds_of(mesh_corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner [3] of triangles [F, 3, 3], a little widened."""
    flat = mesh_corners.reshape(-1, 3)
    return flat.min(axis=0) - 0.05, flat.max(axis=0) + 0.05


__all__ = ["Geometry", "Mesh", "bounds_of", "collect", "lights_on", "world_on"]
