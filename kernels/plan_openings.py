"""All openings of a plan together: what fails, and what halls lose."""

import warp as wp

from .array_access import item
from .plan_doors import is_free, place_doors
from .plan_geometry import FAR, has, next_cell, takes_doors
from .plan_measures import NOT_VALID
from .plan_tables import ANNEX, CIRCULATION, LIVING, QUIET, SOFT_ENDS, SOFT_FIRST, TURNING, PlanProblemRef
from .plan_windows import place_windows

wp.set_module_options({"enable_backward": False})

LOST = wp.constant(300)  # [mm] of a hall beyond its last door, and its width, that nobody minds


@wp.func
def turning_holds(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    room: wp.int32,
    leaves: wp.array(dtype=wp.vec4i),
    leaf_level: wp.array(dtype=wp.int32),
    doors: wp.int32,
):
    """Whether a square to turn in fits into one of a room's cells, beside all leaves: at a wall, or at a leaf."""
    t = p[0].turning
    i = next_cell(p, frame, count, storey, room, -1)
    while i < count:
        if takes_doors(p, frame, i):
            c = cells[i]
            for kx in range(2 + 2 * doors):
                x = c[0]
                if kx == 1:
                    x = c[2] - t
                elif kx >= 2:
                    x = wp.where(kx % 2 == 0, leaves[(kx - 2) / 2][2], leaves[(kx - 2) / 2][0] - t)
                if x >= c[0] and x + t <= c[2]:
                    for ky in range(2 + 2 * doors):
                        y = c[1]
                        if ky == 1:
                            y = c[3] - t
                        elif ky >= 2:
                            y = wp.where(ky % 2 == 0, leaves[(ky - 2) / 2][3], leaves[(ky - 2) / 2][1] - t)
                        if y >= c[1] and y + t <= c[3]:
                            if is_free(wp.vec4i(x, y, x + t, y + t), storey[i], leaves, leaf_level, doors):
                                return True
        i = next_cell(p, frame, count, storey, room, i)
    return False


@wp.func
def rooms_without_turning(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    leaves: wp.array(dtype=wp.vec4i),
    leaf_level: wp.array(dtype=wp.int32),
    doors: wp.int32,
):
    """Rooms that nobody can turn in."""
    bad = int(0)
    if p[0].turning > 0:
        for r in range(p[0].rooms):
            if has(p, r, TURNING):
                if not turning_holds(p, frame, count, cells, storey, r, leaves, leaf_level, doors):
                    bad += 1
    return bad


@wp.func
def dead_ends(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    doors: wp.array2d(dtype=wp.int32),
    n: wp.int32,
):
    """How far [m] halls reach beyond the last of their doors, less their width."""
    total = float(0.0)
    for r in range(p[0].rooms):
        if has(p, r, CIRCULATION):
            hull = wp.vec4i(FAR, FAR, -FAR, -FAR)
            i = next_cell(p, frame, count, storey, r, -1)
            while i < count:
                c = cells[i]
                hull = wp.vec4i(
                    wp.min(hull[0], c[0]), wp.min(hull[1], c[1]), wp.max(hull[2], c[2]), wp.max(hull[3], c[3])
                )
                i = next_cell(p, frame, count, storey, r, i)
            reach = int(0)
            for axis in range(2):
                first = int(hull[axis + 2])
                last = int(hull[axis])
                for k in range(n):
                    if doors[k, 0] == r or doors[k, 1] == r:
                        low = doors[k, 3 + axis]
                        first = wp.min(first, low)
                        if doors[k, 2] % 2 != axis:
                            low += doors[k, 5]
                        last = wp.max(last, low)
                reach = wp.max(reach, wp.max(first - hull[axis], hull[axis + 2] - last))
            total += 0.001 * float(wp.max(reach - item(p[0].room_side, r) - LOST, 0))
    return total


@wp.func
def first_way(p: PlanProblemRef, doors: wp.array2d(dtype=wp.int32), n: wp.int32, flag: wp.int32):
    """How far [mm] along the axes the first door is from the entrance's by which one comes into rooms with a flag.

    Doors to annexes, and between two such rooms, lead on from there. `FAR`: there is none on the entrance's storey.
    """
    if has(p, p[0].entrance, flag):
        return 0
    least = int(FAR)
    for k in range(1, n):
        a = doors[k, 0]
        b = doors[k, 1]
        comes = (has(p, a, flag) and not has(p, b, flag | ANNEX)) or (has(p, b, flag) and not has(p, a, flag | ANNEX))
        if comes and (item(p[0].room_storeys, a) & 1) != 0 and (item(p[0].room_storeys, b) & 1) != 0:
            way = int(0)
            for axis in range(2):
                at = 2 * (doors[k, 3 + axis] - doors[0, 3 + axis])
                if doors[k, 2] % 2 != axis:
                    at += doors[k, 5]
                if doors[0, 2] % 2 != axis:
                    at -= doors[0, 5]
                way += wp.abs(at) / 2
            least = wp.min(least, way)
    return least


@wp.func
def soft_of_doors(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    doors: wp.array2d(dtype=wp.int32),
    n: wp.int32,
):
    """Energy of soft rows about where doors are: halls beyond their last door, bedrooms before the living room."""
    soft = p[0].weights[SOFT_ENDS] * dead_ends(p, frame, count, cells, storey, doors, n)
    if p[0].weights[SOFT_FIRST] > 0.0 and n > 0 and doors[0, 1] < 0:
        living = first_way(p, doors, n, LIVING)
        if living < FAR:
            soft += p[0].weights[SOFT_FIRST] * 0.001 * float(wp.max(living - first_way(p, doors, n, QUIET), 0))
    return soft


@wp.func
def openings_fail(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
    must: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
    leaves: wp.array(dtype=wp.vec4i),
    leaf_level: wp.array(dtype=wp.int32),
    fronts: wp.array(dtype=wp.vec4i),
    front_level: wp.array(dtype=wp.int32),
    record: wp.array(dtype=wp.int32),
    doors: wp.array2d(dtype=wp.int32),
    windows: wp.array2d(dtype=wp.int32),
):
    """Place doors and windows.

    Gives by how much they fail (doors, metres of windows, rooms to turn in), and the energy of soft rows about doors.
    """
    n, failed = place_doors(
        p, frame, count, cells, storey, must, parent, leaves, leaf_level, fronts, front_level, record, doors
    )
    _windows, lack = place_windows(p, frame, count, cells, storey, area, doors, n, windows)
    narrow = rooms_without_turning(p, frame, count, cells, storey, leaves, leaf_level, n)
    soft = soft_of_doors(p, frame, count, cells, storey, doors, n)
    hard = float(failed) + 0.001 * float(lack) + float(narrow)
    if hard > 0.0:
        hard += NOT_VALID
    return hard, soft
