"""`sceneweaver.torch`: values and derivatives are those of the problem. Skipped where there is no PyTorch.

Second derivatives are compared with differences of the engine's gradient over another step than the library's, along
movements of one object, and where two such steps agree: elsewhere there is a kink in between.
"""

from __future__ import annotations

import gc

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


NAME = "bedroom-small"


def moved(seed=5):
    """Poses [4, N, 4] of the room, a movement of one object of each, and what changes the gradient by, and where."""
    problem, poses = problem_of(NAME), poses_of(NAME, 4, seed=seed)
    along = np.zeros_like(poses)
    along[np.arange(4), [0, 1, 2, 3]] = np.random.default_rng(seed).normal(size=(4, 4))

    def gradient(x):
        return problem.energy_and_grad(x.astype(np.float32))[1].astype(np.float64)

    wanted, other = (
        (gradient(poses + step * along) - gradient(poses - step * along)) / (2 * step) for step in (5e-4, 2e-3)
    )
    return poses, along, wanted, np.abs(wanted - other) < 0.02 * (1 + np.abs(wanted))


def leaf(poses):
    return torch.tensor(poses, device=DEVICE, requires_grad=True)


def check_second(found, wanted, smooth):
    assert smooth.mean() > 0.8 and (np.abs(wanted)[smooth] > 1.0).sum() > 5
    np.testing.assert_allclose(found.detach().cpu().numpy()[smooth], wanted[smooth], rtol=0.05, atol=0.2)


def test_a_second_backward_is_the_change_of_the_gradient():
    poses, along, wanted, smooth = moved()
    x = leaf(poses)
    (gradient,) = torch.autograd.grad(swt.energy(problem_of(NAME), x).sum(), x, create_graph=True)
    (found,) = torch.autograd.grad((gradient * torch.tensor(along, device=DEVICE)).sum(), x)
    check_second(found, wanted, smooth)


def test_a_gradient_penalty_has_a_gradient_of_its_own():
    problem, x = problem_of(NAME), leaf(poses_of(NAME, 2))
    (slope,) = torch.autograd.grad(swt.energy(problem, x).sum(), x, create_graph=True)
    penalty = slope.square().sum()
    (found,) = torch.autograd.grad(penalty, x)
    step = -1e-3 * found / found.abs().amax((1, 2), keepdim=True)
    after = problem.energy_and_grad((x + step).detach().cpu().numpy())[1]
    assert found.abs().max() > 1.0 and np.square(after).sum() < penalty.item()


def test_residuals_have_the_same_second_derivative():
    poses, along, wanted, smooth = moved()
    x = leaf(poses)
    energy = swt.residuals(problem_of(NAME), x).square().sum() / 0.1
    (gradient,) = torch.autograd.grad(energy, x, create_graph=True)
    (found,) = torch.autograd.grad((gradient * torch.tensor(along, device=DEVICE)).sum(), x)
    check_second(found, wanted, smooth)


def test_a_third_derivative_says_that_there_is_none():
    x = leaf(poses_of(NAME, 1))
    value = swt.energy(problem_of(NAME), x).sum()
    for _ in range(2):
        (slope,) = torch.autograd.grad(value, x, create_graph=True)
        value = slope.square().sum()
    with pytest.raises(sw.InputError, match="first and second derivatives; a third"):
        torch.autograd.grad(value, x)


def test_torch_func_differentiates_and_maps():
    problem, poses = problem_of(NAME), poses_of(NAME, 4)
    wanted, x = problem.energy_and_grad(poses)[1], torch.tensor(poses, device=DEVICE)

    def energy(one):
        return swt.energy(problem, one)

    np.testing.assert_array_equal(torch.func.vmap(energy)(x).cpu(), problem.energy(poses))
    np.testing.assert_array_equal(torch.func.vmap(torch.func.grad(energy))(x).cpu(), wanted)
    _, along = torch.func.jvp(energy, (x,), (x,))
    np.testing.assert_allclose(along.cpu(), (wanted * poses).sum((1, 2)), rtol=1e-4, atol=1e-4)
    forwards = torch.func.jacfwd(lambda one: swt.residuals(problem, one))(x[0])
    np.testing.assert_allclose(
        forwards.cpu(), torch.func.jacrev(lambda one: swt.residuals(problem, one))(x[0]).cpu(), atol=1e-5
    )
    verdict = torch.func.vmap(lambda one: swt.feasible(problem, one))(x)
    np.testing.assert_array_equal(verdict.cpu(), problem.feasible(poses))


def test_a_hessian_of_torch_func():
    poses, along, wanted, smooth = moved()
    hessian = torch.func.vmap(torch.func.hessian(lambda one: swt.energy(problem_of(NAME), one)))
    found = torch.einsum("bncmd,bmd->bnc", hessian(torch.tensor(poses, device=DEVICE)), torch.tensor(along).to(DEVICE))
    check_second(found, wanted, smooth)


def test_torch_compile_takes_them_whole():
    problem, x = problem_of(NAME), leaf(poses_of(NAME, 4))
    for function in (lambda y: swt.energy(problem, y).sum(), lambda y: swt.residuals(problem, y).square().sum()):
        compiled = torch.compile(function, fullgraph=True, backend="aot_eager")
        (found,), (wanted,) = (torch.autograd.grad(f(x), x) for f in (compiled, function))
        torch.testing.assert_close(found, wanted, rtol=1e-6, atol=1e-6)
    verdict = torch.compile(lambda y: swt.feasible(problem, y), fullgraph=True, backend="aot_eager")
    assert torch.equal(verdict(x), swt.feasible(problem, x))


def test_float64_poses_have_a_gradient_in_float64():
    problem, poses = problem_of(NAME), poses_of(NAME, 2)
    x = leaf(poses.astype(np.float64))
    energy = swt.energy(problem, x)
    energy.sum().backward()
    assert energy.dtype == x.grad.dtype == torch.float64
    np.testing.assert_array_equal(x.grad.cpu(), problem.energy_and_grad(poses)[1])


def test_one_layout_and_any_leading_dimensions():
    problem, poses = problem_of(NAME), poses_of(NAME, 4)
    x = torch.tensor(poses, device=DEVICE)
    assert swt.energy(problem, x[0]).shape == ()
    np.testing.assert_array_equal(
        swt.residuals(problem, x.reshape(2, 2, *x.shape[1:])).reshape(4, -1).cpu(), problem.residuals(poses)[0]
    )


@pytest.mark.parametrize(
    ("poses", "which", "says"),
    [
        (torch.zeros(2, 11, 3), None, "poses: an array of shape"),
        (torch.zeros(2, 11, 4, dtype=torch.float16), None, "poses: numbers of type torch.float16"),
        (np.zeros((2, 11, 4), np.float32), None, "poses: ndarray is no tensor"),
        (torch.zeros(2, 11, 4), torch.zeros(2), "which: numbers of type torch.float32"),
        (torch.zeros(2, 11, 4), torch.zeros(3, dtype=torch.int32), "which: an array of shape"),
        (torch.zeros(2, 11, 4), [0, 1], "which: numbers from 0 to 1"),
    ],
)
def test_what_is_no_input(poses, which, says):
    given = poses.to(DEVICE) if isinstance(poses, torch.Tensor) else poses
    with pytest.raises(sw.InputError, match=says):
        swt.energy(problem_of(NAME), given, which)


def test_a_problem_has_to_be_there_for_its_second_derivative():
    problem = sw.compile(sw.Scene.example("bedroom"), device=DEVICE)
    x = leaf(problem.sample(0, 1))
    (slope,) = torch.autograd.grad(swt.energy(problem, x).sum(), x, create_graph=True)
    del problem
    gc.collect()
    with pytest.raises(sw.InputError, match="problem: it is gone"):
        torch.autograd.grad(slope.square().sum(), x)
