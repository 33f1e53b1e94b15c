"""The frozen zoo: every problem is what its card says."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import pickle

import numpy as np
import pytest

from sceneweaver import problems
from sceneweaver.problems import store
from sceneweaver.scene import InputError
from tests.oracle.check_scene import check as oracle
from tests.sizes import often

LARGE = 150  # objects
KNOWN = {  # relations that the independent checker defines
    *("against_wall", "side_against_wall", "front_against", "front_to_front", "leftright_to_leftright", "side_by_side"),
    *("back_to_back", "near", "distance", "facing", "aligned", "parallel", "centered_on", "in_corner", "at_window"),
}


def each(wanted: tuple[str, ...]) -> list:
    sizes = {name: row["objects"] for name, row in store.manifest().items()}
    return [pytest.param(name, marks=[pytest.mark.slow] if sizes[name] >= LARGE else []) for name in wanted]


def third(wanted: tuple[str, ...]) -> list:
    """One in three of those that are not large, of every family."""
    return often(wanted, [param.values[0] for param in each(wanted) if not param.marks][::3])


@pytest.mark.parametrize("name", third(problems.names()))
def test_a_problem_verifies(name):
    problems.verify(problems.load(name))


@pytest.mark.parametrize("name", each(problems.names(feasible=True)))
def test_the_independent_checker_finds_the_witness_valid(name):
    case = problems.load(name)
    assert case.witness is not None
    scene = case.layout(case.witness).to_json()
    scene["relations"] = [r for r in scene["relations"] if r["type"] in KNOWN]
    found = oracle(scene)
    assert found["valid"], {key: value for key, value in found.items() if value}


def test_there_are_enough_of_every_size_and_kind():
    rows = store.manifest()
    assert len(rows) >= 60 and {row["family"] for row in rows.values()} == set(problems.families())
    sizes = [row["objects"] for row in rows.values()]
    assert min(sizes) == 5 and max(sizes) == 500
    assert len(problems.names(feasible=False)) >= 8
    assert sum(path.stat().st_size for path in store.DATA.iterdir()) < 3_000_000


def test_names_are_sorted_by_family_then_size():
    keys = [(row["family"], row["objects"], name) for name, row in store.manifest().items()]
    assert keys == sorted(keys)
    assert problems.names("walls") == tuple(n for n in problems.names() if n.startswith("walls/"))
    assert set(problems.names(feasible=True)) | set(problems.names(feasible=False)) == set(problems.names())


def test_no_two_problems_are_alike():
    hashes = [row["hash"] for row in store.manifest().values()]
    assert len(set(hashes)) == len(hashes)


def test_a_hash_is_that_of_the_canonical_bytes_and_notices_a_millimetre():
    case = problems.load("packing/n005-t60")
    assert hashlib.sha256(problems.canonical(case)).hexdigest() == case.hash
    assert json.loads(problems.canonical(case))["name"] == case.name
    moved = np.array(case.witness) + np.float32([0.001, 0, 0, 0])
    with pytest.raises(InputError, match="its hash is"):
        problems.verify(dataclasses.replace(case, witness=moved))


def test_a_problem_that_was_compiled_goes_to_other_processes():
    case = problems.load("packing/n005-t60")
    first = case.compile("cpu")
    other = pickle.loads(pickle.dumps(case))
    assert other.hash == case.hash and other.compile("cpu") is not first
    assert case.compile("cpu") is first


def test_a_wrong_witness_is_noticed_even_with_a_hash_of_its_own():
    case = problems.load("packing/n005-t60")
    wrong = dataclasses.replace(case, name="mine", witness=case.start("random", 1, 3)[0])
    wrong = dataclasses.replace(wrong, hash=hashlib.sha256(problems.canonical(wrong)).hexdigest())
    with pytest.raises(InputError, match="the judge finds the witness not valid"):
        problems.verify(wrong)


@pytest.mark.parametrize("name", ["surfaces/n020-t60", "rooms/n014-t50-T", "infeasible/area-n010"])
def test_starts_are_bad_and_repeatable(name):
    case = problems.load(name)
    problem = case.compile("cpu")
    for start in case.starts:
        poses = case.start(start, 6, 5)
        assert poses.shape == (6, len(case.scene.objects), 4) and poses.dtype == np.float32
        assert np.array_equal(poses, case.start(start, 6, 5))
        assert not np.array_equal(poses, case.start(start, 6, 6))
        assert not problem.feasible(poses).any()


def test_perturbed_starts_are_near_the_witness_and_random_ones_are_not():
    case = problems.load("surfaces/n020-t60")
    floor = [i for i, o in enumerate(case.scene.objects) if o.support is None]
    near, far = (case.start(name, 200, 0)[:, floor, :2] - case.witness[floor, :2] for name in ("perturbed", "random"))
    assert near.std() == pytest.approx(0.3, rel=0.1) and far.std() > 1.0
    carried = next(i for i, o in enumerate(case.scene.objects) if o.support is not None)
    item = case.scene.objects[carried]
    below = case.scene.index(item.support.object)
    apart = [np.linalg.norm(p[:, carried, :2] - p[:, below, :2], axis=1) for p in (case.start("perturbed", 20, 0),)]
    known = np.linalg.norm(case.witness[carried, :2] - case.witness[below, :2])
    assert np.allclose(apart, known, atol=1e-5), "what stands on a thing goes along with it"


def test_a_problem_is_compiled_once_for_a_device():
    case = problems.load("packing/n005-t60")
    assert problems.load("packing/n005-t60") is case
    assert case.compile("cpu") is case.compile("cpu")
    with pytest.raises(InputError, match="device"):
        case.compile("tpu")


@pytest.mark.parametrize("name", [problems.names(family)[0] for family in problems.families()])
def test_a_card_says_what_is_known(name):
    case = problems.load(name)
    assert case.card.startswith(f"# {name}\n") and case.hash[:16] in case.card
    hard = sum(r.hard for r in case.scene.relations)
    assert (f"| relations | {hard} hard: " in case.card) == (hard > 0)
    assert ("No layout is valid" in case.card) == (not case.feasible)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: problems.load("packing/n005-t61"), "did you mean packing/n005-t60"),
        (lambda: problems.load("nothing like it"), "see problems.names"),
        (lambda: problems.names("boxes"), "family: 'boxes' is none of"),
        (lambda: problems.load("infeasible/area-n010").start("perturbed", 1, 0), "none of sample, random"),
        (lambda: problems.load("packing/n005-t60").start("random", 0, 0), "count: 0"),
        (lambda: problems.load("packing/n005-t60").start("random", 1, -1), "seed: -1"),
        (lambda: problems.load("packing/n005-t60").layout(np.zeros((4, 4))), "poses: shape"),
    ],
)
def test_bad_input_is_one_line(call, text):
    with pytest.raises(InputError, match=text) as error:
        call()
    assert "\n" not in str(error.value)
