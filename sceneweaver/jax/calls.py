"""The engine's launches as calls that XLA makes.

A call knows its problem by a number, as XLA carries numbers and arrays alone. Warp wants the types of the arguments as
objects, so annotations are not postponed here.
"""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import jax
import numpy as np
import warp as wp

from sceneweaver.layout import Functional, Problem, kinds_from, numbered

from .graphs import measure, own_stream

PoseArray = wp.array2d(dtype=wp.vec4)
SceneArray = wp.array(dtype=wp.int32)
ValueArray = wp.array2d(dtype=wp.float32)

jax.tree_util.register_static(Problem)


def _problem(number: int, poses: wp.array) -> Problem:
    problem = numbered(number)
    if str(poses.device) != problem.device:
        raise RuntimeError(f"poses: they are on {poses.device}, the problem is on {problem.device}")
    return problem


def energy(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    energy: wp.array(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    gradient: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Energies [B] and gradients [B, N]."""
    problem = _problem(number, poses)
    measure(problem, problem.measured, (poses, which), (energy, gradient))


def residuals(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    residual: wp.array2d(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    slope: wp.array3d(dtype=wp.vec4),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Residuals [B, M] and their derivatives [B, M, 3]."""
    problem = _problem(number, poses)
    measure(problem, problem.taken_apart, (poses, which), (residual, slope))


def feasible(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    feasible: wp.array(dtype=wp.bool),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Which layouts [B] are feasible."""
    problem = _problem(number, poses)
    with own_stream(problem.device):
        wp.copy(feasible, problem.judged(poses, which))


def sample(
    rng: wp.array(dtype=wp.uint32),  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Layouts [B, N] to start from."""
    problem = _problem(number, rng)
    with own_stream(problem.device):
        wp.copy(poses, problem.drawn(rng, which))


def project(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    nearest: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The feasible layouts [B, N] nearest to poses."""
    problem = _problem(number, poses)
    with own_stream(problem.device):
        wp.copy(nearest, problem.projected(poses, which))


def energy_with(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    energy: wp.array(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    gradient: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    slope: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Energies [B] at values [B, F] of some kinds of parameters, and gradients [B, N] and [B, F]."""
    _on_host(number, kinds, lambda f: f.energy, (poses, which, values), (energy, gradient, slope))


def residuals_with(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    residual: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    slope: wp.array3d(dtype=wp.vec4),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Residuals [B, M] at values of parameters, and their derivatives [B, M, 3] by poses."""
    _on_host(number, kinds, lambda f: f.residuals, (poses, which, values), (residual, slope))


def residuals_along(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    along: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    change: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The change of residuals [B, M] along one of values."""
    _on_host(number, kinds, lambda f: f.residuals_along, (poses, which, values, along), (change,))


def residuals_pulled(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    up: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    slope: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The gradient [B, F] by values of residuals weighted by ``up`` [B, M]."""
    _on_host(number, kinds, lambda f: f.residuals_pulled, (poses, which, values, up), (slope,))


def project_with(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    nearest: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The feasible layouts [B, N] nearest to poses, at values of parameters."""
    _on_host(number, kinds, lambda f: f.projected, (poses, which, values), (nearest,))


def projection_pulled(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
    nearest: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    up: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    kinds: int,
    by_poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    by_values: ValueArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The gradients [B, N] and [B, F] by poses and values of nearest layouts weighted by ``up`` [B, N]."""
    _on_host(number, kinds, lambda f: f.projection_pulled, (poses, which, values, nearest, up), (by_poses, by_values))


def _on_host(
    number: int, kinds: int, measure: Callable, inputs: Sequence[wp.array], outputs: Sequence[wp.array]
) -> None:
    """Measure by NumPy; a problem is compiled for the values that come."""
    problem = _problem(number, inputs[0])
    with own_stream(problem.device):
        found = measure(Functional(problem, kinds_from(kinds)))(*(np.array(x.numpy()) for x in inputs))
        for there, here in zip(outputs, found if isinstance(found, tuple) else (found,), strict=True):
            if there.size:
                there.assign(np.ascontiguousarray(here, dtype=np.float32))


OUTPUTS: dict[Callable, int] = {
    energy: 2,
    residuals: 2,
    feasible: 1,
    sample: 1,
    project: 1,
    energy_with: 3,
    residuals_with: 2,
    residuals_along: 1,
    residuals_pulled: 1,
    project_with: 1,
    projection_pulled: 2,
}


def call(function: Callable, problem: Problem, *arguments: Any, output_dims: Any, kinds: int | None = None) -> tuple:
    """Call one of the functions above from JAX with the problem's number, and kinds of parameters, as last inputs."""
    numbers = (problem.number,) if kinds is None else (problem.number, kinds)
    return _callable(function)(*arguments, *numbers, output_dims=output_dims)


@cache
def _callable(function: Callable) -> Callable:
    # XLA records no call in a graph of its own: some look at arrays from the host.
    mode = wp.JaxCallableGraphMode.NONE
    return wp.jax_callable(function, num_outputs=OUTPUTS[function], graph_mode=mode, vmap_method="broadcast_all")
