"""Search over one candidate: relation-guided moves of single objects and whole groups, annealed, then a polish.

A round is a chain of jobs (`jobs`). Here one thread goes through a candidate's chain, which is how a CPU works. On a
GPU all candidates do their next job side by side: their poses are drawn, then rated (`proposals`), then it is decided
what is next (`transitions`). Energies are local: a move costs what touches the moved objects.
"""

import warp as wp

from .bodies import candidate_of
from .jobs import JobResult, weights_at
from .proposals import draw_proposals, find_gradient, rate_proposals
from .rounds import finish_round, initial_state
from .starts import Plan
from .state_machine import GRADIENT, MOVE, STOP
from .tables import Problems, State
from .transitions import transition

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.kernel
def search(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    active: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    drawn: wp.array2d(dtype=wp.vec4),
    drafted: wp.array2d(dtype=wp.int32),
    # State out:
    total_out: wp.array(dtype=wp.float32),
):
    """Search each active candidate in place for one round, one after the other: for a CPU."""
    t = b.tables
    m = b.margins
    candidate = wp.tid()
    if active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    d = initial_state(plan, c, clock, s)
    weights = weights_at(b.weights, d)
    while d.job != STOP:
        if d.job >= MOVE:
            draw_proposals(t, m, weights, plan, c, d, 0, 1, s, drawn, drafted)
        x = JobResult()
        if d.job == GRADIENT:
            x = find_gradient(t, m, weights, c, d, s)
        else:
            x = rate_proposals(t, m, weights, plan, c, d, s, drawn, drafted, energy)
        d = transition(t, plan, c, x, s, energy, d)
    finish_round(candidate, d, s, total_out)
