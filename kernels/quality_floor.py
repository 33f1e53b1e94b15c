"""Measures of `quality` that need the free floor as a grid: ways, empty squares, what is far from everything.

They cost about as much as all others together a hundred times, so they are for the best candidates only.
"""

import warp as wp

from .array_access import item
from .geometry import FAR
from .quality import ON_FLOOR, Member, Terms, gap_to_point, member_of, side_of
from .tables import Problems, State
from .walk import Floor, cell_middle, clearance

wp.set_module_options({"enable_backward": False})

WAY = ON_FLOOR  # [m] width of the widest way from the doors to where p0 is left to a, or to its side p1 (-1: any)
EMPTY = ON_FLOOR + 1  # [m] side of the largest free square along the room's axes
REMOTE = ON_FLOOR + 2  # [m] from the free floor that is furthest off to the nearest of the members

LEVELS = wp.constant(16)  # of clearance
LEVEL = wp.constant(0.04)  # [m]
ENTRY = wp.constant(0.6)  # [m] around a step inside of a door within which ways begin


@wp.kernel
def measure_clearance(
    # Problem:
    b: Problems,
    floor: Floor,
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    level_out: wp.array2d(dtype=wp.int32),
):
    """Clearance of the cells [slot, cell] in levels: 0 where nobody can stand, ``LEVELS`` where it is more."""
    slot, cell = wp.tid()
    free = clearance(b, s, floor, selected[slot], cell_middle(floor, cell), float(LEVELS) * LEVEL)
    level_out[slot, cell] = wp.clamp(int(wp.floor(free / LEVEL)), 0, LEVELS)


@wp.kernel
def widest_ways(
    # Problem:
    floor: Floor,
    doors: wp.array(dtype=wp.vec2),
    # State in:
    level: wp.array2d(dtype=wp.int32),
    # State in and out:
    link: wp.array2d(dtype=wp.int32),
    head: wp.array2d(dtype=wp.int32),
    # State out:
    way_out: wp.array2d(dtype=wp.int32),
):
    """The least level on the best way from a door to each cell [slot, cell]; 0: there is none.

    Dijkstra's algorithm with the least level of a way in place of its length, and a list of cells for each level.
    ``doors`` are points a step inside of them; ways begin in squares around these.
    """
    slot = wp.tid()
    cells = floor.nx * floor.ny
    for cell in range(cells):
        way_out[slot, cell] = 0
    for k in range(LEVELS + 1):
        head[slot, k] = -1
    for d in range(doors.shape[0]):
        near = float(FAR)  # where nobody can stand there, the nearest cell where someone can
        for cell in range(cells):
            if level[slot, cell] > 0:
                v = cell_middle(floor, cell) - doors[d]
                near = wp.min(near, wp.max(wp.abs(v[0]), wp.abs(v[1])))
        for cell in range(cells):
            now = level[slot, cell]
            v = cell_middle(floor, cell) - doors[d]
            inside = wp.max(wp.abs(v[0]), wp.abs(v[1])) <= wp.max(near, ENTRY)
            if inside and now > 0 and way_out[slot, cell] == 0:
                way_out[slot, cell] = now
                link[slot, cell] = head[slot, now]
                head[slot, now] = cell
    for k in range(LEVELS):
        now = LEVELS - k
        while head[slot, now] >= 0:
            cell = head[slot, now]
            head[slot, now] = link[slot, cell]
            x = cell % floor.nx
            y = cell // floor.nx
            for side in range(4):
                nx = x + wp.where(side == 0, 1, wp.where(side == 1, -1, 0))
                ny = y + wp.where(side == 2, 1, wp.where(side == 3, -1, 0))
                if nx >= 0 and nx < floor.nx and ny >= 0 and ny < floor.ny:
                    to = ny * floor.nx + nx
                    if way_out[slot, to] == 0 and level[slot, to] > 0:
                        width = wp.min(now, level[slot, to])
                        way_out[slot, to] = width
                        link[slot, to] = head[slot, width]
                        head[slot, width] = to


@wp.kernel
def measure_floor(
    # Problem:
    b: Problems,
    terms: Terms,
    floor: Floor,
    rows: wp.array(dtype=wp.int32),
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    level: wp.array2d(dtype=wp.int32),
    way: wp.array2d(dtype=wp.int32),
    # State in and out:
    square: wp.array2d(dtype=wp.int32),
    # State out:
    value_out: wp.array2d(dtype=wp.float32),
):
    """The measures [slot, row] of the rows on the floor."""
    slot, number = wp.tid()
    row = rows[number]
    kind = item(terms.kind, row)
    candidate = selected[slot]
    first = item(terms.member_start, row)
    last = item(terms.member_start, row + 1)
    p = item(terms.params, row)
    target = Member()
    if kind == WAY:
        target = member_of(b, terms, s, candidate, first)
        if p[1] >= 0.0:  # the face of that side, a little narrower
            target = side_of(target, int(p[1]))
            target.at = target.at + target.half[0] * target.turn
            target.half = wp.vec2(0.0, 0.7 * target.half[1])
    best = float(0.0)
    for cell in range(floor.nx * floor.ny):
        if kind == EMPTY:
            side = int(0)
            if level[slot, cell] > 0:
                side = 1
                if cell % floor.nx > 0 and cell >= floor.nx:
                    before = wp.min(square[slot, cell - 1], square[slot, cell - floor.nx])
                    side += wp.min(before, square[slot, cell - floor.nx - 1])
            square[slot, cell] = side
            best = wp.max(best, float(side) * floor.cell)
        elif kind == WAY:
            radius = float(way[slot, cell]) * LEVEL
            if radius > 0.5 * best:
                if gap_to_point(target, cell_middle(floor, cell)) <= radius + p[0]:
                    best = 2.0 * radius
        elif level[slot, cell] > 0:
            near = float(FAR)
            for k in range(first, last):
                near = wp.min(near, gap_to_point(member_of(b, terms, s, candidate, k), cell_middle(floor, cell)))
            best = wp.max(best, near)
    value_out[slot, row] = best
