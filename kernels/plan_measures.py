"""What rules ask of a plan's rectangles, in whole millimetres; a rule that holds has a violation of exactly 0.

Violations are in metres, square metres or counts, and slope towards plans that hold: a wall that is too short for a
door costs what is missing, rooms that should meet cost the way between them.
"""

import warp as wp

from .plan_tables import (
    ADJACENCY,
    ANNEX,
    APART,
    AREA,
    ASPECT,
    CIRCULATION,
    ENTRANCE,
    ENTRY,
    GLAZED,
    GLAZING,
    GROUPS,
    LARGE,
    LARGEST,
    LIT,
    MAX_CELLS,
    NEAR,
    NORTH,
    QUIET,
    REACHED,
    RULE_COUNT,
    SHAPE,
    SHARE,
    SIDE,
    STAIRS,
    SUITE,
    SUNNY,
    THROUGH,
    WET,
    WINDOWS,
    PlanProblem,
)

wp.set_module_options({"enable_backward": False})

MILLI = wp.constant(0.001)
FAR = wp.constant(1000000)  # [mm]
NO_DOOR = wp.constant(-1)
BY_STAIRS = wp.constant(-2)


@wp.func
def has(p: PlanProblem, room: wp.int32, bits: wp.int32):
    """Whether a room has one of some flags."""
    return (p.room_flags[room] & bits) != 0


@wp.func
def owner_of(p: PlanProblem, frame: wp.int32, cell: wp.int32):
    """The room of a cell."""
    if cell < p.cells:
        return p.cell_room[cell]
    return p.fixed_room[p.fixed_start[frame] + cell - p.cells][0]


@wp.func
def takes_doors(p: PlanProblem, frame: wp.int32, cell: wp.int32):
    """Whether doors may be in a cell's walls: not beside the flights of stairs."""
    if cell < p.cells:
        return True
    return p.fixed_room[p.fixed_start[frame] + cell - p.cells][2] != 0


@wp.func
def gaps(a: wp.vec4i, b: wp.vec4i):
    """How far apart two rectangles are along x and y [mm]; negative: how far they reach past each other."""
    return wp.vec2i(wp.max(a[0], b[0]) - wp.min(a[2], b[2]), wp.max(a[1], b[1]) - wp.min(a[3], b[3]))


@wp.func
def shared_wall(p: PlanProblem, a: wp.vec4i, b: wp.vec4i):
    """How long [mm] the inner wall is that two rectangles share, 0: none."""
    d = gaps(a, b)
    if d[0] == p.inner and d[1] < 0:
        return -d[1]
    if d[1] == p.inner and d[0] < 0:
        return -d[0]
    return 0


@wp.func
def lacking(p: PlanProblem, a: wp.vec4i, b: wp.vec4i, need: wp.int32):
    """How far [mm] two rectangles would have to move to share a wall of some length; 0: they do."""
    d = gaps(a, b)
    over_x = wp.abs(d[0] - p.inner) + wp.max(need + d[1], 0)
    over_y = wp.abs(d[1] - p.inner) + wp.max(need + d[0], 0)
    return wp.min(over_x, over_y)


@wp.func
def facade_overlap(facade: wp.vec4i, cell: wp.vec4i):
    """Where a cell lies along an outer wall: from and to [mm], empty where it does not reach it."""
    side = facade[0]
    if cell[side] != facade[1]:
        return wp.vec2i(0, 0)
    along = 1 - side % 2
    return wp.vec2i(wp.max(cell[along], facade[2]), wp.min(cell[along + 2], facade[3]))


@wp.func
def door_width(p: PlanProblem, a: wp.int32, b: wp.int32):
    """Width [mm] of a door between two rooms: that of the lesser one."""
    return wp.min(p.room_door[a], p.room_door[b])


@wp.func
def rooms_lack(
    p: PlanProblem,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    a: wp.int32,
    b: wp.int32,
    need: wp.int32,
    doors: wp.bool,
):
    """How far [mm] two rooms would have to move to share a wall of some length; ``doors``: where doors may be."""
    least = int(FAR)
    for i in range(count):
        if storey[i] >= 0 and owner_of(p, frame, i) == a and (not doors or takes_doors(p, frame, i)):
            for j in range(count):
                if storey[j] == storey[i] and owner_of(p, frame, j) == b and (not doors or takes_doors(p, frame, j)):
                    least = wp.min(least, lacking(p, cells[i], cells[j], need))
    return least


@wp.func
def rooms_gap(
    p: PlanProblem,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    a: wp.int32,
    others: wp.int32,
):
    """How far [m] a room is from the nearest of a set of rooms on its storey, from wall to wall; 3 m a storey."""
    least = float(1000.0)
    for i in range(count):
        if storey[i] >= 0 and owner_of(p, frame, i) == a:
            for j in range(count):
                if storey[j] >= 0:
                    if (others >> owner_of(p, frame, j)) & 1:
                        d = gaps(cells[i], cells[j])
                        x = float(wp.max(d[0], 0))
                        y = float(wp.max(d[1], 0))
                        floors = float(wp.abs(storey[i] - storey[j]))
                        least = wp.min(least, MILLI * wp.sqrt(x * x + y * y) + 3.0 * floors)
    return least


@wp.func
def lowest_bit(mask: wp.int32):
    """The number of a mask's lowest bit."""
    k = int(0)
    while k < MAX_CELLS and ((mask >> k) & 1) == 0:
        k += 1
    return k


@wp.func(inline=False)
def survey_pairs(
    p: PlanProblem,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    touch: wp.array(dtype=wp.int32),
    wets: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
):
    """For each room: those that a door may lead to, those with water beside or over it, its floor [mm2].

    Gives what is wrong with the shape of rooms of several cells [m]: a cell beside the room's own is joined to it over
    the width of a way, and to no other.
    """
    shape = int(0)
    for r in range(p.rooms):
        touch[r] = 0
        wets[r] = 0
        area[r] = 0
    for i in range(count):
        if storey[i] >= 0:
            a = owner_of(p, frame, i)
            ca = cells[i]
            area[a] = area[a] + (ca[2] - ca[0]) * (ca[3] - ca[1])
            doors = takes_doors(p, frame, i)
            wet = has(p, a, WET)
            for j in range(i):
                if storey[j] >= 0:
                    b = owner_of(p, frame, j)
                    if storey[i] == storey[j]:
                        shared = shared_wall(p, ca, cells[j])
                        if shared > 0:
                            if a == b:
                                if j < p.rooms and i < p.cells:
                                    if shared >= p.room_side[a]:
                                        area[a] = area[a] + shared * p.inner
                                elif i < p.cells:
                                    shape += shared
                            else:
                                if doors and takes_doors(p, frame, j):
                                    if shared >= door_width(p, a, b) + 2 * p.jamb:
                                        touch[a] = touch[a] | (1 << b)
                                        touch[b] = touch[b] | (1 << a)
                                if wet and has(p, b, WET) and shared >= p.wet_wall:
                                    wets[a] = wets[a] | (1 << b)
                                    wets[b] = wets[b] | (1 << a)
                    elif wet and wp.abs(storey[i] - storey[j]) == 1 and has(p, b, WET):
                        d = gaps(ca, cells[j])
                        if d[0] <= -p.wet_wall and d[1] <= -p.wet_wall:
                            wets[a] = wets[a] | (1 << b)
                            wets[b] = wets[b] | (1 << a)
            if i >= p.rooms and i < p.cells:
                if storey[a] == storey[i]:
                    shape += lacking(p, ca, cells[a], p.room_side[a])
                else:
                    shape += 5000
    return shape


@wp.func(inline=False)
def find_ways(
    p: PlanProblem,
    touch: wp.array(dtype=wp.int32),
    must: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
):
    """From which room each room is entered, and which rooms are reached (bits).

    Rooms that lead on are taken in the order of their rank. What asks for a door to one room of its own, as an en-suite
    bath does, is entered by that door alone.
    """
    for r in range(p.rooms):
        parent[r] = NO_DOOR
    reached = int(1 << p.entrance)
    done = int(0)
    while True:
        at = int(-1)
        rank = int(FAR)
        for r in range(p.rooms):
            if ((reached >> r) & 1) != 0 and ((done >> r) & 1) == 0 and has(p, r, THROUGH | SUITE):
                if p.room_rank[r] < rank:
                    rank = p.room_rank[r]
                    at = r
        if at < 0:
            break
        done = done | (1 << at)
        through = has(p, at, THROUGH)
        for r in range(p.rooms):
            if ((reached >> r) & 1) == 0:
                asked = ((must[at] >> r) & 1) != 0
                way = asked
                if through:
                    if ((touch[at] >> r) & 1) != 0 and (must[r] == 0 or not has(p, r, ANNEX)):
                        way = True
                    if has(p, at, STAIRS) and has(p, r, STAIRS):
                        parent[r] = BY_STAIRS
                        reached = reached | (1 << r)
                        way = False
                elif not has(p, r, ANNEX):
                    way = False
                if way:
                    parent[r] = at
                    reached = reached | (1 << r)
    return reached


@wp.func
def wet_count(p: PlanProblem, wets: wp.array(dtype=wp.int32)):
    """Groups of rooms with water that share walls or stand over each other, and a room of each (bits)."""
    left = int(0)
    for r in range(p.rooms):
        if has(p, r, WET):
            left = left | (1 << r)
    groups = int(0)
    first = int(0)
    while left != 0:
        k = lowest_bit(left)
        groups += 1
        first = first | (1 << k)
        front = int(1 << k)
        left = left & ~front
        while front != 0:
            r = lowest_bit(front)
            front = front & ~(1 << r)
            more = wets[r] & left
            left = left & ~more
            front = front | more
    return groups, first


@wp.func
def facade_way(p: PlanProblem, hull: wp.vec4i):
    """How far [mm] a rectangle is from the nearest outer wall that may have windows."""
    least = int(FAR)
    for f in range(p.facade.shape[0]):
        if (p.facade_flags[f] & WINDOWS) != 0:
            least = wp.min(least, wp.abs(hull[p.facade[f][0]] - p.facade[f][1]))
    return least


@wp.func(inline=False)
def measure_rooms(
    p: PlanProblem,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
    violation: wp.array(dtype=wp.float32),
):
    """Violations of what each room has to be by itself: floor, sides, shape, light.

    Gives what is soft of that, and the rooms that violate something (bits).
    """
    soft = float(0.0)
    blame = int(0)
    total = float(0.0)
    halls = float(0.0)
    largest = int(0)
    for r in range(p.rooms):
        bounds = p.room_area[r]
        floor = area[r]
        violation[AREA] = violation[AREA] + 1.0e-6 * float(wp.max(bounds[0] - floor, 0) + wp.max(floor - bounds[2], 0))
        total += float(floor)
        if has(p, r, CIRCULATION):
            halls += float(floor)
        if has(p, r, LARGE):
            largest = wp.max(largest, floor)
        if floor < bounds[0] or floor > bounds[2]:
            blame = blame | (1 << r)
        off = float(floor) / float(wp.max(bounds[1], 1)) - 1.0
        soft += p.weights[0] * off * off
        hull = wp.vec4i(FAR, FAR, -FAR, -FAR)
        lit = int(0)
        sun = int(0)
        for i in range(count):
            if storey[i] >= 0 and owner_of(p, frame, i) == r:
                c = cells[i]
                hull = wp.vec4i(
                    wp.min(hull[0], c[0]), wp.min(hull[1], c[1]), wp.max(hull[2], c[2]), wp.max(hull[3], c[3])
                )
                if i < p.cells:
                    short = wp.min(c[2] - c[0], c[3] - c[1])
                    if short < p.cell_side[i]:
                        blame = blame | (1 << r)
                        violation[SIDE] = violation[SIDE] + MILLI * float(p.cell_side[i] - short)
                if has(p, r, GLAZED | LIT | SUNNY):
                    for f in range(p.facade.shape[0]):
                        if (p.facade_flags[f] & WINDOWS) != 0:
                            s = facade_overlap(p.facade[f], c)
                            free = wp.max(s[1] - s[0] - 2 * p.pier, 0)
                            if free >= p.least_window:
                                lit += free
                                if p.facade[f][0] != NORTH:
                                    sun += free
        long = wp.max(hull[2] - hull[0], hull[3] - hull[1])
        short = wp.min(hull[2] - hull[0], hull[3] - hull[1])
        ratio = p.room_aspect[r]
        over = float(long) - MILLI * float(ratio[0]) * float(short)
        if wp.int64(long) * wp.int64(1000) > wp.int64(short) * wp.int64(ratio[0]):
            blame = blame | (1 << r)
            violation[ASPECT] = violation[ASPECT] + MILLI * wp.max(over, 1.0)
        soft += p.weights[1] * wp.max(float(long) / float(wp.max(short, 1)) - MILLI * float(ratio[1]), 0.0)
        need = int(0)
        if has(p, r, LIT):
            need = p.least_window
        if has(p, r, GLAZED):
            need = wp.max(need, window_need(p, floor))
        if lit < need:
            # a room inside is drawn to the outer walls
            blame = blame | (1 << r)
            way = wp.min(facade_way(p, hull), 10000)
            violation[GLAZING] = violation[GLAZING] + MILLI * (float(need - lit) + 0.3 * float(way))
        if has(p, r, SUNNY):
            soft += p.weights[5] * MILLI * float(wp.max(2 * need - sun, 0))
    share = halls / wp.max(total, 1.0)
    if halls * 1000.0 > total * float(p.corridors[0]):
        violation[SHARE] = wp.max(20.0 * (share - MILLI * float(p.corridors[0])), 0.001)
    soft += p.weights[2] * wp.max(share - MILLI * float(p.corridors[1]), 0.0)
    violation[LARGEST] = 1.0e-6 * float(wp.max(p.large_room - largest, 0))
    return soft, blame


@wp.func
def window_need(p: PlanProblem, floor: wp.int32):
    """Width [mm] of the windows that a floor [mm2] needs, rounded up."""
    glass = wp.int64(floor) * wp.int64(p.glazing)
    unit = wp.int64(1000) * wp.int64(p.pane)
    return int((glass + unit - wp.int64(1)) / unit)


@wp.func(inline=False)
def measure_plan(
    p: PlanProblem,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    touch: wp.array(dtype=wp.int32),
    wets: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
    must: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
    violation: wp.array(dtype=wp.float32),
):
    """Violations of all rules that do not depend on where doors and windows are.

    Gives the soft rows' energy, and the rooms that violate something (bits).
    """
    for k in range(RULE_COUNT):
        violation[k] = 0.0
    shape = survey_pairs(p, frame, count, cells, storey, touch, wets, area)
    violation[SHAPE] = MILLI * float(shape)
    soft, blame = measure_rooms(p, frame, count, cells, storey, area, violation)

    for r in range(p.rooms):
        must[r] = 0
    for k in range(p.adjacency.shape[0]):
        x = p.adjacency[k]
        a = x[0]
        b = x[1]
        weight = p.adjacency_weight[k]
        lack = float(0.0)
        if x[2] == APART:
            if rooms_lack(p, frame, count, cells, storey, a, b, 1, False) == 0:
                lack = 1.0
        elif x[2] == NEAR:
            lack = MILLI * float(wp.min(rooms_lack(p, frame, count, cells, storey, a, b, p.wet_wall, False), 20000))
        else:
            need = x[3] + 2 * p.jamb
            lack = MILLI * float(wp.min(rooms_lack(p, frame, count, cells, storey, a, b, need, True), 20000))
            if lack == 0.0:
                must[a] = must[a] | (1 << b)
                must[b] = must[b] | (1 << a)
            elif weight < 0.0:
                lack += 0.3
        if weight < 0.0:
            violation[ADJACENCY] = violation[ADJACENCY] + lack
            if lack > 0.0:
                blame = blame | (1 << a) | (1 << b)
        else:
            soft += weight * wp.min(lack, 10.0)

    reached = find_ways(p, touch, must, parent)
    for r in range(p.rooms):
        if ((reached >> r) & 1) == 0:
            least = int(10000)
            for o in range(p.rooms):
                if ((reached >> o) & 1) != 0 and has(p, o, THROUGH):
                    need = door_width(p, r, o) + 2 * p.jamb
                    least = wp.min(least, rooms_lack(p, frame, count, cells, storey, r, o, need, True))
            blame = blame | (1 << r)
            violation[REACHED] = violation[REACHED] + 0.3 + MILLI * float(least)
        elif has(p, r, QUIET):
            o = parent[r]
            if o >= 0:
                if not has(p, o, CIRCULATION):
                    soft += p.weights[6]

    least = int(10000)
    need = p.entrance_door + 2 * p.jamb
    for i in range(count):
        if storey[i] == 0 and owner_of(p, frame, i) == p.entrance and takes_doors(p, frame, i):
            for f in range(p.facade.shape[0]):
                if (p.facade_flags[f] & ENTRANCE) != 0:
                    facade = p.facade[f]
                    c = cells[i]
                    along = 1 - facade[0] % 2
                    overlap = wp.min(c[along + 2], facade[3]) - wp.max(c[along], facade[2])
                    least = wp.min(least, wp.abs(c[facade[0]] - facade[1]) + wp.max(need - overlap, 0))
    violation[ENTRY] = MILLI * float(least)
    if least > 0:
        blame = blame | (1 << p.entrance)

    groups, first = wet_count(p, wets)
    if groups > 1:
        # the way between groups counts, so that moves towards each other are worth something
        far = float(0.0)
        rest = int(first & ~(1 << lowest_bit(first)))
        while rest != 0:
            k = lowest_bit(rest)
            rest = rest & ~(1 << k)
            others = int(0)
            for r in range(p.rooms):
                if has(p, r, WET) and r != k and ((wets[k] >> r) & 1) == 0:
                    others = others | (1 << r)
            far = wp.max(far, wp.min(rooms_gap(p, frame, count, cells, storey, k, others), 10.0))
        if groups > p.wet_groups:
            violation[GROUPS] = float(groups - p.wet_groups) + 0.1 * far
        soft += p.weights[3] * (float(groups - 1) + 0.1 * far)

    for k in range(p.wish_room.shape[0]):
        reach = p.wish_reach[k]
        gap = rooms_gap(p, frame, count, cells, storey, p.wish_room[k], p.wish_mask[k])
        soft += reach[1] * wp.clamp(gap - MILLI * reach[0], 0.0, 10.0)
    return soft, blame


@wp.func
def hard_of(violation: wp.array(dtype=wp.float32)):
    """The sum of all violations."""
    total = float(0.0)
    for k in range(RULE_COUNT):
        total += violation[k]
    return total


