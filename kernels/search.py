"""Search over one candidate: relation-guided moves of single objects and whole groups, annealed, then a polish.

A round is a chain of jobs (`jobs`). Here one thread goes through a candidate's chain, which is how a CPU works. On a
GPU all candidates do their next job side by side: their poses are drawn, then rated (`trials`), then it is decided what
is next (`decide`). Energies are local: a move costs what touches the moved objects.
"""

import warp as wp

from .begin import Plan
from .decide import decide, leave, sit_down
from .jobs import GRADIENT, MOVE, STOP, Found, at_home, weights_at
from .tables import Margins, State, TablesRef, Weights
from .trials import draw_trials, find_slope, rate_trials

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.kernel
def search(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    plan: Plan,
    problem: wp.array(dtype=wp.int32),
    # State in:
    open: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    drawn: wp.array2d(dtype=wp.vec4),
    drafted: wp.array2d(dtype=wp.int32),
    # State out:
    total_out: wp.array(dtype=wp.float32),
):
    """Search each open candidate in place for one round, one after the other: for a CPU."""
    candidate = wp.tid()
    if open[candidate] == 0:
        return
    p = problem[candidate]
    round = clock[0] % plan.rounds
    home = at_home(plan, clock)
    weights = weights_at(w, home)
    d = sit_down(t, p, candidate, s)
    while d.job != STOP:
        if d.job >= MOVE:
            draw_trials(t, m, weights, plan, home, p, candidate, d, 0, 1, s, drawn, drafted)
        x = Found()
        if d.job == GRADIENT:
            x = find_slope(t, m, weights, p, candidate, d, s)
        else:
            x = rate_trials(t, m, weights, plan, home, p, candidate, d, s, drawn, drafted, energy)
        d = decide(t, plan, round, home, p, candidate, x, s, energy, d)
    leave(candidate, d, s, total_out)
