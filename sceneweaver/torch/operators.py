"""The engine's measurements as operators of PyTorch, and their derivatives.

An operator knows its problem by a number, as operators take tensors and numbers alone. ``torch.compile`` leaves them
whole (`register_fake` says their shapes), ``torch.func.vmap`` makes one batch of all (`register_vmap`). This module
needs PyTorch, so `functions` imports it inside a function.
"""

# Without PyTorch pyright takes the folder of this module for it:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import torch  # pyright: ignore[reportMissingImports]
from torch import Tensor  # pyright: ignore[reportMissingImports]

from sceneweaver.layout import difference, numbered
from sceneweaver.scene import InputError


@torch.library.custom_op("sceneweaver::energy", mutates_args=())
def _measure_energy(poses: Tensor, which: Tensor, number: int) -> tuple[Tensor, Tensor]:
    """Energies [B] and their gradients [B, N, 4]."""
    energy, gradient = numbered(number).energy_and_grad(poses.detach().contiguous(), which)
    return torch.from_dlpack(energy), torch.from_dlpack(gradient)


@torch.library.custom_op("sceneweaver::residuals", mutates_args=())
def _measure_residuals(poses: Tensor, which: Tensor, number: int, items: int) -> tuple[Tensor, Tensor, Tensor]:
    """Residuals [B, M], their derivatives [B, M, 3, 4] by the poses of an item's objects, and those objects [B, M, 3].

    The derivative by an object that an item has not is zero, so any will do: it is the first one.
    """
    problem = numbered(number)
    residual, slope = problem.residuals(poses.detach().contiguous(), which)
    objects = torch.as_tensor(problem.item_objects, dtype=torch.int64, device=poses.device)
    return torch.from_dlpack(residual), torch.from_dlpack(slope), objects.clamp(min=0)[which.long()]


@torch.library.custom_op("sceneweaver::feasible", mutates_args=())
def feasible(poses: Tensor, which: Tensor, number: int) -> Tensor:
    """Which layouts [B] bool the engine calls valid."""
    return torch.from_dlpack(numbered(number).feasible(poses.detach().contiguous(), which))


@_measure_energy.register_fake
def _(poses: Tensor, which: Tensor, number: int) -> tuple[Tensor, Tensor]:
    return poses.new_empty(poses.shape[0]), torch.empty_like(poses, memory_format=torch.contiguous_format)


@_measure_residuals.register_fake
def _(poses: Tensor, which: Tensor, number: int, items: int) -> tuple[Tensor, Tensor, Tensor]:
    shape = (poses.shape[0], items)
    return poses.new_empty(shape), poses.new_empty(*shape, 3, 4), poses.new_empty(*shape, 3, dtype=torch.int64)


@feasible.register_fake
def _(poses: Tensor, which: Tensor, number: int) -> Tensor:
    return poses.new_empty(poses.shape[0], dtype=torch.bool)


def one_batch(operator: Callable) -> Callable:
    """The rule of ``vmap`` for an operator: layouts of all examples are one batch."""

    def rule(info: Any, in_dims: Sequence[int | None], *given: Any) -> tuple[Any, Any]:
        count = info.batch_size
        tensors = [
            x.expand(count, *x.shape) if dim is None else x.movedim(dim, 0)
            for x, dim in zip(given, in_dims, strict=True)
            if isinstance(x, Tensor)
        ]
        found = operator(*(x.reshape(-1, *x.shape[2:]) for x in tensors), *given[len(tensors) :])
        if isinstance(found, Tensor):
            return found.reshape(count, -1, *found.shape[1:]), 0
        return tuple(x.reshape(count, -1, *x.shape[1:]) for x in found), (0,) * len(found)

    return rule


for _operator in (_measure_energy, _measure_residuals, feasible):
    _operator.register_vmap(one_batch(_operator))


def energy(poses: Tensor, which: Tensor, number: int) -> Tensor:
    """Energies [B] of poses [B, N, 4], of scenes [B] of the problem with a number; differentiable twice."""
    return _variant(_Energy).apply(poses, which, number)[0]


def residuals(poses: Tensor, which: Tensor, number: int, items: int) -> Tensor:
    """Residuals [B, M] likewise, of a problem with so many items."""
    return _variant(_Residuals).apply(poses, which, number, items)[0]


class _Energy(torch.autograd.Function):
    """Energies [B] and their gradients [B, N, 4], by poses, scenes [B] and the problem's number."""

    generate_vmap_rule = True

    @staticmethod
    def forward(poses: Tensor, which: Tensor, number: int) -> tuple[Tensor, Tensor]:
        return _measure_energy(poses, which, number)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: tuple) -> None:
        poses, which, ctx.number = inputs
        ctx.save_for_backward(poses, which, output[1])
        ctx.save_for_forward(poses, which, output[1])
        ctx.set_materialize_grads(False)

    @staticmethod
    def backward(ctx: Any, up: Tensor | None, along: Tensor | None) -> tuple[Tensor | None, None, None]:
        poses, which, gradient = ctx.saved_tensors
        first = None if up is None else up[:, None, None] * gradient
        # second derivatives are symmetric: what goes back through the gradient is its change along what comes in
        second = None if along is None else _Curvature.apply(poses, along, which, gradient, ctx.number)
        return second if first is None else first if second is None else first + second, None, None


class _Residuals(torch.autograd.Function):
    """Residuals [B, M] by poses, scenes [B] and the problem's number and items; with what `_measure_residuals` adds."""

    generate_vmap_rule = True

    @staticmethod
    def forward(poses: Tensor, which: Tensor, number: int, items: int) -> tuple[Tensor, Tensor, Tensor]:
        return _measure_residuals(poses, which, number, items)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: tuple) -> None:
        poses, which, ctx.number, ctx.items = inputs
        _, slope, objects = output
        ctx.mark_non_differentiable(slope, objects)
        ctx.save_for_backward(poses, which, slope, objects)
        ctx.save_for_forward(poses, which, slope, objects)

    @staticmethod
    def backward(ctx: Any, up: Tensor, *_: Tensor) -> tuple[Tensor, None, None, None]:
        poses, which, slope, objects = ctx.saved_tensors
        pull = _variant(_Pull).apply(poses, up, which, slope, objects, ctx.number, ctx.items)
        return pull, None, None, None


class _Pull(torch.autograd.Function):
    """What weights [B, M] of residuals pull poses by [B, N, 4]: linear in the weights, curved in the poses."""

    generate_vmap_rule = True

    @staticmethod
    def forward(
        poses: Tensor, up: Tensor, which: Tensor, slope: Tensor, objects: Tensor, number: int, items: int
    ) -> Tensor:
        return _pulled(slope, objects, up, poses)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: Tensor) -> None:
        *tensors, ctx.number, ctx.items = inputs
        ctx.save_for_backward(*tensors)
        ctx.save_for_forward(*tensors)

    @staticmethod
    def backward(ctx: Any, along: Tensor) -> tuple:
        poses, up, which, slope, objects = ctx.saved_tensors
        bend = _Bend.apply(poses, up, along, which, slope, objects, ctx.number, ctx.items)
        return bend, _pushed(slope, objects, along), None, None, None, None, None


class _EnergyBothWays(_Energy):
    """With derivatives forwards as well."""

    @staticmethod
    def jvp(ctx: Any, along: Tensor, *_: None) -> tuple[Tensor, Tensor]:
        poses, which, gradient = ctx.saved_tensors
        return (gradient * along).sum((1, 2)), _Curvature.apply(poses, along, which, gradient, ctx.number)


class _ResidualsBothWays(_Residuals):
    """With derivatives forwards as well."""

    @staticmethod
    def jvp(ctx: Any, along: Tensor, *_: None) -> tuple[Tensor, None, None]:
        _, _, slope, objects = ctx.saved_tensors
        return _pushed(slope, objects, along), None, None


class _PullBothWays(_Pull):
    """With derivatives forwards as well."""

    @staticmethod
    def jvp(ctx: Any, along: Tensor, up_along: Tensor, *_: None) -> Tensor:
        poses, up, which, slope, objects = ctx.saved_tensors
        bend = _Bend.apply(poses, up, along, which, slope, objects, ctx.number, ctx.items)
        return bend + _pulled(slope, objects, up_along, poses)


_BOTH_WAYS = {_Energy: _EnergyBothWays, _Residuals: _ResidualsBothWays, _Pull: _PullBothWays}


def _variant(function: type[torch.autograd.Function]) -> type[torch.autograd.Function]:
    """The function with derivatives both ways; backwards alone in ``torch.compile``, which takes no other."""
    return function if torch.compiler.is_compiling() else _BOTH_WAYS[function]


class Last(torch.autograd.Function):
    """A measurement that has no derivative of its own."""

    generate_vmap_rule = True

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: Any) -> None:
        """Keep nothing."""

    @staticmethod
    def backward(ctx: Any, *_: Any) -> Any:
        """Refuse."""
        raise InputError("energy and residuals have first and second derivatives; a third one was asked for")


class _Curvature(Last):
    """The change [B, N, 4] of the energy's gradient along a movement of the poses [B, N, 4]."""

    @staticmethod
    def forward(poses: Tensor, along: Tensor, which: Tensor, gradient: Tensor, number: int) -> Tensor:
        twice = torch.cat([which, which])
        return difference(torch, lambda moved: _measure_energy(moved, twice, number)[1], gradient, poses, along)


class _Bend(Last):
    """The change [B, N, 4] of `_Pull` along a movement of the poses [B, N, 4]."""

    @staticmethod
    def forward(
        poses: Tensor,
        up: Tensor,
        along: Tensor,
        which: Tensor,
        slope: Tensor,
        objects: Tensor,
        number: int,
        items: int,
    ) -> Tensor:
        def pull(moved: Tensor) -> Tensor:
            _, slope, objects = _measure_residuals(moved, torch.cat([which, which]), number, items)
            return _pulled(slope, objects, torch.cat([up, up]), moved)

        return difference(torch, pull, _pulled(slope, objects, up, poses), poses, along)


def _pulled(slope: Tensor, objects: Tensor, up: Tensor, poses: Tensor) -> Tensor:
    """The gradient [B, N, 4] of residuals weighted by ``up`` [B, M]: each item pulls at its three objects at most."""
    shares = (up[:, :, None, None] * slope).flatten(1, 2)
    return torch.zeros_like(poses).scatter_add(1, objects.flatten(1, 2)[..., None].expand_as(shares), shares)


def _pushed(slope: Tensor, objects: Tensor, along: Tensor) -> Tensor:
    """By how much residuals [B, M] change with a movement of the poses [B, N, 4]."""
    index = objects.flatten(1, 2)[..., None].expand(-1, -1, 4)
    return (slope * along.gather(1, index).reshape(slope.shape)).sum((2, 3))
