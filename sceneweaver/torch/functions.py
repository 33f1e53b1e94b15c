"""The functions: shapes are made [B, N, 4], types of number float32, and the operators are called."""

# Without PyTorch pyright takes the folder of this module for it:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import prod
from typing import TYPE_CHECKING, Any

from sceneweaver.layout import PARAMETER_KINDS, Problem, bits_of
from sceneweaver.scene import InputError, MissingDependencyError

if TYPE_CHECKING:
    import torch  # pyright: ignore[reportMissingImports]
    from torch import Tensor  # pyright: ignore[reportMissingImports]

ENERGY, NEAREST = -1, 0  # beside numbers of residuals


def energy(
    problem: Problem, poses: Tensor, which: Tensor | None = None, parameters: Mapping[str, Tensor] | None = None
) -> Tensor:
    """Energy [...] in metres of layouts [..., N, 4]: `Problem.energy`, differentiable by the poses.

    The first derivative is the engine's gradient. The second one is a central difference of it over 1 mm and 1 mrad,
    at a kink that of one side. There is no third one. All of it is measured in float32; float64
    poses have an energy and a gradient in float64 with float32's digits.

    Args:
        problem: from `sceneweaver.compile`; keep it as long as the derivatives are needed.
        poses: x, y, z [m] and yaw [rad], float32 or float64, on the problem's device.
        which: the scene of each layout, whole numbers that broadcast against the leading dimensions. Left out,
            [B, N, 4] has equal parts, scene after scene.
        parameters: other values of some kinds of `Problem.parameters`, of the shapes there, for all layouts; the energy
            is differentiable by them as well, backwards. A scene is compiled anew for values not seen lately.

    Raises:
        InputError: another shape, type of number or device, or a third derivative.
        MissingDependencyError: PyTorch is not installed.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.energy(problem, x).sum().backward()
        >>> x.grad.shape == x.shape
        True
        >>> weight = torch.tensor(problem.parameters.values["weight"], requires_grad=True)
        >>> swt.energy(problem, x.detach(), parameters={"weight": weight}).sum().backward()
        >>> bool((weight.grad >= 0).all())
        True
    """
    if parameters:
        return _with_parameters(problem, poses, which, parameters, ENERGY)[..., 0]
    return _flat(lambda ops, x, rows: ops.energy(x, rows, problem.number), problem, poses, which)


def residuals(
    problem: Problem, poses: Tensor, which: Tensor | None = None, parameters: Mapping[str, Tensor] | None = None
) -> Tensor:
    """Residuals [..., M] in metres: `Problem.residuals`. Arguments, derivatives and errors as for `energy`.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> r = swt.residuals(problem, x)
        >>> torch.allclose((r * r).sum(-1) / 0.1, swt.energy(problem, x), rtol=1e-4)
        True
    """
    if parameters:
        return _with_parameters(problem, poses, which, parameters, problem.items)
    return _flat(lambda ops, x, rows: ops.residuals(x, rows, problem.number, problem.items), problem, poses, which)


def feasible(problem: Problem, poses: Tensor, which: Tensor | None = None) -> Tensor:
    """Which layouts [...] bool the engine calls valid: `Problem.feasible`. Errors as for `energy`.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.feasible(problem, x).dtype
        torch.bool
    """
    return _flat(lambda ops, x, rows: ops.feasible(x, rows, problem.number), problem, poses, which)


def project(
    problem: Problem, poses: Tensor, which: Tensor | None = None, parameters: Mapping[str, Tensor] | None = None
) -> Tensor:
    """The feasible layouts [..., N, 4] nearest to poses: `Problem.project`, differentiable once, backwards.

    The derivative is that of the equation that nearest layouts solve, see `Problem.sensitivity`: by the coordinates of
    poses that are free, and by ``parameters``. It is worked out on the host, layout by layout. Arguments and errors as
    for `energy`.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> walls = torch.tensor(problem.parameters.values["outline"], requires_grad=True)
        >>> near = swt.project(problem, torch.tensor(problem.sample(0, 1)), parameters={"outline": walls})
        >>> near.sum().backward()
        >>> bool(walls.grad.isfinite().all())
        True
    """
    return _with_parameters(problem, poses, which, parameters or {}, NEAREST)


def free(problem: Problem, device: torch.device | str | None = None) -> Tensor:
    """One for each coordinate [S, N, 4] that may change, else zero: what to multiply gradients with.

    No device: the CPU.

    Examples:
        >>> import torch, sceneweaver as sw, sceneweaver.torch as swt
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> x = torch.tensor(problem.sample(0, 2), requires_grad=True)
        >>> swt.free(problem).shape == (1, problem.objects, 4)
        True
    """
    return _torch().as_tensor(problem.free, dtype=_torch().float32, device=device)


def _torch() -> Any:
    try:
        import torch
    except ImportError:
        raise MissingDependencyError("PyTorch is not installed; pip install torch") from None
    return torch


def _with_parameters(
    problem: Problem, poses: Tensor, which: Tensor | None, parameters: Mapping[str, Tensor], width: int
) -> Tensor:
    """Residuals of so many numbers, the `ENERGY`, or the `NEAREST` poses, at values of parameters."""
    torch = _torch()
    unknown = [kind for kind in parameters if kind not in PARAMETER_KINDS]
    if unknown:
        raise InputError(f"parameters: no kind {unknown[0]!r}; there are {', '.join(PARAMETER_KINDS)}")
    kinds = [kind for kind in PARAMETER_KINDS if kind in parameters]
    rows = []
    for kind in kinds:
        given, shape = torch.as_tensor(parameters[kind]), problem.parameters.values[kind].shape
        if tuple(given.shape) != shape:
            raise InputError(f"parameters: {kind} is an array of shape {tuple(given.shape)}; give {shape}")
        rows.append(given.to(dtype=torch.float32, device=getattr(poses, "device", None)).reshape(-1))

    def measured(_: Any, x: Tensor, scenes: Tensor) -> Tensor:
        from . import parameters as operators

        values = torch.cat(rows) if rows else x.new_zeros(0)
        u = torch.cat([x.reshape(x.shape[0], -1), values.expand(x.shape[0], -1)], dim=1)
        if width == NEAREST:
            return operators.Projected.apply(u, scenes, problem.number, bits_of(kinds))
        return operators.Measured.apply(u, scenes, problem.number, bits_of(kinds), width)

    return _flat(measured, problem, poses, which)


def _flat(function: Callable, problem: Problem, poses: Tensor, which: Tensor | None) -> Tensor:
    """Call a function of the operators, poses [B, N, 4] float32 and which [B] int32, with any leading dimensions."""
    torch = _torch()
    from . import operators

    if not isinstance(problem, Problem):
        raise InputError(f"problem: {type(problem).__name__} is no Problem; sceneweaver.compile makes one")
    if not isinstance(poses, torch.Tensor):
        raise InputError(f"poses: {type(poses).__name__} is no tensor; torch.as_tensor makes one")
    if poses.ndim < 2 or poses.shape[-2:] != (problem.objects, 4):
        raise InputError(f"poses: an array of shape {tuple(poses.shape)}; poses are [..., {problem.objects}, 4]")
    if poses.dtype not in (torch.float32, torch.float64):
        raise InputError(f"poses: numbers of type {poses.dtype}; poses are float32 or float64")
    if str(poses.device) != problem.device:
        raise InputError(f"poses: they are on {poses.device}, the problem is on {problem.device}")
    lead = poses.shape[:-2]
    rows = _scenes(torch, problem, which, lead, poses.device)
    found = function(operators, poses.to(torch.float32).reshape((-1, *poses.shape[-2:])), rows.reshape(-1))
    found = found.reshape((*lead, *found.shape[1:]))
    return found.to(poses.dtype) if found.is_floating_point() else found


def _scenes(torch: Any, problem: Problem, which: Tensor | None, lead: tuple[int, ...], device: Any) -> Tensor:
    """The scene of each layout, int32 of the shape of the leading dimensions."""
    scenes = len(problem.scenes)
    if which is None:
        if scenes > 1 and (len(lead) != 1 or lead[0] % scenes):
            raise InputError(f"which: left out, poses are [B, N, 4] with B a multiple of the {scenes} scenes")
        each = prod(lead) // scenes
        return torch.arange(scenes, dtype=torch.int32, device=device).repeat_interleave(each).reshape(lead)
    rows = torch.as_tensor(which, device=device)
    if rows.is_floating_point() or rows.is_complex() or rows.dtype == torch.bool:
        raise InputError(f"which: numbers of type {rows.dtype}; scenes are whole numbers")
    try:
        return rows.to(torch.int32).broadcast_to(lead)
    except RuntimeError:
        raise InputError(f"which: an array of shape {tuple(rows.shape)}; there are {tuple(lead)} layouts") from None
