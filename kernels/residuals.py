"""The energy taken apart: one residual for each of its items, its sparse Jacobian, and the signed violation.

An *item* is a relation, an object alone (walls, fixtures, floor and ceiling), or a pair of objects. If e is the item's
part of the energy and k the knee of the penalty, its residual is r = sqrt(2 k e), so that the sum of r^2 / (2 k) over
all items is the energy itself: a least-squares solver and a descent see the same function. A single violation v below
the knee has r = v times the root of its weight. An item has three objects at most, and so has a row of the Jacobian.
"""

import warp as wp

from .array_access import item
from .bodies import Body, Candidate, body_of, candidate_of, fixture_body, layout_of, prism_of
from .evaluator import EVERY_KIND
from .features import Relation, feature
from .geometry import FAR, overlap_in_z, plane_of, prisms_apart, turn
from .tables import Energy, Problems, State, TablesRef, TermSlice
from .terms_bounds import add_bounds
from .terms_contacts import CONTACTS, FIXTURE, Contact, contact_energy, contact_of, may_meet_fixture, meets_fixture
from .terms_relations import relation_energy, relation_of
from .verdict import VALID, DeviceVerdict

wp.set_module_options({"enable_backward": False})

EVERY = wp.constant(EVERY_KIND)
LEAST = wp.constant(1.0e-12)  # [m] energy below which an item counts as in order: its residual is flat there


@wp.struct
class Items:
    """The items of each problem's energy."""

    start: wp.array(dtype=wp.int32)  # [problem + 1]: range of a problem's items
    objects: wp.array(dtype=wp.vec3i)  # [item]: its objects (local); -1: none
    relation: wp.array(dtype=wp.int32)  # [item]: its relation (local); -1: an object alone, or a pair


@wp.func
def pair_flags_of(t: TablesRef, c: Candidate, i: wp.int32, j: wp.int32):
    """The flags of a pair of a candidate's objects (local)."""
    return int(item(t[0].pair_flags, item(t[0].pair_start, c.problem) + i * c.objects + j))


@wp.func
def alone_energy(b: Problems, c: Candidate, obj: wp.int32, s: State):
    """Penalty of one object against walls, fixtures, floor and ceiling, with the gradient for its pose."""
    t = b.tables
    x = body_of(c, obj, s)
    total = add_bounds(b, layout_of(c, s), x, TermSlice(0, 1, FAR), EVERY, Energy())
    e = total.value
    g = total.gradient
    for k in range(item(t[0].fixture_start, c.problem), item(t[0].fixture_start, c.problem + 1)):
        if may_meet_fixture(b, x, k, EVERY):
            ek, gk = contact_energy(b, x, FIXTURE, fixture_body(k), EVERY)
            e += ek
            g += gk
    return e, g


@wp.func
def item_energy(b: Problems, c: Candidate, rel: wp.int32, objects: wp.vec3i, role: wp.int32, s: State):
    """An item's part of the energy [m], with the gradient for the pose of the object in one role."""
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if rel >= 0:
        if item(b.tables[0].relation_rigid, item(b.tables[0].relation_start, c.problem) + rel) == 0:
            layout = layout_of(c, s)
            layout.view.best = 1
            e, g = relation_energy(b, layout, rel, role, EVERY)
    elif objects[1] < 0:
        e, g = alone_energy(b, c, objects[0], s)
    else:
        x = body_of(c, objects[role], s)
        other = body_of(c, objects[1 - role], s)
        flags = pair_flags_of(b.tables, c, objects[role], objects[1 - role])
        e, g = contact_energy(b, x, flags, other, EVERY)
    return e, g


@wp.func
def finite(c: Candidate, objects: wp.vec3i, s: State):
    """True when the poses of an item's objects are numbers."""
    good = bool(True)
    for role in range(3):
        if objects[role] >= 0:
            good = good and wp.isfinite(s.poses[c.index, objects[role]])
    return good


@wp.kernel
def measure_residuals(
    # Problem:
    b: Problems,
    items: Items,
    # State in:
    s: State,
    # State out:
    residual_out: wp.array2d(dtype=wp.float32),
    slope_out: wp.array3d(dtype=wp.vec4),
):
    """Residuals [candidate, item] in metres, and their derivatives [candidate, item, role] for the objects' poses."""
    candidate, k = wp.tid()
    c = candidate_of(b, candidate)
    at = items.start[c.problem] + k
    residual_out[candidate, k] = 0.0
    for role in range(3):
        slope_out[candidate, k, role] = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if at >= items.start[c.problem + 1]:
        return
    objects = items.objects[at]
    if not finite(c, objects, s):
        residual_out[candidate, k] = FAR
        return
    knee = b.weights.knee
    for role in range(3):
        if objects[role] >= 0:
            e, g = item_energy(b, c, items.relation[at], objects, role, s)
            if e > LEAST:
                r = wp.sqrt(2.0 * knee * e)
                residual_out[candidate, k] = r
                slope_out[candidate, k, role] = (knee / r) * g


@wp.func
def relation_violation(t: TablesRef, r: wp.int32, x: Relation):
    """How far relation r (global) is outside of what counts as fulfilled [m], by its best option; negative: inside."""
    least = float(FAR)
    for option in range(item(t[0].option_start, r), item(t[0].option_start, r + 1)):
        worst = float(-FAR)
        for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
            value, _g = feature(t, row, 0, x)
            hold = item(t[0].row_hold, row)
            off = wp.max(hold[0] - value, value - hold[1])
            worst = wp.max(worst, off * item(t[0].row_aim, row)[3])
        least = wp.min(least, worst)
    return least


@wp.func
def contact_violation(b: Problems, contact: Contact, x: Body, other: Body):
    """How much deeper two bodies meet than a contact allows [m]; negative: what is left. -FAR: they never meet."""
    t = b.tables
    worst = float(-FAR)
    for i in range(contact.first[0], contact.first[1]):
        for j in range(contact.second[0], contact.second[1]):
            zi = item(t[0].prism_z, i)
            zj = item(t[0].prism_z, j)
            if overlap_in_z(x.pose[2], zi, other.pose[2], zj, b.margins.least_overlap_z):
                s, _n, _p = prisms_apart(t, prism_of(t, i, x), prism_of(t, j, other), FAR)
                worst = wp.max(worst, contact.hold - s)
    return worst


@wp.func
def contacts_violation(b: Problems, flags: wp.int32, x: Body, other: Body):
    """The worst `contact_violation` of all contacts that the flags of a pair, or ``FIXTURE``, mean for two bodies."""
    worst = float(-FAR)
    left = flags & CONTACTS
    while left != 0:
        flag = left & -left
        left = left - flag
        worst = wp.max(worst, contact_violation(b, contact_of(b, flag, x.index, other.index), x, other))
    return worst


@wp.func
def alone_violation(b: Problems, c: Candidate, x: Body):
    """How far an object is beyond walls, fixtures, floor or ceiling [m], past what the verdict lets pass."""
    t = b.tables
    hold = b.margins.bounds_hold
    at = plane_of(x.pose)
    z = item(t[0].object_z, x.index)
    worst = wp.max(hold - x.pose[2] - z[0], x.pose[2] + z[1] + hold - item(t[0].room_height, c.problem))
    for k in range(item(t[0].plane_start, c.problem), item(t[0].plane_start, c.problem + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        for f in range(item(t[0].footprint_start, x.index), item(t[0].footprint_start, x.index + 1)):
            a = item(t[0].footprint, f)
            for v in range(item(t[0].prism_start, a), item(t[0].prism_start, a + 1)):
                depth = wp.dot(n, at + turn(x.turn, item(t[0].vertex, v))) - plane[2]
                worst = wp.max(worst, hold - depth)
    for k in range(item(t[0].fixture_start, c.problem), item(t[0].fixture_start, c.problem + 1)):
        if meets_fixture(t, x.index, k):
            worst = wp.max(worst, contacts_violation(b, FIXTURE, x, fixture_body(k)))
    return worst


@wp.kernel
def measure_violations(
    # Problem:
    b: Problems,
    items: Items,
    # State in:
    s: State,
    # State out:
    violation_out: wp.array2d(dtype=wp.float32),
):
    """By how much each item misses what the verdict insists on [m], [candidate, item]; negative: what is left."""
    candidate, k = wp.tid()
    t = b.tables
    c = candidate_of(b, candidate)
    at = items.start[c.problem] + k
    violation_out[candidate, k] = -FAR
    if at >= items.start[c.problem + 1]:
        return
    objects = items.objects[at]
    rel = items.relation[at]
    off = float(FAR)
    if finite(c, objects, s):
        x = body_of(c, objects[0], s)
        if rel >= 0:
            r = item(t[0].relation_start, c.problem) + rel
            off = relation_violation(t, r, relation_of(t, layout_of(c, s), r))
        elif objects[1] < 0:
            off = alone_violation(b, c, x)
        else:
            flags = pair_flags_of(t, c, objects[0], objects[1])
            off = contacts_violation(b, flags, x, body_of(c, objects[1], s))
    violation_out[candidate, k] = off


@wp.kernel
def mark_feasible(
    # State in:
    verdict: DeviceVerdict,
    also: wp.array(dtype=wp.int32),
    # State out:
    feasible_out: wp.array(dtype=wp.bool),
):
    """Which candidates the verdict calls valid; ``also`` [candidate] is 0 where something else rules them out."""
    candidate = wp.tid()
    feasible_out[candidate] = int(verdict.status[candidate]) == VALID and also[candidate] != 0
