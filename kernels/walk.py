"""How much of the free floor can be walked to from the doors: a flood fill for each candidate.

A coarse measure for choosing among valid layouts; the judge has its own, finer one.
"""

import warp as wp

from .array_access import item
from .geometry import FAR, plane_of, turn_back
from .tables import FIXTURE_SOLID, SOLIDS, Problems, State, TablesRef, parts_of

wp.set_module_options({"enable_backward": False})

FREE = wp.constant(0)
BLOCKED = wp.constant(1)
REACHED = wp.constant(2)


@wp.struct
class Floor:
    """A grid over the room: lowest corner, cell size [m], counts; who walks on it."""

    origin: wp.vec2
    cell: wp.float32
    nx: wp.int32
    ny: wp.int32
    radius: wp.float32  # of the robot
    low: wp.float32  # solids wholly below this height are walked over
    high: wp.float32  # solids wholly above it are walked under


@wp.func
def point_distance(t: TablesRef, a: wp.int32, x: wp.vec2):
    """Distance from a point to a convex polygon in the polygon's frame; at most 0 inside."""
    first = t[0].prism_start[a]
    last = t[0].prism_start[a + 1]
    inside = bool(True)
    best = float(FAR)
    for e in range(first, last):
        face = t[0].edge[e]
        if face[0] * x[0] + face[1] * x[1] > face[2]:
            inside = False
        p = t[0].vertex[e]
        f = e + 1
        if f == last:
            f = first
        s = t[0].vertex[f] - p
        u = wp.clamp(wp.dot(x - p, s) / wp.max(wp.dot(s, s), 1.0e-12), 0.0, 1.0)
        best = wp.min(best, wp.length(x - p - u * s))
    return wp.where(inside, 0.0, best)


@wp.func
def cell_middle(floor: Floor, cell: wp.int32):
    """The middle of a cell."""
    return floor.origin + floor.cell * wp.vec2(float(cell % floor.nx) + 0.5, float(cell // floor.nx) + 0.5)


@wp.func
def clearance(b: Problems, s: State, floor: Floor, candidate: wp.int32, x: wp.vec2, most: wp.float32):
    """Distance [m] from a point to the nearest solid or wall, ``most`` where it is more; at most 0 inside of one."""
    t = b.tables
    p = b.problem[candidate]
    free = most
    for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
        plane = item(t[0].plane, k)
        free = wp.min(free, plane[0] * x[0] + plane[1] * x[1] - plane[2])
    for k in range(item(t[0].fixture_start, p), item(t[0].fixture_start, p + 1)):
        if free > 0.0 and item(t[0].fixture_kind, k) == FIXTURE_SOLID:
            free = wp.min(free, point_distance(t, item(t[0].fixture, k), x))
    o0 = item(t[0].object_start, p)
    for obj in range(item(t[0].object_start, p + 1) - o0):
        if free > 0.0:
            pose = s.poses[candidate, obj]
            v = x - plane_of(pose)
            reach = item(t[0].object_radius, o0 + obj)[0] + free
            if wp.dot(v, v) < reach * reach:
                local = turn_back(s.turns[candidate, obj], v)
                solids = parts_of(t, o0 + obj, SOLIDS)
                for a in range(solids[0], solids[1]):
                    z = item(t[0].prism_z, a)
                    if pose[2] + z[0] < floor.high and pose[2] + z[1] > floor.low:
                        free = wp.min(free, point_distance(t, a, local))
    return free


@wp.kernel
def mark_floor(
    # Problem:
    b: Problems,
    floor: Floor,
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    grid_out: wp.array2d(dtype=wp.int32),
):
    """Mark the cells [slot, cell] where the robot cannot stand."""
    slot, cell = wp.tid()
    free = clearance(b, s, floor, selected[slot], cell_middle(floor, cell), floor.radius)
    grid_out[slot, cell] = wp.where(free < floor.radius, BLOCKED, FREE)


@wp.func
def flood_fill(
    grid: wp.array2d(dtype=wp.int32),
    queue: wp.array2d(dtype=wp.int32),
    slot: wp.int32,
    floor: Floor,
    seed: wp.int32,
):
    """Flood the free cells from a seed; returns how many it reached."""
    if grid[slot, seed] != FREE:
        return 0
    grid[slot, seed] = REACHED
    queue[slot, 0] = seed
    head = int(0)
    tail = int(1)
    while head < tail:
        cell = queue[slot, head]
        head += 1
        x = cell % floor.nx
        y = cell // floor.nx
        for side in range(4):
            nx = x + wp.where(side == 0, 1, wp.where(side == 1, -1, 0))
            ny = y + wp.where(side == 2, 1, wp.where(side == 3, -1, 0))
            if nx >= 0 and nx < floor.nx and ny >= 0 and ny < floor.ny:
                to = ny * floor.nx + nx
                if grid[slot, to] == FREE:
                    grid[slot, to] = REACHED
                    queue[slot, tail] = to
                    tail += 1
    return tail


@wp.kernel
def walk(
    # Problem:
    floor: Floor,
    doors: wp.array(dtype=wp.vec2),
    # State in and out:
    grid: wp.array2d(dtype=wp.int32),
    queue: wp.array2d(dtype=wp.int32),
    # State out:
    share_out: wp.array(dtype=wp.float32),
):
    """Share of the free cells reached from the doors; without doors, by the largest connected piece."""
    slot = wp.tid()
    cells = floor.nx * floor.ny
    free = int(0)
    for cell in range(cells):
        if grid[slot, cell] == FREE:
            free += 1
    reached = int(0)
    for d in range(doors.shape[0]):
        near = float(FAR)
        seed = int(-1)
        for cell in range(cells):
            if grid[slot, cell] != BLOCKED:
                far = wp.length(cell_middle(floor, cell) - doors[d])
                if far < near:
                    near = far
                    seed = cell
        if seed >= 0:
            reached += flood_fill(grid, queue, slot, floor, seed)
    if doors.shape[0] == 0:
        for cell in range(cells):
            reached = wp.max(reached, flood_fill(grid, queue, slot, floor, cell))
    share_out[slot] = wp.where(free > 0, float(reached) / float(wp.max(free, 1)), 0.0)
