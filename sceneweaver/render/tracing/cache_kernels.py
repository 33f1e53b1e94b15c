"""The light of the room's surfaces, sampled once for all views."""

import warp as wp

from .light_kernels import Lights, escaped_light, in_room, lamp_light, sun_light, window_light
from .ray_kernels import FAR, even_point, hit_solid
from .sampling_kernels import cosine_direction
from .world_kernels import OFFSET, Cache, World, cell_of, diffuse_of, shade_of

wp.set_module_options({"enable_backward": False, "fast_math": True, "max_unroll": 1})


@wp.kernel
def see_out(
    # Problem:
    world: World,
    corners: wp.array(dtype=wp.vec3),
    owner: wp.array(dtype=int),
    rays: int,
    start: int,
    # State out:
    share_out: wp.array(dtype=float),
):
    """The share of the light of triangles, evenly bright from all sides, that the rest of their instance lets out."""
    i = start + wp.tid()
    a, b, c = corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]
    n = wp.normalize(wp.cross(b - a, c - a))
    free = float(0.0)
    random = wp.rand_init(i, 3)
    for k in range(rays):
        r = wp.sqrt(wp.randf(random))
        s = wp.randf(random)
        p = a * (1.0 - r) + b * (r * (1.0 - s)) + c * (r * s)
        hit = hit_solid(world.meshes, p + n * OFFSET, cosine_direction(n, even_point(k)), 1.0)
        own = int(0)
        if hit.face >= 0:
            if world.face_instance[hit.face] == owner[i]:
                own = 1
        if own == 0:
            free += 1.0
    share_out[i] = free / float(rays)


@wp.struct
class PointLight:
    """Of each point the light that arrives but the sun's, the sun's, and the share of its rays that end on the back of
    a surface; of each ray the entry of the cache that it sees (-1: none) and that one's colour."""

    direct: wp.array(dtype=wp.vec3)
    sun: wp.array(dtype=wp.vec3)
    inside: wp.array(dtype=float)
    hit: wp.array(dtype=int)
    color: wp.array(dtype=wp.vec3)


@wp.kernel
def light_points(
    # Problem:
    world: World,
    lights: Lights,
    cache: Cache,
    points: wp.array(dtype=wp.vec3),
    normals: wp.array(dtype=wp.vec3),
    shadow_rays: int,
    bounce_rays: int,
    start: int,
    # State out:
    light_out: PointLight,
):
    """Direct light of points on surfaces, and which cells of the cache they see in which colour."""
    i = start + wp.tid()
    p, n = points[i], normals[i]
    direct = wp.vec3(0.0)
    sun = wp.vec3(0.0)
    for k in range(shadow_rays):
        e = even_point(i * shadow_rays + k)
        sky = window_light(world, lights, p, n, n, e)
        lamp = lamp_light(world, lights, p, n, n, i * shadow_rays + k)
        direct = direct + sky.light + lamp.light
        sun = sun + sun_light(world, lights, p, n, n, e)
    direct = direct / float(shadow_rays)
    light_out.sun[i] = sun / float(shadow_rays)
    inside = float(0.0)
    for k in range(bounce_rays):
        row = i * bounce_rays + k
        way = cosine_direction(n, even_point(row))
        hit = hit_solid(world.meshes, p + n * OFFSET, way, FAR)
        light_out.hit[row] = -1
        light_out.color[row] = wp.vec3(0.0)
        if hit.face < 0:
            direct = direct + escaped_light(lights, p, way) / float(bounce_rays)
        else:
            s = shade_of(world, hit, way, 0.2, 0)
            inside += float(s.back) / float(bounce_rays)
            at = p + way * hit.t
            if in_room(lights, at) == 1:
                light_out.hit[row] = cell_of(cache, at, s.flat)
                light_out.color[row] = diffuse_of(s)
    light_out.direct[i] = direct
    light_out.inside[i] = inside
