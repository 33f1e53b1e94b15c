"""`sceneweaver.torch` by parameters: values and derivatives are those of the problem. Skipped without PyTorch."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import sceneweaver as sw
import sceneweaver.torch as swt
from tests.layout.made import BED, BOX, OTHER, relation, scene
from tests.layout.research import DEVICE

torch = pytest.importorskip("torch")


@functools.cache
def small() -> tuple[sw.Problem, np.ndarray]:
    """A room of three things, and layouts of it in general position."""
    relations = [relation("against_wall", "bed"), relation("near", "box", "bed"), relation("facing", "other", "bed")]
    problem = sw.compile(scene([BED, BOX, OTHER], relations), device=DEVICE)
    noise = np.random.default_rng(0).normal(0.0, 0.05, (4, 3, 4)) * problem.free
    return problem, (problem.sample(3, 4) + noise).astype(np.float32)


def leaf(values, dtype=None):
    return torch.tensor(values, dtype=dtype or torch.float32, device=DEVICE, requires_grad=True)


@pytest.mark.parametrize("kind", ["size", "weight", "relation"])
@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_derivatives_by_poses_and_parameters(kind, dtype):
    problem, poses = small()
    x, values = leaf(poses), leaf(problem.parameters.values[kind], dtype)
    total = swt.energy(problem, x, parameters={kind: values}).sum()
    by_poses, by_values = torch.autograd.grad(total, (x, values), create_graph=True)
    np.testing.assert_allclose(by_poses.detach().cpu(), problem.energy_and_grad(poses)[1], atol=1e-5)
    wanted = problem.parameter_gradient(poses, of=kind)[kind].sum(0)
    np.testing.assert_allclose(by_values[0].detach().cpu(), wanted, atol=1e-5)
    assert by_values.dtype == dtype and np.abs(wanted).max() > 1e-3
    along = torch.tensor(np.random.default_rng(1).normal(size=poses.shape), dtype=torch.float32, device=DEVICE)
    (mixed,) = torch.autograd.grad((by_poses * along).sum(), values)
    product = problem.mixed_product(poses, along.cpu().numpy(), of=kind)[kind].sum(0)
    np.testing.assert_allclose(mixed[0].cpu(), product, atol=1e-4)


def test_residuals_pull_as_the_energy_does():
    problem, poses = small()
    x, size = leaf(poses), leaf(problem.parameters.values["size"])
    one = swt.energy(problem, x, parameters={"size": size}).sum()
    other = swt.residuals(problem, x, parameters={"size": size}).square().sum() / 0.1
    for a, b in zip(torch.autograd.grad(one, (x, size)), torch.autograd.grad(other, (x, size)), strict=True):
        np.testing.assert_allclose(a.cpu(), b.cpu(), atol=1e-4)


def test_a_gradient_penalty_by_parameters_has_a_gradient():
    """The penalty of slopes by sizes: less of it after a step against its own gradient."""
    problem, poses = small()

    def penalty(values):
        total = swt.energy(problem, torch.tensor(poses, device=DEVICE), parameters={"size": values}).sum()
        return torch.autograd.grad(total, values, create_graph=True)[0].square().sum()

    size = leaf(problem.parameters.values["size"])
    before = penalty(size)
    (found,) = torch.autograd.grad(before, size)
    after = penalty((size - 1e-3 * found / found.abs().max()).detach().requires_grad_())
    assert found.abs().max() > 0.1 and after < before


def test_a_projection_moves_with_the_room():
    problem, poses = small()
    x, walls = leaf(poses), leaf(problem.parameters.values["outline"])
    weight = np.random.default_rng(3).normal(size=poses.shape).astype(np.float32)
    nearest = swt.project(problem, x, parameters={"outline": walls})
    (nearest * torch.tensor(weight, device=DEVICE)).sum().backward()
    moves = problem.sensitivity(nearest.detach().cpu().numpy(), of="outline", anchors=poses)["outline"]
    np.testing.assert_allclose(walls.grad[0].cpu(), np.einsum("bnc,bncij->ij", weight, moves), atol=1e-4)
    np.testing.assert_array_equal(swt.project(problem, x).detach().cpu(), problem.project(poses))


def test_torch_func_takes_parameters():
    problem, poses = small()
    x, size = torch.tensor(poses, device=DEVICE), leaf(problem.parameters.values["size"]).detach()

    def total(values):
        return swt.energy(problem, x, parameters={"size": values}).sum()

    one = torch.func.grad(total)(size)
    both = torch.func.vmap(torch.func.grad(total))(torch.stack([size, size]))
    np.testing.assert_allclose(both[1].cpu(), one.cpu(), atol=1e-6)


@pytest.mark.parametrize(
    ("parameters", "text"),
    [({"colour": torch.zeros(1)}, "parameters: no kind 'colour'"), ({"weight": torch.zeros(2)}, "weight is an array")],
)
def test_what_are_no_parameters(parameters, text):
    problem, poses = small()
    with pytest.raises(sw.InputError, match=text):
        swt.energy(problem, torch.tensor(poses, device=DEVICE), parameters=parameters)
