"""Small services on layouts: the (cos, sin) of yaws, keeping the best of each candidate."""

import warp as wp

from .tables import State, TablesRef

wp.set_module_options({"enable_backward": False})


@wp.kernel
def keep_best(
    # Problem:
    t: TablesRef,
    problem: wp.array(dtype=wp.int32),
    active: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    total: wp.array(dtype=wp.float32),
    # State out:
    best_out: State,
    best_total_out: wp.array(dtype=wp.float32),
):
    """Copy a candidate's layout when its energy is the lowest so far."""
    candidate = active[wp.tid()]
    if not total[candidate] < best_total_out[candidate]:
        return
    p = problem[candidate]
    best_total_out[candidate] = total[candidate]
    for obj in range(t[0].object_start[p + 1] - t[0].object_start[p]):
        best_out.poses[candidate, obj] = s.poses[candidate, obj]
        best_out.turns[candidate, obj] = s.turns[candidate, obj]
    for r in range(t[0].relation_start[p + 1] - t[0].relation_start[p]):
        best_out.options[candidate, r] = s.options[candidate, r]


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
