"""Solvers and placers of others: what they are told is what the engine means, and each solves an easy problem."""

from __future__ import annotations

import dataclasses
import importlib
import importlib.util
import time
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from benchmarks.external import RIVALS
from benchmarks.external.bstar_tree import BStarTree
from benchmarks.external.flat import Flat, TimeUp
from benchmarks.external.holodeck_dfs import HolodeckDfs
from benchmarks.external.objectives import Lengths, nets_of, objective_of, slope
from benchmarks.external.one_by_one import Solving, keep_best
from benchmarks.external.quarter_turns import quarter_turns
from benchmarks.external.rectangles import holds, overlapping
from benchmarks.external.rejection import Rejection
from benchmarks.external.sequence_pair_plan import SequencePair
from sceneweaver import problems
from sceneweaver.layout import StepOptimizer
from tests.layout.made import scene, thing

EASY = "packing/n005-t60"
SOLVERS = {
    "cp-sat (or-tools)": "ortools",
    "milp (highs)": "scipy",
    "sequence pair": "numpy",
    "b*-tree": "numpy",
    "minimize (scipy)": "scipy",
    "dual annealing (scipy)": "scipy",
    "nlopt": "nlopt",
    "holodeck dfs": "numpy",
    "rejection": "numpy",
    "layoutvlm (torch)": "torch",
    "arena relations (torch)": "torch",
    "holodeck dfs + projection": "numpy",
    "layoutvlm (torch) + projection": "torch",
    "arena relations (torch) + projection": "torch",
}


def made(name: str):
    module, _, attribute = RIVALS[name].partition(":")
    return getattr(importlib.import_module(module), attribute)()


def begun(optimizer, problem, poses, key: int = 0):
    return optimizer.init(problem, wp.array(poses, dtype=wp.float32, device="cpu"), key)


def term(kind: str, *objects: str, weight: float = 1.0, **params):
    return SimpleNamespace(kind=kind, objects=objects, weight=weight, params=params)


# ---- the view --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["packing/n020-t50", "walls/n010-t55", "groups/n015-t50", "rooms/n014-t50-T", "bodies/n008-t50"]
)
def test_a_witness_is_in_order_in_the_view(name):
    case = problems.load(name)
    view = quarter_turns(case.compile("cpu"))
    witness = case.witness[None].astype(np.float64)
    xy, turns = view.spot(witness)
    np.testing.assert_allclose(view.placed(witness, xy, turns)[..., :2], witness[..., :2], atol=1e-6)
    assert view.left_out == 0 and not overlapping(view.apart, xy, turns, slack=2e-3).any()
    for wanted in view.relations:
        assert not wanted.hard or any(holds(choice, xy, turns, slack=2e-3)[0] for choice in wanted.choices)
    for body in range(len(view.bodies)):
        level = view.planes[:, :2] @ xy[0, body]
        assert (level >= view.bounds(body, int(turns[0, body])) - 2e-3).all()


@pytest.mark.parametrize("name", ["groups/n015-t50", "rooms/n014-t50-T"])
def test_what_the_view_calls_in_order_the_engine_calls_valid(name):
    """Layouts by rejection pass the view's tests alone; the engine judges them."""
    case = problems.load(name)
    problem, optimizer = case.compile("cpu"), Rejection(limit=3.0)
    state = begun(optimizer, problem, case.start("random", 4, seed=1))
    for _ in range(4):
        state = optimizer.step(state)
    view = quarter_turns(problem)
    xy, turns = view.spot(optimizer.best(state).astype(np.float64))
    fine = ~overlapping(view.apart, xy, turns, slack=6e-4).any(axis=1)
    for wanted in view.relations:
        fine &= np.any([holds(choice, xy, turns, slack=1e-4) for choice in wanted.choices], axis=0) | (not wanted.hard)
    valid = problem.feasible(optimizer.best(state))
    assert fine.sum() >= 2 and valid[fine].all()


def test_a_room_turned_out_of_the_axes_is_seen_along_its_walls():
    view = quarter_turns(problems.load("rooms/n014-t50-T").compile("cpu"))
    assert 0.05 < view.angle % (np.pi / 2) < np.pi / 2 - 0.05
    square = np.abs(view.planes[:, :2]).max(axis=1)
    assert np.isclose(square, 1.0, atol=1e-6).sum() >= 4


# ---- objectives ------------------------------------------------------------------------------------------------------


def test_lengths_are_those_of_plain_arithmetic():
    case = problems.load("packing/n020-t50")
    problem = case.compile("cpu")
    view, ids = quarter_turns(problem), [o.id for o in case.scene.objects]
    terms = [
        term("wire_length", *ids[:4], weight=2.0, pins=[[0.1, 0.0], [0.0, 0.2], [0.0, 0.0], [-0.1, 0.1]]),
        term("flow", *ids[4:6]),
        term("flow", *ids[6:8], weight=3.0, metric="manhattan"),
    ]
    poses = case.witness[None].astype(np.float64)
    expected, pins = 0.0, []
    for k, (dx, dy) in enumerate(terms[0].params["pins"]):
        x, y, _, yaw = poses[0, k]
        pins.append((x + np.cos(yaw) * dx - np.sin(yaw) * dy, y + np.sin(yaw) * dx + np.cos(yaw) * dy))
    expected += 2.0 * np.ptp(pins, axis=0).sum()
    expected += np.hypot(*(poses[0, 4, :2] - poses[0, 5, :2]))
    expected += 3.0 * np.abs(poses[0, 6, :2] - poses[0, 7, :2]).sum()
    xy, turns = view.spot(poses)
    nets = nets_of(problem, terms)
    np.testing.assert_allclose(objective_of(problem, terms, poses), expected, rtol=1e-6)
    np.testing.assert_allclose(Lengths(nets, view)(xy[0], turns[0]), expected, rtol=1e-5)  # it stands at quarter turns
    shaken = poses[0] + np.random.default_rng(0).normal(0, 0.2, poses[0].shape)
    _, gradient = slope(nets, view, shaken)
    for index in [(0, 0), (1, 3), (4, 1), (6, 0), (3, 3)]:
        up, down = shaken.copy(), shaken.copy()
        up[index] += 1e-6
        down[index] -= 1e-6
        change = (slope(nets, view, up)[0] - slope(nets, view, down)[0]) / 2e-6
        np.testing.assert_allclose(gradient[index], change, atol=1e-6)


def test_a_flat_problem_has_the_engines_gradient_with_what_is_carried():
    """The energy of float32 falls along the gradient at the rate that it says."""
    case = problems.load("bedrooms/n011-seed6")
    problem = case.compile("cpu")
    flat = Flat(problem, case.start("perturbed", 1, 0)[0], lambda: False, (), 1.0)
    value, gradient = flat(flat.start)
    step = 1e-3 / np.linalg.norm(gradient)
    change = flat.value(flat.start + step * gradient) - flat.value(flat.start - step * gradient)
    assert change == pytest.approx(2 * step * gradient @ gradient, rel=0.1) and flat.lowest <= value
    flat.until = lambda: True
    with pytest.raises(TimeUp):
        flat.value(flat.start)


# ---- packings --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", [BStarTree(), SequencePair()], ids=lambda m: type(m).__name__)
def test_packings_never_overlap_and_lose_no_block(method):
    rng = np.random.default_rng(0)
    packing = method.packing(12, rng)
    for _ in range(300):
        packing = packing.moved(rng)
        size = rng.uniform(0.2, 1.0, (2, 12))
        x, y = (np.array(v) for v in packing.pack(size[0].tolist(), size[1].tolist()))
        apart = (x[:, None] + size[0][:, None] <= x + 1e-9) | (y[:, None] + size[1][:, None] <= y + 1e-9)
        assert (apart | apart.T | np.eye(12, dtype=bool)).all() and min(x.min(), y.min()) >= 0


# ---- solvers ---------------------------------------------------------------------------------------------------------


def _easy(name: str):
    """A tight packing; for those that know nothing of doors, boxes in a room without any."""
    if "torch" in name:
        return sw.compile(scene([thing("one"), thing("two"), thing("three")], []), device="cpu")
    return problems.load(EASY).compile("cpu")


@pytest.mark.parametrize("name", SOLVERS)
def test_a_solver_solves_an_easy_problem(name):
    pytest.importorskip(SOLVERS[name])
    problem, optimizer = _easy(name), made(name)
    assert isinstance(optimizer, StepOptimizer)
    given = problem.sample(0, 4)
    state = begun(optimizer, problem, given)
    for _ in range(optimizer.steps or 4):
        state = optimizer.step(state)
    best = np.asarray(optimizer.best(state))
    assert best.shape == given.shape and problem.feasible(best).any()
    np.testing.assert_array_equal(best[..., 2], given[..., 2])


@pytest.mark.parametrize("name", ["cp-sat (or-tools)", "sequence pair", "b*-tree", "nlopt"])
def test_a_solver_that_is_told_an_objective_lowers_it(name):
    pytest.importorskip(SOLVERS[name])
    case = problems.load(EASY)
    ids, problem = [o.id for o in case.scene.objects], case.compile("cpu")
    terms = [term("wire_length", a, b) for a, b in zip(ids, ids[1:], strict=False)]
    optimizer = made(name).configure(terms, 2.0)
    state = begun(optimizer, problem, case.start("sample", 1, seed=0))
    state = optimizer.step(state)
    best = optimizer.best(state)
    assert problem.feasible(best).all()
    assert objective_of(problem, terms, best)[0] < objective_of(problem, terms, case.witness[None])[0]


@pytest.mark.parametrize("optimizer", [HolodeckDfs(), Rejection(), SequencePair(moves=200), BStarTree(moves=200)])
def test_equal_seeds_give_equal_layouts(optimizer):
    case = problems.load(EASY)
    problem, given = case.compile("cpu"), case.start("sample", 2, seed=0)
    first, second = (optimizer.step(begun(optimizer, problem, given, key=5)).poses for _ in range(2))
    np.testing.assert_array_equal(first, second)


@pytest.mark.parametrize(
    "name", ["cp-sat (or-tools)", "holodeck dfs", "rejection", "b*-tree", "dual annealing (scipy)"]
)
def test_a_step_ends_when_its_time_is_over(name):
    pytest.importorskip(SOLVERS[name])
    case = problems.load("packing/n020-t88")
    optimizer = dataclasses.replace(made(name), limit=0.2)
    state = begun(optimizer, case.compile("cpu"), case.start("sample", 1, seed=0))
    began = time.process_time()
    optimizer.step(state)
    assert time.process_time() - began < 2.0


def test_what_is_kept_never_gets_worse():
    case = problems.load(EASY)
    problem = case.compile("cpu")
    good, bad = case.witness[None].astype(np.float32), case.start("random", 1, seed=0)
    state = Solving(problem, good.copy(), good.copy(), 0)
    keep_best(state, 0, bad)
    np.testing.assert_array_equal(state.poses, good)
    keep_best(state, 0, np.full(good.shape, np.nan))
    np.testing.assert_array_equal(state.poses, good)
    state.poses = bad.copy()
    keep_best(state, 0, np.concatenate([bad, good]))
    assert problem.feasible(state.poses).all()


def test_settings_name_fields_and_have_the_default_among_them():
    for name in RIVALS:
        if "torch" in name and importlib.util.find_spec("torch") is None:
            continue
        optimizer = made(name)
        for field, values in getattr(optimizer, "SETTINGS", {}).items():
            assert len(values) > 1
            for value in values:
                assert getattr(dataclasses.replace(optimizer, **{field: value}), field) == value


def test_shared_area_is_that_of_polygons():
    torch = pytest.importorskip("torch")
    shapely = pytest.importorskip("shapely")
    from benchmarks.external.layoutvlm import shared_area

    rng = np.random.default_rng(0)
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * 0.5
    quads = []
    for _ in range(200):
        yaw, (x, y), size = rng.uniform(-3, 3), rng.uniform(-0.7, 0.7, 2), rng.uniform(0.2, 1.5, 2)
        turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
        quads.append(corners * size @ turn.T + (x, y))
    a, b = np.array(quads[:100]), np.array(quads[100:])
    expected = [shapely.Polygon(p).intersection(shapely.Polygon(q)).area for p, q in zip(a, b, strict=True)]
    x = torch.tensor(a, requires_grad=True)
    area = shared_area(x, torch.tensor(b))
    np.testing.assert_allclose(area.detach().numpy(), expected, atol=1e-6)
    area.sum().backward()
    assert torch.isfinite(x.grad).all()
