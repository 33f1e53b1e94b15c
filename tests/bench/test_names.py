"""How optimisers and problems of a comparison are named."""

from __future__ import annotations

import pickle
from importlib.metadata import EntryPoint

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver import problems
from sceneweaver.bench.entries import find_methods, find_tasks
from sceneweaver.layout import BuiltIn, stepwise
from tests.bench import optimizers
from tests.kernels.harness import ZOO
from tests.layout.made import BOX, CUP, relation, scene, table

SCENE = scene([table(), CUP, BOX], [relation("near", "box", "table", max=0.2)])


def test_optimisers_go_by_many_names():
    own = optimizers.Momentum()
    path = "tests.bench.optimizers"
    given = ["adam", f"mine={path}:Momentum", f"{path}:Endless", f"{path}:SOME", own]
    found = find_methods(given)
    assert [method.name for method in found] == ["adam", "mine", "Endless", "a", "b", "Momentum"]
    made = [method.make() for method in found]
    assert made[0] == BuiltIn("adam") and made[5] is own
    assert [type(each).__name__ for each in made[1:5]] == ["Momentum", "Endless", "Momentum", "Endless"]


def test_an_entry_point_is_a_name(monkeypatch):
    point = EntryPoint("momentum", "tests.bench.optimizers:Momentum", stepwise.GROUP)
    monkeypatch.setattr(stepwise, "entry_points", lambda group: [point] if group == stepwise.GROUP else [])
    (method,) = find_methods(["momentum"])
    assert type(method.make()).__name__ == "Momentum"


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ([], "give at least one"),
        (["sgd"], '"sgd" is not one of adam'),
        (["no.module:Here"], 'there is no "no.module:Here"'),
        (["tests.bench.optimizers:"], "there is no"),
        (["tests.bench.optimizers:NONE"], "is no mapping"),
        (["adam", "adam"], '"adam" is there twice'),
        ([3], "int has no init, step, best"),
    ],
)
def test_what_is_no_optimiser(given, text):
    with pytest.raises(sw.InputError, match=text):
        find_methods(given)


def test_scenes_are_problems():
    path = ZOO / "dining-round.json"
    named, own = find_tasks([str(path), SCENE])
    assert (named.name, named.family, own.name, own.best_energy) == ("dining-round", "scenes", SCENE.id, None)
    assert named.hash != own.hash and len(own.hash) == 64
    again = pickle.loads(pickle.dumps(own))
    assert again.hash == own.hash
    np.testing.assert_array_equal(again.start("sample", 3, 1), own.start("sample", 3, 1))


def test_the_zoo_goes_by_names_and_families():
    one, *family = find_tasks(["packing/n005-t60", "walls"])
    assert one.name == "packing/n005-t60"
    assert {task.family for task in family} == {"walls"} and len(family) == len(problems.names("walls"))
    assert [task.name for task in find_tasks(["all"])] == list(problems.names(feasible=True))
    assert [task.name for task in find_tasks(["infeasible"])] == list(problems.names("infeasible"))


@pytest.mark.parametrize("name", ["sample", "random", "perturbed"])
def test_starts_follow_the_seed(name):
    (task,) = find_tasks([SCENE])
    problem = task.compile("cpu")
    first, again, other = (task.start(name, 6, seed) for seed in (5, 5, 6))
    np.testing.assert_array_equal(first, again)
    assert first.shape == (6, 3, 4) and first.dtype == np.float32 and (first != other).any()
    roots = problem.free[0].any(axis=1)
    kept = np.broadcast_to(problem.home[0], first.shape)
    np.testing.assert_array_equal(first[:, roots][..., 2], kept[:, roots][..., 2])  # what may not move stays
    np.testing.assert_allclose(problem.carry(first, like=kept)[..., :3], first[..., :3], atol=1e-5)
    inside = (first >= problem.lower[0] - 1e-5) & (first <= problem.upper[0] + 1e-5)
    assert inside[:, roots].all() or name == "perturbed"


@pytest.mark.parametrize(
    ("given", "text"),
    [([], "give at least one"), (["nowhere"], 'there is no "nowhere"'), ([SCENE, SCENE], "is there twice")],
)
def test_what_is_no_problem(given, text):
    with pytest.raises(sw.InputError, match=text):
        find_tasks(given)
