"""The world of a picture: triangles, materials, maps and lights of all instances, also as structs on a device."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.assets import textures
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.by_identity import ByIdentity
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError

from ..instances import Instance
from . import cache_kernels, light_kernels, world_kernels
from .lights import DirectLights, Emitters, Lights, Portal, areas, emission_of, emitters, linear_color
from .maps import MapTable
from .rays import Triangles, launch

MAX_TRIANGLES = 20_000_000
MAX_LAMPS = 256
_OUTWARD_RAYS = 24
_CREASE = np.cos(np.radians(36.0))
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


def collect(instances: Sequence[Instance], lights: Lights | DirectLights) -> Geometry:
    """The triangles of all instances.

    Raises:
        InputError: nothing to draw, more than `MAX_TRIANGLES`, or a transform that is not finite, not 4x4, or flat.
    """
    corners, normals, uvs, owner, look, emission, lamps = [], [], [], [], [], [], []
    materials: list[Material] = []
    if sum(len(one.mesh.faces) for one in instances) > MAX_TRIANGLES:
        raise InputError(f"instances: more than {MAX_TRIANGLES} triangles")
    for number, one in enumerate(instances):
        checkpoint()
        mesh, matrix = one.mesh, checked(one.transform, number)
        if not len(mesh.faces):
            continue
        turn = np.linalg.inv(matrix[:3, :3])
        placed = (mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])[mesh.faces]
        bent = _prepared(ByIdentity(mesh)) @ turn
        bent = bent / np.maximum(np.linalg.norm(bent, axis=1, keepdims=True), 1e-12)
        shine = emission_of(mesh, areas(placed) if any(m.emission for m in mesh.materials) else None, lights)
        bright = shine.max(axis=1)[mesh.face_material] > 0
        if bright.any() and isinstance(lights, Lights):
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


def triangles_on(geometry: Geometry, device: str) -> Triangles:
    """The triangles on a device, numbered as in ``geometry``."""
    faces = np.arange(3 * len(geometry.corners)).reshape(-1, 3)
    return Triangles(geometry.corners.reshape(-1, 3), faces, device, geometry.opaque)


def world_on(geometry: Geometry, triangles: Triangles) -> Any:
    """The world as a struct on the current device; ``triangles`` have to live as long as it is used."""
    world = world_kernels.World()
    world.meshes = triangles.meshes
    table = MapTable()
    finishes = [_finish(m, e, table) for m, e in zip(geometry.materials, geometry.emission, strict=True)]
    world.normals = wp.array(geometry.normals.reshape(-1, 3), dtype=wp.vec3)
    world.uvs = wp.array(geometry.uvs.reshape(-1, 2), dtype=wp.vec2)
    world.tangents = wp.array(_tangents(geometry.corners, geometry.uvs), dtype=wp.vec3)
    world.face_finish = wp.array(geometry.material, dtype=int)
    world.face_instance = wp.array(geometry.instance, dtype=int)
    world.finishes = wp.array(finishes, dtype=world_kernels.Finish)
    world.patterns, world.colors, world.bumps = table.rows, table.colors, table.bumps
    return world


def lights_on(lights: Lights, found: Emitters, low: np.ndarray, high: np.ndarray) -> Any:
    """The lights as a struct on the current device; ``low`` and ``high`` [3] are the box of the room."""
    light = light_kernels.Lights()
    light.enclosed = int(lights.enclosed)
    light.sun = wp.vec3(*(np.asarray(lights.sun) / np.linalg.norm(lights.sun)))
    for key in ("sun_color", "zenith", "horizon", "ground", "hall"):
        setattr(light, key, wp.vec3(*getattr(lights, key)))
    light.softness, light.view = lights.softness, wp.vec3(lights.view)
    light.low, light.high = wp.vec3(*low), wp.vec3(*high)
    _put_portals(light, lights.portals)
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


def direct_lights_on(lights: DirectLights) -> Any:
    """Plain light as a struct on the current device."""
    light = light_kernels.Lights()
    light.sun = wp.vec3(*(np.asarray(lights.sun) / np.linalg.norm(lights.sun)))
    light.sun_color = wp.vec3(*(np.pi * np.asarray(lights.sun_color)))  # of what a surface at right angles shows
    light.softness, light.view = lights.softness, wp.vec3(1.0)
    _put_portals(light, lights.portals)
    light.lamps = wp.array([light_kernels.Lamp()], dtype=light_kernels.Lamp)
    light.faces = wp.array([light_kernels.LampFace()], dtype=light_kernels.LampFace)
    direct = light_kernels.Direct()
    direct.on = 1
    for key in ("sky", "ground", "background", "beam_color", "glow_color"):
        setattr(direct, key, wp.vec3(*getattr(lights, key)))
    direct.reach, direct.bounce = lights.reach, lights.bounce
    direct.beam = wp.vec3(*(np.asarray(lights.beam) / np.linalg.norm(lights.beam)))
    direct.beam_softness, direct.beam_floor = lights.beam_softness, lights.beam_floor
    direct.glow_count = len(lights.glows)
    direct.glows = wp.array(np.asarray(lights.glows or ((0.0,) * 4,), dtype=np.float32), dtype=wp.vec4)
    light.direct = direct
    return light


def _put_portals(light: Any, found: Sequence[Portal]) -> None:
    portals = []
    for one in found:
        portal = light_kernels.Portal()
        portal.corner, portal.ex, portal.ey = wp.vec3(*one.corner), wp.vec3(*one.across), wp.vec3(*one.up)
        portal.normal = wp.vec3(*one.inward)
        portal.area = float(np.linalg.norm(one.across) * np.linalg.norm(one.up))
        portals.append(portal)
    light.portals = wp.array(portals or [light_kernels.Portal()], dtype=light_kernels.Portal)
    light.portal_count = len(portals)


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
    launch(cache_kernels.see_out, count, [world, corners, wp.array(found.owner, dtype=int), _OUTWARD_RAYS], [share])
    visible = share.numpy().astype(float)
    kept = visible > _HIDDEN
    lamp = np.repeat(np.arange(len(found.start) - 1), np.diff(found.start))[kept]
    start = np.concatenate([[0], np.cumsum(np.bincount(lamp, minlength=1))[np.unique(lamp)]]).astype(int)
    radiance, least, owner = found.radiance[kept], found.least[kept], found.owner[kept]
    return Emitters(found.corners[kept], radiance, visible[kept], least, owner, start)


def _finish(material: Material, emission: np.ndarray, table: MapTable) -> Any:
    finish = world_kernels.Finish()
    finish.pattern, gain, rough_gain = table.add(material.texture)
    finish.plain = wp.vec3(*linear_color(material))
    finish.color = wp.vec3(*(linear_color(material) * gain))
    finish.emission = wp.vec3(*emission)
    finish.roughness = material.roughness * rough_gain
    finish.metallic, finish.opacity = material.metallic, material.opacity
    return finish


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


@lru_cache(maxsize=512)
def _prepared(mesh: ByIdentity[Mesh]) -> np.ndarray:
    """Corner normals [3 F, 3] of a mesh, kept for when it is drawn again."""
    return corner_normals(mesh.it)


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
