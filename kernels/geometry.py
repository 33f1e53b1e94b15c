"""Planar geometry of convex polygons: separation and distance, each with the witness that carries its gradient.

Both functions return ``(value, n, x)``. With n a unit vector from the first polygon to the second and x the witness
point (world frame), the frozen-witness gradient of the value is

    first  polygon at p: d/dp = -n,  d/dyaw = -n . perp(x - p)
    second polygon at q: d/dq =  n,  d/dyaw =  n . perp(x - q)

whichever polygon owns the face: moving the witness along n by any amount does not change n . perp(x - p) when both
contact points lie on one line along n, and a face's own rotation is first-order equal to the witness's.
"""

import warp as wp

from .array_access import item, opaque_one
from .tables import TablesRef

wp.set_module_options({"enable_backward": False})

FAR = wp.constant(1.0e6)

OUTSIDE_TOP = wp.constant(1.0e3)
"""Height [m] up to which prisms reach that stand for the outside of a room, and none else."""


@wp.func
def turn(q: wp.vec2, v: wp.vec2):
    """Rotate v by the angle whose (cos, sin) is q."""
    return wp.vec2(q[0] * v[0] - q[1] * v[1], q[1] * v[0] + q[0] * v[1])


@wp.func
def turn_back(q: wp.vec2, v: wp.vec2):
    """Rotate v by minus the angle whose (cos, sin) is q."""
    return wp.vec2(q[0] * v[0] + q[1] * v[1], q[0] * v[1] - q[1] * v[0])


@wp.func
def perp(v: wp.vec2):
    """v turned by a quarter: the derivative of a rotating vector."""
    return wp.vec2(-v[1], v[0])


@wp.func
def plane_of(pose: wp.vec4):
    """The planar position of a pose (x, y, z, yaw)."""
    return wp.vec2(pose[0], pose[1])


@wp.func
def wrap(angle: wp.float32, period: wp.float32):
    """The angle moved by whole periods into [-period / 2, period / 2]."""
    return angle - period * wp.round(angle / period)


@wp.func
def overlap_in_z(za: wp.float32, a: wp.vec2, zb: wp.float32, b: wp.vec2, least: wp.float32):
    """True when two z intervals overlap by more than the least: z decides whether, never how.

    What is outside of the room is so at all heights, and a body however thin (a rug) has to stay out of it.
    """
    shared = wp.min(za + a[1], zb + b[1]) - wp.max(za + a[0], zb + b[0])
    return shared > least or a[1] >= OUTSIDE_TOP or b[1] >= OUTSIDE_TOP


@wp.struct
class Prism:
    """A prism of the tables somewhere in the room."""

    index: wp.int32
    box: wp.vec4  # as in ``Tables.prism_box``
    at: wp.vec2
    turn: wp.vec2  # (cos, sin) of the yaw


@wp.func
def prism_at(t: TablesRef, prism: wp.int32, at: wp.vec2, q: wp.vec2):
    """A prism (global index) whose body's origin is at a point and turned by q."""
    return Prism(prism, item(t[0].prism_box, prism), at, q)


@wp.func
def discs_apart(t: TablesRef, a: Prism, b: Prism, margin: wp.float32):
    """True when the bounding circles of two prisms are further apart than the margin."""
    da = item(t[0].prism_disc, a.index)
    db = item(t[0].prism_disc, b.index)
    v = b.at + turn(b.turn, wp.vec2(db[0], db[1])) - a.at - turn(a.turn, wp.vec2(da[0], da[1]))
    reach = da[2] + db[2] + margin
    return wp.dot(v, v) > reach * reach


@wp.func
def sign_of(x: wp.float32):
    """1 or -1, never 0."""
    return wp.where(x < 0.0, -1.0, 1.0)


@wp.func
def deepest(box: wp.vec4, m: wp.vec2):
    """The vertex of a box (``Tables.prism_box``) that lies furthest against the direction m, both in its frame."""
    return wp.vec2(box[0] - sign_of(m[0]) * box[2], box[1] - sign_of(m[1]) * box[3])


@wp.func(inline=False)
def lowest_of_polygon(t: TablesRef, a: wp.int32, m: wp.vec2):
    """The vertex of prism a that lies furthest against the direction m, and how far along m it lies: (x, y, m)."""
    low = wp.vec3(0.0, 0.0, FAR)
    for k in range(item(t[0].prism_start, a), item(t[0].prism_start, a + 1), opaque_one()):
        v = item(t[0].vertex, k)
        d = wp.dot(m, v)
        if d < low[2]:
            low = wp.vec3(v[0], v[1], d)
    return low


@wp.func
def lowest_vertex(t: TablesRef, o: wp.int32, m: wp.vec2):
    """`lowest_of_polygon` over the whole footprint of object o; direction and vertex are in its frame."""
    low = wp.vec3(0.0, 0.0, FAR)
    for f in range(item(t[0].footprint_start, o), item(t[0].footprint_start, o + 1), opaque_one()):
        a = item(t[0].footprint, f)
        box = item(t[0].prism_box, a)
        v = deepest(box, m)
        here = wp.vec3(v[0], v[1], wp.dot(m, v))
        if box[2] < 0.0:
            here = lowest_of_polygon(t, a, m)
        if here[2] < low[2]:
            low = here
    return low


@wp.func
def box_separation(a: Prism, b: Prism, margin: wp.float32):
    """`separation` of two boxes (``Tables.prism_box``), without loops; for what they bound, a least value."""
    d = b.at - a.at + turn(b.turn, wp.vec2(b.box[0], b.box[1])) - turn(a.turn, wp.vec2(a.box[0], a.box[1]))
    u = turn_back(a.turn, d)
    v = turn_back(b.turn, d)
    ha = wp.vec2(wp.abs(a.box[2]), wp.abs(a.box[3]))
    hb = wp.vec2(wp.abs(b.box[2]), wp.abs(b.box[3]))
    c = wp.abs(wp.dot(a.turn, b.turn))
    s = wp.abs(a.turn[0] * b.turn[1] - a.turn[1] * b.turn[0])
    a0 = wp.abs(u[0]) - ha[0] - c * hb[0] - s * hb[1]
    a1 = wp.abs(u[1]) - ha[1] - s * hb[0] - c * hb[1]
    b0 = wp.abs(v[0]) - hb[0] - c * ha[0] - s * ha[1]
    b1 = wp.abs(v[1]) - hb[1] - s * ha[0] - c * ha[1]
    best = wp.max(wp.max(a0, a1), wp.max(b0, b1))
    n = wp.vec2(1.0, 0.0)
    x = a.at
    if best <= margin:
        if wp.max(a0, a1) >= wp.max(b0, b1):
            n = sign_of(u[0]) * a.turn
            if a1 > a0:
                n = sign_of(u[1]) * perp(a.turn)
            x = b.at + turn(b.turn, deepest(b.box, turn_back(b.turn, n)))
        else:
            n = sign_of(v[0]) * b.turn
            if b1 > b0:
                n = sign_of(v[1]) * perp(b.turn)
            x = a.at + turn(a.turn, deepest(a.box, -turn_back(a.turn, n)))
    return best, n, x


@wp.func
def way_out(t: TablesRef, face: wp.int32, first: wp.int32, last: wp.int32, rest: wp.int32):
    """True when a body may leave through a face, coming to rest on a vertex of the polygon with vertices first:last.

    Faces inside the outside of a room are no way out, neither as the face itself nor on either side of the vertex.
    """
    before = rest - 1
    if rest == first:
        before = last - 1
    return item(t[0].edge_real, face) == 1 and item(t[0].edge_real, rest) == 1 and item(t[0].edge_real, before) == 1


@wp.struct
class PartingFace:
    """The face of one of two convex polygons a and b that parts them best, and the other's vertex nearest to it."""

    clearance: wp.float32  # [m], negative is depth
    face: wp.int32  # -1: they are known to be apart, whatever the best face is
    of_first: wp.bool  # the face is a's
    vertex: wp.int32


@wp.func(inline=False)
def parting_face(t: TablesRef, a: Prism, b: Prism, margin: wp.float32):
    """The separating axis of two convex polygons among the face normals of both.

    Stops at the first axis that parts them by more than the margin (the clearance is then just some number above it).
    Axes that are no way out (`way_out`) part the polygons, but a body inside is never pushed along them.
    """
    best = PartingFace()
    best.clearance = -FAR
    best.face = -1
    shut = PartingFace()
    shut.clearance = -FAR
    shut.face = -1
    a0 = item(t[0].prism_start, a.index)
    a1 = item(t[0].prism_start, a.index + 1)
    b0 = item(t[0].prism_start, b.index)
    b1 = item(t[0].prism_start, b.index + 1)
    ab = b.at - a.at
    for k in range(a0, a1 + b1 - b0):
        # a's faces against b's vertices, then b's faces against a's
        here = PartingFace()
        here.of_first = k < a1
        here.face = k
        v0 = b0
        v1 = b1
        q = a.turn
        other = b.turn
        towards = ab
        if k >= a1:
            here.face = b0 + k - a1
            v0 = a0
            v1 = a1
            q = b.turn
            other = a.turn
            towards = -ab
        plane = item(t[0].edge, here.face)
        n = turn(q, wp.vec2(plane[0], plane[1]))
        m = turn_back(other, n)
        low = float(FAR)
        rest = int(v0)
        for v in range(v0, v1):
            d = wp.dot(m, item(t[0].vertex, v))
            if d < low:
                low = d
                rest = v
        here.vertex = rest
        here.clearance = low + wp.dot(n, towards) - plane[2]
        if here.clearance > margin:
            here.face = -1
            return here
        if here.clearance > wp.min(best.clearance, shut.clearance):
            if way_out(t, here.face, v0, v1, rest):
                if here.clearance > best.clearance:
                    best = here
            else:
                if here.clearance > 0.0:
                    here.clearance = FAR
                    here.face = -1
                    return here
                if here.clearance > shut.clearance:
                    shut = here
    if best.clearance == -FAR:
        return shut
    return best


@wp.func(inline=False)
def separation(t: TablesRef, a: Prism, b: Prism, margin: wp.float32):
    """Separating-axis distance of two convex polygons; negative is depth. Stops as `parting_face` does."""
    found = parting_face(t, a, b, margin)
    n = wp.vec2(1.0, 0.0)
    x = a.at
    if found.face >= 0:
        plane = item(t[0].edge, found.face)
        rest = item(t[0].vertex, found.vertex)
        if found.of_first:
            n = turn(a.turn, wp.vec2(plane[0], plane[1]))
            x = b.at + turn(b.turn, rest)
        else:
            n = -turn(b.turn, wp.vec2(plane[0], plane[1]))
            x = a.at + turn(a.turn, rest)
    return found.clearance, n, x


@wp.func
def box_face(t: TablesRef, box: wp.vec4, at: wp.vec2, spin: wp.vec2, other: wp.int32):
    """The face of a box that parts it best from a polygon, its normal and its distance, all in the box's frame.

    ``at`` and ``spin`` are the place and the (cos, sin) of the polygon there.
    """
    low = wp.vec2(FAR, FAR)
    high = wp.vec2(-FAR, -FAR)
    for v in range(item(t[0].prism_start, other), item(t[0].prism_start, other + 1), opaque_one()):
        x = turn(spin, item(t[0].vertex, v))
        low = wp.min(low, x)
        high = wp.max(high, x)
    low = low + at - wp.vec2(box[0] + box[2], box[1] + box[3])
    high = wp.vec2(box[0] - box[2], box[1] - box[3]) - high - at
    s = low[0]
    n = wp.vec2(1.0, 0.0)
    if high[0] > s:
        s = high[0]
        n = wp.vec2(-1.0, 0.0)
    if low[1] > s:
        s = low[1]
        n = wp.vec2(0.0, 1.0)
    if high[1] > s:
        s = high[1]
        n = wp.vec2(0.0, -1.0)
    return s, n


@wp.func(inline=False)
def convex_separation(t: TablesRef, a: Prism, b: Prism, margin: wp.float32):
    """`separation` where every face is a way out."""
    best = float(-FAR)
    best_n = wp.vec2(1.0, 0.0)  # in the frame of the face's owner
    owner = int(0)
    step = opaque_one()
    for which in range(0, 2, step):
        mine = wp.where(which == 0, a, b)
        other = wp.where(which == 0, b, a)
        q = mine.turn
        towards = turn_back(q, other.at - mine.at)
        spin = wp.vec2(wp.dot(q, other.turn), q[0] * other.turn[1] - q[1] * other.turn[0])
        face = item(t[0].prism_start, mine.index)
        last = item(t[0].prism_start, mine.index + 1)
        if mine.box[2] > 0.0:  # its faces all at once
            s, n = box_face(t, mine.box, towards, spin, other.index)
            if s > best:
                best = s
                best_n = n
                owner = which
            face = last
        while face < last and best <= margin:
            plane = item(t[0].edge, face)
            n = wp.vec2(plane[0], plane[1])
            m = turn_back(spin, n)
            low = wp.dot(m, deepest(other.box, m))
            if other.box[2] < 0.0:
                low = FAR
                for v in range(item(t[0].prism_start, other.index), item(t[0].prism_start, other.index + 1), step):
                    low = wp.min(low, wp.dot(m, item(t[0].vertex, v)))
            s = low + wp.dot(n, towards) - plane[2]
            if s > best:
                best = s
                best_n = n
                owner = which
            face += 1
        if best > margin:
            return best, best_n, a.at
    # the witness: the vertex of the other prism that is nearest to the face
    n = turn(wp.where(owner == 0, a.turn, b.turn), best_n)
    other = wp.where(owner == 0, b, a)
    m = turn_back(other.turn, n)
    x = deepest(other.box, m)
    if other.box[2] < 0.0:
        rest = lowest_of_polygon(t, other.index, m)
        x = wp.vec2(rest[0], rest[1])
    if owner != 0:
        n = -n
    return best, n, other.at + turn(other.turn, x)


@wp.func
def prisms_apart(t: TablesRef, a: Prism, b: Prism, margin: wp.float32):
    """`separation` the quick way: boxes without loops, others only where their bounding boxes meet."""
    s, n, x = box_separation(a, b, margin)
    if s <= margin and (a.box[3] < 0.0 or b.box[3] < 0.0):
        s, n, x = separation(t, a, b, margin)
    elif s <= margin and (a.box[2] < 0.0 or b.box[2] < 0.0):
        s, n, x = convex_separation(t, a, b, margin)
    return s, n, x


@wp.func(inline=False)
def closest_to_edges(t: TablesRef, a: Prism, b: Prism):
    """Smallest distance of b's vertices to a, outside of it: (distance, vector from a to b, witness point)."""
    best = float(FAR)
    best_v = wp.vec2(1.0, 0.0)
    best_x = a.at
    a0 = item(t[0].prism_start, a.index)
    a1 = item(t[0].prism_start, a.index + 1)
    step = opaque_one()
    box = a.box
    for v in range(item(t[0].prism_start, b.index), item(t[0].prism_start, b.index + 1), step):
        x = turn_back(a.turn, b.at + turn(b.turn, item(t[0].vertex, v)) - a.at)
        if box[2] > 0.0:
            r = x - wp.vec2(box[0], box[1])
            r = r - wp.vec2(wp.clamp(r[0], -box[2], box[2]), wp.clamp(r[1], -box[3], box[3]))
            if wp.dot(r, r) < best:
                best = wp.dot(r, r)
                best_v = r
                best_x = x
            a1 = a0  # its edges need no look
        for e in range(a0, a1, step):
            p = item(t[0].vertex, e)
            f = e + 1
            if f == a1:
                f = a0
            s = item(t[0].vertex, f) - p
            u = wp.clamp(wp.dot(x - p, s) / wp.max(wp.dot(s, s), 1.0e-12), 0.0, 1.0)
            w = x - p - u * s
            d = wp.dot(w, w)
            if d < best:
                best = d
                best_v = w
                best_x = x
    return wp.sqrt(best + 1.0e-14), turn(a.turn, best_v), a.at + turn(a.turn, best_x)


@wp.func
def box_distance(a: Prism, b: Prism):
    """`distance` of two boxes (``Tables.prism_box``): from a corner of one to the other, unless they overlap."""
    s, n, x = box_separation(a, b, FAR)
    if s > 0.0:
        ca = a.at + turn(a.turn, wp.vec2(a.box[0], a.box[1]))
        cb = b.at + turn(b.turn, wp.vec2(b.box[0], b.box[1]))
        ha = wp.vec2(a.box[2], a.box[3])
        hb = wp.vec2(b.box[2], b.box[3])
        u = turn_back(a.turn, cb - ca)  # b's centre as a sees it, and a's as b does
        v = turn_back(b.turn, ca - cb)
        spin = wp.vec2(wp.dot(a.turn, b.turn), a.turn[0] * b.turn[1] - a.turn[1] * b.turn[0])  # b's axes as a sees them
        best = float(FAR)
        corner = wp.vec2(0.0, 0.0)
        mine = bool(True)
        for k in range(4):
            sign = wp.vec2(wp.where((k & 1) == 0, 1.0, -1.0), wp.where((k & 2) == 0, 1.0, -1.0))
            of_b = u + turn(spin, wp.cw_mul(sign, hb))
            of_a = v + turn_back(spin, wp.cw_mul(sign, ha))
            gap_b = of_b - wp.vec2(wp.clamp(of_b[0], -ha[0], ha[0]), wp.clamp(of_b[1], -ha[1], ha[1]))
            gap_a = of_a - wp.vec2(wp.clamp(of_a[0], -hb[0], hb[0]), wp.clamp(of_a[1], -hb[1], hb[1]))
            if wp.dot(gap_b, gap_b) < best:
                best = wp.dot(gap_b, gap_b)
                corner = of_b
                mine = True
            if wp.dot(gap_a, gap_a) < best:
                best = wp.dot(gap_a, gap_a)
                corner = of_a
                mine = False
        s = wp.sqrt(best + 1.0e-14)
        if mine:
            gap = corner - wp.vec2(wp.clamp(corner[0], -ha[0], ha[0]), wp.clamp(corner[1], -ha[1], ha[1]))
            n = turn(a.turn, gap) / s
            x = ca + turn(a.turn, corner)
        else:
            gap = corner - wp.vec2(wp.clamp(corner[0], -hb[0], hb[0]), wp.clamp(corner[1], -hb[1], hb[1]))
            n = -turn(b.turn, gap) / s
            x = cb + turn(b.turn, corner)
    return s, n, x


@wp.func
def distance(t: TablesRef, a: Prism, b: Prism):
    """Euclidean distance of two convex polygons; where they overlap, minus their separating-axis depth.

    Polygon b may be a single vertex.
    """
    if a.box[2] > 0.0 and b.box[2] > 0.0:
        s_box, n_box, x_box = box_distance(a, b)
        return s_box, n_box, x_box
    s, n, x = convex_separation(t, a, b, FAR)
    if s > 0.0:
        d0, v0, x0 = closest_to_edges(t, a, b)
        s = d0
        n = v0 / d0
        x = x0
        if item(t[0].prism_start, b.index + 1) - item(t[0].prism_start, b.index) > 1:
            d1, v1, x1 = closest_to_edges(t, b, a)
            if d1 < d0:
                s = d1
                n = -v1 / d1
                x = x1
    return s, n, x
