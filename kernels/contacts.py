"""Feasibility near a layout as linear inequalities on how far each root has moved from its anchor.

A convex prism is clear of another one when some face of either has all vertices of the other before it. Which face
is a discrete choice, made anew from the present poses: the one with the largest clearance, so the way out that is
shortest. Given the face, the clearance of each vertex is smooth in both poses, and its derivative gives one row
J . d >= goal on the displacements d. Bounds, zones, openings and the rows of hard relations become rows likewise.
"""

import warp as wp

from .energy import EAST, gate
from .features import feature
from .geometry import FAR, discs_apart, perp, plane_of, turn, turn_back, way_out
from .tables import (
    FIXTURE_SOLID,
    FREE_PLANE,
    FREE_YAW,
    FREE_Z,
    PAIR_COLLIDE,
    PAIR_RIGID,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    Margins,
    State,
    TablesRef,
)

wp.set_module_options({"enable_backward": False})

ROWS = wp.constant(32)  # rows that one object may have
SPARE = wp.constant(8)  # of them, kept for what is violated
SLACK = wp.constant(7.0e-4)  # [m] clearance beyond what the verdict insists on that a violated row is given
CONTENT = wp.constant(1.0e-4)  # [m] beyond the verdict's limit, from which on a row is left as it is
SURE = wp.constant(3.0e-5)  # [m] beyond the verdict's limit, for rounding
ARM = wp.constant(0.5)  # [m] that a radian of yaw counts as


@wp.struct
class Row:
    """One inequality first . d[body 0] + second . d[body 1] + third . d[body 2] >= goal; body -1: none."""

    body: wp.vec3i
    first: wp.vec4
    second: wp.vec4
    third: wp.vec4
    goal: wp.float32
    inverse: wp.float32  # of J W^-1 J^T, where W holds the weights of the squared movement


@wp.func
def mobility(v: wp.vec4):
    """W^-1 v: the least movement that a unit pull along v causes."""
    return wp.vec4(v[0], v[1], v[2], v[3] / (ARM * ARM))


@wp.func
def on_root(t: TablesRef, o0: wp.int32, obj: wp.int32, g: wp.vec4, s: State, candidate: wp.int32):
    """A gradient for an object's pose as one for the pose of its root, without what the root is not free to do."""
    root = t[0].object_root[o0 + obj]
    if root != obj:
        arm = perp(plane_of(s.poses[candidate, obj]) - plane_of(s.poses[candidate, root]))
        g[3] = g[3] + g[0] * arm[0] + g[1] * arm[1]
    free = t[0].object_free[o0 + root]
    if (free & FREE_PLANE) == 0:
        g[0] = 0.0
        g[1] = 0.0
    if (free & FREE_Z) == 0:
        g[2] = 0.0
    if (free & FREE_YAW) == 0:
        g[3] = 0.0
    return g


@wp.func(inline=False)
def add_row(
    t: TablesRef,
    o0: wp.int32,
    candidate: wp.int32,
    slot: wp.int32,
    who: wp.vec3i,
    ga: wp.vec4,
    gb: wp.vec4,
    gc: wp.vec4,
    missing: wp.float32,
    key: wp.int32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Row),
    keys: wp.array2d(dtype=wp.int32),
):
    """Write a row into a slot: the gradients for the objects ``who`` have to gain what is missing at the present poses.

    Returns 1, or 0 when nothing that is free to move can change it.
    """
    row = Row()
    a = t[0].object_root[o0 + who[0]]
    row.body = wp.vec3i(a, -1, -1)
    row.first = on_root(t, o0, who[0], ga, s, candidate)
    row.goal = missing
    if who[1] >= 0:
        b = t[0].object_root[o0 + who[1]]
        g = on_root(t, o0, who[1], gb, s, candidate)
        if b == a:
            row.first += g
        else:
            row.body[1] = b
            row.second = g
    if who[2] >= 0:
        c = t[0].object_root[o0 + who[2]]
        h = on_root(t, o0, who[2], gc, s, candidate)
        if c == a:
            row.first += h
        elif c == row.body[1]:
            row.second += h
        else:
            row.body[2] = c
            row.third = h
    size = wp.dot(row.first, mobility(row.first)) + wp.dot(row.second, mobility(row.second))
    size += wp.dot(row.third, mobility(row.third))
    if size < 1.0e-8:
        return int(0)
    row.inverse = 1.0 / size
    row.goal += wp.dot(row.first, shift[candidate, a])
    if row.body[1] >= 0:
        row.goal += wp.dot(row.second, shift[candidate, row.body[1]])
    if row.body[2] >= 0:
        row.goal += wp.dot(row.third, shift[candidate, row.body[2]])
    rows[candidate, slot] = row
    keys[candidate, slot] = key
    return int(1)


@wp.func
def wanting(clearance: wp.float32, hold: wp.float32):
    """What a clearance is to gain: when it is violated, enough for a little more than the limit.

    Contacts that the verdict accepts keep what they have, so that what is in order need not move.
    """
    want = hold + SLACK - clearance
    if clearance >= hold + CONTENT:
        want = wp.min(want, 0.0)
    return want


@wp.func(inline=False)
def parting_face(
    t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2, far: wp.float32
):
    """The face, of prism a or b, with the largest clearance of the other prism: (clearance, face, 1 when it is a's).

    As `geometry.separation`, which finds the same clearance: faces that are no way out only tell whether the prisms
    are apart. The face is -1 when they are further apart than ``far``.
    """
    best = float(-FAR)
    best_face = int(-1)
    best_mine = int(1)
    shut = float(-FAR)
    shut_face = int(-1)
    shut_mine = int(1)
    a0 = t[0].prism_start[a]
    a1 = t[0].prism_start[a + 1]
    b0 = t[0].prism_start[b]
    b1 = t[0].prism_start[b + 1]
    ab = pb - pa
    for k in range(a0, a1 + b1 - b0):
        mine = int(1)
        face = k
        v0 = b0
        v1 = b1
        q = qa
        other = qb
        towards = ab
        if k >= a1:
            mine = 0
            face = b0 + k - a1
            v0 = a0
            v1 = a1
            q = qb
            other = qa
            towards = -ab
        plane = t[0].edge[face]
        n = turn(q, wp.vec2(plane[0], plane[1]))
        m = turn_back(other, n)
        low = float(FAR)
        rest = int(v0)
        for v in range(v0, v1):
            d = wp.dot(m, t[0].vertex[v])
            if d < low:
                low = d
                rest = v
        clear = low + wp.dot(n, towards) - plane[2]
        if clear > far:
            return clear, int(-1), int(1)
        if clear > wp.min(best, shut):
            if way_out(t, face, v0, v1, rest):
                if clear > best:
                    best = clear
                    best_face = face
                    best_mine = mine
            else:
                if clear > 0.0:
                    return FAR, int(-1), int(1)
                if clear > shut:
                    shut = clear
                    shut_face = face
                    shut_mine = mine
    if best == -FAR:
        return shut, shut_face, shut_mine
    return best, best_face, best_mine


@wp.func(inline=False)
def add_contacts(
    t: TablesRef,
    o0: wp.int32,
    candidate: wp.int32,
    base: wp.int32,
    count: wp.int32,
    i: wp.int32,
    first_start: wp.int32,
    first_end: wp.int32,
    first_list: wp.array(dtype=wp.int32),
    pose_a: wp.vec4,
    qa: wp.vec2,
    j: wp.int32,
    second_start: wp.int32,
    second_end: wp.int32,
    second_list: wp.array(dtype=wp.int32),
    pose_b: wp.vec4,
    qb: wp.vec2,
    hold: wp.float32,
    least: wp.float32,
    reach: wp.float32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Row),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows that keep two sets of prisms, of objects i and j (-1: static), apart.

    Each pair of prisms gets the two vertices nearest to the parting face, so that a face may rest on a face. Returns
    the number of rows so far, and by how much [m] the pairs miss the verdict's limit in all, without those that cannot
    move.
    """
    pa = plane_of(pose_a)
    pb = plane_of(pose_b)
    missed = float(0.0)
    for x in range(first_start, first_end):
        a = first_list[x]
        for y in range(second_start, second_end):
            b = second_list[y]
            if gate(pose_a[2], t[0].prism_z[a], pose_b[2], t[0].prism_z[b], least):
                if not discs_apart(t, a, pa, qa, b, pb, qb, reach):
                    clear, face, mine = parting_face(t, a, pa, qa, b, pb, qb, reach)
                    if face >= 0:
                        mobile = int(0)
                        # the face's owner, the other prism, and the direction from a to b
                        owner = pa
                        turned = qa
                        v0 = t[0].prism_start[b]
                        v1 = t[0].prism_start[b + 1]
                        at = pb
                        q = qb
                        if mine == 0:
                            owner = pb
                            turned = qb
                            v0 = t[0].prism_start[a]
                            v1 = t[0].prism_start[a + 1]
                            at = pa
                            q = qa
                        plane = t[0].edge[face]
                        n = turn(turned, wp.vec2(plane[0], plane[1]))
                        m = turn_back(q, n)
                        offset = wp.dot(n, at - owner) - plane[2]
                        lowest = int(-1)
                        second = int(-1)
                        low = float(FAR)
                        next = float(FAR)
                        for v in range(v0, v1):
                            d = wp.dot(m, t[0].vertex[v]) + offset
                            if d < low:
                                next = low
                                second = lowest
                                low = d
                                lowest = v
                            elif d < next:
                                next = d
                                second = v
                        out = n
                        if mine == 0:
                            out = -n
                        for k in range(2):
                            v = lowest
                            d = low
                            if k == 1:
                                v = second
                                d = next
                            if v >= 0 and d < reach:
                                room = ROWS
                                if d > hold:
                                    room = ROWS - SPARE
                                if count >= room:
                                    mobile = 1
                                else:
                                    point = at + turn(q, t[0].vertex[v])
                                    ga = wp.vec4(-out[0], -out[1], 0.0, -wp.dot(out, perp(point - pa)))
                                    gb = wp.vec4(out[0], out[1], 0.0, wp.dot(out, perp(point - pb)))
                                    one = add_row(
                                        t, o0, candidate, base + count, wp.vec3i(i, j, -1), ga, gb,
                                        wp.vec4(0.0, 0.0, 0.0, 0.0), wanting(d, hold), face * 32768 + v, s, shift,
                                        rows, keys,
                                    )
                                    count += one
                                    mobile += one
                        if mobile > 0:
                            missed += wp.max(hold + SURE - clear, 0.0)
    return count, missed


@wp.func(inline=False)
def add_bounds(
    t: TablesRef,
    m: Margins,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    base: wp.int32,
    count: wp.int32,
    reach: wp.float32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Row),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows that keep an object in the room and out of openings; returns as `add_contacts`."""
    o0 = t[0].object_start[p]
    o = o0 + obj
    pose = s.poses[candidate, obj]
    q = s.turns[candidate, obj]
    at = plane_of(pose)
    none = wp.vec4(0.0, 0.0, 0.0, 0.0)
    missed = float(0.0)
    radius = t[0].object_radius[o][0]
    for k in range(t[0].plane_start[p], t[0].plane_start[p + 1]):
        plane = t[0].plane[k]
        n = wp.vec2(plane[0], plane[1])
        depth = wp.dot(n, at) - plane[2]
        if depth - radius < reach:
            mm = turn_back(q, n)
            lowest = int(-1)
            second = int(-1)
            low = float(FAR)
            next = float(FAR)
            for f in range(t[0].foot_start[o], t[0].foot_start[o + 1]):
                a = t[0].foot[f]
                for v in range(t[0].prism_start[a], t[0].prism_start[a + 1]):
                    d = depth + wp.dot(mm, t[0].vertex[v])
                    if d < low:
                        next = low
                        second = lowest
                        low = d
                        lowest = v
                    elif d < next:
                        next = d
                        second = v
            mobile = int(0)
            for c in range(2):
                v = lowest
                d = low
                if c == 1:
                    v = second
                    d = next
                if count >= ROWS:
                    mobile = 1
                elif v >= 0 and d < reach:
                    arm = turn(q, t[0].vertex[v])
                    g = wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(arm)))
                    one = add_row(
                        t, o0, candidate, base + count, wp.vec3i(obj, -1, -1), g, none, none,
                        wanting(d, m.bounds_hold), -3 - (k * 32768 + v), s, shift, rows, keys,
                    )
                    count += one
                    mobile += one
            if mobile > 0:
                missed += wp.max(m.bounds_hold + SURE - low, 0.0)
    for k in range(t[0].fixture_start[p], t[0].fixture_start[p + 1]):
        disc = t[0].prism_disc[t[0].fixture[k]]
        to = wp.vec2(disc[0], disc[1]) - at
        far = disc[2] + radius + reach
        if wp.dot(to, to) < far * far:
            solid = t[0].fixture_kind[k] == FIXTURE_SOLID
            if solid or t[0].object_clear[o] == 1:
                hold = wp.where(solid, m.bounds_hold, m.zone_hold)
                more, miss = add_contacts(
                    t, o0, candidate, base, count, obj, t[0].solid_start[o], t[0].solid_start[o + 1], t[0].solid, pose,
                    q, -1, k, k + 1, t[0].fixture, none, EAST, hold, m.gate, reach, s, shift, rows, keys,
                )
                count = more
                missed += miss
    z = t[0].object_z[o]
    down = pose[2] + z[0]
    up = t[0].room_height[p] - z[1] - pose[2]
    if t[0].object_free[o] & FREE_Z:
        missed += wp.max(m.bounds_hold - down, 0.0) + wp.max(m.bounds_hold - up, 0.0)
        rise = wp.vec4(0.0, 0.0, 1.0, 0.0)
        if down < reach and count < ROWS:
            count += add_row(
                t, o0, candidate, base + count, wp.vec3i(obj, -1, -1), rise, none, none, wanting(down, m.bounds_hold),
                -1, s, shift, rows, keys,
            )
        if up < reach and count < ROWS:
            count += add_row(
                t, o0, candidate, base + count, wp.vec3i(obj, -1, -1), -rise, none, none, wanting(up, m.bounds_hold),
                -2, s, shift, rows, keys,
            )
    return count, missed


@wp.func(inline=False)
def add_pairs(
    t: TablesRef,
    m: Margins,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    base: wp.int32,
    count: wp.int32,
    reach: wp.float32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Row),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows of the pairs that an object looks after: solids apart, and out of hard zones. Returns as `add_contacts`.

    Of two objects the first looks after the pair when their indices are both even or both odd, else the second, so
    that threads of one candidate have like work.
    """
    o0 = t[0].object_start[p]
    n = t[0].object_start[p + 1] - o0
    a = o0 + obj
    pose = s.poses[candidate, obj]
    q = s.turns[candidate, obj]
    radius = t[0].object_radius[a]
    line = t[0].pair_start[p] + obj * n
    sa = t[0].solid_start[a]
    sa1 = t[0].solid_start[a + 1]
    missed = float(0.0)
    for j in range(n):
        ours = ((obj + j) & 1) == 0
        if j < obj:
            ours = not ours
        if ours:
            flags = int(t[0].pair_flags[line + j])
            if flags != 0 and (flags & PAIR_RIGID) == 0:
                other = s.poses[candidate, j]
                v = plane_of(other) - plane_of(pose)
                b = o0 + j
                rj = t[0].object_radius[b]
                far = wp.max(radius[0] + rj[1], radius[1] + rj[0]) + reach
                if wp.dot(v, v) < far * far:
                    qj = s.turns[candidate, j]
                    sb = t[0].solid_start[b]
                    sb1 = t[0].solid_start[b + 1]
                    if flags & PAIR_COLLIDE:
                        count1, miss1 = add_contacts(
                            t, o0, candidate, base, count, obj, sa, sa1, t[0].solid, pose, q, j, sb, sb1, t[0].solid,
                            other, qj, m.collision_hold, m.gate, reach, s, shift, rows, keys,
                        )
                        count = count1
                        missed += miss1
                    if flags & PAIR_ZONE_OF_FIRST:
                        count2, miss2 = add_contacts(
                            t, o0, candidate, base, count, obj, t[0].zone_start[a], t[0].zone_start[a + 1], t[0].zone,
                            pose, q, j, sb, sb1, t[0].solid, other, qj, m.zone_hold, m.gate, reach, s, shift, rows,
                            keys,
                        )
                        count = count2
                        missed += miss2
                    if flags & PAIR_ZONE_OF_SECOND:
                        count3, miss3 = add_contacts(
                            t, o0, candidate, base, count, obj, sa, sa1, t[0].solid, pose, q, j, t[0].zone_start[b],
                            t[0].zone_start[b + 1], t[0].zone, other, qj, m.zone_hold, m.gate, reach, s, shift, rows,
                            keys,
                        )
                        count = count3
                        missed += miss3
    return count, missed


@wp.func(inline=False)
def add_relations(
    t: TablesRef,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    base: wp.int32,
    count: wp.int32,
    reach: wp.float32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Row),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows of the hard relations of which an object is the subject, under their chosen options; as `add_contacts`."""
    o0 = t[0].object_start[p]
    r0 = t[0].relation_start[p]
    o = o0 + obj
    missed = float(0.0)
    for c in range(t[0].touch_start[o], t[0].touch_start[o + 1]):
        r = r0 + t[0].touch[c]
        if t[0].touch_role[c] == 0 and t[0].relation_fault[r] != 0 and t[0].relation_rigid[r] == 0:
            ids = t[0].relation_object[r]
            pose_a = s.poses[candidate, obj]
            qa = s.turns[candidate, obj]
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
            option = s.options[candidate, r - r0]
            for k in range(t[0].row_start[option], t[0].row_start[option + 1]):
                scale = t[0].row_scale[k]
                value, ga = feature(t, k, 0, o, b, pose_a, qa, pose_b, qb, pose_c)
                gb = wp.vec4(0.0, 0.0, 0.0, 0.0)
                gc = wp.vec4(0.0, 0.0, 0.0, 0.0)
                if ids[1] >= 0:
                    _vb, gb1 = feature(t, k, 1, o, b, pose_a, qa, pose_b, qb, pose_c)
                    gb = gb1
                if ids[2] >= 0:
                    _vc, gc1 = feature(t, k, 2, o, b, pose_a, qa, pose_b, qb, pose_c)
                    gc = gc1
                hold = t[0].row_hold[k]
                width = (hold[1] - hold[0]) * scale
                for side in range(2):
                    clear = (value - hold[0]) * scale
                    sign = scale
                    if side == 1:
                        clear = (hold[1] - value) * scale
                        sign = -scale
                    if clear < reach:
                        one = int(1)
                        inset = wp.min(SLACK, 0.4 * width)
                        want = inset - clear
                        if clear > 0.1 * inset:
                            want = wp.min(want, 0.0)
                        if count < ROWS:
                            one = add_row(
                                t, o0, candidate, base + count, ids, sign * ga, sign * gb, sign * gc, want,
                                1073741824 + 2 * k + side, s, shift, rows, keys,
                            )
                            count += one
                        if one > 0:
                            missed += wp.max(-clear, 0.0)
    return count, missed


@wp.kernel
def gather_rows(
    # Problem:
    t: TablesRef,
    m: Margins,
    reach: wp.float32,
    problem: wp.array(dtype=wp.int32),
    active: wp.array(dtype=wp.int32),
    # State in:
    live: wp.array(dtype=wp.int32),
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    keys: wp.array2d(dtype=wp.int32),
    force: wp.array2d(dtype=wp.float32),
    # State in and out:
    count: wp.array2d(dtype=wp.int32),
    # State out:
    rows_out: wp.array2d(dtype=Row),
    keys_out: wp.array2d(dtype=wp.int32),
    force_out: wp.array2d(dtype=wp.float32),
    missed_out: wp.array2d(dtype=wp.float32),
):
    """Rows of every active (candidate, object) at the present poses, with the forces that they had before.

    ``shift`` [candidate, object] is how far each root is from its anchor; slots of an object's rows begin at
    ROWS times its index. ``missed_out`` is by how much [m] its terms miss the verdict's limits, without those that
    nothing free to move can mend.
    """
    slot, obj = wp.tid()
    candidate = active[slot]
    p = problem[candidate]
    if live[candidate] == 0 or obj >= t[0].object_start[p + 1] - t[0].object_start[p]:
        return
    if not wp.isfinite(s.poses[candidate, obj]):
        missed_out[candidate, obj] = FAR
        count[candidate, obj] = 0
        return
    base = obj * ROWS
    before = count[candidate, obj]
    n1, miss1 = add_bounds(t, m, p, candidate, obj, base, 0, reach, s, shift, rows_out, keys_out)
    n2, miss2 = add_relations(t, p, candidate, obj, base, n1, reach, s, shift, rows_out, keys_out)
    n3, miss3 = add_pairs(t, m, p, candidate, obj, base, n2, reach, s, shift, rows_out, keys_out)
    for k in range(n3):
        key = keys_out[candidate, base + k]
        warm = float(0.0)
        for c in range(before):
            if keys[candidate, base + c] == key:
                warm = force[candidate, base + c]
        force_out[candidate, base + k] = warm
    count[candidate, obj] = n3
    missed_out[candidate, obj] = miss1 + miss2 + miss3
