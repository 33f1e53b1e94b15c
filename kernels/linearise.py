"""Feasibility near a layout as linear inequalities: bounds, openings, hard relations, collisions and zones."""

import warp as wp

from .contacts import add_contacts
from .energy import EAST
from .features import feature
from .geometry import FAR, perp, plane_of, turn, turn_back
from .inequality import ROWS, SLACK, SURE, Inequality, add_row, wanting
from .tables import (
    FIXTURE_SOLID,
    FREE_Z,
    PAIR_COLLIDE,
    PAIR_RIGID,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    SOLIDS,
    ZONES,
    Margins,
    State,
    TablesRef,
    parts_of,
)

wp.set_module_options({"enable_backward": False})


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
    rows: wp.array2d(dtype=Inequality),
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
            for f in range(t[0].footprint_start[o], t[0].footprint_start[o + 1]):
                a = t[0].footprint[f]
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
                        t,
                        o0,
                        candidate,
                        base + count,
                        wp.vec3i(obj, -1, -1),
                        g,
                        none,
                        none,
                        wanting(d, m.bounds_hold),
                        -3 - (k * 32768 + v),
                        s,
                        shift,
                        rows,
                        keys,
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
                prism = t[0].fixture[k]
                more, miss = add_contacts(
                    t,
                    o0,
                    candidate,
                    base,
                    count,
                    obj,
                    parts_of(t, o, SOLIDS),
                    pose,
                    q,
                    -1,
                    wp.vec2i(prism, prism + 1),
                    none,
                    EAST,
                    hold,
                    m.least_overlap_z,
                    reach,
                    s,
                    shift,
                    rows,
                    keys,
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
                t,
                o0,
                candidate,
                base + count,
                wp.vec3i(obj, -1, -1),
                rise,
                none,
                none,
                wanting(down, m.bounds_hold),
                -1,
                s,
                shift,
                rows,
                keys,
            )
        if up < reach and count < ROWS:
            count += add_row(
                t,
                o0,
                candidate,
                base + count,
                wp.vec3i(obj, -1, -1),
                -rise,
                none,
                none,
                wanting(up, m.bounds_hold),
                -2,
                s,
                shift,
                rows,
                keys,
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
    rows: wp.array2d(dtype=Inequality),
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
    sa = parts_of(t, a, SOLIDS)
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
                    sb = parts_of(t, b, SOLIDS)
                    if flags & PAIR_COLLIDE:
                        count1, miss1 = add_contacts(
                            t,
                            o0,
                            candidate,
                            base,
                            count,
                            obj,
                            sa,
                            pose,
                            q,
                            j,
                            sb,
                            other,
                            qj,
                            m.collision_hold,
                            m.least_overlap_z,
                            reach,
                            s,
                            shift,
                            rows,
                            keys,
                        )
                        count = count1
                        missed += miss1
                    if flags & PAIR_ZONE_OF_FIRST:
                        count2, miss2 = add_contacts(
                            t,
                            o0,
                            candidate,
                            base,
                            count,
                            obj,
                            parts_of(t, a, ZONES),
                            pose,
                            q,
                            j,
                            sb,
                            other,
                            qj,
                            m.zone_hold,
                            m.least_overlap_z,
                            reach,
                            s,
                            shift,
                            rows,
                            keys,
                        )
                        count = count2
                        missed += miss2
                    if flags & PAIR_ZONE_OF_SECOND:
                        count3, miss3 = add_contacts(
                            t,
                            o0,
                            candidate,
                            base,
                            count,
                            obj,
                            sa,
                            pose,
                            q,
                            j,
                            parts_of(t, b, ZONES),
                            other,
                            qj,
                            m.zone_hold,
                            m.least_overlap_z,
                            reach,
                            s,
                            shift,
                            rows,
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
    rows: wp.array2d(dtype=Inequality),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows of the hard relations of which an object is the subject, under their chosen options; as `add_contacts`."""
    o0 = t[0].object_start[p]
    r0 = t[0].relation_start[p]
    o = o0 + obj
    missed = float(0.0)
    for c in range(t[0].incidence_start[o], t[0].incidence_start[o + 1]):
        r = r0 + t[0].incidence[c]
        if t[0].incidence_role[c] == 0 and t[0].relation_fault[r] != 0 and t[0].relation_rigid[r] == 0:
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
                scale = t[0].row_aim[k][3]
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
                                t,
                                o0,
                                candidate,
                                base + count,
                                ids,
                                sign * ga,
                                sign * gb,
                                sign * gc,
                                want,
                                1073741824 + 2 * k + side,
                                s,
                                shift,
                                rows,
                                keys,
                            )
                            count += one
                        if one > 0:
                            missed += wp.max(-clear, 0.0)
    return count, missed


@wp.kernel
def linearise(
    # Problem:
    t: TablesRef,
    m: Margins,
    reach: wp.float32,
    problem: wp.array(dtype=wp.int32),
    selected: wp.array(dtype=wp.int32),
    # State in:
    live: wp.array(dtype=wp.int32),
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    keys: wp.array2d(dtype=wp.int32),
    force: wp.array2d(dtype=wp.float32),
    # State in and out:
    count: wp.array2d(dtype=wp.int32),
    # State out:
    rows_out: wp.array2d(dtype=Inequality),
    keys_out: wp.array2d(dtype=wp.int32),
    force_out: wp.array2d(dtype=wp.float32),
    missed_out: wp.array2d(dtype=wp.float32),
):
    """Rows of every selected (candidate, object) at the present poses, with the forces that they had before.

    ``shift`` [candidate, object] is how far each root is from its anchor; slots of an object's rows begin at
    ROWS times its index. ``missed_out`` is by how much [m] its terms miss the verdict's limits, without those that
    nothing free to move can mend.
    """
    slot, obj = wp.tid()
    candidate = selected[slot]
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
