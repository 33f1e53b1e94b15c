"""Parallel tempering: replicas of each candidate at a ladder of temperatures, which they exchange.

A candidate owns REPLICAS neighbouring rows of the state. Each holds one rung of the ladder, and samples
exp(-energy / T) by one of two moves, both under the Metropolis rule:

- a Langevin step of all that is free (MALA: Roberts & Tweedie 1996, "Exponential convergence of Langevin distributions
  and their discrete approximations"), its length adapted ever more slowly to the best acceptance (Andrieu & Thoms 2008,
  "A tutorial on adaptive MCMC");
- a jump of one object, or of it and all that is placed by it, to anywhere in the room, by quarter turns as a rule.

The energy is that of every relation's best option, so that an object that jumps may stand at another wall. Neighbouring
rungs then exchange their temperatures by the rule of replica exchange (Swendsen & Wang 1986; Geyer 1991).
"""

import warp as wp

from .bodies import object_count, root_at
from .features import TURN
from .geometry import plane_of, turn
from .sample import QUARTER
from .step import Gradients, freedom, noise, place_members, stream, total_of, turning_arm
from .tables import FREE_PLANE, FREE_TURNS, FREE_YAW, Problems, State, TablesRef
from .warp_primitives import WARP_SIZE
from .yaw_domain import yaw_at, yaw_count

wp.set_module_options({"enable_backward": False})

GROUPS = wp.constant(0.5)  # share of jumps that take along what is placed by the object
SQUARE = wp.constant(0.8)  # share of jumps that turn by quarters
TARGET = wp.constant(0.574)  # acceptance at which MALA explores fastest
PICKS = wp.constant(8)  # looks for an object that may jump
OF_ROW = wp.constant(1048576)  # streams of rows begin here, beyond those of objects

# ``Ladder.move``: the proposal of a row. Zero and above: a jump of that object.
FIRST = wp.constant(-1)  # the start, which is taken as it is
LANGEVIN = wp.constant(-2)
GROUP = wp.constant(65536)  # added to a jump of the whole group


@wp.struct
class Ladder:
    """Replicas and their rungs. A row is candidate * replicas + replica."""

    temperature: wp.array(dtype=wp.float32)  # [rung], in units of the energy [m], coldest first
    rung: wp.array(dtype=wp.int32)  # [row]
    step_size: wp.array(dtype=wp.float32)  # [candidate * replicas + rung]: length of Langevin steps, metres per slope
    energy: wp.array(dtype=wp.float32)  # [row]
    move: wp.array(dtype=wp.int32)  # [row]
    accepted: wp.array(dtype=wp.int32)  # [row]: 1 when the proposal was accepted
    better: wp.array(dtype=wp.int32)  # [row]: 1 when the proposal is the candidate's best so far
    lowest: wp.array(dtype=wp.float32)  # [candidate]
    best: wp.array2d(dtype=wp.vec4)  # [candidate, object]: poses of that energy
    clock: wp.array(dtype=wp.int32)  # [candidate]: all alike
    total: wp.array(dtype=wp.float32)  # [row]: energy of the proposal
    gradient: wp.array2d(dtype=wp.vec4)  # [object, row]: where the row is
    step: wp.array2d(dtype=wp.vec4)  # [object, row]: to the proposal


@wp.func
def exchange_odds(energy_a: wp.float32, temperature_a: wp.float32, energy_b: wp.float32, temperature_b: wp.float32):
    """Logarithm of the odds by which two replicas exchange their temperatures: 0 and above always."""
    return (1.0 / temperature_a - 1.0 / temperature_b) * (energy_a - energy_b)


@wp.func
def langevin_odds(
    step: wp.vec4, gradient: wp.vec4, proposal_gradient: wp.vec4, step_size: wp.float32, temperature: wp.float32
):
    """One object's part in the logarithm of how much likelier the way back is than the way there."""
    there = step + step_size * gradient
    back = step - step_size * proposal_gradient
    return (wp.dot(there, there) - wp.dot(back, back)) / (4.0 * step_size * temperature)


@wp.kernel
def copy_replicas(
    # Problem:
    replicas: wp.int32,
    problem: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    problem_out: wp.array(dtype=wp.int32),
    rows_out: State,
    rung_out: wp.array(dtype=wp.int32),
):
    """Give every candidate its replicas: the same poses, streams of their own, the rungs in order."""
    row, obj = wp.tid()
    candidate = row // replicas
    replica = row - candidate * replicas
    rows_out.poses[row, obj] = s.poses[candidate, obj]
    rows_out.turns[row, obj] = s.turns[candidate, obj]
    rows_out.anchors[row, obj] = s.anchors[candidate, obj]
    if obj == 0:
        problem_out[row] = problem[candidate]
        rows_out.rng[row] = wp.rand_init(int(s.rng[candidate]), replica)
        rung_out[row] = replica


@wp.kernel
def accept(
    # Problem:
    b: Problems,
    replicas: wp.int32,
    jumps: wp.float32,
    # State in:
    s: State,
    measured: Gradients,
    # State in and out:
    ladder: Ladder,
):
    """Decide on every row's proposal, adapt its step size, and draw what it tries next: a share of ``jumps`` jump."""
    t = b.tables
    row = wp.tid()
    p = b.problem[row]
    n = object_count(t, p)
    kind = ladder.move[row]
    now = ladder.clock[0]
    draw = stream(s.rng[row], now, OF_ROW)
    total = total_of(measured.share, row, n)
    ladder.total[row] = total
    rung = ladder.rung[row]
    temperature = ladder.temperature[rung]
    at = (row // replicas) * replicas + rung
    step_size = ladder.step_size[at]
    odds = (ladder.energy[row] - total) / temperature
    if kind == LANGEVIN:
        for obj in range(n):
            before = ladder.gradient[obj, row]
            after = measured.gradient[obj, row]
            odds += langevin_odds(ladder.step[obj, row], before, after, step_size, temperature)
        chance = float(0.0)  # stays zero when the odds are no number
        if odds > -50.0:
            chance = wp.exp(wp.min(odds, 0.0))
        ladder.step_size[at] = step_size * wp.exp(2.0 * (chance - TARGET) / wp.pow(1.0 + 0.1 * float(now), 0.6))
    accepted = kind == FIRST or wp.log(wp.randf(draw) + 1.0e-20) < odds
    ladder.accepted[row] = wp.where(accepted, 1, 0)
    if accepted:
        ladder.energy[row] = total
    move = int(LANGEVIN)
    if wp.randf(draw) < jumps:
        for _try in range(PICKS):
            obj = wp.min(int(wp.randf(draw) * float(n)), n - 1)
            if move == LANGEVIN and (t[0].object_free[t[0].object_start[p] + obj] & FREE_PLANE) != 0:
                move = obj
        if move != LANGEVIN and wp.randf(draw) < GROUPS:
            move += GROUP
    ladder.move[row] = move


@wp.kernel
def exchange(
    # Problem:
    replicas: wp.int32,
    # State in:
    s: State,
    # State in and out:
    ladder: Ladder,
):
    """Let neighbouring rungs of each candidate exchange replicas, even pairs and odd pairs in turn; note the best."""
    candidate = wp.tid()
    first = candidate * replicas
    now = ladder.clock[candidate]
    ladder.clock[candidate] = now + 1
    low = ladder.lowest[candidate]
    best = int(-1)
    for row in range(first, first + replicas):
        ladder.better[row] = 0
        if ladder.total[row] < low:
            low = ladder.total[row]
            best = row
    if best >= 0:
        ladder.better[best] = 1
        ladder.lowest[candidate] = low
    draw = stream(s.rng[first], now, OF_ROW + 1)
    for cold in range(now % 2, replicas - 1, 2):
        a = int(first)
        b = int(first)
        for row in range(first, first + replicas):
            if ladder.rung[row] == cold:
                a = row
            if ladder.rung[row] == cold + 1:
                b = row
        odds = exchange_odds(ladder.energy[a], ladder.temperature[cold], ladder.energy[b], ladder.temperature[cold + 1])
        if wp.log(wp.randf(draw) + 1.0e-20) < odds:
            ladder.rung[a] = cold + 1
            ladder.rung[b] = cold


@wp.func
def jumps_with(t: TablesRef, o0: wp.int32, move: wp.int32, obj: wp.int32):
    """True when a root takes part in a jump."""
    if move < GROUP:
        return obj == move
    o = o0 + move - GROUP
    for k in range(t[0].group_start[o], t[0].group_start[o + 1]):
        if t[0].group[k] == obj:
            return True
    return False


@wp.func
def jump(
    t: TablesRef,
    p: wp.int32,
    row: wp.int32,
    root: wp.int32,
    obj: wp.int32,
    seed: wp.uint32,
    poses: wp.array2d(dtype=wp.vec4),
):
    """How object ``obj`` moves when root jumps anywhere in the room's bounding box and takes it along."""
    draw = seed
    box = t[0].room_box[p]
    x = box[0] + wp.randf(draw) * (box[2] - box[0])
    y = box[1] + wp.randf(draw) * (box[3] - box[1])
    spin = float(0.0)
    if wp.randf(draw) < SQUARE:
        spin = QUARTER * wp.floor(4.0 * wp.randf(draw))
    else:
        spin = TURN * wp.randf(draw)
    o = t[0].object_start[p] + root
    if (t[0].object_free[o] & FREE_TURNS) != 0:
        spin = (
            yaw_at(t, o, wp.min(int(wp.randf(draw) * float(yaw_count(t, o))), yaw_count(t, o) - 1))
            - poses[row, root][3]
        )
    elif (t[0].object_free[o] & FREE_YAW) == 0:
        spin = 0.0
    at = plane_of(poses[row, root])
    pose = plane_of(poses[row, obj])
    d = wp.vec2(x, y) + turn(wp.vec2(wp.cos(spin), wp.sin(spin)), pose - at) - pose
    return wp.vec4(d[0], d[1], 0.0, spin)


@wp.kernel
def make_moves(
    # Problem:
    b: Problems,
    replicas: wp.int32,
    # State in:
    measured: Gradients,
    # State in and out:
    ladder: Ladder,
    s: State,
    proposal: State,
):
    """Carry out what was decided on every row's proposal and lay out the next one."""
    t = b.tables
    group, obj, lane = wp.tid()
    row = group * WARP_SIZE + lane
    o = root_at(b, row, obj)
    if o < 0:
        return
    candidate = row // replicas
    for k in range(t[0].member_start[o], t[0].member_start[o + 1]):
        i = t[0].member[k]
        if ladder.better[row] == 1:
            ladder.best[candidate, i] = proposal.poses[row, i]
        if ladder.accepted[row] == 1:
            s.poses[row, i] = proposal.poses[row, i]
    if ladder.accepted[row] == 1:
        ladder.gradient[obj, row] = measured.gradient[obj, row]
    free = freedom(t, o)
    move = ladder.move[row]
    d = wp.vec4(0.0, 0.0, 0.0, 0.0)
    if move == LANGEVIN:
        rung = ladder.rung[row]
        step_size = ladder.step_size[candidate * replicas + rung]
        sigma = wp.sqrt(2.0 * step_size * ladder.temperature[rung])
        random = noise(stream(s.rng[row], ladder.clock[candidate], obj))
        d = wp.cw_mul(free, sigma * random - step_size * ladder.gradient[obj, row])
        ladder.step[obj, row] = d
        d[3] = d[3] / turning_arm(t, o)
    elif jumps_with(t, o - obj, move, obj):
        seed = stream(s.rng[row], ladder.clock[candidate], OF_ROW + 2)
        if (t[0].object_free[o] & FREE_TURNS) != 0:
            free[3] = 1.0
        d = wp.cw_mul(free, jump(t, b.problem[row], row, move % GROUP, obj, seed, s.poses))
    place_members(t, o, obj, row, d, s.poses, proposal.poses, proposal.turns)
