"""What a camera sees: surfaces through panes and in mirrors, their light before and after it is smoothed."""

import warp as wp

from .light_kernels import (
    Lights,
    beam_light,
    bounced_light,
    clamped,
    escaped_light,
    glow_light,
    hazy,
    in_room,
    lamp_light,
    light_around,
    outdoor_light,
    seen_outside,
    sun_light,
    window_light,
)
from .ray_kernels import FAR, Lens, Ray, camera_ray, even_point, hit_any
from .sampling_kernels import glossy_direction, glossy_lobe, reflected, split_sum
from .world_kernels import OFFSET, Cache, World, diffuse_of, luminance, passed, schlick, shade_of

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})

_LAYERS = wp.constant(10)  # surfaces that a ray goes on from at most
_MATT = wp.constant(0.62)  # roughness from which on gloss is taken from the diffuse light
_SHARP = wp.constant(0.28)  # roughness under which only the ray that follows the gloss sees windows and lamps
_MIRROR = wp.constant(0.13)  # roughness of metal under which a ray goes on as in a mirror


@wp.struct
class Seen:
    """What a ray ends at, past panes and mirrors: a point with its normals, and how its light makes up the pixel.

    The pixel is ``color`` times diffuse light, plus ``gloss`` times reflected light, plus ``shine``. ``instance`` is
    -1 where it ends nowhere, ``path`` tells what is seen directly, in a mirror and through panes apart.
    ``glossy_point``, ``glossy_normal`` and ``glossy_way`` are where reflected light comes from: the first pane, if any.
    """

    point: wp.vec3
    way: wp.vec3
    normal: wp.vec3
    bump: wp.vec3
    flat: wp.vec3
    color: wp.vec3
    gloss: wp.vec3
    shine: wp.vec3
    roughness: float
    depth: float
    instance: int
    path: int
    glossy_point: wp.vec3
    glossy_normal: wp.vec3
    glossy_way: wp.vec3
    glossy_roughness: float
    first_instance: int
    first_depth: float
    first_normal: wp.vec3
    first_color: wp.vec3


@wp.func
def pixel_width(lens: Lens, height: int):
    """The width of a pixel [m] where the ray starts, and what it grows by over a metre."""
    width = 2.0 * wp.length(lens.up) / float(height)
    if lens.flat == 1:
        return wp.vec2(width, 0.0)
    return wp.vec2(0.0, width)


# Over 80 lines: one walk along a ray, whose state would have to be handed from part to part.
@wp.func
def what_is_seen(world: World, lights: Lights, cache: Cache, ray: Ray, width: wp.vec2):
    """Follow a ray, whose width is that of a pixel, to the surface whose light it brings."""
    seen = Seen()
    seen.instance = -1
    seen.first_instance = -1
    seen.first_depth = FAR
    at = ray.origin
    way = ray.direction
    through = wp.vec3(1.0)
    for layer in range(_LAYERS):
        hit = hit_any(world.meshes, at, way, FAR)
        if hit.face < 0:
            seen.shine = seen.shine + wp.cw_mul(wp.cw_mul(through, seen_outside(lights, at, way)), lights.view)
            seen.depth += 1000.0
            break
        seen.depth += hit.t
        s = shade_of(world, hit, way, width[0] + width[1] * seen.depth, 1 - lights.direct.on)
        p = at + way * hit.t
        if layer == 0:
            seen.first_instance = s.instance
            seen.first_depth = hit.t
            seen.first_normal = s.normal
            seen.first_color = s.color
        facing = wp.max(-wp.dot(s.bump, way), 0.02)
        if s.opacity < 0.999:
            finish = world.finishes[world.face_finish[hit.face]]
            if s.roughness > 0.3:
                # Cloth and frosted panes glow with the light of both sides.
                near = light_around(lights, cache, p, s.flat, wp.vec2(0.5, 0.5))
                far = light_around(lights, cache, p, -s.flat, wp.vec2(0.5, 0.5))
                lit = near * 0.6 + far * 0.4
                seen.shine = seen.shine + wp.cw_mul(wp.cw_mul(through, s.color) * s.opacity, lit)
            elif seen.path < 10000 and s.back == 0:
                seen.path += 10000
                seen.glossy_point = p
                seen.glossy_normal = s.normal
                seen.glossy_way = way
                seen.glossy_roughness = s.roughness
                mirrored = 1.8 * schlick(facing, 0.04)
                seen.gloss = through * wp.min(mirrored, 1.0)
                through = through * (1.0 - wp.min(mirrored, 1.0))
            seen.shine = seen.shine + wp.cw_mul(through, s.emission) * s.opacity
            through = wp.cw_mul(through, passed(finish))
            at = p + way * OFFSET
        elif s.metallic > 0.9 and s.roughness < _MIRROR and seen.path % 10000 < 300:
            rim = wp.vec3(1.0) - s.color
            through = wp.cw_mul(through, s.color + rim * schlick(facing, 0.0))
            seen.path += 100
            at = p + s.flat * OFFSET
            way = reflected(way, s.normal)
        else:
            seen.shine = seen.shine + wp.cw_mul(through, s.emission)
            seen.point = p
            seen.way = way
            seen.normal = s.normal
            seen.bump = s.bump
            seen.flat = s.flat
            seen.roughness = s.roughness
            seen.instance = s.instance
            if in_room(lights, p) == 0:
                lit = wp.cw_mul(diffuse_of(s), outdoor_light(lights, s.normal))
                seen.shine = seen.shine + wp.cw_mul(wp.cw_mul(through, hazy(lights, lit, seen.depth)), lights.view)
                break
            f0 = wp.vec3(0.04 * (1.0 - s.metallic)) + s.color * s.metallic
            fit = split_sum(s.roughness, facing)
            thrown = f0 * fit[0] + wp.vec3(fit[1])
            if lights.direct.on == 1:
                # Plain light comes from everywhere: a rough surface would have a veil of it over its colour.
                thrown = thrown * (1.0 - (1.0 - s.metallic) * (2.0 - s.roughness) * s.roughness)
            seen.color = wp.cw_mul(through, s.color) * ((1.0 - s.metallic) * (1.0 - thrown[0] * (1.0 - s.metallic)))
            if seen.path < 10000:
                seen.gloss = wp.cw_mul(through, thrown)
                seen.glossy_point = p
                seen.glossy_normal = s.bump
                seen.glossy_way = way
                seen.glossy_roughness = s.roughness
            break
    if seen.instance < 0:
        seen.normal = -way
        seen.point = at + way * 1000.0
    return seen


@wp.func
def reflected_light(world: World, lights: Lights, cache: Cache, seen: Seen, e: wp.vec2, k: int):
    """Radiance that a glossy surface or pane reflects, by one ray."""
    way = glossy_direction(seen.glossy_way, seen.glossy_normal, seen.glossy_roughness, e)
    at = seen.glossy_point + seen.glossy_normal * OFFSET
    if wp.dot(way, seen.glossy_normal) <= 0.0:
        return wp.vec3(0.0)
    hit = hit_any(world.meshes, at, way, FAR)
    share = wp.vec3(1.0)
    for _layer in range(3):
        if hit.face >= 0:
            finish = world.finishes[world.face_finish[hit.face]]
            if finish.opacity < 0.999:
                share = wp.cw_mul(share, passed(finish))
                at = at + way * (hit.t + OFFSET)
                hit = hit_any(world.meshes, at, way, FAR)
    sharp = seen.glossy_roughness < _SHARP
    if hit.face < 0:
        if sharp:
            return wp.cw_mul(share, seen_outside(lights, at, way))
        return wp.cw_mul(share, escaped_light(lights, at, way))
    s = shade_of(world, hit, way, 0.01 + 0.3 * seen.glossy_roughness * hit.t, 0)
    p = at + way * hit.t
    if in_room(lights, p) == 0:
        return wp.cw_mul(share, wp.cw_mul(diffuse_of(s), outdoor_light(lights, s.normal))) * wp.where(sharp, 1.0, 0.0)
    lit = wp.cw_mul(diffuse_of(s), light_around(lights, cache, p, s.flat, even_point(k * 3 + 1)))
    if sharp:
        lit = lit + s.emission
    return wp.cw_mul(share, lit)


@wp.func
def is_matt(lights: Lights, seen: Seen):
    """Whether what is reflected is as blurred as diffuse light, which then stands for it; sooner so in plain light."""
    least = wp.where(lights.direct.on == 1, _SHARP, _MATT)
    return wp.where(seen.glossy_roughness > least and seen.path < 10000, 1, 0)


@wp.func
def all_sun(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """Irradiance over pi by the sun, and by the beam of plain light."""
    return sun_light(world, lights, p, n, flat, e) + beam_light(world, lights, p, n, flat, wp.vec2(e[1], e[0]))


# Over 80 lines and 10 parameters: all light of a pixel by one thread, numbers of rays in and arrays out.
@wp.kernel
def light_pixels(
    # Problem:
    world: World,
    lights: Lights,
    cache: Cache,
    lens: Lens,
    order: wp.array(dtype=int),
    width: int,
    height: int,
    spacing: int,
    windows: int,
    lamps: int,
    bounces: int,
    suns: int,
    start: int,
    # State out:
    soft_out: wp.array(dtype=wp.vec4),
    sun_out: wp.array(dtype=wp.vec3),
    gloss_out: wp.array(dtype=wp.vec3),
    toward_out: wp.array(dtype=wp.vec3),
    point_out: wp.array(dtype=wp.vec3),
    normal_out: wp.array(dtype=wp.vec3),
    key_out: wp.array(dtype=int),
):
    """Light at one pixel of each block of ``spacing`` pixels, with its variance, and what it falls on.

    ``order`` [64 * 64] is the place of a pixel on a Hilbert curve: along it neighbours take points of one even
    sequence, so that the noise of a neighbourhood averages out.
    """
    i = start + wp.tid()
    columns = (width + spacing - 1) // spacing
    rows = (height + spacing - 1) // spacing
    x, y = i % columns, i // columns
    place = order[(y % 64) * 64 + x % 64]
    px = (float(x) + 0.5) * float(width) / float(columns)
    py = (float(y) + 0.5) * float(height) / float(rows)
    seen = what_is_seen(world, lights, cache, camera_ray(lens, px, py, width, height), pixel_width(lens, height))
    point_out[i] = seen.point
    normal_out[i] = seen.normal
    key_out[i] = wp.where(seen.instance < 0, -1, seen.instance + 65536 * (seen.path // 100 + 1))
    gloss = wp.vec3(0.0)
    soft = wp.vec3(0.0)
    sun = wp.vec3(0.0)
    toward = wp.vec3(0.0)
    square = float(0.0)
    if luminance(seen.color) + luminance(seen.gloss) > 1.0e-4 and seen.instance >= 0:
        p, n, flat = seen.point, seen.normal, seen.flat
        most = 40.0
        aside = seen.path < 10000 and seen.glossy_roughness >= _SHARP and seen.glossy_roughness <= _MATT
        rough = wp.max(seen.glossy_roughness, 0.12)
        if lights.portal_count > 0:
            for k in range(windows):
                a = window_light(world, lights, p, n, flat, even_point(place * windows + k))
                c = clamped(a.light, most) / float(windows)
                soft = soft + c
                toward = toward + a.way * luminance(c)
                square += luminance(c) * luminance(c)
                if aside:
                    gloss = gloss + c * glossy_lobe(-seen.way, seen.glossy_normal, rough, a.way)
        if lights.lamp_count > 0:
            for k in range(lamps):
                a = lamp_light(world, lights, p, n, flat, place * lamps + k)
                c = clamped(a.light, most) / float(lamps)
                soft = soft + c
                toward = toward + a.way * luminance(c)
                square += luminance(c) * luminance(c)
                if aside:
                    gloss = gloss + c * glossy_lobe(-seen.way, seen.glossy_normal, rough, a.way)
        for k in range(bounces):
            a = bounced_light(world, lights, cache, p, n, flat, even_point(place * bounces + k), place * bounces + k)
            c = clamped(a.light, most) / float(bounces)
            soft = soft + c
            toward = toward + a.way * luminance(c)
            square += luminance(c) * luminance(c)
        if lights.direct.on == 1:
            soft = soft + glow_light(lights, p, n)
        least = float(1.0e6)
        for k in range(suns):
            c = all_sun(world, lights, p, n, flat, even_point(place * suns + k))
            least = wp.min(least, luminance(c))
            sun = sun + c / float(suns)
        if luminance(sun) > 1.05 * least:
            # At the rim of a patch of sun more rays tell how much of the disc is seen.
            sun = sun * 0.2
            for k in range(4 * suns):
                e = even_point((place + 4096) * 4 * suns + k)
                sun = sun + all_sun(world, lights, p, n, flat, e) / float(5 * suns)
        if seen.path < 10000 and is_matt(lights, seen) == 0:
            gloss = gloss + clamped(sun * glossy_lobe(-seen.way, seen.glossy_normal, rough, lights.sun), 12.0)
    bright = luminance(soft)
    rays = float(windows + lamps + bounces)
    soft_out[i] = wp.vec4(soft[0], soft[1], soft[2], wp.max(square - bright * bright / rays, 0.0))
    sun_out[i] = sun
    toward_out[i] = toward / wp.max(bright, 1.0e-6)
    if luminance(seen.gloss) > 1.0e-4:
        if is_matt(lights, seen) == 0:
            gloss = gloss + clamped(reflected_light(world, lights, cache, seen, even_point(place), place), 12.0)
    gloss_out[i] = gloss
