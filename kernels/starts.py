"""The start of an attempt: every free object drawn anew, anywhere or from its relations, or back at its anchor."""

import warp as wp

from .array_access import item, opaque_one
from .bodies import candidate_of
from .groups import is_formation, move_inside, move_with_members, redraw_surfaces, set_pose
from .plan import ANYWHERE, DRAWN, GIVEN, Plan, SearchRun
from .sample import keep_inside, project_onto_relations, random_start, uniform
from .tables import Problems, State, TablesRef
from .warp_primitives import lane_id, syncwarp, warp_size

# Fast sines on a GPU are good to a few micrometres; the judge gets exact ones (`set_turns`).
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

DEPTHS = wp.constant(16)  # objects that others are placed by are drawn before those, down to this depth


@wp.func
def depth_of(t: TablesRef, o0: wp.int32, obj: wp.int32):
    """How many objects stand between this one and what places it, in a row."""
    depth = int(0)
    parent = item(t[0].object_parent, o0 + obj)
    while parent >= 0 and depth < DEPTHS - 1:
        parent = item(t[0].object_parent, o0 + parent)
        depth += 1
    return depth


@wp.kernel
def start_attempt(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    run: SearchRun,
    # State in and out:
    s: State,
):
    """At the first round of an attempt, put every active candidate where the attempt begins. A warp a candidate."""
    t = b.tables
    m = b.margins
    candidate = wp.tid() // warp_size()
    me = lane_id()
    if run.clock[0] % plan.rounds != 0 or run.active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    p = c.problem
    o0 = c.first_object
    n = c.objects
    attempt = run.clock[0] // plan.rounds
    if attempt == 0:
        s.stream[candidate, me] = wp.rand_init(int(s.rng[candidate]), me)
        if me == 0:
            s.stream[candidate, warp_size()] = wp.rand_init(int(s.rng[candidate]), warp_size())
        if plan.start == GIVEN:
            return
    elif plan.start == GIVEN and attempt < plan.anchored_attempts:
        for obj in range(me, n, warp_size()):
            set_pose(s, candidate, obj, item(s.anchors, candidate, obj))
        return
    rng = item(s.stream, candidate, me)
    for depth in range(0, DEPTHS, opaque_one()):  # it seldom runs: little code
        for obj in range(me, n, warp_size()):
            if item(t[0].object_root, o0 + obj) == obj and item(t[0].object_free, o0 + obj) != 0:
                if depth_of(t, o0, obj) == depth:
                    pose = random_start(t, p, o0 + obj, item(s.poses, candidate, obj), rng)
                    if plan.start != ANYWHERE or attempt > 0:
                        pose = project_onto_relations(b, c, obj, pose, s, True, rng)
                        pose = keep_inside(t, p, o0 + obj, pose, m.bounds_aim)
                    move_with_members(t, o0, s, candidate, obj, pose)
        syncwarp()
    for obj in range(me, n, warp_size()):
        if item(t[0].object_parent, o0 + obj) < 0 and is_formation(t, o0 + obj):
            move_inside(t, p, candidate, obj, m.bounds_aim, s)
    syncwarp()
    if t[0].pool_size > 0:
        for obj in range(me, n, warp_size()):
            if item(t[0].surface_start, o0 + obj + 1) > item(t[0].surface_start, o0 + obj):
                redraw_surfaces(t, p, obj, candidate, int(uniform(rng) * 1.0e9), s.poses)
                for k in range(item(t[0].member_start, o0 + obj), item(t[0].member_start, o0 + obj + 1)):
                    i = item(t[0].member, k)
                    set_pose(s, candidate, i, item(s.poses, candidate, i))
    if plan.start == DRAWN and attempt == 0:  # what was drawn just now has moved the streams on, and may be the same
        syncwarp()
        for obj in range(me, n, warp_size()):
            pose = item(s.anchors, candidate, obj)
            if wp.length_sq(pose - item(s.poses, candidate, obj)) > 0.0:
                set_pose(s, candidate, obj, pose)
    s.stream[candidate, me] = rng
