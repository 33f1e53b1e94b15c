"""What a search does with one candidate: a chain of *jobs*, each a number of *proposals*, with a transition after each.

A proposal is rated by the energy of some objects as a `View` sees them. Between two jobs a candidate's search is all in
its `SearchState`, so that the proposals of a job, and the jobs of different candidates, may be rated anywhere.
"""

import warp as wp

from .array_access import item
from .bodies import Candidate
from .groups import members_end
from .plan import Plan
from .state_machine import MOVE, RATE, RETURN, SQUARE, STEP, SURVEY
from .tables import Problems, TablesRef

wp.set_module_options({"enable_backward": False})

SOLVED = wp.constant(1.0e-9)
BACK_STEPS = wp.constant(4)  # shares of the way back that are tried


@wp.struct
class SearchState:
    """Where the search of a candidate stands: the job to be done, and what is remembered between jobs."""

    job: wp.int32
    phase: wp.int32
    round: wp.int32  # of the attempt
    anchored: wp.int32  # 1: the attempt keeps what is in order where it is
    move: wp.int32  # moves made in this round
    soft_moves: wp.int32  # of these, those made for soft relations, since the hard ones held
    sweep: wp.int32  # gradient sweeps
    finishing_passes: wp.int32
    solved: wp.int32
    obj: wp.int32  # whose turn it is
    cursor: wp.int32  # where polishing or tidying is among the objects
    first: wp.int32  # the range of its group that goes along
    last: wp.int32
    stamp: wp.int32  # of their marks
    draft: wp.int32  # 1: their surfaces are laid out anew in `State.draft`
    seed: wp.int32  # of the streams that proposals are drawn from
    total: wp.float32  # energy at the last survey
    hard: wp.float32  # of that, what soft terms do not make up
    late: wp.float32  # last share of the attempt, in which soft relations give way where hard terms are violated
    soft: wp.float32  # share of their weight that soft relations have in what a move costs
    threshold: wp.float32  # what a move may cost: the Metropolis rule, drawn ahead
    scale: wp.float32  # [m] of near proposals
    base: wp.float32  # energy that a step has to beat
    step: wp.vec4  # along the gradient
    rng: wp.uint32  # the candidate's own stream


@wp.struct
class JobResult:
    """What came of a job's proposals."""

    share: wp.float32  # sums of a survey
    soft: wp.float32
    base: wp.float32  # energy where the objects are
    gradient: wp.vec4
    least: wp.float32  # the best proposal: its energy, number, pose, rating and whether it took the draft
    index: wp.int32
    pose: wp.vec4
    rating: wp.float32
    draft: wp.int32


@wp.struct
class Proposals:
    """The poses that are tried, [candidate, proposal], and whether they take surfaces laid out anew."""

    poses: wp.array2d(dtype=wp.vec4)
    drafts: wp.array2d(dtype=wp.int32)


@wp.struct
class Jobs:
    """The job of every candidate, where all do theirs side by side.

    Launches go over a queue of the candidates that have a job, and each leaves the queue of the next job behind. The
    order within a queue is left to the device: no candidate depends on another.
    """

    state: wp.array(dtype=SearchState)  # [candidate]
    result: wp.array(dtype=JobResult)  # [candidate]
    queue: wp.array(dtype=wp.int32)  # [slot]: candidates that have a job now
    queued: wp.array(dtype=wp.int32)  # [1]: how many
    next_queue: wp.array(dtype=wp.int32)  # [slot]: those that have a job after it
    next_queued: wp.array(dtype=wp.int32)  # [1]


@wp.func
def queued_candidate(jobs: Jobs, slot: wp.int32):
    """The candidate of a slot of the queue; -1 beyond its end."""
    if slot >= jobs.queued[0]:
        return -1
    return jobs.queue[slot]


@wp.func
def problems_at(b: Problems, d: SearchState):
    """The problems with the weights of a job: something pulls back in anchored attempts, and what is soft gives way."""
    if d.anchored == 0:
        b.weights.pull = 0.0
    b.weights.soft = d.soft
    return b


@wp.func
def proposal_count(d: SearchState, c: Candidate, plan: Plan):
    """How many proposals a job rates."""
    if d.job == SURVEY:
        return c.objects
    if d.job == RATE:
        return d.last - d.first
    if d.job == MOVE:
        return 1 + plan.proposals
    if d.job == STEP:
        return plan.tries
    if d.job == SQUARE:
        return int(2)
    if d.job == RETURN:
        return BACK_STEPS
    return int(1)


@wp.func
def rates_only(job: wp.int32):
    """True when a job's proposals look at one object each, where it is."""
    return job == SURVEY or job == RATE


@wp.func
def object_of(t: TablesRef, d: SearchState, k: wp.int32):
    """The object that proposal k is about."""
    if d.job == SURVEY:
        return k
    if d.job == RATE:
        return item(t[0].group, d.first + k)
    return d.obj


@wp.func
def single_body(t: TablesRef, o: wp.int32):
    """The range of the group of object o (global) that is one body with it."""
    return item(t[0].group_start, o), members_end(t, o)
