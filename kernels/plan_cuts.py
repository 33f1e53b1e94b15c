"""Where the cuts of a slicing tree lie: projected least squares over a plan's topology, which stays as it is.

Residuals are the floor that rooms lack or have too much of, their distance from the floor that is wanted, walls too
short for the doors that are to be in them, outer walls too short for windows, and sides that are too unequal. Each has
its derivatives by the sides of the cells, and each side is a cut. A step goes along the gradient, scaled by the
diagonal of the Gauss-Newton matrix, and is projected onto what the least sides leave open (`plan_tree.cut_between`).
"""

import warp as wp

from .array_access import item
from .plan_geometry import FAR, facade_overlap, gaps, has, lacking, next_cell, takes_doors
from .plan_measures import hard_of, measure_plan, window_need
from .plan_openings import openings_fail
from .plan_tables import (
    APART,
    CUT_X,
    ENTRANCE,
    FRONTS,
    GLAZED,
    HARD_WEIGHT,
    LIT,
    MAX_CELLS,
    MAX_CODE,
    MAX_DOORS,
    NEAR,
    RULE_COUNT,
    WINDOWS,
    PlanProblemRef,
    PlanState,
)
from .plan_tree import lay_out, measure_trees

wp.set_module_options({"enable_backward": False, "fast_math": False})

WANTED = wp.constant(0.05)  # weight of the floor that is wanted, against a floor's bounds
DAMPING = wp.constant(0.6)
MARGIN = wp.constant(0.01)  # [m, m2] that residuals ask for beyond a bound, so that whole millimetres keep it


@wp.func
def bound_cuts(
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    roots: wp.int32,
    end: wp.array(dtype=wp.int32),
    bounds: wp.array(dtype=wp.vec4i),
    cell_bounds: wp.array(dtype=wp.vec4i),
):
    """For each side of each cell the place in the code of the cut that it lies on; -1: the bay's own side."""
    root = int(0)
    for _bay in range(roots):
        bounds[root] = wp.vec4i(-1, -1, -1, -1)
        root = end[root]
    for t in range(n):
        what = code[t]
        if what < CUT_X:
            cell_bounds[what] = bounds[t]
        else:
            axis = what - CUT_X
            a = bounds[t]
            b = bounds[t]
            a[axis + 2] = t
            b[axis] = t
            bounds[t + 1] = a
            bounds[end[t + 1]] = b


@wp.func
def pull(
    cell_bounds: wp.array(dtype=wp.vec4i),
    cells: wp.int32,
    cell: wp.int32,
    side: wp.int32,
    residual: wp.float32,
    slope: wp.float32,
    weight: wp.float32,
    gradient: wp.array(dtype=wp.float32),
    curvature: wp.array(dtype=wp.float32),
):
    """Add a residual with its derivative by the side of a cell to the gradient of the cut that it lies on."""
    if cell < cells:
        t = cell_bounds[cell][side]
        if t >= 0:
            gradient[t] = gradient[t] + weight * residual * slope
            curvature[t] = curvature[t] + weight * slope * slope


@wp.func
def on_one_cut(cell_bounds: wp.array(dtype=wp.vec4i), cells: wp.int32, i: wp.int32, j: wp.int32, side: wp.int32):
    """Whether the same sides of two cells are one cut's."""
    if i >= cells or j >= cells:
        return False
    return cell_bounds[i][side] == cell_bounds[j][side]


@wp.func
def pull_overlap(
    p: PlanProblemRef,
    cell_bounds: wp.array(dtype=wp.vec4i),
    i: wp.int32,
    a: wp.vec4i,
    j: wp.int32,
    b: wp.vec4i,
    axis: wp.int32,
    need: wp.int32,
    gradient: wp.array(dtype=wp.float32),
    curvature: wp.array(dtype=wp.float32),
):
    """The residual of two cells that overlap too little along an axis; ``j`` of at least MAX_CELLS is a wall."""
    low = wp.max(a[axis], b[axis])
    high = wp.min(a[axis + 2], b[axis + 2])
    e = 0.001 * float(need - (high - low))
    if e > 0.0:
        e += MARGIN
        if a[axis + 2] <= b[axis + 2]:
            pull(cell_bounds, p[0].cells, i, axis + 2, e, -1.0, 4.0, gradient, curvature)
        if b[axis + 2] <= a[axis + 2] and not on_one_cut(cell_bounds, p[0].cells, i, j, axis + 2):
            pull(cell_bounds, p[0].cells, j, axis + 2, e, -1.0, 4.0, gradient, curvature)
        if a[axis] >= b[axis]:
            pull(cell_bounds, p[0].cells, i, axis, e, 1.0, 4.0, gradient, curvature)
        if b[axis] >= a[axis] and not on_one_cut(cell_bounds, p[0].cells, i, j, axis):
            pull(cell_bounds, p[0].cells, j, axis, e, 1.0, 4.0, gradient, curvature)
    return wp.max(e, 0.0)


@wp.func
def pull_rooms(
    p: PlanProblemRef,
    count: wp.int32,
    frame: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
    cell_bounds: wp.array(dtype=wp.vec4i),
    gradient: wp.array(dtype=wp.float32),
    curvature: wp.array(dtype=wp.float32),
):
    """Residuals of rooms by themselves: floor, shape, light. Gives half their weighted sum of squares."""
    cost = float(0.0)
    for i in range(p[0].cells):
        if storey[i] >= 0:
            r = item(p[0].cell_room, i)
            c = cells[i]
            w = 0.001 * float(c[2] - c[0])
            h = 0.001 * float(c[3] - c[1])
            limits = item(p[0].room_area, r)
            floor = 1.0e-6 * float(area[r])
            low = 1.0e-6 * float(limits[0])
            high = 1.0e-6 * float(limits[2])
            slack = wp.min(MARGIN, 0.5 * (high - low))
            e = floor - wp.clamp(floor, low + slack, high - slack)
            off = floor - 1.0e-6 * float(limits[1])
            for k in range(2):
                residual = e
                weight = float(1.0)
                if k == 1:
                    residual = off
                    weight = WANTED
                pull(cell_bounds, p[0].cells, i, 0, residual, -h, weight, gradient, curvature)
                pull(cell_bounds, p[0].cells, i, 2, residual, h, weight, gradient, curvature)
                pull(cell_bounds, p[0].cells, i, 1, residual, -w, weight, gradient, curvature)
                pull(cell_bounds, p[0].cells, i, 3, residual, w, weight, gradient, curvature)
                if i < p[0].rooms:
                    cost += 0.5 * weight * residual * residual
            if i < p[0].rooms:
                ratio = 0.001 * float(item(p[0].room_aspect, r))
                axis = wp.where(w > h, 0, 1)
                over = wp.max(w, h) - ratio * wp.min(w, h)
                if over > 0.0:
                    over += MARGIN
                    pull(cell_bounds, p[0].cells, i, axis + 2, over, 1.0, 1.0, gradient, curvature)
                    pull(cell_bounds, p[0].cells, i, axis, over, -1.0, 1.0, gradient, curvature)
                    pull(cell_bounds, p[0].cells, i, 3 - axis, over, -ratio, 1.0, gradient, curvature)
                    pull(cell_bounds, p[0].cells, i, 1 - axis, over, ratio, 1.0, gradient, curvature)
                    cost += 0.5 * over * over
            if has(p, r, GLAZED | LIT) and i < p[0].rooms:
                need = int(p[0].least_window)
                if has(p, r, GLAZED):
                    need = wp.max(need, window_need(p, area[r]))
                best = int(-1)
                longest = int(0)
                for f in range(p[0].facade.shape[0]):
                    if (item(p[0].facade_flags, f) & WINDOWS) != 0:
                        s = facade_overlap(item(p[0].facade, f), c)
                        if s[1] - s[0] > longest:
                            longest = s[1] - s[0]
                            best = f
                if best >= 0:
                    facade = item(p[0].facade, best)
                    along = 1 - facade[0] % 2
                    wall = c
                    wall[along] = facade[2]
                    wall[along + 2] = facade[3]
                    e = pull_overlap(
                        p, cell_bounds, i, c, MAX_CELLS, wall, along, need + 2 * p[0].pier, gradient, curvature
                    )
                    cost += 2.0 * e * e
    return cost


@wp.func
def pull_door(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    cell_bounds: wp.array(dtype=wp.vec4i),
    a: wp.int32,
    b: wp.int32,
    need: wp.int32,
    gradient: wp.array(dtype=wp.float32),
    curvature: wp.array(dtype=wp.float32),
):
    """The residual of a wall between two rooms that is too short for their door."""
    least = int(FAR)
    best_i = int(-1)
    best_j = int(-1)
    i = next_cell(p, frame, count, storey, a, -1)
    while i < count:
        if takes_doors(p, frame, i):
            j = next_cell(p, frame, count, storey, b, -1)
            while j < count:
                if storey[j] == storey[i] and takes_doors(p, frame, j):
                    lack = lacking(p, cells[i], cells[j], need)
                    if lack < least:
                        least = lack
                        best_i = i
                        best_j = j
                j = next_cell(p, frame, count, storey, b, j)
        i = next_cell(p, frame, count, storey, a, i)
    if best_i < 0 or least == 0:
        return 0.0
    ca = cells[best_i]
    cb = cells[best_j]
    d = gaps(ca, cb)
    axis = int(-1)
    if d[0] == p[0].inner:
        axis = 1
    if d[1] == p[0].inner and (axis < 0 or d[0] < d[1]):
        axis = 0
    if axis < 0:
        return 0.0
    e = pull_overlap(p, cell_bounds, best_i, ca, best_j, cb, axis, need, gradient, curvature)
    return 2.0 * e * e


@wp.func
def pull_ways(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    parent: wp.array(dtype=wp.int32),
    cell_bounds: wp.array(dtype=wp.vec4i),
    gradient: wp.array(dtype=wp.float32),
    curvature: wp.array(dtype=wp.float32),
):
    """Residuals of walls that doors are to be in: those asked for, those found, the entrance's, ways within a room."""
    cost = float(0.0)
    for k in range(p[0].adjacency.shape[0]):
        x = item(p[0].adjacency, k)
        if x[2] != NEAR and x[2] != APART and item(p[0].adjacency_weight, k) < 0.0:
            need = x[3] + 2 * p[0].jamb
            cost += pull_door(p, frame, count, cells, storey, cell_bounds, x[0], x[1], need, gradient, curvature)
    for r in range(p[0].rooms):
        a = parent[r]
        if a >= 0:
            need = wp.min(item(p[0].room_door, a), item(p[0].room_door, r)) + 2 * p[0].jamb
            cost += pull_door(p, frame, count, cells, storey, cell_bounds, a, r, need, gradient, curvature)
    need = p[0].entrance_door + 2 * p[0].jamb
    longest = int(-FAR)
    best_i = int(-1)
    best_f = int(-1)
    for i in range(p[0].cells):
        if storey[i] == 0 and item(p[0].cell_room, i) == p[0].entrance:
            for f in range(p[0].facade.shape[0]):
                facade = item(p[0].facade, f)
                if (item(p[0].facade_flags, f) & ENTRANCE) != 0 and cells[i][facade[0]] == facade[1]:
                    along = 1 - facade[0] % 2
                    long = wp.min(cells[i][along + 2], facade[3]) - wp.max(cells[i][along], facade[2])
                    if long > longest:
                        longest = long
                        best_i = i
                        best_f = f
    if best_i >= 0:
        facade = item(p[0].facade, best_f)
        along = 1 - facade[0] % 2
        wall = cells[best_i]
        wall[along] = facade[2]
        wall[along + 2] = facade[3]
        e = pull_overlap(p, cell_bounds, best_i, cells[best_i], MAX_CELLS, wall, along, need, gradient, curvature)
        cost += 2.0 * e * e
    for i in range(p[0].rooms, p[0].cells):
        j = item(p[0].cell_room, i)
        if storey[i] >= 0:
            d = gaps(cells[i], cells[j])
            if d[0] == p[0].inner or d[1] == p[0].inner:
                axis = wp.where(d[0] == p[0].inner and d[1] <= d[0], 1, 0)
                e = pull_overlap(
                    p, cell_bounds, i, cells[i], j, cells[j], axis, item(p[0].room_side, j), gradient, curvature
                )
                cost += 2.0 * e * e
    return cost


@wp.kernel
def solve_cuts(
    # Problem:
    p: PlanProblemRef,
    steps: wp.int32,
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: PlanState,
):
    """Move the cuts of each active candidate that is not valid yet; what has the least energy stays."""
    candidate = active[wp.tid()]
    n = s.length[candidate]
    if s.status[candidate] != 0 or n == 0:
        return
    frame = s.frame[candidate]
    code = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    end = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    least = wp.zeros(shape=(MAX_CODE,), dtype=wp.vec2i)
    share = wp.zeros(shape=(MAX_CODE,), dtype=wp.float32)
    box = wp.zeros(shape=(MAX_CODE,), dtype=wp.vec4i)
    level = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    cut = wp.zeros(shape=(MAX_CODE,), dtype=wp.int32)
    bounds = wp.zeros(shape=(MAX_CODE,), dtype=wp.vec4i)
    gradient = wp.zeros(shape=(MAX_CODE,), dtype=wp.float32)
    curvature = wp.zeros(shape=(MAX_CODE,), dtype=wp.float32)
    weight = wp.zeros(shape=(MAX_CELLS,), dtype=wp.float32)
    cell_bounds = wp.zeros(shape=(MAX_CELLS,), dtype=wp.vec4i)
    cells = wp.zeros(shape=(MAX_CELLS,), dtype=wp.vec4i)
    storey = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    touch = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    wets = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    area = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    must = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    parent = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    violation = wp.zeros(shape=(RULE_COUNT,), dtype=wp.float32)
    leaves = wp.zeros(shape=(MAX_DOORS,), dtype=wp.vec4i)
    leaf_level = wp.zeros(shape=(MAX_DOORS,), dtype=wp.int32)
    fronts = wp.zeros(shape=(FRONTS,), dtype=wp.vec4i)
    front_level = wp.zeros(shape=(FRONTS,), dtype=wp.int32)
    record = wp.zeros(shape=(9,), dtype=wp.int32)
    doors = s.doors[candidate]
    windows = s.windows[candidate]
    for k in range(n):
        code[k] = s.code[candidate, k]
        cut[k] = s.cut[candidate, k]
    for k in range(p[0].cells):
        weight[k] = s.weight[candidate, k]
    measure_trees(p, code, n, weight, end, least, share)
    roots = item(p[0].bay_start, frame + 1) - item(p[0].bay_start, frame)
    bound_cuts(code, n, roots, end, bounds, cell_bounds)
    lowest = s.energy[candidate]
    for step in range(steps + 1):
        count = lay_out(p, frame, code, n, False, end, least, share, box, level, cut, cells, storey)
        soft, blame = measure_plan(p, frame, count, cells, storey, touch, wets, area, must, parent, violation)
        hard = hard_of(violation)
        energy = HARD_WEIGHT * hard + soft
        if energy < lowest and hard == 0.0:
            failed, lost = openings_fail(
                p, frame, count, cells, storey, area, must, parent,
                leaves, leaf_level, fronts, front_level, record, doors, windows,
            )  # fmt: skip
            energy += HARD_WEIGHT * failed + lost
        if energy < lowest:
            lowest = energy
            for k in range(n):
                s.cut[candidate, k] = cut[k]
        for k in range(n):
            gradient[k] = 0.0
            curvature[k] = 1.0e-3
        cost = pull_rooms(p, count, frame, cells, storey, area, cell_bounds, gradient, curvature)
        cost += pull_ways(p, frame, count, cells, storey, parent, cell_bounds, gradient, curvature)
        for k in range(n):
            if code[k] >= CUT_X:
                cut[k] = cut[k] - int(wp.round(1000.0 * DAMPING * gradient[k] / curvature[k]))
    s.energy[candidate] = lowest
