"""Rounds of the search job by job, as a GPU goes through them: their start, and a transition after every job."""

import warp as wp

from .array_access import item
from .bodies import Candidate, candidate_of
from .jobs import JobResult, SearchState
from .starts import GIVEN, Plan
from .state_machine import MOVING, STOP, SURVEY
from .tables import Problems, State
from .transitions import transition
from .warp_primitives import warp_size

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.func
def initial_state(plan: Plan, c: Candidate, clock: wp.array(dtype=wp.int32), s: State):
    """The state at the start of a round."""
    for obj in range(c.objects):
        s.mark[c.index, obj] = 0
    d = SearchState()
    d.job = SURVEY
    d.phase = MOVING
    d.round = clock[0] % plan.rounds
    d.anchored = wp.where(plan.start == GIVEN and clock[0] // plan.rounds < plan.anchored_attempts, 1, 0)
    d.cursor = -1
    d.rng = item(s.stream, c.index, warp_size())
    return d


@wp.func
def finish_round(candidate: wp.int32, d: SearchState, s: State, total_out: wp.array(dtype=wp.float32)):
    """The end of a round."""
    total_out[candidate] = d.total
    s.stream[candidate, warp_size()] = d.rng


@wp.kernel
def start_rounds(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    active: wp.array(dtype=wp.int32),
    clock: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    # State out:
    search_state_out: wp.array(dtype=SearchState),
    busy_out: wp.array(dtype=wp.int32),
):
    """Start a round of every active candidate; the others have nothing to do."""
    candidate = wp.tid()
    if candidate == 0:
        busy_out[0] = 1
    d = SearchState()
    d.job = STOP
    if active[candidate] != 0:
        d = initial_state(plan, candidate_of(b, candidate), clock, s)
    search_state_out[candidate] = d


@wp.kernel
def advance(
    # Problem:
    b: Problems,
    plan: Plan,
    # State in:
    result: wp.array(dtype=JobResult),
    # State in and out:
    s: State,
    energy: wp.array2d(dtype=wp.float32),
    search_state: wp.array(dtype=SearchState),
    # State out:
    total_out: wp.array(dtype=wp.float32),
    busy_out: wp.array(dtype=wp.int32),
):
    """Apply the result of every candidate's job and choose its next. ``busy_out`` becomes 1 if any has one."""
    t = b.tables
    candidate = wp.tid()
    d = search_state[candidate]
    if d.job == STOP:
        return
    d = transition(t, plan, candidate_of(b, candidate), result[candidate], s, energy, d)
    search_state[candidate] = d
    if d.job == STOP:
        finish_round(candidate, d, s, total_out)
    else:
        busy_out[0] = 1
