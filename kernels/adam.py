"""Adam with annealed noise: the update of every object, and the best so far, in one launch.

Each thread reads the poses of the last step and writes those of the next, so the order of threads does not matter and
nothing is summed across threads. Before it overwrites the poses of the step before, it keeps them if they were best.
"""

import warp as wp

from .array_access import item
from .step import (
    freedom,
    keep_last,
    noise,
    place_members,
    scaled_gradient,
    stream,
    turning_arm,
)
from .tables import State, TablesRef
from .warp_primitives import WARP_SIZE

# Fast sines on a GPU are good to a few micrometres; the layout that is kept is measured again with exact ones.
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

BETA1 = wp.constant(0.9)
BETA2 = wp.constant(0.99)
EPSILON = wp.constant(1.0e-6)


@wp.struct
class Schedule:
    """Step sizes over the run: from rate to rate_end, noise from its start to none at ``quiet``."""

    steps: wp.int32
    rate: wp.float32  # [m]
    rate_end: wp.float32
    noise: wp.float32  # [m] standard deviation at the start; Langevin: temperature [m], in units of the energy
    quiet: wp.float32  # share of the run after which there is no noise


@wp.func
def rate_at(schedule: Schedule, life: wp.float32):
    """Step size [m] after a share of the run: half a cosine from rate to rate_end."""
    return schedule.rate_end + 0.5 * (schedule.rate - schedule.rate_end) * (1.0 + wp.cos(wp.min(life, 1.0) * wp.pi))


@wp.func
def noise_at(schedule: Schedule, life: wp.float32):
    """Noise after a share of the run, falling linearly."""
    return schedule.noise * wp.max(0.0, 1.0 - life / schedule.quiet)


@wp.kernel
def adam_step(
    # Problem:
    t: TablesRef,
    schedule: Schedule,
    problem: wp.array(dtype=wp.int32),
    # State in:
    clock: wp.array(dtype=wp.int32),
    s: State,
    share: wp.array2d(dtype=wp.float32),
    lowest: wp.array(dtype=wp.float32),
    part: wp.array2d(dtype=wp.float32),
    slope: wp.array2d(dtype=wp.vec4),
    # State in and out:
    mean: wp.array2d(dtype=wp.vec4),
    square: wp.array2d(dtype=wp.vec4),
    next_poses: wp.array2d(dtype=wp.vec4),
    # State out:
    next_turns_out: wp.array2d(dtype=wp.vec2),
    best_out: wp.array2d(dtype=wp.vec4),
    share_out: wp.array2d(dtype=wp.float32),
    lowest_out: wp.array(dtype=wp.float32),
    clock_out: wp.array(dtype=wp.int32),
):
    """Move every root one step along its gradient; what it carries follows.

    ``share`` and, before they are overwritten, ``next_poses`` are those of the step before; ``lowest`` is the lowest
    energy before that step; ``part`` and ``slope`` are every object's share and gradient at the poses of this step.
    """
    group, obj, lane = wp.tid()
    candidate = group * WARP_SIZE + lane
    if candidate >= problem.shape[0]:
        return
    if candidate == 0 and obj == 0:
        clock_out[0] = clock[0] + 1
    p = problem[candidate]
    o = item(t[0].object_start, p) + obj
    if not keep_last(t, p, candidate, obj, share, lowest, next_poses, best_out, share_out, lowest_out):
        return
    arm = turning_arm(t, o)
    portion, g = scaled_gradient(t, o, obj, candidate, arm, part, slope, s.poses)
    share_out[obj, candidate] = portion
    step = clock[0]
    life = float(step) / float(schedule.steps)
    mu = BETA1 * mean[obj, candidate] + (1.0 - BETA1) * g
    nu = BETA2 * square[obj, candidate] + (1.0 - BETA2) * wp.cw_mul(g, g)
    mean[obj, candidate] = mu
    square[obj, candidate] = nu
    up = rate_at(schedule, life) / (1.0 - wp.pow(BETA1, float(step + 1)))
    down = 1.0 / (1.0 - wp.pow(BETA2, float(step + 1)))
    sigma = noise_at(schedule, life)
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        d[c] = -up * mu[c] / (wp.sqrt(down * nu[c]) + EPSILON)
    if sigma > 0.0:
        d += sigma * noise(stream(s.rng[candidate], step, obj))
    d = wp.cw_mul(d, freedom(t, o))
    d[3] = d[3] / arm
    place_members(t, o, obj, candidate, candidate, d, s.poses, next_poses, next_turns_out)
