"""From a violation to a penalty."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.func
def penalty(v: wp.float32, knee: wp.float32):
    """Huber penalty [m] of a violation v [m] and its slope: quadratic up to the knee [m], then linear; 0 for v <= 0."""
    if v <= 0.0:
        return float(0.0), float(0.0)
    if v < knee:
        return 0.5 * v * v / knee, v / knee
    return v - 0.5 * knee, float(1.0)


@wp.func
def outside(value: wp.float32, interval: wp.vec2):
    """How far a value lies outside an interval, and the sign of the slope."""
    if value < interval[0]:
        return interval[0] - value, float(-1.0)
    if value > interval[1]:
        return value - interval[1], float(1.0)
    return float(0.0), float(0.0)
