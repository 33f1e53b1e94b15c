"""Energy of a candidate and its gradient: collisions, bounds, zones, openings and relations in one gather.

One thread per (candidate, object) adds up every term that its object takes part in, so nothing is written twice and
no atomics are needed. Each penalty is C1 in the length that it is a penalty of: quadratic up to a knee, then linear
(Huber), on the clearance that is missing to a small safety margin, so that the optimum is strictly feasible. That
length itself has kinks where the witness changes, and jumps where a body leaves a pocket by a face that is no way out.
"""

import warp as wp

from .cells import cell_at, crowded
from .features import TURN, feature
from .geometry import FAR, discs_apart, perp, plane_of, separation, turn, wrap
from .tables import (
    FIXTURE_SOLID,
    FREE_Z,
    PAIR_COLLIDE,
    PAIR_RIGID,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    Margins,
    State,
    TablesRef,
    Weights,
)

wp.set_module_options({"enable_backward": False})

ORIGIN = wp.constant(wp.vec2(0.0, 0.0))
EAST = wp.constant(wp.vec2(1.0, 0.0))


@wp.func
def penalty(v: wp.float32, knee: wp.float32):
    """Huber penalty of a violation v [m] and its slope; zero for v <= 0."""
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


@wp.func
def gate(za: wp.float32, a: wp.vec2, zb: wp.float32, b: wp.vec2, least: wp.float32):
    """True when two z intervals overlap by more than the least: z decides whether, never how."""
    return wp.min(za + a[1], zb + b[1]) - wp.max(za + a[0], zb + b[0]) > least


@wp.func(inline=False)
def clearance(
    t: TablesRef,
    first_start: wp.int32,
    first_end: wp.int32,
    first_list: wp.array(dtype=wp.int32),
    pose_a: wp.vec4,
    qa: wp.vec2,
    second_start: wp.int32,
    second_end: wp.int32,
    second_list: wp.array(dtype=wp.int32),
    pose_b: wp.vec4,
    qb: wp.vec2,
    aim: wp.float32,
    least: wp.float32,
    knee: wp.float32,
):
    """Penalty of two sets of prisms for being closer than aim, with the gradient for the first's pose."""
    pa = plane_of(pose_a)
    pb = plane_of(pose_b)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for i in range(first_start, first_end):
        a = first_list[i]
        for j in range(second_start, second_end):
            b = second_list[j]
            if gate(pose_a[2], t[0].prism_z[a], pose_b[2], t[0].prism_z[b], least):
                if not discs_apart(t, a, pa, qa, b, pb, qb, aim):
                    s, n, x = separation(t, a, pa, qa, b, pb, qb, aim)
                    de, dv = penalty(aim - s, knee)
                    e += de
                    g += dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(x - pa)))
    return e, g


@wp.func
def pair_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    flags: wp.int32,
    a: wp.int32,
    pose_a: wp.vec4,
    qa: wp.vec2,
    b: wp.int32,
    pose_b: wp.vec4,
    qb: wp.vec2,
):
    """Collision and zone penalties of objects a and b (global indices), with the gradient for a's pose."""
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    sa = t[0].solid_start[a]
    sa1 = t[0].solid_start[a + 1]
    sb = t[0].solid_start[b]
    sb1 = t[0].solid_start[b + 1]
    if flags & PAIR_COLLIDE:
        ec, gc = clearance(
            t, sa, sa1, t[0].solid, pose_a, qa, sb, sb1, t[0].solid, pose_b, qb, m.collision_aim, m.gate, w.knee
        )
        e += w.collision * ec
        g += w.collision * gc
    if flags & PAIR_ZONE_OF_FIRST:
        ez, gz = clearance(
            t, t[0].zone_start[a], t[0].zone_start[a + 1], t[0].zone, pose_a, qa, sb, sb1, t[0].solid, pose_b, qb,
            m.zone_aim, m.gate, w.knee,
        )
        e += w.zone * ez
        g += w.zone * gz
    if flags & PAIR_ZONE_OF_SECOND:
        ey, gy = clearance(
            t, sa, sa1, t[0].solid, pose_a, qa, t[0].zone_start[b], t[0].zone_start[b + 1], t[0].zone, pose_b, qb,
            m.zone_aim, m.gate, w.knee,
        )
        e += w.zone * ey
        g += w.zone * gy
    return e, g


@wp.func(inline=False)
def room_energy(t: TablesRef, m: Margins, w: Weights, p: wp.int32, o: wp.int32, pose: wp.vec4, q: wp.vec2):
    """Bounds and openings: penalty of object o (global index) against the room, with gradient."""
    at = plane_of(pose)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    reach = t[0].object_radius[o][0]
    for k in range(t[0].plane_start[p], t[0].plane_start[p + 1]):
        plane = t[0].plane[k]
        n = wp.vec2(plane[0], plane[1])
        depth = wp.dot(n, at) - plane[2]
        if depth - reach < m.bounds_aim:
            low = float(1.0e6)
            x = at
            for f in range(t[0].foot_start[o], t[0].foot_start[o + 1]):
                a = t[0].foot[f]
                for v in range(t[0].prism_start[a], t[0].prism_start[a + 1]):
                    r = turn(q, t[0].vertex[v])
                    d = depth + wp.dot(n, r)
                    if d < low:
                        low = d
                        x = at + r
            de, dv = penalty(m.bounds_aim - low, w.knee)
            e += w.bounds * de
            g -= w.bounds * dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(x - at)))
    for k in range(t[0].fixture_start[p], t[0].fixture_start[p + 1]):
        a = t[0].fixture[k]
        disc = t[0].prism_disc[a]
        to = wp.vec2(disc[0], disc[1]) - at
        far = disc[2] + reach + m.bounds_aim
        if wp.dot(to, to) < far * far:
            solid = t[0].fixture_kind[k] == FIXTURE_SOLID
            if solid or t[0].object_clear[o] == 1:
                aim = wp.where(solid, m.bounds_aim, m.zone_aim)
                es, gs = clearance(
                    t, t[0].solid_start[o], t[0].solid_start[o + 1], t[0].solid, pose, q, k, k + 1, t[0].fixture,
                    wp.vec4(0.0, 0.0, 0.0, 0.0), EAST, aim, m.gate, w.knee,
                )
                weight = wp.where(solid, w.bounds, w.opening)
                e += weight * es
                g += weight * gs
    if t[0].object_free[o] & FREE_Z:
        z = t[0].object_z[o]
        off, slope = outside(pose[2], wp.vec2(m.bounds_aim - z[0], t[0].room_height[p] - z[1] - m.bounds_aim))
        dz, dzv = penalty(off, w.knee)
        e += w.bounds * dz
        g += wp.vec4(0.0, 0.0, w.bounds * dzv * slope, 0.0)
    return e, g


@wp.func(inline=False)
def relation_energy(
    t: TablesRef,
    w: Weights,
    o0: wp.int32,
    r: wp.int32,
    option: wp.int32,
    role: wp.int32,
    s: State,
    candidate: wp.int32,
):
    """Penalty of relation r under one option, with the gradient for the object in the given role."""
    ids = t[0].relation_object[r]
    pose_a = s.poses[candidate, ids[0]]
    qa = s.turns[candidate, ids[0]]
    pose_b = wp.vec4(0.0, 0.0, 0.0, 0.0)
    qb = EAST
    pose_c = wp.vec4(0.0, 0.0, 0.0, 0.0)
    b = int(-1)
    if ids[1] >= 0:
        b = o0 + ids[1]
        pose_b = s.poses[candidate, ids[1]]
        qb = s.turns[candidate, ids[1]]
    if ids[2] >= 0:
        pose_c = s.poses[candidate, ids[2]]
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for row in range(t[0].row_start[option], t[0].row_start[option + 1]):
        value, slope = feature(t, row, role, o0 + ids[0], b, pose_a, qa, pose_b, qb, pose_c)
        off, sign = outside(value, t[0].row_aim[row])
        scale = t[0].row_scale[row]
        de, dv = penalty(off * scale, w.knee)
        e += de
        g += dv * sign * scale * slope
    weight = w.relation * t[0].relation_weight[r]
    return weight * e, weight * g


@wp.func
def meeting(
    t: TablesRef,
    m: Margins,
    w: Weights,
    o0: wp.int32,
    row: wp.int32,
    o: wp.int32,
    pose: wp.vec4,
    q: wp.vec2,
    j: wp.int32,
    candidate: wp.int32,
    s: State,
    stamp: wp.int32,
):
    """Pair energy of object o (global) with object j (local), and its gradient for o's pose."""
    flags = int(t[0].pair_flags[row + j])
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if flags != 0 and (flags & PAIR_RIGID) == 0:
        other = s.poses[candidate, j]
        v = plane_of(other) - plane_of(pose)
        ri = t[0].object_radius[o]
        rj = t[0].object_radius[o0 + j]
        # a zone only meets solids
        far = wp.max(ri[0] + rj[1], ri[1] + rj[0]) + m.collision_aim
        if wp.dot(v, v) < far * far:
            if stamp == 0 or s.mark[candidate, j] != stamp:
                e, g = pair_energy(t, m, w, flags, o, pose, q, o0 + j, other, s.turns[candidate, j])
    return e, g


@wp.func(inline=False)
def object_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    s: State,
    limit: wp.float32,
    stamp: wp.int32,
):
    """Everything that object ``obj`` of a candidate takes part in.

    Returns (energy, share, soft, gradient): the energy of all its terms; its share of the candidate's energy (half of
    each pair, the whole of a relation for its subject); what of the share soft relations and the pull make up; and the
    gradient of the energy for its pose (x, y, z, yaw). Once the energy exceeds the limit the rest is left out;
    so are pairs with objects that carry the stamp of the same move (0: none), whose distances a move does not change.
    """
    o0 = t[0].object_start[p]
    n = t[0].object_start[p + 1] - o0
    o = o0 + obj
    pose = s.poses[candidate, obj]
    q = s.turns[candidate, obj]
    at = plane_of(pose)
    if not wp.isfinite(pose):  # comparisons with NaN are false, so every term would pass it
        return FAR, FAR, float(0.0), wp.vec4(0.0, 0.0, 0.0, 0.0)
    e, g = room_energy(t, m, w, p, o, pose, q)
    soft = float(0.0)
    if w.pull > 0.0:
        d = pose - s.anchors[candidate, obj]
        d[3] = wrap(d[3], TURN)
        soft += 0.5 * w.pull * wp.dot(d, d)
        e += soft
        g += w.pull * d
    share = e
    r0 = t[0].relation_start[p]
    for k in range(t[0].touch_start[o], t[0].touch_start[o + 1]):
        r = t[0].touch[k]
        if t[0].relation_rigid[r0 + r] == 0:
            role = t[0].touch_role[k]
            er, gr = relation_energy(t, w, o0, r0 + r, s.options[candidate, r], role, s, candidate)
            e += er
            g += gr
            if role == 0:
                share += er
                if t[0].relation_fault[r0 + r] == 0:
                    soft += er
    row = t[0].pair_start[p] + obj * n
    if crowded(n, s):
        reach = t[0].object_radius[o][1] + t[0].grid[p][3] + m.collision_aim
        left, low = cell_at(t, p, at[0] - reach, at[1] - reach)
        right, high = cell_at(t, p, at[0] + reach, at[1] + reach)
        for y in range(low, high + 1):
            if e > limit:
                break
            for x in range(left, right + 1):
                j = s.cell_head[candidate, y * t[0].grid_count[p][0] + x]
                while j >= 0:
                    ep, gp = meeting(t, m, w, o0, row, o, pose, q, j, candidate, s, stamp)
                    e += ep
                    share += 0.5 * ep
                    g += gp
                    j = s.cell_next[candidate, j]
    else:
        for k in range(n):
            if e > limit:
                break
            eq, gq = meeting(t, m, w, o0, row, o, pose, q, k, candidate, s, stamp)
            e += eq
            share += 0.5 * eq
            g += gq
    return e, share, soft, g


@wp.kernel
def evaluate(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    problem: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    share_out: wp.array2d(dtype=wp.float32),
    soft_out: wp.array2d(dtype=wp.float32),
    gradient_out: wp.array2d(dtype=wp.vec4),
):
    """Energy share, soft part of it and gradient of every object, [candidate, object]."""
    candidate, obj = wp.tid()
    p = problem[candidate]
    if obj >= t[0].object_start[p + 1] - t[0].object_start[p]:
        share_out[candidate, obj] = 0.0
        soft_out[candidate, obj] = 0.0
        gradient_out[candidate, obj] = wp.vec4(0.0, 0.0, 0.0, 0.0)
        return
    _e, share, soft, g = object_energy(t, m, w, p, candidate, obj, s, FAR, 0)
    share_out[candidate, obj] = share
    soft_out[candidate, obj] = soft
    gradient_out[candidate, obj] = g
