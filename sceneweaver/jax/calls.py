"""The engine's launches as calls that XLA makes.

A call knows its problem by a number, as XLA carries numbers and arrays alone. Warp wants the types of the arguments as
objects, so annotations are not postponed here.
"""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from functools import cache
from itertools import count
from typing import Any
from weakref import WeakValueDictionary

import jax
import warp as wp

from sceneweaver.layout import Problem

PoseArray = wp.array2d(dtype=wp.vec4)
SceneArray = wp.array(dtype=wp.int32)

_NUMBERS = count()
_PROBLEMS: WeakValueDictionary[int, Problem] = WeakValueDictionary()
_KEPT: set[Problem] = set()

jax.tree_util.register_static(Problem)


def _number_of(problem: Problem) -> int:
    """The number that calls know a problem by."""
    number = getattr(problem, "_number", None)
    if number is None:
        number = problem._number = next(_NUMBERS)  # pyright: ignore[reportAttributeAccessIssue]
        _PROBLEMS[number] = problem
    return number


def _problem(number: int, poses: wp.array) -> Problem:
    problem = _PROBLEMS.get(int(number))
    if problem is None:
        raise RuntimeError("the problem of a compiled function is gone; keep it as long as the function")
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
    for into, values in zip((energy, gradient), _problem(number, poses).measured(poses, which), strict=True):
        wp.copy(into, values)


def residuals(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    residual: wp.array2d(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    slope: wp.array3d(dtype=wp.vec4),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Residuals [B, M] and their derivatives [B, M, 3]."""
    for into, values in zip((residual, slope), _problem(number, poses).taken_apart(poses, which), strict=True):
        wp.copy(into, values)


def feasible(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    feasible: wp.array(dtype=wp.bool),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Which layouts [B] are feasible."""
    problem = _problem(number, poses)
    with _aside(problem):
        wp.copy(feasible, problem.judged(poses, which))


def sample(
    rng: wp.array(dtype=wp.uint32),  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Layouts [B, N] to start from."""
    problem = _problem(number, rng)
    with _aside(problem):
        wp.copy(poses, problem.drawn(rng, which))


def project(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    nearest: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The feasible layouts [B, N] nearest to poses."""
    problem = _problem(number, poses)
    with _aside(problem):
        wp.copy(nearest, problem.projected(poses, which))


_KINDS: dict[Callable, int] = {energy: 2, residuals: 2, feasible: 1, sample: 1, project: 1}
CAPTURED = (energy, residuals)  # launches alone; the others look at arrays from the host
CUDA_MODE = wp.JaxCallableGraphMode.WARP_STAGED_EX
"""How captured calls run on a GPU: as a CUDA graph on buffers of its own, between a copy there and one back."""


def call(function: Callable, problem: Problem, *arguments: Any, output_dims: Any) -> tuple:
    """Call one of the functions above from JAX with the problem's number as its last input."""
    on_gpu = problem.device != "cpu"
    mode = CUDA_MODE if on_gpu and function in CAPTURED else wp.JaxCallableGraphMode.NONE
    number = _number_of(problem)
    if mode != wp.JaxCallableGraphMode.NONE:
        _keep(problem)
    return _callable(function, mode)(*arguments, number, output_dims=output_dims)


@cache
def _callable(function: Callable, mode: wp.JaxCallableGraphMode) -> Callable:
    outputs = _KINDS[function]
    return wp.jax_callable(function, num_outputs=outputs, graph_mode=mode, vmap_method="broadcast_all")


def _keep(problem: Problem) -> None:
    """Keep a problem for good, as graphs hold the addresses of its tables; load the kernels that are to be captured."""
    if problem in _KEPT:
        return
    _KEPT.add(problem)
    counts = problem.energy_calls, problem.evaluations
    home, which = wp.array(problem.home[:1], dtype=wp.vec4, device=problem.device), [0]
    problem.energy_and_grad(home, which)
    problem.residuals(home, which)
    problem.energy_calls, problem.evaluations = counts


@cache
def _stream(device: str) -> wp.Stream:
    return wp.Stream(device)


def _aside(problem: Problem) -> AbstractContextManager:
    """On a GPU a stream of our own, in order with XLA's: what runs there may record graphs."""
    return nullcontext() if problem.device == "cpu" else wp.ScopedStream(_stream(problem.device), True, True)
