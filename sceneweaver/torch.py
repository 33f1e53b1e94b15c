"""A `sceneweaver.Problem` as differentiable functions for PyTorch; ``import sceneweaver.torch``.

Poses are tensors [B, N, 4] float32 on the problem's device. The engine's kernels run on the tensors' own memory.
PyTorch is not installed along with sceneweaver: ``pip install torch``.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from sceneweaver.layout import Problem
from sceneweaver.scene import MissingDependencyError

__all__ = ["energy", "feasible", "free", "residuals"]

Tensor = Any


def energy(problem: Problem, poses: Tensor, which: Tensor | None = None) -> Tensor:
    """Energy [B] float32 [m] of layouts: `Problem.energy`, differentiable once by the poses.

    Args:
        problem: from `sceneweaver.compile`.
        poses: [B, N, 4] float32: x, y, z [m] and yaw [rad].
        which: the scene [B] of each layout; left out, equal parts, scene after scene.

    Raises:
        InputError: another shape, type of number or device.
        MissingDependencyError: PyTorch is not installed.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.energy(problem, x).sum().backward()
        >>> x.grad.shape == x.shape
        True
    """
    return _functions()[0].apply(poses, problem, which)


def residuals(problem: Problem, poses: Tensor, which: Tensor | None = None) -> Tensor:
    """Residuals [B, M] in metres: `Problem.residuals`, differentiable once by the poses. Errors as for `energy`.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> r = swt.residuals(problem, x)
        >>> torch.allclose((r * r).sum(-1) / 0.1, swt.energy(problem, x), rtol=1e-4)
        True
    """
    return _functions()[1].apply(poses, problem, which)


def feasible(problem: Problem, poses: Tensor, which: Tensor | None = None) -> Tensor:
    """Which layouts [B] bool the engine calls valid: `Problem.feasible`. Errors as for `energy`.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.feasible(problem, x).dtype
        torch.bool
    """
    torch = _torch()
    return torch.from_dlpack(problem.feasible(poses.detach().contiguous(), which))


def free(problem: Problem, device: Any = None) -> Tensor:
    """One for each coordinate [S, N, 4] that may change, else zero: what to multiply gradients with.

    No device: the CPU.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.free(problem).shape == (1, problem.objects, 4)
        True
    """
    torch = _torch()
    return torch.as_tensor(problem.free, dtype=torch.float32, device=device)


def _torch() -> Any:
    try:
        import torch
    except ImportError:
        raise MissingDependencyError("PyTorch is not installed; pip install torch") from None
    return torch


@cache
def _functions() -> tuple[Any, Any]:
    """The autograd functions of energy and residuals."""
    torch = _torch()
    once_differentiable = torch.autograd.function.once_differentiable

    class Energy(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, poses: Tensor, problem: Problem, which: Tensor | None) -> Tensor:
            total, gradient = problem.energy_and_grad(poses.detach().contiguous(), which)
            ctx.save_for_backward(torch.from_dlpack(gradient))
            return torch.from_dlpack(total)

        @staticmethod
        @once_differentiable
        def backward(ctx: Any, up: Tensor) -> tuple[Tensor, None, None]:
            (gradient,) = ctx.saved_tensors
            return up[:, None, None] * gradient, None, None

    class Residuals(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, poses: Tensor, problem: Problem, which: Tensor | None) -> Tensor:
            residual, slope = problem.residuals(poses.detach().contiguous(), which)
            scene = torch.as_tensor(problem.scene_of(len(poses), which), dtype=torch.int64)
            objects = torch.as_tensor(problem.item_objects, dtype=torch.int64)[scene].clamp(min=0)
            ctx.save_for_backward(torch.from_dlpack(slope), objects.to(poses.device))
            ctx.shape = poses.shape
            return torch.from_dlpack(residual)

        @staticmethod
        @once_differentiable
        def backward(ctx: Any, up: Tensor) -> tuple[Tensor, None, None]:
            slope, objects = ctx.saved_tensors
            pulled = (up[:, :, None, None] * slope).flatten(1, 2)
            gradient = torch.zeros(ctx.shape, dtype=slope.dtype, device=slope.device)
            return gradient.scatter_add(1, objects.flatten(1, 2)[..., None].expand_as(pulled), pulled), None, None

    return Energy, Residuals
