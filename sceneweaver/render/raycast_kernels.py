"""Pictures by ray casting against one ``wp.Mesh``: sun with soft shadow, sky with occlusion, glass, mirrors, textures.

One thread a pixel, on CPU and CUDA alike. Diffuse light is written apart from colour, so that it can be smoothed
without blurring edges or textures. Pixels of a tile as large as the smoothing window share one even point sequence,
each a stretch of its own (interleaved sampling, Keller and Heidrich 2001), so a full window has next to no noise. The
pattern depends on the pixel only: equal scenes give equal pictures.
"""

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

_PI = wp.constant(3.14159265)
_FAR = wp.constant(1.0e4)
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
class Lens:
    """A camera: ``right`` and ``up`` are as long as half the picture at distance 1 (or half the width [m], flat)."""

    eye: wp.vec3
    forward: wp.vec3
    right: wp.vec3
    up: wp.vec3
    flat: int


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
def _even(k: int):
    """Point k of Roberts' R2 sequence, in the unit square; in integers, so that it stays even for large k."""
    x = wp.uint32(k) * _R2_X + _HALF
    y = wp.uint32(k) * _R2_Y + _HALF
    return wp.vec2(float(x >> wp.uint32(8)) * (1.0 / 16777216.0), float(y >> wp.uint32(8)) * (1.0 / 16777216.0))


@wp.func
def _tangent(n: wp.vec3):
    """Any unit vector across n."""
    a = wp.vec3(1.0, 0.0, 0.0)
    if wp.abs(n[0]) > 0.7:
        a = wp.vec3(0.0, 1.0, 0.0)
    return wp.normalize(wp.cross(n, a))


@wp.func
def _sky(direction: wp.vec3, light: Light):
    """What a ray sees that hits nothing: bright above, the ground's colour below."""
    t = wp.clamp(0.5 + 0.5 * direction[2], 0.0, 1.0)
    return light.ground * (1.0 - t) + light.sky * t


@wp.func
def _wave(p: wp.vec3, seed: int):
    return wp.noise(wp.rand_init(seed), p)


@wp.func
def _textured(look: Look, p: wp.vec3, grain: int):
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
def _open(solid: Solid, origin: wp.vec3, direction: wp.vec3, reach: float):
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
def _around(solid: Solid, light: Light, origin: wp.vec3, direction: wp.vec3):
    """The light that comes from the surroundings: the sky, or a near surface that throws light back in its colour."""
    sky = _sky(direction, light)
    if light.bounce <= 0.0:
        return sky * (0.28 + 0.72 * _open(solid, origin, direction, light.reach))
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
def _lamplight(solid: Solid, light: Light, point: wp.vec3, n: wp.vec3):
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
def _point(solid: Solid, face: int, u: float, v: float):
    """A point of a triangle in its object's frame."""
    a, b, c = (
        solid.local[solid.faces[3 * face]],
        solid.local[solid.faces[3 * face + 1]],
        solid.local[solid.faces[3 * face + 2]],
    )
    return a * u + b * v + c * (1.0 - u - v)


@wp.func
def _normal(solid: Solid, face: int, u: float, v: float, facing: wp.vec3, flat: wp.vec3):
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
def _glimpse(solid: Solid, light: Light, origin: wp.vec3, direction: wp.vec3):
    """What a mirror shows: the first thing hit in plain light, or the sky."""
    hit = wp.mesh_query_ray(solid.mesh, origin, direction, _FAR)
    seen = _sky(direction, light)
    if hit.result:
        look = solid.looks[solid.face_look[hit.face]]
        color = _textured(look, _point(solid, hit.face, hit.u, hit.v), solid.face_grain[hit.face])
        n = hit.normal
        if wp.dot(n, direction) > 0.0:
            n = -n
        lit = _sky(n, light) * 0.75 + light.sun_color * (wp.max(wp.dot(n, light.sun), 0.0) * 0.6 / _PI)
        seen = wp.cw_mul(color, lit) + color * look.emission
    return seen


@wp.kernel
def cast(
    # Problem:
    solid: Solid,
    lens: Lens,
    light: Light,
    background: wp.vec3,
    pixels: wp.array(dtype=int),
    width: int,
    height: int,
    start: int,
    rays: int,
    shades: int,
    period: int,
    # State out:
    color_out: wp.array(dtype=wp.vec3),
    light_out: wp.array(dtype=wp.vec3),
    shine_out: wp.array(dtype=wp.vec3),
    normal_out: wp.array(dtype=wp.vec3),
    depth_out: wp.array(dtype=float),
    object_out: wp.array(dtype=int),
):
    """Colour, diffuse light, shine and normal of some pixels, means over ``rays`` rays; depth and object of the middle.

    Light is sampled alike in tiles of ``period`` pixels; depth is a distance along the ray.
    """
    pixel = pixels[start + wp.tid()]
    px, py = pixel % width, pixel // width
    # Rows are shifted against each other: else points in a column have nearly one direction, and shadows are streaky.
    tile = (py % period) * period + (px + 2 * (py % period)) % period
    color, lit, shine, mean = wp.vec3(0.0), wp.vec3(0.0), wp.vec3(0.0), wp.vec3(0.0)
    depth = float(_FAR)
    cover = float(0.0)
    first = int(-1)
    for s in range(rays):
        # The same even pattern in every pixel (Roberts' R2 sequence) makes clean edges.
        jx = (0.5 + 0.7548776662 * float(s)) % 1.0
        jy = (0.5 + 0.5698402910 * float(s)) % 1.0
        x = 2.0 * (float(px) + jx) / float(width) - 1.0
        y = 1.0 - 2.0 * (float(py) + jy) / float(height)
        at = lens.eye
        way = lens.forward
        if lens.flat == 1:
            at = at + lens.right * x + lens.up * y
        else:
            way = wp.normalize(way + lens.right * x + lens.up * y)
        through = float(1.0)
        for layer in range(6):
            hit = wp.mesh_query_ray(solid.mesh, at, way, _FAR)
            if not hit.result:
                shine = shine + background * through
                break
            look = solid.looks[solid.face_look[hit.face]]
            point = at + way * hit.t
            n = _normal(solid, hit.face, hit.u, hit.v, way, hit.normal)
            flat = hit.normal
            if wp.dot(flat, way) > 0.0:
                flat = -flat
            if layer == 0:
                mean = mean + n
                if s == 0:
                    depth = hit.t
                    first = solid.face_object[hit.face]
            opacity = look.opacity
            facing = wp.max(-wp.dot(n, way), 0.0)
            gloss = (1.0 - look.roughness) * (1.0 - look.roughness)
            fresnel = 0.04 + 0.96 * wp.pow(1.0 - facing, 5.0)
            if opacity < 0.999:
                opacity = wp.max(opacity, fresnel)
            base = _textured(look, _point(solid, hit.face, hit.u, hit.v), solid.face_grain[hit.face])
            share = through * opacity
            origin = point + flat * 2.0e-4
            # The sky, with what stands before it: directions in proportion to the cosine.
            t1 = _tangent(n)
            t2 = wp.cross(n, t1)
            around = wp.vec3(0.0)
            for k in range(shades):
                i = s * shades + k
                e = _even(tile * rays * shades + i)
                r = wp.sqrt(e[0])
                a = 2.0 * _PI * e[1]
                d = t1 * (r * wp.cos(a)) + t2 * (r * wp.sin(a)) + n * wp.sqrt(wp.max(0.0, 1.0 - r * r))
                if wp.dot(d, flat) > 0.0:
                    # What is shaded still gets some light that others throw back.
                    around = around + _around(solid, light, origin, d)
                else:
                    around = around + _sky(d, light) * 0.28
            around = around * (1.0 / float(shades))
            # The sun, a little disc.
            b1 = _tangent(light.sun)
            b2 = wp.cross(light.sun, b1)
            f = _even(tile * rays + s)
            ra = light.softness * wp.sqrt(f[0])
            aa = 2.0 * _PI * f[1]
            toward = wp.normalize(light.sun + b1 * (ra * wp.cos(aa)) + b2 * (ra * wp.sin(aa)))
            cosine = wp.dot(n, toward)
            sun = wp.vec3(0.0)
            if cosine > 0.0 and wp.dot(flat, toward) > 0.0:
                sun = light.sun_color * (cosine * _open(solid, origin, toward, 40.0))
            if light.beam_color[0] > 0.0 and point[2] > light.beam_floor:
                c1 = _tangent(light.beam)
                c2 = wp.cross(light.beam, c1)
                rb = light.beam_softness * wp.sqrt(f[1])
                ab = 2.0 * _PI * f[0]
                slant = wp.normalize(light.beam + c1 * (rb * wp.cos(ab)) + c2 * (rb * wp.sin(ab)))
                lean = wp.dot(n, slant)
                if lean > 0.0 and wp.dot(flat, slant) > 0.0:
                    held = wp.mesh_query_ray(solid.shutters, origin, slant, 60.0)
                    if not held.result:
                        sun = sun + light.beam_color * (lean * _open(solid, origin, slant, 40.0))
            if light.lamps > 0:
                around = around + _lamplight(solid, light, point, n)
            diffuse = base * ((1.0 - look.metallic) * share)
            color = color + diffuse
            lit = lit + (around + sun) * share
            cover = cover + share
            # Reflection: a mirror's, or only a shimmer of sky.
            mirrored = way + n * (2.0 * facing)
            tint = base * look.metallic + wp.vec3(fresnel * gloss) * (1.0 - look.metallic)
            strength = wp.max(tint[0], wp.max(tint[1], tint[2]))
            if strength > 0.003:
                seen = _sky(mirrored, light) * 0.9
                if strength > 0.15 and look.roughness < 0.5:
                    seen = _glimpse(solid, light, origin, wp.normalize(mirrored))
                else:
                    seen = wp.cw_mul(seen, around) * 0.9
                half = wp.normalize(light.sun - way)
                sharp = 2.0 / wp.max(look.roughness * look.roughness * look.roughness * look.roughness, 1.0e-3)
                glint = wp.pow(wp.max(wp.dot(n, half), 0.0), wp.min(sharp, 400.0)) * wp.min(sharp, 400.0) * 0.02
                seen = seen + sun * wp.min(glint, 4.0)
                shine = shine + wp.cw_mul(tint, seen) * share
            shine = shine + base * (look.emission * 1.6 * share)
            through = through * (1.0 - opacity)
            if through < 0.02:
                break
            at = point + way * 1.0e-4
    scale = 1.0 / float(rays)
    color_out[pixel] = color * scale
    # Colour already holds how much of the pixel is covered; light must not hold it once more, or edges are dark.
    light_out[pixel] = lit / wp.max(cover, 1.0e-6)
    shine_out[pixel] = shine * scale
    # A unit vector at edges, too, where it is a mean: light is then smoothed along the edge.
    normal_out[pixel] = mean / wp.max(wp.length(mean), 1.0e-6)
    depth_out[pixel] = depth
    object_out[pixel] = first


@wp.kernel
def develop(
    # Problem:
    width: int,
    height: int,
    start: int,
    radius: int,
    exposure: float,
    # State in:
    color: wp.array(dtype=wp.vec3),
    light: wp.array(dtype=wp.vec3),
    shine: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    # State out:
    picture_out: wp.array(dtype=wp.vec3),
):
    """Smooth the diffuse light among pixels of one object and one direction, and bring it to sRGB."""
    pixel = start + wp.tid()
    px, py = pixel % width, pixel // width
    n = normal[pixel]
    far = depth[pixel]
    total = wp.vec3(0.0)
    weight = float(0.0)
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            x, y = px + dx, py + dy
            if x >= 0 and x < width and y >= 0 and y < height:
                other = y * width + x
                if objects[other] == objects[pixel]:
                    alike = wp.max(0.0, wp.dot(n, normal[other]))
                    gap = wp.abs(depth[other] - far) / wp.max(0.02 * far, 1.0e-3)
                    a2 = alike * alike
                    a4 = a2 * a2
                    a8 = a4 * a4
                    w = a8 * a8 * a8 * wp.exp(-gap * gap) + 1.0e-4 * wp.where(other == pixel, 1.0, 0.0)
                    total = total + light[other] * w
                    weight = weight + w
    lit = total / weight
    linear = (wp.cw_mul(color[pixel], lit) + shine[pixel]) * exposure
    out = wp.vec3(0.0)
    for k in range(3):
        v = linear[k]
        # Straight for most of the range, then a soft shoulder.
        if v > 0.7:
            v = 0.7 + 0.3 * (1.0 - wp.exp(-(v - 0.7) / 0.3))
        if v <= 0.0031308:
            v = 12.92 * v
        else:
            v = 1.055 * wp.pow(v, 1.0 / 2.4) - 0.055
        out[k] = wp.clamp(v, 0.0, 1.0)
    picture_out[pixel] = out
