"""Drawing poses: relation-guided proposals by randomised projection onto interval rows.

To draw a pose for an object, start anywhere and move it, row by row, to a random value inside each row's interval
along the row's own gradient. Yaw rows come first in every option, and the remaining rows of an option are nearly
orthogonal, so that one or two sweeps fulfil them. The same code serves every relation, also a user's own.
"""

import warp as wp

from .energy import EAST, outside, relation_energy
from .features import TURN, feature
from .geometry import plane_of, turn, wrap
from .tables import (
    FEATURE_BEARING,
    FEATURE_CONSTANT,
    FEATURE_YAW,
    FREE_PLANE,
    FREE_YAW,
    FREE_Z,
    State,
    TablesRef,
    Weights,
)

wp.set_module_options({"enable_backward": False})

QUARTER = wp.constant(1.5707963267948966)
REACH = wp.constant(0.6)  # [m] how far beyond the closed end of a half-open interval a target is drawn


@wp.func
def uniform(s: State, candidate: wp.int32):
    """A uniform number in [0, 1) from the candidate's own stream."""
    r = s.rng[candidate]
    u = wp.randf(r)
    s.rng[candidate] = r
    return u


@wp.func
def normal(s: State, candidate: wp.int32):
    """A standard normal number from the candidate's own stream."""
    r = s.rng[candidate]
    u = wp.randn(r)
    s.rng[candidate] = r
    return u


@wp.func
def pick(s: State, candidate: wp.int32, n: wp.int32):
    """A uniform index below n."""
    return wp.min(int(uniform(s, candidate) * float(n)), n - 1)


@wp.func
def set_pose(s: State, candidate: wp.int32, obj: wp.int32, pose: wp.vec4):
    """Write a pose with its (cos, sin), yaw wrapped."""
    yaw = wrap(pose[3], TURN)
    s.poses[candidate, obj] = wp.vec4(pose[0], pose[1], pose[2], yaw)
    s.turns[candidate, obj] = wp.vec2(wp.cos(yaw), wp.sin(yaw))


@wp.func(inline=False)
def carry(t: TablesRef, o0: wp.int32, s: State, candidate: wp.int32, root: wp.int32, pose: wp.vec4, whole: wp.int32):
    """Move a root to a pose with all that it carries; with whole = 1 also the group that it places."""
    old = s.poses[candidate, root]
    spin = pose[3] - old[3]
    q = wp.vec2(wp.cos(spin), wp.sin(spin))
    first = t[0].member_start[o0 + root]
    last = t[0].member_start[o0 + root + 1]
    if whole == 1:
        first = t[0].group_start[o0 + root]
        last = t[0].group_start[o0 + root + 1]
    for k in range(first, last):
        i = int(0)
        if whole == 1:
            i = t[0].group[k]
        else:
            i = t[0].member[k]
        if i != root:
            child = s.poses[candidate, i]
            at = plane_of(pose) + turn(q, plane_of(child) - plane_of(old))
            rise = wp.where(t[0].object_root[o0 + i] == root, pose[2] - old[2], 0.0)  # others keep their own height
            set_pose(s, candidate, i, wp.vec4(at[0], at[1], child[2] + rise, child[3] + spin))
    set_pose(s, candidate, root, pose)


@wp.func(inline=False)
def best_option(t: TablesRef, w: Weights, o0: wp.int32, r: wp.int32, s: State, candidate: wp.int32):
    """The option of relation r (global) with the lowest energy at the present poses."""
    first = t[0].option_start[r]
    last = t[0].option_start[r + 1]
    best = int(first)
    if last - first > 1:
        low = float(1.0e9)
        for option in range(first, last):
            e, _g = relation_energy(t, w, o0, r, option, 0, s, candidate)
            if e < low:
                low = e
                best = option
    return best


@wp.func(inline=False)
def random_start(t: TablesRef, p: wp.int32, obj: wp.int32, s: State, candidate: wp.int32):
    """A pose anywhere in the room's bounding box, square to the room four times in five."""
    o = t[0].object_start[p] + obj
    pose = s.poses[candidate, obj]
    box = t[0].room_box[p]
    free = t[0].object_free[o]
    if free & FREE_PLANE:
        pose[0] = box[0] + uniform(s, candidate) * (box[2] - box[0])
        pose[1] = box[1] + uniform(s, candidate) * (box[3] - box[1])
    if free & FREE_YAW:
        if uniform(s, candidate) < 0.8 and t[0].plane_start[p + 1] > t[0].plane_start[p]:
            n = t[0].plane[t[0].plane_start[p]]
            pose[3] = wp.atan2(n[1], n[0]) + QUARTER * float(pick(s, candidate, 4))
        else:
            pose[3] = TURN * uniform(s, candidate)
    return pose


@wp.func
def target_value(s: State, candidate: wp.int32, aim: wp.vec2):
    """A random value inside an interval that may be open to one side."""
    lo = aim[0]
    hi = aim[1]
    if lo < -1.0e8:
        lo = hi - REACH
    if hi > 1.0e8:
        hi = lo + REACH
    return lo + uniform(s, candidate) * (hi - lo)


@wp.func(inline=False)
def project_option(
    t: TablesRef,
    o0: wp.int32,
    r: wp.int32,
    option: wp.int32,
    s: State,
    candidate: wp.int32,
    pose: wp.vec4,
    fresh: wp.int32,
):
    """Move the subject's pose into the rows of one option, row by row.

    fresh = 1 draws a new value for every row; otherwise only rows outside their interval move it.
    """
    ids = t[0].relation_object[r]
    o = o0 + ids[0]
    free = t[0].object_free[o]
    pose_b = wp.vec4(0.0, 0.0, 0.0, 0.0)
    qb = EAST
    pose_c = wp.vec4(0.0, 0.0, 0.0, 0.0)
    b = int(-1)
    if ids[1] >= 0:
        b = o0 + ids[1]
        pose_b = s.poses[candidate, ids[1]]
        qb = s.turns[candidate, ids[1]]
    if ids[2] >= 0:
        pose_c = s.poses[candidate, ids[2]]
    q = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
    for row in range(t[0].row_start[option], t[0].row_start[option + 1]):
        kind = t[0].row_feature[row]
        if kind != FEATURE_CONSTANT:
            value, g = feature(t, row, 0, o, b, pose, q, pose_b, qb, pose_c)
            off, _sign = outside(value, t[0].row_aim[row])
            if off > 0.0 or fresh == 1:
                aim = t[0].row_aim[row]
                d = target_value(s, candidate, aim) - value
                if kind == FEATURE_YAW or kind == FEATURE_BEARING:
                    if free & FREE_YAW:
                        if kind == FEATURE_YAW and uniform(s, candidate) < 0.7:
                            d = wp.clamp(0.0, aim[0], aim[1]) - value  # people set furniture square
                        pose[3] = pose[3] + d * g[3]
                        q = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
                else:
                    if (free & FREE_PLANE) == 0:
                        g[0] = 0.0
                        g[1] = 0.0
                    if (free & FREE_Z) == 0:
                        g[2] = 0.0
                    gg = g[0] * g[0] + g[1] * g[1] + g[2] * g[2]
                    if gg > 1.0e-8:
                        step = d / gg
                        pose[0] = pose[0] + step * g[0]
                        pose[1] = pose[1] + step * g[1]
                        pose[2] = pose[2] + step * g[2]
    return pose


@wp.func(inline=False)
def settle(t: TablesRef, w: Weights, p: wp.int32, obj: wp.int32, s: State, candidate: wp.int32, fresh: wp.int32):
    """Project an object's pose onto its own relations; a fresh draw starts from one of them at random.

    The object's entry in the state is the start and receives the result (what it carries stays behind).
    """
    o0 = t[0].object_start[p]
    o = o0 + obj
    r0 = t[0].relation_start[p]
    first = t[0].touch_start[o]
    last = t[0].touch_start[o + 1]
    mine = int(0)
    for k in range(first, last):
        if t[0].touch_role[k] == 0 and t[0].relation_rigid[r0 + t[0].touch[k]] == 0:
            mine += 1
    if mine == 0:
        return
    main = int(-1)
    if fresh == 1:
        skip = pick(s, candidate, mine)
        for k in range(first, last):
            if t[0].touch_role[k] == 0 and t[0].relation_rigid[r0 + t[0].touch[k]] == 0:
                if skip == 0:
                    main = t[0].touch[k]
                skip -= 1
        r = r0 + main
        option = t[0].option_start[r] + pick(s, candidate, t[0].option_start[r + 1] - t[0].option_start[r])
        set_pose(s, candidate, obj, project_option(t, o0, r, option, s, candidate, s.poses[candidate, obj], 1))
    for _sweep in range(2):
        for k in range(first, last):
            r = r0 + t[0].touch[k]
            if t[0].touch_role[k] == 0 and t[0].relation_rigid[r] == 0:
                if t[0].relation_fault[r] != 0 or uniform(s, candidate) < 0.7:
                    option = best_option(t, w, o0, r, s, candidate)
                    set_pose(
                        s, candidate, obj, project_option(t, o0, r, option, s, candidate, s.poses[candidate, obj], 0)
                    )


@wp.func(inline=False)
def keep_inside(t: TablesRef, p: wp.int32, obj: wp.int32, s: State, candidate: wp.int32, aim: wp.float32):
    """Push an object's footprint back over each half plane that it crosses."""
    o = t[0].object_start[p] + obj
    pose = s.poses[candidate, obj]
    q = s.turns[candidate, obj]
    if t[0].object_free[o] & FREE_PLANE:
        for k in range(t[0].plane_start[p], t[0].plane_start[p + 1]):
            plane = t[0].plane[k]
            n = wp.vec2(plane[0], plane[1])
            low = float(1.0e6)
            for f in range(t[0].foot_start[o], t[0].foot_start[o + 1]):
                a = t[0].foot[f]
                for v in range(t[0].prism_start[a], t[0].prism_start[a + 1]):
                    low = wp.min(low, wp.dot(n, plane_of(pose) + turn(q, t[0].vertex[v])) - plane[2])
            if low < aim:
                pose[0] = pose[0] + (aim - low) * n[0]
                pose[1] = pose[1] + (aim - low) * n[1]
        s.poses[candidate, obj] = pose
