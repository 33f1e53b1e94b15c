"""Exact poses: what stands nearly square, flush, centred or in line is brought to stand exactly so.

The energy leaves everything within its tolerances; people see three degrees and two centimetres. Rows of exact values
(``Tables.snap_start``) say what a relation's quantities ought to be. Objects are brought there one by one, what others
are placed by first, together with all that they place or else alone: all of the way, or three quarters, half or a
quarter of it, the first that costs nothing. What shares a target is brought there side by side, all by the same value.
"""

import warp as wp

from .array_access import item, opaque_one
from .bodies import Candidate, Layout, candidate_of, layout_of, posed, viewed_body
from .evaluator import EVERY_KIND
from .features import TURN, Relation, feature
from .geometry import FAR, wrap
from .groups import group_energy, group_evaluator, members_end, move_with_members, set_pose
from .sample import QUARTER, shifted, turned
from .tables import FEATURE_YAW, FREE_YAW, Problems, State, TablesRef, TermSlice, View
from .terms_relations import ALL_RELATIONS, best_option, relation_of
from .verdict import relation_holds

wp.set_module_options({"enable_backward": False, "default_grid_stride": False})

PASSES = wp.constant(12)  # at most; they end when one moves nothing
SHARES = wp.constant(4)  # of the way that are tried
SQUARE = wp.constant(0.21)  # [rad] within which something is taken for square to a wall
SETTLED = wp.constant(1.0e-4)  # [m, rad] movement of a pass that calls for another
STILL = wp.constant(2.0e-6)  # [m, rad] a way that is not worth going
SLIGHT = wp.constant(2.0e-5)  # energy of contacts that are less than a millimetre short of the clearance aimed at
SLACK = wp.constant(0.1)  # [m] by which the penalty of a relation that does not hold may rise

group_energy_without_relations = group_evaluator(EVERY_KIND & ~ALL_RELATIONS)


@wp.func
def exact_pose(b: Problems, r: wp.int32, x: Relation, free: wp.int32, share: wp.float32):
    """The subject's pose with the quantities of relation r (global) exact, one after the other.

    It ends at the first quantity that is too far off. Quantities that are shared come to lie between the value that
    all may take (share 0) and the exact one (share 1); a negative share leaves them as they are.
    """
    t = b.tables
    option, _e = best_option(b, r, x)
    for row in range(item(t[0].snap_start, option), item(t[0].snap_start, option + 1)):
        value, g = feature(t, row, 0, x)
        within = item(t[0].row_hold, row)
        aim = item(t[0].row_aim, row)
        shared = aim[0] != aim[1]
        if (value < within[0] or value > within[1]) and not (shared and share < 0.0):
            break
        d = aim[0] - value
        if shared:
            d = wp.where(share < 0.0, 0.0, aim[1] + share * (aim[0] - aim[1]) - value)
        kind = item(t[0].row_feature, row)
        if kind == FEATURE_YAW:
            if free & FREE_YAW:
                x.a = turned(x.a, d * g[3])
        else:
            x.a.pose = shifted(x.a.pose, d, g, free)
    return x.a.pose


@wp.func
def shares_value(t: TablesRef, r: wp.int32):
    """True when a quantity of relation r (global) takes the same value for all subjects of its target."""
    first = item(t[0].snap_start, item(t[0].option_start, r))
    for row in range(first, item(t[0].snap_start, item(t[0].option_start, r + 1))):
        aim = item(t[0].row_aim, row)
        if aim[0] != aim[1]:
            return True
    return False


@wp.func
def squared(t: TablesRef, p: wp.int32, pose: wp.vec4):
    """A pose turned square to the wall to which it nearly is."""
    least = float(SQUARE)
    turned = float(0.0)
    for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
        plane = item(t[0].plane, k)
        off = wrap(pose[3] - wp.atan2(plane[1], plane[0]), QUARTER)
        if wp.abs(off) < least:
            least = wp.abs(off)
            turned = off
    return wp.vec4(pose[0], pose[1], pose[2], pose[3] - turned)


@wp.func
def way_to(pose: wp.vec4, goal: wp.vec4):
    """The way from one pose to another, the shorter way round."""
    d = goal - pose
    return wp.vec4(d[0], d[1], d[2], wrap(d[3], TURN))


@wp.func
def is_still(way: wp.vec4):
    """True for a way that is not worth going."""
    return wp.max(wp.max(wp.abs(way[0]), wp.abs(way[1])), wp.max(wp.abs(way[2]), wp.abs(way[3]))) < STILL


@wp.func
def allowed(b: Problems, layout: Layout, first: wp.int32, last: wp.int32):
    """True when all relations of the objects group[first:last] that hold still do where the view sees the objects, and
    those that do not hold are hardly worse off."""
    t = b.tables
    c = layout.candidate
    stays = layout_of(c, layout.state)
    r0 = item(t[0].relation_start, c.problem)
    for k in range(first, last):
        o = c.first_object + item(t[0].group, k)
        for j in range(item(t[0].incidence_start, o), item(t[0].incidence_start, o + 1)):
            r = r0 + item(t[0].incidence, j)
            if item(t[0].relation_rigid, r) == 0:
                after = relation_of(t, layout, r)
                if not relation_holds(t, r, after):
                    before = relation_of(t, stays, r)
                    if relation_holds(t, r, before):
                        return False
                    _option, low = best_option(b, r, before)
                    _other, high = best_option(b, r, after)
                    if high > low + SLACK:
                        return False
    return True


@wp.func
def move_to_view(t: TablesRef, layout: Layout, first: wp.int32, last: wp.int32, s: State):
    """Move the objects group[first:last] to where the view sees them."""
    for k in range(first, last):
        i = item(t[0].group, k)
        set_pose(s, layout.candidate.index, i, viewed_body(layout, i).pose)


@wp.func
def try_way(b: Problems, c: Candidate, obj: wp.int32, way: wp.vec4, stamp: wp.int32, s: State):
    """Move an object along a way, as far as costs nothing: with all that it places, else with what it carries.

    Returns the last stamp that marks were set to.
    """
    t = b.tables
    layout = layout_of(c, s)
    first = item(t[0].group_start, c.first_object + obj)
    alone = members_end(t, c.first_object + obj)
    last = item(t[0].group_start, c.first_object + obj + 1)
    old = item(s.poses, c.index, obj)
    mark = int(stamp)
    moved = bool(False)
    for whole in range(1, -1, -opaque_one()):
        if whole == 0:
            if last == alone:
                moved = True  # the same again
            last = alone
        if not moved:
            mark += 1
            for k in range(first, last):
                i = item(t[0].group, k)
                carried = item(t[0].object_root, c.first_object + i) == obj
                s.mark[c.index, i] = wp.where(carried, -mark, mark)
            view = View()
            view.stamp = mark
            view.before = old
            base = float(0.0)
            for k in range(0, SHARES + 1, opaque_one()):
                if not moved:
                    share = 1.0 - float(k - 1) / float(SHARES)
                    if k == 0:
                        share = 0.0
                    view.after = old + share * way
                    view.spin = wp.vec2(wp.cos(share * way[3]), wp.sin(share * way[3]))
                    limit = float(FAR)
                    if k > 0:
                        limit = wp.max(base, SLIGHT)
                    layout.view = view
                    e = group_energy_without_relations(b, layout, first, last, TermSlice(0, 1, limit)).value
                    if k == 0:
                        base = e
                    elif e <= limit:
                        if allowed(b, layout, first, last):
                            move_to_view(t, layout, first, last, s)
                            moved = True
    return mark


@wp.func
def is_placed(t: TablesRef, o0: wp.int32, r: wp.int32):
    """True when the subject of relation r (global) is free to move by itself."""
    subject = o0 + item(t[0].relation_object, r)[0]
    root = item(t[0].object_root, subject)
    return o0 + root == subject and item(t[0].object_free, subject) != 0 and item(t[0].relation_rigid, r) == 0


@wp.func
def snap_one(b: Problems, c: Candidate, obj: wp.int32, stamp: wp.int32, s: State):
    """Square an object to the room, then to its relations: those to objects first, those to the room have the last
    word. Returns the last stamp that marks were set to."""
    t = b.tables
    o = c.first_object + obj
    r0 = item(t[0].relation_start, c.problem)
    free = item(t[0].object_free, o)
    mark = int(stamp)
    first = item(t[0].incidence_start, o)
    count = item(t[0].incidence_start, o + 1) - first
    for k in range(-1, 2 * count, opaque_one()):
        pose = item(s.poses, c.index, obj)
        goal = pose
        if k < 0:
            if free & FREE_YAW:
                goal = squared(t, c.problem, pose)
        else:
            at = first + k % wp.max(count, 1)
            r = r0 + item(t[0].incidence, at)
            in_room = item(t[0].relation_object, r)[1] < 0
            if item(t[0].incidence_role, at) == 0 and item(t[0].relation_rigid, r) == 0 and in_room == (k >= count):
                goal = exact_pose(b, r, relation_of(t, layout_of(c, s), r), free, -1.0)
        way = way_to(pose, goal)
        if not is_still(way):
            mark = try_way(b, c, obj, way, mark, s)
    return mark


@wp.func
def shares_with(t: TablesRef, c: Candidate, r: wp.int32, target: wp.int32):
    """True when the subject of relation r (global) is free to move and shares a value with others at the target."""
    return item(t[0].relation_object, r)[1] == target and shares_value(t, r) and is_placed(t, c.first_object, r)


@wp.func
def energy_at(b: Problems, c: Candidate, target: wp.int32, first: wp.int32, s: State):
    """Energy of all that shares a value at a target, from relation ``first`` (global) on, soft terms apart."""
    t = b.tables
    e = float(0.0)
    soft = float(0.0)
    layout = layout_of(c, s)
    layout.view.best = 1
    for r in range(first, item(t[0].relation_start, c.problem + 1)):
        if shares_with(t, c, r, target):
            o = c.first_object + item(t[0].relation_object, r)[0]
            mine = group_energy(b, layout, item(t[0].group_start, o), members_end(t, o), TermSlice(0, 1, FAR))
            e += mine.value
            soft += mine.soft
    return e, soft


@wp.func
def snap_alike(b: Problems, c: Candidate, first: wp.int32, s: State):
    """Give all that shares a value at a target the same one, as near to the exact one as costs nothing.

    ``first`` (global) is the first of the relations that share it.
    """
    t = b.tables
    target = item(t[0].relation_object, first)[1]
    last = item(t[0].relation_start, c.problem + 1)
    base = float(0.0)
    base_soft = float(0.0)
    done = bool(False)
    for k in range(0, SHARES + 3, opaque_one()):  # where they are, all shares down to none, and back
        if not done:
            for r in range(first, last):
                if shares_with(t, c, r, target):
                    obj = item(t[0].relation_object, r)[0]
                    if k == 0:
                        s.draft[c.index, obj] = item(s.poses, c.index, obj)
                    else:
                        pose = item(s.draft, c.index, obj)
                        if k < SHARES + 2:
                            x = relation_of(t, layout_of(c, s), r)
                            x.a = posed(x.a, pose)
                            share = 1.0 - float(k - 1) / float(SHARES)
                            pose = exact_pose(b, r, x, item(t[0].object_free, c.first_object + obj), share)
                        move_with_members(t, c.first_object, s, c.index, obj, pose)
            e, soft = energy_at(b, c, target, first, s)
            if k == 0:
                base = e
                base_soft = soft
            else:
                done = e - soft <= wp.max(base - base_soft, SLIGHT) and soft <= wp.max(base_soft, SLIGHT)


@wp.kernel
def snap(
    # Problem:
    b: Problems,
    order: wp.array2d(dtype=wp.int32),
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
):
    """Make active candidates exact. ``order`` [problem, object] lists parents first. A thread a candidate."""
    t = b.tables
    candidate = wp.tid()
    if active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    still = b
    still.weights.pull = 0.0
    for obj in range(c.objects):
        s.mark[candidate, obj] = 0
    stamp = int(0)
    due = int(0)  # the last pass that is called for
    for turn in range(0, PASSES, opaque_one()):
        if turn <= due:
            for k in range(0, c.objects, opaque_one()):
                obj = order[c.problem, k]
                o = c.first_object + obj
                if item(t[0].object_root, o) == obj and item(t[0].object_free, o) != 0:
                    before = item(s.poses, candidate, obj)
                    stamp = snap_one(still, c, obj, stamp, s)
                    if wp.length(item(s.poses, candidate, obj) - before) > SETTLED:
                        due = turn + 1
    r0 = item(t[0].relation_start, c.problem)
    for r in range(r0, item(t[0].relation_start, c.problem + 1)):
        target = item(t[0].relation_object, r)[1]
        first = target >= 0 and shares_with(t, c, r, target)
        for k in range(r0, r):
            if first and shares_with(t, c, k, target):
                first = False
        if first:
            snap_alike(still, c, r, s)


@wp.kernel
def keep_valid(
    # State in:
    before: wp.array2d(dtype=wp.vec4),
    active: wp.array(dtype=wp.int32),
    status: wp.array(dtype=wp.int8),
    # State in and out:
    s: State,
):
    """Take back the poses [candidate, object] of active candidates that are not valid any more."""
    candidate, obj = wp.tid()
    if active[candidate] != 0 and int(status[candidate]) != 0:
        pose = before[candidate, obj]
        s.poses[candidate, obj] = pose
        s.turns[candidate, obj] = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
