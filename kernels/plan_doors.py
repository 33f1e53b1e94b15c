"""Doors of a plan, in whole millimetres, each where it can be.

A door is tried at both ends and in the middle of every wall that its rooms share, its leaf in either room. A leaf takes
up the square of its width before the wall, which holds the quarter circle that it sweeps; that square is free of other
leaves and of what lies right before other doors.
"""

import warp as wp

from .array_access import item
from .plan_geometry import facade_overlap, has, next_cell, owner_of, shared_wall, takes_doors
from .plan_tables import CIRCULATION, ENTRANCE, HINGED, MAX_DOORS, OPEN, PASSAGE, SLIDES, SLIDING, PlanProblemRef

wp.set_module_options({"enable_backward": False})

APPROACH = wp.constant(250)  # [mm] before a door, which no other leaf stands in
NO_PLACE = wp.constant(1000)


@wp.func
def overlap(a: wp.vec4i, b: wp.vec4i):
    """Whether two rectangles have floor in common."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


@wp.func
def before_wall(side: wp.int32, face: wp.int32, low: wp.int32, width: wp.int32, depth: wp.int32):
    """The rectangle before a part of a wall: ``side`` is the wall's side of the room that it lies in."""
    if side == 0:
        return wp.vec4i(face, low, face + depth, low + width)
    if side == 1:
        return wp.vec4i(low, face, low + width, face + depth)
    if side == 2:
        return wp.vec4i(face - depth, low, face, low + width)
    return wp.vec4i(low, face - depth, low + width, face)


@wp.func
def is_free(
    zone: wp.vec4i, level: wp.int32, zones: wp.array(dtype=wp.vec4i), levels: wp.array(dtype=wp.int32), n: wp.int32
):
    """Whether a rectangle has no floor in common with any of some on its storey."""
    for k in range(n):
        if levels[k] == level and overlap(zone, zones[k]):
            return False
    return True


@wp.func
def door_place(low: wp.int32, high: wp.int32, width: wp.int32, jamb: wp.int32, place: wp.int32):
    """Where a door begins on a wall: 0 at its low end, 1 at its high end, 2 in the middle."""
    if place == 0:
        return low + jamb
    if place == 1:
        return high - jamb - width
    return (low + high - width) / 2


@wp.func
def hinge_of(side: wp.int32, at_low: wp.bool):
    """0 where the hinge is to the left of who comes in through a wall on this side of the room, else 1."""
    # who comes in from the west walks east, with the high end of the wall to the left; from the north likewise
    left_is_high = side == 0 or side == 3
    if left_is_high == at_low:
        return 1
    return 0


@wp.func
def place_door(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    a: wp.int32,
    b: wp.int32,
    width: wp.int32,
    kind: wp.int32,
    leaves: wp.array(dtype=wp.vec4i),
    leaf_level: wp.array(dtype=wp.int32),
    fronts: wp.array(dtype=wp.vec4i),
    front_level: wp.array(dtype=wp.int32),
    n: wp.int32,
    record: wp.array(dtype=wp.int32),
):
    """Find the place of door number ``n`` from room a to b (-1: outdoors) with the least to be said against it.

    Sets its leaf (empty for passages), what lies before it on both sides, and its record; gives the penalty, which is
    `NO_PLACE` where there is none.
    """
    best = int(NO_PLACE)
    empty = wp.vec4i(0, 0, 0, 0)
    i = next_cell(p, frame, count, storey, a, -1)
    while i < count:
        if takes_doors(p, frame, i):
            ca = cells[i]
            others = count
            if b < 0:
                others = p[0].facade.shape[0]
            for j in range(others):
                low = int(0)
                high = int(0)
                side = int(0)
                cb = empty
                if b < 0:
                    if (item(p[0].facade_flags, j) & ENTRANCE) != 0 and storey[i] == 0:
                        s = facade_overlap(item(p[0].facade, j), ca)
                        low = s[0]
                        high = s[1]
                        side = item(p[0].facade, j)[0]
                elif storey[j] == storey[i] and owner_of(p, frame, j) == b and takes_doors(p, frame, j):
                    cb = cells[j]
                    if shared_wall(ca, cb, p[0].inner) > 0:
                        axis = wp.where(cb[0] - ca[2] == p[0].inner or ca[0] - cb[2] == p[0].inner, 0, 1)
                        if axis == 1 and not (cb[1] - ca[3] == p[0].inner or ca[1] - cb[3] == p[0].inner):
                            axis = 0
                        side = wp.where(cb[axis] > ca[axis], axis + 2, axis)
                        low = wp.max(ca[1 - axis], cb[1 - axis])
                        high = wp.min(ca[3 - axis], cb[3 - axis])
                if high - low >= width + 2 * p[0].jamb:
                    axis = side % 2
                    face_a = ca[side]
                    opposite = (side + 2) % 4
                    for place in range(3):
                        at = door_place(low, high, width, p[0].jamb, place)
                        front_a = before_wall(side, face_a, at, width, APPROACH)
                        front_b = empty
                        if b >= 0:
                            front_b = before_wall(opposite, cb[opposite], at, width, APPROACH)
                        clear = is_free(front_a, storey[i], leaves, leaf_level, n)
                        if b >= 0:
                            clear = clear and is_free(front_b, storey[i], leaves, leaf_level, n)
                        if clear:
                            for option in range(3):
                                # 0: the leaf in b, 1: in a, 2: none
                                penalty = int(wp.where(place == 2, 2, 0))
                                leaf = empty
                                fits = True
                                into = int(-1)
                                in_cell = ca
                                in_side = int(side)
                                if option == 0:
                                    into = b
                                    in_cell = cb
                                    in_side = opposite
                                    fits = b >= 0 and kind == HINGED
                                elif option == 1:
                                    into = a
                                    fits = kind == HINGED
                                    if b >= 0:
                                        penalty += wp.where(has(p, a, CIRCULATION), 12, 6)
                                else:
                                    fits = kind == PASSAGE
                                    if kind == HINGED and b >= 0:
                                        fits = has(p, a, SLIDING) or has(p, b, SLIDING)
                                        penalty += 30
                                at_low = True
                                if fits and option < 2:
                                    depth = in_cell[axis + 2] - in_cell[axis]
                                    leaf = before_wall(in_side, in_cell[in_side], at, width, width)
                                    fits = depth >= width
                                    fits = fits and is_free(leaf, storey[i], leaves, leaf_level, n)
                                    fits = fits and is_free(leaf, storey[i], fronts, front_level, 2 * n)
                                    to_low = at - in_cell[1 - axis]
                                    to_high = in_cell[3 - axis] - at - width
                                    at_low = to_low <= to_high
                                    # a leaf swings best against a wall
                                    penalty += wp.min(wp.min(to_low, to_high) / 400, 4)
                                if fits and penalty < best:
                                    best = penalty
                                    leaves[n] = leaf
                                    leaf_level[n] = storey[i]
                                    fronts[2 * n] = front_a
                                    fronts[2 * n + 1] = front_b
                                    front_level[2 * n] = storey[i]
                                    front_level[2 * n + 1] = storey[i]
                                    record[0] = a
                                    record[1] = b
                                    record[2] = side
                                    record[3] = wp.where(axis == 0, face_a, at)
                                    record[4] = wp.where(axis == 0, at, face_a)
                                    record[5] = width
                                    record[6] = kind
                                    if option == 2 and kind == HINGED:
                                        record[6] = SLIDES
                                    record[7] = into
                                    record[8] = 0
                                    if option < 2:
                                        record[8] = hinge_of(in_side, at_low)
        i = next_cell(p, frame, count, storey, a, i)
    return best


@wp.func
def kind_between(p: PlanProblemRef, a: wp.int32, b: wp.int32):
    """What joins two rooms whose door an adjacency asks for: its kind and width [mm]; -1: nothing asks for one."""
    for k in range(p[0].adjacency.shape[0]):
        x = item(p[0].adjacency, k)
        if (x[0] == a and x[1] == b) or (x[0] == b and x[1] == a):
            if x[2] == OPEN:
                return PASSAGE, x[3]
            if x[2] == HINGED:  # the kind DOOR of adjacencies
                return HINGED, x[3]
    return -1, 0


@wp.func
def place_doors(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    must: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
    leaves: wp.array(dtype=wp.vec4i),
    leaf_level: wp.array(dtype=wp.int32),
    fronts: wp.array(dtype=wp.vec4i),
    front_level: wp.array(dtype=wp.int32),
    record: wp.array(dtype=wp.int32),
    doors: wp.array2d(dtype=wp.int32),
):
    """Place the entrance's door and all others; how many, and how many found no place."""
    n = int(0)
    failed = int(0)
    for turn in range(p[0].rooms + 1):
        b = turn - 1
        first = int(0)
        last = int(p[0].rooms)
        if turn == 0:
            last = 1
        for o in range(first, last):
            a = int(o)
            wanted = turn == 0
            kind = int(HINGED)
            width = int(p[0].entrance_door)
            if turn == 0:
                a = p[0].entrance
            else:
                asked = ((must[b] >> a) & 1) != 0 and a < b
                led = parent[b] == a and ((must[b] >> a) & 1) == 0
                wanted = asked or led
                if wanted:
                    width = wp.min(item(p[0].room_door, a), item(p[0].room_door, b))
                    if asked:
                        of, wide = kind_between(p, a, b)
                        if of >= 0:
                            kind = of
                            width = wide
            if wanted:
                if n >= MAX_DOORS:
                    failed += 1
                else:
                    # the leaf goes into the room that is entered, which leads on less
                    from_ = a
                    to = b
                    if b >= 0:
                        if item(p[0].room_rank, a) > item(p[0].room_rank, b):
                            from_ = b
                            to = a
                    penalty = place_door(
                        p, frame, count, cells, storey, from_, to, width, kind,
                        leaves, leaf_level, fronts, front_level, n, record,
                    )  # fmt: skip
                    if penalty < NO_PLACE:
                        for k in range(9):
                            doors[n, k] = record[k]
                        n += 1
                    else:
                        failed += 1
    return n, failed
