"""Planar geometry of convex polygons: separation and distance, each with the witness that carries its gradient.

Both functions return ``(value, n, x)``. With n a unit vector from the first polygon to the second and x the witness
point (world frame), the frozen-witness gradient of the value is

    first  polygon at p: d/dp = -n,  d/dyaw = -n . perp(x - p)
    second polygon at q: d/dq =  n,  d/dyaw =  n . perp(x - q)

whichever polygon owns the face: moving the witness along n by any amount does not change n . perp(x - p) when both
contact points lie on one line along n, and a face's own rotation is first-order equal to the witness's.
"""

import warp as wp

from .tables import TablesRef

wp.set_module_options({"enable_backward": False})

FAR = wp.constant(1.0e6)


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
def discs_apart(
    t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2, margin: wp.float32
):
    """True when the bounding circles of prisms a and b are further apart than the margin."""
    da = t[0].prism_disc[a]
    db = t[0].prism_disc[b]
    v = pb + turn(qb, wp.vec2(db[0], db[1])) - pa - turn(qa, wp.vec2(da[0], da[1]))
    reach = da[2] + db[2] + margin
    return wp.dot(v, v) > reach * reach


@wp.func
def way_out(t: TablesRef, face: wp.int32, first: wp.int32, last: wp.int32, rest: wp.int32):
    """True when a body may leave through a face, coming to rest on a vertex of the polygon with vertices first:last.

    Faces inside the outside of a room are no way out, neither as the face itself nor on either side of the vertex.
    """
    before = rest - 1
    if rest == first:
        before = last - 1
    return t[0].edge_real[face] == 1 and t[0].edge_real[rest] == 1 and t[0].edge_real[before] == 1


@wp.func(inline=False)
def separation(
    t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2, margin: wp.float32
):
    """Separating-axis distance of two convex polygons over the face normals of both; negative is depth.

    Stops at the first axis that parts them by more than the margin (the value is then just some number above it).
    Axes that are no way out (`way_out`) part the polygons, but a body inside is never pushed along them.
    """
    best = float(-FAR)
    best_n = wp.vec2(1.0, 0.0)
    best_x = pa
    shut = float(-FAR)
    shut_n = wp.vec2(1.0, 0.0)
    shut_x = pa
    a0 = t[0].prism_start[a]
    a1 = t[0].prism_start[a + 1]
    b0 = t[0].prism_start[b]
    b1 = t[0].prism_start[b + 1]
    ab = pb - pa
    for k in range(a0, a1 + b1 - b0):
        # a's faces against b's vertices, then b's faces against a's
        mine = k < a1
        face = k
        v0 = b0
        v1 = b1
        q = qa
        other = qb
        towards = ab
        if not mine:
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
        s = low + wp.dot(n, towards) - plane[2]
        if s > margin:
            return s, n, pa
        if s > wp.min(best, shut):
            x = pb + turn(qb, t[0].vertex[rest])
            out = n
            if not mine:
                x = pa + turn(qa, t[0].vertex[rest])
                out = -n
            if way_out(t, face, v0, v1, rest):
                if s > best:
                    best = s
                    best_n = out
                    best_x = x
            else:
                if s > 0.0:
                    return FAR, n, pa
                if s > shut:
                    shut = s
                    shut_n = out
                    shut_x = x
    if best == -FAR:
        return shut, shut_n, shut_x
    return best, best_n, best_x


@wp.func(inline=False)
def closest_to_edges(
    t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2
):
    """Smallest distance of b's vertices to a's edges: (distance, vector from a to b, witness point)."""
    best = float(FAR)
    best_v = wp.vec2(1.0, 0.0)
    best_x = pa
    a0 = t[0].prism_start[a]
    a1 = t[0].prism_start[a + 1]
    for v in range(t[0].prism_start[b], t[0].prism_start[b + 1]):
        x = turn_back(qa, pb + turn(qb, t[0].vertex[v]) - pa)
        for e in range(a0, a1):
            p = t[0].vertex[e]
            f = e + 1
            if f == a1:
                f = a0
            s = t[0].vertex[f] - p
            u = wp.clamp(wp.dot(x - p, s) / wp.max(wp.dot(s, s), 1.0e-12), 0.0, 1.0)
            w = x - p - u * s
            d = wp.dot(w, w)
            if d < best:
                best = d
                best_v = w
                best_x = x
    return wp.sqrt(best + 1.0e-14), turn(qa, best_v), pa + turn(qa, best_x)


@wp.func
def distance(t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2):
    """Euclidean distance of two convex polygons; where they overlap, minus their separating-axis depth.

    Polygon b may be a single vertex.
    """
    s, n, x = separation(t, a, pa, qa, b, pb, qb, FAR)
    if s > 0.0:
        d0, v0, x0 = closest_to_edges(t, a, pa, qa, b, pb, qb)
        s = d0
        n = v0 / d0
        x = x0
        if t[0].prism_start[b + 1] - t[0].prism_start[b] > 1:
            d1, v1, x1 = closest_to_edges(t, b, pb, qb, a, pa, qa)
            if d1 < d0:
                s = d1
                n = -v1 / d1
                x = x1
    return s, n, x
