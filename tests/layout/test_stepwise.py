"""Optimisers of one's own: how they are found, what they are given, what is taken from them."""

from __future__ import annotations

from importlib.metadata import EntryPoint

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.layout import BuiltIn, StepOptimizer, step_optimizer, stepwise
from sceneweaver.optimizers import OPTIMIZERS, Monitor, run, streams
from tests.layout.made import BOX, CUP, relation, scene, table, thing
from tests.layout.research import problem_of

FIXED = thing("fixed", fixed=True, pose=sw.Pose(position=(4.0, 3.0, 0.0)))
PAIR = scene([BOX, thing("other")], [relation("near", "box", "other", max=0.4)])


class Momentum:
    """Gradient descent with momentum; keeps the best of each layout."""

    def __init__(self, steps: int = 60) -> None:
        self.steps = steps
        self.seen: list[tuple[tuple[int, ...], int]] = []

    def init(self, problem, poses, key):
        x = poses.numpy()
        self.seen.append((x.shape, key))
        return problem, x, np.zeros_like(x), x, np.full(len(x), np.inf), x

    def step(self, state):
        problem, x, speed, best, lowest, given = state
        energy, gradient = problem.energy_and_grad(x)
        best = np.where((energy < lowest)[:, None, None], x, best)
        speed = 0.9 * speed - 0.01 * gradient * problem.free[problem.scene_of(len(x))]
        return problem, problem.carry(x + speed, like=given), speed, best, np.minimum(energy, lowest), given

    def best(self, state):
        return state[3]


class Jump(Momentum):
    """Says that everything is a metre further and turned, whatever may move."""

    def step(self, state):
        return state

    def best(self, state):
        return state[1] + np.float32(1.0)


def test_it_is_an_optimizer():
    assert isinstance(Momentum(), StepOptimizer) and not isinstance("adam", StepOptimizer)


def test_it_runs_through_refine():
    solution = sw.refine(PAIR, candidates=16, init="random", optimizer=Momentum(150), seed=5, device="cpu")
    again = sw.refine(PAIR, candidates=16, init="random", optimizer=Momentum(), steps=150, seed=5, device="cpu")
    np.testing.assert_array_equal(solution.poses, again.poses)
    started = sw.refine(PAIR, candidates=16, init="random", optimizer=Momentum(1), seed=5, device="cpu")
    assert (solution.status == 0).sum() > (started.status == 0).sum() and (solution.energy <= started.energy).all()
    assert sw.check(solution.best, walkable=False).valid
    problem = sw.compile(PAIR, device="cpu")
    np.testing.assert_array_equal(problem.energy(solution.poses), solution.energy)
    np.testing.assert_array_equal(problem.feasible(solution.poses), solution.status == 0)


BUDGETS = {"search": None, "projection": None, "adam": 99, "langevin": 70, "lbfgs": 50, "tempering": 60}
LADEN = scene([table(), CUP, BOX], [relation("near", "box", "table", max=0.2)])


@pytest.mark.parametrize("what", [PAIR, LADEN], ids=["pair", "laden"])
@pytest.mark.parametrize("start", ["drawn", "given"])
@pytest.mark.parametrize("name", BUDGETS)
def test_built_in_ones_step_as_well(name, start, what):
    """To the bit what the engine's own run makes of roots, whatever looks into it between two steps."""
    if (name, start) == ("tempering", "drawn"):
        pytest.skip("the engine's own run draws a start for each replica")
    own = {"candidates": 40, "seed": 4, "device": "cpu", "explain": False}
    init = "sample" if start == "drawn" else sw.compile(what, device="cpu").sample(9, 40)
    wanted = sw.refine(what, init=init, optimizer=name, steps=BUDGETS[name], **own)
    found = sw.refine(what, init=init, optimizer=Watched(name, BUDGETS[name], start), **own)
    roots = [i for i, obj in enumerate(what.objects) if obj.support is None]
    np.testing.assert_array_equal(found.poses[:, roots], wanted.poses[:, roots])
    np.testing.assert_array_equal(found.status, wanted.status)


class Watched(BuiltIn):
    """Looks at the best after every step."""

    def step(self, state):
        super().step(state)
        assert np.isfinite(self.best(state).numpy()).all()
        return state


@pytest.mark.slow
@pytest.mark.parametrize("name", BUDGETS)
def test_a_built_in_one_under_way(name):
    """What it calls best gets no worse, by the verdict and for descents by energy, its counts rise to the end, and what
    it ends at is the engine's to the bit."""
    problem, optimizer = problem_of("bedroom-small"), BuiltIn(name, BUDGETS[name])
    poses = problem.sample(0, 36)
    state = optimizer.init(problem, wp.array(poses, dtype=wp.vec4, device="cpu"), 0)
    valid, lowest, counts = [0], [problem.energy(poses).mean()], [(0, 0)]
    while not optimizer.done(state):
        state = optimizer.step(state)
        best = optimizer.best(state).numpy()
        valid.append(int(problem.feasible(best).sum()))
        lowest.append(problem.energy(best).mean())
        counts.append(optimizer.counts(state))
    assert len(counts) > 3 and (np.diff(counts, axis=0) >= 0).all() and counts[-1][1] == 36 * counts[-1][0]
    assert (np.diff(valid) >= 0).all() and lowest[-1] < lowest[0]
    assert name in ("search", "projection") or (np.diff(lowest) <= 1e-5).all()
    wanted = problem.batch(poses)
    wanted.state.rng.assign(streams(0, np.arange(36)))
    run(wanted, name, "drawn", BUDGETS[name], Monitor(36))
    np.testing.assert_array_equal(best, wanted.state.poses.numpy())
    assert isinstance(optimizer, StepOptimizer) and optimizer.step(state) is state, "a step behind the end is none"


def test_every_name_is_a_step_optimizer():
    for name in OPTIMIZERS:
        assert step_optimizer(name) == BuiltIn(name)
    own = Momentum()
    assert step_optimizer(own) is own
    with pytest.raises(sw.InputError, match='optimizer: "sgd" is not one of'):
        step_optimizer("sgd")


def test_it_begins_where_it_is_told():
    optimizer, given = Momentum(), sw.compile(PAIR, device="cpu").sample(3, 4)
    far = sw.refine(PAIR, init=given, optimizer=Jump(), device="cpu", explain=False).poses
    np.testing.assert_allclose(far[..., :2], given[..., :2] + 1.0, atol=1e-5)
    sw.refine(PAIR, init=given, optimizer=optimizer, seed=7, device="cpu", explain=False)
    assert optimizer.seen == [((4, 2, 4), 7)]


def test_what_may_not_move_stays_and_what_is_carried_goes_along():
    what = scene([table(), CUP, FIXED], [])
    before = sw.compile(what, device="cpu").home[0]
    after = sw.refine(what, candidates=2, init="current", optimizer=Jump(), device="cpu", explain=False).poses
    np.testing.assert_allclose(after[:, 2], np.broadcast_to(before[2], (2, 4)), atol=1e-6)
    np.testing.assert_allclose(after[:, 0, :2], np.broadcast_to(before[0, :2] + 1.0, (2, 2)), atol=1e-5)
    distance = np.linalg.norm(after[:, 1, :2] - after[:, 0, :2], axis=1)
    np.testing.assert_allclose(distance, np.linalg.norm(before[1, :2] - before[0, :2]), atol=0.3)
    np.testing.assert_allclose(after[:, 1, 2], 0.75, atol=1e-3)


def test_several_scenes_at_once():
    optimizer, scenes = Momentum(40), [PAIR, scene([BOX, thing("a"), thing("b")], [])]
    solutions = sw.refine_many(scenes, candidates=4, optimizer=optimizer, device="cpu")
    assert [s.poses.shape for s in solutions] == [(4, 2, 4), (4, 3, 4)]
    for what, solution in zip(scenes, solutions, strict=True):
        np.testing.assert_allclose(sw.compile(what, device="cpu").energy(solution.poses), solution.energy, atol=1e-6)
    assert {shape for shape, _ in optimizer.seen} == {(8, 3, 4)}


def test_time_runs_out_between_steps():
    solution = sw.refine(PAIR, candidates=2, optimizer=Momentum(10**9), time_limit=0.5, device="cpu", explain=False)
    assert solution.timed_out


@pytest.mark.parametrize("value", ["Momentum", "made"])
def test_it_joins_by_an_entry_point(monkeypatch, value):
    point = EntryPoint("momentum", f"{__name__}:{value}", stepwise.GROUP)
    monkeypatch.setattr(EntryPoint, "load", lambda self: {"Momentum": Momentum, "made": Momentum()}[value])
    monkeypatch.setattr(stepwise, "entry_points", lambda group: [point] if group == stepwise.GROUP else [])
    solution = sw.refine(PAIR, candidates=4, optimizer="momentum", steps=30, device="cpu", explain=False)
    assert np.isfinite(solution.energy).all()
    with pytest.raises(sw.InputError, match='"momenta" is not one of adam, .*momentum'):
        sw.refine(PAIR, optimizer="momenta", device="cpu")


class NoBest:
    def init(self, problem, poses, key): ...
    def step(self, state): ...


@pytest.mark.parametrize(
    ("optimizer", "text"),
    [
        (NoBest(), "optimizer: NoBest has no best"),
        (Momentum, "optimizer: type: give an instance"),
        (3, "optimizer: int has no init, step, best"),
        ("sgd", 'optimizer: "sgd" is not one of adam, langevin'),
    ],
)
def test_what_is_no_optimizer(optimizer, text):
    with pytest.raises(sw.InputError, match=text):
        sw.refine(PAIR, optimizer=optimizer, device="cpu")


@pytest.mark.parametrize("best", [np.zeros((3, 2, 4), np.float32), np.zeros((2, 4), np.float32), None])
def test_what_is_no_answer(best):
    class Wrong(Momentum):
        def best(self, state):
            return best

    with pytest.raises(sw.InputError, match="optimizer: best|poses:"):
        sw.refine(PAIR, candidates=2, optimizer=Wrong(1), device="cpu", explain=False)


def test_a_room_without_objects():
    assert sw.refine(scene([], []), candidates=2, optimizer=Momentum(2), device="cpu").best.objects == ()
