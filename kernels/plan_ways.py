"""Which rooms of a plan adjoin, how each is entered from the entrance, and groups of rooms with water."""

import warp as wp

from .plan_geometry import FAR, door_width, gaps, has, lacking, lowest_bit, owner_of, shared_wall, takes_doors
from .plan_tables import ANNEX, STAIRS, SUITE, THROUGH, WET, PlanProblem

wp.set_module_options({"enable_backward": False})

NO_DOOR = wp.constant(-1)
BY_STAIRS = wp.constant(-2)


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
