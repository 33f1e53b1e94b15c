"""Search over the codes of floor plans: annealing by moves on slicing trees, one thread a candidate.

A move exchanges two cells, turns a cut or a subtree, exchanges the sides of a cut, moves a cell or a subtree to
another place, gives a cell more or less of the floor, adds a cell to a room or takes it away (a hall that bends), or
goes to another frame. After every move the cuts are placed anew and all rules are measured. A round begins with a random
forest, unless the candidate is valid.
"""

import warp as wp

from .plan_measures import hard_of, measure_plan
from .plan_openings import openings_fail
from .plan_tables import (
    CUT_X,
    FRONTS,
    MAX_CELLS,
    MAX_CODE,
    MAX_DOORS,
    RULE_COUNT,
    PlanProblem,
    PlanState,
)
from .plan_tree import exchange_sides, insert_beside, lay_out, measure_trees, parent_of, take_out, turn_subtree
from .sample import pick, uniform

wp.set_module_options({"enable_backward": False, "fast_math": False})

HARD_WEIGHT = wp.constant(10.0)  # of a violation of 1, against soft rows


@wp.func
def may_lie(p: PlanProblem, cell: wp.int32, storey: wp.int32):
    """Whether a cell may lie on a storey."""
    return ((p.room_storeys[p.cell_room[cell]] >> storey) & 1) != 0


@wp.func(inline=False)
def random_forest(
    p: PlanProblem,
    frame: wp.int32,
    code: wp.array(dtype=wp.int32),
    piece: wp.array(dtype=wp.int32),
    left: wp.array(dtype=wp.float32),
    bay_of: wp.array(dtype=wp.int32),
    rng: wp.ref[wp.uint32],
):
    """Deal the rooms out to the frame's bays at random, as far as there is floor, and cut each bay; give the length.

    0: a bay would stay empty.
    """
    first = p.bay_start[frame]
    bays = p.bay_start[frame + 1] - first
    for b in range(bays):
        r = p.bay[first + b]
        left[b] = 1.0e-6 * float(r[2] - r[0]) * float(r[3] - r[1])
    start = pick(rng, p.rooms)
    for k in range(p.rooms):
        room = (start + k) % p.rooms
        bay_of[room] = -1
        best = float(-1.0e9)
        if p.room_storeys[room] != 0:
            for b in range(bays):
                if may_lie(p, room, p.bay_storey[first + b]):
                    score = left[b] * (0.3 + uniform(rng))
                    if score > best:
                        best = score
                        bay_of[room] = b
            if bay_of[room] >= 0:
                left[bay_of[room]] = left[bay_of[room]] - 1.0e-6 * float(p.room_area[room][1])
    n = int(0)
    for b in range(bays):
        root = n
        m = int(0)
        start = pick(rng, p.rooms)
        for k in range(p.rooms):
            room = (start + k) % p.rooms
            if bay_of[room] == b:
                if m == 0:
                    code[n] = room
                    n += 1
                else:
                    at = root + pick(rng, n - root)
                    piece[0] = room
                    n = insert_beside(code, n, at, CUT_X + pick(rng, 2), uniform(rng) < 0.5, piece, 1)
                m += 1
        if m == 0:
            return 0
    return n


@wp.func
def place_of(code: wp.array(dtype=wp.int32), n: wp.int32, what: wp.int32):
    """Where in a code a cell is; -1: nowhere."""
    for t in range(n):
        if code[t] == what:
            return t
    return -1


@wp.func
def drawn_frame(p: PlanProblem, u: wp.float32):
    """The frame in whose part of the unit interval a number lies."""
    first = int(0)
    last = p.frames - 1
    while first < last:
        middle = (first + last) / 2
        if p.frame_share[middle] <= u:
            first = middle + 1
        else:
            last = middle
    return first


@wp.func(inline=False)
def propose(
    p: PlanProblem,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    level: wp.array(dtype=wp.int32),
    frame: wp.ref[wp.int32],
    weight: wp.array(dtype=wp.float32),
    piece: wp.array(dtype=wp.int32),
    rng: wp.ref[wp.uint32],
):
    """Change a code, its frame or its weights in place by one random move; the new length, or 0 where it is none."""
    u = uniform(rng)
    t = pick(rng, n)
    what = code[t]
    if u < 0.3:
        other = pick(rng, n)
        with_ = code[other]
        if what >= CUT_X or with_ >= CUT_X or other == t:
            return 0
        if not may_lie(p, what, level[other]) or not may_lie(p, with_, level[t]):
            return 0
        code[t] = with_
        code[other] = what
        return n
    if u < 0.45:
        if what < CUT_X:
            return 0
        if uniform(rng) < 0.5:
            turn_subtree(code, t)
        else:
            code[t] = CUT_X + 1 - (what - CUT_X)
        return n
    if u < 0.53:
        if what < CUT_X:
            return 0
        exchange_sides(code, t, piece)
        return n
    if u < 0.75:
        if what >= CUT_X and uniform(rng) < 0.6:
            return 0
        parent = parent_of(code, t)
        if parent < 0:
            return 0
        storey = level[t]
        m = take_out(code, n, t, parent, piece)
        shorter = n - m - 1
        at = pick(rng, shorter)
        # where that place was before, for its storey
        before = at
        if at >= parent:
            before = at + 1
            if before >= t:
                before = at + 1 + m
        if level[before] != storey:
            for k in range(m):
                if piece[k] < CUT_X:
                    if not may_lie(p, piece[k], level[before]):
                        return 0
        return insert_beside(code, shorter, at, CUT_X + pick(rng, 2), uniform(rng) < 0.5, piece, m)
    if u < 0.92:
        if what >= CUT_X:
            return 0
        wanted = 1.0e-6 * float(p.room_area[p.cell_room[what]][1])
        weight[what] = wp.clamp(weight[what] * wp.exp(0.6 * (uniform(rng) - 0.5)), 0.2 * wanted, 4.0 * wanted)
        return n
    if u < 0.97:
        if p.cells == p.rooms:
            return 0
        extra = p.rooms + pick(rng, p.cells - p.rooms)
        there = place_of(code, n, extra)
        if there >= 0:
            parent = parent_of(code, there)
            if parent < 0:
                return 0
            m = take_out(code, n, there, parent, piece)
            return n - m - 1
        home = place_of(code, n, p.cell_room[extra])
        if n + 2 > MAX_CODE or home < 0 or level[t] != level[home]:
            return 0
        piece[0] = extra
        weight[extra] = 1.0e-6 * float(p.room_area[p.cell_room[extra]][1]) * (0.2 + 0.5 * uniform(rng))
        return insert_beside(code, n, t, CUT_X + pick(rng, 2), uniform(rng) < 0.5, piece, 1)
    family = p.frame_family[frame]
    low = float(0.0)
    if family[0] > 0:
        low = p.frame_share[family[0] - 1]
    frame = drawn_frame(p, low + uniform(rng) * (p.frame_share[family[1] - 1] - low))
    return n


@wp.kernel
def search_plans(
    # Problem:
    p: PlanProblem,
    moves: wp.int32,
    more: wp.int32,
    hot: wp.float32,
    cold: wp.float32,
    # State in and out:
    s: PlanState,
):
    """One round of each candidate that is not valid yet: a random forest, then so many moves, annealed.

    Once a plan is valid, at most ``more`` moves follow, which make it better.
    """
    candidate = wp.tid()
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
    for k in range(p.cells):
        weight[k] = 1.0e-6 * float(p.room_area[p.cell_room[k]][1])
    while n == 0 and tries < 50:
        frame = drawn_frame(p, uniform(rng))
        n = random_forest(p, frame, trial, piece, new_weight, end, rng)
        tries += 1
    for k in range(p.cells):
        new_weight[k] = weight[k]
    energy = float(1.0e30)
    lowest = float(1.0e30)
    length = int(0)
    new_frame = int(frame)
    rate = wp.pow(cold / heat, 1.0 / float(wp.max(moves, 1)))
    number = int(0)
    last = int(moves)
    if n == 0:
        last = -1
    while number <= last:
        if n > 0:
            measure_trees(p, trial, n, new_weight, end, least, share)
            count = lay_out(p, new_frame, trial, n, True, end, least, share, box, new_level, cut, cells, storey)
            soft = measure_plan(
                p, new_frame, count, cells, storey, touch, wets, area, must, parent, violation
            )
            hard = hard_of(violation)
            value = HARD_WEIGHT * hard + soft
            ceiling = energy - heat * wp.log(wp.max(uniform(rng), 1.0e-9))
            if value <= ceiling and hard == 0.0:
                # only what would be taken is worth a search for the places of doors and windows
                failed = openings_fail(
                    p, new_frame, count, cells, storey, area, must, parent,
                    leaves, leaf_level, fronts, front_level, record, doors, windows,
                )  # fmt: skip
                value += HARD_WEIGHT * failed
                if failed == 0.0:
                    last = wp.min(last, number + more)
            if value <= ceiling:
                energy = value
                length = n
                frame = new_frame
                for k in range(n):
                    code[k] = trial[k]
                    level[k] = new_level[k]
                for k in range(p.cells):
                    weight[k] = new_weight[k]
                if value < lowest:
                    lowest = value
                    s.frame[candidate] = frame
                    s.length[candidate] = n
                    for k in range(n):
                        s.code[candidate, k] = code[k]
                        s.cut[candidate, k] = cut[k]
                    for k in range(p.cells):
                        s.weight[candidate, k] = weight[k]
        for k in range(length):
            trial[k] = code[k]
        for k in range(p.cells):
            new_weight[k] = weight[k]
        new_frame = frame
        n = propose(p, trial, length, level, new_frame, new_weight, piece, rng)
        heat *= rate
        number += 1
    s.energy[candidate] = lowest
    s.rng[candidate] = rng
    s.rounds[candidate] = s.rounds[candidate] + 1
