"""Drawing poses: relation-guided proposals by randomised projection onto interval rows.

To draw a pose for an object, start anywhere and move it, row by row, to a random value inside each row's interval
along the row's own gradient. Yaw rows come first in every option, and the remaining rows of an option are nearly
orthogonal, so that one sweep fulfils them. The same code serves every relation, also a user's own. Nothing is
written but the state of the random stream, which the caller holds: many poses of a candidate may be drawn at once.
"""

from typing import Any

import warp as wp

from .array_access import item, opaque_one
from .bodies import Body, Candidate, layout_of, posed
from .features import TURN, Relation, feature
from .geometry import lowest_vertex, perp, plane_of, turn_back
from .penalties import outside
from .tables import (
    FEATURE_BEARING,
    FEATURE_CONSTANT,
    FEATURE_YAW,
    FREE_PLANE,
    FREE_TURNS,
    FREE_YAW,
    FREE_Z,
    Problems,
    State,
    TablesRef,
)
from .terms_relations import best_option, relation_of
from .yaw_domain import nearest_yaw, yaw_at, yaw_count

wp.set_module_options({"enable_backward": False})

QUARTER = wp.constant(1.5707963267948966)
REACH = wp.constant(0.6)  # [m] how far beyond the closed end of a half-open interval a target is drawn


def _from_stream(name: str, number: Any) -> wp.Function:
    """A function that draws a number and moves the caller's stream on."""

    @wp.func(name=name)
    def draw(rng: wp.ref[wp.uint32]):
        stream = wp.uint32(rng)
        x = number(stream)
        rng = stream
        return x

    return draw


uniform = _from_stream("uniform", wp.randf)
"""A uniform number in [0, 1)."""

normal = _from_stream("normal", wp.randn)
"""A standard normal number."""


@wp.func
def pick(rng: wp.ref[wp.uint32], n: wp.int32):
    """A uniform index below n."""
    return wp.min(int(uniform(rng) * float(n)), n - 1)


@wp.func
def random_start(t: TablesRef, p: wp.int32, o: wp.int32, pose: wp.vec4, rng: wp.ref[wp.uint32]):
    """A pose for object o (global) anywhere in the room's bounding box, square to the room four times in five."""
    box = item(t[0].room_box, p)
    free = item(t[0].object_free, o)
    if free & FREE_PLANE:
        pose[0] = box[0] + uniform(rng) * (box[2] - box[0])
        pose[1] = box[1] + uniform(rng) * (box[3] - box[1])
    if free & FREE_YAW:
        if uniform(rng) < 0.8 and item(t[0].plane_start, p + 1) > item(t[0].plane_start, p):
            n = item(t[0].plane, item(t[0].plane_start, p))
            pose[3] = wp.atan2(n[1], n[0]) + QUARTER * float(pick(rng, 4))
        else:
            pose[3] = TURN * uniform(rng)
    if free & FREE_TURNS:
        pose[3] = yaw_at(t, o, pick(rng, yaw_count(t, o)))
    return pose


@wp.func
def jitter(t: TablesRef, o: wp.int32, pose: wp.vec4, scale: wp.float32, rng: wp.ref[wp.uint32]):
    """A pose within about ``scale`` metres of a given one; once in twenty also turned by quarters, or anew."""
    o_free = item(t[0].object_free, o)
    if o_free & FREE_PLANE:
        pose[0] = pose[0] + scale * normal(rng)
        pose[1] = pose[1] + scale * normal(rng)
    if o_free & FREE_Z:
        pose[2] = pose[2] + 0.5 * scale * normal(rng)
    if o_free & FREE_YAW:
        if uniform(rng) < 0.05:
            pose[3] = pose[3] + QUARTER * float(1 + pick(rng, 3))
    if o_free & FREE_TURNS:
        if uniform(rng) < 0.15:
            pose[3] = yaw_at(t, o, pick(rng, yaw_count(t, o)))
    return pose


@wp.func
def target_value(aim: wp.vec2, rng: wp.ref[wp.uint32]):
    """A random value inside an interval that may be open to one side."""
    lo = aim[0]
    hi = aim[1]
    if lo < -1.0e8:
        lo = hi - REACH
    if hi > 1.0e8:
        hi = lo + REACH
    return lo + uniform(rng) * (hi - lo)


@wp.func
def shifted(pose: wp.vec4, d: wp.float32, g: wp.vec4, free: wp.int32):
    """A pose shifted along a value's gradient g, as far as it is free to, by as much as changes the value by d."""
    if (free & FREE_PLANE) == 0:
        g[0] = 0.0
        g[1] = 0.0
    if (free & FREE_Z) == 0:
        g[2] = 0.0
    gg = g[0] * g[0] + g[1] * g[1] + g[2] * g[2]
    if gg > 1.0e-8:
        pose = pose + d / gg * wp.vec4(g[0], g[1], g[2], 0.0)
    return pose


@wp.func
def turned(x: Body, angle: wp.float32):
    """An object turned by an angle."""
    return posed(x, wp.vec4(x.pose[0], x.pose[1], x.pose[2], x.pose[3] + angle))


@wp.func
def project_option(t: TablesRef, option: wp.int32, x: Relation, free: wp.int32, fresh: wp.bool, rng: wp.ref[wp.uint32]):
    """The subject's pose moved into the rows of one option, row by row.

    A fresh draw takes a new value for every row; otherwise only rows outside their interval move it.
    """
    for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
        kind = item(t[0].row_feature, row)
        if kind != FEATURE_CONSTANT:
            value, g = feature(t, row, 0, x)
            span = item(t[0].row_aim, row)
            aim = wp.vec2(span[0], span[1])
            off, _sign = outside(value, aim)
            if off > 0.0 or fresh:
                d = target_value(aim, rng) - value
                if kind == FEATURE_YAW or kind == FEATURE_BEARING:
                    if free & FREE_YAW:
                        if kind == FEATURE_YAW and uniform(rng) < 0.7:
                            d = wp.clamp(0.0, aim[0], aim[1]) - value  # people set furniture square
                        x.a = turned(x.a, d * g[3])
                    elif free & FREE_TURNS:
                        if kind == FEATURE_YAW:
                            d = wp.clamp(0.0, aim[0], aim[1]) - value
                        yaw = nearest_yaw(t, x.a.index, x.a.pose[3] + d * g[3])
                        x.a = turned(x.a, yaw - x.a.pose[3])
                else:
                    x.a.pose = shifted(x.a.pose, d, g, free)
    return x.a.pose


@wp.func
def project_onto_relations(
    b: Problems, c: Candidate, obj: wp.int32, pose: wp.vec4, s: State, fresh: wp.bool, rng: wp.ref[wp.uint32]
):
    """A pose projected onto the object's own relations; a fresh draw starts from one of them at random."""
    t = b.tables
    o = c.first_object + obj
    r0 = item(t[0].relation_start, c.problem)
    first = item(t[0].incidence_start, o)
    count = item(t[0].incidence_start, o + 1) - first
    free = item(t[0].object_free, o)
    mine = int(0)
    for k in range(first, first + count):
        if item(t[0].incidence_role, k) == 0 and item(t[0].relation_rigid, r0 + item(t[0].incidence, k)) == 0:
            mine += 1
    if mine == 0:
        return pose
    skip = int(-1)
    if fresh:
        skip = pick(rng, mine)
    # a fresh draw's sweep of one relation (for others it is empty, so that all go through the second side by side),
    # then a sweep over all
    for sweep in range(0, 2, opaque_one()):
        for k in range(first, first + count):
            r = r0 + item(t[0].incidence, k)
            if item(t[0].incidence_role, k) == 0 and item(t[0].relation_rigid, r) == 0:
                draw = sweep == 0 and skip == 0
                if sweep == 0:
                    skip -= 1
                if sweep > 0:
                    draw = item(t[0].relation_fault, r) != 0 or uniform(rng) < 0.7
                if draw:
                    x = relation_of(t, layout_of(c, s), r)
                    x.a = posed(x.a, pose)
                    option = item(t[0].option_start, r)
                    low = float(1.0)
                    if sweep == 0:
                        option += pick(rng, item(t[0].option_start, r + 1) - option)
                    else:
                        best, e = best_option(b, r, x)
                        option = best
                        low = e
                    if low > 0.0:
                        pose = project_option(t, option, x, free, sweep == 0, rng)
    return pose


@wp.func
def keep_inside(t: TablesRef, p: wp.int32, o: wp.int32, pose: wp.vec4, aim: wp.float32):
    """A pose with the footprint of object o (global) pushed back over each half plane that it crosses."""
    q = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
    if item(t[0].object_free, o) & FREE_PLANE:
        for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
            plane = item(t[0].plane, k)
            n = wp.vec2(plane[0], plane[1])
            depth = wp.dot(n, plane_of(pose)) - plane[2]
            if depth - item(t[0].object_radius, o)[0] < aim:
                low = lowest_vertex(t, o, turn_back(q, n))
                missing = aim - depth - low[2]
                if missing > 0.0:
                    pose[0] = pose[0] + missing * n[0]
                    pose[1] = pose[1] + missing * n[1]
    return pose


@wp.func
def slide(t: TablesRef, c: Candidate, obj: wp.int32, pose: wp.vec4, s: State, gap: wp.float32, rng: wp.ref[wp.uint32]):
    """A pose slid along the object's own left axis until its box is flush with another's, or with a wall."""
    o0 = c.first_object
    o = o0 + obj
    if (item(t[0].object_free, o) & FREE_PLANE) == 0:
        return pose
    axis = wp.vec2(-wp.sin(pose[3]), wp.cos(pose[3]))
    half = 0.5 * item(t[0].object_size, o)[1]
    side = wp.where(uniform(rng) < 0.5, 1.0, -1.0)
    n = c.objects
    step = float(0.0)
    if uniform(rng) < 0.3 or n < 2:
        found = float(1.0e6)
        for k in range(item(t[0].plane_start, c.problem), item(t[0].plane_start, c.problem + 1)):
            plane = item(t[0].plane, k)
            along = side * (plane[0] * axis[0] + plane[1] * axis[1])
            if along < -0.5:
                d = (wp.dot(wp.vec2(plane[0], plane[1]), plane_of(pose)) - plane[2]) / -along - half - gap
                if d < found:
                    found = d
        if found < 1.0e5:
            step = side * found
    else:
        near = float(1.0e12)
        for _try in range(3):
            j = pick(rng, n)
            if item(t[0].object_root, o0 + j) != obj:
                v = plane_of(item(s.poses, c.index, j)) - plane_of(pose)
                if wp.dot(v, v) < near:
                    near = wp.dot(v, v)
                    qj = item(s.turns, c.index, j)
                    size = item(t[0].object_size, o0 + j)
                    reach = 0.5 * (wp.abs(wp.dot(axis, qj)) * size[0] + wp.abs(wp.dot(axis, perp(qj))) * size[1])
                    step = wp.dot(axis, v) + side * (half + reach + gap)
    return wp.vec4(pose[0] + step * axis[0], pose[1] + step * axis[1], pose[2], pose[3])


@wp.func
def propose(
    b: Problems,
    c: Candidate,
    obj: wp.int32,
    s: State,
    scale: wp.float32,
    far: wp.float32,
    flush: wp.float32,
    rng: wp.ref[wp.uint32],
):
    """Draw a new pose for an object: with probability ``far`` in the whole room, else within ``scale`` metres.

    With probability ``flush`` it is then slid along something.
    """
    t = b.tables
    o = c.first_object + obj
    pose = item(s.poses, c.index, obj)
    fresh = uniform(rng) < far
    if fresh:
        pose = random_start(t, c.problem, o, pose, rng)
    else:
        pose = jitter(t, o, pose, scale, rng)
    pose = project_onto_relations(b, c, obj, pose, s, fresh, rng)
    pose = keep_inside(t, c.problem, o, pose, b.margins.bounds_aim)
    if uniform(rng) < flush:
        pose = slide(t, c, obj, pose, s, b.margins.collision_aim + 0.001, rng)
    return pose
