"""Length of the way on foot between two pins: shortest ways over the free floor as a grid."""

import warp as wp

from .array_access import item
from .bodies import candidate_of
from .geometry import FAR
from .objective import Objective, pin_of
from .tables import Problems, State
from .walk import Floor, cell_middle

wp.set_module_options({"enable_backward": False})

WALKER = wp.constant(5)  # levels of clearance (`quality_floor.LEVEL`) that a person needs on both sides: 0.2 m
ROUNDS = wp.constant(200)  # of four sweeps, each in another direction; a way with fewer turns than that is found
DIAGONAL = wp.constant(1.4142135623730951)


@wp.func
def nearest_free(floor: Floor, level: wp.array2d(dtype=wp.int32), slot: wp.int32, at: wp.vec2):
    """The free cell nearest to a point (-1: there is none), and how far off its middle is."""
    best = int(-1)
    near = float(FAR)
    for cell in range(floor.nx * floor.ny):
        if item(level, slot, cell) >= WALKER:
            d = wp.length(cell_middle(floor, cell) - at)
            if d < near:
                near = d
                best = cell
    return best, near


@wp.func
def relax(
    floor: Floor,
    level: wp.array2d(dtype=wp.int32),
    way: wp.array2d(dtype=wp.float32),
    row: wp.int32,
    slot: wp.int32,
    x: wp.int32,
    y: wp.int32,
):
    """Shorten the way to a cell by its neighbours; 1: it got shorter. Corners are not cut."""
    cell = y * floor.nx + x
    if item(level, slot, cell) < WALKER:
        return 0
    best = float(way[row, cell])
    was = float(best)
    for dy in range(-1, 2):
        for dx in range(-1, 2):
            u = x + dx
            v = y + dy
            if (dx != 0 or dy != 0) and u >= 0 and v >= 0 and u < floor.nx and v < floor.ny:
                free = item(level, slot, v * floor.nx + u) >= WALKER
                step = float(1.0)
                if dx != 0 and dy != 0:
                    step = DIAGONAL
                    free = free and item(level, slot, y * floor.nx + u) >= WALKER
                    free = free and item(level, slot, v * floor.nx + x) >= WALKER
                if free:
                    best = wp.min(best, way[row, v * floor.nx + u] + step * floor.cell)
    if best < was - 1.0e-6:
        way[row, cell] = best
        return 1
    return 0


@wp.kernel
def measure_walking(
    # Problem:
    b: Problems,
    o: Objective,
    floor: Floor,
    terms: wp.array(dtype=wp.int32),
    detour: wp.float32,
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    level: wp.array2d(dtype=wp.int32),
    # State in and out:
    way: wp.array2d(dtype=wp.float32),
    # State out:
    value_out: wp.array2d(dtype=wp.float32),
):
    """Weighted length [slot, number] of the ways of some terms; where there is none, as the crow flies and ``detour``.

    ``way`` [slot * terms, cell] is room to work in.
    """
    slot, number = wp.tid()
    row = slot * terms.shape[0] + number
    term = item(terms, number)
    c = candidate_of(b, selected[slot])
    k = item(o.member_start, term)
    p = pin_of(o, c, s, k).at
    q = pin_of(o, c, s, k + 1).at
    here = wp.vec2(p[0], p[1])
    there = wp.vec2(q[0], q[1])
    value = wp.length(there - here) + detour
    first, near = nearest_free(floor, level, slot, here)
    last, far = nearest_free(floor, level, slot, there)
    if first >= 0:
        for cell in range(floor.nx * floor.ny):
            way[row, cell] = FAR
        way[row, first] = near
        changed = int(1)
        rounds = int(0)
        while changed != 0 and rounds < ROUNDS:
            changed = int(0)
            rounds += 1
            for sweep in range(4):
                for j in range(floor.ny):
                    y = wp.where(sweep < 2, j, floor.ny - 1 - j)
                    for i in range(floor.nx):
                        x = wp.where(sweep % 2 == 0, i, floor.nx - 1 - i)
                        changed = wp.max(changed, relax(floor, level, way, row, slot, x, y))
        found = way[row, last] + far
        if found < FAR:
            value = wp.max(found, wp.length(there - here))
    value_out[slot, number] = value * item(o.weight, term)
