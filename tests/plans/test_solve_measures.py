"""The kernels' measures of plans against a twin of their own arithmetic, and under mirrors and quarter turns."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.kernels.plan_tables import RULES
from sceneweaver.plans import Envelope, Programme
from sceneweaver.plans.solve_problem import compile_plan
from sceneweaver.plans.solve_run import judge_rectangles
from tests.plans.solved import Twin, candidates, problem

EXAMPLES = [("flat-2-bedrooms", 0), ("flat-2-bedrooms", 1), ("house-3-bedrooms", 0), ("clinic-doctor", 0)]


@pytest.mark.parametrize(("name", "seed"), EXAMPLES)
def test_violations_are_those_of_the_twin(name, seed):
    plan, found = problem(name, seed), candidates(name, seed)
    broken = np.zeros(len(RULES), dtype=int)
    for k in range(len(found["status"])):
        twin = Twin(plan, int(found["frame"][k]), found["cells"][k], found["storey"][k], found["owner"][k])
        for rule, value in twin.violations().items():
            got = float(found["violation"][k, RULES.index(rule)])
            if rule in ("reached", "wet-groups"):
                got = float(got > 0)
            assert got == pytest.approx(value, rel=1e-4, abs=1e-5), f"candidate {k}: {rule}"
            assert (got == 0) == (value == 0), f"candidate {k}: {rule}"
            broken[RULES.index(rule)] += value > 0
    assert (broken[:5] > 0).sum() >= 4  # the candidates are such that rules are seen to be broken


def _moved(points, turn):
    """Corners turned by quarters, then mirrored in x where turn is negative; the lowest corner comes to 0, 0."""
    points = np.array(points, dtype=float)
    for _ in range(abs(turn) % 4):
        points = np.stack([-points[:, 1], points[:, 0]], axis=1)
    if turn < 0:
        points[:, 0] = -points[:, 0]
    return points


@pytest.mark.parametrize("turn", [1, 2, 3, -1, -4])
def test_turned_and_mirrored_plans_break_the_same_rules(turn):
    plan, found = problem(), candidates()
    envelope = plan.envelope
    corners = _moved(envelope.outline, turn)
    shift = -corners.min(axis=0)
    corners += shift
    order = list(range(4))
    if turn < 0:  # counter-clockwise again, from the same corner on
        corners = np.roll(corners[::-1], 1, axis=0)
        order = [3, 2, 1, 0]
    other = compile_plan(
        plan.programme,
        Envelope(
            outline=tuple(map(tuple, corners.round(3))),
            open_walls=tuple(order.index(w) for w in envelope.open_walls),
            entrance_wall=None if envelope.entrance_wall is None else order.index(envelope.entrance_wall),
        ),
    )
    alone = [k for k in range(48) if (found["storey"][k, plan.numbers["rooms"] :] < 0).all()]
    assert len(alone) >= 8
    cells = found["cells"][alone][:, : plan.numbers["rooms"]]
    ends = _moved(cells.reshape(-1, 2) / 1000, turn) + shift
    ends = np.round(1000 * ends).astype(int).reshape(len(alone), -1, 2, 2)
    turned = np.concatenate([ends.min(axis=2), ends.max(axis=2)], axis=2)
    rules = [RULES.index(r) for r in RULES[: RULES.index("doors")]]
    before = judge_rectangles(plan, cells)["violation"][:, rules]
    after = judge_rectangles(other, turned)["violation"][:, rules]
    assert np.allclose(before, after, rtol=1e-4, atol=1e-5)


def test_a_plan_by_hand_is_valid_and_its_faults_are_seen():
    programme = Programme.from_graph(
        {
            "hall": ("entrance_hall", [4, 6, 12]),
            "living": ("living_kitchen", [20, 26, 34]),
            "bed": "bedroom",
            "bath": "bathroom",
        },
        [("hall", "living"), ("hall", "bed"), ("hall", "bath")],
    )
    plan = compile_plan(programme, Envelope.rectangle(9, 7, entrance_wall=3))
    # living room in the south; hall, bath and bedroom in the north
    cells = np.array(
        [[300, 3800, 4900, 5000], [300, 300, 8700, 3700], [5000, 3800, 8700, 6700], [300, 5100, 4900, 6700]]
    )
    judged = judge_rectangles(plan, cells[None])
    assert judged["status"][0] == 1, dict(zip(RULES, judged["violation"][0], strict=True))
    narrow = cells.copy()
    narrow[1, 3] -= 1  # the living room gives way by 1 mm: nothing shares its wall any more
    judged = judge_rectangles(plan, narrow[None])
    assert judged["status"][0] == 0
    assert judged["violation"][0, RULES.index("adjacency")] == pytest.approx(0.301, abs=1e-6)
