"""What rules ask of a plan's rectangles, in whole millimetres; a rule that holds has a violation of exactly 0.

Violations are in metres, square metres or counts, and slope towards plans that hold: a wall that is too short for a
door costs what is missing, rooms that should meet cost the way between them.
"""

import warp as wp

from .array_access import item
from .plan_geometry import (
    FAR,
    MILLI,
    door_width,
    facade_overlap,
    facade_way,
    has,
    lowest_bit,
    next_cell,
    rooms_gap,
    rooms_lack,
    takes_doors,
)
from .plan_tables import (
    ADJACENCY,
    APART,
    AREA,
    ASPECT,
    CIRCULATION,
    DAY,
    ENTRANCE,
    ENTRY,
    GLAZED,
    GLAZING,
    GROUPS,
    LARGE,
    LARGEST,
    LIT,
    LIVING,
    MASTER,
    NEAR,
    NORTH,
    QUIET,
    REACHED,
    RULE_COUNT,
    SHAPE,
    SHARE,
    SIDE,
    SOFT_AREA,
    SOFT_BEDROOM_DOORS,
    SOFT_BEDROOMS,
    SOFT_CORRIDORS,
    SOFT_HALLS,
    SOFT_MASTER,
    SOFT_SIDES,
    SOFT_SUN,
    SOFT_TOILET_DOORS,
    SOFT_WET,
    SUNNY,
    THROUGH,
    TOILET,
    TWO_SIDED,
    WINDOWS,
    PlanProblemRef,
)
from .plan_ways import find_ways, survey_pairs, wet_count

wp.set_module_options({"enable_backward": False})


NOT_VALID = wp.constant(0.3)  # of hard violations, beside what they are


@wp.func
def measure_rooms(
    p: PlanProblemRef,
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
    bedroom = int(FAR * 1000)  # floors of the smallest ones [mm2]
    living = int(FAR * 1000)
    master = int(FAR * 1000)
    for r in range(p[0].rooms):
        bounds = item(p[0].room_area, r)
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
        soft += p[0].weights[SOFT_AREA] * off * off
        hull = wp.vec4i(FAR, FAR, -FAR, -FAR)
        lit = int(0)
        sun = int(0)
        sides = int(0)
        i = next_cell(p, frame, count, storey, r, -1)
        while i < count:
            c = cells[i]
            hull = wp.vec4i(wp.min(hull[0], c[0]), wp.min(hull[1], c[1]), wp.max(hull[2], c[2]), wp.max(hull[3], c[3]))
            if i < p[0].cells:
                short = wp.min(c[2] - c[0], c[3] - c[1])
                if short < item(p[0].cell_side, i):
                    blame = blame | (1 << r)
                    violation[SIDE] = violation[SIDE] + MILLI * float(item(p[0].cell_side, i) - short)
            if has(p, r, GLAZED | LIT | SUNNY | TWO_SIDED):
                for f in range(p[0].facade.shape[0]):
                    if (item(p[0].facade_flags, f) & WINDOWS) != 0:
                        s = facade_overlap(item(p[0].facade, f), c)
                        free = wp.max(s[1] - s[0] - 2 * p[0].pier, 0)
                        if free >= p[0].least_window:
                            lit += free
                            sides = sides | (1 << item(p[0].facade, f)[0])
                            if item(p[0].facade, f)[0] != NORTH:
                                sun += free
            i = next_cell(p, frame, count, storey, r, i)
        long = wp.max(hull[2] - hull[0], hull[3] - hull[1])
        short = wp.min(hull[2] - hull[0], hull[3] - hull[1])
        ratio = item(p[0].room_aspect, r)
        over = float(long) - MILLI * float(ratio) * float(short)
        if wp.int64(long) * wp.int64(1000) > wp.int64(short) * wp.int64(ratio):
            blame = blame | (1 << r)
            violation[ASPECT] = violation[ASPECT] + MILLI * wp.max(over, 1.0)
        form = item(p[0].room_form, r)
        soft += form[1] * wp.max(float(long) / float(wp.max(short, 1)) - form[0], 0.0)
        soft += form[3] * wp.max(form[2] - float(floor) / wp.max(float(long) * float(short), 1.0), 0.0)
        need = int(0)
        if has(p, r, LIT):
            need = p[0].least_window
        if has(p, r, GLAZED):
            need = wp.max(need, window_need(p, floor))
        if lit < need:
            # a room inside is drawn to the outer walls
            blame = blame | (1 << r)
            way = wp.min(facade_way(p, hull), 10000)
            violation[GLAZING] = violation[GLAZING] + MILLI * (float(need - lit) + 0.3 * float(way))
        if has(p, r, SUNNY):
            soft += p[0].weights[SOFT_SUN] * MILLI * float(wp.max(2 * need - sun, 0))
        if has(p, r, TWO_SIDED) and (sides & (sides - 1)) == 0:
            soft += p[0].weights[SOFT_SIDES]
        if has(p, r, QUIET):
            bedroom = wp.min(bedroom, floor)
        if has(p, r, LIVING):
            living = wp.min(living, floor)
        if has(p, r, MASTER):
            master = wp.min(master, floor)
    for r in range(p[0].rooms):
        if has(p, r, CIRCULATION):
            soft += p[0].weights[SOFT_HALLS] * 1.0e-6 * float(wp.max(area[r] - bedroom, 0))
        if has(p, r, QUIET):
            soft += p[0].weights[SOFT_BEDROOMS] * 1.0e-6 * float(wp.max(area[r] - living, 0))
            if not has(p, r, MASTER):
                soft += p[0].weights[SOFT_MASTER] * 1.0e-6 * float(wp.max(area[r] - master, 0))
    share = halls / wp.max(total, 1.0)
    if halls * 1000.0 > total * float(p[0].corridors[0]):
        violation[SHARE] = wp.max(20.0 * (share - MILLI * float(p[0].corridors[0])), 0.001)
    soft += p[0].weights[SOFT_CORRIDORS] * wp.max(share - MILLI * float(p[0].corridors[1]), 0.0)
    violation[LARGEST] = 1.0e-6 * float(wp.max(p[0].large_room - largest, 0))
    return soft, blame


@wp.func
def window_need(p: PlanProblemRef, floor: wp.int32):
    """Width [mm] of the windows that a floor [mm2] needs, rounded up."""
    glass = wp.int64(floor) * wp.int64(p[0].glazing)
    unit = wp.int64(1000) * wp.int64(p[0].pane)
    return int((glass + unit - wp.int64(1)) / unit)


@wp.func
def measure_plan(
    p: PlanProblemRef,
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

    for r in range(p[0].rooms):
        must[r] = 0
    for k in range(p[0].adjacency.shape[0]):
        x = item(p[0].adjacency, k)
        a = x[0]
        b = x[1]
        weight = item(p[0].adjacency_weight, k)
        lack = float(0.0)
        if x[2] == APART:
            if rooms_lack(p, frame, count, cells, storey, a, b, 1, False) == 0:
                lack = 1.0
        elif x[2] == NEAR:
            lack = MILLI * float(wp.min(rooms_lack(p, frame, count, cells, storey, a, b, p[0].wet_wall, False), 20000))
        else:
            need = x[3] + 2 * p[0].jamb
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
    for r in range(p[0].rooms):
        if ((reached >> r) & 1) == 0:
            least = int(10000)
            for o in range(p[0].rooms):
                if ((reached >> o) & 1) != 0 and has(p, o, THROUGH):
                    need = door_width(p, r, o) + 2 * p[0].jamb
                    least = wp.min(least, rooms_lack(p, frame, count, cells, storey, r, o, need, True))
            blame = blame | (1 << r)
            violation[REACHED] = violation[REACHED] + 0.3 + MILLI * float(least)
        elif has(p, r, QUIET | TOILET):
            o = parent[r]
            if o >= 0:
                if has(p, r, QUIET) and not has(p, o, CIRCULATION):
                    soft += p[0].weights[SOFT_BEDROOM_DOORS]
                if has(p, r, TOILET) and has(p, o, DAY):
                    soft += p[0].weights[SOFT_TOILET_DOORS]

    least = int(10000)
    need = p[0].entrance_door + 2 * p[0].jamb
    i = next_cell(p, frame, count, storey, p[0].entrance, -1)
    while i < count:
        if storey[i] == 0 and takes_doors(p, frame, i):
            for f in range(p[0].facade.shape[0]):
                if (item(p[0].facade_flags, f) & ENTRANCE) != 0:
                    facade = item(p[0].facade, f)
                    c = cells[i]
                    along = 1 - facade[0] % 2
                    overlap = wp.min(c[along + 2], facade[3]) - wp.max(c[along], facade[2])
                    least = wp.min(least, wp.abs(c[facade[0]] - facade[1]) + wp.max(need - overlap, 0))
        i = next_cell(p, frame, count, storey, p[0].entrance, i)
    violation[ENTRY] = MILLI * float(least)
    if least > 0:
        blame = blame | (1 << p[0].entrance)

    groups, first = wet_count(p, wets)
    if groups > 1:
        # the way between groups counts, so that moves towards each other are worth something
        far = float(0.0)
        rest = int(first & ~(1 << lowest_bit(first)))
        while rest != 0:
            k = lowest_bit(rest)
            rest = rest & ~(1 << k)
            others = p[0].wet_rooms & ~(wets[k] | (1 << k))
            far = wp.max(far, wp.min(rooms_gap(p, frame, count, cells, storey, k, others), 10.0))
        if groups > p[0].wet_groups:
            violation[GROUPS] = float(groups - p[0].wet_groups) + 0.1 * far
        soft += p[0].weights[SOFT_WET] * (float(groups - 1) + 0.1 * far)

    for k in range(p[0].wish_room.shape[0]):
        reach = item(p[0].wish_reach, k)
        gap = rooms_gap(p, frame, count, cells, storey, item(p[0].wish_room, k), item(p[0].wish_mask, k))
        soft += reach[1] * wp.clamp(gap - MILLI * reach[0], 0.0, 10.0)
    return soft, blame


@wp.func
def hard_of(violation: wp.array(dtype=wp.float32)):
    """The sum of all violations, and `NOT_VALID` where there is one: no soft row is worth a small one."""
    total = float(0.0)
    for k in range(RULE_COUNT):
        total += violation[k]
    if total > 0.0:
        total += NOT_VALID
    return total
