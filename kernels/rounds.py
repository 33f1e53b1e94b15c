"""Rounds of the search job by job, as a GPU goes through them: their start, and a transition after every job."""

import warp as wp

from .array_access import item
from .bodies import Candidate, candidate_of
from .jobs import Jobs, SearchState, queued_candidate
from .plan import GIVEN, Plan, SearchRun
from .state_machine import MOVING, RATE, STOP, SURVEY
from .tables import Problems, State
from .transitions import transition
from .warp_primitives import next_slot, warp_size

LATE = wp.constant(0.2)  # last share of an attempt in which soft relations give way at first; later ones have more


wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.func
def initial_state(plan: Plan, c: Candidate, run: SearchRun, s: State):
    """The state at the start of a round."""
    for obj in range(c.objects):
        s.mark[c.index, obj] = 0
    d = SearchState()
    d.phase = MOVING
    d.round = run.clock[0] % plan.rounds
    d.job = wp.where(plan.mixing > 0.0 and d.round == 0, RATE, SURVEY)  # to mix, no rating is needed: RATE of no group
    d.anchored = wp.where(plan.start == GIVEN and run.clock[0] // plan.rounds < plan.anchored_attempts, 1, 0)
    d.cursor = -1
    since = run.clock[0] - d.round - plan.eases_from
    d.late = wp.where(since < 0, 0.0, LATE + float(since) / float(plan.eases_over))
    d.soft = 1.0
    d.rng = item(s.stream, c.index, warp_size())
    return d


@wp.func
def finish_round(candidate: wp.int32, d: SearchState, s: State, run: SearchRun):
    """The end of a round."""
    run.total[candidate] = d.total
    run.hard[candidate] = d.hard
    s.stream[candidate, warp_size()] = d.rng


@wp.kernel
def start_rounds(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    run: SearchRun,
    # State in and out:
    s: State,
    jobs: Jobs,
):
    """Start a round of every active candidate; the others are not queued. The queue is empty before."""
    candidate = wp.tid()
    if run.active[candidate] != 0:
        jobs.state[candidate] = initial_state(plan, candidate_of(b, candidate), run, s)
        jobs.queue[next_slot(jobs.queued)] = candidate


@wp.kernel
def advance(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in and out:
    s: State,
    jobs: Jobs,
    run: SearchRun,
):
    """Apply the result of every queued candidate's job, choose its next, and queue it for that."""
    candidate = queued_candidate(jobs, wp.tid())
    if candidate < 0:
        return
    d = jobs.state[candidate]
    d = transition(b.tables, plan, candidate_of(b, candidate), jobs.result[candidate], s, d)
    jobs.state[candidate] = d
    if d.job == STOP:
        finish_round(candidate, d, s, run)
    else:
        jobs.next_queue[next_slot(jobs.next_queued)] = candidate
