"""What a camera sees: surfaces through panes and in mirrors, their light before and after it is smoothed."""

import warp as wp

from .filter_kernels import Grid, Layers
from .light_kernels import (
    Arriving,
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
from .world_kernels import OFFSET, Cache, Shade, World, diffuse_of, luminance, passed, schlick, shade_of

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


@wp.func
def pixel_width(lens: Lens):
    """The width of a pixel [m] where the ray starts, and what it grows by over a metre."""
    width = 2.0 * wp.length(lens.up) / float(lens.height)
    if lens.flat == 1:
        return wp.vec2(width, 0.0)
    return wp.vec2(0.0, width)


@wp.func
def _ended(lights: Lights, seen: Seen, s: Shade, way: wp.vec3, through: wp.vec3):
    """A ray's end, at ``seen.point`` on a surface that it does not go on from; ``through`` is the share of light that
    comes from there."""
    seen.shine = seen.shine + wp.cw_mul(through, s.emission)
    seen.way = way
    seen.normal = s.normal
    seen.bump = s.bump
    seen.flat = s.flat
    seen.roughness = s.roughness
    seen.instance = s.instance
    if in_room(lights, seen.point) == 0:
        lit = wp.cw_mul(diffuse_of(s), outdoor_light(lights, s.normal))
        seen.shine = seen.shine + wp.cw_mul(wp.cw_mul(through, hazy(lights, lit, seen.depth)), lights.view)
        return seen
    f0 = wp.vec3(0.04 * (1.0 - s.metallic)) + s.color * s.metallic
    fit = split_sum(s.roughness, wp.max(-wp.dot(s.bump, way), 0.02))
    thrown = f0 * fit[0] + wp.vec3(fit[1])
    if lights.direct.on == 1:
        # Plain light comes from everywhere: a rough surface would have a veil of it over its colour.
        thrown = thrown * (1.0 - (1.0 - s.metallic) * (2.0 - s.roughness) * s.roughness)
    seen.color = wp.cw_mul(through, s.color) * ((1.0 - s.metallic) * (1.0 - thrown[0] * (1.0 - s.metallic)))
    if seen.path < 10000:
        seen.gloss = wp.cw_mul(through, thrown)
        seen.glossy_point = seen.point
        seen.glossy_normal = s.bump
        seen.glossy_way = way
        seen.glossy_roughness = s.roughness
    return seen


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
        facing = wp.max(-wp.dot(s.bump, way), 0.02)
        if s.opacity < 0.999:
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
            through = wp.cw_mul(through, passed(world.finishes[world.face_finish[hit.face]]))
            at = p + way * OFFSET
        elif s.metallic > 0.9 and s.roughness < _MIRROR and seen.path % 10000 < 300:
            rim = wp.vec3(1.0) - s.color
            through = wp.cw_mul(through, s.color + rim * schlick(facing, 0.0))
            seen.path += 100
            at = p + s.flat * OFFSET
            way = reflected(way, s.normal)
        else:
            seen.point = p
            seen = _ended(lights, seen, s, way, through)
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
def sun_and_beam(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """Irradiance over pi by the sun, and by the beam of plain light."""
    return sun_light(world, lights, p, n, flat, e) + beam_light(world, lights, p, n, flat, wp.vec2(e[1], e[0]))


@wp.func
def key_of(seen: Seen):
    """What tells surfaces apart whose light is not mixed: the instance, how it is seen; -1 for none."""
    return wp.where(seen.instance < 0, -1, seen.instance + 65536 * (seen.path // 100 + 1))


@wp.struct
class Counts:
    """Rays of a pixel to windows, lamps, other surfaces and the sun."""

    windows: int
    lamps: int
    bounces: int
    suns: int


@wp.struct
class Gathered:
    """Sums over the rays of a pixel: soft light, gloss, direction by brightness, and squares of brightness."""

    soft: wp.vec3
    gloss: wp.vec3
    toward: wp.vec3
    square: float


@wp.func
def _with_ray(sums: Gathered, seen: Seen, a: Arriving, rays: int, glossy: bool):
    """The sums with one of some rays more; ``glossy`` surfaces reflect what it brings."""
    c = clamped(a.light, 40.0) / float(rays)
    sums.soft = sums.soft + c
    sums.toward = sums.toward + a.way * luminance(c)
    sums.square += luminance(c) * luminance(c)
    if glossy:
        rough = wp.max(seen.glossy_roughness, 0.12)
        sums.gloss = sums.gloss + c * glossy_lobe(-seen.way, seen.glossy_normal, rough, a.way)
    return sums


@wp.func
def _all_sun(world: World, lights: Lights, seen: Seen, suns: int, place: int):
    """Irradiance over pi by the sun and the beam of plain light."""
    p, n, flat = seen.point, seen.normal, seen.flat
    total = wp.vec3(0.0)
    least = float(1.0e6)
    for k in range(suns):
        c = sun_and_beam(world, lights, p, n, flat, even_point(place * suns + k))
        least = wp.min(least, luminance(c))
        total = total + c / float(suns)
    if luminance(total) > 1.05 * least:
        # At the rim of a patch of sun more rays tell how much of the disc is seen.
        total = total * 0.2
        for k in range(4 * suns):
            e = even_point((place + 4096) * 4 * suns + k)
            total = total + sun_and_beam(world, lights, p, n, flat, e) / float(5 * suns)
    return total


@wp.kernel
def light_pixels(
    # Problem:
    world: World,
    lights: Lights,
    cache: Cache,
    lens: Lens,
    counts: Counts,
    order: wp.array(dtype=int),
    start: int,
    # State out:
    grid_out: Grid,
    layers_out: Layers,
    variance_out: wp.array(dtype=float),
):
    """Light at the pixels of a grid, the variance of its soft light, and what it falls on.

    ``order`` [64 * 64] is the place of a pixel on a Hilbert curve: along it neighbours take points of one even
    sequence, so that the noise of a neighbourhood averages out.
    """
    i = start + wp.tid()
    x, y = i % grid_out.columns, i // grid_out.columns
    place = order[(y % 64) * 64 + x % 64]
    px = (float(x) + 0.5) * float(lens.width) / float(grid_out.columns)
    py = (float(y) + 0.5) * float(lens.height) / float(grid_out.rows)
    seen = what_is_seen(world, lights, cache, camera_ray(lens, px, py), pixel_width(lens))
    grid_out.point[i] = seen.point
    grid_out.normal[i] = seen.normal
    grid_out.key[i] = key_of(seen)
    sums = Gathered()
    sun = wp.vec3(0.0)
    if luminance(seen.color) + luminance(seen.gloss) > 1.0e-4 and seen.instance >= 0:
        p, n, flat = seen.point, seen.normal, seen.flat
        # Middling gloss is blurred less than diffuse light and more than one ray could tell: by the rays of light.
        glossy = seen.path < 10000 and seen.glossy_roughness >= _SHARP and seen.glossy_roughness <= _MATT
        if lights.portal_count > 0:
            for k in range(counts.windows):
                a = window_light(world, lights, p, n, flat, even_point(place * counts.windows + k))
                sums = _with_ray(sums, seen, a, counts.windows, glossy)
        if lights.lamp_count > 0:
            for k in range(counts.lamps):
                a = lamp_light(world, lights, p, n, flat, place * counts.lamps + k)
                sums = _with_ray(sums, seen, a, counts.lamps, glossy)
        for k in range(counts.bounces):
            row = place * counts.bounces + k
            a = bounced_light(world, lights, cache, p, n, flat, even_point(row), row)
            sums = _with_ray(sums, seen, a, counts.bounces, False)
        if lights.direct.on == 1:
            sums.soft = sums.soft + glow_light(lights, p, n)
        sun = _all_sun(world, lights, seen, counts.suns, place)
        if seen.path < 10000 and is_matt(lights, seen) == 0:
            rough = wp.max(seen.glossy_roughness, 0.12)
            lobe = glossy_lobe(-seen.way, seen.glossy_normal, rough, lights.sun)
            sums.gloss = sums.gloss + clamped(sun * lobe, 12.0)
    bright = luminance(sums.soft)
    rays = float(counts.windows + counts.lamps + counts.bounces)
    variance_out[i] = wp.max(sums.square - bright * bright / rays, 0.0)
    layers_out.soft[i] = sums.soft
    layers_out.sun[i] = sun
    layers_out.toward[i] = sums.toward / wp.max(bright, 1.0e-6)
    gloss = sums.gloss
    if luminance(seen.gloss) > 1.0e-4 and is_matt(lights, seen) == 0:
        gloss = gloss + clamped(reflected_light(world, lights, cache, seen, even_point(place), place), 12.0)
    layers_out.gloss[i] = gloss
