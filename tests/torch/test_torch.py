"""`sceneweaver.torch`: values and derivatives are those of the problem. Skipped where there is no PyTorch."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
import sceneweaver.torch as swt
from tests.layout.research import DEVICE, check_differences, poses_of, problem_of, rooms

torch = pytest.importorskip("torch")


@pytest.mark.parametrize("name", rooms(pytest.mark.slow))
def test_gradients_are_the_engines(name):
    problem, poses = problem_of(name), poses_of(name, 4)
    energy, gradient = problem.energy_and_grad(poses)
    x = torch.tensor(poses, device=DEVICE, requires_grad=True)
    found = swt.energy(problem, x)
    np.testing.assert_allclose(found.detach().cpu(), energy, rtol=1e-6)
    found.sum().backward()
    np.testing.assert_allclose(x.grad.cpu(), gradient, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("name", rooms(pytest.mark.slow))
def test_gradients_are_finite_differences(name):
    problem, layout = problem_of(name), poses_of(name, 1, seed=3)[0]
    x = torch.tensor(layout[None], device=DEVICE, requires_grad=True)
    swt.energy(problem, x).sum().backward()
    check_differences(lambda poses: problem.residuals(poses)[0], layout, x.grad[0].cpu().numpy(), count=20, least=0.3)


@pytest.mark.parametrize("name", rooms(pytest.mark.slow))
def test_residuals_pull_as_the_energy_does(name):
    problem, poses = problem_of(name), poses_of(name, 3)
    x = torch.tensor(poses, device=DEVICE, requires_grad=True)
    residual = swt.residuals(problem, x)
    np.testing.assert_array_equal(residual.detach().cpu(), problem.residuals(poses)[0])
    (residual.square().sum() / 0.1).backward()
    np.testing.assert_allclose(x.grad.cpu(), problem.energy_and_grad(poses)[1], rtol=1e-4, atol=1e-4)


def test_adam_of_torch_lowers_the_energy():
    problem = problem_of("bedroom-small")
    x = torch.tensor(problem.sample(0, 8), device=DEVICE, requires_grad=True)
    before, optimizer = swt.energy(problem, x).detach(), torch.optim.Adam([x], lr=0.02)
    for _ in range(100):
        optimizer.zero_grad()
        swt.energy(problem, x).sum().backward()
        x.grad *= swt.free(problem, DEVICE)
        optimizer.step()
    assert swt.energy(problem, x).sum() < 0.8 * before.sum()
    assert swt.feasible(problem, x).dtype == torch.bool


def test_several_scenes():
    problem = problem_of("bedroom-small", "dining-round")
    poses = problem.sample(0, 2)
    which = torch.tensor([0, 0, 1, 1], dtype=torch.int32, device=DEVICE)
    np.testing.assert_array_equal(
        swt.energy(problem, torch.tensor(poses, device=DEVICE), which).cpu(), problem.energy(poses)
    )


def test_what_is_no_input():
    with pytest.raises(sw.InputError, match="poses: an array of shape"):
        swt.energy(problem_of("bedroom-small"), torch.zeros(2, 11, 3))
    with pytest.raises(sw.InputError, match="poses: numbers of type float64"):
        swt.energy(problem_of("bedroom-small"), torch.zeros(2, 11, 4, dtype=torch.float64))
