"""Derivatives of the energy and of its residuals by the parameters of scenes.

A thread goes once more through the terms of one item (see `residuals`) and pushes what each of them says of the tables
on to parameters (`slopes`): backwards, the gradient of a sum of items, or forwards, the change of every item.
"""

import warp as wp

from .array_access import item
from .bodies import Body, Candidate, body_of, candidate_of, fixture_body, layout_of, prism_of
from .evaluator import EVERY_KIND
from .features import feature
from .geometry import FAR, overlap_in_z, parting_face, plane_of, turn, turn_back
from .penalties import outside, penalty
from .residuals import LEAST, Items, finite, item_energy, pair_flags_of
from .slopes import UNIT, Entries, Sink, push, push_clearance, push_feature, push_two, push_vertex
from .tables import FREE_Z, Problems, State
from .terms_contacts import CONTACTS, FIXTURE, contact_of, may_meet_fixture, weight_of
from .terms_relations import best_option, relation_of

wp.set_module_options({"enable_backward": False})

EVERY = wp.constant(EVERY_KIND)


@wp.func(inline=False)
def push_relation(b: Problems, c: Candidate, rel: wp.int32, by: wp.float32, s: State, sink: Sink):
    """Add ``by`` times the derivative of a relation's energy: of its weight and of the rows of its best option."""
    t = b.tables
    r = item(t[0].relation_start, c.problem) + rel
    if item(t[0].relation_rigid, r) != 0:
        return
    x = relation_of(t, layout_of(c, s), r)
    option, low = best_option(b, r, x)
    by = by * b.weights.relation
    push(sink, sink.entries.weight + r, by * low)
    by = by * item(t[0].relation_weight, r)
    for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
        value, _g = feature(t, row, 0, x)
        aim = item(t[0].row_aim, row)
        off, sign = outside(value, wp.vec2(aim[0], aim[1]))
        _e, dv = penalty(off * aim[3], b.weights.knee)
        if dv > 0.0:
            first = sink.entries.aim + 4 * row
            push(sink, first + 3, by * dv * off)
            by_off = by * dv * aim[3]
            push(sink, wp.where(sign < 0.0, first, first + 1), -sign * by_off)
            push_feature(t, row, x, sign * by_off, sink)


@wp.func(inline=False)
def push_contacts(b: Problems, x: Body, flags: wp.int32, other: Body, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of `contact_energy`."""
    t = b.tables
    left = flags & CONTACTS
    while left != 0:
        flag = left & -left
        left = left - flag
        contact = contact_of(b, flag, x.index, other.index)
        weight = by * weight_of(b, flag, other.index)
        for i in range(contact.first[0], contact.first[1]):
            mine = prism_of(t, i, x)
            z = item(t[0].prism_z, i)
            for j in range(contact.second[0], contact.second[1]):
                if overlap_in_z(x.pose[2], z, other.pose[2], item(t[0].prism_z, j), b.margins.least_overlap_z):
                    theirs = prism_of(t, j, other)
                    found = parting_face(t, mine, theirs, contact.aim)
                    _e, dv = penalty(contact.aim - found.clearance, b.weights.knee)
                    if found.face >= 0 and dv > 0.0:
                        push_clearance(t, mine, theirs, found, -weight * dv, sink)


@wp.func(inline=False)
def push_walls(b: Problems, c: Candidate, x: Body, by: wp.float32, sink: Sink):
    """Add ``by`` times the derivative of what an object costs for walls, floor and ceiling."""
    t = b.tables
    aim = b.margins.bounds_aim
    at = plane_of(x.pose)
    by = by * b.weights.bounds
    for k in range(item(t[0].plane_start, c.problem), item(t[0].plane_start, c.problem + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        m = turn_back(x.turn, n)
        low = float(FAR)
        rest = int(-1)
        for f in range(item(t[0].footprint_start, x.index), item(t[0].footprint_start, x.index + 1)):
            a = item(t[0].footprint, f)
            for v in range(item(t[0].prism_start, a), item(t[0].prism_start, a + 1)):
                d = wp.dot(m, item(t[0].vertex, v))
                if d < low:
                    low = d
                    rest = v
        _e, dv = penalty(aim - wp.dot(n, at) + plane[2] - low, b.weights.knee)
        if dv > 0.0 and rest >= 0:
            first = sink.entries.plane + 3 * k
            push_two(sink, first, -by * dv * (at + turn(x.turn, item(t[0].vertex, rest))))
            push(sink, first + 2, by * dv)
            push_vertex(sink, rest, -by * dv * m)
    if item(t[0].object_free, x.index) & FREE_Z:
        z = item(t[0].object_z, x.index)
        off, sign = outside(x.pose[2], wp.vec2(aim - z[0], item(t[0].room_height, c.problem) - z[1] - aim))
        _e, dv = penalty(off, b.weights.knee)
        first = sink.entries.heights + 2 * x.index
        if sign < 0.0:
            push(sink, first, -by * dv)
        elif sign > 0.0:
            push(sink, first + 1, by * dv)
            push(sink, sink.entries.ceiling + c.problem, -by * dv)


@wp.kernel
def measure_parameter_slopes(
    # Problem:
    b: Problems,
    items: Items,
    entries: Entries,
    along: wp.array2d(dtype=wp.float32),
    # State in:
    s: State,
    up: wp.array2d(dtype=wp.float32),
    roots: wp.int32,
    # State in and out:
    total: wp.array2d(dtype=wp.int64),
):
    """Derivatives by parameters [candidate, parameter] of a sum of items, or of items [candidate, item] along a change.

    Items count ``up`` [candidate, item] times; where ``roots`` is 1 as residuals, else as energies.
    """
    candidate, k = wp.tid()
    c = candidate_of(b, candidate)
    at = items.start[c.problem] + k
    if at >= items.start[c.problem + 1]:
        return
    by = up[candidate, k]
    objects = items.objects[at]
    if by == 0.0 or not finite(c, objects, s):
        return
    rel = items.relation[at]
    if roots != 0:
        e, _g = item_energy(b, c, rel, objects, 0, s)
        if e <= LEAST:
            return
        by = by * wp.sqrt(b.weights.knee / (2.0 * e))
    sink = Sink(entries, candidate, k, along, total)
    x = body_of(c, objects[0], s)
    if rel >= 0:
        push_relation(b, c, rel, by, s, sink)
    elif objects[1] < 0:
        push_walls(b, c, x, by, sink)
        for f in range(item(b.tables[0].fixture_start, c.problem), item(b.tables[0].fixture_start, c.problem + 1)):
            if may_meet_fixture(b, x, f, EVERY):
                push_contacts(b, x, FIXTURE, fixture_body(f), by, sink)
    else:
        flags = pair_flags_of(b.tables, c, objects[0], objects[1])
        push_contacts(b, x, flags, body_of(c, objects[1], s), by, sink)


@wp.kernel
def in_units(
    # Problem:
    b: Problems,
    offset: wp.array2d(dtype=wp.float32),
    # State in:
    total: wp.array2d(dtype=wp.int64),
    # State out:
    slope_out: wp.array2d(dtype=wp.float32),
):
    """Sums in `UNIT` as numbers, with what a candidate's problem adds to each."""
    candidate, j = wp.tid()
    slope_out[candidate, j] = wp.float32(wp.float64(total[candidate, j]) * UNIT) + offset[b.problem[candidate], j]
