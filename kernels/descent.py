"""Descent by an update rule: one step skeleton, and the rules on it.

A step keeps the poses of the step before if they were best, takes every root's share and scaled gradient, asks the rule
for a displacement, and writes the poses of the next step, in one launch. Each thread reads the poses of the last step
and writes those of the next, so the order of threads does not matter and nothing is summed across threads.

A rule is ``rule(x: Update) -> Update``: it sets the displacement, and the averages that it keeps.
"""

from typing import Any, NamedTuple

import warp as wp

from .array_access import item
from .bodies import Candidate, candidate_of
from .step import AT_REST, Gradients, freedom, noise, place_members, scaled_gradient, stream, total_of, turning_arm
from .tables import Problems, TablesRef
from .warp_primitives import WARP_SIZE

# Fast sines on a GPU are good to a few micrometres; the layout that is kept is measured again with exact ones.
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

BETA1 = wp.constant(0.9)  # of the running mean of gradients
BETA2 = wp.constant(0.99)  # of the running mean of their squares
EPSILON = wp.constant(1.0e-6)
FLOOR = wp.constant(0.3)  # slope beside which smaller ones do not lengthen the step; a violated term has slope 1


@wp.struct
class Schedule:
    """Step sizes over the run: from rate to rate_end, noise from its start to none at ``quiet``."""

    steps: wp.int32
    rate: wp.float32  # [m]
    rate_end: wp.float32
    noise: wp.float32  # [m] standard deviation at the start; Langevin: temperature [m], in units of the energy
    quiet: wp.float32  # share of the run after which there is no noise


@wp.struct
class StepBuffer:
    """What a step leaves to the next; two of these take turns."""

    poses: wp.array2d(dtype=wp.vec4)
    turns: wp.array2d(dtype=wp.vec2)
    share: wp.array2d(dtype=wp.float32)  # [object, candidate]: of the roots, at these poses
    lowest: wp.array(dtype=wp.float32)  # [candidate]: lowest energy before these poses
    clock: wp.array(dtype=wp.int32)  # [1]: the step


@wp.struct
class DescentMemory:
    """What a descent keeps from step to step."""

    mean: wp.array2d(dtype=wp.vec4)  # [object, candidate]: running averages of the rule's own
    square: wp.array2d(dtype=wp.vec4)
    best: wp.array2d(dtype=wp.vec4)  # [candidate, object]: poses of the lowest energy so far
    rng: wp.array(dtype=wp.uint32)  # [candidate]


@wp.struct
class Update:
    """What a rule sees of a root, and what it leaves. Vectors are (x, y, z, yaw times the turning arm) [m]."""

    step: wp.int32
    rate: wp.float32  # [m] step size
    noise: wp.float32  # as in `Schedule`
    gradient: wp.vec4
    random: wp.vec4  # standard normal numbers; zero where there is no noise
    mean: wp.vec4  # running averages of the rule's own
    square: wp.vec4
    displacement: wp.vec4


@wp.func
def rate_at(schedule: Schedule, life: wp.float32):
    """Step size [m] after a share of the run: half a cosine from rate to rate_end."""
    return schedule.rate_end + 0.5 * (schedule.rate - schedule.rate_end) * (1.0 + wp.cos(wp.min(life, 1.0) * wp.pi))


@wp.func
def noise_at(schedule: Schedule, life: wp.float32):
    """Noise after a share of the run, falling linearly."""
    return schedule.noise * wp.max(0.0, 1.0 - life / schedule.quiet)


@wp.func
def mean_square(x: Update):
    """The running mean of the gradients' squares, and by what it is too small at the beginning."""
    square = BETA2 * x.square + (1.0 - BETA2) * wp.cw_mul(x.gradient, x.gradient)
    return square, 1.0 / (1.0 - wp.pow(BETA2, float(x.step + 1)))


@wp.func
def adam(x: Update):
    """Adam (Kingma & Ba 2015, "Adam: a method for stochastic optimization") with annealed noise."""
    square, down = mean_square(x)
    x.square = square
    x.mean = BETA1 * x.mean + (1.0 - BETA1) * x.gradient
    up = x.rate / (1.0 - wp.pow(BETA1, float(x.step + 1)))
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        d[c] = -up * x.mean[c] / (wp.sqrt(down * x.square[c]) + EPSILON)
    x.displacement = d + x.noise * x.random
    return x


@wp.func
def langevin(x: Update):
    """Annealed Langevin dynamics, preconditioned: gradient and noise of one temperature T.

    A step is d = -rate G g + sqrt(2 rate G T) N(0, 1) with the diagonal preconditioner G = 1 / (FLOOR + rms(g)) over
    the last gradients (Li, Chen, Carlson & Carin 2016, "Preconditioned stochastic gradient Langevin dynamics for deep
    neural networks"; like there, the term with the derivative of G is left out). As the rate goes to zero this samples
    from exp(-energy / T); the temperature falls to zero, and what remains of the run is a quiet descent.
    """
    square, down = mean_square(x)
    x.square = square
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for c in range(4):
        size = x.rate / (FLOOR + wp.sqrt(down * x.square[c]))
        d[c] = -size * x.gradient[c] + wp.sqrt(2.0 * size * x.noise) * x.random[c]
    x.displacement = d
    return x


@wp.func
def keep_last(t: TablesRef, c: Candidate, obj: wp.int32, now: StepBuffer, other: StepBuffer, memory: DescentMemory):
    """Keep the poses of the step before if they were the best; True: this thread has a root.

    Candidates at rest have no thread with a root: they are left as they are.
    """
    candidate = c.index
    o = c.first_object + obj
    if obj >= c.objects:
        return False
    low = now.lowest[candidate]
    if low <= AT_REST:
        other.lowest[candidate] = low
        return False
    total = total_of(other.share, candidate, c.objects)
    if obj == 0:
        other.lowest[candidate] = wp.where(total < low, total, low)
    if item(t[0].object_root, o) != obj:
        now.share[obj, candidate] = 0.0
        return False
    if total < low:
        for k in range(item(t[0].member_start, o), item(t[0].member_start, o + 1)):
            i = item(t[0].member, k)
            memory.best[candidate, i] = other.poses[candidate, i]
    return True


class UpdateRule(NamedTuple):
    """The kernel of one step by a rule, and whether it keeps a mean of gradients in ``mean``."""

    kernel: Any
    keeps_mean: bool


def update_rule(rule: wp.Function, keeps_mean: bool) -> UpdateRule:
    """Build the kernel of a rule."""
    with_mean = wp.constant(int(keeps_mean))

    @wp.kernel(name=f"step_of_{rule.key}")
    def step(
        # Problem:
        b: Problems,
        schedule: Schedule,
        # State in:
        each: Gradients,
        # State in and out:
        memory: DescentMemory,
        now: StepBuffer,
        other: StepBuffer,
    ):
        """Move every root one step by the rule; what it carries follows.

        ``each`` are every object's share of the energy and its gradient at the poses of this step, ``now``. The other
        buffer holds the step before, and then the next.
        """
        t = b.tables
        group, obj, lane = wp.tid()
        candidate = group * WARP_SIZE + lane
        if candidate >= b.problem.shape[0]:
            return
        if candidate == 0 and obj == 0:
            other.clock[0] = now.clock[0] + 1
        c = candidate_of(b, candidate)
        o = c.first_object + obj
        if not keep_last(t, c, obj, now, other, memory):
            return
        arm = turning_arm(t, o)
        share, g = scaled_gradient(t, o, obj, candidate, arm, each, now.poses)
        now.share[obj, candidate] = share
        x = Update()
        x.step = now.clock[0]
        life = float(x.step) / float(schedule.steps)
        x.rate = rate_at(schedule, life)
        x.noise = noise_at(schedule, life)
        x.gradient = g
        if with_mean != 0:
            x.mean = memory.mean[obj, candidate]
        x.square = memory.square[obj, candidate]
        if x.noise > 0.0:
            x.random = noise(stream(memory.rng[candidate], x.step, obj))
        x = rule(x)
        if with_mean != 0:
            memory.mean[obj, candidate] = x.mean
        memory.square[obj, candidate] = x.square
        d = wp.cw_mul(x.displacement, freedom(t, o))
        d[3] = d[3] / arm
        place_members(t, o, obj, candidate, d, now.poses, other.poses, other.turns)

    return UpdateRule(step, keeps_mean)


ADAM = update_rule(adam, keeps_mean=True)
LANGEVIN = update_rule(langevin, keeps_mean=False)
