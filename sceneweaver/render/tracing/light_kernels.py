"""Light that arrives at a point: sun and sky through windows, lamps, and what other surfaces throw back."""

import warp as wp

from .ray_kernels import FAR, PI, even_point, hit_any, hit_solid
from .sampling_kernels import (
    cone_direction,
    cosine_direction,
    rectangle_sample,
    rectangle_weight,
    spherical_rectangle,
)
from .world_kernels import (
    OFFSET,
    Cache,
    World,
    cached_light,
    diffuse_of,
    luminance,
    shade_of,
    transmitted,
)

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})

_BEYOND = wp.constant(0.35)  # how far past a window light is looked for [m]: what is outside throws no shadows
_FRAME = wp.constant(0.2)  # depth of a window's frame and ledge past the portal [m]
_AIMS = wp.constant(4)  # points of lamps to choose one of for each ray


@wp.struct
class Portal:
    """A window: a corner, two edges [m], the normal into the room, and its area [m2]."""

    corner: wp.vec3
    ex: wp.vec3
    ey: wp.vec3
    normal: wp.vec3
    area: float


@wp.struct
class Lamp:
    """Emissive faces that belong together: middle and radius [m], flux, and where its faces are in the table."""

    middle: wp.vec3
    radius: float
    flux: float
    start: int
    count: int


@wp.struct
class LampFace:
    """A triangle that shines on its outer side: corners, normal, radiance, the chance to aim at it or one before it,
    and its area over its own chance [m2].

    Its light falls off no further than from the distance whose square is ``least`` [m2]."""

    a: wp.vec3
    b: wp.vec3
    c: wp.vec3
    normal: wp.vec3
    radiance: wp.vec3
    share: float
    area: float
    least: float


@wp.struct
class Direct:
    """Plain light without bounces, for a draft; with ``on`` it takes the place of sky, windows and lamps.

    ``reach`` [m] is how far what hides the sky is looked for, ``bounce`` how much light near surfaces throw back in
    their own colour (0: a plain share of the sky's). The beam is a second sun that shines through windows alone, and
    on nothing below ``beam_floor`` [m]. ``glows`` are small lights without shadows: place, power.
    """

    on: int
    sky: wp.vec3
    ground: wp.vec3
    background: wp.vec3
    reach: float
    bounce: float
    beam: wp.vec3
    beam_softness: float
    beam_color: wp.vec3
    beam_floor: float
    glows: wp.array(dtype=wp.vec4)
    glow_count: int
    glow_color: wp.vec3


@wp.struct
class Lights:
    """Sun, sky, windows and lamps. With ``enclosed`` daylight comes by the portals alone, all else sees ``hall``.

    ``low`` and ``high`` are the box of the room: what is hit outside of it lies in plain daylight.
    """

    enclosed: int
    sun: wp.vec3
    softness: float
    sun_color: wp.vec3
    zenith: wp.vec3
    horizon: wp.vec3
    ground: wp.vec3
    hall: wp.vec3
    view: wp.vec3
    low: wp.vec3
    high: wp.vec3
    portals: wp.array(dtype=Portal)
    portal_count: int
    lamps: wp.array(dtype=Lamp)
    lamp_count: int
    faces: wp.array(dtype=LampFace)
    direct: Direct


@wp.struct
class Arriving:
    """Irradiance over pi, and the direction that it comes from (unit)."""

    light: wp.vec3
    way: wp.vec3


@wp.func
def sky_light(lights: Lights, way: wp.vec3):
    """Radiance of the world outside that lights the room: a clear sky over a ground."""
    up = way[2]
    if lights.direct.on == 1:
        return lights.direct.ground * (0.5 - 0.5 * up) + lights.direct.sky * (0.5 + 0.5 * up)
    if up < 0.0:
        return lights.ground
    t = wp.sqrt(up)
    sky = lights.horizon * (1.0 - t) + lights.zenith * t
    near = wp.max(wp.dot(way, lights.sun), 0.0)
    return sky + lights.sun_color * (0.02 * wp.pow(near, 24.0))


@wp.func
def in_portal(portal: Portal, origin: wp.vec3, way: wp.vec3):
    """Distance [m] at which a ray leaves by a window, or -1; what starts in its frame or pane may have left."""
    down = -wp.dot(way, portal.normal)
    if down < 1.0e-4:
        return -1.0
    t = wp.dot(origin - portal.corner, portal.normal) / down
    if t < -_FRAME:
        return -1.0
    p = origin + way * t - portal.corner
    u, v = wp.dot(p, portal.ex), wp.dot(p, portal.ey)
    if u < 0.0 or v < 0.0 or u > wp.dot(portal.ex, portal.ex) or v > wp.dot(portal.ey, portal.ey):
        return -1.0
    return wp.max(t, 0.0)


@wp.func
def portal_distance(lights: Lights, origin: wp.vec3, way: wp.vec3):
    """Distance [m] at which a ray leaves the room by some window, or -1."""
    for k in range(lights.portal_count):
        t = in_portal(lights.portals[k], origin, way)
        if t >= 0.0:
            return t
    return -1.0


@wp.func
def escaped_light(lights: Lights, origin: wp.vec3, way: wp.vec3):
    """Radiance of a ray that hits nothing, less what is sampled by way of the portals."""
    if lights.enclosed == 0:
        return sky_light(lights, way)
    if portal_distance(lights, origin, way) >= 0.0:
        return wp.vec3(0.0)
    return lights.hall


@wp.func
def seen_outside(lights: Lights, origin: wp.vec3, way: wp.vec3):
    """Radiance of a ray that hits nothing, as an eye sees it: through a window the world, else the hall."""
    if lights.direct.on == 1:
        return lights.direct.background
    if lights.enclosed == 1 and portal_distance(lights, origin, way) < 0.0:
        return lights.hall
    return sky_light(lights, way)


@wp.func
def sun_light(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """Irradiance over pi by the sun, by one ray toward its disc."""
    none = wp.vec3(0.0)
    if wp.dot(n, lights.sun) <= 0.0 or wp.dot(flat, lights.sun) <= 0.0:
        return none
    way = cone_direction(lights.sun, lights.softness, e)
    cosine = wp.dot(n, way)
    if cosine <= 0.0 or wp.dot(flat, way) <= 0.0:
        return none
    reach = float(FAR)
    if lights.enclosed == 1:
        out = portal_distance(lights, p, way)
        if out < 0.0:
            return none
        reach = out + _BEYOND
    return wp.cw_mul(lights.sun_color, transmitted(world, p + flat * OFFSET, way, reach)) * (cosine / PI)


@wp.func
def beam_light(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """Irradiance over pi by the beam of plain light, by one ray toward its disc through a window."""
    none = wp.vec3(0.0)
    if lights.direct.on == 0 or lights.direct.beam_color[0] <= 0.0 or p[2] < lights.direct.beam_floor:
        return none
    way = cone_direction(lights.direct.beam, lights.direct.beam_softness, e)
    cosine = wp.dot(n, way)
    out = portal_distance(lights, p, way)
    if cosine <= 0.0 or wp.dot(flat, way) <= 0.0 or out < 0.0:
        return none
    return wp.cw_mul(lights.direct.beam_color, transmitted(world, p + flat * OFFSET, way, out)) * cosine


@wp.func
def glow_light(lights: Lights, p: wp.vec3, n: wp.vec3):
    """Irradiance over pi by the small lights of plain light, which reach 3 m."""
    total = float(0.0)
    for k in range(lights.direct.glow_count):
        glow = lights.direct.glows[k]
        gap = wp.vec3(glow[0], glow[1], glow[2]) - p
        square = wp.dot(gap, gap)
        if square < 9.0:
            facing = wp.max(0.0, 0.25 + 0.75 * wp.dot(n, gap) / wp.sqrt(square + 1.0e-6))
            fade = 1.0 - square / 9.0
            total += glow[3] * facing * fade * fade / (0.12 + square)
    return lights.direct.glow_color * total


@wp.func
def near_light(world: World, lights: Lights, p: wp.vec3, flat: wp.vec3, way: wp.vec3):
    """Plain light along a ray: that of the sky, or of a near surface that throws some back in its colour."""
    sky = sky_light(lights, way)
    reach = lights.direct.reach
    if wp.dot(flat, way) <= 0.0:
        return sky * 0.28
    if lights.direct.bounce <= 0.0:
        return wp.cw_mul(sky, wp.vec3(0.28) + transmitted(world, p + flat * OFFSET, way, reach) * 0.72)
    hit = hit_any(world.meshes, p + flat * OFFSET, way, reach)
    if hit.face < 0:
        return sky
    finish = world.finishes[world.face_finish[hit.face]]
    # What is near hides all of the sky, what is far hardly any of it: there is no edge where the reach ends.
    far = hit.t / reach
    share = finish.opacity * (1.0 - far * far)
    thrown = wp.cw_mul(finish.plain * 0.75 + wp.vec3(0.12), lights.direct.sky) * lights.direct.bounce
    return sky * (1.0 - share) + (thrown + finish.emission) * share


@wp.func
def light_around(lights: Lights, cache: Cache, p: wp.vec3, n: wp.vec3, e: wp.vec2):
    """Irradiance over pi near a point without any ray: from the cache, or plain light without shadows."""
    if lights.direct.on == 1:
        return sky_light(lights, n) * 0.75 + lights.sun_color * (0.06 * wp.max(wp.dot(n, lights.sun), 0.0))
    return cached_light(cache, cache.light, p, n, e)


@wp.func
def _portal_weight(portal: Portal, p: wp.vec3, n: wp.vec3):
    """About how much light a window sends to a point."""
    middle = portal.corner + (portal.ex + portal.ey) * 0.5
    to = middle - p
    d2 = wp.dot(to, to)
    before = -wp.dot(to, portal.normal)
    if before <= -1.0e-3:
        return 0.0
    size = portal.area
    facing = wp.dot(to, n) / wp.sqrt(d2 + 1.0e-6)
    return size * (before / wp.sqrt(d2 + 1.0e-6) + 0.15) * (wp.max(facing, 0.0) + 0.15) / (d2 + 0.3 * size)


@wp.func
def window_light(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2):
    """Irradiance over pi by the sky through the windows, by one ray to one of them."""
    none = Arriving()
    total = float(0.0)
    for k in range(lights.portal_count):
        total += _portal_weight(lights.portals[k], p, n)
    if total <= 0.0:
        return none
    left = e[0] * total
    chosen = int(0)
    share = float(0.0)
    within = float(0.5)
    for k in range(lights.portal_count):
        w = _portal_weight(lights.portals[k], p, n)
        if left >= 0.0 and w > 0.0:
            chosen = k
            share = w
            within = wp.min(left / w, 0.999999)
        left -= w
        if left < 0.0:
            break
    portal = lights.portals[chosen]
    if wp.dot(p - portal.corner, portal.normal) <= 1.0e-4:
        return none
    q = spherical_rectangle(portal.corner, portal.ex, portal.ey, p)
    to = rectangle_sample(q, wp.vec2(within, e[1]))
    distance = wp.length(to)
    way = to / distance
    cosine = wp.dot(n, way)
    if cosine <= 0.0 or wp.dot(flat, way) <= 0.0:
        return none
    light = wp.cw_mul(sky_light(lights, way), transmitted(world, p + flat * OFFSET, way, distance + _BEYOND))
    found = Arriving()
    found.light = light * (cosine / PI * rectangle_weight(q, to) * total / share)
    found.way = way
    return found


@wp.func
def _lamp_weight(lamp: Lamp, p: wp.vec3):
    """About how much light a lamp sends to a point."""
    to = lamp.middle - p
    return lamp.flux / (wp.dot(to, to) + lamp.radius * lamp.radius + 0.01)


@wp.struct
class Aim:
    """A point of a lamp as seen from a surface: direction and distance [m], and the irradiance over pi that its whole
    lamp would send if all of it were there and nothing stood between, over the chance to aim at it."""

    way: wp.vec3
    distance: float
    light: wp.vec3


@wp.func
def _aim(lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, total: float, e: float, e2: wp.vec2):
    """Aim at a point of some lamp, chosen by how much the lamps send about here."""
    aim = Aim()
    left = e * total
    chosen = int(0)
    share = float(1.0)
    within = float(0.5)
    for k in range(lights.lamp_count):
        w = _lamp_weight(lights.lamps[k], p)
        if left >= 0.0:
            chosen = k
            share = w
            within = wp.min(left / w, 0.999999)
        left -= w
        if left < 0.0:
            break
    lamp = lights.lamps[chosen]
    first = lamp.start
    last = lamp.start + lamp.count - 1
    while first < last:
        middle = (first + last) // 2
        if lights.faces[middle].share < within:
            first = middle + 1
        else:
            last = middle
    face = lights.faces[first]
    r = wp.sqrt(e2[0])
    to = face.a * (1.0 - r) + face.b * (r * (1.0 - e2[1])) + face.c * (r * e2[1]) - p
    d2 = wp.max(wp.dot(to, to), 1.0e-6)
    aim.distance = wp.sqrt(d2)
    aim.way = to / aim.distance
    cosine = wp.dot(n, aim.way)
    leaving = -wp.dot(face.normal, aim.way)
    if cosine > 0.0 and leaving > 0.0 and wp.dot(flat, aim.way) > 0.0:
        aim.light = face.radiance * (cosine * leaving * face.area * total / (PI * wp.max(d2, face.least) * share))
    return aim


@wp.func
def lamp_light(world: World, lights: Lights, p: wp.vec3, n: wp.vec3, flat: wp.vec3, k: int):
    """Irradiance over pi by the lamps, by ray k to a point of one: of some, the one that would send most is likely.

    This is resampled importance sampling (Talbot, Cline and Egbert 2005).
    """
    found = Arriving()
    total = float(0.0)
    for j in range(lights.lamp_count):
        total += _lamp_weight(lights.lamps[j], p)
    if total <= 0.0:
        return found
    best = Aim()
    level = float(0.0)
    random = wp.rand_init(k, 11)
    pick = wp.randf(random)
    for c in range(_AIMS):
        row = k * _AIMS + c
        e = even_point(row)
        aim = _aim(lights, p, n, flat, total, e[0], wp.vec2(wp.randf(random), e[1]))
        bright = luminance(aim.light)
        if bright > 0.0:
            level += bright
            odds = bright / level
            if pick < odds:
                best = aim
                pick = pick / odds
            else:
                pick = (pick - odds) / (1.0 - odds)
    reach = best.distance - 3.0 * OFFSET
    if level <= 0.0 or reach <= 0.0:
        return found
    through = transmitted(world, p + flat * OFFSET, best.way, reach)
    found.light = wp.cw_mul(best.light, through) * (level / (float(_AIMS) * luminance(best.light)))
    found.way = best.way
    return found


@wp.func
def in_room(lights: Lights, p: wp.vec3):
    """Whether a point lies in the box of the room; everything does where light comes from all sides."""
    if lights.enclosed == 0:
        return 1
    inside = (
        p[0] > lights.low[0] and p[1] > lights.low[1] and p[2] > lights.low[2]
        and p[0] < lights.high[0] and p[1] < lights.high[1] and p[2] < lights.high[2]
    )  # fmt: skip
    return wp.where(inside, 1, 0)


@wp.func
def outdoor_light(lights: Lights, n: wp.vec3):
    """Irradiance over pi of what stands outside: sun and sky without shadows, or the little of a closed hall."""
    up = 0.5 + 0.5 * n[2]
    sky = (lights.zenith + lights.horizon) * (0.5 * up) + lights.ground * (1.0 - up)
    return sky + lights.sun_color * (0.6 * wp.max(wp.dot(n, lights.sun), 0.0) / PI)


@wp.func
def hazy(lights: Lights, color: wp.vec3, distance: float):
    """What stands outside, through the air before it."""
    clear = wp.exp(-distance / 140.0)
    grey = wp.vec3(luminance(color)) * 0.15 + color * 0.85
    return grey * (1.5 * clear) + lights.horizon * (1.0 - clear)


@wp.func
def bounced_light(
    world: World, lights: Lights, cache: Cache, p: wp.vec3, n: wp.vec3, flat: wp.vec3, e: wp.vec2, k: int
):
    """Irradiance over pi by one ray about n with a density of cosine over pi, by the cached light where it ends."""
    found = Arriving()
    way = cosine_direction(n, e)
    found.way = way
    if lights.direct.on == 1:
        found.light = near_light(world, lights, p, flat, way)
        return found
    if wp.dot(flat, way) <= 1.0e-3:
        return found
    hit = hit_solid(world.meshes, p + flat * OFFSET, way, FAR)
    if hit.face < 0:
        found.light = escaped_light(lights, p, way)
        return found
    s = shade_of(world, hit, way, 0.05 + 0.2 * hit.t, 0)
    at = p + way * hit.t
    if in_room(lights, at) == 1:
        # Sunlight on surfaces is sampled as that of lamps.
        light = cached_light(cache, cache.bounced, at, s.flat, even_point(k * 7 + 3))
        found.light = wp.cw_mul(diffuse_of(s), light)
    return found


@wp.func
def clamped(c: wp.vec3, most: float):
    """A colour no brighter than ``most``: single samples never outshine their surroundings."""
    bright = luminance(c)
    if bright > most:
        return c * (most / bright)
    return c
