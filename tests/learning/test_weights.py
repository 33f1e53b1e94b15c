"""Weights are learned from poses alone: forces against energies, known balances, planted weights, bad input."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from benchmarks.planted_weights import arranged, cosine, forgotten, planted, wished
from sceneweaver.learning.forces import Forces, forces_of
from sceneweaver.learning.weights import _at_rest
from tests.layout.made import relation, scene, thing

STEP = 1.0e-3  # [m], [rad]


def kind(rel):
    return rel.type


def near(weight: float, a: str, b: str, most: float = 0.1) -> sw.Relation:
    return sw.Relation(type="near", subject=a, target=b, params={"max": most}, hard=False, weight=weight)


def far(weight: float, a: str, b: str, least: float = 3.0) -> sw.Relation:
    params = {"min": least, "max": 9.0}
    return sw.Relation(type="distance", subject=a, target=b, params=params, hard=False, weight=weight)


def put(given: sw.Scene, **places: tuple[float, float, float]) -> sw.Scene:
    """The scene with things where they are said to be (x, y, yaw)."""
    return given.replace_poses({name: sw.Pose.from_yaw(x, y, 0.0, yaw) for name, (x, y, yaw) in places.items()})


TRIO = scene(
    [thing("a", (0.5, 0.6, 0.8)), thing("b", (0.6, 0.4, 0.8)), thing("c", (0.4, 0.4, 0.4))],
    [near(2.0, "a", "b"), far(0.5, "a", "c"), near(1.0, "b", "c")],
)
TRIO = put(TRIO, a=(1.0, 2.0, 0.3), b=(3.0, 2.2, -0.4), c=(2.0, 3.2, 1.0))


def test_forces_are_differences_of_the_energy_at_a_weight_of_one():
    """Against central differences of the energy of a scene that has the relations of one kind alone."""
    found = forces_of(TRIO, ["distance", "near"], kind, device="cpu")
    for k, name in enumerate(("distance", "near")):
        mine = tuple(r.model_copy(update={"weight": 1.0}) for r in TRIO.relations if r.type == name)
        problem = sw.compile(TRIO.model_copy(update={"relations": mine}), device="cpu")
        home, rows = problem.home[0], np.argwhere(problem.free[0])
        sizes = np.array([o.size for o in TRIO.objects])
        arms = 0.15 * np.linalg.norm(sizes[:, :2], axis=1) + 0.05
        poses = np.repeat(home[None], 2 * len(rows), axis=0)
        for n, (obj, c) in enumerate(rows):
            poses[2 * n, obj, c] += STEP
            poses[2 * n + 1, obj, c] -= STEP
        energy = problem.energy(poses).astype(float)
        slope = (energy[::2] - energy[1::2]) / (2 * STEP)
        slope /= np.where(rows[:, 1] == 3, arms[rows[:, 0]], 1.0)
        np.testing.assert_allclose(found.soft[:, k], slope, atol=2e-3)


def test_what_is_carried_pulls_at_what_carries_it():
    top = [(-0.3, -0.4), (0.3, -0.4), (0.3, 0.4), (-0.3, 0.4)]
    desk = thing("desk", (0.6, 0.8, 0.7), surfaces=(sw.scene.Surface(name="top", polygon=tuple(top), z=0.7),))
    on = sw.scene.Support(object="desk", surface="top")
    lamp = thing("lamp", (0.1, 0.1, 0.3), mount="surface", support=on, pose=sw.Pose(position=(1.2, 1.3, 0.7)))
    given = put(
        scene([desk, lamp, thing("chair")], [near(1.0, "lamp", "chair")]), desk=(1.0, 1.0, 0.0), chair=(3, 3, 0)
    )
    found = forces_of(given, ["near"], kind, device="cpu")
    pulled = found.soft[found.objects == 0, 0]
    assert (np.abs(pulled) > 0.01).all()  # along both axes, and about its middle
    assert 1 not in found.objects


def test_hard_rows_that_touch_are_found_with_their_side():
    given = put(scene([thing("a", (0.5, 0.5, 0.5)), thing("b", (0.5, 0.5, 0.5))], [near(1.0, "a", "b")]),
                a=(2.0, 2.0, 0.0), b=(2.503, 2.0, 0.0))  # fmt: skip
    touching = forces_of(given, ["near"], kind, device="cpu").hard
    apart = forces_of(put(given, b=(3.5, 2.0, 0.0)), ["near"], kind, device="cpu").hard
    assert touching.shape[1] >= 1 and apart.shape[1] == 0
    x = touching[:, np.abs(touching[0]).argmax()]
    assert x[0] > 0.3 and x[3] < -0.3  # a further right and b further left is worse


def balance(pulls, objects=None, hard=None) -> Forces:
    pulls = np.array(pulls, dtype=float)
    walls = np.zeros((len(pulls), 0)) if hard is None else np.array(hard, dtype=float)
    return Forces(pulls, walls, np.arange(len(pulls)) if objects is None else np.array(objects))


def test_two_kinds_in_balance_have_the_inverse_of_their_slopes():
    shares, left = _at_rest([balance([[1.0, -3.0]]), balance([[-2.0, 6.0]])])
    np.testing.assert_allclose(shares, [0.75, 0.25], atol=1e-5)
    assert left < 1e-5


def test_a_wall_takes_up_what_pushes_into_it_and_nothing_else():
    into = balance([[-5.0, 1.0], [1.0, -2.0]], hard=[[1.0], [0.0]])
    shares, left = _at_rest([into])
    np.testing.assert_allclose(shares, [2 / 3, 1 / 3], atol=1e-4)  # the first row is the wall's business
    assert left < 1e-4
    out = balance([[5.0, -1.0], [1.0, -2.0]], hard=[[1.0], [0.0]])  # no wall pulls
    assert _at_rest([out])[1] > 0.1


def test_a_room_that_is_wrong_does_not_spoil_the_others():
    shares, _ = _at_rest([*[balance([[1.0, -3.0]])] * 9, balance([[3.0, -1.0]])])
    np.testing.assert_allclose(shares, [0.75, 0.25], atol=0.03)


@pytest.fixture(scope="module")
def rooms() -> list[sw.Scene]:
    return [forgotten(arranged(wished(700 + k, planted(7)))) for k in range(4)]


def test_planted_weights_are_found_again(rooms):
    weights = planted(7)
    learned = sw.learn_weights(rooms)
    assert cosine(learned.weights, weights) > 0.95 > cosine(dict.fromkeys(weights, 1.0), weights)
    assert learned.left < 0.3 and learned.rooms == 4 and learned.silent == ()
    assert np.mean(list(learned.weights.values())) == pytest.approx(1.0)


def test_equal_rooms_give_equal_weights_whatever_weights_they_have(rooms):
    rooms = rooms[:2]
    learned = sw.learn_weights(rooms)
    assert sw.learn_weights(rooms) == learned
    heavy = [
        r.model_copy(update={"relations": tuple(x.model_copy(update={"weight": 7.0}) for x in r.relations)})
        for r in rooms
    ]
    assert cosine(sw.learn_weights(heavy).weights, learned.weights) > 0.9999


def test_learned_weights_are_put_into_scenes():
    learned = sw.LearnedWeights({"near": 1.5, "distance": 0.0}, {}, (), 0.0, 1)
    kept = learned.applied(TRIO.model_copy(update={"relations": (*TRIO.relations, relation("in_corner", "c"))}))
    assert [r.weight for r in kept.relations] == [1.5, 0.5, 1.5, 1.0]  # one that counts for nothing stays as it is


def test_kinds_that_pull_at_nothing_are_named():
    held = put(scene([thing("a"), thing("b"), thing("c")], [near(1, "a", "b", 9.0), far(1, "a", "c")]),
               a=(1, 1, 0), b=(2, 1, 0), c=(2, 3, 0))  # fmt: skip
    learned = sw.learn_weights([held])
    assert learned.silent == ("near",) and list(learned.weights) == ["distance"]


@pytest.mark.parametrize(
    ("rooms", "options", "message"),
    [
        ([], {}, "scenes: there is none"),
        ([scene([thing("a")], [])], {}, "no soft relation or term"),
        ([TRIO], {"reach": 0.0}, "reach: 0.0 is not a length"),
        ([TRIO], {"kind": lambda r: None}, "no soft relation or term"),
    ],
)
def test_bad_input_is_one_line(rooms, options, message):
    with pytest.raises(sw.InputError, match=message):
        sw.learn_weights(rooms, **options)


def test_no_room_tells_anything_where_all_wishes_hold():
    held = put(scene([thing("a"), thing("b")], [near(1, "a", "b", 9.0)]), a=(1, 1, 0), b=(2, 1, 0))
    with pytest.raises(sw.InputError, match="all soft relations hold"):
        sw.learn_weights([held])
