"""Where cuts lie: gradients against finite differences, projections, and trees as codes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels import plan_tables as T
from sceneweaver.kernels.plan_cuts import bound_cuts, pull_rooms, pull_ways
from sceneweaver.kernels.plan_forests import append_row
from sceneweaver.kernels.plan_tables import PlanProblemRef
from sceneweaver.kernels.plan_tree import insert_beside, lay_out, measure_trees, parent_of, subtree_end, take_out
from sceneweaver.kernels.plan_ways import survey_pairs
from tests.plans.solved import candidates, problem

CODE, CELLS = T.MAX_CODE, T.MAX_CELLS


@wp.kernel(enable_backward=False, module="unique")
def cost_and_gradient(
    p: PlanProblemRef,
    frame: wp.int32,
    code: wp.array(dtype=wp.int32),
    n: wp.int32,
    weight: wp.array(dtype=wp.float32),
    frozen: wp.array(dtype=wp.int32),
    cut: wp.array(dtype=wp.int32),
    cost_out: wp.array(dtype=wp.float32),
    gradient: wp.array(dtype=wp.float32),
):
    end = wp.zeros(shape=(CODE,), dtype=wp.int32)
    least = wp.zeros(shape=(CODE,), dtype=wp.vec2i)
    share = wp.zeros(shape=(CODE,), dtype=wp.float32)
    box = wp.zeros(shape=(CODE,), dtype=wp.vec4i)
    level = wp.zeros(shape=(CODE,), dtype=wp.int32)
    bounds = wp.zeros(shape=(CODE,), dtype=wp.vec4i)
    curvature = wp.zeros(shape=(CODE,), dtype=wp.float32)
    cell_bounds = wp.zeros(shape=(CELLS,), dtype=wp.vec4i)
    cells = wp.zeros(shape=(CELLS,), dtype=wp.vec4i)
    storey = wp.zeros(shape=(CELLS,), dtype=wp.int32)
    touch = wp.zeros(shape=(CELLS,), dtype=wp.int32)
    wets = wp.zeros(shape=(CELLS,), dtype=wp.int32)
    area = wp.zeros(shape=(CELLS,), dtype=wp.int32)
    measure_trees(p, code, n, weight, end, least, share)
    bound_cuts(code, n, p[0].bay_start[frame + 1] - p[0].bay_start[frame], end, bounds, cell_bounds)
    count = lay_out(p, frame, code, n, False, end, least, share, box, level, cut, cells, storey)
    _shape = survey_pairs(p, frame, count, cells, storey, touch, wets, area)
    cost = pull_rooms(p, count, frame, cells, storey, area, cell_bounds, gradient, curvature)
    cost += pull_ways(p, frame, count, cells, storey, frozen, cell_bounds, gradient, curvature)
    cost_out[0] = cost


@pytest.fixture(scope="module")
def loose():
    """A problem in which nothing is projected, no window grows with the floor and no residual has a jump."""
    plan = problem("flat-2-bedrooms", 1)
    arrays = dict(plan.arrays)
    arrays["cell_side"] = np.zeros_like(arrays["cell_side"])
    return replace(plan, arrays=arrays, numbers=plan.numbers | {"glazing": 0})


def test_gradients_are_those_of_finite_differences(loose):
    found = candidates("flat-2-bedrooms", 1)
    p = loose.on_device("cpu")
    frozen = wp.full(CELLS, -1, dtype=wp.int32, device="cpu")
    step, compared, steep = 4, 0, 0
    for k in range(16):
        n = int(found["length"][k])
        code = wp.array(found["code"][k], dtype=wp.int32, device="cpu")
        weight = wp.array(found["weight"][k], dtype=wp.float32, device="cpu")

        def at(cuts, k=k, n=n, code=code, weight=weight):
            cost, gradient = wp.zeros(1, device="cpu"), wp.zeros(CODE, device="cpu")
            given = wp.array(cuts, dtype=wp.int32, device="cpu")
            inputs = [p.ref, int(found["frame"][k]), code, n, weight, frozen, given]
            wp.launch(cost_and_gradient, 1, inputs, [cost, gradient], device="cpu")
            return float(cost.numpy()[0]), gradient.numpy()

        if (found["storey"][k, loose.numbers["rooms"] :] >= 0).any():
            continue  # the part of a wall that is not there changes with cuts, which gradients leave out
        _, gradient = at(found["cut"][k])
        for t in np.flatnonzero(found["code"][k, :n] >= int(T.CUT_X)):
            values = []
            for h in (-step, 0, step):
                cuts = found["cut"][k].copy()
                cuts[t] += h
                values.append(at(cuts)[0])
            before, behind = ((values[i + 1] - values[i]) / (step / 1000) for i in (0, 1))
            if abs(before - behind) > 0.05 * max(abs(before), 1.0):
                continue  # a residual begins or ends here: half of that is more than what is tolerated below
            close = (before + behind) / 2
            assert gradient[t] == pytest.approx(close, rel=0.03, abs=0.03), f"candidate {k}, cut {t}"
            compared += 1
            steep += abs(close) > 1
    assert compared >= 30 and steep >= 8


def test_cuts_leave_both_sides_their_least_width_where_there_is_room():
    plan, found = problem("flat-2-bedrooms", 1), candidates("flat-2-bedrooms", 1)
    for k in range(len(found["status"])):
        code, n = found["code"][k], int(found["length"][k])
        least = _least(code, plan)
        bay = plan.arrays["bay"][0]
        if n and (least[0] <= (bay[2:] - bay[:2])).all():
            side = plan.arrays["cell_side"]
            for cell in range(plan.numbers["cells"]):
                if found["storey"][k, cell] >= 0:
                    c = found["cells"][k, cell]
                    assert min(c[2] - c[0], c[3] - c[1]) >= side[cell]


def _least(code, plan, at=0):
    """Least extents of the subtree at a place, and where it ends."""
    what = int(code[at])
    if what < int(T.CUT_X):
        side = plan.arrays["cell_side"][what]
        return np.array([side, side]), at + 1
    a, end = _least(code, plan, at + 1)
    b, end = _least(code, plan, end)
    axis, total = what - int(T.CUT_X), np.maximum(a, b)
    total[axis] = a[axis] + plan.numbers["inner"] + b[axis]
    return total, end


@pytest.mark.parametrize("name", ["flat-2-bedrooms", "house-3-bedrooms"])
def test_cells_and_walls_tile_the_bays(name):
    plan, found = problem(name, 0), candidates(name, 0)
    for k in range(len(found["status"])):
        frame = plan.frames[int(found["frame"][k])]
        for storey, bays in enumerate(frame.bays):
            for bay in bays:
                inside = [
                    c
                    for cell, c in enumerate(found["cells"][k][: plan.numbers["cells"]])
                    if found["storey"][k, cell] == storey
                    and bay[0] <= c[0]
                    and c[2] <= bay[2]
                    and bay[1] <= c[1]
                    and c[3] <= bay[3]
                ]
                inner = plan.numbers["inner"]
                padded = sum((c[2] - c[0] + inner) * (c[3] - c[1] + inner) for c in inside)
                assert padded == (bay[2] - bay[0] + inner) * (bay[3] - bay[1] + inner)


@wp.kernel(enable_backward=False, module="unique")
def edit(
    code: wp.array(dtype=wp.int32),
    piece: wp.array(dtype=wp.int32),
    at: wp.int32,
    into: wp.int32,
    length: wp.array(dtype=wp.int32),
    found: wp.array(dtype=wp.int32),
):
    found[0] = parent_of(code, at)
    found[1] = subtree_end(code, at)
    if found[0] >= 0:
        m = take_out(code, length[0], at, found[0], piece)
        length[0] = insert_beside(code, length[0] - m - 1, into, 101, True, piece, m)


def test_a_subtree_moves_to_another_place():
    x, y = 100, 101
    code = [x, 0, y, 1, x, 2, 3]  # 0 | (1 / (2 | 3))
    arrays = [
        wp.array(np.array(code + [0] * 20), dtype=wp.int32, device="cpu"),
        wp.zeros(27, dtype=wp.int32, device="cpu"),
    ]
    length, found = wp.array([7], dtype=wp.int32, device="cpu"), wp.zeros(2, dtype=wp.int32, device="cpu")
    wp.launch(edit, 1, [*arrays, 4, 1, length, found], device="cpu")
    assert found.numpy().tolist() == [2, 7]  # of 2 | 3
    # beside 0, which is at place 1 of what is left: (0 / (2 | 3)) | 1
    assert arrays[0].numpy()[: length.numpy()[0]].tolist() == [x, y, 0, x, 2, 3, 1]


@wp.kernel(enable_backward=False, module="unique")
def row(code: wp.array(dtype=wp.int32), piece: wp.array(dtype=wp.int32), length: wp.array(dtype=wp.int32)):
    length[0] = append_row(code, 0, 100, piece, 0, 3)


def test_a_row_is_a_chain_of_cuts():
    code, length = wp.zeros(8, dtype=wp.int32, device="cpu"), wp.zeros(1, dtype=wp.int32, device="cpu")
    wp.launch(row, 1, [code, wp.array([5, 6, 7], dtype=wp.int32, device="cpu"), length], device="cpu")
    assert code.numpy()[: length.numpy()[0]].tolist() == [100, 5, 100, 6, 7]
