"""What comes of a job's proposals, and what the next job is.

A move picks an object in proportion to its energy, and takes the best of some poses drawn for it by the Metropolis
rule with a temperature that falls to zero. Walls and sides are discrete choices: wherever an object is looked at, its
relations choose their best option. A round moves objects until nothing is at fault, then polishes what still is by
gradient steps, and tidies up.
"""

import warp as wp

from .array_access import item, opaque_one
from .cells import change_cell, crowded
from .energy import viewed_pose
from .features import TURN
from .geometry import FAR, wrap
from .groups import members_end, redraw_surfaces, set_pose
from .jobs import (
    FINISHING,
    GRADIENT,
    MOVE,
    MOVING,
    POLISHING,
    RATE,
    RETURN,
    SOLVED,
    SQUARE,
    STEP,
    STOP,
    SURVEY,
    JobResult,
    SearchState,
    is_anchored,
    single_body,
)
from .proposals import off_square
from .starts import Plan
from .tables import FREE_YAW, Margins, State, TablesRef, View, Weights
from .warp_primitives import warp_size

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

LEAST_MOVES = wp.constant(16)  # of a round, however few objects there are
ALMOST_SQUARE = wp.constant(0.2)  # [rad]
STRIDE = wp.constant(0.3)  # [m] longest gradient step


@wp.func
def pick_object(n: wp.int32, candidate: wp.int32, energy: wp.array2d(dtype=wp.float32), u: wp.float32):
    """The object on which a share u of all energies falls, laid end to end; -1 when there is none."""
    total = float(0.0)
    step = opaque_one()
    for i in range(0, n, step):
        total += item(energy, candidate, i)
    left = u * total
    obj = int(-1)
    for i in range(0, n, step):
        e = item(energy, candidate, i)
        if e > 0.0 and left >= 0.0:
            obj = i
            left -= e
    return obj


@wp.func
def next_object(
    t: TablesRef,
    o0: wp.int32,
    n: wp.int32,
    candidate: wp.int32,
    energy: wp.array2d(dtype=wp.float32),
    obj: wp.int32,
    faulty: wp.bool,
):
    """The next free object after this one (of those with energy, if only faulty ones count); n at the end."""
    obj += 1
    while obj < n and (item(t[0].object_free, o0 + obj) == 0 or (faulty and item(energy, candidate, obj) <= SOLVED)):
        obj += 1
    return obj


@wp.func
def initial_state(t: TablesRef, p: wp.int32, candidate: wp.int32, s: State):
    """The state at the start of a round."""
    for obj in range(item(t[0].object_start, p + 1) - item(t[0].object_start, p)):
        s.mark[candidate, obj] = 0
    d = SearchState()
    d.job = SURVEY
    d.phase = MOVING
    d.cursor = -1
    d.rng = item(s.stream, candidate, warp_size())
    return d


@wp.func
def apply_move(t: TablesRef, p: wp.int32, n: wp.int32, candidate: wp.int32, d: SearchState, view: View, s: State):
    """Move the objects of a move to where a view sees them."""
    for k in range(d.first, d.last):
        obj = item(t[0].group, k)
        pose, _q = viewed_pose(s, candidate, obj, view)
        set_pose(s, candidate, obj, pose)
        if crowded(n, s):
            change_cell(t, p, candidate, obj, s)


@wp.func
def decide(
    t: TablesRef,
    plan: Plan,
    round_index: wp.int32,
    anchored: wp.bool,
    p: wp.int32,
    candidate: wp.int32,
    x: JobResult,
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    d: SearchState,
):
    """Act on a job's result, and choose the next job: the state after it."""
    o0 = item(t[0].object_start, p)
    n = item(t[0].object_start, p + 1) - o0
    movable = wp.max(item(t[0].movable, p), 2)
    moves = wp.max(plan.moves * movable, LEAST_MOVES)
    refresh = wp.max(4, movable // 2)
    done = int(d.job)

    # What comes of it.
    moved = bool(False)
    if done == SURVEY:
        d.total = x.share
        hard = x.share - x.soft
        if d.phase == MOVING:
            if hard <= SOLVED:
                d.soft_moves += refresh
                if x.soft <= SOLVED or d.soft_moves > plan.soft_moves * movable or anchored:
                    d.solved = 1
        else:
            d.solved = wp.where(x.share <= SOLVED or (anchored and hard <= SOLVED), 1, 0)
    elif done == GRADIENT:
        d.base = x.base
    elif done == MOVE:
        moved = x.least < x.base + d.threshold
        if moved:
            energy[candidate, d.obj] = x.rating
    elif done == STEP:
        moved = x.least < d.base
    elif done == SQUARE:
        moved = x.index == 0
    elif done == RETURN:
        moved = x.least < FAR
    if moved:
        view = View()
        view.stamp = d.stamp
        view.draft = x.draft
        view.before = item(s.poses, candidate, d.obj)
        view.after = x.pose
        turned = view.after[3] - view.before[3]
        view.spin = wp.vec2(wp.cos(turned), wp.sin(turned))
        apply_move(t, p, n, candidate, d, view, s)

    # What next.
    d.job = STOP
    if d.phase == MOVING:
        if plan.rates != 0 and done == MOVE and moved and d.last > members_end(t, o0 + d.obj):
            d.job = RATE
        elif d.solved != 0:
            d.phase = FINISHING
        elif done != SURVEY and d.move % refresh == 0:
            d.job = SURVEY
        elif d.move >= moves:
            d.phase = POLISHING
        else:
            rng = d.rng
            chosen = pick_object(n, candidate, energy, wp.randf(rng))
            if chosen < 0 and plan.rates == 0 and done != SURVEY:  # what went along with a move was not rated
                d.job = SURVEY
            elif chosen < 0:  # nothing that is free to move is at fault
                d.phase = FINISHING
            else:
                d.job = MOVE
                whole = bool(False)
                u = wp.randf(rng)
                v = wp.randf(rng)
                parent = item(t[0].object_parent, o0 + chosen)
                if parent >= 0 and u < wp.where(anchored, 0.1, 0.25):
                    chosen = parent
                    whole = True
                elif v < plan.whole:
                    whole = True
                d.obj = chosen
                d.first = item(t[0].group_start, o0 + chosen)
                d.last = item(t[0].group_start, o0 + chosen + 1)
                if not whole:
                    d.last = members_end(t, o0 + chosen)
                level = 1.0 - (float(round_index) + float(d.move) / float(moves)) / float(plan.rounds)
                d.scale = 0.4 * level
                d.threshold = 0.0
                if d.soft_moves == 0:
                    temperature = wp.where(anchored, plan.anchored_temperature, plan.temperature)
                    d.threshold = -temperature * level * level * wp.log(wp.randf(rng) + 1.0e-9)
                d.seed = int(2.0e9 * wp.randf(rng))
                d.draft = 0
                if t[0].pool_size > 0:
                    if item(t[0].surface_start, o0 + chosen + 1) > item(t[0].surface_start, o0 + chosen):
                        d.draft = 1
                d.move += 1
            d.rng = rng
    if d.phase == POLISHING:
        d.threshold = 0.0
        arm = 0.3 * item(t[0].object_radius, o0 + d.obj)[0] + 0.05
        g = x.gradient
        scaled = wp.vec4(g[0], g[1], g[2], g[3] / (arm * arm))
        gg = wp.dot(g, scaled)
        if done == SURVEY and d.solved != 0:
            d.phase = FINISHING
            d.cursor = -1
        elif done == GRADIENT and d.base > SOLVED and gg > 1.0e-12:
            d.job = STEP
            size = 1.8 * d.base / gg
            reach = size * wp.sqrt(wp.dot(scaled, wp.vec4(g[0], g[1], g[2], arm * arm * scaled[3])))
            if reach > STRIDE:
                size = size * STRIDE / reach
            d.step = -size * scaled
        elif d.sweep < plan.polish:
            d.job = GRADIENT
            d.cursor = next_object(t, o0, n, candidate, energy, d.cursor, True)
            if d.cursor < n:
                d.obj = d.cursor
            else:
                d.job = SURVEY
                d.cursor = -1
                d.sweep += 1
        elif done != SURVEY:  # the round ends with what it came to
            d.job = SURVEY
    if d.phase == FINISHING:
        d.threshold = 0.0
        d.job = STOP
        walled = item(t[0].plane_start, p + 1) > item(t[0].plane_start, p)
        while d.job == STOP and d.finishing_passes <= wp.where(
            anchored, 1, 0
        ):  # what goes back may clear the way for another
            d.cursor = next_object(t, o0, n, candidate, energy, d.cursor, False)
            if d.cursor >= n:
                d.cursor = -1
                d.finishing_passes += 1
            else:
                d.obj = d.cursor
                pose = item(s.poses, candidate, d.obj)
                if anchored:
                    back = item(s.anchors, candidate, d.obj) - pose
                    back[3] = wrap(back[3], TURN)
                    if wp.dot(back, back) > 1.0e-12:
                        d.job = RETURN
                elif item(t[0].object_free, o0 + d.obj) & FREE_YAW and walled:
                    off = wp.abs(off_square(t, p, pose))
                    if off > 1.0e-6 and off < ALMOST_SQUARE:
                        d.job = SQUARE
    if d.job >= MOVE and d.job != STOP:
        if d.job != MOVE:
            first, last = single_body(t, o0 + d.obj)
            d.first = first
            d.last = last
            d.draft = 0
        d.stamp += 1
        for k in range(d.first, d.last):
            i = item(t[0].group, k)
            carried = item(t[0].object_root, o0 + i) == d.obj
            s.mark[candidate, i] = wp.where(carried, -d.stamp, d.stamp)
            if d.draft != 0:
                s.draft[candidate, i] = item(s.poses, candidate, i)
        if d.draft != 0:
            rng = d.rng
            redraw_surfaces(t, p, d.obj, candidate, int(1.0e9 * wp.randf(rng)), s.draft)
            d.rng = rng
    return d


@wp.func
def finish_round(candidate: wp.int32, d: SearchState, s: State, total_out: wp.array(dtype=wp.float32)):
    """The end of a round."""
    total_out[candidate] = d.total
    s.stream[candidate, warp_size()] = d.rng


@wp.kernel
def start_rounds(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    # State out:
    search_state_out: wp.array(dtype=SearchState),
    busy_out: wp.array(dtype=wp.int32),
):
    """Start a round of every active candidate; the others have nothing to do."""
    candidate = wp.tid()
    if candidate == 0:
        busy_out[0] = 1
    d = SearchState()
    d.job = STOP
    if active[candidate] != 0:
        d = initial_state(t, problem[candidate], candidate, s)
    search_state_out[candidate] = d


@wp.kernel
def advance(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    clock: wp.array(dtype=wp.int32),
    result: wp.array(dtype=JobResult),
    # State in and out:
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    search_state: wp.array(dtype=SearchState),
    # State out:
    total_out: wp.array(dtype=wp.float32),
    busy_out: wp.array(dtype=wp.int32),
):
    """Act on the result of every candidate's job and choose its next. ``busy_out`` becomes 1 if any has one."""
    candidate = wp.tid()
    d = search_state[candidate]
    if d.job == STOP:
        return
    round_index = clock[0] % plan.rounds
    d = decide(
        t, plan, round_index, is_anchored(plan, clock), problem[candidate], candidate, result[candidate], s, energy, d
    )
    search_state[candidate] = d
    if d.job == STOP:
        finish_round(candidate, d, s, total_out)
    else:
        busy_out[0] = 1
