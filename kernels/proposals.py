"""The proposals of the search's jobs: drawing poses, and what they cost.

On a GPU a warp rates the proposals of one candidate: with as many proposals as lanes each lane has its own; with
fewer, a subwarp of lanes shares the terms of one energy. Drawing and rating are kernels of their own, so that the
code of each fits the instruction cache and all warps are at the same place of it.
"""

import warp as wp

from .array_access import inline_on_gpu, item
from .bodies import Candidate, candidate_of, layout_of
from .features import TURN
from .geometry import FAR, wrap
from .groups import group_energy, is_formation, way_inside
from .jobs import (
    BACK_STEPS,
    SOLVED,
    JobResult,
    Jobs,
    Proposals,
    SearchState,
    object_of,
    problems_at,
    proposal_count,
    queued_candidate,
    rates_only,
    single_body,
)
from .plan import Plan
from .sample import QUARTER, propose, uniform
from .state_machine import GRADIENT, MOVE, RETURN, SQUARE, STEP
from .tables import Problems, State, TablesRef, TermSlice, View
from .warp_primitives import (
    lane_id,
    shfl_float,
    shfl_int,
    shfl_vec4,
    subwarp_size,
    subwarp_sum,
    subwarp_sum_vec4,
    warp_argmin,
    warp_size,
    warp_sum,
)
from .yaw_domain import nearest_yaw

# Fast sines on a GPU are good to a few micrometres; the judge gets exact ones (`set_turns`).
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

SHORTER = wp.constant(0.35)  # how much shorter each next gradient step is tried
DRAFTS = wp.constant(0.3)  # share of proposals that take the surfaces laid out anew
STAYS = wp.constant(0.15)  # share of proposals that then leave the object where it is
FAR_SHARE = wp.constant(0.65)  # share of proposals anywhere in the room
FAR_SHARE_ANCHORED = wp.constant(0.35)  # the same in anchored attempts


@wp.func
def off_square(t: TablesRef, p: wp.int32, pose: wp.vec4):
    """By how much a pose is turned against the room's first wall, modulo a quarter."""
    plane = item(t[0].plane, item(t[0].plane_start, p))
    return wrap(pose[3] - wp.atan2(plane[1], plane[0]), QUARTER)


@wp.func
def draw_proposals(
    b: Problems, plan: Plan, c: Candidate, d: SearchState, first: wp.int32, by: wp.int32, s: State, proposals: Proposals
):
    """Draw the pose of every ``by``-th proposal from ``first``, and whether it takes the draft."""
    t = b.tables
    m = b.margins
    candidate = c.index
    old = item(s.poses, candidate, d.obj)
    rng = wp.rand_init(d.seed, first)
    for k in range(first, proposal_count(d, c, plan), by):
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
                far = wp.where(d.anchored == 1, FAR_SHARE_ANCHORED, FAR_SHARE)
                pose = propose(b, c, d.obj, s, near, far, plan.slide, rng)
                o = c.first_object + d.obj
                if d.last == item(t[0].group_start, o + 1) and is_formation(t, o):
                    way = way_inside(t, c.problem, candidate, d.obj, pose, m.bounds_aim, s)
                    pose = wp.vec4(pose[0] + way[0], pose[1] + way[1], pose[2], pose[3])
        elif d.job == STEP:
            pose = pose + wp.pow(SHORTER, float(k)) * d.step
        elif d.job == SQUARE and k == 0:
            pose[3] = pose[3] - off_square(t, c.problem, pose)
        elif d.job == RETURN:
            back = item(s.anchors, candidate, d.obj) - pose
            back[3] = wrap(back[3], TURN)
            pose = pose + (1.0 - float(k) / float(BACK_STEPS)) * back
        pose[3] = nearest_yaw(t, c.first_object + d.obj, pose[3])
        proposals.poses[candidate, k] = pose
        proposals.drafts[candidate, k] = draft
    if d.job == MOVE:
        s.stream[candidate, first] = rng


@wp.func
def rate_proposals(b: Problems, plan: Plan, c: Candidate, d: SearchState, s: State, proposals: Proposals):
    """Rate all proposals of a job, each by a subwarp. Every lane gets the result. The code has no gradients."""
    t = b.tables
    candidate = c.index
    o0 = c.first_object
    me = lane_id()
    count = proposal_count(d, c, plan)
    subwarp = subwarp_size(count)
    old = item(s.poses, candidate, d.obj)
    layout = layout_of(c, s)
    x = JobResult()
    x.least = FAR
    x.base = FAR
    if d.job == STEP:
        x.base = d.base
    for k in range(me // subwarp, count, warp_size() // subwarp):
        who = object_of(t, d, k)
        first = int(d.first)
        last = int(d.last)
        view = View()
        view.best = 1
        view.crowd = 1
        part = TermSlice(me % subwarp, subwarp, FAR)
        if rates_only(d.job):
            first, last = single_body(t, o0 + who)
        else:
            view.stamp = d.stamp
            view.draft = item(proposals.drafts, candidate, k)
            view.before = old
            view.after = item(proposals.poses, candidate, k)
            view.spin = wp.vec2(wp.cos(view.after[3] - old[3]), wp.sin(view.after[3] - old[3]))
            if (d.job == MOVE and k > 0) or d.job == STEP:
                part.limit = wp.min(x.least, x.base + d.threshold)
        e = float(0.0)
        share = float(0.0)
        soft = float(0.0)
        rating = float(0.0)
        if last > first:
            layout.view = view
            energy_of_group = group_energy(b, layout, first, last, part)
            e = subwarp_sum(energy_of_group.value, subwarp)
            share = subwarp_sum(energy_of_group.share, subwarp)
            soft = subwarp_sum(energy_of_group.soft, subwarp)
            if item(t[0].object_free, o0 + who) != 0:
                rating = e
                if d.anchored == 1:  # soft terms are no reason to move anything
                    rating = float(item(s.released, c.index, who)) * wp.max(e - soft - SOLVED, 0.0)
        if rates_only(d.job):
            if me % subwarp == 0:
                x.share += share
                x.soft += soft
                s.rating[candidate, who] = rating
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
    if warp_size() > 1:
        winner = warp_argmin(x.least)
        x.share = warp_sum(x.share)
        x.soft = warp_sum(x.soft)
        x.base = shfl_float(x.base, 0)
        x.least = shfl_float(x.least, winner)
        x.index = shfl_int(x.index, winner)
        x.pose = shfl_vec4(x.pose, winner)
        x.draft = shfl_int(x.draft, winner)
        x.rating = shfl_float(x.rating, winner)
    return x


@wp.func
def find_gradient(b: Problems, c: Candidate, d: SearchState, s: State):
    """The result of a job that takes a gradient; all lanes share its terms, and each gets the result."""
    first, last = single_body(b.tables, c.first_object + d.obj)
    layout = layout_of(c, s)
    layout.view.best = 1
    layout.view.crowd = 1
    e = group_energy(b, layout, first, last, TermSlice(lane_id(), warp_size(), FAR))
    x = JobResult()
    x.base = warp_sum(e.value)
    x.gradient = subwarp_sum_vec4(e.gradient, warp_size())
    return x


@wp.kernel(cuda_max_registers=128)  # more warps are worth the spills
def draw(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in and out:
    s: State,
    proposals: Proposals,
    jobs: Jobs,
):
    """Draw the poses that are tried, [slot of the queue, drawer], and empty the next queue."""
    inline_on_gpu()
    slot, first = wp.tid()
    if slot == 0 and first == 0:
        jobs.next_queued[0] = 0
    candidate = queued_candidate(jobs, slot)
    if candidate < 0 or jobs.state[candidate].job < MOVE:
        return
    d = jobs.state[candidate]
    by = wp.min(1 + plan.proposals, warp_size())
    draw_proposals(problems_at(b, d), plan, candidate_of(b, candidate), d, first, by, s, proposals)


@wp.kernel(cuda_max_registers=128)
def rate(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    proposals: Proposals,
    # State in and out:
    s: State,
    jobs: Jobs,
):
    """Rate the proposals of every candidate's job. A warp a candidate."""
    inline_on_gpu()
    candidate = queued_candidate(jobs, wp.tid() // warp_size())
    if candidate < 0 or jobs.state[candidate].job == GRADIENT:
        return
    d = jobs.state[candidate]
    x = rate_proposals(problems_at(b, d), plan, candidate_of(b, candidate), d, s, proposals)
    if lane_id() == 0:
        jobs.result[candidate] = x


@wp.kernel
def take_gradients(
    # Problem:
    b: Problems,
    # State in:
    s: State,
    # State in and out:
    jobs: Jobs,
):
    """Take the gradient where that is a candidate's job. A warp a candidate."""
    inline_on_gpu()
    candidate = queued_candidate(jobs, wp.tid() // warp_size())
    if candidate < 0 or jobs.state[candidate].job != GRADIENT:
        return
    d = jobs.state[candidate]
    x = find_gradient(problems_at(b, d), candidate_of(b, candidate), d, s)
    if lane_id() == 0:
        jobs.result[candidate] = x
