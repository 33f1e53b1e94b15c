"""Annealed Langevin dynamics, preconditioned: gradient and noise of one temperature in one launch.

A step is d = -rate G g + sqrt(2 rate G T) N(0, 1) with the diagonal preconditioner G = 1 / (FLOOR + rms(g)) over the
last gradients (Li, Chen, Carlson & Carin 2016, "Preconditioned stochastic gradient Langevin dynamics for deep neural
networks"; like there, the term with the derivative of G is left out). As the rate goes to zero this samples from
exp(-energy / T); the temperature falls to zero, and what remains of the run is a quiet descent.
"""

import warp as wp

from .adam import BETA2, Schedule, noise_at, rate_at
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

FLOOR = wp.constant(0.3)  # slope beside which smaller ones do not lengthen the step; a violated term has slope 1


@wp.kernel
def langevin_step(
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
    square: wp.array2d(dtype=wp.vec4),
    next_poses: wp.array2d(dtype=wp.vec4),
    # State out:
    next_turns_out: wp.array2d(dtype=wp.vec2),
    best_out: wp.array2d(dtype=wp.vec4),
    share_out: wp.array2d(dtype=wp.float32),
    lowest_out: wp.array(dtype=wp.float32),
    clock_out: wp.array(dtype=wp.int32),
):
    """Move every root one step; what it carries follows. Arrays as for ``adam.adam_step``."""
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
    nu = BETA2 * square[obj, candidate] + (1.0 - BETA2) * wp.cw_mul(g, g)
    square[obj, candidate] = nu
    down = 1.0 / (1.0 - wp.pow(BETA2, float(step + 1)))
    rate = rate_at(schedule, life)
    temperature = noise_at(schedule, life)
    xi = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if temperature > 0.0:
        xi = noise(stream(s.rng[candidate], step, obj))
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        pace = rate / (FLOOR + wp.sqrt(down * nu[c]))
        d[c] = -pace * g[c] + wp.sqrt(2.0 * pace * temperature) * xi[c]
    d = wp.cw_mul(d, freedom(t, o))
    d[3] = d[3] / arm
    place_members(t, o, obj, candidate, candidate, d, s.poses, next_poses, next_turns_out)
