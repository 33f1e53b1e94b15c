"""An even sequence of points, and a vector across another: for the ray caster and the path tracer."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": True})

PI = wp.constant(3.14159265)
_R2_X = wp.constant(wp.uint32(3242174889))  # 2^32 / 1.32471795...
_R2_Y = wp.constant(wp.uint32(2447445414))  # the same squared
_HALF = wp.constant(wp.uint32(2147483648))


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
