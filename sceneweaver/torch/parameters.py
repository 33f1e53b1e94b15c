"""Energy, residuals and projection as operators of PyTorch that have derivatives by parameters as well.

Coordinates u [B, U] of a layout are its poses and values of some kinds of parameters (bits of a number). A measurement
has a Jacobian J that is never a matrix: ``_push`` is J v, ``_pull`` is J^T w. This module needs PyTorch, so `functions`
imports it inside a function.
"""

# Without PyTorch pyright takes the folder of this module for it:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import torch  # pyright: ignore[reportMissingImports]
from torch import Tensor  # pyright: ignore[reportMissingImports]

from sceneweaver.layout import Functional, Joint, difference, kinds_from, numbered

from .operators import Last, one_batch

ENERGY = -1
"""The width of an energy, beside those of residuals."""


def _on_host(function: Callable, *tensors: Tensor) -> Any:
    """A function of NumPy arrays of tensors, its results as tensors beside the first."""
    device = tensors[0].device
    found = function(*(np.array(x.detach().cpu().numpy()) for x in tensors))
    several = found if isinstance(found, tuple) else (found,)
    made = tuple(torch.as_tensor(x, dtype=torch.float32, device=device) for x in several)
    return made if isinstance(found, tuple) else made[0]


def _joint(number: int, bits: int, width: int) -> Joint:
    """What is measured: ``width`` residuals, or with `ENERGY` the energy."""
    return Joint(numbered(number), kinds_from(bits), width != ENERGY)


@torch.library.custom_op("sceneweaver::value_with", mutates_args=())
def _value(u: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
    """The measurement [B, M]."""
    return _on_host(_joint(number, bits, width).value, u, which)


@torch.library.custom_op("sceneweaver::push_with", mutates_args=())
def _push(u: Tensor, which: Tensor, v: Tensor, number: int, bits: int, width: int) -> Tensor:
    """J v [B, M]."""
    return _on_host(_joint(number, bits, width).push, u, which, v)


@torch.library.custom_op("sceneweaver::pull_with", mutates_args=())
def _pull(u: Tensor, which: Tensor, w: Tensor, number: int, bits: int, width: int) -> Tensor:
    """J^T w [B, U]."""
    return _on_host(_joint(number, bits, width).pull, u, which, w)


@torch.library.custom_op("sceneweaver::project_with", mutates_args=())
def _project(u: Tensor, which: Tensor, number: int, bits: int) -> Tensor:
    """Nearest feasible poses [B, N, 4]."""
    return _on_host(lambda u, rows: _projection(number, bits, "projected")(*_taken(u, rows, number)), u, which)


@torch.library.custom_op("sceneweaver::projection_pulled", mutates_args=())
def _project_pull(u: Tensor, which: Tensor, nearest: Tensor, up: Tensor, number: int, bits: int) -> Tensor:
    """The gradient [B, U] of nearest poses weighted by ``up`` [B, N, 4]."""

    def pulled(u: np.ndarray, rows: np.ndarray, nearest: np.ndarray, up: np.ndarray) -> np.ndarray:
        by_poses, by_values = _projection(number, bits, "projection_pulled")(*_taken(u, rows, number), nearest, up)
        return np.concatenate([by_poses.reshape(len(u), -1), by_values], axis=1)

    return _on_host(pulled, u, which, nearest, up)


def _projection(number: int, bits: int, name: str) -> Callable:
    return getattr(Functional(numbered(number), kinds_from(bits)), name)


def _taken(u: np.ndarray, which: np.ndarray, number: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Poses, scenes and values of coordinates."""
    objects = numbered(number).objects
    return np.ascontiguousarray(u[:, : 4 * objects]).reshape(-1, objects, 4), which, np.array(u[:, 4 * objects :])


@_value.register_fake
def _(u: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
    return u.new_empty(u.shape[0], abs(width))


@_push.register_fake
def _(u: Tensor, which: Tensor, v: Tensor, number: int, bits: int, width: int) -> Tensor:
    return u.new_empty(u.shape[0], abs(width))


@_pull.register_fake
def _(u: Tensor, which: Tensor, w: Tensor, number: int, bits: int, width: int) -> Tensor:
    return u.new_empty(u.shape)


@_project.register_fake
def _(u: Tensor, which: Tensor, number: int, bits: int) -> Tensor:
    return u.new_empty(u.shape[0], numbered(number).objects, 4)


@_project_pull.register_fake
def _(u: Tensor, which: Tensor, nearest: Tensor, up: Tensor, number: int, bits: int) -> Tensor:
    return u.new_empty(u.shape)


for _operator in (_value, _push, _pull, _project, _project_pull):
    _operator.register_vmap(one_batch(_operator))


class Measured(torch.autograd.Function):
    """A measurement [B, M] by coordinates [B, U], scenes [B], and numbers of problem, kinds and M; twice
    differentiable, backwards."""

    generate_vmap_rule = True

    @staticmethod
    def forward(u: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
        """Measure."""
        return _value(u, which, number, bits, width)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: Tensor) -> None:
        """Keep the place."""
        u, which, *ctx.of = inputs
        ctx.save_for_backward(u, which)

    @staticmethod
    def backward(ctx: Any, up: Tensor) -> tuple:
        """J^T up."""
        u, which = ctx.saved_tensors
        return _Pulled.apply(u, up, which, *ctx.of), None, None, None, None


class _Pulled(torch.autograd.Function):
    """J^T w [B, U]: linear in w, curved in the place."""

    generate_vmap_rule = True

    @staticmethod
    def forward(u: Tensor, w: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
        return _pull(u, which, w, number, bits, width)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: Tensor) -> None:
        u, w, which, *ctx.of = inputs
        ctx.save_for_backward(u, w, which)

    @staticmethod
    def backward(ctx: Any, along: Tensor) -> tuple:
        # second derivatives are symmetric: what goes back to the place is the product's change along what comes in
        u, w, which = ctx.saved_tensors
        back = _Bent.apply(u, w, along, which, *ctx.of)
        return back, _PushedLast.apply(u, along, which, *ctx.of), None, None, None, None


class _PushedLast(Last):
    """J v [B, M]."""

    @staticmethod
    def forward(u: Tensor, v: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
        return _push(u, which, v, number, bits, width)


class _Bent(Last):
    """The change [B, U] of J^T w along a movement of the place."""

    @staticmethod
    def forward(u: Tensor, w: Tensor, along: Tensor, which: Tensor, number: int, bits: int, width: int) -> Tensor:
        twice, both = torch.cat([which, which]), torch.cat([w, w])
        here = _pull(u, which, w, number, bits, width)

        def pull(moved: Tensor) -> Tensor:
            return _pull(moved[..., 0].contiguous(), twice, both, number, bits, width)

        return difference(torch, pull, here, u[..., None], along[..., None])


class Projected(torch.autograd.Function):
    """Nearest feasible poses [B, N, 4] by coordinates [B, U]; differentiable once, backwards."""

    generate_vmap_rule = True

    @staticmethod
    def forward(u: Tensor, which: Tensor, number: int, bits: int) -> Tensor:
        """Project."""
        return _project(u, which, number, bits)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple, output: Tensor) -> None:
        """Keep the place and what was found."""
        u, which, *ctx.of = inputs
        ctx.save_for_backward(u, which, output)

    @staticmethod
    def backward(ctx: Any, up: Tensor) -> tuple:
        """By the implicit function theorem."""
        u, which, nearest = ctx.saved_tensors
        return _ProjectedBack.apply(u, nearest, up, which, *ctx.of), None, None, None


class _ProjectedBack(Last):
    """What weights of nearest poses pull coordinates by."""

    @staticmethod
    def forward(u: Tensor, nearest: Tensor, up: Tensor, which: Tensor, number: int, bits: int) -> Tensor:
        return _project_pull(u, which, nearest, up.contiguous(), number, bits)
