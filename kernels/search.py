"""Search over one candidate: relation-guided moves of single objects and whole groups, annealed, then a polish.

A move picks an object in proportion to its energy, draws some poses for it, and takes the best by the Metropolis rule
with a temperature that falls to zero. Walls and sides are discrete choices: wherever an object is looked at, its
relations choose their best option. Energies are local: a move costs what touches the moved objects.

On a GPU a warp works on one candidate: its lanes try poses side by side, or look at objects side by side. The kernel
is one loop over *jobs*, each a number of *trials*; a trial is the energy of some objects as a `View` sees them. That
keeps the lanes together, and the energy, which is most of the code, in one place.
"""

import warp as wp

from .begin import GIVEN, Plan
from .cells import change_cell, crowded
from .energy import seen
from .features import TURN
from .geometry import FAR, wrap
from .groups import group_energy, members_end, set_pose, shuffle
from .lanes import index_of, lane, lanes, lowest, meet, number_of, pose_of, sum_of, team_for
from .reading import item, one
from .sample import QUARTER, propose, uniform
from .tables import FREE_YAW, Margins, Share, State, TablesRef, View, Weights

# Fast sines on a GPU are good to a few micrometres; the judge gets exact ones (`set_turns`).
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

SOLVED = wp.constant(1.0e-9)
LEAST_MOVES = wp.constant(16)  # of a round, however few objects there are
ALMOST_SQUARE = wp.constant(0.2)  # [rad]
STRIDE = wp.constant(0.3)  # [m] longest gradient step
SHORTER = wp.constant(0.35)  # how much shorter each next gradient step is tried
BACK_STEPS = wp.constant(4)  # shares of the way back that are tried

# Jobs.
SURVEY = wp.constant(0)  # rate every object
RATE = wp.constant(1)  # rate the objects of the group that has just moved, if they are not one body
MOVE = wp.constant(2)  # what the objects to be moved cost where they are, and proposals
GRADIENT = wp.constant(3)  # of one object
STEP = wp.constant(4)  # along it: a Polyak step towards zero energy, and shorter ones
SQUARE = wp.constant(5)  # turn what stands almost square to the room fully square, unless that costs anything
RETURN = wp.constant(6)  # take an object as far back to its anchor as costs nothing hard
STOP = wp.constant(7)

# Phases of a round.
MOVING = wp.constant(0)
POLISHING = wp.constant(1)
TIDYING = wp.constant(2)


@wp.func
def pick_object(n: wp.int32, candidate: wp.int32, energy: wp.array2d(dtype=wp.float32), u: wp.float32):
    """The object on which a share u of all energies falls, laid end to end; -1 when there is none."""
    sum = float(0.0)
    step = one()
    for i in range(0, n, step):
        sum += item(energy, candidate, i)
    left = u * sum
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
def off_square(t: TablesRef, p: wp.int32, pose: wp.vec4):
    """By how much a pose is turned against the room's first wall, modulo a quarter."""
    plane = item(t[0].plane, item(t[0].plane_start, p))
    return wrap(pose[3] - wp.atan2(plane[1], plane[0]), QUARTER)


@wp.kernel
def search(
    # Problem:
    t: TablesRef,
    m: Margins,
    w_given: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    open: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    # State out:
    total_out: wp.array(dtype=wp.float32),
):
    """Search each open candidate in place for one round. A warp a candidate."""
    candidate = wp.tid() // lanes()
    me = lane()
    width = lanes()
    if open[candidate] == 0:
        return
    p = problem[candidate]
    o0 = item(t[0].object_start, p)
    n = item(t[0].object_start, p + 1) - o0
    round = clock[0] % plan.rounds
    stay = plan.start == GIVEN and clock[0] // plan.rounds < plan.at_home
    w = w_given
    if not stay:
        w.pull = 0.0
    hot = wp.where(stay, plan.hot_at_home, plan.hot)
    dice = item(s.stream, candidate, width)  # the candidate's own stream, the same in all lanes
    for obj in range(me, n, width):
        s.mark[candidate, obj] = 0
    meet()

    walled = item(t[0].plane_start, p + 1) > item(t[0].plane_start, p)
    movable = wp.max(item(t[0].movable, p), 2)
    moves = wp.max(plan.moves * movable, LEAST_MOVES)
    refresh = wp.max(4, movable // 2)
    phase = int(MOVING)
    move = int(0)
    lingered = int(0)
    sweep = int(0)
    tidied = int(0)  # passes
    solved = bool(False)
    total = float(0.0)
    obj = int(0)
    cursor = int(-1)  # where polishing or tidying is among the objects
    first = int(0)  # the range of its group that goes along
    last = int(0)
    stamp = int(0)
    heat = float(0.0)  # how much a move may cost
    scale = float(0.0)
    draft = bool(False)
    base = float(0.0)  # energy that a step has to beat
    step = wp.vec4(0.0, 0.0, 0.0, 0.0)
    job = int(SURVEY)
    while job != STOP:
        count = int(1)
        if job == SURVEY:
            count = n
        elif job == RATE:
            count = last - first
        elif job == MOVE:
            count = 1 + plan.proposals
            base = FAR
        elif job == STEP:
            count = plan.tries
        elif job == SQUARE:
            count = 2
        elif job == RETURN:
            count = BACK_STEPS

        # The trials, each by a team of lanes.
        team = team_for(count)
        part = Share(me % team, team)
        old = item(s.poses, candidate, obj)
        share_sum = float(0.0)
        soft_sum = float(0.0)
        least = float(FAR)
        least_k = int(0)
        least_pose = old
        least_draft = int(0)
        least_rating = float(0.0)
        g = wp.vec4(0.0, 0.0, 0.0, 0.0)
        for k in range(me // team, count, width // team):
            who = int(obj)
            if job == SURVEY:
                who = k
            elif job == RATE:
                who = item(t[0].group, first + k)
            pose = item(s.poses, candidate, who)
            view = View()
            view.best = 1
            if job == MOVE and k > 0:
                anew = bool(True)
                if draft:
                    u = uniform(s, candidate)
                    if u < 0.3:
                        view.draft = 1
                    anew = u > 0.15
                if anew:
                    near = 0.02 + scale * uniform(s, candidate)
                    pose = propose(t, m, w, p, obj, pose, s, candidate, near, wp.where(stay, 0.35, 0.65))
            elif job == STEP:
                pose = pose + wp.pow(SHORTER, float(k)) * step
            elif job == SQUARE and k == 0:
                pose[3] = pose[3] - off_square(t, p, pose)
            elif job == RETURN:
                d = item(s.anchors, candidate, obj) - pose
                d[3] = wrap(d[3], TURN)
                pose = pose + (1.0 - float(k) / float(BACK_STEPS)) * d
            from_k = int(first)
            to_k = int(last)
            if job == SURVEY or job == RATE:
                from_k = item(t[0].group_start, o0 + who)
                to_k = members_end(t, o0 + who)
            elif job != GRADIENT:
                view.stamp = stamp
                view.before = old
                view.after = pose
                view.spin = wp.vec2(wp.cos(pose[3] - old[3]), wp.sin(pose[3] - old[3]))
            limit = float(FAR)
            if (job == MOVE and k > 0) or job == STEP:
                limit = wp.min(least, base + heat)
            e = float(0.0)
            share = float(0.0)
            soft = float(0.0)
            if to_k > from_k:
                e, share, soft, g = group_energy(t, m, w, p, candidate, from_k, to_k, s, limit, view, part)
            rating = float(0.0)
            if to_k > from_k and item(t[0].object_free, o0 + who) != 0:
                rating = e
                if stay:  # soft terms are no reason to move anything
                    rating = wp.max(e - soft - SOLVED, 0.0)
            if job == SURVEY or job == RATE:
                if part.first == 0:
                    share_sum += share
                    soft_sum += soft
                    energy[candidate, who] = rating
            elif job == GRADIENT or (job == MOVE and k == 0):
                base = e
            elif job == RETURN:
                if least == FAR and e - soft <= SOLVED:
                    least = float(k)
                    least_pose = pose
            elif e < least:
                least = e
                least_k = k
                least_pose = pose
                least_draft = view.draft
                least_rating = rating

        # What comes of them.
        moved = bool(False)
        if job == SURVEY:
            total = sum_of(share_sum)
            soft_total = sum_of(soft_sum)
            if phase == MOVING:
                if total - soft_total <= SOLVED:
                    lingered += refresh
                    solved = soft_total <= SOLVED or lingered > plan.linger * movable or stay
            else:
                solved = total <= SOLVED or (stay and total - soft_total <= SOLVED)
        elif job == MOVE or job >= STEP:
            winner = lowest(least)
            least = number_of(least, winner)
            if job == MOVE:
                base = number_of(base, 0)
                moved = least < base + heat
                rating = number_of(least_rating, winner)
                if moved and me == 0:
                    energy[candidate, obj] = rating
            elif job == STEP:
                moved = least < base
            elif job == SQUARE:
                moved = index_of(least_k, winner) == 0
            else:
                moved = least < FAR
            if moved:
                view = View()
                view.stamp = stamp
                view.before = old
                view.after = pose_of(least_pose, winner)
                view.draft = index_of(least_draft, winner)
                turned = view.after[3] - old[3]
                view.spin = wp.vec2(wp.cos(turned), wp.sin(turned))
                for k in range(first + me, last, width):
                    pose, _q = seen(s, candidate, item(t[0].group, k), view)
                    set_pose(s, candidate, item(t[0].group, k), pose)
                if crowded(n, s):
                    meet()
                    if me == 0:
                        for k in range(first, last):
                            change_cell(t, p, candidate, item(t[0].group, k), s)
        meet()

        # What next.
        done = int(job)
        if phase == MOVING:
            if done == MOVE and moved and last > members_end(t, o0 + obj):
                job = RATE
            elif solved:
                phase = TIDYING
            elif done != SURVEY and move % refresh == 0:
                job = SURVEY
            elif move >= moves:
                phase = POLISHING
            else:
                job = MOVE
                chosen = pick_object(n, candidate, energy, wp.randf(dice))
                if chosen < 0:  # nothing that is free to move is at fault
                    phase = TIDYING
                else:
                    obj = chosen
                    whole = bool(False)
                    u = wp.randf(dice)
                    v = wp.randf(dice)
                    if item(t[0].object_parent, o0 + obj) >= 0 and u < wp.where(stay, 0.1, 0.25):
                        obj = item(t[0].object_parent, o0 + obj)
                        whole = True
                    elif v < 0.5:
                        whole = True
                    first = item(t[0].group_start, o0 + obj)
                    last = item(t[0].group_start, o0 + obj + 1)
                    if not whole:
                        last = members_end(t, o0 + obj)
                    level = 1.0 - (float(round) + float(move) / float(moves)) / float(plan.rounds)
                    scale = 0.4 * level
                    heat = float(0.0)
                    if lingered == 0:
                        heat = -hot * level * level * wp.log(wp.randf(dice) + 1.0e-9)
                    # lanes of a team have to draw the same pose
                    slot = me // team_for(1 + plan.proposals)
                    s.stream[candidate, me] = wp.rand_init(int(2.0e9 * wp.randf(dice)), slot)
                    draft = t[0].pool_size > 0 and item(t[0].deck_start, o0 + obj + 1) > item(t[0].deck_start, o0 + obj)
                    move += 1
        if phase == POLISHING:
            heat = float(0.0)
            arm = 0.3 * item(t[0].object_radius, o0 + obj)[0] + 0.05
            scaled = wp.vec4(g[0], g[1], g[2], g[3] / (arm * arm))
            gg = wp.dot(g, scaled)
            if done == SURVEY and solved:
                phase = TIDYING
                cursor = -1
            elif done == GRADIENT and base > SOLVED and gg > 1.0e-12:
                job = STEP
                size = 1.8 * base / gg
                reach = size * wp.sqrt(wp.dot(scaled, wp.vec4(g[0], g[1], g[2], arm * arm * scaled[3])))
                if reach > STRIDE:
                    size = size * STRIDE / reach
                step = -size * scaled
            elif sweep >= plan.polish:
                job = STOP
            else:
                job = GRADIENT
                cursor = next_object(t, o0, n, candidate, energy, cursor, True)
                if cursor < n:
                    obj = cursor
                else:
                    job = SURVEY
                    cursor = -1
                    sweep += 1
        if phase == TIDYING:
            heat = float(0.0)
            job = STOP
            while job == STOP and tidied <= wp.where(stay, 1, 0):  # what goes back may clear the way for another
                cursor = next_object(t, o0, n, candidate, energy, cursor, False)
                if cursor < n:
                    obj = cursor
                if cursor >= n:
                    cursor = -1
                    tidied += 1
                elif stay:
                    d = item(s.anchors, candidate, obj) - item(s.poses, candidate, obj)
                    d[3] = wrap(d[3], TURN)
                    if wp.dot(d, d) > 1.0e-12:
                        job = RETURN
                elif item(t[0].object_free, o0 + obj) & FREE_YAW and walled:
                    off = wp.abs(off_square(t, p, item(s.poses, candidate, obj)))
                    if off > 1.0e-6 and off < ALMOST_SQUARE:
                        job = SQUARE
        if job >= MOVE and job != STOP:
            if job != MOVE:
                first = item(t[0].group_start, o0 + obj)
                last = members_end(t, o0 + obj)
                draft = False
            stamp += 1
            for k in range(first + me, last, width):
                i = item(t[0].group, k)
                carried = item(t[0].object_root, o0 + i) == obj
                s.mark[candidate, i] = wp.where(carried, -stamp, stamp)
                if draft:
                    s.draft[candidate, i] = item(s.poses, candidate, i)
            if draft:
                meet()
                key = int(1.0e9 * wp.randf(dice))
                if me == 0:
                    shuffle(t, p, obj, candidate, key, s.draft)
        meet()  # what was read above the next job's trials may write
    if me == 0:
        total_out[candidate] = total
        s.stream[candidate, width] = dice
