"""What a search is told, and where a run of it stands."""

import warp as wp

wp.set_module_options({"enable_backward": False})

# Where an attempt begins, ``Plan.start``.
GIVEN = 0
ANYWHERE = 1
RELATIONS = 2
DRAWN = 3  # as it stands, which was drawn before; later attempts draw from the relations


@wp.struct
class Plan:
    """How a search goes about it, in work units. A run is attempts of so many rounds; the clock counts rounds."""

    steps: wp.int32  # rounds of all attempts
    first_steps: wp.int32  # rounds after which candidates leave that never came close to valid
    rounds: wp.int32  # rounds of one attempt
    start: wp.int32  # GIVEN, ANYWHERE, RELATIONS or DRAWN; later attempts draw from the relations
    anchored_attempts: wp.int32  # with GIVEN: attempts that begin there and keep what is in order where it is
    mixing: wp.float32  # moves for each movable object, picked at random, that an attempt begins with
    moves: wp.int32  # in a round, for each movable object
    proposals: wp.int32
    slide: wp.float32  # share of proposals that are slid flush with something
    whole: wp.float32  # share of moves that take along what the object places
    rates: wp.int32  # 1: what such a move took along is rated at once, else at the next survey
    polish: wp.int32  # gradient sweeps at the end of a round
    tries: wp.int32  # step lengths of one gradient step
    eases_from: wp.int32  # rounds after which soft relations give way late in an attempt that violates hard terms,
    eases_over: wp.int32  # and in how many more they come to do so from its start
    soft_moves: wp.int32  # moves for each movable object spent on soft relations once the hard ones hold
    temperature: wp.float32  # [m] temperature at the start of an attempt
    anchored_temperature: wp.float32


@wp.struct
class SearchRun:
    """Where a run stands, beside the layouts themselves."""

    clock: wp.array(dtype=wp.int32)  # [1]: rounds done
    active: wp.array(dtype=wp.int32)  # [candidate]: 1 while it is searched
    total: wp.array(dtype=wp.float32)  # [candidate]: energy after the last round
    hard: wp.array(dtype=wp.float32)  # [candidate]: of that, what soft terms do not make up
    best: wp.array2d(dtype=wp.vec4)  # [candidate, object]: poses of the lowest hard energy so far, then of the lowest
    best_total: wp.array(dtype=wp.float32)  # [candidate]: their energy
    best_hard: wp.array(dtype=wp.float32)  # [candidate]: of that, what soft terms do not make up
    left: wp.array(dtype=wp.int32)  # [2]: candidates that go on, and those that just left without being valid
    more: wp.array(dtype=wp.int32)  # [1]: 1 when another round is due
    cut: wp.array(dtype=wp.int32)  # [1]: from 1 on, rounds on a CPU break off where they are
