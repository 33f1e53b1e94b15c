"""The last word of the solver on a plan: doors and windows are placed and every rule is measured, in whole numbers.

What is called valid here breaks no rule: each violation is the excess of integers over integers, and 0.
"""

import warp as wp

from .array_access import item
from .plan_doors import place_doors
from .plan_geometry import owner_of
from .plan_measures import hard_of, measure_plan
from .plan_openings import rooms_without_turning, soft_of_doors
from .plan_tables import (
    DOORS,
    FRONTS,
    HARD_WEIGHT,
    MAX_CELLS,
    MAX_CODE,
    MAX_DOORS,
    PANES,
    RULE_COUNT,
    TURN,
    PlanProblemRef,
    PlanState,
)
from .plan_tree import lay_out, measure_trees
from .plan_windows import place_windows

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def place_cells(
    # Problem:
    p: PlanProblemRef,
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: PlanState,
):
    """Cells of each active candidate that is not valid yet, from its code and cuts."""
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
    weight = wp.zeros(shape=(MAX_CELLS,), dtype=wp.float32)
    cells = wp.zeros(shape=(MAX_CELLS,), dtype=wp.vec4i)
    storey = wp.zeros(shape=(MAX_CELLS,), dtype=wp.int32)
    for k in range(n):
        code[k] = s.code[candidate, k]
        cut[k] = s.cut[candidate, k]
    for k in range(p[0].cells):
        weight[k] = s.weight[candidate, k]
    measure_trees(p, code, n, weight, end, least, share)
    count = lay_out(p, frame, code, n, False, end, least, share, box, level, cut, cells, storey)
    for k in range(MAX_CELLS):
        s.owner[candidate, k] = -1
        s.storey[candidate, k] = -1
        s.cells[candidate, k] = wp.vec4i(0, 0, 0, 0)
    for k in range(count):
        if storey[k] >= 0:
            s.cells[candidate, k] = cells[k]
            s.storey[candidate, k] = storey[k]
            s.owner[candidate, k] = owner_of(p, frame, k)


@wp.kernel
def judge_cells(
    # Problem:
    p: PlanProblemRef,
    # State in:
    active: wp.array(dtype=wp.int32),
    # State in and out:
    s: PlanState,
):
    """Doors, windows, violations and status of each active candidate that is not valid yet, from its cells."""
    candidate = active[wp.tid()]
    if s.status[candidate] != 0:
        return
    frame = s.frame[candidate]
    count = p[0].cells + item(p[0].fixed_start, frame + 1) - item(p[0].fixed_start, frame)
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
    for k in range(count):
        cells[k] = s.cells[candidate, k]
        storey[k] = s.storey[candidate, k]
    soft, blame = measure_plan(p, frame, count, cells, storey, touch, wets, area, must, parent, violation)
    doors = s.doors[candidate]
    n_doors, failed = place_doors(
        p, frame, count, cells, storey, must, parent, leaves, leaf_level, fronts, front_level, record, doors
    )
    violation[DOORS] = float(failed)
    n_windows, lack = place_windows(p, frame, count, cells, storey, area, doors, n_doors, s.windows[candidate])
    violation[PANES] = 0.001 * float(lack)
    violation[TURN] = float(rooms_without_turning(p, frame, count, cells, storey, leaves, leaf_level, n_doors))
    soft += soft_of_doors(p, frame, count, cells, storey, doors, n_doors)
    hard = hard_of(violation)
    for k in range(RULE_COUNT):
        s.violation[candidate, k] = violation[k]
    s.count[candidate] = wp.vec2i(n_doors, n_windows)
    s.blame[candidate] = blame
    s.energy[candidate] = HARD_WEIGHT * hard + soft
    if hard == 0.0:
        s.status[candidate] = 1
