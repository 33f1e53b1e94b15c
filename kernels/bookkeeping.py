"""Small services on layouts: starts, frames, (cos, sin) of yaws, the best of each candidate, who is done, the clock."""

import warp as wp

from .bodies import candidate_of, object_count
from .features import TURN
from .geometry import plane_of, turn_back, wrap
from .plan import Plan, SearchRun
from .tables import Problems, State
from .verdict import VALID, DeviceVerdict

wp.set_module_options({"enable_backward": False})


@wp.kernel
def keep_best(
    # Problem:
    b: Problems,
    # State in:
    s: State,
    # State in and out:
    run: SearchRun,
):
    """Keep an active candidate's poses when its hard energy is the lowest so far, or as low and its energy lower."""
    candidate = wp.tid()
    if run.active[candidate] == 0:
        return
    hard, best = run.hard[candidate], run.best_hard[candidate]
    if not (hard < best or (hard == best and run.total[candidate] < run.best_total[candidate])):
        return
    run.best_hard[candidate] = hard
    run.best_total[candidate] = run.total[candidate]
    for obj in range(object_count(b.tables, b.problem[candidate])):
        run.best[candidate, obj] = s.poses[candidate, obj]


@wp.kernel
def take_best_found(
    # Problem:
    b: Problems,
    # State in:
    run: SearchRun,
    verdict: DeviceVerdict,
    # State in and out:
    s: State,
):
    """Put candidates that are not valid back to the lowest energy that they had."""
    candidate, obj = wp.tid()
    if int(verdict.status[candidate]) == VALID or not run.best_total[candidate] < wp.inf:
        return
    if obj < object_count(b.tables, b.problem[candidate]):
        pose = run.best[candidate, obj]
        s.poses[candidate, obj] = pose
        s.turns[candidate, obj] = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))


@wp.kernel
def set_turns(
    # State in:
    poses: wp.array2d(dtype=wp.vec4),
    # State out:
    turns_out: wp.array2d(dtype=wp.vec2),
):
    """(cos, sin) of every yaw."""
    candidate, obj = wp.tid()
    yaw = poses[candidate, obj][3]
    turns_out[candidate, obj] = wp.vec2(wp.cos(yaw), wp.sin(yaw))


@wp.kernel
def broadcast_poses(
    # Problem:
    problem: wp.array(dtype=wp.int32),
    # State in:
    homes: wp.array2d(dtype=wp.vec4),
    # State out:
    poses_out: wp.array2d(dtype=wp.vec4),
    anchors_out: wp.array2d(dtype=wp.vec4),
):
    """Put every candidate, [candidate, object], at the one pose that its problem has for each object."""
    candidate, obj = wp.tid()
    pose = homes[problem[candidate], obj]
    poses_out[candidate, obj] = pose
    anchors_out[candidate, obj] = pose


@wp.kernel
def to_surface_frames(
    # Problem:
    first: wp.int32,
    candidates: wp.int32,
    supporter: wp.array(dtype=wp.int32),
    member_start: wp.array(dtype=wp.int32),
    member: wp.array(dtype=wp.int32),
    # State in:
    poses: wp.array2d(dtype=wp.vec4),
    # State out:
    local_out: wp.array2d(dtype=wp.vec4),
):
    """Poses of what stands on each surface, in its supporter's frame, surface by surface, candidate by candidate."""
    row, k = wp.tid()
    surface = row // candidates
    candidate = first + row % candidates
    if k >= member_start[surface + 1] - member_start[surface]:
        return
    base = poses[candidate, supporter[surface]]
    pose = poses[candidate, member[member_start[surface] + k]]
    at = turn_back(wp.vec2(wp.cos(base[3]), wp.sin(base[3])), plane_of(pose) - plane_of(base))
    local_out[row, k] = wp.vec4(at[0], at[1], 0.0, wrap(pose[3] - base[3], TURN))


@wp.kernel
def release(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    run: SearchRun,
    verdict: DeviceVerdict,
    # State in and out:
    s: State,
):
    """At the start of an attempt, let the roots move whose bodies the last verdict finds at fault; all in the last one.

    What was released before stays so: attempt by attempt the neighbours join that were in the way of the last one.
    """
    t = b.tables
    candidate = wp.tid()
    if run.active[candidate] == 0 or run.clock[0] % plan.rounds != 0:
        return
    c = candidate_of(b, candidate)
    all_of_them = run.clock[0] // plan.rounds >= plan.anchored_attempts - 1
    for obj in range(c.objects):
        if all_of_them or int(verdict.fault[candidate, obj]) != VALID:
            s.released[candidate, t[0].object_root[c.first_object + obj]] = 1
    r0 = t[0].relation_start[c.problem]
    for r in range(r0, t[0].relation_start[c.problem + 1]):
        if t[0].relation_fault[r] != 0 and not verdict.holds[candidate, r - r0]:
            parties = t[0].relation_object[r]
            for k in range(3):
                if parties[k] >= 0:
                    s.released[candidate, t[0].object_root[c.first_object + parties[k]]] = 1


@wp.kernel
def advance_clock(
    # State in and out:
    run: SearchRun,
):
    """Another round is done; nobody counted yet who is left. One thread."""
    run.clock[0] = run.clock[0] + 1
    run.left[0] = 0


@wp.kernel
def retire(
    # Problem:
    plan: Plan,
    close: wp.float32,
    # State in:
    verdict: DeviceVerdict,
    # State in and out:
    run: SearchRun,
):
    """Take candidates out of the search, and count those that go on in ``left[0]``.

    The valid ones leave, and after the first attempts those that never came close to it (hard energy above ``close``
    [m]), which are counted in ``left[1]``.
    """
    candidate = wp.tid()
    if run.active[candidate] == 0:
        return
    if int(verdict.status[candidate]) == VALID:
        run.active[candidate] = 0
    elif run.clock[0] == plan.first_steps and run.best_hard[candidate] > close:
        run.active[candidate] = 0
        wp.atomic_add(run.left, 1, 1)
    else:
        wp.atomic_add(run.left, 0, 1)


@wp.kernel
def check_continue(
    # Problem:
    plan: Plan,
    # State in and out:
    run: SearchRun,
):
    """Whether another round is due. One thread."""
    run.more[0] = wp.where(run.left[0] > 0 and run.clock[0] < plan.steps, 1, 0)
