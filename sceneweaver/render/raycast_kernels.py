"""Pictures by ray casting: what a pixel shows, the light that arrives there, and more rays where a pixel needs them.

One thread a pixel, on CPU and CUDA alike. Light is kept apart from what it falls on, so that it can be cast for some
pixels only and smoothed without blurring edges or textures. Pixels of a tile as large as the smoothing window share one
even point sequence, each a stretch of its own (interleaved sampling, Keller and Heidrich 2001), so a full window has
next to no noise. Where a pixel gets several rays, each takes the light of a neighbour on the same surface (subpixel
reconstruction, Chajdas, McGuire and Luebke 2011). The pattern depends on the pixel only: equal scenes, equal pictures.
"""

import warp as wp

from .point_kernels import even_point, tangent
from .raycast_world import (
    FAR,
    PI,
    Light,
    Solid,
    ambient_light,
    lamp_light,
    mirrored_light,
    passed_light,
    shading_normal,
    sky_light,
    textured,
)
from .smoothing_kernels import likeness, tone_mapped

wp.set_module_options({"enable_backward": False, "fast_math": True})

_LAYERS = wp.constant(6)  # surfaces that a ray goes through at most


@wp.struct
class Lens:
    """A camera: ``right`` and ``up`` are as long as half the picture at distance 1 (or half the width [m], flat)."""

    eye: wp.vec3
    forward: wp.vec3
    right: wp.vec3
    up: wp.vec3
    flat: int


@wp.struct
class Ray:
    """Where a ray starts, its direction (unit), and how wide it is [m]: there, and more for each metre."""

    origin: wp.vec3
    direction: wp.vec3
    width: float
    spread: float


@wp.struct
class Surface:
    """What a ray meets first: its triangle, the distance [m], and the smooth normal."""

    face: int
    depth: float
    normal: wp.vec3


@wp.struct
class Seen:
    """What a ray shows: ``color`` times all light, plus ``gloss`` times the ambient and ``glint`` times the sun's, plus
    ``shine``, which needs no light; the first surface, and the instance that it belongs to (-1: none)."""

    color: wp.vec3
    gloss: wp.vec3
    glint: wp.vec3
    shine: wp.vec3
    first: Surface
    instance: int


@wp.struct
class Arriving:
    """Light that arrives at what a ray shows: from the surroundings, and from sun and beam."""

    ambient: wp.vec3
    sun: wp.vec3


@wp.func
def camera_ray(lens: Lens, x: float, y: float, width: int, height: int):
    """The ray through a point of the picture [pixels]."""
    ray = Ray()
    u = 2.0 * x / float(width) - 1.0
    v = 1.0 - 2.0 * y / float(height)
    ray.origin = lens.eye
    ray.direction = lens.forward
    ray.spread = 2.0 * wp.length(lens.right) / float(width)
    if lens.flat == 1:
        ray.width = ray.spread
        ray.spread = 0.0
        ray.origin = lens.eye + lens.right * u + lens.up * v
    else:
        ray.direction = wp.normalize(lens.forward + lens.right * u + lens.up * v)
    return ray


@wp.func
def seen_opacity(opacity: float, fresnel: float):
    """How much a surface hides: panes reflect more, and so hide more, when they are seen from the side."""
    if opacity < 0.999:
        return wp.max(opacity, fresnel)
    return opacity


@wp.func
def what_is_seen(solid: Solid, light: Light, background: wp.vec3, ray: Ray):
    """Colours of all surfaces that a ray meets, through panes, with mirrors, without the light that falls on them."""
    seen = Seen()
    seen.first.depth = FAR
    seen.instance = -1
    at = ray.origin
    way = ray.direction
    through = float(1.0)
    passed = float(0.0)
    for layer in range(_LAYERS):
        hit = wp.mesh_query_ray(solid.mesh, at, way, FAR)
        if not hit.result:
            seen.shine = seen.shine + background * through
            break
        look = solid.looks[solid.face_look[hit.face]]
        n = shading_normal(solid, hit.face, hit.u, hit.v, way, hit.normal)
        if layer == 0:
            seen.first.face = hit.face
            seen.first.depth = hit.t
            seen.first.normal = n
            seen.instance = solid.face_object[hit.face]
        facing = wp.max(-wp.dot(n, way), 0.0)
        gloss = (1.0 - look.roughness) * (1.0 - look.roughness)
        fresnel = 0.04 + 0.96 * wp.pow(1.0 - facing, 5.0)
        opacity = seen_opacity(look.opacity, fresnel)
        share = through * opacity
        footprint = (ray.width + ray.spread * (passed + hit.t)) / wp.sqrt(wp.max(facing, 0.05))
        base = textured(solid, look, hit.face, hit.u, hit.v, footprint)
        seen.color = seen.color + base * ((1.0 - look.metallic) * share)
        # Reflection: a mirror's, or only a shimmer of sky.
        mirrored = way + n * (2.0 * facing)
        tint = base * look.metallic + wp.vec3(fresnel * gloss) * (1.0 - look.metallic)
        strength = wp.max(tint[0], wp.max(tint[1], tint[2]))
        if strength > 0.003:
            if strength > 0.15 and look.roughness < 0.5:
                flat = hit.normal
                if wp.dot(flat, way) > 0.0:
                    flat = -flat
                origin = at + way * hit.t + flat * 2.0e-4
                reflected = mirrored_light(solid, light, origin, wp.normalize(mirrored))
                seen.shine = seen.shine + wp.cw_mul(tint, reflected) * share
            else:
                seen.gloss = seen.gloss + wp.cw_mul(tint, sky_light(mirrored, light)) * (0.81 * share)
            half = wp.normalize(light.sun - way)
            sharp = 2.0 / wp.max(look.roughness * look.roughness * look.roughness * look.roughness, 1.0e-3)
            glint = wp.pow(wp.max(wp.dot(n, half), 0.0), wp.min(sharp, 400.0)) * wp.min(sharp, 400.0) * 0.02
            seen.glint = seen.glint + tint * (wp.min(glint, 4.0) * share)
        seen.shine = seen.shine + base * (look.emission * 1.6 * share)
        through = through * (1.0 - opacity)
        if through < 0.02:
            break
        at = at + way * (hit.t + 1.0e-4)
        passed = passed + hit.t
    return seen


@wp.func
def sunlight(solid: Solid, light: Light, origin: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """The light of the sun, a little disc of which ``e`` is a point, and of the beam."""
    b1 = tangent(light.sun)
    b2 = wp.cross(light.sun, b1)
    ra = light.softness * wp.sqrt(e[0])
    aa = 2.0 * PI * e[1]
    toward = wp.normalize(light.sun + b1 * (ra * wp.cos(aa)) + b2 * (ra * wp.sin(aa)))
    cosine = wp.dot(n, toward)
    sun = wp.vec3(0.0)
    if cosine > 0.0 and wp.dot(flat, toward) > 0.0:
        sun = light.sun_color * (cosine * passed_light(solid, origin, toward, 40.0))
    if light.beam_color[0] > 0.0 and origin[2] > light.beam_floor:
        c1 = tangent(light.beam)
        c2 = wp.cross(light.beam, c1)
        rb = light.beam_softness * wp.sqrt(e[1])
        ab = 2.0 * PI * e[0]
        slant = wp.normalize(light.beam + c1 * (rb * wp.cos(ab)) + c2 * (rb * wp.sin(ab)))
        lean = wp.dot(n, slant)
        if lean > 0.0 and wp.dot(flat, slant) > 0.0:
            if not wp.mesh_query_ray_anyhit(solid.shutters, origin, slant, 60.0):
                sun = sun + light.beam_color * (lean * passed_light(solid, origin, slant, 40.0))
    return sun


@wp.func
def arriving_light(solid: Solid, light: Light, ray: Ray, first: Surface, stretch: int, shades: int, suns: int):
    """The light on what a ray shows, of all surfaces by how much of each is seen.

    ``stretch`` says which stretch of the even sequence is used, for ``shades`` rays to the surroundings and ``suns`` to
    the sun.
    """
    found = Arriving()
    at = ray.origin
    way = ray.direction
    through = float(1.0)
    cover = float(0.0)
    met = first
    for layer in range(_LAYERS):
        if layer > 0:
            hit = wp.mesh_query_ray(solid.mesh, at, way, FAR)
            if not hit.result:
                break
            met.face = hit.face
            met.depth = hit.t
            met.normal = shading_normal(solid, hit.face, hit.u, hit.v, way, hit.normal)
        look = solid.looks[solid.face_look[met.face]]
        n = met.normal
        point = at + way * met.depth
        flat = wp.mesh_eval_face_normal(solid.mesh, met.face)
        if wp.dot(flat, way) > 0.0:
            flat = -flat
        fresnel = 0.04 + 0.96 * wp.pow(1.0 - wp.max(-wp.dot(n, way), 0.0), 5.0)
        opacity = seen_opacity(look.opacity, fresnel)
        share = through * opacity
        origin = point + flat * 2.0e-4
        # The sky, with what stands before it: directions in proportion to the cosine.
        t1 = tangent(n)
        t2 = wp.cross(n, t1)
        around = wp.vec3(0.0)
        for k in range(shades):
            e = even_point(stretch * shades + k)
            r = wp.sqrt(e[0])
            a = 2.0 * PI * e[1]
            d = t1 * (r * wp.cos(a)) + t2 * (r * wp.sin(a)) + n * wp.sqrt(wp.max(0.0, 1.0 - r * r))
            if wp.dot(d, flat) > 0.0:
                # What is shaded still gets some light that others throw back.
                around = around + ambient_light(solid, light, origin, d)
            else:
                around = around + sky_light(d, light) * 0.28
        around = around * (1.0 / float(shades))
        if light.lamps > 0:
            around = around + lamp_light(solid, light, point, n)
        sun = wp.vec3(0.0)
        for k in range(suns):
            sun = sun + sunlight(solid, light, origin, n, flat, even_point(stretch * suns + k))
        found.ambient = found.ambient + around * share
        found.sun = found.sun + sun * (share / float(suns))
        cover = cover + share
        through = through * (1.0 - opacity)
        if through < 0.02:
            break
        at = point + way * 1.0e-4
    # Colour already holds how much of the pixel is covered; light must not hold it once more, or edges are dark.
    found.ambient = found.ambient / wp.max(cover, 1.0e-6)
    found.sun = found.sun / wp.max(cover, 1.0e-6)
    return found


@wp.kernel
def cast(
    # Problem:
    solid: Solid,
    lens: Lens,
    light: Light,
    background: wp.vec3,
    width: int,
    height: int,
    start: int,
    # State out:
    color_out: wp.array(dtype=wp.vec3),
    gloss_out: wp.array(dtype=wp.vec3),
    glint_out: wp.array(dtype=wp.vec3),
    shine_out: wp.array(dtype=wp.vec3),
    normal_out: wp.array(dtype=wp.vec3),
    depth_out: wp.array(dtype=float),
    object_out: wp.array(dtype=int),
    face_out: wp.array(dtype=int),
):
    """What is seen in the middle of each pixel."""
    pixel = start + wp.tid()
    px, py = pixel % width, pixel // width
    seen = what_is_seen(solid, light, background, camera_ray(lens, float(px) + 0.5, float(py) + 0.5, width, height))
    color_out[pixel] = seen.color
    gloss_out[pixel] = seen.gloss
    glint_out[pixel] = seen.glint
    shine_out[pixel] = seen.shine
    normal_out[pixel] = seen.first.normal
    depth_out[pixel] = seen.first.depth
    object_out[pixel] = seen.instance
    face_out[pixel] = seen.first.face


@wp.kernel
def illuminate(
    # Problem:
    solid: Solid,
    lens: Lens,
    light: Light,
    pixels: wp.array(dtype=int),
    width: int,
    height: int,
    start: int,
    spacing: int,
    period: int,
    shades: int,
    suns: int,
    # State in:
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    faces: wp.array(dtype=int),
    # State out:
    ambient_out: wp.array(dtype=wp.vec3),
    sun_out: wp.array(dtype=wp.vec3),
):
    """The light of some pixels, sampled alike in tiles of ``period`` pixels that are ``spacing`` apart.

    It is that of a point anywhere in the pixel, if that is on the surface in its middle: else what is as narrow as a
    pixel would have too much or too little of it.
    """
    pixel = pixels[start + wp.tid()]
    px, py = pixel % width, pixel // width
    column, row = px // spacing, py // spacing
    # Rows are shifted against each other: else points in a column have nearly one direction, and shadows are streaky.
    stretch = (row % period) * period + (column + 2 * (row % period)) % period
    ray = camera_ray(lens, float(px) + 0.5, float(py) + 0.5, width, height)
    first = Surface()
    first.face = faces[pixel]
    first.depth = depth[pixel]
    first.normal = normal[pixel]
    if spacing == 1:
        e = even_point(stretch)
        other = camera_ray(lens, float(px) + e[0], float(py) + e[1], width, height)
        hit = wp.mesh_query_ray(solid.mesh, other.origin, other.direction, FAR)
        if hit.result and solid.face_object[hit.face] == objects[pixel]:
            n = shading_normal(solid, hit.face, hit.u, hit.v, other.direction, hit.normal)
            if likeness(normal[pixel], n, depth[pixel], hit.t) > 0.5:
                ray = other
                first.face = hit.face
                first.depth = hit.t
                first.normal = n
    found = arriving_light(solid, light, ray, first, stretch, shades, suns)
    ambient_out[pixel] = found.ambient
    sun_out[pixel] = found.sun


@wp.kernel
def refine(
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
    exposure: float,
    # State in:
    color: wp.array(dtype=wp.vec3),
    gloss: wp.array(dtype=wp.vec3),
    glint: wp.array(dtype=wp.vec3),
    shine: wp.array(dtype=wp.vec3),
    ambient: wp.array(dtype=wp.vec3),
    sun: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    depth: wp.array(dtype=float),
    objects: wp.array(dtype=int),
    # State out:
    picture_out: wp.array(dtype=wp.vec3),
):
    """Some pixels as means over ``rays`` rays, each in the smooth light of the pixels around on the same surface."""
    pixel = pixels[start + wp.tid()]
    px, py = pixel % width, pixel // width
    total = wp.cw_mul(color[pixel], ambient[pixel] + sun[pixel]) + shine[pixel]
    total = total + wp.cw_mul(gloss[pixel], ambient[pixel]) + wp.cw_mul(glint[pixel], sun[pixel])
    for s in range(1, rays):
        # The same even pattern in every pixel (Roberts' R2 sequence) makes clean edges; its first point is the middle.
        jx = (0.5 + 0.7548776662 * float(s)) % 1.0
        jy = (0.5 + 0.5698402910 * float(s)) % 1.0
        ray = camera_ray(lens, float(px) + jx, float(py) + jy, width, height)
        seen = what_is_seen(solid, light, background, ray)
        lit = Arriving()
        if seen.instance >= 0:
            weight = float(0.0)
            # The four pixels whose middles are around the point.
            left, top = px + int(wp.floor(jx - 0.5)), py + int(wp.floor(jy - 0.5))
            for corner in range(4):
                x, y = left + corner % 2, top + corner // 2
                if x >= 0 and x < width and y >= 0 and y < height:
                    other = y * width + x
                    if objects[other] == seen.instance:
                        gx, gy = float(px - x) + jx - 0.5, float(py - y) + jy - 0.5
                        near = (1.0 - wp.abs(gx)) * (1.0 - wp.abs(gy))
                        w = near * likeness(seen.first.normal, normal[other], seen.first.depth, depth[other])
                        lit.ambient = lit.ambient + ambient[other] * w
                        lit.sun = lit.sun + sun[other] * w
                        weight = weight + w
            if weight > 0.01:
                lit.ambient = lit.ambient / weight
                lit.sun = lit.sun / weight
            else:
                lit = arriving_light(solid, light, ray, seen.first, s, 2, 1)
        total = total + wp.cw_mul(seen.color, lit.ambient + lit.sun) + seen.shine
        total = total + wp.cw_mul(seen.gloss, lit.ambient) + wp.cw_mul(seen.glint, lit.sun)
    picture_out[pixel] = tone_mapped(total * (exposure / float(rays)))
