"""Relations and terms of the user's own.

A set of residuals is compiled once: all tests share ``ring``, and stand in one file so that one worker runs them.
"""

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.verify.relations import JUDGES
from tests.layout.made import BED, BOX, relation, scene, thing
from tests.layout.research import KNEE


@wp.func
def ring(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + 1.0e-6)
    return wp.abs(d - p[0]) - p[1]


@wp.func
def endless(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.sqrt(wp.min(a[0], 0.0))


@wp.func
def short(a: wp.vec4):
    return a[0]


@wp.func
def to_the_east(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - a[0]


@wp.func
def stairs(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.floor(a[0] * 100.0)


ROOM = scene([BED, BOX], [relation("against_wall", "bed")])


def ring_holds(a, b, p):
    (ax, ay, _), (bx, by, _) = a.pose.position, b.pose.position
    return abs(np.hypot(ax - bx, ay - by) - p["radius"]) <= p["slack"]


@pytest.fixture
def defined():
    params = {"radius": 2.0, "slack": 0.1}
    sw.define_relation("made_by_test_ring", residual=ring, holds=ring_holds, params=params)
    yield
    sw.undefine_relation("made_by_test_ring")


def test_it_is_reached_judged_and_differentiated(defined):
    what = scene([BED, BOX], [relation("made_by_test_ring", "box", "bed", radius=1.7)])
    solution = sw.refine(what, candidates=16, init="random", device="cpu")
    assert np.mean(solution.status == 0) > 0.9
    for i in range(16):
        assert sw.check(solution.scene(i), walkable=False).valid == (solution.status[i] == 0)
    far = what.replace_poses({"box": sw.Pose(position=(4.5, 0.5, 0)), "bed": sw.Pose(position=(1.2, 3.0, 0))})
    assert not sw.check(far).valid
    adam = sw.refine(far, candidates=8, init="current", optimizer="adam", device="cpu")
    assert np.mean(adam.status == 0) > 0.5  # the gradient leads there


def test_engine_against_judge_is_told(defined, monkeypatch):
    """A predicate that is otherwise than at the samples: the engine calls the best layout valid, the judge does not."""
    what = scene([BED, BOX], [relation("made_by_test_ring", "box", "bed", radius=1.7)])
    assert sw.refine(what, candidates=8, device="cpu").explanation is None
    monkeypatch.setitem(JUDGES, "made_by_test_ring", lambda case: False)
    solution = sw.refine(what, candidates=8, device="cpu")
    assert (solution.status == 0).any() and not sw.check(solution.best).valid
    assert "Engine and judge disagree about box made_by_test_ring bed (radius 1.7)" in solution.explanation
    assert "its residual says that it holds, its `holds` that it does not" in solution.explanation


def test_built_in_relations_go_on_as_before(defined):
    what = scene([BED, BOX], [relation("near", "box", "bed", max=0.3)])
    with_user = sw.refine(what, candidates=4, device="cpu", seed=1)
    sw.undefine_relation("made_by_test_ring")
    try:
        without = sw.refine(what, candidates=4, device="cpu", seed=1)
    finally:
        sw.define_relation("made_by_test_ring", residual=ring, holds=ring_holds, params={"radius": 2.0, "slack": 0.1})
    np.testing.assert_allclose(with_user.poses, without.poses, atol=1e-5)


@pytest.mark.parametrize(
    ("residual", "says"), [(endless, "not finite"), (short, "does not compile"), (ring_holds, "wp.func")]
)
def test_a_wrong_residual_is_refused(residual, says):
    with pytest.raises(sw.InputError, match=says):
        sw.define_relation("made_by_test_wrong", residual=residual, holds=ring_holds)
    with pytest.raises(sw.InputError):
        scene([BED, BOX], [relation("made_by_test_wrong", "box", "bed")])


def test_names_and_params_are_checked():
    for options, says in (
        ({"name": "near"}, "there already"),
        ({"params": dict.fromkeys("abcde", 1.0)}, "at most 4"),
        ({"target": "wall"}, "target"),
        ({"scale": 0.0}, "scale"),
    ):
        name = options.pop("name", "made_by_test_other")
        with pytest.raises(sw.InputError, match=says):
            sw.define_relation(name, residual=ring, holds=ring_holds, **options)


def test_its_residuals_make_up_the_energy():
    """The sum of residuals, by kernels that are built anew, is the energy of those that are built anew as well."""
    sw.define_relation("on_ring", residual=ring, holds=ring_holds, params={"radius": 1.5, "slack": 0.1})
    try:
        what = scene([BOX, thing("other")], [relation("on_ring", "box", "other")])
        problem = sw.compile(what, device="cpu")
        poses = np.repeat(problem.home, 2, axis=0)
        poses[:, 0], poses[:, 1] = (1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 0.0, 0.0)
        poses[:, 1, 0] += (1.5, 2.1)
        terms = problem.terms(poses)
        np.testing.assert_allclose(terms.violation[:, 0], (-0.1, 0.5), atol=1e-3)
        np.testing.assert_allclose((terms.residual**2).sum(axis=1) / (2 * KNEE), problem.energy(poses), rtol=1e-5)
        assert terms.energy["relation"][1, 0] == pytest.approx(0.5 - KNEE / 2, abs=0.005)
    finally:
        sw.undefine_relation("on_ring")


# ---- terms


@pytest.fixture
def term():
    sw.define_term("at 2.5 m", residual=ring, subjects=["box"], targets=["bed"], params=[2.5, 0.0], weight=3.0)
    yield
    sw.undefine_term("at 2.5 m")


def distances(solution):
    return np.linalg.norm(solution.poses[:, 0, :2] - solution.poses[:, 1, :2], axis=1)


def test_valid_layouts_are_ranked_by_it_and_none_is_made_invalid(term):
    solution = sw.refine(ROOM, candidates=32, init="random", device="cpu")
    assert (solution.status == 0).all()
    assert abs(distances(solution)[solution.order[0]] - 2.5) < 0.1
    with_adam = sw.refine(ROOM, candidates=8, init="random", optimizer="adam", device="cpu")
    assert abs(np.median(distances(with_adam)) - 2.5) < 0.1
    assert solution.relations.shape[1] == 1 and sw.check(solution.scene(int(solution.order[0]))).valid


def test_its_energy_is_that_of_a_soft_relation_and_its_gradient_is_right(term):
    problem = sw.compile(ROOM, device="cpu")
    poses = problem.sample(0, 64)
    with_term = problem.energy(poses)
    energy, gradient = problem.energy_and_grad(poses)
    sw.undefine_term("at 2.5 m")
    try:
        without = sw.compile(ROOM, device="cpu").energy(poses)
    finally:
        sw.define_term("at 2.5 m", residual=ring, subjects=["box"], targets=["bed"], params=[2.5, 0.0], weight=3.0)
    missing = np.abs(2.5 - np.linalg.norm(poses[:, 0, :2] - poses[:, 1, :2], axis=1))
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
        sw.define_term("x", **{"residual": ring, "subjects": ["box"], **more})
    with pytest.raises(sw.InputError, match="unknown"):
        sw.undefine_term("x")


def test_a_name_is_used_once(term):
    with pytest.raises(sw.InputError, match="there already"):
        sw.define_term("at 2.5 m", residual=ring, subjects=["box"])


def test_the_check_of_gradients_alone():
    assert sw.check_gradient(ring) < 0.02 and sw.check_gradient(stairs, count=64, seed=3) > 0.3
    with pytest.raises(sw.InputError, match="residual: residual is not a wp.func"):
        sw.check_gradient(len)
