"""Terms of the user's own."""

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from tests.layout.made import BED, BOX, relation, scene, thing


@wp.func
def apart(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - wp.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + 1.0e-6)


@wp.func
def to_the_east(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - a[0]


@wp.func
def stairs(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.floor(a[0] * 100.0)


ROOM = scene([BED, BOX], [relation("against_wall", "bed")])


@pytest.fixture
def term():
    sw.define_term("apart", residual=apart, subjects=["box"], targets=["bed"], params=[2.5], weight=3.0)
    yield
    sw.undefine_term("apart")


def distances(solution):
    return np.linalg.norm(solution.poses[:, 0, :2] - solution.poses[:, 1, :2], axis=1)


def test_valid_layouts_are_ranked_by_it_and_none_is_made_invalid(term):
    solution = sw.refine(ROOM, candidates=32, init="random", device="cpu")
    assert (solution.status == 0).all()
    assert distances(solution)[solution.order[0]] > 2.4
    with_adam = sw.refine(ROOM, candidates=8, init="random", optimizer="adam", device="cpu")
    assert np.median(distances(with_adam)) > 2.4
    assert solution.relations.shape[1] == 1 and sw.check(solution.scene(int(solution.order[0]))).valid


def test_its_energy_is_that_of_a_soft_relation_and_its_gradient_is_right(term):
    problem = sw.compile(ROOM, device="cpu")
    poses = problem.sample(0, 64)
    with_term = problem.energy(poses)
    energy, gradient = problem.energy_and_grad(poses)
    sw.undefine_term("apart")
    try:
        without = sw.compile(ROOM, device="cpu").energy(poses)
    finally:
        sw.define_term("apart", residual=apart, subjects=["box"], targets=["bed"], params=[2.5], weight=3.0)
    missing = np.maximum(0.0, 2.5 - np.linalg.norm(poses[:, 0, :2] - poses[:, 1, :2], axis=1))
    added = with_term - without
    assert (added[missing < 1e-3] < 1e-4).all() and (added[missing > 0.05] > 0).all()
    assert np.corrcoef(added, missing)[0, 1] > 0.9
    h = 1e-3
    for axis in range(2):
        step = np.zeros_like(poses)
        step[:, 1, axis] = h
        slope = (problem.energy(poses + step) - problem.energy(poses - step)) / (2 * h)
        near = np.isclose(gradient[:, 1, axis], slope, atol=2e-2, rtol=2e-2)
        assert near.mean() > 0.9
    np.testing.assert_allclose(energy, with_term, rtol=1e-5, atol=1e-6)


@pytest.mark.slow  # compiles the kernels anew
def test_a_term_of_single_objects_counts_for_each_of_its_categories_and_no_others():
    sw.define_term("east", residual=to_the_east, subjects=["box"], params=[4.0])
    try:
        solution = sw.refine(ROOM, candidates=32, init="random", device="cpu")
        assert solution.poses[solution.order[0], 1, 0] > 3.9
        other = scene([BED, thing("chair")], [relation("against_wall", "bed")])
        one = sw.refine(other, candidates=4, device="cpu")
    finally:
        sw.undefine_term("east")
    np.testing.assert_allclose(one.poses, sw.refine(other, candidates=4, device="cpu").poses, atol=1e-5)


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"residual": stairs}, 'term "x": the residual is not smooth'),
        ({"residual": len}, 'term "x": residual is not a wp.func'),
        ({"params": [1.0] * 5}, "5 params"),
        ({"subjects": "box"}, "lists of categories"),
        ({"weight": 0.0}, "positive"),
    ],
)
def test_what_is_wrong_is_told(more, says):
    with pytest.raises(sw.InputError, match=says):
        sw.define_term("x", **{"residual": apart, "subjects": ["box"], **more})
    with pytest.raises(sw.InputError, match="unknown"):
        sw.undefine_term("x")


def test_a_name_is_used_once(term):
    with pytest.raises(sw.InputError, match="there already"):
        sw.define_term("apart", residual=apart, subjects=["box"])


def test_the_check_of_gradients_alone():
    assert sw.check_gradient(apart) < 0.02 and sw.check_gradient(stairs, count=64, seed=3) > 0.3
    with pytest.raises(sw.InputError, match="residual: residual is not a wp.func"):
        sw.check_gradient(len)
