"""Rays of cameras and what they meet first, and an even sequence of points to spread others by."""

import warp as wp

from sceneweaver.runtime.compiling import prepare_warp

prepare_warp()
wp.set_module_options({"enable_backward": False, "fast_math": True})

PI = wp.constant(3.14159265)
FAR = wp.constant(1.0e4)
_R2_X = wp.constant(wp.uint32(3242174889))  # 2^32 / 1.32471795...
_R2_Y = wp.constant(wp.uint32(2447445414))  # the same squared
_HALF = wp.constant(wp.uint32(2147483648))


@wp.struct
class Lens:
    """A camera: ``right`` and ``up`` are as long as half the picture at distance 1 (or half the width [m], flat).

    ``width`` and ``height`` are those of its picture in pixels."""

    eye: wp.vec3
    forward: wp.vec3
    right: wp.vec3
    up: wp.vec3
    flat: int
    width: int
    height: int


@wp.struct
class Ray:
    """Where a ray starts, and its direction (unit)."""

    origin: wp.vec3
    direction: wp.vec3


@wp.struct
class Hit:
    """A point of the world: face (-1: nothing), distance along the ray, barycentric u and v, and flat normal."""

    face: int
    t: float
    u: float
    v: float
    normal: wp.vec3


@wp.struct
class Meshes:
    """An opaque and a see-through mesh, of which the faces of the latter are counted on after those of the former."""

    solid: wp.uint64
    clear: wp.uint64
    clear_start: int
    clear_count: int


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
def camera_ray(lens: Lens, x: float, y: float):
    """The ray through a point of the picture [pixels]."""
    ray = Ray()
    across = lens.right * (2.0 * x / float(lens.width) - 1.0) + lens.up * (1.0 - 2.0 * y / float(lens.height))
    ray.origin = lens.eye
    ray.direction = lens.forward
    if lens.flat == 1:
        ray.origin = lens.eye + across
    else:
        ray.direction = wp.normalize(lens.forward + across)
    return ray


@wp.func
def hit_solid(meshes: Meshes, origin: wp.vec3, way: wp.vec3, reach: float):
    """The first opaque surface along a ray."""
    hit = Hit()
    hit.face = -1
    hit.t = reach
    found = wp.mesh_query_ray(meshes.solid, origin, way, reach)
    if found.result:
        hit.face = found.face
        hit.t = found.t
        hit.u = found.u
        hit.v = found.v
        hit.normal = found.normal
    return hit


@wp.func
def hit_any(meshes: Meshes, origin: wp.vec3, way: wp.vec3, reach: float):
    """The first surface along a ray, see-through or not."""
    hit = hit_solid(meshes, origin, way, reach)
    if meshes.clear_count > 0:
        found = wp.mesh_query_ray(meshes.clear, origin, way, hit.t)
        if found.result and found.t < hit.t:
            hit.face = found.face + meshes.clear_start
            hit.t = found.t
            hit.u = found.u
            hit.v = found.v
            hit.normal = found.normal
    return hit


@wp.kernel
def first_hits(
    # Problem:
    meshes: Meshes,
    lenses: wp.array(dtype=Lens),
    start: int,
    # State out:
    face_out: wp.array(dtype=int),
    distance_out: wp.array(dtype=float),
    bary_out: wp.array(dtype=wp.vec2),
):
    """The hit of the ray through the middle of each pixel, picture after picture of one size; face -1: none."""
    i = start + wp.tid()
    width, height = lenses[0].width, lenses[0].height
    pixel = i % (width * height)
    ray = camera_ray(lenses[i // (width * height)], float(pixel % width) + 0.5, float(pixel // width) + 0.5)
    hit = hit_any(meshes, ray.origin, ray.direction, FAR)
    face_out[i] = hit.face
    distance_out[i] = hit.t
    bary_out[i] = wp.vec2(hit.u, hit.v)
