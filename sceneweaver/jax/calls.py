"""The engine's launches as calls that XLA makes.

A call knows its problem by a number, as XLA carries numbers and arrays alone. Warp wants the types of the arguments as
objects, so annotations are not postponed here.
"""

from itertools import count
from weakref import WeakValueDictionary

import jax
import warp as wp

from sceneweaver.layout import Problem

PoseArray = wp.array2d(dtype=wp.vec4)
SceneArray = wp.array(dtype=wp.int32)

_NUMBERS = count()
_PROBLEMS: WeakValueDictionary[int, Problem] = WeakValueDictionary()

jax.tree_util.register_static(Problem)


def number_of(problem: Problem) -> int:
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


def _energy(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    energy: wp.array(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    gradient: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Energies [B] and gradients [B, N]."""
    for into, values in zip((energy, gradient), _problem(number, poses).measured(poses, which), strict=True):
        wp.copy(into, values)


def _residuals(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    residual: wp.array2d(dtype=wp.float32),  # pyright: ignore[reportInvalidTypeForm]
    slope: wp.array3d(dtype=wp.vec4),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Residuals [B, M] and their derivatives [B, M, 3]."""
    for into, values in zip((residual, slope), _problem(number, poses).taken_apart(poses, which), strict=True):
        wp.copy(into, values)


def _feasible(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    feasible: wp.array(dtype=wp.bool),  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Which layouts [B] are feasible."""
    wp.copy(feasible, _problem(number, poses).judged(poses, which))


def _sample(
    rng: wp.array(dtype=wp.uint32),  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """Layouts [B, N] to start from."""
    wp.copy(poses, _problem(number, rng).drawn(rng, which))


def _project(
    poses: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
    which: SceneArray,  # pyright: ignore[reportInvalidTypeForm]
    number: int,
    nearest: PoseArray,  # pyright: ignore[reportInvalidTypeForm]
) -> None:
    """The feasible layouts [B, N] nearest to poses."""
    wp.copy(nearest, _problem(number, poses).projected(poses, which))


# They look at arrays from the host and take memory, so none is recorded as a part of a graph.
PLAIN = {"graph_mode": wp.JaxCallableGraphMode.NONE, "vmap_method": "broadcast_all"}
energy_call = wp.jax_callable(_energy, num_outputs=2, **PLAIN)
residuals_call = wp.jax_callable(_residuals, num_outputs=2, **PLAIN)
feasible_call = wp.jax_callable(_feasible, **PLAIN)
sample_call = wp.jax_callable(_sample, **PLAIN)
project_call = wp.jax_callable(_project, **PLAIN)
