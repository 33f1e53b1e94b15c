"""The state machine of the search: phases, jobs, events, and in one table what event leads to what job.

A round starts in MOVING with a SURVEY. When a job is done, its result is applied and the phase says which event that
is (`transitions`); TRANSITIONS says what comes next. A row without a job leads into another phase, which is asked for
its event in turn. Whoever enters a phase begins at the first object.
"""

import warp as wp

wp.set_module_options({"enable_backward": False})

# Phases of a round.
MOVING = wp.constant(0)  # objects move to poses drawn for them
POLISHING = wp.constant(1)  # objects take gradient steps, one after the other
FINISHING = wp.constant(2)  # nothing is at fault, or nothing helps: square up, or go back to the anchors
PHASES = 3

# Jobs.
SURVEY = wp.constant(0)  # rate every object
RATE = wp.constant(1)  # rate the objects of the group that has just moved, if they are not one body
MOVE = wp.constant(2)  # what the objects to be moved cost where they are, and proposals
GRADIENT = wp.constant(3)  # of one object
STEP = wp.constant(4)  # along it: a Polyak step towards zero energy, and shorter ones
SQUARE = wp.constant(5)  # turn what stands almost square to the room fully square, unless that costs anything
RETURN = wp.constant(6)  # take an object as far back to its anchor as costs nothing hard
STOP = wp.constant(7)
NO_JOB = wp.constant(8)  # another phase decides

# Events.
IN_ORDER = wp.constant(0)  # nothing is at fault, or nothing that may move
GROUP_MOVED = wp.constant(1)  # what went along has to be rated
SURVEY_DUE = wp.constant(2)
MOVES_SPENT = wp.constant(3)
OBJECT_CHOSEN = wp.constant(4)
SLOPE_FOUND = wp.constant(5)  # of an object that is at fault
SWEEPS_SPENT = wp.constant(6)
OFF_ANCHOR = wp.constant(7)  # an object is not where it was given
OFF_SQUARE = wp.constant(8)  # an object is almost square to the room
NOTHING_LEFT = wp.constant(9)
EVENTS = 10

TRANSITIONS = {
    (MOVING, IN_ORDER): (FINISHING, NO_JOB),
    (MOVING, GROUP_MOVED): (MOVING, RATE),
    (MOVING, SURVEY_DUE): (MOVING, SURVEY),
    (MOVING, MOVES_SPENT): (POLISHING, NO_JOB),
    (MOVING, OBJECT_CHOSEN): (MOVING, MOVE),
    (POLISHING, IN_ORDER): (FINISHING, NO_JOB),
    (POLISHING, SURVEY_DUE): (POLISHING, SURVEY),
    (POLISHING, OBJECT_CHOSEN): (POLISHING, GRADIENT),
    (POLISHING, SLOPE_FOUND): (POLISHING, STEP),
    (POLISHING, SWEEPS_SPENT): (POLISHING, STOP),
    (FINISHING, OFF_ANCHOR): (FINISHING, RETURN),
    (FINISHING, OFF_SQUARE): (FINISHING, SQUARE),
    (FINISHING, NOTHING_LEFT): (FINISHING, STOP),
}
"""(phase, event) to (phase, job). An event that a phase cannot have stops the round."""

_NEXT = [TRANSITIONS.get(divmod(row, EVENTS), (0, STOP)) for row in range(PHASES * EVENTS)]
_LOOKUP = "static const int next[] = {{{values}}}; return next[phase * {events} + event];"


@wp.func_native(_LOOKUP.format(values=", ".join(str(phase) for phase, _job in _NEXT), events=EVENTS))
def next_phase(phase: wp.int32, event: wp.int32) -> wp.int32:
    """The phase that an event leads to."""
    ...


@wp.func_native(_LOOKUP.format(values=", ".join(str(job) for _phase, job in _NEXT), events=EVENTS))
def next_job(phase: wp.int32, event: wp.int32) -> wp.int32:
    """The job that an event leads to; NO_JOB when the next phase decides."""
    ...
