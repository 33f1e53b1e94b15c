"""From a slicing tree's code to the rectangles of its cells, in whole millimetres.

Each cut shares the clear width of its rectangle out between the two sides in proportion to the floor that their cells
want, and is then projected onto the widths that the least sides of both sides leave open (a cut that leaves both room
enough always exists where the rectangle is large enough, because the least extents add up over the tree).
"""

import warp as wp

from .array_access import item
from .plan_tables import CUT_X, CUT_Y, MAX_CODE, PlanProblemRef

wp.set_module_options({"enable_backward": False})


@wp.func
def cut_between(low: wp.int32, high: wp.int32, least_low: wp.int32, least_high: wp.int32, at: wp.int32):
    """A place projected between ``low + least_low`` and ``high - least_high``; where that is empty, halfway."""
    first = low + least_low
    last = high - least_high
    if first > last:
        return (first + last) / 2
    return wp.clamp(at, first, last)


@wp.func
def measure_trees(
    p: PlanProblemRef,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    weight: wp.array(dtype=wp.float32),
    end: wp.array(dtype=wp.int32),
    least: wp.array(dtype=wp.vec2i),
    share: wp.array(dtype=wp.float32),
):
    """For each number of a code: where its subtree ends, its least extents [mm] and the floor that it wants [m2]."""
    for k in range(n):
        t = n - 1 - k
        what = code[t]
        if what < CUT_X:
            side = item(p[0].cell_side, what)
            end[t] = t + 1
            least[t] = wp.vec2i(side, side)
            share[t] = weight[what]
        else:
            b = end[t + 1]
            x = least[t + 1]
            y = least[b]
            end[t] = end[b]
            share[t] = share[t + 1] + share[b]
            if what == CUT_X:
                least[t] = wp.vec2i(x[0] + p[0].inner + y[0], wp.max(x[1], y[1]))
            else:
                least[t] = wp.vec2i(wp.max(x[0], y[0]), x[1] + p[0].inner + y[1])


@wp.func
def lay_out(
    p: PlanProblemRef,
    frame: wp.int32,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    fresh: wp.bool,
    end: wp.array(dtype=wp.int32),
    least: wp.array(dtype=wp.vec2i),
    share: wp.array(dtype=wp.float32),
    box: wp.array(dtype=wp.vec4i),
    level: wp.array(dtype=wp.int32),
    cut: wp.array(dtype=wp.int32),
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
):
    """Set the rectangle and storey of each number of a code and of each cell; give how many cells there are.

    ``fresh`` cuts come from the shares; others are taken from ``cut``. Both are projected, and stored. Fixed cells of
    the frame follow after those of trees.
    """
    for k in range(p[0].cells):
        storey[k] = -1
    root = int(0)
    for bay in range(item(p[0].bay_start, frame), item(p[0].bay_start, frame + 1)):
        box[root] = item(p[0].bay, bay)
        level[root] = item(p[0].bay_storey, bay)
        root = end[root]
    for t in range(n):
        what = code[t]
        r = box[t]
        if what < CUT_X:
            cells[what] = r
            storey[what] = level[t]
        else:
            a = t + 1
            b = end[a]
            axis = what - CUT_X
            low = r[axis]
            high = r[axis + 2]
            at = cut[t]
            if fresh:
                of_a = share[a] / (share[a] + share[b])
                at = low + int(wp.round(float(high - low - p[0].inner) * of_a))
            at = cut_between(low, high - p[0].inner, least[a][axis], least[b][axis], at)
            cut[t] = at
            ra = r
            rb = r
            ra[axis + 2] = at
            rb[axis] = at + p[0].inner
            box[a] = ra
            box[b] = rb
            level[a] = level[t]
            level[b] = level[t]
    count = p[0].cells
    for k in range(item(p[0].fixed_start, frame), item(p[0].fixed_start, frame + 1)):
        cells[count] = item(p[0].fixed, k)
        storey[count] = item(p[0].fixed_room, k)[1]
        count += 1
    return count


@wp.func
def subtree_end(code: wp.array(dtype=wp.int32), t: wp.int32):
    """Where the subtree that begins at a place of a code ends."""
    open = int(1)
    at = int(t)
    while open > 0 and at < MAX_CODE:
        open += wp.where(code[at] < CUT_X, -1, 1)
        at += 1
    return at


@wp.func
def insert_beside(
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    at: wp.int32,
    cut: wp.int32,
    after: wp.bool,
    piece: wp.array(dtype=wp.int32),
    m: wp.int32,
):
    """Put a piece of so many numbers beside the subtree at a place, under a new cut; give the new length."""
    end = subtree_end(code, at)
    shift = m + 1
    from_ = wp.where(after, end, at)
    for k in range(n - from_):
        j = n - 1 - k
        code[j + shift] = code[j]
    if after:
        for k in range(end - at):
            j = end - 1 - k
            code[j + 1] = code[j]
        for k in range(m):
            code[end + 1 + k] = piece[k]
    else:
        for k in range(m):
            code[at + 1 + k] = piece[k]
    code[at] = cut
    return n + shift


@wp.func
def parent_of(code: wp.array(dtype=wp.int32), t: wp.int32):
    """The cut right over the subtree at a place; -1: it is a whole tree."""
    open = int(0)  # whole subtrees that stand between
    at = int(t - 1)
    while at >= 0:
        if code[at] < CUT_X:
            open += 1
        else:
            if open <= 1:
                # a cut with none or one whole subtree after it is waiting for the one at t
                return at
            open -= 1  # two of them and the cut are one whole subtree
        at -= 1
    return -1


@wp.func
def take_out(
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    t: wp.int32,
    parent: wp.int32,
    piece: wp.array(dtype=wp.int32),
):
    """Take the subtree at a place out of a code, with the cut over it, into ``piece``; give its length."""
    end = subtree_end(code, t)
    m = end - t
    for k in range(m):
        piece[k] = code[t + k]
    for k in range(t - parent - 1):
        code[parent + k] = code[parent + 1 + k]
    for k in range(n - end):
        code[t - 1 + k] = code[end + k]
    return m


@wp.func
def exchange_sides(code: wp.array(dtype=wp.int32), t: wp.int32, piece: wp.array(dtype=wp.int32)):
    """Exchange the two sides of the cut at a place."""
    b = subtree_end(code, t + 1)
    end = subtree_end(code, b)
    for k in range(b - t - 1):
        piece[k] = code[t + 1 + k]
    for k in range(end - b):
        code[t + 1 + k] = code[b + k]
    for k in range(b - t - 1):
        code[t + 1 + end - b + k] = piece[k]


@wp.func
def turn_subtree(code: wp.array(dtype=wp.int32), t: wp.int32):
    """Exchange the axes of all cuts of the subtree at a place."""
    for k in range(t, subtree_end(code, t)):
        if code[k] >= CUT_X:
            code[k] = CUT_X + CUT_Y - code[k]
