"""Small services on layouts: starts, frames, (cos, sin) of yaws, the best of each candidate, who is done, the clock."""

import warp as wp

from .bodies import object_count
from .features import TURN
from .geometry import plane_of, turn_back, wrap
from .tables import Problems, State

wp.set_module_options({"enable_backward": False})


@wp.func
def copy_layout(b: Problems, candidate: wp.int32, source: State, target: State):
    """Copy a candidate's poses from one state to another."""
    for obj in range(object_count(b.tables, b.problem[candidate])):
        target.poses[candidate, obj] = source.poses[candidate, obj]
        target.turns[candidate, obj] = source.turns[candidate, obj]


@wp.kernel
def keep_best(
    # Problem:
    b: Problems,
    # State in:
    active: wp.array(dtype=wp.int32),
    s: State,
    total: wp.array(dtype=wp.float32),
    # State out:
    best_out: State,
    best_total_out: wp.array(dtype=wp.float32),
):
    """Copy an active candidate's layout when its energy is the lowest so far."""
    candidate = wp.tid()
    if active[candidate] == 0 or not total[candidate] < best_total_out[candidate]:
        return
    best_total_out[candidate] = total[candidate]
    copy_layout(b, candidate, s, best_out)


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
    rounds: wp.int32,
    anchored_attempts: wp.int32,
    # State in:
    active: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    fault: wp.array2d(dtype=wp.int8),
    holds: wp.array2d(dtype=wp.bool),
    # State out:
    released_out: wp.array2d(dtype=wp.int32),
):
    """At the start of an attempt, let the roots move whose bodies the last verdict finds at fault; all in the last one.

    What was released before stays so: attempt by attempt the neighbours join that were in the way of the last one.
    """
    t = b.tables
    candidate = wp.tid()
    if active[candidate] == 0 or clock[0] % rounds != 0:
        return
    p = b.problem[candidate]
    o0 = t[0].object_start[p]
    all_of_them = clock[0] // rounds >= anchored_attempts - 1
    for obj in range(t[0].object_start[p + 1] - o0):
        if all_of_them or int(fault[candidate, obj]) != 0:
            released_out[candidate, t[0].object_root[o0 + obj]] = 1
    r0 = t[0].relation_start[p]
    for r in range(r0, t[0].relation_start[p + 1]):
        if t[0].relation_fault[r] != 0 and not holds[candidate, r - r0]:
            parties = t[0].relation_object[r]
            for k in range(3):
                if parties[k] >= 0:
                    released_out[candidate, t[0].object_root[o0 + parties[k]]] = 1


@wp.kernel
def advance_clock(
    # State out:
    clock_out: wp.array(dtype=wp.int32),
    left_out: wp.array(dtype=wp.int32),
):
    """Another step; nobody counted yet who is left. One thread."""
    clock_out[0] = clock_out[0] + 1
    left_out[0] = 0


@wp.kernel
def retire(
    # Problem:
    b: Problems,
    first_steps: wp.int32,
    close: wp.float32,
    # State in:
    clock: wp.array(dtype=wp.int32),
    status: wp.array(dtype=wp.int8),
    best: State,
    best_total: wp.array(dtype=wp.float32),
    # State in and out:
    active: wp.array(dtype=wp.int32),
    s: State,
    # State out:
    left_out: wp.array(dtype=wp.int32),
):
    """Take candidates out of the search, and count those that go on in ``left_out[0]``.

    The valid ones leave, and after so many steps those that never came close to it (energy above ``close`` [m]): with
    their best layout, and counted in ``left_out[1]``.
    """
    candidate = wp.tid()
    if active[candidate] == 0:
        return
    if int(status[candidate]) == 0:
        active[candidate] = 0
    elif clock[0] == first_steps and best_total[candidate] > close:
        active[candidate] = 0
        wp.atomic_add(left_out, 1, 1)
        copy_layout(b, candidate, best, s)
    else:
        wp.atomic_add(left_out, 0, 1)


@wp.kernel
def check_continue(
    # State in:
    clock: wp.array(dtype=wp.int32),
    left: wp.array(dtype=wp.int32),
    steps: wp.int32,
    # State out:
    more_out: wp.array(dtype=wp.int32),
):
    """Whether another step is due. One thread."""
    more_out[0] = wp.where(left[0] > 0 and clock[0] < steps, 1, 0)
