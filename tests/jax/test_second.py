"""Second derivatives in JAX, and derivatives by parameters, beside differences and the methods of `Problem`."""

from __future__ import annotations

import functools

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import sceneweaver as sw
import sceneweaver.jax as swj
from tests.layout.made import BED, BOX, OTHER, relation, scene
from tests.layout.research import DEVICE


@functools.cache
def small() -> tuple[sw.Problem, np.ndarray]:
    """A room of three things, and layouts of it in general position."""
    relations = [relation("against_wall", "bed"), relation("near", "box", "bed"), relation("facing", "other", "bed")]
    problem = sw.compile(scene([BED, BOX, OTHER], relations), device=DEVICE)
    noise = np.random.default_rng(0).normal(0.0, 0.05, (4, 3, 4)) * problem.free
    return problem, (problem.sample(3, 4) + noise).astype(np.float32)


def of(kind: str):
    problem, _ = small()
    return jnp.asarray(problem.parameters.values[kind], dtype=jnp.float32)


def test_a_double_backward_is_the_change_of_the_gradient():
    """A gradient penalty's own gradient is 2 H g; H g is also a difference of the gradient along g."""
    problem, poses = small()
    layout = jnp.asarray(poses[3:])
    slope = jax.grad(lambda x: swj.energy(problem, x).sum())
    found = jax.jit(jax.grad(lambda x: (slope(x) ** 2).sum()))(layout)
    g = np.asarray(slope(layout))
    step = 2e-3 / np.abs(g).max()
    ahead, behind = (np.asarray(slope(layout + s * step * g)) for s in (1, -1))
    np.testing.assert_allclose(found, (ahead - behind) / step, rtol=2e-2, atol=2e-2 * np.abs(found).max())
    assert np.abs(found).max() > 0.1


@pytest.mark.slow
def test_hessians_are_symmetric_and_agree_with_products():
    problem, poses = small()
    hessian = jax.hessian(lambda x: swj.energy(problem, x))(jnp.asarray(poses[3]))
    size = float(jnp.abs(hessian).max())
    assert size > 1.0 and jnp.abs(hessian - hessian.transpose(2, 3, 0, 1)).max() < 1e-3 * size
    along = np.random.default_rng(1).normal(size=poses[3:].shape).astype(np.float32)
    product = problem.hessian_product(poses[3:], along)[0]
    np.testing.assert_allclose(np.einsum("abcd,cd->ab", hessian, along[0]), product, atol=1e-2 * size)


@pytest.mark.slow
def test_second_derivatives_of_residuals_do_not_depend_on_the_order():
    problem, poses = small()
    residual, layout = (lambda x: swj.residuals(problem, x)), jnp.asarray(poses[0])
    first = jax.jacfwd(jax.jacrev(residual))(layout)
    assert jnp.abs(first).max() > 1.0
    for other in (jax.jacrev(jax.jacrev(residual)), jax.jacrev(jax.jacfwd(residual))):
        np.testing.assert_allclose(other(layout), first, atol=2e-3 * float(jnp.abs(first).max()))


@pytest.mark.parametrize(
    "kind", ["size", *(pytest.param(k, marks=pytest.mark.slow) for k in ("weight", "relation", "outline"))]
)
def test_derivatives_by_parameters(kind):
    problem, poses = small()

    def energy(values, x):
        return swj.energy(problem, x, parameters={kind: values}).sum()

    x, values = jnp.asarray(poses), of(kind)
    slope = jax.jit(jax.grad(energy))(values, x)
    wanted = problem.parameter_gradient(poses, of=kind)[kind].sum(0)
    np.testing.assert_allclose(slope[0], wanted, atol=1e-5)
    assert np.abs(wanted).max() > 1e-3
    squares = jax.grad(lambda v: (swj.residuals(problem, x, parameters={kind: v}) ** 2).sum() / 0.1)(values)
    np.testing.assert_allclose(squares, slope, atol=1e-5)
    along = jnp.asarray(np.random.default_rng(2).normal(size=poses.shape), dtype=jnp.float32)
    mixed = jax.grad(lambda v: (jax.grad(energy, argnums=1)(v, x) * along).sum())(values)
    product = problem.mixed_product(poses, along, of=kind)[kind].sum(0)
    np.testing.assert_allclose(mixed[0], product, atol=1e-4)
    several = jax.vmap(lambda v: jax.grad(energy)(v, x))(jnp.stack([values, 1.01 * values]))
    np.testing.assert_allclose(several[0], slope, atol=1e-5)


@pytest.mark.slow
def test_residuals_forwards_and_backwards_by_parameters():
    problem, poses = small()

    def total(v):
        return (swj.residuals(problem, jnp.asarray(poses), parameters={"size": v}) ** 2).sum()

    along = jnp.ones_like(of("size"))
    _, forwards = jax.jvp(total, (of("size"),), (along,))
    np.testing.assert_allclose(forwards, (jax.grad(total)(of("size")) * along).sum(), rtol=1e-4)


def test_a_projection_moves_with_the_room():
    problem, poses = small()
    weight = jnp.asarray(np.random.default_rng(3).normal(size=poses.shape), dtype=jnp.float32)

    def total(x, walls):
        return (swj.project(problem, x, parameters={"outline": walls}) * weight).sum()

    by_poses, by_walls = jax.jit(jax.grad(total, argnums=(0, 1)))(jnp.asarray(poses), of("outline"))
    solved = problem.project(poses)
    moves = problem.sensitivity(solved, of="outline", anchors=poses)["outline"]
    np.testing.assert_allclose(by_walls[0], np.einsum("bnc,bncij->ij", weight, moves), atol=1e-4)
    assert np.abs(by_walls).max() > 0.1 and by_poses.shape == poses.shape


@pytest.mark.parametrize(
    ("parameters", "text"),
    [({"colour": 1.0}, "parameters: no kind 'colour'"), ({"weight": jnp.zeros(2)}, r"parameters: weight is an array")],
)
def test_what_are_no_parameters(parameters, text):
    problem, poses = small()
    with pytest.raises(sw.InputError, match=text):
        swj.energy(problem, jnp.asarray(poses), parameters=parameters)
