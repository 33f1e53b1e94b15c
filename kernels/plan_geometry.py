"""Cells of plans and what lies between them: gaps, shared walls, outer walls, distances of rooms, in millimetres."""

import warp as wp

from .plan_tables import MAX_CELLS, WINDOWS, PlanProblem

wp.set_module_options({"enable_backward": False})

MILLI = wp.constant(0.001)
FAR = wp.constant(1000000)  # [mm]


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


@wp.func
def facade_way(p: PlanProblem, hull: wp.vec4i):
    """How far [mm] a rectangle is from the nearest outer wall that may have windows."""
    least = int(FAR)
    for f in range(p.facade.shape[0]):
        if (p.facade_flags[f] & WINDOWS) != 0:
            least = wp.min(least, wp.abs(hull[p.facade[f][0]] - p.facade[f][1]))
    return least
