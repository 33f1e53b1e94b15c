"""Annealing of an objective over packings of rectangles: proposals for what is packed too densely to be moved singly.

A sequence pair (Murata, Fujiyoshi, Nakatake, Kajitani 1996) is two orders of the blocks: one is left of another that
comes after it in both, and below another that comes before it in the first and after it in the second. Every block
goes as far to the left and down as these allow, by longest paths, found as weighted longest common subsequences
(Tang, Tian, Wong 2000). A move changes an order, or turns a block by a quarter. What reaches out of the room costs;
what lies inside is a layout, and counts only when the verdict calls it valid. One thread per candidate.
"""

from typing import TYPE_CHECKING

import warp as wp

from .anneal import TRIALS, Annealing, Cooling, all_soft
from .array_access import item, item_strided
from .bodies import Candidate, body_of, candidate_of, layout_of
from .geometry import plane_of
from .groups import move_with_members
from .objective import Objective, term_value
from .sample import pick, uniform
from .tables import Problems, State, Table, struct_of
from .terms_contacts import reach_of_pair
from .terms_relations import relation_of
from .verdict import contacts_hold, relation_holds, room_holds

wp.set_module_options({"enable_backward": False})

PACKING = (
    Table("block", ("block",), wp.int32, "", "root of each block"),
    Table("rectangle", ("4 block",), wp.vec4, "m", "its rectangle when turned by quarters: lowest x, y from it; size"),
    Table("turns", ("block",), wp.int32, "", "bits: the quarters that it may be turned by"),
    Table("heading", ("quarter",), wp.vec3, "rad", "cos, sin and yaw of each quarter in the room's frame"),
    Table("first", ("candidate", "block"), wp.int32, "", "blocks in the first order"),
    Table("place", ("candidate", "block"), wp.int32, "", "place of each block in the second order"),
    Table("turn", ("candidate", "block"), wp.int32, "", "quarters that each block is turned by"),
    Table("corner", ("candidate", "block"), wp.vec2, "m", "lower left corner of each block"),
    Table(
        "front", ("candidate", "block"), wp.float32, "m", "how far blocks reach up to each place of the second order"
    ),
)

# ``origin`` is the room's corner, ``axis`` its x axis and ``extent`` its size along both.
if TYPE_CHECKING:
    from .tables import Arrays

    class Packing(Arrays):
        """As below."""
else:
    Packing = struct_of(
        "Packing", "Sequence pairs of all candidates.", PACKING, origin=wp.vec2, axis=wp.vec2, extent=wp.vec2
    )


@wp.func
def pack_along(k: Packing, candidate: wp.int32, blocks: wp.int32, axis: wp.int32):
    """Set the corners along an axis (0: x, 1: y) and give how far the blocks reach."""
    for j in range(blocks):
        k.front[candidate, j] = 0.0
    for i in range(blocks):
        n = i
        if axis == 1:
            n = blocks - 1 - i
        block = item(k.first, candidate, n)
        p = item(k.place, candidate, block)
        rectangle = item(k.rectangle, 4 * block + item(k.turn, candidate, block))
        at = item(k.front, candidate, p)
        corner = k.corner[candidate, block]
        corner[axis] = at
        k.corner[candidate, block] = corner
        reach = at + rectangle[2 + axis]
        for j in range(p, blocks):
            if item(k.front, candidate, j) >= reach:
                break
            k.front[candidate, j] = reach
    return item(k.front, candidate, blocks - 1)


@wp.func
def place_blocks(b: Problems, k: Packing, c: Candidate, s: State, reach: wp.vec2):
    """Put every block, with what it carries, where it is packed; what is left of the room goes on both sides alike."""
    t = b.tables
    spare = 0.5 * wp.max(k.extent - reach, wp.vec2(0.0, 0.0))
    for block in range(k.block.shape[0]):
        root = item(k.block, block)
        quarter = item(k.turn, c.index, block)
        rectangle = item(k.rectangle, 4 * block + quarter)
        heading = item(k.heading, quarter)
        at = k.corner[c.index, block] - wp.vec2(rectangle[0], rectangle[1]) + spare
        x = k.origin[0] + at[0] * k.axis[0] - at[1] * k.axis[1]
        y = k.origin[1] + at[0] * k.axis[1] + at[1] * k.axis[0]
        old = item_strided(s.poses, c.index, root)
        pose = wp.vec4(x, y, old[2], heading[2])
        o = c.first_object + root
        if item(t[0].member_start, o + 1) > item(t[0].member_start, o) + 1:
            move_with_members(t, c.first_object, s, c.index, root, pose)
        else:
            s.poses[c.index, root] = pose
            s.turns[c.index, root] = wp.vec2(heading[0], heading[1])


@wp.func(inline=False)
def layout_holds(b: Problems, c: Candidate, s: State):
    """Whether the verdict has nothing against a layout."""
    t = b.tables
    for i in range(c.objects):
        x = body_of(c, i, s)
        if not wp.isfinite(x.pose):
            return False
        if not room_holds(b, c.problem, x):
            return False
        row = item(t[0].pair_start, c.problem) + i * c.objects
        for j in range(i):
            flags = int(item(t[0].pair_flags, row + j))
            if flags != 0:
                other = body_of(c, j, s)
                v = plane_of(other.pose) - plane_of(x.pose)
                far = reach_of_pair(t, x.index, other.index)
                if wp.dot(v, v) < far * far:
                    if not contacts_hold(b, flags, x, other):
                        return False
    for r in range(item(t[0].relation_start, c.problem), item(t[0].relation_start, c.problem + 1)):
        if item(t[0].relation_fault, r) != 0:
            if not relation_holds(t, r, relation_of(t, layout_of(c, s), r)):
                return False
    return True


@wp.func
def packed_value(b: Problems, o: Objective, cooling: Cooling, k: Packing, c: Candidate, s: State):
    """Objective and soft relations of the packing, and by how much it reaches out of the room [m]; poses are set."""
    blocks = k.block.shape[0]
    reach = wp.vec2(pack_along(k, c.index, blocks, 0), pack_along(k, c.index, blocks, 1))
    place_blocks(b, k, c, s, reach)
    total = float(0.0)
    for term in range(o.terms):
        total += term_value(b.tables, o, c, s, term)
    if cooling.soft > 0.0:
        total += cooling.soft * all_soft(b, c, s)
    return total, wp.max(reach[0] - k.extent[0], 0.0) + wp.max(reach[1] - k.extent[1], 0.0)


@wp.func
def exchange(k: Packing, candidate: wp.int32, i: wp.int32, j: wp.int32, orders: wp.int32):
    """Exchange the blocks at two places of the first order: there (bit 1), in the second order (bit 2), or in both."""
    x = item(k.first, candidate, i)
    y = item(k.first, candidate, j)
    if orders & 1:
        k.first[candidate, i] = y
        k.first[candidate, j] = x
    if orders & 2:
        p = item(k.place, candidate, x)
        k.place[candidate, x] = item(k.place, candidate, y)
        k.place[candidate, y] = p


@wp.func
def next_turn(turns: wp.int32, now: wp.int32, by: wp.int32):
    """Another quarter that is allowed, ``by`` further on at first."""
    for more in range(4):
        quarter = (now + by + more) % 4
        if (turns >> quarter) & 1:
            return quarter
    return now


@wp.kernel
def begin_packing(
    # Problem:
    b: Problems,
    o: Objective,
    cooling: Cooling,
    # State in:
    valid: wp.array(dtype=wp.int32),
    # State in and out:
    s: State,
    k: Packing,
    run: Annealing,
):
    """Random sequence pairs; the layouts as they stand are the best ones where they are valid."""
    candidate = wp.tid()
    c = candidate_of(b, candidate)
    rng = run.rng[candidate]
    blocks = k.block.shape[0]
    for i in range(blocks):
        k.first[candidate, i] = i
        k.place[candidate, i] = i
        k.turn[candidate, i] = next_turn(item(k.turns, i), 0, pick(rng, 4))
    for i in range(blocks):
        exchange(k, candidate, i, i + pick(rng, blocks - i), 1)
        exchange(k, candidate, i, i + pick(rng, blocks - i), 2)
    run.least[candidate] = wp.inf
    if valid[candidate] != 0:
        total = float(0.0)
        for term in range(o.terms):
            total += term_value(b.tables, o, c, s, term)
        if cooling.soft > 0.0:
            total += cooling.soft * all_soft(b, c, s)
        run.least[candidate] = total
    for obj in range(c.objects):
        run.best[candidate, obj] = s.poses[candidate, obj]
    value, over = packed_value(b, o, cooling, k, c, s)
    run.total[candidate] = value
    run.over[candidate] = over
    run.heat[candidate] = 0.0
    run.rng[candidate] = rng


@wp.kernel
def anneal_packing(
    # Problem:
    b: Problems,
    o: Objective,
    cooling: Cooling,
    first: wp.int32,
    last: wp.int32,
    # State in and out:
    s: State,
    k: Packing,
    run: Annealing,
):
    """Moves ``first`` to ``last`` of every candidate's sequence pair."""
    candidate = wp.tid()
    c = candidate_of(b, candidate)
    rng = run.rng[candidate]
    blocks = k.block.shape[0]
    total = run.total[candidate]
    over = run.over[candidate]
    for number in range(first, last):
        past = float(number) / float(cooling.moves)
        i = pick(rng, blocks)
        j = pick(rng, blocks)
        u = uniform(rng)
        block = item(k.first, candidate, i)
        before = item(k.turn, candidate, block)
        orders = int(0)
        if u < 0.3:
            k.turn[candidate, block] = next_turn(item(k.turns, block), before, 1 + pick(rng, 3))
        else:
            orders = wp.where(u < 0.5, 1, wp.where(u < 0.7, 2, 3))
            exchange(k, candidate, i, j, orders)
        value, out = packed_value(b, o, cooling, k, c, s)
        heat = run.heat[candidate]
        change = value - total
        if number < TRIALS:
            run.heat[candidate] = heat + wp.min(wp.abs(change), 1.0e6) / float(TRIALS)
        # A metre outside costs as much as some moves of the beginning gain.
        change += 8.0 * heat * (out - over)
        temperature = wp.max(heat * cooling.hot * wp.pow(cooling.cold / cooling.hot, past), 1.0e-9)
        taken = change <= 0.0
        if not taken:
            taken = uniform(rng) < wp.exp(-change / temperature)
        if taken:
            total = value
            over = out
            if out <= 0.0 and total < run.least[candidate] - 1.0e-6 * wp.abs(total):
                if layout_holds(b, c, s):
                    run.least[candidate] = total
                    for obj in range(c.objects):
                        run.best[candidate, obj] = s.poses[candidate, obj]
        elif orders > 0:
            exchange(k, candidate, i, j, orders)
        else:
            k.turn[candidate, block] = before
    run.total[candidate] = total
    run.over[candidate] = over
    run.rng[candidate] = rng
