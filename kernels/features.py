"""The features that relations are made of, each with its hand-written gradient.

A relation's option (say: the back at wall 2) is a set of rows; a row asks one feature to lie in an interval. The
gradient returned is that of the value with respect to the pose (x, y, z, yaw) of the object in the given role:
0 subject a, 1 first target b, 2 second target c. Target -1 is the room's own frame.
"""

import warp as wp

from .array_access import item
from .bodies import Body, prism_of
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
class Relation:
    """The objects of a relation: its subject, and the first and the second target (index -1: none)."""

    a: Body
    b: Body
    c: Body


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
def lever(role: wp.int32, n: wp.vec2, point: wp.vec2, x: Relation):
    """Gradient of a length along n measured from b to the witness point of a."""
    if role == 0:
        return wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(point - plane_of(x.a.pose))))
    return wp.vec4(-n[0], -n[1], 0.0, -wp.dot(n, perp(point - plane_of(x.b.pose))))


@wp.func
def angle_slope(v: wp.vec2):
    """Gradient of atan2(v.y, v.x) with respect to v."""
    return perp(v) / (wp.dot(v, v) + TINY)


@wp.func
def distance_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation, boxes: wp.bool):
    """Distance of a's footprint to b's or to the row's prism. ``boxes``: all of them are known to be boxes."""
    best = float(FAR)
    best_n = wp.vec2(1.0, 0.0)
    best_point = plane_of(x.a.pose)
    prism = item(t[0].row_prism, row)
    first = int(0)
    last = int(1)
    if prism < 0:
        first = item(t[0].footprint_start, x.b.index)
        last = item(t[0].footprint_start, x.b.index + 1)
    for i in range(item(t[0].footprint_start, x.a.index), item(t[0].footprint_start, x.a.index + 1)):
        mine = prism_of(t, item(t[0].footprint, i), x.a)
        for j in range(first, last):
            k = prism
            if prism < 0:
                k = item(t[0].footprint, j)
            other = prism_of(t, k, x.b)
            s = float(0.0)
            n = wp.vec2(1.0, 0.0)
            point = mine.at
            if boxes:
                s, n, point = box_distance(mine, other)
            else:
                s, n, point = distance(t, mine, other)
            if s < best:
                best = s
                best_n = n
                best_point = point
    return best, lever(role, -best_n, best_point, x)


@wp.func
def line_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation):
    """Coordinate of a point of a along a direction fixed to b."""
    n = turn(x.b.turn, normal_of(t, row))
    point = plane_of(x.a.pose) + turn(x.a.turn, point_of(t, row))
    return wp.dot(n, point - plane_of(x.b.pose)) - offset_of(t, row), lever(role, n, point, x)


@wp.func
def yaw_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation):
    """Difference of yaw modulo the row's period."""
    value = wrap(x.a.pose[3] - x.b.pose[3] - offset_of(t, row), normal_of(t, row)[0])
    return value, wp.vec4(0.0, 0.0, 0.0, wp.where(role == 0, 1.0, -1.0))


@wp.func
def bearing_feature(role: wp.int32, x: Relation):
    """Direction of b's centre seen from a's front."""
    v = plane_of(x.b.pose) - plane_of(x.a.pose)
    w = turn_back(x.a.turn, v)
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
def extent_feature(t: TablesRef, row: wp.int32, a: Body):
    """Lowest point of a's box along a direction of the room."""
    n = normal_of(t, row)
    reach, slope = half_extent(item(t[0].object_size, a.index), n, a.turn)
    return wp.dot(n, plane_of(a.pose)) - offset_of(t, row) - reach, wp.vec4(n[0], n[1], 0.0, -slope)


@wp.func
def window_feature(t: TablesRef, row: wp.int32, a: Body):
    """How much of the overlap along the wall is missing: of the shorter of a's box and the window (half width
    the point's x) the share the point's y must lie beside the other."""
    n = normal_of(t, row)
    reach, slope = half_extent(item(t[0].object_size, a.index), n, a.turn)
    u = wp.dot(n, plane_of(a.pose)) - offset_of(t, row)
    half = point_of(t, row)[0]
    share = 2.0 * point_of(t, row)[1]
    value = wp.abs(u) - (reach + half - share * wp.min(reach, half))
    if reach < half:
        slope = (1.0 - share) * slope
    return value, wp.vec4(wp.sign(u) * n[0], wp.sign(u) * n[1], 0.0, -slope)


@wp.func
def between_feature(role: wp.int32, x: Relation):
    """a's place along the line from b to c: 0 at b, 1 at c."""
    d = plane_of(x.c.pose) - plane_of(x.b.pose)
    u = plane_of(x.a.pose) - plane_of(x.b.pose)
    dd = wp.dot(d, d) + TINY
    value = wp.dot(u, d) / dd
    g = d / dd
    if role == 1:
        g = (2.0 * value * d - d - u) / dd
    elif role == 2:
        g = (u - 2.0 * value * d) / dd
    return value, wp.vec4(g[0], g[1], 0.0, 0.0)


@wp.func
def aside_feature(role: wp.int32, x: Relation):
    """a's signed distance from the line through b and c."""
    d = plane_of(x.c.pose) - plane_of(x.b.pose)
    u = plane_of(x.a.pose) - plane_of(x.b.pose)
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
def spread_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation):
    """Angle about b from c to a."""
    u = plane_of(x.a.pose) - plane_of(x.b.pose)
    w = plane_of(x.c.pose) - plane_of(x.b.pose)
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
def user_residual(kind: wp.int32, a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    """`user_value` for other modules, which would keep the one that they imported."""
    return user_value(kind, a, b, size_a, size_b, p)


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
def other_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation):
    """`feature` for all but plain kinds of rows."""
    kind = item(t[0].row_feature, row)
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if kind == FEATURE_BEARING:
        value, grad = bearing_feature(role, x)
    elif kind == FEATURE_DISTANCE:
        value, grad = distance_feature(t, row, role, x, False)
    elif kind == FEATURE_BETWEEN:
        value, grad = between_feature(role, x)
    elif kind == FEATURE_ASIDE:
        value, grad = aside_feature(role, x)
    elif kind == FEATURE_SPREAD:
        value, grad = spread_feature(t, row, role, x)
    elif kind >= FEATURE_USER:
        u = point_of(t, row)
        v = normal_of(t, row)
        size_b = wp.vec3(0.0, 0.0, 0.0)
        if x.b.index >= 0:
            size_b = item(t[0].object_size, x.b.index)
        p = wp.vec4(u[0], u[1], v[0], v[1])
        value, grad = user_feature(kind, role, x.a.pose, x.b.pose, item(t[0].object_size, x.a.index), size_b, p)
    if role == 2 and kind != FEATURE_BETWEEN and kind != FEATURE_ASIDE and kind != FEATURE_SPREAD:
        grad = wp.vec4(0.0, 0.0, 0.0, 0.0)  # those do not look at the second target
    return value, grad


@wp.func
def plain_feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation, distances: wp.bool):
    """`feature` for plain rows and, where asked for, for distances of boxes."""
    kind = item(t[0].row_feature, row)
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if kind == FEATURE_LINE:
        value, grad = line_feature(t, row, role, x)
    elif kind == FEATURE_YAW:
        value, grad = yaw_feature(t, row, role, x)
    elif kind == FEATURE_EXTENT:
        value, grad = extent_feature(t, row, x.a)
    elif kind == FEATURE_WINDOW:
        value, grad = window_feature(t, row, x.a)
    elif kind == FEATURE_HEIGHT:
        value = x.a.pose[2] - x.b.pose[2] - offset_of(t, row)
        grad = wp.vec4(0.0, 0.0, wp.where(role == 0, 1.0, -1.0), 0.0)
    elif distances and kind == FEATURE_DISTANCE:
        value, grad = distance_feature(t, row, role, x, True)
    else:  # FEATURE_CONSTANT
        value = offset_of(t, row)
    if role == 2:  # they do not look at the second target
        grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    return value, grad


@wp.func
def feature(t: TablesRef, row: wp.int32, role: wp.int32, x: Relation):
    """Value of a row's feature and its gradient for the pose of the object in one role."""
    value = float(0.0)
    grad = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if item(t[0].row_feature, row) < FEATURES_PLAIN:
        value, grad = plain_feature(t, row, role, x, False)
    else:
        value, grad = other_feature(t, row, role, x)
    return value, grad
