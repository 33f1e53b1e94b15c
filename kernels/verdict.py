"""The engine's own verdict: conservative predicates, so that what it calls valid the judge calls valid.

Thresholds are tighter than the judge's by more than float32 loses in a room of 100 m.
"""

import warp as wp

from .array_access import item
from .energy import EAST, overlap_in_z
from .features import feature
from .geometry import plane_of, prisms_apart, turn
from .tables import (
    FIXTURE_SOLID,
    PAIR_COLLIDE,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    SOLIDS,
    ZONES,
    Margins,
    TablesRef,
    parts_of,
)

wp.set_module_options({"enable_backward": False})

VALID = wp.constant(0)
BROKEN = wp.constant(1)  # collision, bounds, support, zone or opening
UNMET = wp.constant(2)  # a hard relation is false
DIVERGED = wp.constant(3)


@wp.func(inline=False)
def apart(
    t: TablesRef,
    first: wp.vec2i,
    pose_a: wp.vec4,
    qa: wp.vec2,
    second: wp.vec2i,
    pose_b: wp.vec4,
    qb: wp.vec2,
    hold: wp.float32,
    least: wp.float32,
):
    """True when no two prisms of the ranges come closer than hold (negative: may sink in so far)."""
    pa = plane_of(pose_a)
    pb = plane_of(pose_b)
    for a in range(first[0], first[1]):
        for b in range(second[0], second[1]):
            if overlap_in_z(pose_a[2], item(t[0].prism_z, a), pose_b[2], item(t[0].prism_z, b), least):
                s, _n, _x = prisms_apart(
                    t, a, item(t[0].prism_box, a), pa, qa, b, item(t[0].prism_box, b), pb, qb, hold
                )
                if s < hold:
                    return False
    return True


@wp.func
def pair_holds(
    t: TablesRef,
    m: Margins,
    flags: wp.int32,
    a: wp.int32,
    pose_a: wp.vec4,
    qa: wp.vec2,
    b: wp.int32,
    pose_b: wp.vec4,
    qb: wp.vec2,
):
    """True when objects a and b (global indices) neither collide nor stand in each other's hard zones."""
    sa = parts_of(t, a, SOLIDS)
    sb = parts_of(t, b, SOLIDS)
    if flags & PAIR_COLLIDE:
        if not apart(t, sa, pose_a, qa, sb, pose_b, qb, m.collision_hold, m.least_overlap_z):
            return False
    if flags & PAIR_ZONE_OF_FIRST:
        if not apart(t, parts_of(t, a, ZONES), pose_a, qa, sb, pose_b, qb, m.zone_hold, m.least_overlap_z):
            return False
    if flags & PAIR_ZONE_OF_SECOND:
        if not apart(t, sa, pose_a, qa, parts_of(t, b, ZONES), pose_b, qb, m.zone_hold, m.least_overlap_z):
            return False
    return True


@wp.func(inline=False)
def room_holds(t: TablesRef, m: Margins, p: wp.int32, o: wp.int32, pose: wp.vec4, q: wp.vec2):
    """True when object o (global index) is inside the room and clear of doors and windows."""
    at = plane_of(pose)
    for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        for f in range(item(t[0].footprint_start, o), item(t[0].footprint_start, o + 1)):
            a = item(t[0].footprint, f)
            for v in range(item(t[0].prism_start, a), item(t[0].prism_start, a + 1)):
                if wp.dot(n, at + turn(q, item(t[0].vertex, v))) - plane[2] < m.bounds_hold:
                    return False
    for k in range(item(t[0].fixture_start, p), item(t[0].fixture_start, p + 1)):
        solid = item(t[0].fixture_kind, k) == FIXTURE_SOLID
        if solid or item(t[0].object_clear, o) == 1:
            hold = wp.where(solid, m.bounds_hold, m.zone_hold)
            prism = item(t[0].fixture, k)
            fixture = wp.vec2i(prism, prism + 1)
            nowhere = wp.vec4(0.0, 0.0, 0.0, 0.0)
            if not apart(t, parts_of(t, o, SOLIDS), pose, q, fixture, nowhere, EAST, hold, m.least_overlap_z):
                return False
    if pose[2] + item(t[0].object_z, o)[1] > item(t[0].room_height, p) - m.bounds_hold:
        return False
    return pose[2] + item(t[0].object_z, o)[0] >= m.bounds_hold


@wp.func(inline=False)
def option_holds(
    t: TablesRef,
    o0: wp.int32,
    ids: wp.vec3i,
    option: wp.int32,
    candidate: wp.int32,
    poses: wp.array2d(dtype=wp.vec4),
    turns: wp.array2d(dtype=wp.vec2),
):
    """True when every row of an option lies in its interval."""
    pose_b = wp.vec4(0.0, 0.0, 0.0, 0.0)
    qb = EAST
    pose_c = wp.vec4(0.0, 0.0, 0.0, 0.0)
    b = int(-1)
    if ids[1] >= 0:
        b = o0 + ids[1]
        pose_b = poses[candidate, ids[1]]
        qb = turns[candidate, ids[1]]
    if ids[2] >= 0:
        pose_c = poses[candidate, ids[2]]
    for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
        value, _g = feature(
            t, row, 0, o0 + ids[0], b, poses[candidate, ids[0]], turns[candidate, ids[0]], pose_b, qb, pose_c
        )
        hold = item(t[0].row_hold, row)
        if value < hold[0] or value > hold[1]:
            return False
    return True


@wp.kernel
def judge_objects(
    # Problem:
    t: TablesRef,
    m: Margins,
    problem: wp.array(dtype=wp.int32),
    # State in:
    active: wp.array(dtype=wp.int32),
    poses: wp.array2d(dtype=wp.vec4),
    turns: wp.array2d(dtype=wp.vec2),
    # State out:
    fault_out: wp.array2d(dtype=wp.int8),
):
    """Fault of every object of the active candidates: 0, BROKEN or DIVERGED. A pair is charged to both."""
    candidate, obj = wp.tid()
    if active[candidate] == 0:
        return
    p = problem[candidate]
    o0 = item(t[0].object_start, p)
    n = item(t[0].object_start, p + 1) - o0
    if obj >= n:
        fault_out[candidate, obj] = wp.int8(0)
        return
    pose = poses[candidate, obj]
    if not wp.isfinite(pose):
        fault_out[candidate, obj] = wp.int8(DIVERGED)
        return
    q = turns[candidate, obj]
    o = o0 + obj
    ok = room_holds(t, m, p, o, pose, q)
    radius = item(t[0].object_radius, o)
    row = item(t[0].pair_start, p) + obj * n
    for j in range(n):
        flags = int(item(t[0].pair_flags, row + j))
        if ok and flags != 0:
            other = poses[candidate, j]
            v = plane_of(other) - plane_of(pose)
            rj = item(t[0].object_radius, o0 + j)
            far = wp.max(radius[0] + rj[1], radius[1] + rj[0])
            if wp.dot(v, v) < far * far:
                ok = pair_holds(t, m, flags, o, pose, q, o0 + j, other, turns[candidate, j])
    fault_out[candidate, obj] = wp.int8(wp.where(ok, VALID, BROKEN))


@wp.kernel
def judge_relations(
    # Problem:
    t: TablesRef,
    problem: wp.array(dtype=wp.int32),
    # State in:
    active: wp.array(dtype=wp.int32),
    poses: wp.array2d(dtype=wp.vec4),
    turns: wp.array2d(dtype=wp.vec2),
    # State out:
    holds_out: wp.array2d(dtype=wp.bool),
):
    """Whether each relation of the active candidates holds under any of its options, [candidate, relation]."""
    candidate, rel = wp.tid()
    if active[candidate] == 0:
        return
    p = problem[candidate]
    r = item(t[0].relation_start, p) + rel
    if r >= item(t[0].relation_start, p + 1):
        holds_out[candidate, rel] = True
        return
    found = bool(False)
    for option in range(item(t[0].option_start, r), item(t[0].option_start, r + 1)):
        if not found:
            found = option_holds(
                t, item(t[0].object_start, p), item(t[0].relation_object, r), option, candidate, poses, turns
            )
    holds_out[candidate, rel] = found


@wp.kernel
def judge_candidates(
    # Problem:
    t: TablesRef,
    problem: wp.array(dtype=wp.int32),
    # State in:
    active: wp.array(dtype=wp.int32),
    fault: wp.array2d(dtype=wp.int8),
    holds: wp.array2d(dtype=wp.bool),
    # State out:
    status_out: wp.array(dtype=wp.int8),
):
    """Status of every active candidate: 0 valid, 1 broken, 2 a hard relation is unmet, 3 diverged."""
    candidate = wp.tid()
    if active[candidate] == 0:
        return
    p = problem[candidate]
    status = int(VALID)
    r0 = item(t[0].relation_start, p)
    for r in range(r0, item(t[0].relation_start, p + 1)):
        if not holds[candidate, r - r0]:
            kind = item(t[0].relation_fault, r)
            if kind == UNMET and status == VALID:
                status = UNMET
            if kind == BROKEN and status != DIVERGED:
                status = BROKEN
    for obj in range(item(t[0].object_start, p + 1) - item(t[0].object_start, p)):
        kind = int(fault[candidate, obj])
        if kind == DIVERGED:
            status = DIVERGED
        elif kind == BROKEN and status != DIVERGED:
            status = BROKEN
    status_out[candidate] = wp.int8(status)
