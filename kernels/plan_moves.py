"""Moves on the codes of plans."""

import warp as wp

from .array_access import item
from .plan_forests import drawn_frame, may_lie
from .plan_tables import APART, CUT_X, MAX_CODE, PlanProblemRef
from .plan_tree import exchange_sides, insert_beside, parent_of, take_out, turn_subtree
from .sample import pick, uniform

wp.set_module_options({"enable_backward": False})

GUIDED = wp.constant(0.3)  # of the moves of cells go beside a room that an adjacency asks for
BLAMED = wp.constant(0.4)  # of the moves begin at a room that violates something


@wp.func
def place_of(code: wp.array(dtype=wp.int32), n: wp.int32, what: wp.int32):
    """Where in a code a cell is; -1: nowhere."""
    for t in range(n):
        if code[t] == what:
            return t
    return -1


@wp.func
def partner_of(p: PlanProblemRef, room: wp.int32, rng: wp.ref[wp.uint32]):
    """A room that a hard adjacency wants beside another, at random; -1: there is none."""
    count = p[0].adjacency.shape[0]
    if count == 0:
        return -1
    start = pick(rng, count)
    for k in range(count):
        at = (start + k) % count
        x = item(p[0].adjacency, at)
        if x[2] != APART and item(p[0].adjacency_weight, at) < 0.0:
            if x[0] == room:
                return x[1]
            if x[1] == room:
                return x[0]
    return -1


@wp.func
def propose_move(
    p: PlanProblemRef,
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
                if ((blame >> item(p[0].cell_room, code[at])) & 1) != 0:
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
            other = partner_of(p, item(p[0].cell_room, piece[m - 1]), rng)
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
        wanted = 1.0e-6 * float(item(p[0].room_area, item(p[0].cell_room, what))[1])
        weight[what] = wp.clamp(weight[what] * wp.exp(0.6 * (uniform(rng) - 0.5)), 0.2 * wanted, 4.0 * wanted)
        return n
    if u < 0.97:
        if p[0].cells == p[0].rooms:
            return 0
        extra = p[0].rooms + pick(rng, p[0].cells - p[0].rooms)
        there = place_of(code, n, extra)
        if there >= 0:
            parent = parent_of(code, there)
            if parent < 0:
                return 0
            m = take_out(code, n, there, parent, piece)
            return n - m - 1
        home = place_of(code, n, item(p[0].cell_room, extra))
        if n + 2 > MAX_CODE or home < 0 or level[t] != level[home]:
            return 0
        piece[0] = extra
        weight[extra] = (
            1.0e-6 * float(item(p[0].room_area, item(p[0].cell_room, extra))[1]) * (0.2 + 0.5 * uniform(rng))
        )
        return insert_beside(code, n, t, CUT_X + pick(rng, 2), uniform(rng) < 0.5, piece, 1)
    family = item(p[0].frame_family, frame)
    low = float(0.0)
    if family[0] > 0:
        low = item(p[0].frame_share, family[0] - 1)
    frame = drawn_frame(p, low + uniform(rng) * (item(p[0].frame_share, family[1] - 1) - low))
    return n
