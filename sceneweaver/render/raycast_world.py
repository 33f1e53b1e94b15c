"""What a ray meets in one ``wp.Mesh``: materials with textures, glass, sky with occlusion, lamps, mirrors."""

import os

import warp as wp

from .map_kernels import Pattern, map_texel, mip_of
from .point_kernels import PI

if not os.environ.get("SCENEWEAVER_DEBUG"):
    wp.config.log_level = wp.LOG_ERROR  # no greeting, no notes on what is compiled
wp.set_module_options({"enable_backward": False, "fast_math": True})

FAR = wp.constant(1.0e4)
_MIRRORED = wp.constant(0.006)  # width [m] of what a mirror shows of a texture


@wp.struct
class Look:
    """A material: linear base colour, and its numbers; ``pattern`` -1 has no maps, whose tint has a
    ``gain``."""

    color: wp.vec3
    roughness: float
    metallic: float
    opacity: float
    emission: float
    pattern: int
    gain: float


@wp.struct
class Light:
    """The sun's direction (unit, toward it), its softness (tangent of the half angle), colours, and how far walls of
    occlusion are looked for [m]; ``bounce`` is how much light near surfaces throw back in their colour (0: a plain
    share). The beam is a second sun that the shutters hold off, and ``lamps`` the number of small lights."""

    sun: wp.vec3
    softness: float
    sun_color: wp.vec3
    sky: wp.vec3
    ground: wp.vec3
    reach: float
    bounce: float
    beam: wp.vec3
    beam_softness: float
    beam_color: wp.vec3
    beam_floor: float
    lamp_color: wp.vec3
    lamps: int


@wp.struct
class Solid:
    """The world: a mesh, its normals and texture coordinates [m] at triangle corners, looks and object numbers.

    ``shutters`` is a mesh that nobody sees: it only holds off the beam. ``lamps`` are small lights: place, power.
    """

    mesh: wp.uint64
    normals: wp.array(dtype=wp.vec3)
    looks: wp.array(dtype=Look)
    face_look: wp.array(dtype=int)
    face_object: wp.array(dtype=int)
    uvs: wp.array(dtype=wp.vec2)
    patterns: wp.array(dtype=Pattern)
    colors: wp.array(dtype=wp.uint32)
    shutters: wp.uint64
    lamps: wp.array(dtype=wp.vec4)


@wp.func
def sky_light(direction: wp.vec3, light: Light):
    """What a ray sees that hits nothing: bright above, the ground's colour below."""
    t = wp.clamp(0.5 + 0.5 * direction[2], 0.0, 1.0)
    return light.ground * (1.0 - t) + light.sky * t


@wp.func
def textured(solid: Solid, look: Look, face: int, u: float, v: float, footprint: float):
    """The base colour at a point of a triangle, seen by a ray that is ``footprint`` [m] wide there."""
    if look.pattern < 0:
        return look.color
    pattern = solid.patterns[look.pattern]
    f = 3 * face
    uv = solid.uvs[f] * u + solid.uvs[f + 1] * v + solid.uvs[f + 2] * (1.0 - u - v)
    uv = wp.cw_mul(uv, pattern.scale)
    uv = wp.vec2(uv[0] - wp.floor(uv[0]), uv[1] - wp.floor(uv[1]))
    tint = map_texel(solid.colors, pattern, mip_of(pattern, footprint), uv, 1)
    return wp.cw_mul(look.color, wp.vec3(tint[0], tint[1], tint[2])) * look.gain


@wp.func
def passed_light(solid: Solid, origin: wp.vec3, direction: wp.vec3, reach: float):
    """How much light comes along a ray: 0 where something stands in its way; glass lets most of it through."""
    at = origin
    left = reach
    share = float(1.0)
    for _k in range(4):
        hit = wp.mesh_query_ray(solid.mesh, at, direction, left)
        if not hit.result:
            break
        look = solid.looks[solid.face_look[hit.face]]
        if look.emission > 0.5:
            break
        share = share * (1.0 - look.opacity)
        if share < 0.02:
            share = 0.0
            break
        at = at + direction * (hit.t + 1.0e-4)
        left = left - hit.t - 1.0e-4
    return share


@wp.func
def ambient_light(solid: Solid, light: Light, origin: wp.vec3, direction: wp.vec3):
    """The light that comes from the surroundings: the sky, or a near surface that throws light back in its colour."""
    sky = sky_light(direction, light)
    if light.bounce <= 0.0:
        return sky * (0.28 + 0.72 * passed_light(solid, origin, direction, light.reach))
    seen = sky
    hit = wp.mesh_query_ray(solid.mesh, origin, direction, light.reach)
    if hit.result:
        look = solid.looks[solid.face_look[hit.face]]
        if look.emission <= 0.5:
            # What is near hides all of the sky, what is far hardly any of it: there is no edge where the reach ends.
            far = hit.t / light.reach
            share = look.opacity * (1.0 - far * far)
            thrown = wp.cw_mul(look.color * 0.75 + wp.vec3(0.12), light.sky) * light.bounce
            seen = sky * (1.0 - share) + thrown * share
    return seen


@wp.func
def lamp_light(solid: Solid, light: Light, point: wp.vec3, n: wp.vec3):
    """The soft light of small lamps near by; it throws no shadows."""
    total = float(0.0)
    for k in range(light.lamps):
        lamp = solid.lamps[k]
        gap = wp.vec3(lamp[0], lamp[1], lamp[2]) - point
        square = wp.dot(gap, gap)
        if square < 9.0:
            facing = wp.max(0.0, 0.25 + 0.75 * wp.dot(n, gap) / wp.sqrt(square + 1.0e-6))
            fade = 1.0 - square / 9.0
            total = total + lamp[3] * facing * fade * fade / (0.12 + square)
    return light.lamp_color * total


@wp.func
def shading_normal(solid: Solid, face: int, u: float, v: float, facing: wp.vec3, flat: wp.vec3):
    """The smooth normal, turned against the ray; seen from behind a surface is as smooth as from the front."""
    n = solid.normals[3 * face] * u + solid.normals[3 * face + 1] * v + solid.normals[3 * face + 2] * (1.0 - u - v)
    n = wp.normalize(n)
    if wp.dot(flat, facing) > 0.0:
        n = -n
    if wp.dot(n, facing) > -0.02:
        n = flat
        if wp.dot(n, facing) > 0.0:
            n = -n
    return n


@wp.func
def mirrored_light(solid: Solid, light: Light, origin: wp.vec3, direction: wp.vec3):
    """What a mirror shows: the first thing hit in plain light, or the sky."""
    hit = wp.mesh_query_ray(solid.mesh, origin, direction, FAR)
    seen = sky_light(direction, light)
    if hit.result:
        look = solid.looks[solid.face_look[hit.face]]
        color = textured(solid, look, hit.face, hit.u, hit.v, _MIRRORED)
        n = hit.normal
        if wp.dot(n, direction) > 0.0:
            n = -n
        lit = sky_light(n, light) * 0.75 + light.sun_color * (wp.max(wp.dot(n, light.sun), 0.0) * 0.6 / PI)
        seen = wp.cw_mul(color, lit) + color * look.emission
    return seen
