"""Search over one candidate: relation-guided moves of single objects and whole groups, annealed, then a polish.

One thread per candidate. A move picks an object in proportion to its energy, draws some poses for it, and takes the
best by the Metropolis rule with a temperature that falls to zero. Walls and sides are discrete choices: a move sets
them anew for every relation that it touches. Energies are local: a move costs what touches the moved objects.
"""

import warp as wp

from .cells import change_cell, crowded, fill_cells
from .energy import object_energy
from .features import TURN
from .geometry import FAR, perp, plane_of, turn, wrap
from .sample import (
    QUARTER,
    best_option,
    carry,
    keep_inside,
    normal,
    pick,
    random_start,
    set_pose,
    settle,
    uniform,
)
from .tables import FREE_PLANE, FREE_YAW, FREE_Z, Margins, State, TablesRef, Weights

wp.set_module_options({"enable_backward": False})

SOLVED = wp.constant(1.0e-9)
ALMOST_SQUARE = wp.constant(0.2)  # [rad]


@wp.struct
class Budget:
    """Work units of one launch (a round), its place in the attempt, and the temperature [m] at the start."""

    round: wp.int32
    rounds: wp.int32
    moves: wp.int32  # in a round, for each movable object
    proposals: wp.int32
    polish: wp.int32  # gradient sweeps at the end
    linger: wp.int32  # moves for each movable object spent on soft relations once the hard ones hold
    hot: wp.float32
    stay: wp.int32  # 1: keep what is in order where it is, and move the rest as little as it takes
    start: wp.int32  # 0: where the poses are; 1: anywhere; 2: drawn from the relations; 3: the anchors


@wp.func(inline=False)
def copy_group(
    t: TablesRef, p: wp.int32, candidate: wp.int32, first: wp.int32, last: wp.int32, a: State, b: State
):
    """Copy poses and the options of all relations touched, for the objects group[first:last], from a to b."""
    o0 = t[0].object_start[p]
    for k in range(first, last):
        i = t[0].group[k]
        b.poses[candidate, i] = a.poses[candidate, i]
        b.turns[candidate, i] = a.turns[candidate, i]
        for c in range(t[0].touch_start[o0 + i], t[0].touch_start[o0 + i + 1]):
            r = t[0].touch[c]
            b.options[candidate, r] = a.options[candidate, r]


@wp.func
def update_cells(t: TablesRef, p: wp.int32, candidate: wp.int32, first: wp.int32, last: wp.int32, s: State):
    """After a move of the objects group[first:last]: put them into the cells where they stand now."""
    if crowded(t[0].object_start[p + 1] - t[0].object_start[p], s):
        for k in range(first, last):
            change_cell(t, p, candidate, t[0].group[k], s)


@wp.func(inline=False)
def choose_options(
    t: TablesRef, w: Weights, p: wp.int32, candidate: wp.int32, first: wp.int32, last: wp.int32, s: State
):
    """Give every relation that touches the objects group[first:last] its best option."""
    o0 = t[0].object_start[p]
    r0 = t[0].relation_start[p]
    for k in range(first, last):
        o = o0 + t[0].group[k]
        for c in range(t[0].touch_start[o], t[0].touch_start[o + 1]):
            r = t[0].touch[c]
            if t[0].relation_rigid[r0 + r] == 0:
                s.options[candidate, r] = best_option(t, w, o0, r0 + r, s, candidate)


@wp.func(inline=False)
def group_energy(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    first: wp.int32,
    last: wp.int32,
    s: State,
    limit: wp.float32,
    stamp: wp.int32,
):
    """Energy of all terms that touch the objects group[first:last], which carry the stamp, except pairs among them.

    Once it exceeds the limit the rest is left out.
    """
    e = float(0.0)
    for k in range(first, last):
        if e > limit:
            break
        ei, _share, _soft, _g = object_energy(t, m, w, p, candidate, t[0].group[k], s, limit - e, stamp)
        e += ei
    return e


@wp.func(inline=False)
def shuffle(t: TablesRef, p: wp.int32, root: wp.int32, s: State, candidate: wp.int32, key: wp.int32):
    """Lay out the surfaces of a root anew from their pools; the key says which entries."""
    o = t[0].object_start[p] + root
    rng = wp.rand_init(key)
    for d in range(t[0].deck_start[o], t[0].deck_start[o + 1]):
        base = s.poses[candidate, t[0].deck_supporter[d]]
        q = s.turns[candidate, t[0].deck_supporter[d]]
        first = t[0].deck_member_start[d]
        count = t[0].deck_member_start[d + 1] - first
        entry = wp.min(int(wp.randf(rng) * float(t[0].pool_size)), t[0].pool_size - 1)
        for j in range(count):
            local = t[0].pool[t[0].pool_start[d] + entry * count + j]
            at = plane_of(base) + turn(q, plane_of(local))
            pose = wp.vec4(at[0], at[1], base[2] + t[0].deck_height[d], base[3] + local[3])
            set_pose(s, candidate, t[0].deck_member[first + j], pose)


@wp.func(inline=False)
def members_energy(t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, root: wp.int32, s: State):
    """Energy, share, soft share and gradient of a root with all that it carries, as one rigid body."""
    o = t[0].object_start[p] + root
    at = plane_of(s.poses[candidate, root])
    e = float(0.0)
    share = float(0.0)
    soft = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for k in range(t[0].member_start[o], t[0].member_start[o + 1]):
        i = t[0].member[k]
        ei, hi, fi, gi = object_energy(t, m, w, p, candidate, i, s, FAR, 0)
        e += ei
        share += hi
        soft += fi
        arm = perp(plane_of(s.poses[candidate, i]) - at)
        g += wp.vec4(gi[0], gi[1], gi[2], gi[3] + gi[0] * arm[0] + gi[1] * arm[1])
    free = t[0].object_free[o]
    if (free & FREE_PLANE) == 0:
        g[0] = 0.0
        g[1] = 0.0
    if (free & FREE_Z) == 0:
        g[2] = 0.0
    if (free & FREE_YAW) == 0:
        g[3] = 0.0
    return e, share, soft, g


@wp.func(inline=False)
def slide(t: TablesRef, p: wp.int32, obj: wp.int32, s: State, candidate: wp.int32, gap: wp.float32):
    """Slide an object along its own left axis until its box is flush with another's, or with a wall."""
    o0 = t[0].object_start[p]
    o = o0 + obj
    pose = s.poses[candidate, obj]
    q = s.turns[candidate, obj]
    axis = wp.vec2(-q[1], q[0])
    half = 0.5 * t[0].object_size[o][1]
    side = wp.where(uniform(s, candidate) < 0.5, 1.0, -1.0)
    n = t[0].object_start[p + 1] - o0
    step = float(0.0)
    if uniform(s, candidate) < 0.3 or n < 2:
        found = float(1.0e6)
        for k in range(t[0].plane_start[p], t[0].plane_start[p + 1]):
            plane = t[0].plane[k]
            along = side * (plane[0] * axis[0] + plane[1] * axis[1])
            if along < -0.5:
                d = (wp.dot(wp.vec2(plane[0], plane[1]), plane_of(pose)) - plane[2]) / -along - half - gap
                if d < found:
                    found = d
        if found < 1.0e5:
            step = side * found
    else:
        near = float(1.0e12)
        for _try in range(3):
            j = pick(s, candidate, n)
            if t[0].object_root[o0 + j] != obj:
                v = plane_of(s.poses[candidate, j]) - plane_of(pose)
                if wp.dot(v, v) < near:
                    near = wp.dot(v, v)
                    qj = s.turns[candidate, j]
                    size = t[0].object_size[o0 + j]
                    reach = 0.5 * (
                        wp.abs(wp.dot(axis, qj)) * size[0] + wp.abs(wp.dot(axis, perp(qj))) * size[1]
                    )
                    step = wp.dot(axis, v) + side * (half + reach + gap)
    if t[0].object_free[o] & FREE_PLANE:
        s.poses[candidate, obj] = wp.vec4(pose[0] + step * axis[0], pose[1] + step * axis[1], pose[2], pose[3])


@wp.func(inline=False)
def propose(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    obj: wp.int32,
    s: State,
    candidate: wp.int32,
    scale: wp.float32,
    far: wp.float32,
):
    """Draw a new pose for an object into its entry of the state (what it carries stays behind).

    With probability ``far`` it is drawn from the whole room, else within ``scale`` metres.
    """
    u = uniform(s, candidate)
    if u < far:
        set_pose(s, candidate, obj, random_start(t, p, obj, s, candidate))
        settle(t, w, p, obj, s, candidate, 1)
    else:
        free = t[0].object_free[t[0].object_start[p] + obj]
        pose = s.poses[candidate, obj]
        if free & FREE_PLANE:
            pose[0] = pose[0] + scale * normal(s, candidate)
            pose[1] = pose[1] + scale * normal(s, candidate)
        if free & FREE_Z:
            pose[2] = pose[2] + 0.5 * scale * normal(s, candidate)
        if free & FREE_YAW:
            if u > 0.95:
                pose[3] = pose[3] + 1.5707963267948966 * float(1 + pick(s, candidate, 3))
        set_pose(s, candidate, obj, pose)
        settle(t, w, p, obj, s, candidate, 0)
    keep_inside(t, p, obj, s, candidate, m.bounds_aim)
    if uniform(s, candidate) < 0.35:
        slide(t, p, obj, s, candidate, m.collision_aim + 0.001)


@wp.func(inline=False)
def descend(
    t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, root: wp.int32, s: State
):
    """One Polyak step towards zero energy on a root's pose, halved until it helps. Returns the new energy."""
    o = t[0].object_start[p] + root
    e, _share, _soft, g = members_energy(t, m, w, p, candidate, root, s)
    arm = 0.3 * t[0].object_radius[o][0] + 0.05
    scaled = wp.vec4(g[0], g[1], g[2], g[3] / (arm * arm))
    gg = wp.dot(g, scaled)
    if e <= SOLVED or gg < 1.0e-12:
        return e
    first = t[0].group_start[o]
    last = first + t[0].member_start[o + 1] - t[0].member_start[o]
    old = s.poses[candidate, root]
    step = 1.8 * e / gg
    reach = step * wp.sqrt(wp.dot(scaled, wp.vec4(g[0], g[1], g[2], arm * arm * scaled[3])))
    if reach > 0.3:
        step = step * 0.3 / reach
    for _try in range(3):
        carry(t, t[0].object_start[p], s, candidate, root, old - step * scaled, 0)
        en, _share2, _soft2, _g2 = members_energy(t, m, w, p, candidate, root, s)
        if en < e:
            update_cells(t, p, candidate, first, last, s)
            return en
        step = 0.35 * step
    carry(t, t[0].object_start[p], s, candidate, root, old, 0)
    return e


@wp.func(inline=False)
def square_up(t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, root: wp.int32, s: State):
    """Turn an object that stands almost square to the room fully square, unless that costs anything."""
    o = t[0].object_start[p] + root
    if (t[0].object_free[o] & FREE_YAW) == 0 or t[0].plane_start[p + 1] == t[0].plane_start[p]:
        return
    plane = t[0].plane[t[0].plane_start[p]]
    old = s.poses[candidate, root]
    off = wrap(old[3] - wp.atan2(plane[1], plane[0]), QUARTER)
    if wp.abs(off) < 1.0e-6 or wp.abs(off) > ALMOST_SQUARE:
        return
    before, _share, _soft, _g = members_energy(t, m, w, p, candidate, root, s)
    carry(t, t[0].object_start[p], s, candidate, root, wp.vec4(old[0], old[1], old[2], old[3] - off), 0)
    after, _share2, _soft2, _g2 = members_energy(t, m, w, p, candidate, root, s)
    if after > before:
        carry(t, t[0].object_start[p], s, candidate, root, old, 0)


@wp.func(inline=False)
def go_back(t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, root: wp.int32, s: State):
    """Take a root, with all that it carries, as far back to its anchor as costs nothing hard."""
    o0 = t[0].object_start[p]
    o = o0 + root
    old = s.poses[candidate, root]
    d = s.anchors[candidate, root] - old
    d[3] = wrap(d[3], TURN)
    if wp.dot(d, d) < 1.0e-12:
        return
    first = t[0].group_start[o]
    last = first + t[0].member_start[o + 1] - t[0].member_start[o]
    for k in range(4):
        carry(t, o0, s, candidate, root, old + (1.0 - 0.25 * float(k)) * d, 0)
        choose_options(t, w, p, candidate, first, last, s)
        e, _share, soft, _g = members_energy(t, m, w, p, candidate, root, s)
        if e - soft <= SOLVED:
            update_cells(t, p, candidate, first, last, s)
            return
    carry(t, o0, s, candidate, root, old, 0)
    choose_options(t, w, p, candidate, first, last, s)


@wp.func(inline=False)
def survey(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    stay: wp.int32,
):
    """Energy of every root into ``energy``; returns the candidate's total and the soft part of it.

    With stay = 1 soft terms do not count in ``energy``: they are no reason to move anything.
    """
    o0 = t[0].object_start[p]
    total = float(0.0)
    soft = float(0.0)
    for obj in range(t[0].object_start[p + 1] - o0):
        energy[candidate, obj] = 0.0
        if t[0].member_start[o0 + obj + 1] > t[0].member_start[o0 + obj]:
            e, share, f, _g = members_energy(t, m, w, p, candidate, obj, s)
            total += share
            soft += f
            if t[0].object_free[o0 + obj] != 0:
                energy[candidate, obj] = wp.where(stay == 1, wp.max(e - f - SOLVED, 0.0), e)
    return total, soft


@wp.func(inline=False)
def begin(t: TablesRef, m: Margins, w: Weights, p: wp.int32, candidate: wp.int32, s: State, how: wp.int32):
    """Draw every free object anew: anywhere (1), or from its relations, those that place others first (2)."""
    o0 = t[0].object_start[p]
    n = t[0].object_start[p + 1] - o0
    for depth in range(4):
        for obj in range(n):
            if t[0].object_root[o0 + obj] == obj and t[0].object_free[o0 + obj] != 0:
                chain = int(0)
                parent = t[0].object_parent[o0 + obj]
                while parent >= 0 and chain < 3:
                    parent = t[0].object_parent[o0 + parent]
                    chain += 1
                if chain == depth:
                    old = s.poses[candidate, obj]
                    set_pose(s, candidate, obj, random_start(t, p, obj, s, candidate))
                    if how == 2:
                        settle(t, w, p, obj, s, candidate, 1)
                        keep_inside(t, p, obj, s, candidate, m.bounds_aim)
                    pose = s.poses[candidate, obj]
                    set_pose(s, candidate, obj, old)
                    carry(t, o0, s, candidate, obj, pose, 0)
    if t[0].pool_size > 0:
        for obj in range(n):
            if t[0].deck_start[o0 + obj + 1] > t[0].deck_start[o0 + obj]:
                shuffle(t, p, obj, s, candidate, int(uniform(s, candidate) * 1.0e9))


@wp.func(inline=False)
def make_move(
    t: TablesRef,
    m: Margins,
    w: Weights,
    p: wp.int32,
    candidate: wp.int32,
    s: State,
    trial: State,
    energy: wp.array2d(dtype=wp.float32),
    mark: wp.float32,
    heat: wp.float32,
    level: wp.float32,
    proposals: wp.int32,
    stay: wp.int32,
    stamp: wp.int32,
):
    """One move: pick an object, draw poses for it, take the best.

    The mark picks: energies laid end to end, it falls on the object to move, or rather on what that is placed by.
    """
    o0 = t[0].object_start[p]
    left = mark
    obj = int(-1)
    for i in range(t[0].object_start[p + 1] - o0):
        e = energy[candidate, i]
        if e > 0.0 and left >= 0.0:
            obj = i
            left -= e
    parent = t[0].object_parent[o0 + obj]
    whole = int(0)
    if parent >= 0 and uniform(s, candidate) < wp.where(stay == 1, 0.1, 0.25):
        obj = parent
        whole = 1
    elif uniform(s, candidate) < 0.5:
        whole = 1
    o = o0 + obj
    first = t[0].group_start[o]
    last = t[0].group_start[o + 1]
    if whole == 0:
        last = first + t[0].member_start[o + 1] - t[0].member_start[o]
    decks = t[0].pool_size > 0 and t[0].deck_start[o + 1] > t[0].deck_start[o]
    old = s.poses[candidate, obj]
    for k in range(first, last):
        s.mark[candidate, t[0].group[k]] = stamp
    before = group_energy(t, m, w, p, candidate, first, last, s, FAR, stamp)
    bar = before - heat * wp.log(uniform(s, candidate) + 1.0e-9)
    least = bar
    chosen = old
    chosen_key = int(-1)
    for _k in range(proposals):
        key = int(-1)
        pose = old
        if decks and uniform(s, candidate) < 0.3:
            key = int(uniform(s, candidate) * 1.0e9)
        if key < 0 or uniform(s, candidate) < 0.5:
            scale = 0.02 + 0.4 * level * uniform(s, candidate)
            propose(t, m, w, p, obj, trial, candidate, scale, wp.where(stay == 1, 0.35, 0.65))
            pose = trial.poses[candidate, obj]
            set_pose(trial, candidate, obj, old)
        carry(t, o0, trial, candidate, obj, pose, whole)
        if key >= 0:
            shuffle(t, p, obj, trial, candidate, key)
        choose_options(t, w, p, candidate, first, last, trial)
        e = group_energy(t, m, w, p, candidate, first, last, trial, least, stamp)
        if e < least:
            least = e
            chosen = pose
            chosen_key = key
        copy_group(t, p, candidate, first, last, s, trial)
    if least < bar:
        carry(t, o0, s, candidate, obj, chosen, whole)
        if chosen_key >= 0:
            shuffle(t, p, obj, s, candidate, chosen_key)
        choose_options(t, w, p, candidate, first, last, s)
        copy_group(t, p, candidate, first, last, s, trial)
        update_cells(t, p, candidate, first, last, s)
        for k in range(first, last):
            i = t[0].group[k]
            if energy[candidate, i] > 0.0 or i == obj:
                ei, _h, fi, _g = members_energy(t, m, w, p, candidate, i, s)
                energy[candidate, i] = wp.where(stay == 1, wp.max(ei - fi - SOLVED, 0.0), ei)


@wp.kernel
def search(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    budget: Budget,
    problem: wp.array(dtype=wp.int32),
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    trial: State,
    # State out:
    energy_out: wp.array2d(dtype=wp.float32),
    total_out: wp.array(dtype=wp.float32),
):
    """Search each active candidate in place; ``trial`` is scratch of the same shape."""
    candidate = active[wp.tid()]
    p = problem[candidate]
    o0 = t[0].object_start[p]
    n = t[0].object_start[p + 1] - o0
    r0 = t[0].relation_start[p]
    if budget.start == 3:
        for obj in range(n):
            set_pose(s, candidate, obj, s.anchors[candidate, obj])
    elif budget.start > 0:
        begin(t, m, w, p, candidate, s, budget.start)
    for r in range(r0, t[0].relation_start[p + 1]):
        s.options[candidate, r - r0] = best_option(t, w, o0, r, s, candidate)
        trial.options[candidate, r - r0] = s.options[candidate, r - r0]
    for obj in range(n):
        trial.poses[candidate, obj] = s.poses[candidate, obj]
        trial.turns[candidate, obj] = s.turns[candidate, obj]
    fill_cells(t, p, candidate, s)

    movable = wp.max(t[0].movable[p], 2)
    moves = budget.moves * movable
    refresh = wp.max(4, movable // 2)
    total = float(0.0)
    lingered = int(0)
    done = bool(False)
    for move in range(moves):
        if move % refresh == 0:
            all, soft = survey(t, m, w, p, candidate, s, energy_out, budget.stay)
            total = all
            if all - soft <= SOLVED:
                lingered += refresh
                done = soft <= SOLVED or lingered > budget.linger * movable or budget.stay == 1
        sum = float(0.0)
        for obj in range(n):
            sum += energy_out[candidate, obj]
        if done or sum <= 0.0:
            done = True
            break
        level = 1.0 - (float(budget.round) + float(move) / float(moves)) / float(budget.rounds)
        heat = budget.hot * level * level
        if lingered > 0:
            heat = 0.0
        mark = uniform(s, candidate) * sum
        make_move(
            t, m, w, p, candidate, s, trial, energy_out, mark, heat, level, budget.proposals, budget.stay, move + 1
        )
    for _sweep in range(budget.polish):
        if done:
            break
        for obj in range(n):
            if t[0].object_free[o0 + obj] != 0:
                descend(t, m, w, p, candidate, obj, s)
        all, soft = survey(t, m, w, p, candidate, s, energy_out, budget.stay)
        total = all
        done = all <= SOLVED or (budget.stay == 1 and all - soft <= SOLVED)
    if done:
        for _again in range(1 + budget.stay):  # what goes back may clear the way for another
            for obj in range(n):
                if t[0].object_free[o0 + obj] != 0:
                    if budget.stay == 1:
                        go_back(t, m, w, p, candidate, obj, s)
                    else:
                        square_up(t, m, w, p, candidate, obj, s)
    total_out[candidate] = total
