"""The trials of the search's jobs: drawing poses, and what they cost.

On a GPU a warp rates the trials of one candidate: with as many trials as lanes each lane has its own; with fewer, a
team of lanes shares the terms of one energy. Drawing and rating are kernels of their own, so that the code of each
fits the instruction cache and all warps are at the same place of it.
"""

import warp as wp

from .begin import Plan
from .features import TURN
from .geometry import FAR, wrap
from .groups import group_energy
from .jobs import (
    BACK_STEPS,
    GRADIENT,
    MOVE,
    RETURN,
    SOLVED,
    SQUARE,
    STEP,
    STOP,
    Desk,
    Found,
    alone,
    at_home,
    object_of,
    rates_only,
    trials_of,
    weights_at,
)
from .lanes import index_of, lane, lanes, lowest, number_of, pose_of, sum_of, sum_of_poses, sum_of_team, team_for
from .reading import inline_on_gpu, item
from .sample import QUARTER, propose, uniform
from .tables import Margins, Share, State, TablesRef, View, Weights

# Fast sines on a GPU are good to a few micrometres; the judge gets exact ones (`set_turns`).
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

SHORTER = wp.constant(0.35)  # how much shorter each next gradient step is tried
DRAFTS = wp.constant(0.3)  # share of proposals that take the surfaces laid out anew
STAYS = wp.constant(0.15)  # share of proposals that then leave the object where it is
FAR_AWAY = wp.constant(0.65)  # share of proposals anywhere in the room
FAR_FROM_HOME = wp.constant(0.35)  # the same at home


@wp.func
def off_square(t: TablesRef, p: wp.int32, pose: wp.vec4):
    """By how much a pose is turned against the room's first wall, modulo a quarter."""
    plane = item(t[0].plane, item(t[0].plane_start, p))
    return wrap(pose[3] - wp.atan2(plane[1], plane[0]), QUARTER)


@wp.func
def draw_trials(
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    home: wp.bool,
    p: wp.int32,
    candidate: wp.int32,
    d: Desk,
    first: wp.int32,
    by: wp.int32,
    s: State,
    drawn: wp.array2d(dtype=wp.vec4),
    drafted: wp.array2d(dtype=wp.int32),
):
    """Draw the pose of every ``by``-th trial from ``first``, and whether it takes the draft."""
    old = item(s.poses, candidate, d.obj)
    rng = wp.rand_init(d.seed, first)
    for k in range(first, trials_of(d, 0, plan), by):
        pose = old
        draft = int(0)
        if d.job == MOVE and k > 0:
            anew = bool(True)
            if d.draft != 0:
                u = uniform(rng)
                if u < DRAFTS:
                    draft = 1
                anew = u > STAYS
            if anew:
                near = 0.02 + d.scale * uniform(rng)
                far = wp.where(home, FAR_FROM_HOME, FAR_AWAY)
                pose = propose(t, m, w, p, d.obj, pose, s, candidate, near, far, plan.slide, rng)
        elif d.job == STEP:
            pose = pose + wp.pow(SHORTER, float(k)) * d.step
        elif d.job == SQUARE and k == 0:
            pose[3] = pose[3] - off_square(t, p, pose)
        elif d.job == RETURN:
            back = item(s.anchors, candidate, d.obj) - pose
            back[3] = wrap(back[3], TURN)
            pose = pose + (1.0 - float(k) / float(BACK_STEPS)) * back
        drawn[candidate, k] = pose
        drafted[candidate, k] = draft
    if d.job == MOVE:
        s.stream[candidate, first] = rng


@wp.func
def rate_trials(
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    home: wp.bool,
    p: wp.int32,
    candidate: wp.int32,
    d: Desk,
    s: State,
    drawn: wp.array2d(dtype=wp.vec4),
    drafted: wp.array2d(dtype=wp.int32),
    energy: wp.array2d(dtype=wp.float32),
):
    """Rate all trials of a job, each by a team of lanes. Every lane gets the outcome. The code has no gradients."""
    o0 = item(t[0].object_start, p)
    me = lane()
    count = trials_of(d, item(t[0].object_start, p + 1) - o0, plan)
    team = team_for(count)
    part = Share(me % team, team)
    old = item(s.poses, candidate, d.obj)
    x = Found()
    x.least = FAR
    x.base = FAR
    if d.job == STEP:
        x.base = d.base
    for k in range(me // team, count, lanes() // team):
        who = object_of(t, d, k)
        first = int(d.first)
        last = int(d.last)
        view = View()
        view.best = 1
        view.crowd = 1
        limit = float(FAR)
        if rates_only(d.job):
            first, last = alone(t, o0 + who)
        else:
            view.stamp = d.stamp
            view.draft = item(drafted, candidate, k)
            view.before = old
            view.after = item(drawn, candidate, k)
            view.spin = wp.vec2(wp.cos(view.after[3] - old[3]), wp.sin(view.after[3] - old[3]))
            if (d.job == MOVE and k > 0) or d.job == STEP:
                limit = wp.min(x.least, x.base + d.heat)
        e = float(0.0)
        share = float(0.0)
        soft = float(0.0)
        rating = float(0.0)
        if last > first:
            e, share, soft, _g = group_energy(t, m, w, p, candidate, first, last, s, limit, view, part)
            e = sum_of_team(e, team)
            share = sum_of_team(share, team)
            soft = sum_of_team(soft, team)
            if item(t[0].object_free, o0 + who) != 0:
                rating = e
                if home:  # soft terms are no reason to move anything
                    rating = wp.max(e - soft - SOLVED, 0.0)
        if rates_only(d.job):
            if part.first == 0:
                x.share += share
                x.soft += soft
                energy[candidate, who] = rating
        elif d.job == MOVE and k == 0:
            x.base = e
        elif d.job == RETURN:
            if x.least == FAR and e - soft <= SOLVED:
                x.least = float(k)
                x.pose = view.after
        elif e < x.least:
            x.least = e
            x.index = k
            x.pose = view.after
            x.draft = view.draft
            x.rating = rating
    if lanes() > 1:
        winner = lowest(x.least)
        x.share = sum_of(x.share)
        x.soft = sum_of(x.soft)
        x.base = number_of(x.base, 0)
        x.least = number_of(x.least, winner)
        x.index = index_of(x.index, winner)
        x.pose = pose_of(x.pose, winner)
        x.draft = index_of(x.draft, winner)
        x.rating = number_of(x.rating, winner)
    return x


@wp.func
def find_slope(t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, d: Desk, s: State):
    """The outcome of a job that takes a gradient; all lanes share its terms, and each gets the outcome."""
    first, last = alone(t, item(t[0].object_start, p) + d.obj)
    view = View()
    view.best = 1
    view.crowd = 1
    e, _share, _soft, g = group_energy(t, m, w, p, candidate, first, last, s, FAR, view, Share(lane(), lanes()))
    x = Found()
    x.base = sum_of(e)
    x.gradient = sum_of_poses(g, lanes())
    return x


@wp.kernel(cuda_max_registers=128)  # more warps are worth the spills
def draw(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    clock: wp.array(dtype=wp.int32),
    desk: wp.array(dtype=Desk),
    # State in and out:
    s: State,
    # State out:
    drawn_out: wp.array2d(dtype=wp.vec4),
    drafted_out: wp.array2d(dtype=wp.int32),
    busy_out: wp.array(dtype=wp.int32),
):
    """Draw the poses that are tried, [candidate, drawer]. ``busy_out`` is set to 0."""
    inline_on_gpu()
    candidate, first = wp.tid()
    if candidate == 0 and first == 0:
        busy_out[0] = 0
    if desk[candidate].job < MOVE or desk[candidate].job == STOP:
        return
    home = at_home(plan, clock)
    by = wp.min(1 + plan.proposals, lanes())
    draw_trials(
        t,
        m,
        weights_at(w, home),
        plan,
        home,
        problem[candidate],
        candidate,
        desk[candidate],
        first,
        by,
        s,
        drawn_out,
        drafted_out,
    )


@wp.kernel(cuda_max_registers=128)
def rate(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    clock: wp.array(dtype=wp.int32),
    desk: wp.array(dtype=Desk),
    s: State,
    drawn: wp.array2d(dtype=wp.vec4),
    drafted: wp.array2d(dtype=wp.int32),
    # State out:
    energy_out: wp.array2d(dtype=wp.float32),
    found_out: wp.array(dtype=Found),
):
    """Rate the trials of every candidate's job. A warp a candidate."""
    inline_on_gpu()
    candidate = wp.tid() // lanes()
    if desk[candidate].job == STOP or desk[candidate].job == GRADIENT:
        return
    home = at_home(plan, clock)
    x = rate_trials(
        t,
        m,
        weights_at(w, home),
        plan,
        home,
        problem[candidate],
        candidate,
        desk[candidate],
        s,
        drawn,
        drafted,
        energy_out,
    )
    if lane() == 0:
        found_out[candidate] = x


@wp.kernel
def slope(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    clock: wp.array(dtype=wp.int32),
    desk: wp.array(dtype=Desk),
    s: State,
    # State out:
    found_out: wp.array(dtype=Found),
):
    """Take the gradient where that is a candidate's job. A warp a candidate."""
    inline_on_gpu()
    candidate = wp.tid() // lanes()
    if desk[candidate].job != GRADIENT:
        return
    weights = weights_at(w, at_home(plan, clock))
    x = find_slope(t, m, weights, problem[candidate], candidate, desk[candidate], s)
    if lane() == 0:
        found_out[candidate] = x
