"""Search over one candidate: relation-guided moves of single objects and whole groups, annealed, then a polish.

A round is a chain of jobs (`jobs`). Here one thread goes through a candidate's chain, which is how a CPU works. On a
GPU all candidates do their next job side by side: their poses are drawn, then rated (`proposals`), then it is decided
what is next (`transitions`). Energies are local: a move costs what touches the moved objects.
"""

import warp as wp

from .bodies import candidate_of
from .jobs import JobResult, Proposals, problems_at
from .plan import Plan, SearchRun
from .proposals import draw_proposals, find_gradient, rate_proposals
from .rounds import finish_round, initial_state
from .state_machine import GRADIENT, MOVE, STOP
from .tables import Problems, State
from .transitions import transition

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.kernel
def search(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in and out:
    s: State,
    proposals: Proposals,
    run: SearchRun,
):
    """Search each active candidate in place for one round, one after the other: for a CPU.

    A round that is broken off has no energy that is known, so that what was kept before stays the best.
    """
    candidate = wp.tid()
    if run.active[candidate] == 0:
        return
    c = candidate_of(b, candidate)
    d = initial_state(plan, c, run, s)
    while d.job != STOP and run.cut[0] == 0:
        anew = problems_at(b, d)
        if d.job >= MOVE:
            draw_proposals(anew, plan, c, d, 0, 1, s, proposals)
        x = JobResult()
        if d.job == GRADIENT:
            x = find_gradient(anew, c, d, s)
        else:
            x = rate_proposals(anew, plan, c, d, s, proposals)
        d = transition(b.tables, plan, c, x, s, d)
    if d.job != STOP:
        d.total = wp.inf
    finish_round(candidate, d, s, run)
