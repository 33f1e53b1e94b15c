"""Annealing of an objective over valid layouts: a move that would break anything hard is never taken.

A move takes one or two bodies (a root with what it carries, often with all that it places) elsewhere. What the
objective and soft relations gain decides first, by the Metropolis rule; then the verdict's own predicates look at what
moved. So a layout that was valid stays valid, and soft things never win over hard ones. One thread per candidate.
"""

from typing import TYPE_CHECKING

import warp as wp

from .array_access import item, item_strided
from .bodies import Candidate, body_of, candidate_of, layout_of
from .geometry import plane_of, turn
from .groups import members_end, set_pose
from .objective import Objective, pin_of, term_value
from .sample import QUARTER, normal, pick, propose, uniform
from .tables import FREE_PLANE, FREE_TURNS, FREE_YAW, FREE_Z, Problems, State, Table, TablesRef, struct_of
from .terms_contacts import reach_of_pair
from .terms_relations import ALL_RELATIONS, relation_energy, relation_of
from .verdict import contacts_hold, relation_holds, room_holds
from .yaw_domain import yaw_at, yaw_count

wp.set_module_options({"enable_backward": False})

TRIALS = wp.constant(48)
"""Moves whose gain or loss tells how hot an annealing begins."""

ANNEALING = (
    Table("active", ("candidate",), wp.int32, "", "1: the layout is valid, and annealed"),
    Table("rng", ("candidate",), wp.uint32, "", "random stream"),
    Table("root", ("root",), wp.int32, "", "roots that may move"),
    Table("value", ("candidate", "term"), wp.float32, "", "of each term at the present poses"),
    Table("fresh", ("candidate", "term"), wp.float32, "", "of each term after the move that is tried"),
    Table("stamp", ("candidate", "term"), wp.int32, "", "the last move that changed the term"),
    Table("back", ("candidate", "object"), wp.vec4, "m, rad", "poses before the move"),
    Table("best", ("candidate", "object"), wp.vec4, "m, rad", "poses of the lowest total so far"),
    Table("total", ("candidate",), wp.float32, "", "objective and soft relations at the present poses"),
    Table("least", ("candidate",), wp.float32, "", "of the best"),
    Table("over", ("candidate",), wp.float32, "m", "how far a packing reaches out of the room"),
    Table("heat", ("candidate",), wp.float32, "", "mean gain or loss of the first moves"),
)

if TYPE_CHECKING:
    from .tables import Arrays

    class Annealing(Arrays):
        """As below."""
else:
    Annealing = struct_of("Annealing", "Where annealings stand, see ANNEALING.", ANNEALING)


@wp.struct
class Cooling:
    """How an annealing goes: moves in all, share of the first moves' mean change that it begins and ends with."""

    moves: wp.int32
    hot: wp.float32
    cold: wp.float32
    soft: wp.float32  # what a metre of a soft relation's energy costs


@wp.struct
class Move:
    """Two bodies (ranges of the groups' list; the second may be empty) and where their roots go."""

    first: wp.vec2i
    second: wp.vec2i
    root: wp.int32
    other: wp.int32
    pose: wp.vec4
    other_pose: wp.vec4


@wp.func
def body_range(t: TablesRef, o: wp.int32, whole: wp.bool):
    """A root with what it carries, or with all that it places as well, in the list of groups."""
    first = item(t[0].group_start, o)
    if whole:
        return wp.vec2i(first, item(t[0].group_start, o + 1))
    return wp.vec2i(first, members_end(t, o))


@wp.func
def aimed_at(b: Problems, obj: Objective, c: Candidate, s: State, root: wp.int32, rng: wp.ref[wp.uint32]):
    """Where another member of one of the root's terms is; where the root is, if there is none."""
    t = b.tables
    here = plane_of(item_strided(s.poses, c.index, root))
    g = item(t[0].group_start, c.first_object + root)
    i = item(t[0].group, g + pick(rng, members_end(t, c.first_object + root) - g))
    first = item(obj.incidence_start, i)
    count = item(obj.incidence_start, i + 1) - first
    if count == 0:
        return here
    term = item(obj.incidence, first + pick(rng, count))
    k = item(obj.member_start, term)
    at = pin_of(obj, c, s, k + pick(rng, item(obj.member_start, term + 1) - k)).at
    return wp.vec2(at[0], at[1])


@wp.func
def elsewhere(
    b: Problems, o: Objective, c: Candidate, s: State, root: wp.int32, scale: wp.float32, rng: wp.ref[wp.uint32]
):
    """A pose for a root: shifted, turned by quarters, towards what its terms are about, or drawn from its relations."""
    t = b.tables
    pose = item_strided(s.poses, c.index, root)
    free = item(t[0].object_free, c.first_object + root)
    u = uniform(rng)
    if u < 0.15:  # as the search does
        return propose(b, c, root, s, scale, 0.3, 0.3, rng)
    if u < 0.3 and (free & FREE_YAW) != 0:
        pose[3] = pose[3] + QUARTER * float(1 + pick(rng, 3))
        if u < 0.2:
            return pose
    if u < 0.3 and (free & FREE_TURNS) != 0:
        pose[3] = yaw_at(t, c.first_object + root, pick(rng, yaw_count(t, c.first_object + root)))
        if u < 0.2:
            return pose
    if (free & FREE_PLANE) != 0:
        if u > 0.8:
            way = aimed_at(b, o, c, s, root, rng) - plane_of(pose)
            share = uniform(rng)
            if uniform(rng) < 0.5:
                share = share * wp.min(scale, 1.0)
            step = share * way
            q = item_strided(s.turns, c.index, root)
            if uniform(rng) < 0.5:  # along one axis, so that it may slide along what is beside it
                if uniform(rng) < 0.5:
                    q = wp.vec2(-q[1], q[0])
                step = wp.dot(step, q) * q
            return pose + wp.vec4(step[0], step[1], 0.0, 0.0)
        d = scale * normal(rng)
        q = item_strided(s.turns, c.index, root)
        v = uniform(rng)
        if v < 0.4:
            return pose + wp.vec4(-q[1] * d, q[0] * d, 0.0, 0.0)
        if v < 0.8:
            return pose + wp.vec4(q[0] * d, q[1] * d, 0.0, 0.0)
        pose = pose + wp.vec4(d, scale * normal(rng), 0.0, 0.0)
    if (free & FREE_Z) != 0 and u > 0.75:
        pose[2] = pose[2] + 0.3 * scale * normal(rng)
    return pose


@wp.func
def place_body(b: Problems, c: Candidate, s: State, run: Annealing, bodies: wp.vec2i, mark: wp.int32, after: wp.vec4):
    """Take a body to where its root is at a pose; where its members were is kept."""
    t = b.tables
    candidate = c.index
    before = item_strided(s.poses, candidate, item(t[0].group, bodies[0]))
    spin = wp.vec2(wp.cos(after[3] - before[3]), wp.sin(after[3] - before[3]))
    for k in range(bodies[0], bodies[1]):
        i = item(t[0].group, k)
        pose = item_strided(s.poses, candidate, i)
        run.back[candidate, i] = pose
        s.mark[candidate, i] = mark
        at = plane_of(after) + turn(spin, plane_of(pose) - plane_of(before))
        set_pose(s, candidate, i, wp.vec4(at[0], at[1], pose[2] + after[2] - before[2], pose[3] + after[3] - before[3]))


@wp.func
def take_back(b: Problems, c: Candidate, s: State, run: Annealing, bodies: wp.vec2i):
    """Put a body back."""
    for k in range(bodies[0], bodies[1]):
        i = item(b.tables[0].group, k)
        set_pose(s, c.index, i, run.back[c.index, i])


@wp.func
def unmark(b: Problems, c: Candidate, s: State, bodies: wp.vec2i):
    """Forget what moved."""
    for k in range(bodies[0], bodies[1]):
        s.mark[c.index, item(b.tables[0].group, k)] = 0


@wp.func
def leads(t: TablesRef, c: Candidate, s: State, r: wp.int32, i: wp.int32):
    """Whether of what moved object i is the first that takes part in relation r (global): each is looked at once."""
    ids = item(t[0].relation_object, r)
    if ids[0] == i:
        return True
    if ids[0] >= 0 and item(s.mark, c.index, ids[0]) != 0:
        return False
    if ids[1] == i:
        return True
    return not (ids[1] >= 0 and item(s.mark, c.index, ids[1]) != 0)


@wp.func
def soft_energy(b: Problems, c: Candidate, s: State, bodies: wp.vec2i):
    """Energy of the soft relations of what moved; ``mark`` says what that is."""
    t = b.tables
    layout = layout_of(c, s)
    layout.view.best = 1
    r0 = item(t[0].relation_start, c.problem)
    total = float(0.0)
    for k in range(bodies[0], bodies[1]):
        i = item(t[0].group, k)
        o = c.first_object + i
        for n in range(item(t[0].incidence_start, o), item(t[0].incidence_start, o + 1)):
            rel = item(t[0].incidence, n)
            if item(t[0].relation_fault, r0 + rel) == 0 and leads(t, c, s, r0 + rel, i):
                e, _g = relation_energy(b, layout, rel, 0, ALL_RELATIONS)
                total += e
    return total


@wp.func
def all_soft(b: Problems, c: Candidate, s: State):
    """Energy of all soft relations."""
    t = b.tables
    layout = layout_of(c, s)
    layout.view.best = 1
    r0 = item(t[0].relation_start, c.problem)
    total = float(0.0)
    for r in range(r0, item(t[0].relation_start, c.problem + 1)):
        if item(t[0].relation_fault, r) == 0:
            e, _g = relation_energy(b, layout, r - r0, 0, ALL_RELATIONS)
            total += e
    return total


@wp.func
def changed_terms(b: Problems, o: Objective, c: Candidate, s: State, run: Annealing, bodies: wp.vec2i, stamp: wp.int32):
    """By how much the terms of a body change, those that are not looked at yet in this move."""
    t = b.tables
    candidate = c.index
    total = float(0.0)
    for k in range(bodies[0], bodies[1]):
        i = item(t[0].group, k)
        for n in range(item(o.incidence_start, i), item(o.incidence_start, i + 1)):
            term = item(o.incidence, n)
            if item(run.stamp, candidate, term) != stamp:
                run.stamp[candidate, term] = stamp
                value = term_value(t, o, c, s, term)
                run.fresh[candidate, term] = value
                total += value - item(run.value, candidate, term)
    return total


@wp.func
def take_terms(b: Problems, o: Objective, c: Candidate, run: Annealing, bodies: wp.vec2i):
    """Make the values after a move the present ones."""
    for k in range(bodies[0], bodies[1]):
        i = item(b.tables[0].group, k)
        for n in range(item(o.incidence_start, i), item(o.incidence_start, i + 1)):
            term = item(o.incidence, n)
            run.value[c.index, term] = item(run.fresh, c.index, term)


@wp.func(inline=False)
def body_holds(b: Problems, c: Candidate, s: State, bodies: wp.vec2i):
    """Whether the verdict has nothing against what moved: the room, all other bodies, hard relations."""
    t = b.tables
    r0 = item(t[0].relation_start, c.problem)
    for k in range(bodies[0], bodies[1]):
        i = item(t[0].group, k)
        x = body_of(c, i, s)
        if not wp.isfinite(x.pose):
            return False
        if not room_holds(b, c.problem, x):
            return False
        mark = item(s.mark, c.index, i)
        row = item(t[0].pair_start, c.problem) + i * c.objects
        for j in range(c.objects):
            flags = int(item(t[0].pair_flags, row + j))
            if flags != 0 and item(s.mark, c.index, j) != mark:
                other = body_of(c, j, s)
                v = plane_of(other.pose) - plane_of(x.pose)
                far = reach_of_pair(t, x.index, other.index)
                if wp.dot(v, v) < far * far:
                    if not contacts_hold(b, flags, x, other):
                        return False
        o = c.first_object + i
        for n in range(item(t[0].incidence_start, o), item(t[0].incidence_start, o + 1)):
            r = r0 + item(t[0].incidence, n)
            if item(t[0].relation_fault, r) != 0:
                if leads(t, c, s, r, i):
                    if not relation_holds(t, r, relation_of(t, layout_of(c, s), r)):
                        return False
    return True


@wp.func
def new_move(
    b: Problems, o: Objective, c: Candidate, s: State, run: Annealing, scale: wp.float32, rng: wp.ref[wp.uint32]
):
    """Draw a move: one body elsewhere, or two that change places."""
    t = b.tables
    roots = run.root.shape[0]
    x = Move()
    x.root = item(run.root, pick(rng, roots))
    x.first = body_range(t, c.first_object + x.root, uniform(rng) < 0.6)
    x.other = -1
    if roots > 1 and uniform(rng) < 0.2:
        j = item(run.root, pick(rng, roots))
        mine = item(t[0].object_free, c.first_object + x.root)
        both = mine & item(t[0].object_free, c.first_object + j)
        if j != x.root and (both & FREE_PLANE) != 0:
            x.first = body_range(t, c.first_object + x.root, False)
            x.second = body_range(t, c.first_object + j, False)
            x.other = j
            x.pose = item_strided(s.poses, c.index, x.root)
            x.other_pose = item_strided(s.poses, c.index, j)
            here = plane_of(x.pose)
            yaw = x.pose[3]
            turns = float(pick(rng, 4))
            if (both & FREE_YAW) == 0:
                turns = 0.0
            elif uniform(rng) < 0.5:  # each stands as the other did
                x.pose[3] = x.other_pose[3]
                x.other_pose[3] = yaw
                turns = 0.0
            x.pose = wp.vec4(x.other_pose[0], x.other_pose[1], x.pose[2], x.pose[3] + QUARTER * turns)
            x.other_pose = wp.vec4(here[0], here[1], x.other_pose[2], x.other_pose[3])
            return x
    x.pose = elsewhere(b, o, c, s, x.root, scale, rng)
    return x


@wp.kernel
def begin_annealing(
    # Problem:
    b: Problems,
    o: Objective,
    cooling: Cooling,
    # State in and out:
    s: State,
    run: Annealing,
):
    """What the layouts are worth as they stand."""
    candidate = wp.tid()
    c = candidate_of(b, candidate)
    total = float(0.0)
    for term in range(o.terms):
        value = term_value(b.tables, o, c, s, term)
        run.value[candidate, term] = value
        run.stamp[candidate, term] = -1
        total += value
    if cooling.soft > 0.0:
        total += cooling.soft * all_soft(b, c, s)
    run.total[candidate] = total
    run.least[candidate] = total
    run.heat[candidate] = 0.0
    for obj in range(c.objects):
        s.mark[candidate, obj] = 0
        run.best[candidate, obj] = s.poses[candidate, obj]


@wp.kernel
def anneal(
    # Problem:
    b: Problems,
    o: Objective,
    cooling: Cooling,
    first: wp.int32,
    last: wp.int32,
    # State in and out:
    s: State,
    run: Annealing,
):
    """Moves ``first`` to ``last`` of every active candidate."""
    candidate = wp.tid()
    if run.active[candidate] == 0:
        return
    t = b.tables
    c = candidate_of(b, candidate)
    rng = run.rng[candidate]
    box = item(t[0].room_box, c.problem)
    width = wp.max(box[2] - box[0], box[3] - box[1])
    for number in range(first, last):
        past = float(number) / float(cooling.moves)
        scale = wp.max(0.4 * width * wp.pow(0.002, past), 0.002) * (0.1 + uniform(rng))
        move = new_move(b, o, c, s, run, scale, rng)
        before = float(0.0)
        after = float(0.0)
        if cooling.soft > 0.0:
            mark_body(b, c, s, move.first, 1)
            mark_body(b, c, s, move.second, 2)
            before = soft_energy(b, c, s, move.first) + soft_energy(b, c, s, move.second)
        place_body(b, c, s, run, move.first, 1, move.pose)
        if move.other >= 0:
            place_body(b, c, s, run, move.second, 2, move.other_pose)
        change = changed_terms(b, o, c, s, run, move.first, number)
        if move.other >= 0:
            change += changed_terms(b, o, c, s, run, move.second, number)
        if cooling.soft > 0.0:
            after = soft_energy(b, c, s, move.first) + soft_energy(b, c, s, move.second)
            change += cooling.soft * (after - before)
        heat = run.heat[candidate]
        if number < TRIALS:
            run.heat[candidate] = heat + wp.min(wp.abs(change), 1.0e3) / float(TRIALS)
        temperature = wp.max(heat * cooling.hot * wp.pow(cooling.cold / cooling.hot, past), 1.0e-9)
        taken = change <= 0.0
        if not taken:
            taken = uniform(rng) < wp.exp(-change / temperature)
        if taken:
            taken = body_holds(b, c, s, move.first)
        if taken and move.other >= 0:
            taken = body_holds(b, c, s, move.second)
        if taken:
            take_terms(b, o, c, run, move.first)
            if move.other >= 0:
                take_terms(b, o, c, run, move.second)
            total = run.total[candidate] + change
            run.total[candidate] = total
            if total < run.least[candidate] - 1.0e-6 * wp.abs(total):
                run.least[candidate] = total
                for obj in range(c.objects):
                    run.best[candidate, obj] = s.poses[candidate, obj]
        else:
            take_back(b, c, s, run, move.first)
            if move.other >= 0:
                take_back(b, c, s, run, move.second)
        unmark(b, c, s, move.first)
        if move.other >= 0:
            unmark(b, c, s, move.second)
    run.rng[candidate] = rng


@wp.func
def mark_body(b: Problems, c: Candidate, s: State, bodies: wp.vec2i, mark: wp.int32):
    """Say that a body moves."""
    for k in range(bodies[0], bodies[1]):
        s.mark[c.index, item(b.tables[0].group, k)] = mark


@wp.kernel
def end_annealing(
    # Problem:
    b: Problems,
    # State in:
    run: Annealing,
    # State in and out:
    s: State,
):
    """Go to the best layouts."""
    candidate, obj = wp.tid()
    if run.active[candidate] == 0:
        return
    if obj < item(b.tables[0].object_start, b.problem[candidate] + 1) - item(
        b.tables[0].object_start, b.problem[candidate]
    ):
        pose = run.best[candidate, obj]
        s.poses[candidate, obj] = pose
        s.turns[candidate, obj] = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
