"""`solve_plans`: what it calls valid the exact checker calls valid; seeds, limits, bad input, explanations."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.kernels.plan_tables import RULES
from sceneweaver.plans import Envelope, Programme, check_plan, envelope_for, programme_names, solve_plans
from sceneweaver.plans.solve_topology import neighbour_matrices, room_classes, topology_codes
from tests.plans.solved import small

ARRAYS = ("status", "energy", "codes", "cuts", "cells", "storeys", "owners", "doors", "windows", "violations")
CASES = [("flat-2-bedrooms", 0, "base"), ("house-3-bedrooms", 0, "base"), ("flat-1-bedroom", 0, "accessible")]


def solved(**options):
    programme, envelope = small()
    return solve_plans(programme, envelope, **{"candidates": 24, "device": "cpu"} | options)


@pytest.mark.parametrize(("name", "seed", "profile"), CASES)
def test_the_exact_checker_agrees(name, seed, profile):
    programme = Programme.example(name)
    envelope = envelope_for(programme, seed)
    solution = solve_plans(programme, envelope, candidates=48, rounds=4, device="cpu", profile=profile)
    assert len(solution.valid) >= 5
    for k in solution.valid.tolist():
        report = check_plan(solution.home(k), solution.plan.programme, profile, envelope=envelope)
        assert report.valid, f"candidate {k}: {report.violations[0].detail}"


@pytest.mark.slow
@pytest.mark.parametrize("name", programme_names())
def test_the_exact_checker_agrees_on_all_programmes(name):
    programme = Programme.example(name)
    envelope = envelope_for(programme, 3)
    solution = solve_plans(programme, envelope, candidates=64, rounds=6, device="cpu")
    for k in solution.valid.tolist():
        report = check_plan(solution.home(k), solution.plan.programme, envelope=envelope)
        assert report.valid, f"candidate {k}: {report.violations[0].detail}"


def test_what_is_not_valid_the_checker_does_not_call_valid_for_geometry():
    solution = solved(candidates=48, rounds=1, moves=60)
    geometric = [RULES.index(r) for r in ("area", "aspect", "adjacency", "reached")]
    looked = 0
    for k in np.flatnonzero(solution.status == 0):
        broken = solution.violations[k]
        complete = broken[RULES.index("doors")] == 0 and broken[RULES.index("shape")] == 0
        if complete and broken[geometric].any():
            home = solution.home(int(k))
            assert not check_plan(home, solution.plan.programme, envelope=solution.plan.envelope).valid
            looked += 1
    assert looked >= 3


def test_equal_seeds_give_equal_plans_and_others_do_not():
    one, two, other = solved(seed=5), solved(seed=5), solved(seed=6)
    for name in ARRAYS:
        assert np.array_equal(getattr(one, name), getattr(two, name)), name
    assert not np.array_equal(one.cuts, other.cuts)


def test_a_candidate_does_not_depend_on_how_many_there_are():
    few, many = solved(candidates=10), solved(candidates=90)
    for name in ARRAYS:
        assert np.array_equal(getattr(few, name), getattr(many, name)[:10]), name


def test_the_solution_says_what_it_holds():
    solution = solved()
    home = solution.best
    assert isinstance(home, Home)
    assert [room.id for room in home.rooms] == ["hall", "living", "bed", "bath"]
    assert Home.loads(home.dumps()) == home
    assert len(solution.outlines(int(solution.valid[0]))) == 4
    assert (np.diff(solution.energy[solution.valid]) >= 0).all()
    assert solution.explanation == "" and "plans valid" in repr(solution)
    codes = solution.topologies()
    assert (codes[solution.status == 0] == 0).all()
    homes = solution.distinct(50)
    assert len(homes) == len(set(codes[solution.valid].tolist()))


def test_a_time_limit_cuts_off_and_says_so():
    programme = Programme.example("flat-4-bedrooms")
    solution = solve_plans(programme, envelope_for(programme), candidates=4096, device="cpu", moves=500, time_limit=0.5)
    assert solution.timed_out and solution.elapsed < 20
    assert "time was up" in repr(solution)


def test_where_nothing_is_valid_it_says_which_rule_fails_and_by_how_much():
    programme, _ = small()
    solution = solve_plans(programme, Envelope.rectangle(5, 4), candidates=16, rounds=1, device="cpu")
    assert not len(solution.valid)
    assert (
        solution.explanation.startswith("no valid plan was found: ") and "fails most often, in " in solution.explanation
    )
    with pytest.raises(InputError, match="no valid plan was found"):
        _ = solution.best
    dark = solve_plans(programme, Envelope.rectangle(9, 7, closed=(0, 1, 2, 3)), candidates=16, rounds=1, device="cpu")
    assert "glazing fails most often, in 16 of 16" in dark.explanation


@pytest.mark.parametrize(
    ("options", "line"),
    [
        ({"candidates": 0}, "candidates is 0; give a whole number from 1"),
        ({"candidates": True}, "candidates is true"),
        ({"seed": -1}, "seed is -1"),
        ({"rounds": 0}, "rounds is 0"),
        ({"moves": 0}, "moves is 0"),
        ({"time_limit": 0}, "time_limit is 0; give seconds above 0"),
        ({"time_limit": "x"}, "time_limit is"),
        ({"device": "tpu"}, 'device: "tpu" is not there'),
        ({"profile": "bse"}, 'profile "bse" is not known'),
    ],
)
def test_bad_options(options, line):
    with pytest.raises(InputError) as caught:
        solved(**options)
    assert line in str(caught.value) and "\n" not in str(caught.value)


def test_bad_problems():
    programme, envelope = small()
    with pytest.raises(InputError, match="give a Programme"):
        solve_plans({}, envelope)  # pyright: ignore[reportArgumentType]
    with pytest.raises(InputError, match="give an Envelope"):
        solve_plans(programme, [(0, 0)])  # pyright: ignore[reportArgumentType]
    with pytest.raises(InputError, match="envelope has 2 storeys, the programme 1"):
        solve_plans(programme, Envelope.rectangle(9, 7, storeys=2))
    house = Programme.example("house-2-bedrooms")
    with pytest.raises(InputError, match="no place for the stairs"):
        solve_plans(house, Envelope.rectangle(3, 3, storeys=2))
    many = Programme(
        rooms=tuple({"id": f"r{k}", "type": "bedroom"} for k in range(40)),  # pyright: ignore[reportArgumentType]
        entrance="r0",
    )
    with pytest.raises(InputError, match="programme has 40 rooms"):
        solve_plans(many, Envelope.rectangle(30, 20))
    solution = solved(candidates=4)
    with pytest.raises(InputError, match="candidates are 0 to 3"):
        solution.home(4)


def test_topologies_do_not_depend_on_names_of_equal_rooms():
    programme = Programme.from_graph(
        {"hall": "entrance_hall", "a": "bedroom", "b": "bedroom", "c": "bathroom"},
        [("hall", "a"), ("hall", "b"), ("hall", "c")],
    )
    classes = room_classes(programme)
    assert classes.tolist() == [0, 1, 1, 3]
    rng = np.random.default_rng(0)
    graphs = rng.integers(0, 3, (60, 4, 4))
    graphs = np.triu(graphs, 1) + np.triu(graphs, 1).transpose(0, 2, 1)
    swapped = graphs[:, [0, 2, 1, 3]][:, :, [0, 2, 1, 3]]
    assert np.array_equal(topology_codes(graphs, classes), topology_codes(swapped, classes))
    other = graphs[:, [0, 3, 2, 1]][:, :, [0, 3, 2, 1]]
    differ = topology_codes(graphs, classes) != topology_codes(other, classes)
    same = (graphs == other).all(axis=(1, 2)) | (graphs == other[:, [0, 2, 1, 3]][:, :, [0, 2, 1, 3]]).all(axis=(1, 2))
    assert not differ[same].any() and differ[~same].mean() > 0.8


def test_neighbours_share_walls_and_doors():
    cells = np.array([[[0, 0, 10, 10], [12, 0, 20, 10], [0, 12, 10, 20]]])
    storey, owner = np.zeros((1, 3), dtype=int), np.array([[0, 1, 2]])
    doors = np.zeros((1, 2, 9), dtype=int)
    doors[0, 0, :2], doors[0, 1, :2] = (0, -1), (0, 2)
    found = neighbour_matrices(cells, storey, owner, doors, np.array([2]), 3, 2)
    assert found[0].tolist() == [[0, 1, 2], [1, 0, 0], [2, 0, 0]]


@pytest.mark.slow
def test_many_topologies():
    programme = Programme.example("flat-3-bedrooms")
    solution = solve_plans(programme, envelope_for(programme), candidates=1200, device="cpu")
    assert len(set(solution.topologies()[solution.valid].tolist())) >= 1000
