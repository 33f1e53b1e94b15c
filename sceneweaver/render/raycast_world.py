"""What a ray meets in one ``wp.Mesh``: materials with textures, glass, sky with occlusion, lamps, mirrors."""

import os

import warp as wp

if not os.environ.get("SCENEWEAVER_DEBUG"):
    wp.config.log_level = wp.LOG_ERROR  # no greeting, no notes on what is compiled
wp.set_module_options({"enable_backward": False, "fast_math": True})

PLAIN = wp.constant(0)
WOOD = wp.constant(1)
FABRIC = wp.constant(2)
STONE = wp.constant(3)
METAL = wp.constant(4)
LEAF = wp.constant(5)

PI = wp.constant(3.14159265)
FAR = wp.constant(1.0e4)
_R2_X = wp.constant(wp.uint32(3242174889))  # 2^32 / 1.32471795...
_R2_Y = wp.constant(wp.uint32(2447445414))  # the same squared
_HALF = wp.constant(wp.uint32(2147483648))


@wp.struct
class Look:
    """A material: linear base colour, and its numbers."""

    color: wp.vec3
    roughness: float
    metallic: float
    opacity: float
    emission: float
    texture: int


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
    """The world: a mesh, its normals at triangle corners, looks, object numbers and object coordinates.

    ``shutters`` is a mesh that nobody sees: it only holds off the beam. ``lamps`` are small lights: place, power.
    """

    mesh: wp.uint64
    normals: wp.array(dtype=wp.vec3)
    looks: wp.array(dtype=Look)
    face_look: wp.array(dtype=int)
    face_object: wp.array(dtype=int)
    face_grain: wp.array(dtype=int)
    faces: wp.array(dtype=int)
    local: wp.array(dtype=wp.vec3)
    shutters: wp.uint64
    lamps: wp.array(dtype=wp.vec4)


@wp.func
def even_point(k: int):
    """Point k of Roberts' R2 sequence, in the unit square; in integers, so that it stays even for large k."""
    x = wp.uint32(k) * _R2_X + _HALF
    y = wp.uint32(k) * _R2_Y + _HALF
    return wp.vec2(float(x >> wp.uint32(8)) * (1.0 / 16777216.0), float(y >> wp.uint32(8)) * (1.0 / 16777216.0))


@wp.func
def tangent(n: wp.vec3):
    """Any unit vector across n."""
    a = wp.vec3(1.0, 0.0, 0.0)
    if wp.abs(n[0]) > 0.7:
        a = wp.vec3(0.0, 1.0, 0.0)
    return wp.normalize(wp.cross(n, a))


@wp.func
def sky_light(direction: wp.vec3, light: Light):
    """What a ray sees that hits nothing: bright above, the ground's colour below."""
    t = wp.clamp(0.5 + 0.5 * direction[2], 0.0, 1.0)
    return light.ground * (1.0 - t) + light.sky * t


@wp.func
def _wave(p: wp.vec3, seed: int):
    return wp.noise(wp.rand_init(seed), p)


@wp.func
def textured(look: Look, p: wp.vec3, grain: int):
    """The base colour at a point in the object's frame [m]."""
    c = look.color
    if look.texture == WOOD:
        q = wp.vec3(p[0] * 34.0, p[1] * 34.0, p[2] * 34.0)
        if grain == 0:
            q = wp.vec3(p[0] * 1.7, q[1], q[2])
        elif grain == 1:
            q = wp.vec3(q[0], p[1] * 1.7, q[2])
        else:
            q = wp.vec3(q[0], q[1], p[2] * 1.7)
        rings = _wave(q, 7) + 0.5 * _wave(q * 2.7, 11)
        fine = _wave(wp.cw_mul(q, wp.vec3(4.1, 4.1, 4.1)), 13)
        c = c * (1.0 + 0.16 * rings + 0.06 * fine)
    elif look.texture == FABRIC:
        weave = wp.sin(p[0] * 1400.0) * wp.sin(p[1] * 1400.0) * wp.sin(p[2] * 1400.0)
        c = c * (1.0 + 0.05 * weave + 0.10 * _wave(p * 24.0, 17))
    elif look.texture == STONE:
        veins = 1.0 - wp.abs(_wave(p * 6.0, 19) + 0.5 * _wave(p * 15.0, 23)) * 2.0
        c = c * (1.0 - 0.16 * wp.pow(wp.clamp(veins, 0.0, 1.0), 6.0) + 0.05 * _wave(p * 60.0, 29))
    elif look.texture == METAL:
        c = c * (1.0 + 0.03 * _wave(wp.vec3(p[0] * 30.0, p[1] * 30.0, p[2] * 900.0), 31))
    elif look.texture == LEAF:
        c = c * (1.0 + 0.25 * _wave(p * 22.0, 37))
    return wp.vec3(wp.max(c[0], 0.0), wp.max(c[1], 0.0), wp.max(c[2], 0.0))


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
def local_point(solid: Solid, face: int, u: float, v: float):
    """A point of a triangle in its object's frame."""
    a, b, c = (
        solid.local[solid.faces[3 * face]],
        solid.local[solid.faces[3 * face + 1]],
        solid.local[solid.faces[3 * face + 2]],
    )
    return a * u + b * v + c * (1.0 - u - v)


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
        color = textured(look, local_point(solid, hit.face, hit.u, hit.v), solid.face_grain[hit.face])
        n = hit.normal
        if wp.dot(n, direction) > 0.0:
            n = -n
        lit = sky_light(n, light) * 0.75 + light.sun_color * (wp.max(wp.dot(n, light.sun), 0.0) * 0.6 / PI)
        seen = wp.cw_mul(color, lit) + color * look.emission
    return seen
