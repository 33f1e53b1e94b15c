"""The kernels' energies of soft rows are what the exact checker measures, row by row, and doors are not led twice."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels.plan_verdict import judge_cells
from sceneweaver.plans import Profile, Programme, check_plan, envelope_for, solve_plans
from sceneweaver.plans.solve_problem import compile_plan, slope_of
from sceneweaver.plans.solve_run import new_state
from tests.sizes import share

ROWS = {
    "flat-2-bedrooms": (
        "bath-shape", "toilet-shape", "kitchen-shape", "service-shape", "hall-shape", "hall-plain", "hall-modest",
        "room-whole", "living-largest", "master-largest", "living-first", "two-sides", "aspect-good",
        "toilet-not-at-kitchen",
    ),
    "house-3-bedrooms": ("bedrooms-apart", "hall-plain", "bath-shape"),
}  # fmt: skip
"""Rows whose energy is the excess times a slope."""
BASE = Profile.named("base")
BARE = BASE.without(*(row.id for row in BASE.rows if not row.hard))


@cache
def solved(name: str):
    """Valid plans of a search without soft rows, which many of them break."""
    programme = Programme.example(name)
    return solve_plans(programme, envelope_for(programme, 1), candidates=24, seed=2, profile=BARE, device="cpu")


def energies(solution, profile: Profile) -> np.ndarray:
    """What the judging kernel gives the valid plans with other rows."""
    plan = compile_plan(solution.plan.programme, solution.plan.envelope, profile)
    which = solution.valid
    state = new_state(len(which), "cpu")
    cells = slice(0, plan.cells)
    state.frame.assign(solution.frames[which])
    for name, values in (("cells", solution.cells), ("storey", solution.storeys), ("owner", solution.owners)):
        array = getattr(state, name).numpy()
        array[:, cells] = values[which]
        getattr(state, name).assign(array)
    problem = plan.on_device("cpu")
    active = wp.array(np.arange(len(which)), dtype=wp.int32, device="cpu")
    wp.launch(judge_cells, len(which), [problem.ref, active], [state], device="cpu")
    assert (state.status.numpy() == 1).all()
    return state.energy.numpy().astype(float)


@pytest.mark.parametrize(("name", "rule"), share(((name, rule) for name, rules in ROWS.items() for rule in rules), 2))
def test_the_energy_of_a_row_is_its_excess(name: str, rule: str):
    solution = solved(name)
    row = BASE.rule(rule)
    alone = BARE.model_copy(update={"rows": (*BARE.rows, row)})
    rooms = {room.id for room in solution.plan.programme.rooms if "stairs" not in room.kind.roles}
    got = energies(solution, alone) - energies(solution, BARE)
    # rooms that no row bounds have a weak bound of their own on the ratio of their sides
    weak = compile_plan(solution.plan.programme, solution.plan.envelope, BARE).arrays["room_form"]
    broken = 0
    for k, energy in zip(solution.valid, got, strict=True):
        home = solution.home(int(k))
        report = check_plan(home, solution.plan.programme, alone)
        excess = sum(v.amount for v in report.soft if v.rule == rule and set(v.rooms) & rooms)
        expected = slope_of(row) * excess
        if row.measure == "aspect":
            aspects = {v.rooms[0]: v.amount + (row.most or 0) for v in report.soft if v.rule == rule}
            index = solution.plan.programme.index
            expected -= sum(weak[index[r], 1] * max(a - weak[index[r], 0], 0.0) for r, a in aspects.items())
        assert energy == pytest.approx(expected, rel=2e-3, abs=2e-3), (k, rule)
        broken += excess > 0
    if rule not in ("toilet-not-at-kitchen", "bedrooms-apart", "living-largest", "room-whole"):  # hard rows forbid most
        assert broken, f"no plan breaks {rule}: nothing was compared"


@pytest.mark.parametrize("name", ["house-3-bedrooms", "office-mixed"])
def test_rooms_that_lead_nowhere_have_the_door_that_was_asked_for(name: str):
    programme = Programme.example(name).with_storeys()
    solution = solve_plans(programme, envelope_for(programme, 1), candidates=16, seed=1, device="cpu")
    joined = {frozenset((x.a, x.b)) for x in programme.adjacencies if x.hard and x.kind in ("door", "open")}
    through = {room.id for room in programme.rooms if room.kind.transit == "all"}
    asked = {room for pair in joined for room in pair - through if pair & through}
    assert len(solution.valid) >= 6
    for k in solution.valid:
        for door in solution.home(int(k)).doors:
            if door.to is not None and {door.room, door.to} & asked:
                assert frozenset((door.room, door.to)) in joined


def test_ranked_plans_come_in_the_order_of_their_costs():
    solution = solved("flat-2-bedrooms")
    ranked = solution.ranked(12)
    costs = [report.cost for _, report in ranked]
    assert len(ranked) == 12 and costs == sorted(costs)
    homes = solution.distinct(12)
    assert all(home in homes for home, _ in ranked)
