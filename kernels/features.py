"""The features that relations are made of, each with its hand-written gradient.

A relation's option (say: the back at wall 2) is a set of rows; a row asks one feature to lie in an interval. The
gradient returned is that of the value with respect to the pose (x, y, z, yaw) of the object in the given role:
0 subject a, 1 first target b, 2 second target c. Target -1 is the room's own frame.
"""

import warp as wp

from .array_access import item
from .geometry import FAR, box_distance, distance, perp, plane_of, turn, turn_back, wrap
from .tables import (
    FEATURE_ASIDE,
    FEATURE_BEARING,
    FEATURE_BETWEEN,
    FEATURE_DISTANCE,
    FEATURE_EXTENT,
    FEATURE_HEIGHT,
    FEATURE_LINE,
    FEATURE_SPREAD,
    FEATURE_USER,
    FEATURE_WINDOW,
    FEATURE_YAW,
    FEATURES_PLAIN,
    TablesRef,
)

wp.set_module_options({"enable_backward": False})

TURN = wp.constant(6.283185307179586)
STEP = wp.constant(2.0e-3)  # [m, rad] of central differences: float32 keeps four digits of the slope
TINY = wp.constant(1.0e-8)  # [m2] keeps angles about a coinciding centre finite


@wp.struct
class RelationPoses:
    """The objects of a relation: global indices of the first two (-1: none) and the poses of all three."""

    a: wp.int32
    b: wp.int32
    pose_a: wp.vec4
    qa: wp.vec2  # (cos, sin) of the yaw
    pose_b: wp.vec4
    qb: wp.vec2
    pose_c: wp.vec4


@wp.func
def normal_of(t: TablesRef, row: wp.int32):
    """A row's direction, in the frame of b; for angles the first number is the period."""
    frame = item(t[0].row_frame, row)
    return wp.vec2(frame[0], frame[1])


@wp.func
def point_of(t: TablesRef, row: wp.int32):
    """A row's point, in the frame of a."""
    frame = item(t[0].row_frame, row)
    return wp.vec2(frame[2], frame[3])


@wp.func
def offset_of(t: TablesRef, row: wp.int32):
    """What is taken off a row's value."""
    return item(t[0].row_aim, row)[2]


@wp.func
def lever(role: wp.int32, n: wp.vec2, x: wp.vec2, pa: wp.vec2, pb: wp.vec2):
    """Gradient of a length along n measured from b to the witness x of a."""
    if role == 0:
        return wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(x - pa)))
    return wp.vec4(-n[0], -n[1], 0.0, -wp.dot(n, perp(x - pb)))


@wp.func
def angle_slope(v: wp.vec2):
    """Gradient of atan2(v.y, v.x) with respect to v."""
    return perp(v) / (wp.dot(v, v) + TINY)


@wp.func
def footprint_distance(
    t: TablesRef,
    a: wp.int32,
    pa: wp.vec2,
    qa: wp.vec2,
    b: wp.int32,
    pb: wp.vec2,
    qb: wp.vec2,
    prism: wp.int32,
    boxes: wp.bool,
):
    """Distance of a's footprint to that of object b, or to one static prism when prism >= 0; indices are global.

    ``boxes``: all of them are known to be boxes.
    """
    best = float(FAR)
    best_n = wp.vec2(1.0, 0.0)
    best_x = pa
    first = int(0)
    last = int(1)
    if prism < 0:
        first = item(t[0].footprint_start, b)
        last = item(t[0].footprint_start, b + 1)
    for i in range(item(t[0].footprint_start, a), item(t[0].footprint_start, a + 1)):
        mine = item(t[0].footprint, i)
        for j in range(first, last):
            other = prism
            if prism < 0:
                other = item(t[0].footprint, j)
            s = float(0.0)
            n = wp.vec2(1.0, 0.0)
            x = pa
            if boxes:
                s, n, x = box_distance(item(t[0].prism_box, mine), pa, qa, item(t[0].prism_box, other), pb, qb)
            else:
                s, n, x = distance(t, mine, pa, qa, other, pb, qb)
            if s < best:
                best = s
                best_n = n
                best_x = x
    return best, best_n, best_x


@wp.func
def distance_feature(
    t: TablesRef,
    row: wp.int32,
    role: wp.int32,
    a: wp.int32,
    pa: wp.vec2,
    qa: wp.vec2,
    b: wp.int32,
    pb: wp.vec2,
    qb: wp.vec2,
    boxes: wp.bool,
):
    """Distance of a's footprint to b's or to the row's prism."""
    s, n, x = footprint_distance(t, a, pa, qa, b, pb, qb, item(t[0].row_prism, row), boxes)
    return s, lever(role, -n, x, pa, pb)


@wp.func
def line_feature(t: TablesRef, row: wp.int32, role: wp.int32, pa: wp.vec2, qa: wp.vec2, pb: wp.vec2, qb: wp.vec2):
    """Coordinate of a point of a along a direction fixed to b."""
    n = turn(qb, normal_of(t, row))
    x = pa + turn(qa, point_of(t, row))
    return wp.dot(n, x - pb) - offset_of(t, row), lever(role, n, x, pa, pb)


@wp.func
def yaw_feature(t: TablesRef, row: wp.int32, role: wp.int32, yaw_a: wp.float32, yaw_b: wp.float32):
    """Difference of yaw modulo the row's period."""
    value = wrap(yaw_a - yaw_b - offset_of(t, row), normal_of(t, row)[0])
    return value, wp.vec4(0.0, 0.0, 0.0, wp.where(role == 0, 1.0, -1.0))


@wp.func
def bearing_feature(role: wp.int32, pa: wp.vec2, qa: wp.vec2, pb: wp.vec2):
    """Direction of b's centre viewed_pose from a's front."""
    v = pb - pa
    w = turn_back(qa, v)
    g = angle_slope(v)
    grad = wp.vec4(g[0], g[1], 0.0, 0.0)
    if role == 0:
        grad = wp.vec4(-g[0], -g[1], 0.0, -1.0)
    return wp.atan2(w[1], w[0] + 1.0e-12), grad


@wp.func
def half_extent(size: wp.vec3, n: wp.vec2, q: wp.vec2):
    """Half the width of a box along n, and its derivative by yaw."""
    f = wp.dot(n, q)
    g = wp.dot(n, perp(q))
    reach = 0.5 * (wp.abs(f) * size[0] + wp.abs(g) * size[1])
    return reach, 0.5 * (wp.sign(f) * g * size[0] - wp.sign(g) * f * size[1])


@wp.func
def extent_feature(t: TablesRef, row: wp.int32, a: wp.int32, pa: wp.vec2, qa: wp.vec2):
    """Lowest point of a's box along a direction of the room."""
    n = normal_of(t, row)
    reach, slope = half_extent(item(t[0].object_size, a), n, qa)
    return wp.dot(n, pa) - offset_of(t, row) - reach, wp.vec4(n[0], n[1], 0.0, -slope)


@wp.func
def window_feature(t: TablesRef, row: wp.int32, a: wp.int32, pa: wp.vec2, qa: wp.vec2):
    """How much of the overlap along the wall is missing: of the shorter of a's box and the window (half width
    the point's x) the share the point's y must lie beside the other."""
    n = normal_of(t, row)
    reach, slope = half_extent(item(t[0].object_size, a), n, qa)
    u = wp.dot(n, pa) - offset_of(t, row)
    half = point_of(t, row)[0]
    share = 2.0 * point_of(t, row)[1]
    value = wp.abs(u) - (reach + half - share * wp.min(reach, half))
    if reach < half:
        slope = (1.0 - share) * slope
    return value, wp.vec4(wp.sign(u) * n[0], wp.sign(u) * n[1], 0.0, -slope)


@wp.func
def between_feature(role: wp.int32, pa: wp.vec2, pb: wp.vec2, pc: wp.vec2):
    """a's place along the line from b to c: 0 at b, 1 at c."""
    d = pc - pb
    u = pa - pb
    dd = wp.dot(d, d) + TINY
    value = wp.dot(u, d) / dd
    g = d / dd
    if role == 1:
        g = (2.0 * value * d - d - u) / dd
    elif role == 2:
        g = (u - 2.0 * value * d) / dd
    return value, wp.vec4(g[0], g[1], 0.0, 0.0)


@wp.func
def aside_feature(role: wp.int32, pa: wp.vec2, pb: wp.vec2, pc: wp.vec2):
    """a's signed distance from the line through b and c."""
    d = pc - pb
    u = pa - pb
    r = wp.sqrt(wp.dot(d, d) + TINY)
    value = (d[0] * u[1] - d[1] * u[0]) / r
    by_u = perp(d) / r
    by_d = -perp(u) / r - value * d / (r * r)
    g = by_u
    if role == 1:
        g = -by_u - by_d
    elif role == 2:
        g = by_d
    return value, wp.vec4(g[0], g[1], 0.0, 0.0)


@wp.func
def spread_feature(t: TablesRef, row: wp.int32, role: wp.int32, pa: wp.vec2, pb: wp.vec2, pc: wp.vec2):
    """Angle about b from c to a."""
    u = pa - pb
    w = pc - pb
    value = wrap(wp.atan2(u[1], u[0] + 1.0e-12) - wp.atan2(w[1], w[0] + 1.0e-12) - offset_of(t, row), TURN)
    by_u = angle_slope(u)
    by_w = angle_slope(w)
    g = by_u
    if role == 1:
        g = by_w - by_u
    elif role == 2:
        g = -by_w
    return value, wp.vec4(g[0], g[1], 0.0, 0.0)


@wp.func
def user_value(kind: wp.int32, a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    """Residual of a user's relation; `user.py` puts the registered ones here."""
    return float(0.0)


@wp.func(inline=False)
def user_feature(kind: wp.int32, role: wp.int32, a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    """A user's residual and its gradient by central differences (Warp cannot differentiate inside nested functions)."""
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        h = wp.vec4(0.0, 0.0, 0.0, 0.0)
        h[c] = STEP
        if role == 0:
            up = user_value(kind, a + h, b, size_a, size_b, p)
            down = user_value(kind, a - h, b, size_a, size_b, p)
            grad[c] = (up - down) / (2.0 * STEP)
        else:
            up_b = user_value(kind, a, b + h, size_a, size_b, p)
            down_b = user_value(kind, a, b - h, size_a, size_b, p)
            grad[c] = (up_b - down_b) / (2.0 * STEP)
    return user_value(kind, a, b, size_a, size_b, p), grad


@wp.func(inline=False)
def other_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: RelationPoses):
    """`feature` for all but plain kinds of rows."""
    kind = item(t[0].row_feature, row)
    pa = plane_of(x.pose_a)
    pb = plane_of(x.pose_b)
    pc = plane_of(x.pose_c)
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if kind == FEATURE_BEARING:
        value, grad = bearing_feature(role, pa, x.qa, pb)
    elif kind == FEATURE_DISTANCE:
        value, grad = distance_feature(t, row, role, x.a, pa, x.qa, x.b, pb, x.qb, False)
    elif kind == FEATURE_BETWEEN:
        value, grad = between_feature(role, pa, pb, pc)
    elif kind == FEATURE_ASIDE:
        value, grad = aside_feature(role, pa, pb, pc)
    elif kind == FEATURE_SPREAD:
        value, grad = spread_feature(t, row, role, pa, pb, pc)
    elif kind >= FEATURE_USER:
        u = point_of(t, row)
        v = normal_of(t, row)
        size_b = wp.vec3(0.0, 0.0, 0.0)
        if x.b >= 0:
            size_b = item(t[0].object_size, x.b)
        value, grad = user_feature(
            kind, role, x.pose_a, x.pose_b, item(t[0].object_size, x.a), size_b, wp.vec4(u[0], u[1], v[0], v[1])
        )
    if role == 2 and kind != FEATURE_BETWEEN and kind != FEATURE_ASIDE and kind != FEATURE_SPREAD:
        grad = wp.vec4(0.0, 0.0, 0.0, 0.0)  # those do not look at the second target
    return value, grad


@wp.func
def plain_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: RelationPoses, distances: wp.bool):
    """`feature` for plain rows and, where asked for, for distances of boxes."""
    kind = item(t[0].row_feature, row)
    pa = plane_of(x.pose_a)
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if kind == FEATURE_LINE:
        value, grad = line_feature(t, row, role, pa, x.qa, plane_of(x.pose_b), x.qb)
    elif kind == FEATURE_YAW:
        value, grad = yaw_feature(t, row, role, x.pose_a[3], x.pose_b[3])
    elif kind == FEATURE_EXTENT:
        value, grad = extent_feature(t, row, x.a, pa, x.qa)
    elif kind == FEATURE_WINDOW:
        value, grad = window_feature(t, row, x.a, pa, x.qa)
    elif kind == FEATURE_HEIGHT:
        value = x.pose_a[2] - x.pose_b[2] - offset_of(t, row)
        grad = wp.vec4(0.0, 0.0, wp.where(role == 0, 1.0, -1.0), 0.0)
    elif distances and kind == FEATURE_DISTANCE:
        value, grad = distance_feature(t, row, role, x.a, pa, x.qa, x.b, plane_of(x.pose_b), x.qb, True)
    else:  # FEATURE_CONSTANT
        value = offset_of(t, row)
    if role == 2:  # they do not look at the second target
        grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    return value, grad


@wp.func
def feature(t: TablesRef, row: wp.int32, role: wp.int32, x: RelationPoses):
    """Value of a row's feature and its gradient for the pose of the object in one role."""
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if item(t[0].row_feature, row) < FEATURES_PLAIN:
        value, grad = plain_feature(t, row, role, x, False)
    else:
        value, grad = other_feature(t, row, role, x)
    return value, grad
