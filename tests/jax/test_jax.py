"""`sceneweaver.jax`: values and derivatives are those of the problem, under jit, vmap, grad and jacobians."""

from __future__ import annotations

import gc

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import sceneweaver as sw
import sceneweaver.jax as swj
from tests.layout.made import BOX, CUP, scene, table
from tests.layout.research import DEVICE, FEW, check_differences, poses_of, problem_of, rooms


@pytest.mark.parametrize("name", rooms(pytest.mark.slow))
def test_gradients_are_the_engines(name):
    problem, poses = problem_of(name), poses_of(name, 4)
    energy, gradient = problem.energy_and_grad(poses)
    one = jax.value_and_grad(lambda x: swj.energy(problem, x))
    for found in (jax.vmap(one)(poses), jax.jit(jax.vmap(one))(poses), swj.energy_and_grad(problem, poses)):
        np.testing.assert_allclose(found[0], energy, rtol=1e-6)
        np.testing.assert_allclose(found[1], gradient, rtol=1e-5, atol=1e-5)
    total = jax.grad(lambda x: jnp.sum(swj.energy(problem, x)))(jnp.asarray(poses))
    np.testing.assert_allclose(total, gradient, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("name", rooms(pytest.mark.slow, FEW[1:]))
def test_gradients_are_finite_differences(name):
    problem, layout = problem_of(name), poses_of(name, 1, seed=3)[0]
    slope = np.asarray(jax.jit(jax.grad(lambda x: swj.energy(problem, x)))(layout))
    check_differences(jax.jit(lambda x: swj.residuals(problem, x)), layout, slope, count=20, least=0.3)


def test_vmap_over_1024_candidates_is_the_batch():
    problem = problem_of("bedroom-small")
    poses = swj.sample(problem, jax.random.key(0), 1024)
    each = jax.jit(jax.vmap(lambda x: swj.energy(problem, x)))(poses)
    np.testing.assert_array_equal(each, problem.energy(np.asarray(poses)))
    twice = jax.vmap(jax.vmap(lambda x: swj.energy(problem, x)))(poses.reshape(32, 32, *poses.shape[1:]))
    np.testing.assert_array_equal(twice.reshape(-1), each)


def test_vmap_over_problems():
    problem = problem_of("bedroom-small", "dining-round")
    poses = swj.sample(problem, jax.random.key(1), 4)
    wanted, gradient = problem.energy_and_grad(np.asarray(poses))
    by_scene = poses.reshape(2, 4, *poses.shape[1:])
    slope = jax.vmap(lambda layouts, which: jax.vmap(jax.grad(lambda x: swj.energy(problem, x, which)))(layouts))
    np.testing.assert_array_equal(swj.energy(problem, poses), wanted)
    np.testing.assert_array_equal(swj.energy(problem, by_scene, jnp.arange(2)[:, None]).reshape(-1), wanted)
    np.testing.assert_allclose(slope(by_scene, jnp.arange(2)).reshape(gradient.shape), gradient, atol=1e-6)
    assert not gradient[:4, 11:].any()


@pytest.mark.parametrize("name", rooms(pytest.mark.slow, FEW[:1]))
def test_the_jacobian_of_the_residuals(name):
    problem, layout = problem_of(name), poses_of(name, 1)[0]
    if problem.items * layout.size > 100_000:
        pytest.skip("a dense jacobian of this room is large")
    backwards, forwards = (way(lambda x: swj.residuals(problem, x))(layout) for way in (jax.jacrev, jax.jacfwd))
    np.testing.assert_allclose(backwards, forwards, atol=1e-6)
    residual, slope = problem.residuals(layout[None])
    np.testing.assert_array_equal(swj.residuals(problem, layout), residual[0])
    wanted = np.zeros(backwards.shape, np.float32)
    for role in range(3):
        rows = np.flatnonzero(problem.item_objects[0, :, role] >= 0)
        np.add.at(wanted, (rows, problem.item_objects[0, rows, role]), slope[0, rows, role])
    np.testing.assert_allclose(backwards, wanted, atol=1e-6)
    half = jax.grad(lambda x: jnp.sum(swj.residuals(problem, x) ** 2) / 0.1)(layout)
    np.testing.assert_allclose(half, problem.energy_and_grad(layout[None])[1][0], rtol=1e-4, atol=1e-4)


def test_forwards_is_backwards():
    problem, layout = problem_of("dining-round"), jnp.asarray(poses_of("dining-round", 1)[0])
    along = jax.random.normal(jax.random.key(0), layout.shape)
    value, slope = jax.jvp(lambda x: swj.energy(problem, x), (layout,), (along,))
    np.testing.assert_allclose(slope, jnp.sum(jax.grad(lambda x: swj.energy(problem, x))(layout) * along), rtol=1e-5)
    assert value == swj.energy(problem, layout)


def test_a_problem_is_a_pytree_without_leaves():
    problem = problem_of("bedroom-small")
    assert jax.tree.leaves(problem) == []
    poses = swj.sample(problem, jax.random.key(0), 3)
    step = jax.jit(lambda state: {**state, "poses": state["poses"] - 0.01 * jax.grad(total)(state["poses"])})

    def total(x):
        return jnp.sum(swj.energy(problem, x))

    state = step({"problem": problem, "poses": poses})
    assert state["problem"] is problem and total(state["poses"]) < total(poses)


def test_the_verdict_and_the_nearest_feasible_layout():
    problem = problem_of("bedroom-small")
    poses = swj.sample(problem, jax.random.key(2), 6)
    nearest = jax.jit(swj.project)(problem, poses)
    np.testing.assert_array_equal(nearest, problem.project(np.asarray(poses)))
    np.testing.assert_array_equal(jax.jit(swj.feasible)(problem, nearest), problem.feasible(np.asarray(nearest)))
    assert swj.feasible(problem, nearest).all() and not swj.feasible(problem, poses).all()


def test_starts_follow_the_key():
    problem = problem_of("bedroom-small", "dining-round")
    draw = jax.jit(swj.sample, static_argnums=(0, 2))
    first = draw(problem, jax.random.key(3), 5)
    assert first.shape == (10, problem.objects, 4)
    np.testing.assert_array_equal(first, swj.sample(problem, jax.random.key(3), 5))
    assert not np.array_equal(first, draw(problem, jax.random.key(4), 5))


def test_carry_is_the_numpy_one():
    problem = sw.compile(scene([table(), CUP, BOX], []), device=DEVICE)
    poses = np.asarray(swj.sample(problem, jax.random.key(0), 4)) + np.float32(0.3)
    for like in (None, poses[::-1].copy()):
        np.testing.assert_allclose(swj.carry(problem, poses, like=like), problem.carry(poses, like=like), atol=1e-5)
    slope = jax.grad(lambda x: jnp.sum(swj.energy(problem, swj.carry(problem, x))))(jnp.asarray(poses))
    assert not slope[:, 1].any() and slope[:, 0].any()
    assert swj.free(problem).tolist() == problem.free[0].astype(float).tolist()


def test_a_descent_lowers_the_energy():
    """Ten lines of Adam, every step of all of them in one compiled loop."""
    problem = problem_of("bedroom-small")
    poses = swj.sample(problem, jax.random.key(0), 16)

    def step(carry, rate):
        x, m, v, n = carry
        _, g = swj.energy_and_grad(problem, x)
        g = g * swj.free(problem)
        m, v, n = 0.9 * m + 0.1 * g, 0.99 * v + 0.01 * g * g, n + 1
        x = x - rate * (m / (1 - 0.9**n)) / (jnp.sqrt(v / (1 - 0.99**n)) + 1e-6)
        return (swj.carry(problem, x), m, v, n), None

    begin = (poses, jnp.zeros_like(poses), jnp.zeros_like(poses), 0)
    (after, *_), _ = jax.jit(lambda state: jax.lax.scan(step, state, jnp.linspace(0.05, 0.001, 200)))(begin)
    before = swj.energy(problem, poses)
    assert (swj.energy(problem, after) < before).all()
    assert jnp.median(swj.energy(problem, after)) < 0.6 * jnp.median(before)


@pytest.mark.parametrize(
    ("poses", "which", "text"),
    [
        (jnp.zeros((2, 11, 3)), None, r"poses: an array of shape \(2, 11, 3\); poses are \[..., 11, 4\]"),
        (jnp.zeros(4), None, "poses: an array of shape"),
        (jnp.zeros((2, 11, 4), dtype=jnp.float16), None, "poses: numbers of type float16; poses are float32"),
        (jnp.zeros((2, 11, 4)), jnp.zeros(3, dtype=jnp.int32), r"which: an array of shape \(3,\)"),
        (jnp.zeros((2, 11, 4)), jnp.zeros(2), "which: numbers of type float32"),
    ],
)
def test_what_is_no_input(poses, which, text):
    with pytest.raises(sw.InputError, match=text) as found:
        jax.jit(lambda x: swj.energy(problem_of("bedroom-small"), x, which))(poses)
    assert "\n" not in str(found.value)


def test_what_is_no_problem():
    with pytest.raises(sw.InputError, match="problem: Scene is no Problem"):
        swj.energy(scene([BOX], []), jnp.zeros((1, 1, 4)))


def test_scenes_have_to_be_said():
    with pytest.raises(sw.InputError, match="which: left out"):
        swj.energy(problem_of("bedroom-small", "dining-round"), jnp.zeros((13, 4)))


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        (
            lambda problem: jax.grad(lambda x: swj.energy_and_grad(problem, x)[1].sum()),
            "energy_and_grad has no derivative",
        ),
        (
            lambda problem: jax.hessian(lambda x: swj.project(problem, x).sum()),
            "second derivatives of project",
        ),
        (lambda problem: jax.grad(lambda x: third(problem, x)), "third derivatives are not available"),
    ],
    ids=["gradient", "project", "third"],
)
def test_what_has_no_derivative_says_so(asked, says):
    problem = problem_of("bedroom-small")
    with pytest.raises(sw.InputError, match=says):
        asked(problem)(jnp.asarray(poses_of("bedroom-small", 1)[0]))


def third(problem, x):
    def penalty(y):
        return (jax.grad(lambda z: swj.energy(problem, z))(y) ** 2).sum()

    return (jax.grad(penalty)(x) ** 2).sum()


def test_the_verdict_is_a_constant_to_derivatives():
    problem, layout = problem_of("bedroom-small"), jnp.asarray(poses_of("bedroom-small", 1)[0])
    masked = jax.grad(lambda x: jnp.where(swj.feasible(problem, x), 0.0, swj.energy(problem, x)))(layout)
    np.testing.assert_array_equal(masked, jax.grad(lambda x: swj.energy(problem, x))(layout))


def test_a_compiled_function_keeps_its_problem():
    energy = jax.jit(swj.energy)
    poses = energy(sw.compile(scene([BOX], []), device=DEVICE), jnp.zeros((1, 1, 4)))
    gc.collect()
    assert np.isfinite(poses).all()


def test_vectors_of_what_may_change():
    """Back and forth; what is fixed has no part, what is carried goes along, and scenes may differ in size."""
    what = scene([table(), CUP, BOX], [])
    problem = sw.compile([what, scene([BOX], [])], device=DEVICE)
    poses = swj.sample(problem, jax.random.key(0), 2)
    vector = swj.ravel(problem, poses)
    assert vector.shape == (4, problem.free[0].sum()) and not vector[2:, problem.free[1].sum() :].any()
    np.testing.assert_allclose(vector[1], poses[1][problem.free[0]])
    mask = problem.mask[[0, 0, 1, 1]]
    np.testing.assert_allclose(swj.unravel(problem, vector, poses)[mask], poses[mask], atol=1e-6)
    moved = swj.unravel(problem, vector[0] + 0.5, poses[0], 0)
    np.testing.assert_allclose(
        moved,
        problem.carry(jnp.where(problem.free[0], poses[0] + 0.5, poses[0])[None], [0], like=poses[:1])[0],
        atol=1e-5,
    )
    slope = jax.grad(lambda v: swj.energy(problem, swj.unravel(problem, v, poses[0], 0), 0))(vector[0])
    assert slope.shape == vector[0].shape and np.isfinite(slope).all()
