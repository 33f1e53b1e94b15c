"""The engine's launches as calls that XLA makes.

A call knows its problem by a number, as XLA carries numbers and arrays alone. Warp wants the types of the arguments as
objects, so annotations are not postponed here.
"""

from collections.abc import Callable
from functools import cache
from typing import Any

import jax
import warp as wp

from sceneweaver.layout import Problem, numbered

from .graphs import measure, own_stream

PoseArray = wp.array2d(dtype=wp.vec4)
SceneArray = wp.array(dtype=wp.int32)

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


OUTPUTS: dict[Callable, int] = {energy: 2, residuals: 2, feasible: 1, sample: 1, project: 1}


def call(function: Callable, problem: Problem, *arguments: Any, output_dims: Any) -> tuple:
    """Call one of the functions above from JAX with the problem's number as its last input."""
    return _callable(function)(*arguments, problem.number, output_dims=output_dims)


@cache
def _callable(function: Callable) -> Callable:
    # XLA records no call in a graph of its own: some look at arrays from the host.
    mode = wp.JaxCallableGraphMode.NONE
    return wp.jax_callable(function, num_outputs=OUTPUTS[function], graph_mode=mode, vmap_method="broadcast_all")
