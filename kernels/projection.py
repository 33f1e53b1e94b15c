"""Projection of layouts: the least movement that satisfies linear inequalities, solved again and again.

The movement of a layout is the sum over its roots of dx^2 + dy^2 + dz^2 + (ARM dyaw)^2. With constraints J d >= g its
minimum is d = W^-1 J^T f with forces f >= 0, and Hildreth's method finds them: row by row, each force is set so that
its own row just holds, or to zero. Rows are then taken anew at the layout found (sequential quadratic programming,
with the curvature of the constraints left out), and forces carry over. What no force acts on stays exactly where it is.
"""

import warp as wp

from .bodies import candidate_of, free_part, object_count, root_at
from .geometry import FAR, plane_of, turn
from .groups import set_pose
from .inequality import ARM, ROWS, Inequality, InequalitySystem, mobility
from .tables import Problems, State, TablesRef
from .terms_relations import nearest_option

wp.set_module_options({"enable_backward": False})

STEP = wp.constant(0.5)  # [m] that a root moves freely from one set of rows to the next
FRACTION = wp.constant(0.7)  # of a longer way that it goes
SOFT = wp.constant(1.0e-4)  # give of a row under force, so that rows in conflict do not pull without bounds
STILL = wp.constant(5.0e-5)  # [m] movement below which a layout counts as settled


@wp.struct
class Perturbation:
    """How a try begins: roots within a radius [m] of one in trouble start elsewhere, some of them, so far off [m]."""

    attempt: wp.int32
    radius: wp.float32
    share: wp.float32
    spread: wp.float32


@wp.struct
class NearestLayout:
    """The best layout so far of each candidate: that which misses least, then that which moved least."""

    shift: wp.array2d(dtype=wp.vec4)  # [candidate, object]: how far each root is from its anchor
    lack: wp.array(dtype=wp.float32)  # [candidate]: what it misses [m]
    moved: wp.array(dtype=wp.float32)  # [candidate]: its squared movement
    fault: wp.array2d(dtype=wp.float32)  # [candidate, object]: part of the lack or, if there is none, of the movement


@wp.func(inline=False)
def place(t: TablesRef, o0: wp.int32, candidate: wp.int32, root: wp.int32, d: wp.vec4, s: State):
    """Put a root, with all that it carries, at its anchor moved by d."""
    old = s.anchors[candidate, root]
    q = wp.vec2(wp.cos(d[3]), wp.sin(d[3]))
    for k in range(t[0].member_start[o0 + root], t[0].member_start[o0 + root + 1]):
        i = t[0].member[k]
        child = s.anchors[candidate, i]
        if wp.dot(d, d) == 0.0:
            s.poses[candidate, i] = child  # to the bit, also where its yaw is not wrapped
            s.turns[candidate, i] = wp.vec2(wp.cos(child[3]), wp.sin(child[3]))
        elif i == root:
            set_pose(s, candidate, i, child + d)
        else:
            at = plane_of(old) + plane_of(d) + turn(q, plane_of(child) - plane_of(old))
            set_pose(s, candidate, i, wp.vec4(at[0], at[1], child[2] + d[2], child[3] + d[3]))


@wp.func(inline=False)
def draw_focus(n: wp.int32, candidate: wp.int32, fault: wp.array2d(dtype=wp.float32), u: wp.float32):
    """One of n objects drawn by its weight in ``fault``: u in [0, 1) falls on it when these are laid end to end."""
    total = float(0.0)
    for obj in range(n):
        total += fault[candidate, obj]
    left = u * total
    focus = int(0)
    for obj in range(n):
        f = fault[candidate, obj]
        if f > 0.0 and left >= 0.0:
            focus = obj
            left -= f
    return focus


@wp.func
def movement(d: wp.vec4):
    """Squared movement of a root."""
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + ARM * ARM * d[3] * d[3]


@wp.kernel
def start_try(
    # Problem:
    b: Problems,
    perturbation: Perturbation,
    selected: wp.array(dtype=wp.int32),
    # State in:
    best: NearestLayout,
    # State in and out:
    s: State,
    system: InequalitySystem,
):
    """Put every root where a try begins: where the best layout has it, or off its anchor by chance."""
    t = b.tables
    slot, obj = wp.tid()
    candidate = selected[slot]
    if obj == 0:
        system.live[candidate] = 1
        system.last_step[candidate] = FAR
    system.count[candidate, obj] = 0
    o = root_at(b, candidate, obj)
    if o < 0:
        return
    o0 = o - obj
    d = best.shift[candidate, obj]
    if perturbation.attempt > 0:
        draw = wp.rand_init(int(s.rng[candidate]), perturbation.attempt)
        focus = draw_focus(object_count(t, b.problem[candidate]), candidate, best.fault, wp.randf(draw))
        far = plane_of(s.anchors[candidate, focus]) + plane_of(best.shift[candidate, t[0].object_root[o0 + focus]])
        far -= plane_of(s.anchors[candidate, obj]) + plane_of(d)
        rng = wp.rand_init(int(s.rng[candidate]) + 7919 * perturbation.attempt, obj)
        close = wp.dot(far, far) < perturbation.radius * perturbation.radius
        if close and (obj == t[0].object_root[o0 + focus] or wp.randf(rng) < perturbation.share):
            d = perturbation.spread * wp.vec4(wp.randn(rng), wp.randn(rng), 0.5 * wp.randn(rng), wp.randn(rng))
    d = free_part(t, o, d)
    system.shift[candidate, obj] = d
    place(t, o0, candidate, obj, d, s)


@wp.kernel
def choose_options(
    # Problem:
    b: Problems,
    selected: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
):
    """Give every relation of the selected candidates the option that it is nearest to."""
    slot, rel = wp.tid()
    candidate = selected[slot]
    option = nearest_option(b, candidate, rel, s)
    if option >= 0:
        s.options[candidate, rel] = option


@wp.func
def apply_force(d: wp.array2d(dtype=wp.vec4), candidate: wp.int32, row: Inequality, force: wp.float32):
    """Move what a row is about by a change of its force."""
    for k in range(3):
        if row.body[k] >= 0:
            d[candidate, row.body[k]] = d[candidate, row.body[k]] + force * mobility(row.jacobian[k])


@wp.func(inline=False)
def sweep(candidate: wp.int32, n: wp.int32, backward: wp.int32, system: InequalitySystem):
    """Set the force of every row anew, one after the other; returns the largest violation [m] met on the way."""
    worst = float(0.0)
    for i in range(n):
        obj = i
        if backward == 1:
            obj = n - 1 - i
        for k in range(system.count[candidate, obj]):
            slot = obj * ROWS + k
            row = system.rows[candidate, slot]
            value = float(0.0)
            for body in range(3):
                if row.body[body] >= 0:
                    value += wp.dot(row.jacobian[body], system.scratch[candidate, row.body[body]])
            old = system.force[candidate, slot]
            missing = row.goal - value
            if old > 0.0 or missing > 0.0:
                new = wp.max(old + (missing - SOFT * old) * row.inverse, 0.0)
                worst = wp.max(worst, wp.abs(new - old) / row.inverse)
                system.force[candidate, slot] = new
                apply_force(system.scratch, candidate, row, new - old)
    return worst


@wp.kernel
def project(
    # Problem:
    b: Problems,
    sweeps: wp.int32,
    selected: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    system: InequalitySystem,
    best: NearestLayout,
):
    """Keep a layout that is the best so far, and go on to the least movement that satisfies its rows.

    A candidate that has settled at a feasible layout is no longer live.
    """
    t = b.tables
    candidate = selected[wp.tid()]
    if system.live[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    n = c.objects
    o0 = c.first_object
    miss = float(0.0)
    far = float(0.0)
    for obj in range(n):
        miss += system.missed[candidate, obj]
        if t[0].object_root[o0 + obj] == obj:
            far += movement(system.shift[candidate, obj])
    if miss < best.lack[candidate] or (miss == best.lack[candidate] and far < best.moved[candidate]):
        best.lack[candidate] = miss
        best.moved[candidate] = far
        for obj in range(n):
            best.shift[candidate, obj] = system.shift[candidate, obj]
            best.fault[candidate, obj] = system.missed[candidate, obj]
            if miss == 0.0:
                best.fault[candidate, obj] = movement(system.shift[candidate, obj])
    if miss == 0.0 and (system.last_step[candidate] < STILL or far == 0.0):
        system.live[candidate] = 0
        return
    for obj in range(n):
        system.scratch[candidate, obj] = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for obj in range(n):
        for k in range(system.count[candidate, obj]):
            f = system.force[candidate, obj * ROWS + k]
            if f > 0.0:
                apply_force(system.scratch, candidate, system.rows[candidate, obj * ROWS + k], f)
    for i in range(sweeps):
        if sweep(candidate, n, i & 1, system) < 1.0e-5:
            break
    furthest = float(0.0)
    for obj in range(n):
        if t[0].object_root[o0 + obj] == obj and t[0].object_free[o0 + obj] != 0:
            old = system.shift[candidate, obj]
            new = system.scratch[candidate, obj]
            step = new - old
            length = wp.sqrt(movement(step))
            if length > 0.0:
                if length > STEP:
                    new = old + wp.max(STEP / length, FRACTION) * step
                system.shift[candidate, obj] = new
                place(t, o0, candidate, obj, new, s)
            furthest = wp.max(furthest, length)
    system.last_step[candidate] = furthest


@wp.kernel
def restore(
    # Problem:
    b: Problems,
    # State in:
    best: NearestLayout,
    # State in and out:
    s: State,
):
    """Put every root where the best layout has it."""
    candidate, obj = wp.tid()
    o = root_at(b, candidate, obj)
    if o >= 0:
        place(b.tables, o - obj, candidate, obj, best.shift[candidate, obj], s)
