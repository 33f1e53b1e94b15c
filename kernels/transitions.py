"""From one job of the search to the next: the result is applied, and the phase says what event it is.

A move picks an object in proportion to its energy, and takes the best of some poses drawn for it by the Metropolis
rule with a temperature that falls to zero. Walls and sides are discrete choices: wherever an object is looked at, its
relations choose their best option. What event leads to what is in `state_machine.TRANSITIONS`.
"""

import warp as wp

from .array_access import item, opaque_one
from .bodies import Candidate, layout_of, viewed_body
from .cells import change_cell, crowded
from .features import TURN
from .geometry import FAR, wrap
from .groups import members_end, redraw_surfaces, set_pose
from .jobs import SOLVED, JobResult, SearchState, single_body
from .plan import Plan
from .proposals import off_square
from .state_machine import (
    GRADIENT,
    GROUP_MOVED,
    IN_ORDER,
    MOVE,
    MOVES_SPENT,
    MOVING,
    NO_JOB,
    NOTHING_LEFT,
    OBJECT_CHOSEN,
    OFF_ANCHOR,
    OFF_SQUARE,
    POLISHING,
    RETURN,
    SLOPE_FOUND,
    SQUARE,
    STEP,
    STOP,
    SURVEY,
    SURVEY_DUE,
    SWEEPS_SPENT,
    next_job,
    next_phase,
)
from .tables import FREE_YAW, State, TablesRef, View
from .yaw_domain import nearest_yaw

wp.set_module_options({"enable_backward": False})

LEAST_MOVES = wp.constant(16)  # of a round, however few objects there are
ALMOST_SQUARE = wp.constant(0.2)  # [rad]
LONGEST_STEP = wp.constant(0.3)  # [m] along a gradient
EASED = wp.constant(0.1)  # share of their weight that soft relations keep where they give way
LAST = wp.constant(0.25)  # last share of that time, in which they keep nothing


@wp.func
def pick_object(c: Candidate, s: State, u: wp.float32):
    """The object on which a share u of all energies falls, laid end to end; -1 when there is none."""
    total = float(0.0)
    step = opaque_one()
    for i in range(0, c.objects, step):
        total += item(s.rating, c.index, i)
    left = u * total
    obj = int(-1)
    for i in range(0, c.objects, step):
        e = item(s.rating, c.index, i)
        if e > 0.0 and left >= 0.0:
            obj = i
            left -= e
    return obj


@wp.func
def mixing_moves(plan: Plan, movable: wp.int32, round: wp.int32):
    """How many moves of objects picked at random a round begins with."""
    return wp.where(round == 0, int(wp.ceil(plan.mixing * float(movable))), 0)


@wp.func
def pick_any(t: TablesRef, c: Candidate, u: wp.float32):
    """The first object that may move from a share u of all objects on; -1 when there is none."""
    first = wp.min(int(u * float(c.objects)), c.objects - 1)
    for k in range(0, c.objects, opaque_one()):
        obj = (first + k) % c.objects
        if item(t[0].object_free, c.first_object + obj) != 0:
            return obj
    return -1


@wp.func
def may_move(t: TablesRef, c: Candidate, d: SearchState, s: State):
    """True when the attempt may move all objects of a move."""
    if d.anchored == 1:
        for k in range(d.first, d.last):
            if item(s.released, c.index, item(t[0].object_root, c.first_object + item(t[0].group, k))) == 0:
                return False
    return True


@wp.func
def next_object(t: TablesRef, c: Candidate, s: State, obj: wp.int32, faulty: wp.bool):
    """The next free object after this one, of those with energy if only faulty ones count; ``c.objects`` at the end."""
    obj += 1
    while obj < c.objects and (
        item(t[0].object_free, c.first_object + obj) == 0 or (faulty and item(s.rating, c.index, obj) <= SOLVED)
    ):
        obj += 1
    return obj


@wp.func
def movable_of(t: TablesRef, c: Candidate):
    """How many roots may move, at least two; budgets are counted in these."""
    return wp.max(item(t[0].movable, c.problem), 2)


@wp.func
def moves_of(t: TablesRef, plan: Plan, c: Candidate, round: wp.int32):
    """How many moves a round has."""
    movable = movable_of(t, c)
    return wp.max(plan.moves * movable, LEAST_MOVES) + mixing_moves(plan, movable, round)


@wp.func
def temperature_level(t: TablesRef, plan: Plan, c: Candidate, d: SearchState):
    """What is left of an attempt: from 1 to 0."""
    return 1.0 - (float(d.round) + float(d.move) / float(moves_of(t, plan, c, d.round))) / float(plan.rounds)


@wp.func
def apply_move(t: TablesRef, c: Candidate, x: JobResult, d: SearchState, s: State):
    """Put the objects of a move where its best proposal has them."""
    layout = layout_of(c, s)
    view = View()
    view.stamp = d.stamp
    view.draft = x.draft
    view.before = item(s.poses, c.index, d.obj)
    view.after = x.pose
    turned = view.after[3] - view.before[3]
    view.spin = wp.vec2(wp.cos(turned), wp.sin(turned))
    layout.view = view
    for k in range(d.first, d.last):
        obj = item(t[0].group, k)
        pose = viewed_body(layout, obj).pose
        pose[3] = nearest_yaw(t, c.first_object + obj, pose[3])
        set_pose(s, c.index, obj, pose)
        if crowded(c.objects, s):
            change_cell(t, c.problem, c.index, obj, s)


@wp.func
def apply_result(t: TablesRef, plan: Plan, c: Candidate, x: JobResult, s: State, d: SearchState):
    """Take in the result of the job that was done: the state after it, and whether something has moved."""
    movable = movable_of(t, c)
    moved = bool(False)
    if d.job == SURVEY:
        d.total = x.share
        hard = x.share - x.soft
        d.hard = hard
        if d.phase == MOVING:
            if hard <= SOLVED:
                d.soft_moves += wp.max(4, movable // 2)
                if x.soft <= SOLVED or d.soft_moves > plan.soft_moves * movable or d.anchored == 1 or d.soft == 0.0:
                    d.solved = 1
            else:
                level = temperature_level(t, plan, c, d)
                if level <= d.late:
                    d.soft = wp.where(level <= LAST * d.late, 0.0, EASED)
        else:
            d.solved = wp.where(x.share <= SOLVED or ((d.anchored == 1 or d.soft < 1.0) and hard <= SOLVED), 1, 0)
    elif d.job == GRADIENT:
        d.base = x.base
    elif d.job == MOVE:
        moved = x.least < x.base + d.threshold
        if moved:
            s.rating[c.index, d.obj] = x.rating
    elif d.job == STEP:
        moved = x.least < d.base
    elif d.job == SQUARE:
        moved = x.index == 0
    elif d.job == RETURN:
        moved = x.least < FAR
    if moved:
        apply_move(t, c, x, d, s)
    return d, moved


@wp.func
def choose_move(t: TablesRef, plan: Plan, c: Candidate, chosen: wp.int32, s: State, d: SearchState):
    """Set up the move of an object: who goes along, how near the proposals are and what they may cost."""
    rng = d.rng
    whole = bool(False)
    u = wp.randf(rng)
    v = wp.randf(rng)
    parent = item(t[0].object_parent, c.first_object + chosen)
    if d.anchored == 1 and parent >= 0 and item(s.released, c.index, parent) == 0:
        parent = -1
    if parent >= 0 and u < wp.where(d.anchored == 1, 0.1, 0.25):
        chosen = parent
        whole = True
        if d.anchored == 0 and u < 0.125:  # all of a row, a run or a grid
            while item(t[0].object_parent, c.first_object + chosen) >= 0:
                chosen = item(t[0].object_parent, c.first_object + chosen)
    elif v < plan.whole:
        whole = True
    o = c.first_object + chosen
    d.obj = chosen
    d.first = item(t[0].group_start, o)
    d.last = item(t[0].group_start, o + 1)
    if not whole or not may_move(t, c, d, s):
        d.last = members_end(t, o)
    level = temperature_level(t, plan, c, d)
    d.scale = 0.4 * level
    d.threshold = 0.0
    if d.soft_moves == 0:
        temperature = wp.where(d.anchored == 1, plan.anchored_temperature, plan.temperature)
        d.threshold = -temperature * level * level * wp.log(wp.randf(rng) + 1.0e-9)
    d.seed = int(2.0e9 * wp.randf(rng))
    d.draft = 0
    if t[0].pool_size > 0 and item(t[0].surface_start, o + 1) > item(t[0].surface_start, o):
        d.draft = 1
    d.move += 1
    d.rng = rng
    return d


@wp.func
def moving_event(t: TablesRef, plan: Plan, c: Candidate, done: wp.int32, moved: wp.bool, s: State, d: SearchState):
    """What comes next while objects move: the state, and the event."""
    movable = movable_of(t, c)
    mixing = mixing_moves(plan, movable, d.round)
    moves = moves_of(t, plan, c, d.round)
    event = int(IN_ORDER)
    if d.move < mixing:
        rng = d.rng
        chosen = pick_any(t, c, wp.randf(rng))
        d.rng = rng
        if chosen >= 0:
            event = OBJECT_CHOSEN
            d = choose_move(t, plan, c, chosen, s, d)
    elif mixing > 0 and d.move == mixing and done != SURVEY:
        event = SURVEY_DUE
    elif plan.rates != 0 and done == MOVE and moved and d.last > members_end(t, c.first_object + d.obj):
        event = GROUP_MOVED
    elif d.solved == 0:
        if done != SURVEY and d.move % wp.max(4, movable // 2) == 0:
            event = SURVEY_DUE
        elif d.move >= moves:
            event = MOVES_SPENT
        else:
            rng = d.rng
            chosen = pick_object(c, s, wp.randf(rng))
            d.rng = rng
            if chosen >= 0:
                event = OBJECT_CHOSEN
                d = choose_move(t, plan, c, chosen, s, d)
            elif plan.rates == 0 and done != SURVEY:  # what went along with a move was not rated
                event = SURVEY_DUE
    return d, event


@wp.func
def polishing_event(t: TablesRef, plan: Plan, c: Candidate, done: wp.int32, g: wp.vec4, s: State, d: SearchState):
    """What comes next while objects take gradient steps, g is the gradient last found: the state, and the event."""
    arm = 0.3 * item(t[0].object_radius, c.first_object + d.obj)[0] + 0.05
    scaled = wp.vec4(g[0], g[1], g[2], g[3] / (arm * arm))
    gg = wp.dot(g, scaled)
    event = int(SWEEPS_SPENT)
    if done == SURVEY and d.solved != 0:
        event = IN_ORDER
    elif done == GRADIENT and d.base > SOLVED and gg > 1.0e-12:
        event = SLOPE_FOUND
        size = 1.8 * d.base / gg
        reach = size * wp.sqrt(wp.dot(scaled, wp.vec4(g[0], g[1], g[2], arm * arm * scaled[3])))
        if reach > LONGEST_STEP:
            size = size * LONGEST_STEP / reach
        d.step = -size * scaled
    elif d.sweep < plan.polish:
        event = OBJECT_CHOSEN
        d.cursor = next_object(t, c, s, d.cursor, True)
        if d.cursor < c.objects:
            d.obj = d.cursor
        else:
            event = SURVEY_DUE
            d.cursor = -1
            d.sweep += 1
    elif done != SURVEY:  # the round ends with what it came to
        event = SURVEY_DUE
    return d, event


@wp.func
def finishing_event(t: TablesRef, c: Candidate, s: State, d: SearchState):
    """What comes next while objects go back or square up: the state, and the event."""
    walled = item(t[0].plane_start, c.problem + 1) > item(t[0].plane_start, c.problem)
    event = int(NOTHING_LEFT)
    passes = wp.where(d.anchored == 1, 1, 0)  # what goes back may clear the way for another
    while event == NOTHING_LEFT and d.finishing_passes <= passes:
        d.cursor = next_object(t, c, s, d.cursor, False)
        if d.cursor >= c.objects:
            d.cursor = -1
            d.finishing_passes += 1
        else:
            d.obj = d.cursor
            pose = item(s.poses, c.index, d.obj)
            if d.anchored == 1:
                back = item(s.anchors, c.index, d.obj) - pose
                back[3] = wrap(back[3], TURN)
                if wp.dot(back, back) > 1.0e-12:
                    event = OFF_ANCHOR
            elif item(t[0].object_free, c.first_object + d.obj) & FREE_YAW and walled:
                off = wp.abs(off_square(t, c.problem, pose))
                if off > 1.0e-6 and off < ALMOST_SQUARE:
                    event = OFF_SQUARE
    return d, event


@wp.func
def mark_movers(t: TablesRef, c: Candidate, s: State, d: SearchState):
    """Mark the objects that the next job moves, and lay out their surfaces anew where it may take such a draft."""
    if d.job != MOVE:
        first, last = single_body(t, c.first_object + d.obj)
        d.first = first
        d.last = last
        d.draft = 0
    d.stamp += 1
    for k in range(d.first, d.last):
        i = item(t[0].group, k)
        carried = item(t[0].object_root, c.first_object + i) == d.obj
        s.mark[c.index, i] = wp.where(carried, -d.stamp, d.stamp)
        if d.draft != 0:
            s.draft[c.index, i] = item(s.poses, c.index, i)
    if d.draft != 0:
        rng = d.rng
        redraw_surfaces(t, c.problem, d.obj, c.index, int(1.0e9 * wp.randf(rng)), s.draft)
        d.rng = rng
    return d


@wp.func
def transition(t: TablesRef, plan: Plan, c: Candidate, x: JobResult, s: State, d: SearchState):
    """Apply a job's result and choose the next job: the state after it."""
    done = int(d.job)
    d, moved = apply_result(t, plan, c, x, s, d)
    d.job = NO_JOB
    while d.job == NO_JOB:
        event = int(NOTHING_LEFT)
        if d.phase == MOVING:
            d, event = moving_event(t, plan, c, done, moved, s, d)
        elif d.phase == POLISHING:
            d, event = polishing_event(t, plan, c, done, x.gradient, s, d)
        else:
            d, event = finishing_event(t, c, s, d)
        d.job = next_job(d.phase, event)
        d.phase = next_phase(d.phase, event)
        if d.job == NO_JOB:  # a phase begins
            d.cursor = -1
            d.threshold = 0.0
            if d.soft < 1.0:
                d.soft = 0.0
    if d.job >= MOVE and d.job != STOP:
        d = mark_movers(t, c, s, d)
    return d
