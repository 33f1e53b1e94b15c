"""Feasibility near a layout as linear inequalities: bounds, openings, hard relations, collisions and zones.

The functions that add rows return how many an object has so far, and by how much [m] its terms miss the verdict's
limits in all, without those that nothing free to move can mend.
"""

import warp as wp

from .bodies import Body, Candidate, body_of, candidate_of, fixture_body
from .contacts import add_contact_rows, nearest_vertices, no_vertices
from .features import feature
from .geometry import FAR, perp, plane_of, turn, turn_back
from .inequality import ROWS, SLACK, SURE, InequalitySystem, add_own_row, add_row, wanting
from .tables import FREE_Z, PAIR_RIGID, Margins, Problems, State, TablesRef, View
from .terms_contacts import CONTACTS, FIXTURE, contact_of, meets_fixture, reach_of_pair
from .terms_relations import relation_poses

wp.set_module_options({"enable_backward": False})

# Keys of rows; a contact's is face * 32768 + vertex.
KEY_FLOOR = wp.constant(-1)
KEY_CEILING = wp.constant(-2)
KEY_WALL = wp.constant(-3)  # less half plane * 32768 + vertex
KEY_RELATION = wp.constant(1073741824)  # plus twice the row of tables, plus the side


@wp.func(inline=False)
def add_wall_rows(
    t: TablesRef, m: Margins, c: Candidate, x: Body, reach: wp.float32, s: State, system: InequalitySystem
):
    """Rows that keep an object inside the walls."""
    count = int(0)
    missed = float(0.0)
    at = plane_of(x.pose)
    for k in range(t[0].plane_start[c.problem], t[0].plane_start[c.problem + 1]):
        plane = t[0].plane[k]
        n = wp.vec2(plane[0], plane[1])
        depth = wp.dot(n, at) - plane[2]
        if depth - t[0].object_radius[x.index][0] < reach:
            nearest = no_vertices()
            for f in range(t[0].footprint_start[x.index], t[0].footprint_start[x.index + 1]):
                nearest = nearest_vertices(t, t[0].footprint[f], turn_back(x.turn, n), depth, nearest)
            mobile = int(0)
            for i in range(2):
                v = wp.where(i == 0, nearest.lowest, nearest.second)
                d = wp.where(i == 0, nearest.low, nearest.next)
                if count >= ROWS:
                    mobile = 1
                elif v >= 0 and d < reach:
                    g = wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(turn(x.turn, t[0].vertex[v]))))
                    want = wanting(d, m.bounds_hold)
                    key = KEY_WALL - (k * 32768 + v)
                    added = add_own_row(t, c, x.obj, x.obj * ROWS + count, g, want, key, s, system)
                    count += added
                    mobile += added
            if mobile > 0:
                missed += wp.max(m.bounds_hold + SURE - nearest.low, 0.0)
    return count, missed


@wp.func(inline=False)
def add_fixture_rows(
    t: TablesRef,
    m: Margins,
    c: Candidate,
    x: Body,
    reach: wp.float32,
    count: wp.int32,
    missed: wp.float32,
    s: State,
    system: InequalitySystem,
):
    """Rows that keep an object out of the room's outside and of openings."""
    count = int(count)
    missed = float(missed)
    for k in range(t[0].fixture_start[c.problem], t[0].fixture_start[c.problem + 1]):
        disc = t[0].prism_disc[t[0].fixture[k]]
        to = wp.vec2(disc[0], disc[1]) - plane_of(x.pose)
        far = disc[2] + t[0].object_radius[x.index][0] + reach
        if wp.dot(to, to) < far * far and meets_fixture(t, x.index, k):
            contact = contact_of(t, m, FIXTURE, x.index, k)
            count, miss = add_contact_rows(
                t, c, x, fixture_body(k), contact, m.least_overlap_z, reach, count, s, system
            )
            missed += miss
    return count, missed


@wp.func(inline=False)
def add_height_rows(
    t: TablesRef,
    m: Margins,
    c: Candidate,
    x: Body,
    reach: wp.float32,
    count: wp.int32,
    missed: wp.float32,
    s: State,
    system: InequalitySystem,
):
    """Rows that keep an object above the floor and below the ceiling."""
    count = int(count)
    missed = float(missed)
    if t[0].object_free[x.index] & FREE_Z:
        z = t[0].object_z[x.index]
        down = x.pose[2] + z[0]
        up = t[0].room_height[c.problem] - z[1] - x.pose[2]
        missed += wp.max(m.bounds_hold - down, 0.0) + wp.max(m.bounds_hold - up, 0.0)
        rise = wp.vec4(0.0, 0.0, 1.0, 0.0)
        if down < reach and count < ROWS:
            want = wanting(down, m.bounds_hold)
            count += add_own_row(t, c, x.obj, x.obj * ROWS + count, rise, want, KEY_FLOOR, s, system)
        if up < reach and count < ROWS:
            want = wanting(up, m.bounds_hold)
            count += add_own_row(t, c, x.obj, x.obj * ROWS + count, -rise, want, KEY_CEILING, s, system)
    return count, missed


@wp.func(inline=False)
def add_pair_rows(
    t: TablesRef,
    m: Margins,
    c: Candidate,
    x: Body,
    reach: wp.float32,
    count: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """Rows of the pairs that an object looks after: solids apart, and out of hard zones.

    Of two objects the first looks after the pair when their indices are both even or both odd, else the second, so
    that threads of one candidate have like work.
    """
    count = int(count)
    missed = float(0.0)
    for j in range(c.objects):
        ours = ((x.obj + j) & 1) == 0
        if j < x.obj:
            ours = not ours
        flags = int(t[0].pair_flags[t[0].pair_start[c.problem] + x.obj * c.objects + j])
        if ours and flags != 0 and (flags & PAIR_RIGID) == 0:
            other = body_of(c, j, s)
            v = plane_of(other.pose) - plane_of(x.pose)
            far = reach_of_pair(t, x.index, other.index) + reach
            if wp.dot(v, v) < far * far:
                left = flags & CONTACTS
                while left != 0:
                    flag = left & -left
                    left = left - flag
                    contact = contact_of(t, m, flag, x.index, other.index)
                    count, miss = add_contact_rows(t, c, x, other, contact, m.least_overlap_z, reach, count, s, system)
                    missed += miss
    return count, missed


@wp.func(inline=False)
def add_relation_rows(
    t: TablesRef,
    c: Candidate,
    obj: wp.int32,
    reach: wp.float32,
    count: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """Rows of the hard relations of which an object is the subject, under their chosen options."""
    count = int(count)
    missed = float(0.0)
    r0 = t[0].relation_start[c.problem]
    o = c.first_object + obj
    for incidence in range(t[0].incidence_start[o], t[0].incidence_start[o + 1]):
        r = r0 + t[0].incidence[incidence]
        if t[0].incidence_role[incidence] == 0 and t[0].relation_fault[r] != 0 and t[0].relation_rigid[r] == 0:
            ids = t[0].relation_object[r]
            x = relation_poses(t, c.first_object, r, s, c.index, View())
            option = s.options[c.index, r - r0]
            for k in range(t[0].row_start[option], t[0].row_start[option + 1]):
                scale = t[0].row_aim[k][3]
                value, ga = feature(t, k, 0, x)
                gb = wp.vec4(0.0, 0.0, 0.0, 0.0)
                gc = wp.vec4(0.0, 0.0, 0.0, 0.0)
                if ids[1] >= 0:
                    _vb, gb = feature(t, k, 1, x)
                if ids[2] >= 0:
                    _vc, gc = feature(t, k, 2, x)
                hold = t[0].row_hold[k]
                width = (hold[1] - hold[0]) * scale
                for side in range(2):
                    clear = (value - hold[0]) * scale
                    sign = scale
                    if side == 1:
                        clear = (hold[1] - value) * scale
                        sign = -scale
                    if clear < reach:
                        added = int(1)
                        inset = wp.min(SLACK, 0.4 * width)
                        want = inset - clear
                        if clear > 0.1 * inset:
                            want = wp.min(want, 0.0)
                        if count < ROWS:
                            key = KEY_RELATION + 2 * k + side
                            slot = obj * ROWS + count
                            added = add_row(t, c, slot, ids, sign * ga, sign * gb, sign * gc, want, key, s, system)
                            count += added
                        if added > 0:
                            missed += wp.max(-clear, 0.0)
    return count, missed


@wp.kernel
def linearise(
    # Problem:
    b: Problems,
    reach: wp.float32,
    selected: wp.array(dtype=wp.int32),
    # State in:
    live: wp.array(dtype=wp.int32),
    s: State,
    keys: wp.array2d(dtype=wp.int32),
    force: wp.array2d(dtype=wp.float32),
    # State in and out:
    count: wp.array2d(dtype=wp.int32),
    system: InequalitySystem,
    # State out:
    force_out: wp.array2d(dtype=wp.float32),
    missed_out: wp.array2d(dtype=wp.float32),
):
    """Rows of every selected (candidate, object) at the present poses, with the forces that they had before.

    ``keys`` and ``force`` [candidate, slot] are those of the step before. ``missed_out`` is by how much [m] an object's
    terms miss the verdict's limits, without those that nothing free to move can mend.
    """
    t = b.tables
    m = b.margins
    slot, obj = wp.tid()
    candidate = selected[slot]
    if live[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    if obj >= c.objects:
        return
    x = body_of(c, obj, s)
    if not wp.isfinite(x.pose):
        missed_out[candidate, obj] = FAR
        count[candidate, obj] = 0
        return
    n, bounds = add_wall_rows(t, m, c, x, reach, s, system)
    n, bounds = add_fixture_rows(t, m, c, x, reach, n, bounds, s, system)
    n, bounds = add_height_rows(t, m, c, x, reach, n, bounds, s, system)
    n, relations = add_relation_rows(t, c, obj, reach, n, s, system)
    n, pairs = add_pair_rows(t, m, c, x, reach, n, s, system)
    base = obj * ROWS
    before = count[candidate, obj]
    for k in range(n):
        key = system.keys[candidate, base + k]
        warm = float(0.0)
        for i in range(before):
            if keys[candidate, base + i] == key:
                warm = force[candidate, base + i]
        force_out[candidate, base + k] = warm
    count[candidate, obj] = n
    missed_out[candidate, obj] = bounds + relations + pairs
