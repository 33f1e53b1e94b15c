"""Projection of layouts: the least movement that satisfies linear inequalities, solved again and again.

The movement of a layout is the sum over its roots of dx^2 + dy^2 + dz^2 + (ARM dyaw)^2. With constraints J d >= g its
minimum is d = W^-1 J^T f with forces f >= 0, and Hildreth's method finds them: row by row, each force is set so that
its own row just holds, or to zero. Rows are then taken anew at the layout found (sequential quadratic programming,
with the curvature of the constraints left out), and forces carry over. What no force acts on stays exactly where it is.
"""

import warp as wp

from .bodies import free_part, object_count, root_at
from .geometry import FAR, plane_of, turn
from .groups import set_pose
from .inequality import ARM, ROWS, Inequality, mobility
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
def draw_focus(t: TablesRef, p: wp.int32, candidate: wp.int32, fault: wp.array2d(dtype=wp.float32), u: wp.float32):
    """An object drawn by its weight in ``fault``: u in [0, 1) falls on it when the weights are laid end to end."""
    n = object_count(t, p)
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
    best: wp.array2d(dtype=wp.vec4),
    fault: wp.array2d(dtype=wp.float32),
    # State in and out:
    s: State,
    # State out:
    shift_out: wp.array2d(dtype=wp.vec4),
    count_out: wp.array2d(dtype=wp.int32),
    live_out: wp.array(dtype=wp.int32),
    last_step_out: wp.array(dtype=wp.float32),
):
    """Put every root where a try begins: where the best layout has it, or off its anchor by chance."""
    t = b.tables
    slot, obj = wp.tid()
    candidate = selected[slot]
    p = b.problem[candidate]
    o0 = t[0].object_start[p]
    if obj == 0:
        live_out[candidate] = 1
        last_step_out[candidate] = FAR
    if obj >= t[0].object_start[p + 1] - o0:
        return
    count_out[candidate, obj] = 0
    o = o0 + obj
    if t[0].object_root[o] != obj:
        return
    d = best[candidate, obj]
    if perturbation.attempt > 0:
        draw = wp.rand_init(int(s.rng[candidate]), perturbation.attempt)
        focus = draw_focus(t, p, candidate, fault, wp.randf(draw))
        far = plane_of(s.anchors[candidate, focus]) + plane_of(best[candidate, t[0].object_root[o0 + focus]])
        far -= plane_of(s.anchors[candidate, obj]) + plane_of(d)
        rng = wp.rand_init(int(s.rng[candidate]) + 7919 * perturbation.attempt, obj)
        close = wp.dot(far, far) < perturbation.radius * perturbation.radius
        if close and (obj == t[0].object_root[o0 + focus] or wp.randf(rng) < perturbation.share):
            d = perturbation.spread * wp.vec4(wp.randn(rng), wp.randn(rng), 0.5 * wp.randn(rng), wp.randn(rng))
    d = free_part(t, o, d)
    shift_out[candidate, obj] = d
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
    d[candidate, row.body[0]] = d[candidate, row.body[0]] + force * mobility(row.first)
    if row.body[1] >= 0:
        d[candidate, row.body[1]] = d[candidate, row.body[1]] + force * mobility(row.second)
    if row.body[2] >= 0:
        d[candidate, row.body[2]] = d[candidate, row.body[2]] + force * mobility(row.third)


@wp.func(inline=False)
def sweep(
    t: TablesRef,
    candidate: wp.int32,
    n: wp.int32,
    backward: wp.int32,
    count: wp.array2d(dtype=wp.int32),
    rows: wp.array2d(dtype=Inequality),
    force: wp.array2d(dtype=wp.float32),
    d: wp.array2d(dtype=wp.vec4),
):
    """Set the force of every row anew, one after the other; returns the largest violation [m] met on the way."""
    worst = float(0.0)
    for i in range(n):
        obj = i
        if backward == 1:
            obj = n - 1 - i
        for k in range(count[candidate, obj]):
            slot = obj * ROWS + k
            row = rows[candidate, slot]
            value = wp.dot(row.first, d[candidate, row.body[0]])
            if row.body[1] >= 0:
                value += wp.dot(row.second, d[candidate, row.body[1]])
            if row.body[2] >= 0:
                value += wp.dot(row.third, d[candidate, row.body[2]])
            old = force[candidate, slot]
            missing = row.goal - value
            if old > 0.0 or missing > 0.0:
                new = wp.max(old + (missing - SOFT * old) * row.inverse, 0.0)
                worst = wp.max(worst, wp.abs(new - old) / row.inverse)
                force[candidate, slot] = new
                apply_force(d, candidate, row, new - old)
    return worst


@wp.kernel
def project(
    # Problem:
    b: Problems,
    sweeps: wp.int32,
    selected: wp.array(dtype=wp.int32),
    # State in:
    count: wp.array2d(dtype=wp.int32),
    rows: wp.array2d(dtype=Inequality),
    missed: wp.array2d(dtype=wp.float32),
    # State in and out:
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    force: wp.array2d(dtype=wp.float32),
    d: wp.array2d(dtype=wp.vec4),
    best: wp.array2d(dtype=wp.vec4),
    lack: wp.array(dtype=wp.float32),
    moved: wp.array(dtype=wp.float32),
    fault: wp.array2d(dtype=wp.float32),
    last_step: wp.array(dtype=wp.float32),
    live: wp.array(dtype=wp.int32),
):
    """Keep a layout that is the best so far, and go on to the least movement that satisfies its rows.

    Of the best layout so far ``lack`` [candidate] is what it misses [m], ``moved`` its squared movement, and ``fault``
    [candidate, object] each object's part of the lack or, where there is none, of the movement. ``d`` is scratch,
    ``last_step`` how far the last step went. A candidate that has settled at a feasible layout is no longer live.
    """
    t = b.tables
    candidate = selected[wp.tid()]
    if live[candidate] == 0:
        return
    p = b.problem[candidate]
    o0 = t[0].object_start[p]
    n = object_count(t, p)
    miss = float(0.0)
    far = float(0.0)
    for obj in range(n):
        miss += missed[candidate, obj]
        if t[0].object_root[o0 + obj] == obj:
            far += movement(shift[candidate, obj])
    if miss < lack[candidate] or (miss == lack[candidate] and far < moved[candidate]):
        lack[candidate] = miss
        moved[candidate] = far
        for obj in range(n):
            best[candidate, obj] = shift[candidate, obj]
            fault[candidate, obj] = missed[candidate, obj]
            if miss == 0.0:
                fault[candidate, obj] = movement(shift[candidate, obj])
    if miss == 0.0 and (last_step[candidate] < STILL or far == 0.0):
        live[candidate] = 0
        return
    for obj in range(n):
        d[candidate, obj] = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for obj in range(n):
        for k in range(count[candidate, obj]):
            f = force[candidate, obj * ROWS + k]
            if f > 0.0:
                apply_force(d, candidate, rows[candidate, obj * ROWS + k], f)
    for i in range(sweeps):
        worst = sweep(t, candidate, n, i & 1, count, rows, force, d)
        if worst < 1.0e-5:
            break
    furthest = float(0.0)
    for obj in range(n):
        if t[0].object_root[o0 + obj] == obj and t[0].object_free[o0 + obj] != 0:
            old = shift[candidate, obj]
            step = d[candidate, obj] - old
            length = wp.sqrt(movement(step))
            if length > 0.0:
                new = d[candidate, obj]
                if length > STEP:
                    new = old + wp.max(STEP / length, FRACTION) * step
                shift[candidate, obj] = new
                place(t, o0, candidate, obj, new, s)
            furthest = wp.max(furthest, length)
    last_step[candidate] = furthest


@wp.kernel
def restore(
    # Problem:
    b: Problems,
    # State in:
    best: wp.array2d(dtype=wp.vec4),
    # State in and out:
    s: State,
):
    """Put every root where the best layout has it."""
    t = b.tables
    candidate, obj = wp.tid()
    o = root_at(b, candidate, obj)
    if o >= 0:
        place(t, o - obj, candidate, obj, best[candidate, obj], s)
