"""What step-based optimisers share: threads, moving a root with what it carries, the best so far, choosing options.

These optimisers look at every object of every candidate in each step, so their kernels run one thread per (candidate,
object) or (candidate, relation), as (group, object, lane): a warp takes one object of neighbouring candidates. Its
threads then read the same table entries and take the same branches, and warps beside it find the candidates' poses
in the cache. What is private to these optimisers is stored [object, candidate], so that a warp reads it in one piece.
"""

import warp as wp

from .array_access import item, item_strided
from .bodies import object_count, root_at
from .features import TURN
from .geometry import perp, plane_of, wrap
from .tables import FREE_PLANE, FREE_YAW, FREE_Z, Problems, State, TablesRef
from .terms_relations import nearest_option
from .warp_primitives import WARP_SIZE

wp.set_module_options({"enable_backward": False})

AT_REST = wp.constant(1.0e-9)  # energy at which nothing is left to improve


@wp.struct
class Gradients:
    """Shares of the energy and their gradients, [object, candidate]."""

    share: wp.array2d(dtype=wp.float32)
    gradient: wp.array2d(dtype=wp.vec4)


@wp.func
def turning_arm(t: TablesRef, o: wp.int32):
    """Length [m] by which yaw is scaled, so that a step turns object o about as far as it shifts it."""
    return 0.3 * item(t[0].object_radius, o)[0] + 0.05


@wp.func
def freedom(t: TablesRef, o: wp.int32):
    """One for every coordinate (x, y, z, yaw) that object o is free in, else zero."""
    free = item(t[0].object_free, o)
    plane = wp.where((free & FREE_PLANE) != 0, 1.0, 0.0)
    return wp.vec4(plane, plane, wp.where((free & FREE_Z) != 0, 1.0, 0.0), wp.where((free & FREE_YAW) != 0, 1.0, 0.0))


@wp.func
def noise(rng: wp.uint32):
    """Four standard normal numbers."""
    v = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        v[c] = wp.randn(rng)
    return v


@wp.func
def stream(seed: wp.uint32, step: wp.int32, index: wp.int32):
    """A random stream of its own for each candidate's seed, step and index: no state to share between threads."""
    return wp.rand_init(int(seed) + 7919 * step, index)


@wp.func
def scaled_gradient(
    t: TablesRef,
    o: wp.int32,
    root: wp.int32,
    candidate: wp.int32,
    arm: wp.float32,
    each: Gradients,
    poses: wp.array2d(dtype=wp.vec4),
):
    """Share of a root (o: its global index) in its candidate's energy, and the gradient for its pose.

    ``each`` are those of every object, which a root has with all that it carries. Yaw is a length at the arm.
    """
    at = plane_of(item_strided(poses, candidate, root))
    share = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for k in range(item(t[0].member_start, o), item(t[0].member_start, o + 1)):
        i = item(t[0].member, k)
        share += item(each.share, i, candidate)
        gi = item(each.gradient, i, candidate)
        turned = perp(plane_of(item_strided(poses, candidate, i)) - at)
        g += wp.vec4(gi[0], gi[1], gi[2], gi[3] + gi[0] * turned[0] + gi[1] * turned[1])
    g = wp.cw_mul(g, freedom(t, o))
    g[3] = g[3] / arm
    return share, g


@wp.func
def place_members(
    t: TablesRef,
    o: wp.int32,
    root: wp.int32,
    candidate: wp.int32,
    d: wp.vec4,
    poses: wp.array2d(dtype=wp.vec4),
    next_poses: wp.array2d(dtype=wp.vec4),
    next_turns: wp.array2d(dtype=wp.vec2),
):
    """Write the poses of a root (o: its global index) and of all that it carries, moved by d (x, y, z, yaw)."""
    old = poses[candidate, root]
    pose = old + d
    spin = wp.vec2(wp.cos(d[3]), wp.sin(d[3]))
    for k in range(item(t[0].member_start, o), item(t[0].member_start, o + 1)):
        i = item(t[0].member, k)
        child = poses[candidate, i]
        arm = plane_of(child) - plane_of(old)
        at = plane_of(pose) + spin[0] * arm + spin[1] * perp(arm)
        yaw = wrap(child[3] + d[3], TURN)
        next_poses[candidate, i] = wp.vec4(at[0], at[1], child[2] + d[2], yaw)
        next_turns[candidate, i] = wp.vec2(wp.cos(yaw), wp.sin(yaw))


@wp.func
def total_of(share: wp.array2d(dtype=wp.float32), candidate: wp.int32, n: wp.int32):
    """Sum of the first n objects' shares [object, candidate]."""
    total = float(0.0)
    for obj in range(n):
        total += item(share, obj, candidate)
    return total


@wp.kernel
def choose(
    # Problem:
    b: Problems,
    # State in:
    s: State,
    # State out:
    options_out: wp.array2d(dtype=wp.int32),
    other_out: wp.array2d(dtype=wp.int32),
):
    """Give every relation its best option at the present poses, in both buffers."""
    group, rel, lane = wp.tid()
    candidate = group * WARP_SIZE + lane
    if candidate >= b.problem.shape[0]:
        return
    option = nearest_option(b, candidate, rel, s)
    if option >= 0:
        options_out[candidate, rel] = option
        other_out[candidate, rel] = option


@wp.kernel
def measure(
    # Problem:
    b: Problems,
    # State in:
    s: State,
    each: Gradients,
    # State out:
    roots_out: Gradients,
):
    """Every root's share of its candidate's energy and its scaled gradient, from those of each object; else zero."""
    group, obj, lane = wp.tid()
    candidate = group * WARP_SIZE + lane
    if candidate >= b.problem.shape[0]:
        return
    share = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    o = root_at(b, candidate, obj)
    if o >= 0:
        share, g = scaled_gradient(b.tables, o, obj, candidate, turning_arm(b.tables, o), each, s.poses)
    roots_out.share[obj, candidate] = share
    roots_out.gradient[obj, candidate] = g


@wp.kernel
def take_best(
    # Problem:
    b: Problems,
    # State in:
    last: wp.array2d(dtype=wp.vec4),
    total: wp.array(dtype=wp.float32),
    best: wp.array2d(dtype=wp.vec4),
    lowest: wp.array(dtype=wp.float32),
    # State out:
    poses_out: wp.array2d(dtype=wp.vec4),
    turns_out: wp.array2d(dtype=wp.vec2),
):
    """Give every candidate the better one of its last poses, of the given energy, and the best before them."""
    candidate, obj = wp.tid()
    if obj < object_count(b.tables, b.problem[candidate]):
        pose = last[candidate, obj]
        if not total[candidate] < lowest[candidate] and lowest[candidate] < wp.inf:
            pose = best[candidate, obj]
        poses_out[candidate, obj] = pose
        turns_out[candidate, obj] = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))


@wp.kernel
def add_up(
    # Problem:
    b: Problems,
    # State in:
    share: wp.array2d(dtype=wp.float32),
    # State out:
    total_out: wp.array(dtype=wp.float32),
):
    """Energy of every candidate."""
    candidate = wp.tid()
    total_out[candidate] = total_of(share, candidate, object_count(b.tables, b.problem[candidate]))
