"""Derivatives of clearances and features by the tables, passed on to the parameters that the tables depend on.

The numbers of the tables that the energy is smooth in are *entries*, counted through one table after the other. A
sparse matrix says how entries change with parameters; it is the compiler's, see ``sceneweaver.layout.jacobian``. What a
term knows is its derivative by a few entries: `push` turns those into derivatives by parameters on the spot, so no
table of derivatives is ever written.

As for poses, derivatives are those with the witness frozen. Witnesses are looked for among edges and vertices alone,
boxes as well: a corner of a room that moves makes something else of a box.

Sums are in whole numbers of `UNIT`, so that the order in which threads add does not matter.
"""

import warp as wp

from .array_access import item
from .bodies import Body, prism_of
from .features import Relation, half_extent, normal_of, offset_of, point_of, user_residual
from .geometry import FAR, PartingFace, Prism, parting_face, perp, plane_of, turn, turn_back
from .tables import (
    FEATURE_CONSTANT,
    FEATURE_DISTANCE,
    FEATURE_EXTENT,
    FEATURE_HEIGHT,
    FEATURE_LINE,
    FEATURE_SPREAD,
    FEATURE_USER,
    FEATURE_WINDOW,
    FEATURE_YAW,
    TablesRef,
)

wp.set_module_options({"enable_backward": False})

UNIT = wp.constant(wp.float64(2.0**-32))
STEP = wp.constant(2.0e-3)  # of a user's residual by its numbers, of those above 1 as a share


@wp.struct
class Entries:
    """Where the entries of each table begin, and how they change with the parameters of their scene."""

    weight: wp.int32  # relation_weight: 1 for each relation
    frame: wp.int32  # row_frame: 4 for each row
    aim: wp.int32  # row_aim: 4
    size: wp.int32  # object_size: 3
    heights: wp.int32  # object_z: 2
    vertex: wp.int32  # vertex: 2
    edge: wp.int32  # edge: 3 (normal, offset)
    plane: wp.int32  # plane: 3
    ceiling: wp.int32  # room_height: 1
    start: wp.array(dtype=wp.int32)  # [entry + 1]: range of an entry's derivatives
    parameter: wp.array(dtype=wp.int32)  # [derivative]: number of the parameter in its scene
    slope: wp.array(dtype=wp.float32)  # [derivative]


@wp.struct
class Sink:
    """Where derivatives go: for a candidate's parameters, or along a change of them for the item that is looked at."""

    entries: Entries
    candidate: wp.int32
    item: wp.int32
    along: wp.array2d(dtype=wp.float32)  # [candidate, parameter]; of no parameters: all of them are wanted
    total: wp.array2d(dtype=wp.int64)  # [candidate, parameter], or [candidate, item] along; in `UNIT`


@wp.func
def push(sink: Sink, entry: wp.int32, by: wp.float32):
    """Add ``by`` times the derivative of an entry."""
    if by == 0.0:
        return
    for k in range(sink.entries.start[entry], sink.entries.start[entry + 1]):
        p = sink.entries.parameter[k]
        v = wp.float64(by * sink.entries.slope[k])
        column = int(p)
        if sink.along.shape[1] > 0:
            v = v * wp.float64(sink.along[sink.candidate, p])
            column = sink.item
        wp.atomic_add(sink.total, sink.candidate, column, wp.int64(wp.round(v / UNIT)))


@wp.func
def push_two(sink: Sink, entry: wp.int32, by: wp.vec2):
    """`push` of two entries side by side."""
    push(sink, entry, by[0])
    push(sink, entry + 1, by[1])


@wp.func
def push_vertex(sink: Sink, vertex: wp.int32, by: wp.vec2):
    """`push` of a vertex."""
    push_two(sink, sink.entries.vertex + 2 * vertex, by)


@wp.func(inline=False)
def push_clearance(t: TablesRef, a: Prism, b: Prism, found: PartingFace, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of what parts two prisms: the face's line, and the vertex that faces it."""
    owner = a
    facing = b
    if not found.of_first:
        owner = b
        facing = a
    plane = item(t[0].edge, found.face)
    n = turn(owner.turn, wp.vec2(plane[0], plane[1]))
    v = facing.at + turn(facing.turn, item(t[0].vertex, found.vertex))
    first = sink.entries.edge + 3 * found.face
    push_two(sink, first, by * turn_back(owner.turn, v - owner.at))
    push(sink, first + 2, -by)
    push_vertex(sink, found.vertex, by * turn_back(facing.turn, n))


@wp.struct
class ClosestPair:
    """The vertex of one polygon and the point of another's edge that are nearest to each other."""

    distance: wp.float32
    of_first: wp.bool  # the edge is the first polygon's
    vertex: wp.int32
    tail: wp.int32  # the edge's vertices
    head: wp.int32
    share: wp.float32  # of the way from tail to head
    away: wp.vec2  # from the edge to the vertex, a unit vector in the room's frame


@wp.func(inline=False)
def nearest_to_edges(t: TablesRef, a: Prism, b: Prism, of_first: wp.bool, best: ClosestPair):
    """The closest pair so far, or an edge of a with a vertex of b."""
    a0 = item(t[0].prism_start, a.index)
    a1 = item(t[0].prism_start, a.index + 1)
    for v in range(item(t[0].prism_start, b.index), item(t[0].prism_start, b.index + 1)):
        x = turn_back(a.turn, b.at + turn(b.turn, item(t[0].vertex, v)) - a.at)
        for e in range(a0, a1):
            f = e + 1
            if f == a1:
                f = a0
            p = item(t[0].vertex, e)
            s = item(t[0].vertex, f) - p
            u = wp.clamp(wp.dot(x - p, s) / wp.max(wp.dot(s, s), 1.0e-12), 0.0, 1.0)
            w = x - p - u * s
            d = wp.length(w)
            if d < best.distance:
                best = ClosestPair(d, of_first, v, e, f, u, turn(a.turn, w) / wp.max(d, 1.0e-7))
    return best


@wp.func(inline=False)
def push_distance(t: TablesRef, row: wp.int32, x: Relation, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of `distance_feature`."""
    prism = item(t[0].row_prism, row)
    first = int(0)
    last = int(1)
    if prism < 0:
        first = item(t[0].footprint_start, x.b.index)
        last = item(t[0].footprint_start, x.b.index + 1)
    least = float(FAR)
    pair = ClosestPair()
    parting = PartingFace()
    mine = prism_of(t, item(t[0].footprint, item(t[0].footprint_start, x.a.index)), x.a)
    other = mine
    for i in range(item(t[0].footprint_start, x.a.index), item(t[0].footprint_start, x.a.index + 1)):
        a = prism_of(t, item(t[0].footprint, i), x.a)
        for j in range(first, last):
            k = prism
            if prism < 0:
                k = item(t[0].footprint, j)
            b = prism_of(t, k, x.b)
            apart = parting_face(t, a, b, FAR)
            near = ClosestPair()
            s = apart.clearance
            if s > 0.0:
                near.distance = FAR
                near = nearest_to_edges(t, a, b, True, near)
                if item(t[0].prism_start, k + 1) - item(t[0].prism_start, k) > 1:
                    near = nearest_to_edges(t, b, a, False, near)
                s = near.distance
            if s < least:
                least = s
                pair = near
                parting = apart
                mine = a
                other = b
    if least <= 0.0:
        push_clearance(t, mine, other, parting, by, sink)
        return
    owner = mine
    facing = other
    if not pair.of_first:
        owner = other
        facing = mine
    pull = turn_back(owner.turn, -by * pair.away)
    push_vertex(sink, pair.vertex, turn_back(facing.turn, by * pair.away))
    push_vertex(sink, pair.tail, (1.0 - pair.share) * pull)
    push_vertex(sink, pair.head, pair.share * pull)


@wp.func(inline=False)
def push_user(t: TablesRef, row: wp.int32, kind: wp.int32, x: Relation, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of a user's residual by its numbers and sizes, by central differences."""
    u = point_of(t, row)
    n = normal_of(t, row)
    p = wp.vec4(u[0], u[1], n[0], n[1])
    sa = item(t[0].object_size, x.a.index)
    sb = wp.vec3(0.0, 0.0, 0.0)
    if x.b.index >= 0:
        sb = item(t[0].object_size, x.b.index)
    for c in range(4):
        h = wp.vec4(0.0, 0.0, 0.0, 0.0)
        h[c] = STEP * wp.max(wp.abs(p[c]), 1.0)
        up = user_residual(kind, x.a.pose, x.b.pose, sa, sb, p + h)
        down = user_residual(kind, x.a.pose, x.b.pose, sa, sb, p - h)
        place = (c + 2) % 4  # the frame has the normal before the point
        push(sink, sink.entries.frame + 4 * row + place, by * (up - down) / (2.0 * h[c]))
    for c in range(3):
        step = wp.vec3(0.0, 0.0, 0.0)
        step[c] = STEP
        bigger = user_residual(kind, x.a.pose, x.b.pose, sa + step, sb, p)
        smaller = user_residual(kind, x.a.pose, x.b.pose, sa - step, sb, p)
        push(sink, sink.entries.size + 3 * x.a.index + c, by * (bigger - smaller) / (2.0 * STEP))
    if x.b.index >= 0:
        for c in range(3):
            step = wp.vec3(0.0, 0.0, 0.0)
            step[c] = STEP
            bigger = user_residual(kind, x.a.pose, x.b.pose, sa, sb + step, p)
            smaller = user_residual(kind, x.a.pose, x.b.pose, sa, sb - step, p)
            push(sink, sink.entries.size + 3 * x.b.index + c, by * (bigger - smaller) / (2.0 * STEP))


@wp.func
def extent_by_normal(size: wp.vec3, n: wp.vec2, q: wp.vec2):
    """The derivative of `half_extent` by the direction n."""
    side = perp(q)
    return 0.5 * (wp.sign(wp.dot(n, q)) * size[0] * q + wp.sign(wp.dot(n, side)) * size[1] * side)


@wp.func
def push_extent(sink: Sink, a: Body, n: wp.vec2, by: wp.float32):
    """Add ``by`` times the derivative of `half_extent` by the size of its box."""
    first = sink.entries.size + 3 * a.index
    push_two(sink, first, 0.5 * by * wp.vec2(wp.abs(wp.dot(n, a.turn)), wp.abs(wp.dot(n, perp(a.turn)))))


@wp.func(inline=False)
def push_feature(t: TablesRef, row: wp.int32, x: Relation, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of a row's feature."""
    kind = item(t[0].row_feature, row)
    normal = sink.entries.frame + 4 * row
    point = normal + 2
    offset = sink.entries.aim + 4 * row + 2
    at = plane_of(x.a.pose)
    n = normal_of(t, row)
    if kind == FEATURE_LINE:
        from_b = at + turn(x.a.turn, point_of(t, row)) - plane_of(x.b.pose)
        push_two(sink, normal, by * turn_back(x.b.turn, from_b))
        push_two(sink, point, by * turn_back(x.a.turn, turn(x.b.turn, n)))
        push(sink, offset, -by)
    elif kind == FEATURE_YAW or kind == FEATURE_HEIGHT or kind == FEATURE_SPREAD:
        push(sink, offset, -by)
    elif kind == FEATURE_CONSTANT:
        push(sink, offset, by)
    elif kind == FEATURE_EXTENT:
        size = item(t[0].object_size, x.a.index)
        push_two(sink, normal, by * (at - extent_by_normal(size, n, x.a.turn)))
        push(sink, offset, -by)
        push_extent(sink, x.a, n, -by)
    elif kind == FEATURE_WINDOW:
        size = item(t[0].object_size, x.a.index)
        reach, _slope = half_extent(size, n, x.a.turn)
        half = point_of(t, row)[0]
        share = 2.0 * point_of(t, row)[1]
        side = wp.sign(wp.dot(n, at) - offset_of(t, row))
        by_reach = float(-1.0)
        by_half = float(-1.0)
        if reach < half:
            by_reach = share - 1.0
        else:
            by_half = share - 1.0
        push_two(sink, normal, by * (side * at + by_reach * extent_by_normal(size, n, x.a.turn)))
        push(sink, offset, -by * side)
        push_extent(sink, x.a, n, by * by_reach)
        push_two(sink, point, by * wp.vec2(by_half, 2.0 * wp.min(reach, half)))
    elif kind == FEATURE_DISTANCE:
        push_distance(t, row, x, by, sink)
    elif kind >= FEATURE_USER:
        push_user(t, row, kind, x, by, sink)
