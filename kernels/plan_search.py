"""Search over the codes of floor plans: annealing by moves on slicing trees, one thread a candidate.

A move exchanges two cells, turns a cut or a subtree, exchanges the sides of a cut, moves a cell or a subtree to
another place, gives a cell more or less of the floor, adds a cell to a room or takes it away (a hall that bends), or
goes to another frame. After every move the cuts are placed anew and all rules are measured. A round begins with a random
forest; storeys that the round before left in order keep theirs.
"""

import warp as wp

from .plan_measures import hard_of, measure_plan
from .plan_openings import openings_fail
from .plan_tables import (
    APART,
    CIRCULATION,
    CUT_X,
    CUT_Y,
    FRONTS,
    HARD_WEIGHT,
    MAX_CELLS,
    MAX_CODE,
    MAX_DOORS,
    RULE_COUNT,
    PlanProblem,
    PlanState,
)
from .plan_tree import exchange_sides, insert_beside, lay_out, measure_trees, parent_of, subtree_end, take_out, turn_subtree
from .sample import pick, uniform

wp.set_module_options({"enable_backward": False, "fast_math": False})

SPINES = wp.constant(0.7)  # of the bays with a hall begin with rooms in rows along it
GUIDED = wp.constant(0.3)  # of the moves of cells go beside a room that an adjacency asks for
KEEPS = wp.constant(0.85)  # of the rounds begin with the storeys that were in order
BLAMED = wp.constant(0.4)  # of the moves begin at a room that violates something


@wp.func
def may_lie(p: PlanProblem, cell: wp.int32, storey: wp.int32):
    """Whether a cell may lie on a storey."""
    return ((p.room_storeys[p.cell_room[cell]] >> storey) & 1) != 0


@wp.func
def append_row(
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    cut: wp.int32,
    piece: wp.array(dtype=wp.int32),
    first: wp.int32,
    last: wp.int32,
):
    """Append a row of cells, each cut off from the rest along an axis; give the new length."""
    for k in range(first, last):
        if k + 1 < last:
            code[n] = cut
            n += 1
        code[n] = piece[k]
        n += 1
    return n


@wp.func
def append_spine(
    p: PlanProblem,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    hall: wp.int32,
    piece: wp.array(dtype=wp.int32),
    m: wp.int32,
    rng: wp.ref[wp.uint32],
):
    """Append a tree in which a hall lies between two rows of rooms, shared out by their floor; give the new length."""
    total = float(0.0)
    for k in range(m):
        total += float(p.room_area[piece[k]][1])
    half = total * (0.3 + 0.4 * uniform(rng))
    split = int(0)
    sum = float(0.0)
    while split < m and sum < half:
        sum += float(p.room_area[piece[split]][1])
        split += 1
    axis = pick(rng, 2)
    code[n] = CUT_X + axis
    n = append_row(code, n + 1, CUT_Y - axis, piece, 0, split)
    if split < m:
        code[n] = CUT_X + axis
        n += 1
    code[n] = hall
    return append_row(code, n + 1, CUT_Y - axis, piece, split, m)


@wp.func(inline=False)
def random_forest(
    p: PlanProblem,
    frame: wp.int32,
    old: wp.array(dtype=wp.int32),
    kept: wp.int32,
    code: wp.array(dtype=wp.int32),
    piece: wp.array(dtype=wp.int32),
    one: wp.array(dtype=wp.int32),
    left: wp.array(dtype=wp.float32),
    bay_of: wp.array(dtype=wp.int32),
    rng: wp.ref[wp.uint32],
):
    """Deal the rooms out to the frame's bays at random, as far as there is floor, and cut each bay; give the length.

    A bay with a hall often begins as two rows of rooms along it. Bays of storeys that are ``kept`` (bits) have the trees
    of the old code. 0: a bay would stay empty.
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
    root = int(0)
    for b in range(bays):
        if ((kept >> p.bay_storey[first + b]) & 1) != 0:
            last = subtree_end(old, root)
            for k in range(root, last):
                code[n] = old[k]
                n += 1
            root = last
            continue
        if kept != 0:
            root = subtree_end(old, root)
        # the bay's rooms in random order, and its hall
        m = int(0)
        hall = int(-1)
        for room in range(p.rooms):
            if bay_of[room] == b:
                if hall < 0 and (p.room_flags[room] & CIRCULATION) != 0:
                    hall = room
                else:
                    at = pick(rng, m + 1)
                    piece[m] = piece[at]
                    piece[at] = room
                    m += 1
        if m == 0 and hall < 0:
            return 0
        if hall >= 0 and m >= 2 and uniform(rng) < SPINES:
            n = append_spine(p, code, n, hall, piece, m, rng)
        else:
            if hall >= 0:
                at = pick(rng, m + 1)
                piece[m] = piece[at]
                piece[at] = hall
                m += 1
            begin = n
            code[n] = piece[0]
            n += 1
            for k in range(1, m):
                at = begin + pick(rng, n - begin)
                one[0] = piece[k]
                n = insert_beside(code, n, at, CUT_X + pick(rng, 2), uniform(rng) < 0.5, one, 1)
    return n


@wp.func
def place_of(code: wp.array(dtype=wp.int32), n: wp.int32, what: wp.int32):
    """Where in a code a cell is; -1: nowhere."""
    for t in range(n):
        if code[t] == what:
            return t
    return -1


@wp.func
def partner_of(p: PlanProblem, room: wp.int32, rng: wp.ref[wp.uint32]):
    """A room that a hard adjacency wants beside another, at random; -1: there is none."""
    count = p.adjacency.shape[0]
    if count == 0:
        return -1
    start = pick(rng, count)
    for k in range(count):
        at = (start + k) % count
        x = p.adjacency[at]
        if x[2] != APART and p.adjacency_weight[at] < 0.0:
            if x[0] == room:
                return x[1]
            if x[1] == room:
                return x[0]
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
def propose_move(
    p: PlanProblem,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    level: wp.array(dtype=wp.int32),
    frame: wp.ref[wp.int32],
    weight: wp.array(dtype=wp.float32),
    piece: wp.array(dtype=wp.int32),
    blame: wp.int32,
    rng: wp.ref[wp.uint32],
):
    """Change a code, its frame or its weights in place by one random move; the new length, or 0 where it is none.

    Cells of rooms that violate something (bits of ``blame``) are moved more often.
    """
    u = uniform(rng)
    t = pick(rng, n)
    if blame != 0 and uniform(rng) < BLAMED:
        for k in range(n):
            at = (t + k) % n
            if code[at] < CUT_X:
                if ((blame >> p.cell_room[code[at]]) & 1) != 0:
                    t = at
                    break
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
        if uniform(rng) < GUIDED and piece[m - 1] < CUT_X:
            other = partner_of(p, p.cell_room[piece[m - 1]], rng)
            if other >= 0:
                beside = place_of(code, shorter, other)
                if beside >= 0:
                    over = parent_of(code, beside)
                    at = beside
                    if over >= 0 and uniform(rng) < 0.5:
                        at = over
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


@wp.func
def storeys_in_order(p: PlanProblem, blame: wp.int32):
    """Storeys (bits) none of whose rooms violates anything, where there are others; stairs do not count."""
    bad = int(0)
    for r in range(p.rooms):
        if ((blame >> r) & 1) != 0:
            bad = bad | p.room_storeys[r]
    all = (1 << p.storeys) - 1
    if bad == 0:
        return 0
    return all & ~bad


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
    kept = int(0)
    if s.length[candidate] > 0 and uniform(rng) < KEEPS:
        kept = storeys_in_order(p, s.blame[candidate])
    if kept != 0:
        frame = s.frame[candidate]
        for k in range(s.length[candidate]):
            code[k] = s.code[candidate, k]
        for k in range(p.cells):
            if ((p.room_storeys[p.cell_room[k]] & kept)) != 0:
                weight[k] = s.weight[candidate, k]
    while n == 0 and tries < 50:
        if kept == 0:
            frame = drawn_frame(p, uniform(rng))
        n = random_forest(p, frame, code, kept, trial, piece, record, new_weight, end, rng)
        tries += 1
    for k in range(p.cells):
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
    while number <= last:
        if n > 0:
            measure_trees(p, trial, n, new_weight, end, least, share)
            count = lay_out(p, new_frame, trial, n, True, end, least, share, box, new_level, cut, cells, storey)
            soft, blame = measure_plan(
                p, new_frame, count, cells, storey, touch, wets, area, must, parent, violation
            )
            hard = hard_of(violation)
            value = HARD_WEIGHT * hard + soft
            ceiling = energy - heat * wp.log(wp.max(uniform(rng), 1.0e-9))
            if value <= ceiling and hard == 0.0:
                # only what would be taken is worth a search for the places of doors and windows
                failed, ends = openings_fail(
                    p, new_frame, count, cells, storey, area, must, parent,
                    leaves, leaf_level, fronts, front_level, record, doors, windows,
                )  # fmt: skip
                value += HARD_WEIGHT * failed + p.weights[4] * ends
                if failed == 0.0:
                    last = wp.min(last, number + more)
            if value <= ceiling:
                energy = value
                guilty = blame
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
                    s.blame[candidate] = blame
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
        n = propose_move(p, trial, length, level, new_frame, new_weight, piece, guilty, rng)
        heat *= rate
        number += 1
    s.energy[candidate] = lowest
    s.rng[candidate] = rng
    s.rounds[candidate] = s.rounds[candidate] + 1
