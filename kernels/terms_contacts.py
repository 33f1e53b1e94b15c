"""Terms of bodies that meet: solids apart, hard zones free, inside of the room's outside and clear of its openings.

A *contact* is two ranges of prisms that have to stay apart. Which contacts a pair of objects or an object and a fixture
has is said in one place, `contact_of`, for the energy, the verdict and the inequalities of a projection alike.
"""

import warp as wp

from .array_access import item, item_strided
from .bodies import Body, Layout, body_of, fixture_body, prism_of
from .cells import cell_at, crowded
from .geometry import box_separation, overlap_in_z, perp, plane_of, prisms_apart
from .penalties import penalty
from .tables import (
    BOXES,
    FIXTURE_SOLID,
    PAIR_COLLIDE,
    PAIR_POLYGON,
    PAIR_RIGID,
    PAIR_ZONE_OF_FIRST,
    PAIR_ZONE_OF_SECOND,
    POLYGONS,
    SOLIDS,
    ZONES,
    Energy,
    Problems,
    TablesRef,
    TermSlice,
    parts_of,
)

wp.set_module_options({"enable_backward": False})

FIXTURE = wp.constant(32)  # beside the flags of pairs: a contact with a fixture
CONTACTS = wp.constant(PAIR_COLLIDE | PAIR_ZONE_OF_FIRST | PAIR_ZONE_OF_SECOND | FIXTURE)


@wp.struct
class Contact:
    """Two ranges of prisms, of a first and a second body, that have to stay apart."""

    first: wp.vec2i
    second: wp.vec2i
    aim: wp.float32  # [m] clearance that the energy aims at
    hold: wp.float32  # [m] clearance that the verdict insists on


@wp.func
def contact_of(b: Problems, flag: wp.int32, first: wp.int32, second: wp.int32):
    """The contact that one flag (a bit of CONTACTS) means for an object and another or a fixture (global indices)."""
    # solids against solids, zones of the first against solids, its solids against zones or against a fixture
    t = b.tables
    m = b.margins
    x = Contact()
    x.first = parts_of(t, first, wp.where(flag == PAIR_ZONE_OF_FIRST, ZONES, SOLIDS))
    x.aim = m.zone_aim
    x.hold = m.zone_hold
    if flag == FIXTURE:
        prism = item(t[0].fixture, second)
        x.second = wp.vec2i(prism, prism + 1)
        if item(t[0].fixture_kind, second) == FIXTURE_SOLID:
            x.aim = m.bounds_aim
            x.hold = m.bounds_hold
    else:
        x.second = parts_of(t, second, wp.where(flag == PAIR_ZONE_OF_SECOND, ZONES, SOLIDS))
        if flag == PAIR_COLLIDE:
            x.aim = m.collision_aim
            x.hold = m.collision_hold
    return x


@wp.func
def weight_of(b: Problems, flag: wp.int32, second: wp.int32):
    """The weight of a contact in the energy, with its second body (global index)."""
    w = b.weights
    weight = w.zone
    if flag == FIXTURE:
        weight = w.opening
        if item(b.tables[0].fixture_kind, second) == FIXTURE_SOLID:
            weight = w.bounds
    elif flag == PAIR_COLLIDE:
        weight = w.collision
    return weight


@wp.func
def reach_of_pair(t: TablesRef, a: wp.int32, b: wp.int32):
    """Distance [m] of the origins of two objects (global indices) beyond which no contact is violated.

    A zone only meets solids.
    """
    ra = item(t[0].object_radius, a)
    rb = item(t[0].object_radius, b)
    return wp.max(ra[0] + rb[1], ra[1] + rb[0])


@wp.func
def meets_fixture(t: TablesRef, o: wp.int32, k: wp.int32):
    """True when fixture k concerns object o (global indices): not every object has to keep openings clear."""
    return item(t[0].fixture_kind, k) == FIXTURE_SOLID or item(t[0].object_clear, o) == 1


@wp.func
def clearance_penalty(b: Problems, contact: Contact, x: Body, other: Body, kinds: wp.int32):
    """Penalty of a contact's prisms for being closer than it aims at, with the gradient for the first body's pose."""
    t = b.tables
    at = plane_of(x.pose)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for i in range(contact.first[0], contact.first[1]):
        mine = prism_of(t, i, x)
        z = item(t[0].prism_z, i)
        for j in range(contact.second[0], contact.second[1]):
            theirs = prism_of(t, j, other)
            if overlap_in_z(x.pose[2], z, other.pose[2], item(t[0].prism_z, j), b.margins.least_overlap_z):
                s = float(0.0)
                n = wp.vec2(1.0, 0.0)
                point = at
                if (kinds & POLYGONS) == 0:
                    s, n, point = box_separation(mine, theirs, contact.aim)
                else:
                    s, n, point = prisms_apart(t, mine, theirs, contact.aim)
                de, dv = penalty(contact.aim - s, b.weights.knee)
                e += de
                g += dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(point - at)))
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
def contact_energy(b: Problems, x: Body, flags: wp.int32, other: Body, kinds: wp.int32):
    """Penalties of all contacts of an object with another or a fixture, with the gradient for the first.

    ``flags`` are those of the pair, or ``FIXTURE``.
    """
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    left = flags & CONTACTS
    while left != 0:
        flag = left & -left
        left = left - flag
        contact = contact_of(b, flag, x.index, other.index)
        weight = weight_of(b, flag, other.index)
        ek, gk = clearance_penalty(b, contact, x, other, kinds)
        e += weight * ek
        g += weight * gk
    return e, g


@wp.func
def may_meet(b: Problems, layout: Layout, x: Body, heights: wp.vec2, row: wp.int32, j: wp.int32, kinds: wp.int32):
    """True when an object between two heights may have a contact with object j; ``row``: its row of pair flags."""
    t = b.tables
    c = layout.candidate
    flags = int(item(t[0].pair_flags, row + j))
    kind = wp.where((flags & PAIR_POLYGON) != 0, POLYGONS, BOXES)
    if (kinds & BOXES) == 0 and kind == BOXES:
        return False
    # all that is needed is read at once, so that it is waited for once
    other = item_strided(layout.state.poses, c.index, j)
    far = reach_of_pair(t, x.index, c.first_object + j) + b.margins.collision_aim
    v = plane_of(other) - plane_of(x.pose)
    if flags == 0 or (flags & PAIR_RIGID) != 0 or (kinds & kind) == 0 or wp.dot(v, v) >= far * far:
        return False
    if layout.view.stamp != 0 and wp.abs(item(layout.state.mark, c.index, j)) == layout.view.stamp:
        return False
    return (flags & ~PAIR_POLYGON) != PAIR_COLLIDE or overlap_in_z(
        0.0, heights, other[2], item(t[0].object_z, c.first_object + j), b.margins.least_overlap_z
    )


@wp.func
def may_meet_fixture(b: Problems, x: Body, k: wp.int32, kinds: wp.int32):
    """True when an object may have a contact with fixture k (global)."""
    t = b.tables
    prism = item(t[0].fixture, k)
    disc = item(t[0].prism_disc, prism)
    if (kinds & (BOXES | POLYGONS)) != (BOXES | POLYGONS):
        box = item(t[0].prism_box, prism)
        boxes = item(t[0].object_boxes, x.index) == 1 and box[2] > 0.0 and box[3] > 0.0
        if (kinds & wp.where(boxes, BOXES, POLYGONS)) == 0:
            return False
    to = wp.vec2(disc[0], disc[1]) - plane_of(x.pose)
    far = disc[2] + item(t[0].object_radius, x.index)[0] + b.margins.bounds_aim
    return wp.dot(to, to) < far * far and meets_fixture(t, x.index, k)


@wp.func
def add_contacts(b: Problems, layout: Layout, x: Body, part: TermSlice, kinds: wp.int32, total: Energy):
    """The penalties of an object's contacts with fixtures and other objects; arguments as for `evaluator.evaluator`."""
    t = b.tables
    c = layout.candidate
    n = c.objects
    at = plane_of(x.pose)
    row = item(t[0].pair_start, c.problem) + x.obj * n
    z = item(t[0].object_z, x.index)
    heights = wp.vec2(x.pose[2] + z[0], x.pose[2] + z[1])
    cells = layout.view.crowd != 0 and crowded(n, layout.state)
    reach = item(t[0].object_radius, x.index)[1] + item(t[0].grid, c.problem)[3] + b.margins.collision_aim
    left, low = cell_at(t, c.problem, at[0] - reach, at[1] - reach)
    right, high = cell_at(t, c.problem, at[0] + reach, at[1] + reach)
    column = int(left)
    line = int(low)
    head = int(-1)
    deal = int(0)  # cells deal out what they hold one by one
    # what is gone through: the fixtures, then the objects one after the other, unless cells hold them
    f0 = item(t[0].fixture_start, c.problem)
    fixtures = item(t[0].fixture_start, c.problem + 1) - f0
    columns = item(t[0].grid_count, c.problem)[0]
    listed = fixtures + n
    if cells:
        listed = fixtures
        head = item(layout.state.cell_head, c.index, line * columns + column)
    j = int(part.first)
    more = bool(True)
    while more and total.value <= part.limit:
        # who is near is found first: threads that work side by side then meet at the exact tests
        bits = int(0)
        first = j - fixtures
        found = int(-1)
        bit = int(1)
        while bit != (1 << 30) and j < listed:
            close = bool(False)
            if j < fixtures:
                close = may_meet_fixture(b, x, f0 + j, kinds)
            else:
                close = may_meet(b, layout, x, heights, row, j - fixtures, kinds)
            if close:
                bits = bits | bit
            bit = bit << 1
            j += part.step
        more = j < listed
        if cells and not more:
            while bits == 0 and found < 0 and line <= high:
                if head >= 0:
                    if deal == part.first:
                        if may_meet(b, layout, x, heights, row, head, kinds):
                            found = head
                    deal += 1
                    if deal == part.step:
                        deal = 0
                    head = item(layout.state.cell_next, c.index, head)
                while head < 0 and line <= high:
                    column += 1
                    if column > right:
                        column = int(left)
                        line += 1
                    if line <= high:
                        head = item(layout.state.cell_head, c.index, line * columns + column)
            more = line <= high or found >= 0
            if found >= 0:
                bits = 1
        while bits != 0 and total.value <= part.limit:
            k = first + first_bit(bits) * part.step
            bits = bits & (bits - 1)
            if found >= 0:
                k = found
            flags = int(FIXTURE)
            other = fixture_body(f0 + fixtures + k)
            if k >= 0:
                flags = int(item(t[0].pair_flags, row + k))
                other = body_of(c, k, layout.state)
            e, g = contact_energy(b, x, flags, other, kinds)
            total.value += e
            total.share += wp.where(k >= 0, 0.5, 1.0) * e
            total.gradient += g
    return total
