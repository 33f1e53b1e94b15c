"""Which rooms of a plan adjoin, how each is entered from the entrance, and groups of rooms with water."""

import warp as wp

from .array_access import item
from .plan_geometry import FAR, door_width, gaps, lacking, lowest_bit, owner_of, shared_wall, takes_doors
from .plan_tables import PlanProblemRef

wp.set_module_options({"enable_backward": False})

NO_DOOR = wp.constant(-1)
BY_STAIRS = wp.constant(-2)


@wp.func
def survey_pairs(
    p: PlanProblemRef,
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
    inner = p[0].inner
    own = p[0].rooms
    drawn = p[0].cells
    for r in range(own):
        touch[r] = 0
        wets[r] = 0
        area[r] = 0
    for i in range(count):
        level = storey[i]
        if level >= 0:
            a = owner_of(p, frame, i)
            ca = cells[i]
            floor = (ca[2] - ca[0]) * (ca[3] - ca[1])
            wet = (p[0].wet_rooms >> a) & 1
            for j in range(i):
                if storey[j] == level:
                    shared = shared_wall(ca, cells[j], inner)
                    if shared > 0:
                        b = owner_of(p, frame, j)
                        if a == b:
                            if i < drawn:
                                if j >= own:
                                    shape += shared
                                elif shared >= item(p[0].room_side, a):
                                    floor += shared * inner
                        else:
                            if shared >= door_width(p, a, b) + 2 * p[0].jamb:
                                if takes_doors(p, frame, i) and takes_doors(p, frame, j):
                                    touch[a] = touch[a] | (1 << b)
                                    touch[b] = touch[b] | (1 << a)
                            if wet != 0 and ((p[0].wet_rooms >> b) & 1) != 0 and shared >= p[0].wet_wall:
                                wets[a] = wets[a] | (1 << b)
                                wets[b] = wets[b] | (1 << a)
                elif wet != 0 and storey[j] >= 0 and wp.abs(level - storey[j]) == 1:
                    b = owner_of(p, frame, j)
                    d = gaps(ca, cells[j])
                    if ((p[0].wet_rooms >> b) & 1) != 0 and d[0] <= -p[0].wet_wall and d[1] <= -p[0].wet_wall:
                        wets[a] = wets[a] | (1 << b)
                        wets[b] = wets[b] | (1 << a)
            area[a] = area[a] + floor
            if i >= own and i < drawn:
                if storey[a] == level:
                    shape += lacking(p, ca, cells[a], item(p[0].room_side, a))
                else:
                    shape += 5000
    return shape


@wp.func
def find_ways(
    p: PlanProblemRef,
    touch: wp.array(dtype=wp.int32),
    must: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
):
    """From which room each room is entered, and which rooms are reached (bits).

    Rooms that lead on are taken in the order of their rank. What asks for a door to one room of its own, as an en-suite
    bath does, is entered by that door alone; so is a room that leads nowhere and asks for a door to one that does.
    """
    free = int(0)  # rooms that ask for no door of their own
    for r in range(p[0].rooms):
        parent[r] = NO_DOOR
        if must[r] == 0:
            free = free | (1 << r)
    enters = free | ~p[0].annexes
    for r in range(p[0].rooms):
        if ((p[0].through >> r) & 1) == 0 and (must[r] & p[0].through) != 0:
            enters = enters & ~(1 << r)
    reached = int(1 << p[0].entrance)
    done = int(0)
    left = int((p[0].through | p[0].suites) & reached)
    while left != 0:
        at = int(-1)
        rank = int(FAR)
        while left != 0:
            r = lowest_bit(left)
            left = left & ~(1 << r)
            if item(p[0].room_rank, r) < rank:
                rank = item(p[0].room_rank, r)
                at = r
        done = done | (1 << at)
        way = int(must[at])
        if ((p[0].through >> at) & 1) != 0:
            way = way | (touch[at] & enters)
            if ((p[0].stairs >> at) & 1) != 0:
                flights = int(p[0].stairs & ~reached)
                way = way & ~flights
                reached = reached | flights
                while flights != 0:
                    r = lowest_bit(flights)
                    flights = flights & ~(1 << r)
                    parent[r] = BY_STAIRS
        else:
            way = way & p[0].annexes
        way = way & ~reached
        reached = reached | way
        while way != 0:
            r = lowest_bit(way)
            way = way & ~(1 << r)
            parent[r] = at
        left = (p[0].through | p[0].suites) & reached & ~done
    return reached


@wp.func
def wet_count(p: PlanProblemRef, wets: wp.array(dtype=wp.int32)):
    """Groups of rooms with water that share walls or stand over each other, and a room of each (bits)."""
    left = int(p[0].wet_rooms)
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
