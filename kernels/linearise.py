"""Feasibility near a layout as linear inequalities: bounds, openings, hard relations, collisions and zones.

The functions that add rows take the count so far and return the count with theirs.
"""

import warp as wp

from .bodies import Body, Candidate, body_of, candidate_of, fixture_body, layout_of
from .contacts import add_contact_rows, nearest_vertices, no_vertices
from .features import feature
from .geometry import FAR, perp, plane_of, turn, turn_back
from .inequality import ROWS, SLACK, SURE, InequalitySystem, Jacobian, RowCount, add_own_row, add_row, wanting
from .tables import FREE_Z, PAIR_RIGID, Problems, State, TablesRef
from .terms_contacts import CONTACTS, FIXTURE, contact_of, meets_fixture, reach_of_pair
from .terms_relations import relation_of

wp.set_module_options({"enable_backward": False})

# Keys of rows; a contact's is face * 32768 + vertex.
KEY_FLOOR = wp.constant(-1)
KEY_CEILING = wp.constant(-2)
KEY_WALL = wp.constant(-3)  # less half plane * 32768 + vertex
KEY_RELATION = wp.constant(1073741824)  # plus twice the row of tables, plus the side


@wp.func(inline=False)
def add_wall_rows(b: Problems, c: Candidate, x: Body, n: RowCount, s: State, system: InequalitySystem):
    """Rows that keep an object inside the walls."""
    t = b.tables
    hold = b.margins.bounds_hold
    at = plane_of(x.pose)
    for k in range(t[0].plane_start[c.problem], t[0].plane_start[c.problem + 1]):
        plane = t[0].plane[k]
        normal = wp.vec2(plane[0], plane[1])
        depth = wp.dot(normal, at) - plane[2]
        if depth - t[0].object_radius[x.index][0] < system.reach:
            nearest = no_vertices()
            for f in range(t[0].footprint_start[x.index], t[0].footprint_start[x.index + 1]):
                nearest = nearest_vertices(t, t[0].footprint[f], turn_back(x.turn, normal), depth, nearest)
            mobile = int(0)
            for i in range(2):
                v = wp.where(i == 0, nearest.lowest, nearest.second)
                d = wp.where(i == 0, nearest.low, nearest.next)
                if n.count >= ROWS:
                    mobile = 1
                elif v >= 0 and d < system.reach:
                    g = wp.vec4(normal[0], normal[1], 0.0, wp.dot(normal, perp(turn(x.turn, t[0].vertex[v]))))
                    key = KEY_WALL - (k * 32768 + v)
                    added = add_own_row(
                        t, c, x.obj, x.obj * ROWS + n.count, g, wanting(d, hold, system), key, s, system
                    )
                    n.count += added
                    mobile += added
            if mobile > 0:
                n.missed += wp.max(hold + SURE - nearest.low, 0.0)
    return n


@wp.func(inline=False)
def add_fixture_rows(b: Problems, c: Candidate, x: Body, n: RowCount, s: State, system: InequalitySystem):
    """Rows that keep an object out of the room's outside and of openings."""
    t = b.tables
    for k in range(t[0].fixture_start[c.problem], t[0].fixture_start[c.problem + 1]):
        disc = t[0].prism_disc[t[0].fixture[k]]
        to = wp.vec2(disc[0], disc[1]) - plane_of(x.pose)
        far = disc[2] + t[0].object_radius[x.index][0] + system.reach
        if wp.dot(to, to) < far * far and meets_fixture(t, x.index, k):
            n = add_contact_rows(b, c, x, fixture_body(k), contact_of(b, FIXTURE, x.index, k), n, s, system)
    return n


@wp.func(inline=False)
def add_height_rows(b: Problems, c: Candidate, x: Body, n: RowCount, s: State, system: InequalitySystem):
    """Rows that keep an object above the floor and below the ceiling."""
    t = b.tables
    if t[0].object_free[x.index] & FREE_Z:
        z = t[0].object_z[x.index]
        for side in range(2):
            clear = x.pose[2] + z[0]
            rise = float(1.0)
            key = KEY_FLOOR
            if side == 1:
                clear = t[0].room_height[c.problem] - z[1] - x.pose[2]
                rise = -1.0
                key = KEY_CEILING
            n.missed += wp.max(b.margins.bounds_hold - clear, 0.0)
            if clear < system.reach and n.count < ROWS:
                g = wp.vec4(0.0, 0.0, rise, 0.0)
                want = wanting(clear, b.margins.bounds_hold, system)
                n.count += add_own_row(t, c, x.obj, x.obj * ROWS + n.count, g, want, key, s, system)
    return n


@wp.func(inline=False)
def add_pair_rows(b: Problems, c: Candidate, x: Body, n: RowCount, s: State, system: InequalitySystem):
    """Rows of the pairs that an object looks after: solids apart, and out of hard zones.

    Of two objects the first looks after the pair when their indices are both even or both odd, else the second, so
    that threads of one candidate have like work.
    """
    t = b.tables
    for j in range(c.objects):
        ours = ((x.obj + j) & 1) == 0
        if j < x.obj:
            ours = not ours
        flags = int(t[0].pair_flags[t[0].pair_start[c.problem] + x.obj * c.objects + j])
        if ours and flags != 0 and (flags & PAIR_RIGID) == 0:
            other = body_of(c, j, s)
            v = plane_of(other.pose) - plane_of(x.pose)
            far = reach_of_pair(t, x.index, other.index) + system.reach
            if wp.dot(v, v) < far * far:
                left = flags & CONTACTS
                while left != 0:
                    flag = left & -left
                    left = left - flag
                    n = add_contact_rows(b, c, x, other, contact_of(b, flag, x.index, other.index), n, s, system)
    return n


@wp.func(inline=False)
def add_relation_rows(t: TablesRef, c: Candidate, subject: Body, n: RowCount, s: State, system: InequalitySystem):
    """Rows of the hard relations of which an object is the subject, under their chosen options."""
    r0 = t[0].relation_start[c.problem]
    for incidence in range(t[0].incidence_start[subject.index], t[0].incidence_start[subject.index + 1]):
        r = r0 + t[0].incidence[incidence]
        if t[0].incidence_role[incidence] == 0 and t[0].relation_fault[r] != 0 and t[0].relation_rigid[r] == 0:
            ids = t[0].relation_object[r]
            x = relation_of(t, layout_of(c, s), r)
            option = s.options[c.index, r - r0]
            for k in range(t[0].row_start[option], t[0].row_start[option + 1]):
                scale = t[0].row_aim[k][3]
                value, ga = feature(t, k, 0, x)
                g = Jacobian()
                g[0] = ga
                if ids[1] >= 0:
                    _vb, gb = feature(t, k, 1, x)
                    g[1] = gb
                if ids[2] >= 0:
                    _vc, gc = feature(t, k, 2, x)
                    g[2] = gc
                hold = t[0].row_hold[k]
                width = (hold[1] - hold[0]) * scale
                for side in range(2):
                    clear = (value - hold[0]) * scale
                    sign = scale
                    if side == 1:
                        clear = (hold[1] - value) * scale
                        sign = -scale
                    if clear < system.reach:
                        added = int(1)
                        inset = wp.min(SLACK, 0.4 * width)
                        want = inset - clear
                        if clear > 0.1 * inset and system.plain == 0:
                            want = wp.min(want, 0.0)
                        if n.count < ROWS:
                            key = KEY_RELATION + 2 * k + side
                            slot = subject.obj * ROWS + n.count
                            added = add_row(t, c, slot, ids, sign * g, want, key, s, system)
                            n.count += added
                        if added > 0:
                            n.missed += wp.max(-clear, 0.0)
    return n


@wp.kernel
def linearise(
    # Problem:
    b: Problems,
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State in and out:
    system: InequalitySystem,
):
    """Rows of every selected (candidate, object) at the present poses, with the forces that they had before."""
    slot, obj = wp.tid()
    candidate = selected[slot]
    if system.live[candidate] == 0 or system.cut[0] != 0:
        return
    c = candidate_of(b, candidate)
    if obj >= c.objects:
        return
    x = body_of(c, obj, s)
    if not wp.isfinite(x.pose):
        system.missed[candidate, obj] = FAR
        system.count[candidate, obj] = 0
        return
    n = RowCount()
    n = add_wall_rows(b, c, x, n, s, system)
    n = add_fixture_rows(b, c, x, n, s, system)
    n = add_height_rows(b, c, x, n, s, system)
    n = add_relation_rows(b.tables, c, x, n, s, system)
    n = add_pair_rows(b, c, x, n, s, system)
    base = obj * ROWS
    for k in range(n.count):
        warm = float(0.0)
        for i in range(system.count[candidate, obj]):
            if system.last_keys[candidate, base + i] == system.keys[candidate, base + k]:
                warm = system.last_force[candidate, base + i]
        system.force[candidate, base + k] = warm
    system.count[candidate, obj] = n.count
    system.missed[candidate, obj] = n.missed
