"""Energy of a candidate and its gradient: collisions, bounds, zones, openings and relations in one gather.

One thread per (candidate, object) adds up every term that its object takes part in, so nothing is written twice and
no atomics are needed. Each penalty is C1 in the length that it is a penalty of: quadratic up to a knee, then linear
(Huber), on the clearance that is missing to a small safety margin, so that the optimum is strictly feasible. That
length itself has kinks where the witness changes, and jumps where a body leaves a pocket by a face that is no way out.
"""

import warp as wp

from .array_access import item, item_strided
from .cells import cell_at, crowded
from .features import TURN, feature, plain_feature
from .geometry import FAR, box_separation, lowest_vertex, perp, plane_of, prisms_apart, turn, turn_back, wrap
from .tables import (
    BOXES,
    DISTANCES,
    FIXTURE_SOLID,
    FORMULAS,
    FREE_Z,
    PAIR_COLLIDE,
    PAIR_POLYGON,
    PAIR_RIGID,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    POLYGONS,
    RELATIONS,
    ROOM,
    SOLIDS,
    ZONES,
    Margins,
    Share,
    State,
    TablesRef,
    View,
    Weights,
    parts_of,
)

wp.set_module_options({"enable_backward": False})

ORIGIN = wp.constant(wp.vec2(0.0, 0.0))
EAST = wp.constant(wp.vec2(1.0, 0.0))
FIXTURE = wp.constant(32)  # beside the flags of pairs: a meeting with a fixture


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
def overlap_in_z(za: wp.float32, a: wp.vec2, zb: wp.float32, b: wp.vec2, least: wp.float32):
    """True when two z intervals overlap by more than the least: z decides whether, never how."""
    return wp.min(za + a[1], zb + b[1]) - wp.max(za + a[0], zb + b[0]) > least


@wp.func
def viewed_pose(s: State, candidate: wp.int32, i: wp.int32, view: View):
    """Pose and (cos, sin) of the yaw of object i where a view sees it."""
    pose = item_strided(s.poses, candidate, i)
    q = item_strided(s.turns, candidate, i)
    if view.stamp != 0:
        mark = item(s.mark, candidate, i)
        if wp.abs(mark) == view.stamp:
            rise = float(0.0)
            if mark < 0:
                rise = view.after[2] - view.before[2]
                if view.draft == 1:
                    pose = item(s.draft, candidate, i)
                    q = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
            at = plane_of(view.after) + turn(view.spin, plane_of(pose) - plane_of(view.before))
            pose = wp.vec4(at[0], at[1], pose[2] + rise, pose[3] + view.after[3] - view.before[3])
            q = turn(view.spin, q)
    return pose, q


@wp.func
def clearance(
    t: TablesRef,
    first: wp.vec2i,
    pose_a: wp.vec4,
    qa: wp.vec2,
    second: wp.vec2i,
    pose_b: wp.vec4,
    qb: wp.vec2,
    aim: wp.float32,
    least: wp.float32,
    knee: wp.float32,
    without: wp.int32,
):
    """Penalty of two ranges of prisms for being closer than aim, with the gradient for the first's pose."""
    pa = plane_of(pose_a)
    pb = plane_of(pose_b)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for a in range(first[0], first[1]):
        za = item(t[0].prism_z, a)
        box_a = item(t[0].prism_box, a)
        for b in range(second[0], second[1]):
            zb = item(t[0].prism_z, b)
            box_b = item(t[0].prism_box, b)
            if overlap_in_z(pose_a[2], za, pose_b[2], zb, least):
                s = float(0.0)
                n = EAST
                x = pa
                if (without & POLYGONS) != 0:
                    s, n, x = box_separation(box_a, pa, qa, box_b, pb, qb, aim)
                else:
                    s, n, x = prisms_apart(t, a, box_a, pa, qa, b, box_b, pb, qb, aim)
                de, dv = penalty(aim - s, knee)
                e += de
                g += dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(x - pa)))
    return e, g


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __ffs(bits) - 1;
#else
    int first = 0;
    while (!((bits >> first) & 1)) first++;
    return first;
#endif
""")
def first_bit(bits: wp.int32) -> wp.int32:
    """The number of the lowest bit that is set."""
    ...


@wp.func
def contact_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    a: wp.int32,
    pose_a: wp.vec4,
    qa: wp.vec2,
    flags: wp.int32,
    b: wp.int32,
    pose_b: wp.vec4,
    qb: wp.vec2,
    without: wp.int32,
):
    """Penalties of object a (global index) where it meets object b (global) or fixture b, with the gradient for a.

    ``flags`` are those of the pair, or ``FIXTURE``.
    """
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    left = flags & (PAIR_COLLIDE | PAIR_ZONE_OF_FIRST | PAIR_ZONE_OF_SECOND | FIXTURE)
    while left != 0:
        flag = left & -left
        left = left - flag
        # solids against solids, a's zones against b's solids, a's solids against b's zones or against a fixture
        first = parts_of(t, a, wp.where(flag == PAIR_ZONE_OF_FIRST, ZONES, SOLIDS))
        second = wp.vec2i(0, 0)
        aim = m.zone_aim
        weight = w.zone
        if flag == FIXTURE:
            prism = item(t[0].fixture, b)
            second = wp.vec2i(prism, prism + 1)
            weight = w.opening
            if item(t[0].fixture_kind, b) == FIXTURE_SOLID:
                aim = m.bounds_aim
                weight = w.bounds
        else:
            second = parts_of(t, b, wp.where(flag == PAIR_ZONE_OF_SECOND, ZONES, SOLIDS))
            if flag == PAIR_COLLIDE:
                aim = m.collision_aim
                weight = w.collision
        ek, gk = clearance(t, first, pose_a, qa, second, pose_b, qb, aim, m.least_overlap_z, w.knee, without)
        e += weight * ek
        g += weight * gk
    return e, g


@wp.func
def bounds_energy(
    t: TablesRef, m: Margins, w: Weights, p: wp.int32, o: wp.int32, pose: wp.vec4, q: wp.vec2, part: Share
):
    """Bounds: penalty of object o (global index) against the walls, floor and ceiling, with gradient."""
    at = plane_of(pose)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    reach = item(t[0].object_radius, o)[0]
    for k in range(item(t[0].plane_start, p) + part.first, item(t[0].plane_start, p + 1), part.of):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        depth = wp.dot(n, at) - plane[2]
        if depth - reach < m.bounds_aim:
            low = lowest_vertex(t, o, turn_back(q, n))
            de, dv = penalty(m.bounds_aim - depth - low[2], w.knee)
            e += w.bounds * de
            g -= w.bounds * dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(turn(q, wp.vec2(low[0], low[1])))))
    if part.first == 0 and item(t[0].object_free, o) & FREE_Z:
        z = item(t[0].object_z, o)
        off, slope = outside(pose[2], wp.vec2(m.bounds_aim - z[0], item(t[0].room_height, p) - z[1] - m.bounds_aim))
        dz, dzv = penalty(off, w.knee)
        e += w.bounds * dz
        g += wp.vec4(0.0, 0.0, w.bounds * dzv * slope, 0.0)
    return e, g


@wp.struct
class RelationPoses:
    """The objects of a relation: global indices of the first two and the poses of all three."""

    a: wp.int32
    b: wp.int32
    pose_a: wp.vec4
    qa: wp.vec2
    pose_b: wp.vec4
    qb: wp.vec2
    pose_c: wp.vec4


@wp.func
def relation_poses(t: TablesRef, o0: wp.int32, r: wp.int32, s: State, candidate: wp.int32, view: View):
    """The objects of relation r (global) where a view sees them."""
    ids = item(t[0].relation_object, r)
    x = RelationPoses()
    x.a = o0 + ids[0]
    x.b = -1
    x.qb = EAST
    pose, q = viewed_pose(s, candidate, ids[0], view)
    x.pose_a = pose
    x.qa = q
    if ids[1] >= 0:
        x.b = o0 + ids[1]
        pose_b, qb = viewed_pose(s, candidate, ids[1], view)
        x.pose_b = pose_b
        x.qb = qb
    if ids[2] >= 0:
        pose_c, _qc = viewed_pose(s, candidate, ids[2], view)
        x.pose_c = pose_c
    return x


@wp.func
def option_energy(
    t: TablesRef,
    option: wp.int32,
    role: wp.int32,
    x: RelationPoses,
    knee: wp.float32,
    limit: wp.float32,
    without: wp.int32,
):
    """Penalty of one option's rows, with the gradient for the object in the given role; stops above the limit."""
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
        if e >= limit:
            break
        value = float(0.0)
        slope = wp.vec4(0.0, 0.0, 0.0, 0.0)
        if (without & RELATIONS) != 0:
            value, slope = plain_feature(t, row, role, x.a, x.b, x.pose_a, x.qa, x.pose_b, x.qb, without)
        else:
            value, slope = feature(t, row, role, x.a, x.b, x.pose_a, x.qa, x.pose_b, x.qb, x.pose_c)
        aim = item(t[0].row_aim, row)
        off, sign = outside(value, wp.vec2(aim[0], aim[1]))
        de, dv = penalty(off * aim[3], knee)
        e += de
        g += dv * sign * aim[3] * slope
    return e, g


@wp.func
def best_of(
    t: TablesRef,
    first: wp.int32,
    last: wp.int32,
    role: wp.int32,
    x: RelationPoses,
    knee: wp.float32,
    without: wp.int32,
):
    """Of the options first:last the one with the lowest penalty, that penalty and its gradient."""
    best = int(first)
    low = float(FAR)
    low_g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for option in range(first, last):
        e, g = option_energy(t, option, role, x, knee, low, without)
        if e < low:
            low = e
            low_g = g
            best = option
        if low <= 0.0:
            break
    return best, low, low_g


@wp.func
def best_option(t: TablesRef, r: wp.int32, role: wp.int32, x: RelationPoses, knee: wp.float32):
    """The option of relation r (global) with the lowest penalty, that penalty and its gradient."""
    best, low, g = best_of(t, item(t[0].option_start, r), item(t[0].option_start, r + 1), role, x, knee, 0)
    return best, low, g


@wp.func
def relation_energy(
    t: TablesRef,
    w: Weights,
    o0: wp.int32,
    r: wp.int32,
    rel: wp.int32,
    role: wp.int32,
    s: State,
    candidate: wp.int32,
    view: View,
):
    """Penalty of relation r (global; rel: local), with the gradient for the object in the given role."""
    x = relation_poses(t, o0, r, s, candidate, view)
    first = item(t[0].option_start, r)
    last = item(t[0].option_start, r + 1)
    if view.best == 0:
        first = item_strided(s.options, candidate, rel)
        last = first + 1
    _best, low, low_g = best_of(t, first, last, role, x, w.knee, view.without)
    weight = w.relation * item(t[0].relation_weight, r)
    return weight * low, weight * low_g


@wp.func
def near(
    t: TablesRef,
    m: Margins,
    o0: wp.int32,
    row: wp.int32,
    o: wp.int32,
    at: wp.vec2,
    heights: wp.vec2,
    j: wp.int32,
    candidate: wp.int32,
    s: State,
    view: View,
):
    """True when object o (global) at a place and between two heights may have a pair term with object j (local)."""
    flags = int(item(t[0].pair_flags, row + j))
    kind = wp.where((flags & PAIR_POLYGON) != 0, POLYGONS, BOXES)
    if (view.without & BOXES) != 0 and kind == BOXES:
        return False
    # all that is needed is read at once, so that it is waited for once
    other = item_strided(s.poses, candidate, j)
    ri = item(t[0].object_radius, o)
    rj = item(t[0].object_radius, o0 + j)
    v = plane_of(other) - at
    # a zone only meets solids
    far = wp.max(ri[0] + rj[1], ri[1] + rj[0]) + m.collision_aim
    if flags == 0 or (flags & PAIR_RIGID) != 0 or (view.without & kind) != 0 or wp.dot(v, v) >= far * far:
        return False
    if view.stamp != 0 and wp.abs(item(s.mark, candidate, j)) == view.stamp:
        return False
    return (flags & ~PAIR_POLYGON) != PAIR_COLLIDE or overlap_in_z(
        0.0, heights, other[2], item(t[0].object_z, o0 + j), m.least_overlap_z
    )


@wp.func
def may_meet_fixture(t: TablesRef, m: Margins, o: wp.int32, at: wp.vec2, k: wp.int32, view: View):
    """True when object o (global) at a place may touch fixture k (global), and may not."""
    prism = item(t[0].fixture, k)
    disc = item(t[0].prism_disc, prism)
    if (view.without & (BOXES | POLYGONS)) != 0:
        box = item(t[0].prism_box, prism)
        boxes = item(t[0].object_boxes, o) == 1 and box[2] > 0.0 and box[3] > 0.0
        if (view.without & wp.where(boxes, BOXES, POLYGONS)) != 0:
            return False
    to = wp.vec2(disc[0], disc[1]) - at
    far = disc[2] + item(t[0].object_radius, o)[0] + m.bounds_aim
    solid = item(t[0].fixture_kind, k) == FIXTURE_SOLID
    return wp.dot(to, to) < far * far and (solid or item(t[0].object_clear, o) == 1)


@wp.func
def own_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    pose: wp.vec4,
    q: wp.vec2,
    s: State,
    view: View,
    part: Share,
):
    """`object_energy` without what is near the object: bounds, the pull and relations."""
    o0 = item(t[0].object_start, p)
    o = o0 + obj
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if (view.without & ROOM) == 0:
        e, g = bounds_energy(t, m, w, p, o, pose, q, part)
    soft = float(0.0)
    if w.pull > 0.0 and part.first == 0 and (view.without & ROOM) == 0:
        d = pose - item_strided(s.anchors, candidate, obj)
        d[3] = wrap(d[3], TURN)
        soft += 0.5 * w.pull * wp.dot(d, d)
        e += soft
        g += w.pull * d
    share = e
    r0 = item(t[0].relation_start, p)
    for k in range(item(t[0].incidence_start, o) + part.first, item(t[0].incidence_start, o + 1), part.of):
        r = item(t[0].incidence, k)
        wanted = item(t[0].relation_rigid, r0 + r) == 0
        if (view.without & (FORMULAS | DISTANCES | RELATIONS)) != 0:
            wanted = wanted and (view.without & item(t[0].relation_kind, r0 + r)) == 0
        if wanted:
            role = item(t[0].incidence_role, k)
            er, gr = relation_energy(t, w, o0, r0 + r, r, role, s, candidate, view)
            e += er
            g += gr
            if role == 0:
                share += er
                if item(t[0].relation_fault, r0 + r) == 0:
                    soft += er
    return e, share, soft, g


@wp.func
def add_contact_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    pose: wp.vec4,
    q: wp.vec2,
    s: State,
    limit: wp.float32,
    view: View,
    part: Share,
    e: wp.float32,
    share: wp.float32,
    g: wp.vec4,
):
    """Energy, share and gradient of an object with those of what is near it: other objects and fixtures."""
    e = float(e)
    share = float(share)
    o0 = item(t[0].object_start, p)
    n = item(t[0].object_start, p + 1) - o0
    o = o0 + obj
    at = plane_of(pose)
    row = item(t[0].pair_start, p) + obj * n
    z = item(t[0].object_z, o)
    heights = wp.vec2(pose[2] + z[0], pose[2] + z[1])
    cells = view.crowd != 0 and crowded(n, s)
    reach = item(t[0].object_radius, o)[1] + item(t[0].grid, p)[3] + m.collision_aim
    left, low = cell_at(t, p, at[0] - reach, at[1] - reach)
    right, high = cell_at(t, p, at[0] + reach, at[1] + reach)
    x = int(left)
    y = int(low)
    head = int(-1)
    turn_of = int(0)  # cells deal out what they hold one by one
    # what is gone through: the fixtures, then the objects one after the other, unless cells hold them
    f0 = item(t[0].fixture_start, p)
    fixtures = item(t[0].fixture_start, p + 1) - f0
    listed = fixtures + n
    if cells:
        listed = fixtures
        head = item(s.cell_head, candidate, y * item(t[0].grid_count, p)[0] + x)
    j = int(part.first)
    more = bool(True)
    while more and e <= limit:
        # who is near is found first: threads that work side by side then meet at the exact tests
        bits = int(0)
        first = j - fixtures
        found = int(-1)
        bit = int(1)
        while bit != (1 << 30) and j < listed:
            close = bool(False)
            if j < fixtures:
                close = may_meet_fixture(t, m, o, at, f0 + j, view)
            else:
                close = near(t, m, o0, row, o, at, heights, j - fixtures, candidate, s, view)
            if close:
                bits = bits | bit
            bit = bit << 1
            j += part.of
        more = j < listed
        if cells and not more:
            while bits == 0 and found < 0 and y <= high:
                if head >= 0:
                    if turn_of == part.first:
                        if near(t, m, o0, row, o, at, heights, head, candidate, s, view):
                            found = head
                    turn_of += 1
                    if turn_of == part.of:
                        turn_of = 0
                    head = item(s.cell_next, candidate, head)
                while head < 0 and y <= high:
                    x += 1
                    if x > right:
                        x = int(left)
                        y += 1
                    if y <= high:
                        head = item(s.cell_head, candidate, y * item(t[0].grid_count, p)[0] + x)
            more = y <= high or found >= 0
            if found >= 0:
                bits = 1
        while bits != 0 and e <= limit:
            k = first + first_bit(bits) * part.of
            bits = bits & (bits - 1)
            if found >= 0:
                k = found
            b = f0 + fixtures + k
            flags = int(FIXTURE)
            pose_b = wp.vec4(0.0, 0.0, 0.0, 0.0)
            qb = EAST
            if k >= 0:
                b = o0 + k
                flags = int(item(t[0].pair_flags, row + k))
                pose_b = item_strided(s.poses, candidate, k)
                qb = item_strided(s.turns, candidate, k)
            em, gm = contact_energy(t, m, w, o, pose, q, flags, b, pose_b, qb, view.without)
            e += em
            share += wp.where(k >= 0, 0.5, 1.0) * em
            g += gm
    return e, share, g


@wp.func
def object_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    obj: wp.int32,
    s: State,
    limit: wp.float32,
    view: View,
    part: Share,
):
    """Everything that object ``obj`` of a candidate takes part in.

    Returns (energy, share, soft, gradient): the energy of all its terms; its share of the candidate's energy (half of
    each pair, the whole of a relation for its subject); what of the share soft relations and the pull make up; and the
    gradient of the energy for its pose (x, y, z, yaw). Once the energy exceeds the limit the rest is left out; so are
    pairs with objects that the view moves along, whose distances that does not change. A thread may take its share of
    the terms only; what the shares return adds up.
    """
    pose, q = viewed_pose(s, candidate, obj, view)
    if not wp.isfinite(pose):  # comparisons with NaN are false, so every term would pass it
        return FAR, FAR, float(0.0), wp.vec4(0.0, 0.0, 0.0, 0.0)
    e, share, soft, g = own_energy(t, m, w, p, candidate, obj, pose, q, s, view, part)
    e_all, share_all, g_all = add_contact_energy(t, m, w, p, candidate, obj, pose, q, s, limit, view, part, e, share, g)
    return e_all, share_all, soft, g_all


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
    if obj >= item(t[0].object_start, p + 1) - item(t[0].object_start, p):
        share_out[candidate, obj] = 0.0
        soft_out[candidate, obj] = 0.0
        gradient_out[candidate, obj] = wp.vec4(0.0, 0.0, 0.0, 0.0)
        return
    view = View()
    view.crowd = 1
    _e, share, soft, g = object_energy(t, m, w, p, candidate, obj, s, FAR, view, Share(0, 1))
    share_out[candidate, obj] = share
    soft_out[candidate, obj] = soft
    gradient_out[candidate, obj] = g
