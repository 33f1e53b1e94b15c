"""The engine's own verdict: conservative predicates, so that what it calls valid the judge calls valid.

Thresholds are tighter than the judge's by more than float32 loses in a room of 100 m.
"""

import warp as wp

from .array_access import item
from .bodies import Body, body_of, candidate_of, fixture_body, layout_of, object_count, prism_of
from .features import Relation, feature
from .geometry import overlap_in_z, plane_of, prisms_apart, turn
from .tables import Problems, State, TablesRef
from .terms_contacts import CONTACTS, FIXTURE, Contact, contact_of, meets_fixture, reach_of_pair
from .terms_relations import relation_of
from .yaw_domain import in_yaw_domain

wp.set_module_options({"enable_backward": False})

VALID = wp.constant(0)
BROKEN = wp.constant(1)  # collision, bounds, support, zone or opening
UNMET = wp.constant(2)  # a hard relation is false
DIVERGED = wp.constant(3)


@wp.struct
class DeviceVerdict:
    """Where the verdict on a batch is written, on its device."""

    status: wp.array(dtype=wp.int8)  # [candidate]: VALID, BROKEN, UNMET or DIVERGED
    fault: wp.array2d(dtype=wp.int8)  # [candidate, object]: VALID, BROKEN or DIVERGED
    holds: wp.array2d(dtype=wp.bool)  # [candidate, relation]: whether it holds under any of its options


@wp.func(inline=False)
def contact_holds(b: Problems, contact: Contact, x: Body, other: Body):
    """True when no two prisms of a contact come closer than it has to hold (negative: may sink in so far)."""
    t = b.tables
    for i in range(contact.first[0], contact.first[1]):
        mine = prism_of(t, i, x)
        z = item(t[0].prism_z, i)
        for j in range(contact.second[0], contact.second[1]):
            if overlap_in_z(x.pose[2], z, other.pose[2], item(t[0].prism_z, j), b.margins.least_overlap_z):
                s, _n, _x = prisms_apart(t, mine, prism_of(t, j, other), contact.hold)
                if s < contact.hold:
                    return False
    return True


@wp.func
def contacts_hold(b: Problems, flags: wp.int32, x: Body, other: Body):
    """True when every contact holds that the flags of a pair, or ``FIXTURE``, mean for two bodies."""
    left = flags & CONTACTS
    while left != 0:
        flag = left & -left
        left = left - flag
        if not contact_holds(b, contact_of(b, flag, x.index, other.index), x, other):
            return False
    return True


@wp.func(inline=False)
def room_holds(b: Problems, p: wp.int32, x: Body):
    """True when an object is inside the room and clear of doors and windows."""
    t = b.tables
    m = b.margins
    at = plane_of(x.pose)
    o = x.index
    for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        for f in range(item(t[0].footprint_start, o), item(t[0].footprint_start, o + 1)):
            a = item(t[0].footprint, f)
            for v in range(item(t[0].prism_start, a), item(t[0].prism_start, a + 1)):
                if wp.dot(n, at + turn(x.turn, item(t[0].vertex, v))) - plane[2] < m.bounds_hold:
                    return False
    for k in range(item(t[0].fixture_start, p), item(t[0].fixture_start, p + 1)):
        if meets_fixture(t, o, k):
            if not contacts_hold(b, FIXTURE, x, fixture_body(k)):
                return False
    if x.pose[2] + item(t[0].object_z, o)[1] > item(t[0].room_height, p) - m.bounds_hold:
        return False
    return x.pose[2] + item(t[0].object_z, o)[0] >= m.bounds_hold


@wp.func(inline=False)
def relation_holds(t: TablesRef, r: wp.int32, x: Relation):
    """True when every row of one of the options of relation r (global) lies in its interval."""
    for option in range(item(t[0].option_start, r), item(t[0].option_start, r + 1)):
        holds = bool(True)
        for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
            if holds:
                value, _g = feature(t, row, 0, x)
                hold = item(t[0].row_hold, row)
                holds = not (value < hold[0] or value > hold[1])
        if holds:
            return True
    return False


@wp.kernel
def judge_objects(
    # Problem:
    b: Problems,
    # State in:
    active: wp.array(dtype=wp.int32),
    s: State,
    # State out:
    verdict_out: DeviceVerdict,
):
    """Fault of every object of the active candidates. A pair is charged to both."""
    t = b.tables
    candidate, obj = wp.tid()
    if active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    if obj >= c.objects:
        verdict_out.fault[candidate, obj] = wp.int8(VALID)
        return
    x = body_of(c, obj, s)
    if not wp.isfinite(x.pose):
        verdict_out.fault[candidate, obj] = wp.int8(DIVERGED)
        return
    ok = in_yaw_domain(t, x.index, x.pose[3]) and room_holds(b, c.problem, x)
    row = item(t[0].pair_start, c.problem) + obj * c.objects
    for j in range(c.objects):
        flags = int(item(t[0].pair_flags, row + j))
        if ok and flags != 0:
            other = body_of(c, j, s)
            v = plane_of(other.pose) - plane_of(x.pose)
            far = reach_of_pair(t, x.index, other.index)
            if wp.dot(v, v) < far * far:
                ok = contacts_hold(b, flags, x, other)
    verdict_out.fault[candidate, obj] = wp.int8(wp.where(ok, VALID, BROKEN))


@wp.kernel
def judge_relations(
    # Problem:
    b: Problems,
    # State in:
    active: wp.array(dtype=wp.int32),
    s: State,
    # State out:
    verdict_out: DeviceVerdict,
):
    """Whether each relation of the active candidates holds."""
    t = b.tables
    candidate, rel = wp.tid()
    if active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    r = item(t[0].relation_start, c.problem) + rel
    holds = bool(True)
    if r < item(t[0].relation_start, c.problem + 1):
        holds = relation_holds(t, r, relation_of(t, layout_of(c, s), r))
    verdict_out.holds[candidate, rel] = holds


@wp.kernel
def judge_candidates(
    # Problem:
    b: Problems,
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    verdict: DeviceVerdict,
):
    """Status of every active candidate, by its objects and relations."""
    t = b.tables
    candidate = wp.tid()
    if active[candidate] == 0:
        return
    p = b.problem[candidate]
    status = int(VALID)
    r0 = item(t[0].relation_start, p)
    for r in range(r0, item(t[0].relation_start, p + 1)):
        if not verdict.holds[candidate, r - r0]:
            kind = item(t[0].relation_fault, r)
            if kind == UNMET and status == VALID:
                status = UNMET
            if kind == BROKEN and status != DIVERGED:
                status = BROKEN
    for obj in range(object_count(t, p)):
        kind = int(verdict.fault[candidate, obj])
        if kind == DIVERGED:
            status = DIVERGED
        elif kind == BROKEN and status != DIVERGED:
            status = BROKEN
    verdict.status[candidate] = wp.int8(status)
