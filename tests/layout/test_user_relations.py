"""Relations of the user's own."""

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from tests.layout.made import BED, BOX, relation, scene


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
