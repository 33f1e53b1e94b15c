"""How a search for plans begins: rooms dealt out to bays, and trees over the rooms of each."""

import warp as wp

from .array_access import item
from .plan_tables import CIRCULATION, CUT_X, CUT_Y, PlanProblemRef
from .plan_tree import insert_beside, subtree_end
from .sample import pick, uniform

wp.set_module_options({"enable_backward": False})

SPINES = wp.constant(0.7)  # of the bays with a hall begin with rooms in rows along it


@wp.func
def may_lie(p: PlanProblemRef, cell: wp.int32, storey: wp.int32):
    """Whether a cell may lie on a storey."""
    return ((item(p[0].room_storeys, item(p[0].cell_room, cell)) >> storey) & 1) != 0


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
    p: PlanProblemRef,
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
        total += float(item(p[0].room_area, piece[k])[1])
    half = total * (0.3 + 0.4 * uniform(rng))
    split = int(0)
    sum = float(0.0)
    while split < m and sum < half:
        sum += float(item(p[0].room_area, piece[split])[1])
        split += 1
    axis = pick(rng, 2)
    code[n] = CUT_X + axis
    n = append_row(code, n + 1, CUT_Y - axis, piece, 0, split)
    if split < m:
        code[n] = CUT_X + axis
        n += 1
    code[n] = hall
    return append_row(code, n + 1, CUT_Y - axis, piece, split, m)


@wp.func
def random_forest(
    p: PlanProblemRef,
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

    A bay with a hall often begins as two rows of rooms along it. Bays of storeys that are ``kept`` (bits) have the
    trees of the old code. 0: a bay would stay empty.
    """
    first = item(p[0].bay_start, frame)
    bays = item(p[0].bay_start, frame + 1) - first
    for b in range(bays):
        r = item(p[0].bay, first + b)
        left[b] = 1.0e-6 * float(r[2] - r[0]) * float(r[3] - r[1])
    start = pick(rng, p[0].rooms)
    for k in range(p[0].rooms):
        room = (start + k) % p[0].rooms
        bay_of[room] = -1
        best = float(-1.0e9)
        if item(p[0].room_storeys, room) != 0:
            for b in range(bays):
                if may_lie(p, room, item(p[0].bay_storey, first + b)):
                    score = left[b] * (0.3 + uniform(rng))
                    if score > best:
                        best = score
                        bay_of[room] = b
            if bay_of[room] >= 0:
                left[bay_of[room]] = left[bay_of[room]] - 1.0e-6 * float(item(p[0].room_area, room)[1])
    n = int(0)
    root = int(0)
    for b in range(bays):
        if ((kept >> item(p[0].bay_storey, first + b)) & 1) != 0:
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
        for room in range(p[0].rooms):
            if bay_of[room] == b:
                if hall < 0 and (item(p[0].room_flags, room) & CIRCULATION) != 0:
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
def drawn_frame(p: PlanProblemRef, u: wp.float32):
    """The frame in whose part of the unit interval a number lies."""
    first = int(0)
    last = p[0].frames - 1
    while first < last:
        middle = (first + last) / 2
        if item(p[0].frame_share, middle) <= u:
            first = middle + 1
        else:
            last = middle
    return first
