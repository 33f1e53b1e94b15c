"""Cells of plans and what lies between them: gaps, shared walls, outer walls, distances of rooms, in millimetres."""

import warp as wp

from .array_access import item
from .plan_tables import WINDOWS, PlanProblemRef

wp.set_module_options({"enable_backward": False})

MILLI = wp.constant(0.001)
FAR = wp.constant(1000000)  # [mm]


@wp.func
def has(p: PlanProblemRef, room: wp.int32, bits: wp.int32):
    """Whether a room has one of some flags."""
    return (item(p[0].room_flags, room) & bits) != 0


@wp.func
def owner_of(p: PlanProblemRef, frame: wp.int32, cell: wp.int32):
    """The room of a cell."""
    if cell < p[0].cells:
        return item(p[0].cell_room, cell)
    return item(p[0].fixed_room, item(p[0].fixed_start, frame) + cell - p[0].cells)[0]


@wp.func
def takes_doors(p: PlanProblemRef, frame: wp.int32, cell: wp.int32):
    """Whether doors may be in a cell's walls: not beside the flights of stairs."""
    if cell < p[0].cells:
        return True
    return item(p[0].fixed_room, item(p[0].fixed_start, frame) + cell - p[0].cells)[2] != 0


@wp.func
def next_cell(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    storey: wp.array(dtype=wp.int32),
    room: wp.int32,
    cell: wp.int32,
):
    """The cell of a room that follows on one of them, -1: its first; ``count`` where there is none.

    A room's own cell has the number of the room; others may come after those of all rooms.
    """
    i = int(room)
    if cell >= 0:
        i = wp.max(cell + 1, p[0].rooms)
    while i < count and (storey[i] < 0 or owner_of(p, frame, i) != room):
        i = wp.max(i + 1, p[0].rooms)
    return i


@wp.func
def gaps(a: wp.vec4i, b: wp.vec4i):
    """How far apart two rectangles are along x and y [mm]; negative: how far they reach past each other."""
    return wp.vec2i(wp.max(a[0], b[0]) - wp.min(a[2], b[2]), wp.max(a[1], b[1]) - wp.min(a[3], b[3]))


@wp.func
def shared_wall(a: wp.vec4i, b: wp.vec4i, inner: wp.int32):
    """How long [mm] the inner wall of a thickness [mm] is that two rectangles share, 0: none."""
    d = gaps(a, b)
    if d[0] == inner and d[1] < 0:
        return -d[1]
    if d[1] == inner and d[0] < 0:
        return -d[0]
    return 0


@wp.func
def lacking(p: PlanProblemRef, a: wp.vec4i, b: wp.vec4i, need: wp.int32):
    """How far [mm] two rectangles would have to move to share a wall of some length; 0: they do."""
    d = gaps(a, b)
    over_x = wp.abs(d[0] - p[0].inner) + wp.max(need + d[1], 0)
    over_y = wp.abs(d[1] - p[0].inner) + wp.max(need + d[0], 0)
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
def door_width(p: PlanProblemRef, a: wp.int32, b: wp.int32):
    """Width [mm] of a door between two rooms: that of the lesser one."""
    return wp.min(item(p[0].room_door, a), item(p[0].room_door, b))


@wp.func
def rooms_lack(
    p: PlanProblemRef,
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
    i = next_cell(p, frame, count, storey, a, -1)
    while i < count:
        if not doors or takes_doors(p, frame, i):
            j = next_cell(p, frame, count, storey, b, -1)
            while j < count:
                if storey[j] == storey[i] and (not doors or takes_doors(p, frame, j)):
                    least = wp.min(least, lacking(p, cells[i], cells[j], need))
                j = next_cell(p, frame, count, storey, b, j)
        i = next_cell(p, frame, count, storey, a, i)
    return least


@wp.func
def rooms_gap(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    a: wp.int32,
    others: wp.int32,
):
    """How far [m] a room is from the nearest of a set of rooms on its storey, from wall to wall; 3 m a storey."""
    least = float(1000.0)
    i = next_cell(p, frame, count, storey, a, -1)
    while i < count:
        for j in range(count):
            if storey[j] >= 0:
                if (others >> owner_of(p, frame, j)) & 1:
                    d = gaps(cells[i], cells[j])
                    x = float(wp.max(d[0], 0))
                    y = float(wp.max(d[1], 0))
                    floors = float(wp.abs(storey[i] - storey[j]))
                    least = wp.min(least, MILLI * wp.sqrt(x * x + y * y) + 3.0 * floors)
        i = next_cell(p, frame, count, storey, a, i)
    return least


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    return __ffs(mask) - 1;
#else
    return mask == 0 ? -1 : __builtin_ctz(static_cast<unsigned>(mask));
#endif
""")
def lowest_bit(mask: wp.int32) -> wp.int32:
    """The number of a mask's lowest bit; -1: it has none."""
    ...


@wp.func
def facade_way(p: PlanProblemRef, hull: wp.vec4i):
    """How far [mm] a rectangle is from the nearest outer wall that may have windows."""
    least = int(FAR)
    for f in range(p[0].facade.shape[0]):
        if (item(p[0].facade_flags, f) & WINDOWS) != 0:
            least = wp.min(least, wp.abs(hull[item(p[0].facade, f)[0]] - item(p[0].facade, f)[1]))
    return least
