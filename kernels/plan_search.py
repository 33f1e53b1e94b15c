"""Search over the codes of floor plans: annealing by moves on slicing trees, one thread a candidate.

A move exchanges two cells, turns a cut or a subtree, exchanges the sides of a cut, moves a cell or a subtree to
another place, gives a cell more or less of the floor, adds a cell to a room or takes it away (a hall that bends), or
goes to another frame. After every move the cuts are placed anew and all rules are measured. A round begins with a
random forest; storeys that the round before left in order keep theirs.
"""

import warp as wp

from .array_access import item
from .plan_forests import drawn_frame, random_forest
from .plan_measures import hard_of, measure_plan
from .plan_moves import propose_move
from .plan_openings import openings_fail
from .plan_tables import FRONTS, HARD_WEIGHT, MAX_CELLS, MAX_CODE, MAX_DOORS, RULE_COUNT, PlanProblemRef, PlanState
from .plan_tree import lay_out, measure_trees
from .sample import uniform
from .warp_primitives import lanes_with

wp.set_module_options({"enable_backward": False, "fast_math": False})

# Lanes of a warp stand still while others do what they don't, so on a GPU they do the same things together; each
# candidate goes the same way all the same. Measured on one H200, docs/plans.md.
TOGETHER = wp.constant(4)  # so many wait for their openings before these are placed
TRIES = wp.constant(16)  # of proposals that are no move, before those that have one are measured
FINE = wp.constant(0.05)  # the temperature of valid plans at most: soft rows weigh less than hard ones
KEEPS = wp.constant(0.85)  # of the rounds begin with the storeys that were in order


@wp.func
def storeys_in_order(p: PlanProblemRef, blame: wp.int32):
    """Storeys (bits) none of whose rooms violates anything, where there are others; stairs do not count."""
    bad = int(0)
    for r in range(p[0].rooms):
        if ((blame >> r) & 1) != 0:
            bad = bad | item(p[0].room_storeys, r)
    all = (1 << p[0].storeys) - 1
    if bad == 0:
        return 0
    return all & ~bad


@wp.kernel
def search_plans(
    # Problem:
    p: PlanProblemRef,
    moves: wp.int32,
    more: wp.int32,
    hot: wp.float32,
    cold: wp.float32,
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: PlanState,
):
    """One round of each active candidate that is not valid yet: a random forest, then so many moves, annealed.

    Once a plan is valid, at most ``more`` moves follow, which make it better.
    """
    candidate = active[wp.tid()]
    if s.status[candidate] != 0:
        return
    rng = s.rng[candidate]
    code = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    trial = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    piece = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    end = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    least = wp.zeros(shape=(MAX_CODE,), dtype=wp.vec2i)
    share = wp.zeros(shape=(MAX_CODE,), dtype=wp.float32)
    box = wp.zeros(shape=(MAX_CODE,), dtype=wp.vec4i)
    level = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    new_level = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    cut = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    weight = wp.zeros(shape=(MAX_CELLS,), dtype=wp.float32)
    new_weight = wp.zeros(shape=(MAX_CELLS,), dtype=wp.float32)
    cells = wp.zeros(shape=(MAX_CELLS,), dtype=wp.vec4i)
    storey = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    touch = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    wets = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    area = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    must = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    parent = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    violation = wp.zeros(shape=(RULE_COUNT,), dtype=wp.float32)
    leaves = wp.zeros(shape=(MAX_DOORS,), dtype=wp.vec4i)
    leaf_level = wp.zeros(shape=(MAX_DOORS,), dtype=wp.int32)
    fronts = wp.zeros(shape=(FRONTS,), dtype=wp.vec4i)
    front_level = wp.zeros(shape=(FRONTS,), dtype=wp.int32)
    record = wp.zeros(shape=(9,), dtype=wp.int32)
    doors = s.doors[candidate]
    windows = s.windows[candidate]

    frame = int(0)
    n = int(0)
    tries = int(0)
    heat = float(hot)
    for k in range(p[0].cells):
        weight[k] = 1.0e-6 * float(item(p[0].room_area, item(p[0].cell_room, k))[1])
    kept = int(0)
    if s.length[candidate] > 0 and uniform(rng) < KEEPS:
        kept = storeys_in_order(p, s.blame[candidate])
    if kept != 0:
        frame = s.frame[candidate]
        for k in range(s.length[candidate]):
            code[k] = s.code[candidate, k]
        for k in range(p[0].cells):
            if (item(p[0].room_storeys, item(p[0].cell_room, k)) & kept) != 0:
                weight[k] = s.weight[candidate, k]
    while n == 0 and tries < 50:
        if kept == 0:
            frame = drawn_frame(p, uniform(rng))
        n = random_forest(p, frame, code, kept, trial, piece, record, new_weight, end, rng)
        tries += 1
    for k in range(p[0].cells):
        new_weight[k] = weight[k]
    guilty = int(0)
    energy = float(1.0e30)
    lowest = float(1.0e30)
    length = int(0)
    new_frame = int(frame)
    rate = wp.pow(cold / heat, 1.0 / float(wp.max(moves, 1)))
    number = int(0)
    last = int(moves)
    if n == 0:
        last = -1
    soft = float(0.0)
    value = float(0.0)
    ceiling = float(0.0)
    hard = float(0.0)
    blame = int(0)
    count = int(0)
    waits = wp.bool(False)  # for its openings to be placed
    while lanes_with(number <= last) > 0:
        tries = int(0)
        while n == 0 and number <= last and tries < TRIES:
            for k in range(length):
                trial[k] = code[k]
            for k in range(p[0].cells):
                new_weight[k] = weight[k]
            new_frame = frame
            n = propose_move(p, trial, length, level, new_frame, new_weight, piece, guilty, rng)
            heat *= rate
            number += 1
            tries += 1
        moves_on = number <= last and n > 0
        if moves_on and not waits:
            measure_trees(p, trial, n, new_weight, end, least, share)
            count = lay_out(p, new_frame, trial, n, True, end, least, share, box, new_level, cut, cells, storey)
            soft, blame = measure_plan(p, new_frame, count, cells, storey, touch, wets, area, must, parent, violation)
            hard = hard_of(violation)
            value = HARD_WEIGHT * hard + soft
            ceiling = energy - heat * wp.log(wp.max(uniform(rng), 1.0e-9))
            # only what would be taken is worth a search for the places of doors and windows
            waits = value <= ceiling and hard == 0.0
        if lanes_with(waits) >= TOGETHER or lanes_with(number <= last and not waits) == 0:
            if waits:
                failed, lost = openings_fail(
                    p, new_frame, count, cells, storey, area, must, parent,
                    leaves, leaf_level, fronts, front_level, record, doors, windows,
                )  # fmt: skip
                value += HARD_WEIGHT * failed + lost
                if failed == 0.0:
                    last = wp.min(last, number + more)
                    heat = wp.min(heat, FINE)
                waits = False
        if moves_on and not waits:
            if value <= ceiling:
                energy = value
                guilty = blame
                length = n
                frame = new_frame
                for k in range(n):
                    code[k] = trial[k]
                    level[k] = new_level[k]
                for k in range(p[0].cells):
                    weight[k] = new_weight[k]
                if value < lowest:
                    lowest = value
                    s.frame[candidate] = frame
                    s.blame[candidate] = blame
                    s.length[candidate] = n
                    for k in range(n):
                        s.code[candidate, k] = code[k]
                        s.cut[candidate, k] = cut[k]
                    for k in range(p[0].cells):
                        s.weight[candidate, k] = weight[k]
            n = 0
    s.energy[candidate] = lowest
    s.rng[candidate] = rng
    s.rounds[candidate] = s.rounds[candidate] + 1
