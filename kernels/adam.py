"""Adam with annealed noise: energy, gradient and update of every object in one launch.

One thread per (candidate, object). Each reads the poses of the last step and writes those of the next, so the order
of threads does not matter and nothing is summed across threads.
"""

import warp as wp

from .energy import best_option, parties_of
from .features import TURN
from .geometry import perp, plane_of, wrap
from .groups import members_energy
from .tables import FREE_PLANE, FREE_YAW, FREE_Z, Margins, State, TablesRef, View, Weights

wp.set_module_options({"enable_backward": False})

BETA1 = wp.constant(0.9)
BETA2 = wp.constant(0.99)
EPSILON = wp.constant(1.0e-6)


@wp.struct
class Schedule:
    """Step sizes over the run: from rate to rate_end, noise from its start to none at ``quiet``."""

    steps: wp.int32
    rate: wp.float32  # [m]
    rate_end: wp.float32
    noise: wp.float32  # [m] standard deviation at the start
    quiet: wp.float32  # share of the run after which there is no noise


@wp.kernel
def adam_step(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    schedule: Schedule,
    problem: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State in and out:
    mean: wp.array2d(dtype=wp.vec4),
    square: wp.array2d(dtype=wp.vec4),
    # State out:
    next_out: State,
    share_out: wp.array2d(dtype=wp.float32),
):
    """Move every root one step along its gradient; what it carries follows."""
    candidate, obj = wp.tid()
    p = problem[candidate]
    o0 = t[0].object_start[p]
    share_out[candidate, obj] = 0.0
    if obj >= t[0].object_start[p + 1] - o0:
        return
    o = o0 + obj
    if t[0].object_root[o] != obj:
        return
    _e, share, _soft, g = members_energy(t, m, w, p, candidate, obj, s)
    share_out[candidate, obj] = share
    step = clock[0]
    life = float(step) / float(schedule.steps)
    rate = schedule.rate_end + 0.5 * (schedule.rate - schedule.rate_end) * (1.0 + wp.cos(wp.min(life, 1.0) * wp.pi))
    arm = 0.3 * t[0].object_radius[o][0] + 0.05
    g[3] = g[3] / arm  # as a length at the arm
    mu = BETA1 * mean[candidate, obj] + (1.0 - BETA1) * g
    nu = BETA2 * square[candidate, obj] + (1.0 - BETA2) * wp.cw_mul(g, g)
    mean[candidate, obj] = mu
    square[candidate, obj] = nu
    up = 1.0 / (1.0 - wp.pow(BETA1, float(step + 1)))
    down = 1.0 / (1.0 - wp.pow(BETA2, float(step + 1)))
    sigma = schedule.noise * wp.max(0.0, 1.0 - life / schedule.quiet)
    # a stream of its own for each candidate, object and step: no state to share between threads
    rng = wp.rand_init(int(s.rng[candidate]) + 7919 * step, obj)
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        d[c] = -rate * up * mu[c] / (wp.sqrt(down * nu[c]) + EPSILON) + sigma * wp.randn(rng)
    d[3] = d[3] / arm
    free = t[0].object_free[o]
    if (free & FREE_PLANE) == 0:
        d[0] = 0.0
        d[1] = 0.0
    if (free & FREE_Z) == 0:
        d[2] = 0.0
    if (free & FREE_YAW) == 0:
        d[3] = 0.0
    old = s.poses[candidate, obj]
    pose = old + d
    spin = wp.vec2(wp.cos(d[3]), wp.sin(d[3]))
    for k in range(t[0].member_start[o], t[0].member_start[o + 1]):
        i = t[0].member[k]
        child = s.poses[candidate, i]
        arm_i = plane_of(child) - plane_of(old)
        at = plane_of(pose) + spin[0] * arm_i + spin[1] * perp(arm_i)
        yaw = wrap(child[3] + d[3], TURN)
        next_out.poses[candidate, i] = wp.vec4(at[0], at[1], child[2] + d[2], yaw)
        next_out.turns[candidate, i] = wp.vec2(wp.cos(yaw), wp.sin(yaw))


@wp.kernel
def choose(
    # Problem:
    t: TablesRef,
    w: Weights,
    problem: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    options_out: wp.array2d(dtype=wp.int32),
    other_out: wp.array2d(dtype=wp.int32),
):
    """Give every relation its best option at the present poses, in both buffers."""
    candidate, rel = wp.tid()
    p = problem[candidate]
    r = t[0].relation_start[p] + rel
    if r < t[0].relation_start[p + 1]:
        parties = parties_of(t, t[0].object_start[p], r, s, candidate, View())
        option, _e, _g = best_option(t, r, 0, parties, w.knee)
        options_out[candidate, rel] = option
        other_out[candidate, rel] = option


@wp.kernel
def tick(
    # Problem:
    t: TablesRef,
    problem: wp.array(dtype=wp.int32),
    # State in:
    share: wp.array2d(dtype=wp.float32),
    # State out:
    clock_out: wp.array(dtype=wp.int32),
    total_out: wp.array(dtype=wp.float32),
):
    """Sum each candidate's energy; the first thread moves the step counter on."""
    candidate = wp.tid()
    p = problem[candidate]
    total = float(0.0)
    for obj in range(t[0].object_start[p + 1] - t[0].object_start[p]):
        total += share[candidate, obj]
    total_out[candidate] = total
    if candidate == 0:
        clock_out[0] = clock_out[0] + 1
