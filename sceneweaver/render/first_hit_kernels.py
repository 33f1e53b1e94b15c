"""What rays of several cameras meet first: triangle, distance and place in the triangle. One thread a ray."""

import warp as wp

from .raycast_world import FAR

wp.set_module_options({"enable_backward": False, "fast_math": True})


@wp.struct
class View:
    """A camera: the ray of a picture's point (u, v) in [-1, 1]^2 has the direction ``forward + right u + up v``; of a
    flat camera that sum moves the origin instead."""

    eye: wp.vec3
    forward: wp.vec3
    right: wp.vec3
    up: wp.vec3
    flat: int


@wp.kernel
def first_hits(
    # Problem:
    mesh: wp.uint64,
    views: wp.array(dtype=View),
    width: int,
    height: int,
    start: int,
    # State out:
    face_out: wp.array(dtype=int),
    distance_out: wp.array(dtype=float),
    u_out: wp.array(dtype=float),
    v_out: wp.array(dtype=float),
):
    """The hit of the ray through the middle of each pixel, picture after picture; face -1 where there is none."""
    ray = start + wp.tid()
    view = views[ray // (width * height)]
    pixel = ray % (width * height)
    x = 2.0 * (float(pixel % width) + 0.5) / float(width) - 1.0
    y = 1.0 - 2.0 * (float(pixel // width) + 0.5) / float(height)
    origin = view.eye
    way = view.forward + view.right * x + view.up * y
    if view.flat == 1:
        origin = view.eye + view.right * x + view.up * y
        way = view.forward
    hit = wp.mesh_query_ray(mesh, origin, wp.normalize(way), FAR)
    face_out[ray] = -1
    distance_out[ray] = 0.0
    u_out[ray] = 0.0
    v_out[ray] = 0.0
    if hit.result:
        face_out[ray] = hit.face
        distance_out[ray] = hit.t
        u_out[ray] = hit.u
        v_out[ray] = hit.v
