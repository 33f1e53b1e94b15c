"""Pareto fronts: dominance, hypervolume, and the front of a tiny problem against brute force."""

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout.pareto import non_dominated
from tests.layout.test_variables import box, scene


def dominated(values):
    """Which points some other one dominates, by definition."""
    no_worse = (values[:, None] <= values[None]).all(axis=2)
    better = (values[:, None] < values[None]).any(axis=2)
    return (no_worse & better).any(axis=0)


@pytest.mark.parametrize("seed", range(6))
def test_what_no_point_dominates_is_the_front(seed):
    values = np.random.default_rng(seed).integers(0, 12, size=(60, 2)).astype(float)
    front = non_dominated(values)
    assert {tuple(v) for v in values[front]} == {tuple(v) for v in values[~dominated(values)]}
    assert (np.diff(values[front, 0]) > 0).all() and (np.diff(values[front, 1]) < 0).all()


def test_points_that_are_no_numbers_are_left_out():
    assert non_dominated(np.array([[np.nan, 0.0], [1.0, 1.0], [1.0, 1.0]])).tolist() == [1]
    assert non_dominated(np.zeros((0, 2))).tolist() == []


@pytest.mark.parametrize("seed", range(4))
def test_hypervolume_is_the_dominated_area(seed):
    rng = np.random.default_rng(seed)
    values = rng.integers(0, 10, size=(12, 2)).astype(float)
    cells = np.stack(np.meshgrid(np.arange(9) + 0.5, np.arange(9) + 0.5), axis=-1).reshape(-1, 2)
    below = np.any(np.all(cells[:, None] > values[None], axis=2), axis=1)
    assert sw.hypervolume(values, (9.0, 9.0)) == pytest.approx(below.sum())


def test_hypervolume_grows_with_points_and_refuses_nonsense():
    assert sw.hypervolume([], (1.0, 1.0)) == 0.0 and sw.hypervolume([[2.0, 2.0]], (1.0, 1.0)) == 0.0
    few, more = [[0.5, 0.5]], [[0.5, 0.5], [0.2, 0.8]]
    assert sw.hypervolume(few, (1.0, 1.0)) < sw.hypervolume(more, (1.0, 1.0))
    for values, reference in (([[0.0, 1.0, 2.0]], (3.0, 3.0)), (few, (1.0, np.inf)), (few, (1.0,))):
        with pytest.raises(sw.InputError):
            sw.hypervolume(values, reference)


@pytest.fixture(scope="module")
def tiny():
    """One box that may stand anywhere around a block, and should be near to two places: a front with a kink."""
    block = box("block", (0.6, 1.6, 0.5), (2.0, 1.6), fixed=True)
    marks = [box("p", (0.1, 0.1, 0.1), (0.1, 2.9), fixed=True), box("q", (0.1, 0.1, 0.1), (3.9, 2.9), fixed=True)]
    room = scene([box("a", (0.4, 0.4, 0.5), yaw_domain=[0.0]), block, *marks])
    return room, [sw.ObjectiveTerm("flow", ("a", "p"))], [sw.ObjectiveTerm("flow", ("a", "q"))]


def test_the_front_of_a_tiny_problem_is_that_of_brute_force(tiny):
    room, first, second = tiny
    problem = sw.compile(room, device="cpu")
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(0.2, 3.8, 0.02), np.arange(0.2, 2.8, 0.02)))
    poses = np.repeat(problem.home, len(x), axis=0)
    poses[:, 0, 0], poses[:, 0, 1], poses[:, 0, 3] = x, y, 0.0
    poses = poses[problem.feasible(poses)]
    every = np.stack([sw.objective_of(room, terms, poses) for terms in (first, second)], axis=1)
    front = sw.pareto_front(room, first, second, weights=6, candidates=12, rounds=3, device="cpu")
    corner = every[non_dominated(every)].max(axis=0) + 0.2
    known = sw.hypervolume(every, corner)
    assert front.hypervolume(corner) == pytest.approx(known, rel=0.03)
    assert not dominated(front.values).any()
    for k in range(len(front.values)):
        assert sw.check(front.scene(k), walkable=False).valid
    measured = np.stack([sw.objective_of(room, terms, front.poses) for terms in (first, second)], axis=1)
    assert measured == pytest.approx(front.values, abs=1e-6)


def test_equal_seeds_give_equal_fronts(tiny):
    fronts = [sw.pareto_front(*tiny, weights=3, candidates=4, rounds=2, seed=7, device="cpu") for _ in range(2)]
    assert (fronts[0].values == fronts[1].values).all() and (fronts[0].poses == fronts[1].poses).all()


def test_where_nothing_is_valid_the_front_is_empty():
    room = scene([box("a", (2.0, 2.0, 0.5), fixed=True), box("b", (1.9, 1.9, 0.5))], (2.2, 2.2))
    net = [sw.ObjectiveTerm("flow", ("a", "b"))]
    front = sw.pareto_front(room, net, net, weights=2, candidates=2, rounds=2, device="cpu", steps=1)
    assert front.values.shape == (0, 2) and front.solution is None and front.poses.shape == (0, 2, 4)
    with pytest.raises(sw.InputError, match="k"):
        front.scene(0)


@pytest.mark.parametrize("change", [{"weights": 1}, {"rounds": 0}, {"candidates": True}, {"time_limit": -1.0}])
def test_wrong_arguments_are_refused(tiny, change):
    with pytest.raises(sw.InputError, match=next(iter(change))):
        sw.pareto_front(*tiny, **change)


def test_an_objective_without_terms_is_refused(tiny):
    with pytest.raises(sw.InputError, match="second"):
        sw.pareto_front(tiny[0], tiny[1], [])
