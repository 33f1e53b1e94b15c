"""Limited-memory BFGS, every candidate on its own: the poses of its roots are the variables.

A step measures the energy at one trial layout, one thread per (candidate, object), then one thread per candidate
decides: a trial that lowers the energy enough (Armijo 1966) becomes the layout, and the two-loop recursion (Nocedal
1980, "Updating quasi-Newton matrices with limited storage") gives the next direction; else the step is cut back.
Candidates need not be at the same point of their line searches.

The energy has kinks, and jumps where the best option of a relation changes. Quasi-Newton steps get over most (Lewis &
Overton 2013, "Nonsmooth optimization via quasi-Newton methods"); pairs without positive curvature are left out, and
where no step along the gradient helps any more, the candidate is pushed at random out of its minimum and descends
again (basin hopping, Wales & Doye 1997).
"""

import warp as wp

from .bodies import object_count, root_at
from .step import AT_REST, Gradients, freedom, noise, place_members, stream, total_of, turning_arm
from .tables import Problems, State
from .warp_primitives import WARP_SIZE

wp.set_module_options({"enable_backward": False})

MEMORY = wp.constant(6)  # pairs of differences that are remembered
SLOTS = wp.constant(7)  # one more, so that a pair can be left out once it is written down
Weights6 = wp.types.vector(length=6, dtype=wp.float32)
DECREASE = wp.constant(1.0e-4)  # share of the predicted decrease that a trial has to reach
CURVATURE = wp.constant(1.0e-3)  # least cosine between the differences of poses and of gradients
REACH = wp.constant(0.3)  # [m] no object moves further in one step
LITTLE = wp.constant(1.0e-3)  # share of the energy: an accepted step that gains less is idle
IDLE = wp.constant(4)  # idle steps in a row after which nothing more is expected
TRIES = wp.constant(7)  # trials along one direction
FLAT = wp.constant(1.0e-10)  # squared gradient that leads nowhere

# ``Line.state``: what the trial of a candidate has led to.
REFUSED = wp.constant(0)  # the next trial is nearer
ACCEPTED = wp.constant(1)  # it is the layout now
STUCK = wp.constant(2)  # nothing helps: push
STUCK_BEST = wp.constant(3)  # the same, and the minimum is the lowest so far


@wp.struct
class History:
    """Differences of accepted steps, [slot, object, candidate], and how many of them [candidate] hold."""

    steps: wp.array3d(dtype=wp.vec4)
    gradient_changes: wp.array3d(dtype=wp.vec4)
    count: wp.array(dtype=wp.int32)
    head: wp.array(dtype=wp.int32)  # slot of the next pair


@wp.struct
class Line:
    """The line search of each candidate, [candidate]; directions and gradients [object, candidate]."""

    clock: wp.array(dtype=wp.int32)  # [1]
    best: wp.array2d(dtype=wp.vec4)  # [candidate, object]: poses of the lowest minimum
    energy: wp.array(dtype=wp.float32)  # of the layout; infinite: take any trial
    lowest: wp.array(dtype=wp.float32)  # of the minima found before
    step_length: wp.array(dtype=wp.float32)  # share of the direction that the trial takes
    slope: wp.array(dtype=wp.float32)  # of the energy along the direction
    tries: wp.array(dtype=wp.int32)
    idle: wp.array(dtype=wp.int32)
    state: wp.array(dtype=wp.int32)
    gradient: wp.array2d(dtype=wp.vec4)
    direction: wp.array2d(dtype=wp.vec4)


@wp.func
def dot3(a: wp.array3d(dtype=wp.vec4), slot: wp.int32, b: wp.array2d(dtype=wp.vec4), candidate: wp.int32, n: wp.int32):
    """Inner product of a slot of the history with a vector."""
    total = float(0.0)
    for obj in range(n):
        total += wp.dot(a[slot, obj, candidate], b[obj, candidate])
    return total


@wp.func
def store_pair(h: History, line: Line, trial_gradient: wp.array2d(dtype=wp.vec4), candidate: wp.int32, n: wp.int32):
    """Enter the accepted step into the history, unless the energy does not curve upwards along it."""
    slot = h.head[candidate]
    step_length = line.step_length[candidate]
    ss = float(0.0)
    sy = float(0.0)
    yy = float(0.0)
    for obj in range(n):
        a = step_length * line.direction[obj, candidate]
        b = trial_gradient[obj, candidate] - line.gradient[obj, candidate]
        h.steps[slot, obj, candidate] = a
        h.gradient_changes[slot, obj, candidate] = b
        ss += wp.dot(a, a)
        sy += wp.dot(a, b)
        yy += wp.dot(b, b)
    if sy > CURVATURE * wp.sqrt(ss * yy) and sy > 1.0e-12:
        h.head[candidate] = (slot + 1) % SLOTS
        h.count[candidate] = wp.min(h.count[candidate] + 1, MEMORY)


@wp.func
def two_loop_direction(h: History, line: Line, candidate: wp.int32, n: wp.int32):
    """Set the direction to minus the inverse Hessian that the history stands for, times the gradient; its slope."""
    count = h.count[candidate]
    newest = h.head[candidate] + SLOTS - 1
    for obj in range(n):
        line.direction[obj, candidate] = -line.gradient[obj, candidate]
    alpha = Weights6()
    inverse = Weights6()
    for k in range(count):
        slot = (newest - k) % SLOTS
        sy = float(0.0)
        sq = float(0.0)
        for obj in range(n):
            a = h.steps[slot, obj, candidate]
            sy += wp.dot(a, h.gradient_changes[slot, obj, candidate])
            sq += wp.dot(a, line.direction[obj, candidate])
        inverse[k] = 1.0 / sy
        alpha[k] = sq / sy
        for obj in range(n):
            line.direction[obj, candidate] = (
                line.direction[obj, candidate] - alpha[k] * h.gradient_changes[slot, obj, candidate]
            )
    if count > 0:
        yy = float(0.0)
        for obj in range(n):
            b = h.gradient_changes[newest % SLOTS, obj, candidate]
            yy += wp.dot(b, b)
        scale = 1.0 / (inverse[0] * yy)
        for obj in range(n):
            line.direction[obj, candidate] = scale * line.direction[obj, candidate]
    for i in range(count):
        k = count - 1 - i
        slot = (newest - k) % SLOTS
        beta = inverse[k] * dot3(h.gradient_changes, slot, line.direction, candidate, n)
        for obj in range(n):
            line.direction[obj, candidate] = (
                line.direction[obj, candidate] + (alpha[k] - beta) * h.steps[slot, obj, candidate]
            )
    slope = float(0.0)
    for obj in range(n):
        slope += wp.dot(line.gradient[obj, candidate], line.direction[obj, candidate])
    return slope


@wp.func
def start_line_search(h: History, line: Line, candidate: wp.int32, n: wp.int32):
    """Start a line search: direction, first step length, slope. False: the gradient leads nowhere."""
    slope = two_loop_direction(h, line, candidate, n)
    if not slope < 0.0:  # rounding: forget, and take the gradient
        h.count[candidate] = 0
        gg = float(0.0)
        for obj in range(n):
            g = line.gradient[obj, candidate]
            line.direction[obj, candidate] = -g
            gg += wp.dot(g, g)
        slope = -gg
    if not slope < -FLAT:
        return False
    far = float(0.0)
    for obj in range(n):
        far = wp.max(far, wp.length(line.direction[obj, candidate]))
    step_length = float(1.0)
    if h.count[candidate] == 0:
        step_length = line.energy[candidate] / -slope  # Polyak's step: the least energy is zero
    line.step_length[candidate] = wp.min(step_length, REACH / far)
    line.slope[candidate] = slope
    line.tries[candidate] = 0
    return True


@wp.kernel
def search_line(
    # Problem:
    b: Problems,
    # State in:
    measured: Gradients,
    # State in and out:
    h: History,
    line: Line,
):
    """Accept or refuse each candidate's trial, and say where the next one goes."""
    t = b.tables
    candidate = wp.tid()
    if candidate == 0:
        line.clock[0] = line.clock[0] + 1
    p = b.problem[candidate]
    n = object_count(t, p)
    energy = line.energy[candidate]
    if energy <= AT_REST:
        line.state[candidate] = REFUSED
        line.step_length[candidate] = 0.0
        return
    total = total_of(measured.share, candidate, n)
    step_length = line.step_length[candidate]
    slope = line.slope[candidate]
    state = int(REFUSED)
    anew = bool(False)
    spent = line.tries[candidate] == TRIES
    if energy == wp.inf or (total <= energy + DECREASE * step_length * slope and not (spent and step_length == 0.0)):
        if energy == wp.inf:
            h.count[candidate] = 0
            line.idle[candidate] = 0
        else:
            store_pair(h, line, measured.gradient, candidate, n)
            line.idle[candidate] = wp.where(energy - total < LITTLE * energy, line.idle[candidate] + 1, 0)
        for obj in range(n):
            line.gradient[obj, candidate] = measured.gradient[obj, candidate]
        line.energy[candidate] = total
        state = int(ACCEPTED)
        anew = True
    elif not spent:
        bend = total - energy - slope * step_length  # of the parabola through both energies and the slope
        line.step_length[candidate] = step_length * wp.clamp(
            -0.5 * slope * step_length / wp.max(bend, 1.0e-12), 0.1, 0.5
        )
        line.tries[candidate] = line.tries[candidate] + 1
    elif h.count[candidate] > 0:
        h.count[candidate] = 0
        anew = True
    else:
        state = int(STUCK)
    if anew:
        going = start_line_search(h, line, candidate, n)
        if state == ACCEPTED and (not going or line.idle[candidate] == IDLE):
            line.step_length[candidate] = 0.0  # the next trial is the layout itself, which leads to a push
            line.tries[candidate] = TRIES
            h.count[candidate] = 0
        elif not going:
            state = int(STUCK)
    if state == STUCK:
        if energy < line.lowest[candidate]:
            line.lowest[candidate] = energy
            state = int(STUCK_BEST)
        line.energy[candidate] = wp.inf
    line.state[candidate] = state


@wp.kernel
def make_trial(
    # Problem:
    b: Problems,
    push: wp.float32,
    steps: wp.int32,
    # State in:
    measured: Gradients,
    # State in and out:
    line: Line,
    s: State,
    trial: State,
):
    """Carry out what was decided and lay out the next trial: along the direction, or pushed out of a minimum.

    A push [m] (standard deviation, falling to zero over the steps) moves what has a share in the energy.
    """
    t = b.tables
    group, obj, lane = wp.tid()
    candidate = group * WARP_SIZE + lane
    o = root_at(b, candidate, obj)
    if o < 0:
        return
    state = line.state[candidate]
    for k in range(t[0].member_start[o], t[0].member_start[o + 1]):
        i = t[0].member[k]
        if state == ACCEPTED:
            s.poses[candidate, i] = trial.poses[candidate, i]
        elif state == STUCK_BEST:
            line.best[candidate, i] = s.poses[candidate, i]
        elif state == STUCK:
            s.poses[candidate, i] = line.best[candidate, i]
    d = line.step_length[candidate] * line.direction[obj, candidate]
    if state == STUCK or state == STUCK_BEST:
        step = line.clock[0]
        sigma = push * wp.max(0.0, 1.0 - float(step) / float(steps))
        if measured.share[obj, candidate] <= AT_REST:
            sigma = 0.0
        d = sigma * wp.cw_mul(noise(stream(s.rng[candidate], step, obj)), freedom(t, o))
    d[3] = d[3] / turning_arm(t, o)
    place_members(t, o, obj, candidate, d, s.poses, trial.poses, trial.turns)
