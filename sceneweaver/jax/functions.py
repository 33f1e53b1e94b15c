"""The functions: shapes are made [B, N, 4], the engine is called, derivatives are said in JAX's own terms."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from math import prod
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import warp as wp
from jax.core import Tracer
from jax.typing import ArrayLike

from sceneweaver.layout import Problem
from sceneweaver.scene import InputError

from . import calls

Array = jax.Array | np.ndarray


def energy(problem: Problem, poses: Array, which: ArrayLike | None = None) -> jax.Array:
    """Energy [...] float32 [m] of layouts [..., N, 4]: `Problem.energy`, differentiable once, forwards and backwards.

    Args:
        problem: from `sceneweaver.compile`; static under ``jit``.
        poses: x, y, z [m] and yaw [rad], float32.
        which: the scene of each layout, whole numbers that broadcast against the leading dimensions; numbers out of
            range count as the nearest. Left out, [B, N, 4] has equal parts, scene after scene.

    Raises:
        InputError: another shape or type of number, or no ``which`` where it takes one.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 8)
        >>> jax.jit(jax.vmap(jax.grad(lambda x: swj.energy(problem, x))))(poses).shape == poses.shape
        True
    """
    return _flat(_energy, problem, poses, which)


def energy_and_grad(problem: Problem, poses: Array, which: ArrayLike | None = None) -> tuple[jax.Array, jax.Array]:
    """Energies [...] and their gradients [..., N, 4] in one call, which itself has no derivative: asking raises.

    Arguments and errors as for `energy`: [m], and [m/m] by x, y, z, [m/rad] by yaw.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> value, gradient = swj.energy_and_grad(problem, poses)
        >>> value.shape, gradient.shape == poses.shape
        ((2,), True)
    """
    return _flat(_measured_energy, problem, poses, which)


def residuals(problem: Problem, poses: Array, which: ArrayLike | None = None) -> jax.Array:
    """Residuals [..., M] in metres: `Problem.residuals`; ``jacfwd``, ``jacrev`` and least-squares solvers take it.

    The energy is the sum of their squares over 0.1 m. Errors as for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> r = swj.residuals(problem, poses)
        >>> bool(jax.numpy.allclose((r * r).sum(-1) / 0.1, swj.energy(problem, poses), rtol=1e-4))
        True
        >>> jax.jacrev(lambda x: swj.residuals(problem, x))(poses[0]).shape == (problem.items, problem.objects, 4)
        True
    """
    return _flat(_residuals, problem, poses, which)


def feasible(problem: Problem, poses: Array, which: ArrayLike | None = None) -> jax.Array:
    """Which layouts [...] bool the engine calls valid: `Problem.feasible`. Errors as for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> swj.feasible(problem, swj.project(problem, poses)).dtype.name
        'bool'
    """
    return _flat(_launch_feasible, problem, jax.lax.stop_gradient(poses), which)  # yes or no does not change gradually


def project(problem: Problem, poses: Array, which: ArrayLike | None = None) -> jax.Array:
    """The feasible layouts [..., N, 4] nearest to poses: `Problem.project`. It has no derivative. Errors as above.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> near = swj.project(problem, poses)
        >>> bool((swj.energy(problem, near) <= swj.energy(problem, poses)).all())
        True
    """
    return _flat(_projected, problem, poses, which)


def sample(problem: Problem, key: Array, count: int) -> jax.Array:
    """Draw layouts [S * count, N, 4] to start from, ``count`` of each scene: `Problem.sample`, by a key of JAX.

    ``key`` is one of ``jax.random.key``. Poses are x, y, z [m] and yaw [rad], drawn from the relations, not solved.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> poses.shape == (2, problem.objects, 4)
        True
    """
    scenes = len(problem.mask)
    rng = _placed(problem, jax.random.bits(key, (scenes * count,), "uint32"))
    return _launch_sample(problem, rng, jnp.repeat(jnp.arange(scenes, dtype=jnp.int32), count))


def carry(problem: Problem, poses: Array, which: ArrayLike | None = None, *, like: Array | None = None) -> jax.Array:
    """Poses [..., N, 4] with all that is carried put on its root as it stands in ``like``; differentiable.

    ``like`` [..., N, 4] defaults to the scenes as given. ``energy(problem, carry(problem, poses))`` is a function of
    the roots alone, and so of what ``free`` lets move.

    Arguments and errors as for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> lamp, table = (problem.scenes[0].index(name) for name in ("reading-lamp", "nightstand-left"))
        >>> moved = swj.carry(problem, poses.at[:, table, 0].add(0.25), like=poses)
        >>> bool(jax.numpy.allclose(moved[:, lamp, 0], poses[:, lamp, 0] + 0.25, atol=1e-5))
        True
    """
    return _flat(_carry, problem, poses, which, *(() if like is None else (like,)))


def free(problem: Problem, which: ArrayLike = 0) -> jax.Array:
    """One for each coordinate [..., N, 4] that may change, else zero: what to multiply gradients with.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> swj.free(problem).shape == poses.shape[1:]
        True
    """
    return jnp.asarray(problem.free, dtype=jnp.float32)[which]


def ravel(problem: Problem, poses: Array, which: ArrayLike | None = None) -> jax.Array:
    """The coordinates [..., D] of poses [..., N, 4] that may change (`free`), x before y before yaw of each object.

    D is that of the scene with most; behind a smaller one's there are zeros. Errors as for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> swj.ravel(problem, swj.sample(problem, jax.random.key(0), 8)).shape == (8, problem.free.sum())
        True
    """
    return _flat(_ravel, problem, poses, which)


def unravel(problem: Problem, vector: Array, like: Array, which: ArrayLike | None = None) -> jax.Array:
    """Poses [..., N, 4] with the free coordinates ``vector`` [..., D] and all else as in ``like``; differentiable.

    What is carried goes along with its root. ``energy(problem, unravel(problem, v, like))`` is a function of what may
    change alone, as optimisers and samplers of vectors want it. Errors as for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 8)
        >>> swj.unravel(problem, 0 * swj.ravel(problem, poses), poses).shape == poses.shape
        True
    """
    like = jnp.asarray(like)
    return _flat(_unravel, problem, like, which, rows=jnp.broadcast_to(vector, (*like.shape[:-2], vector.shape[-1])))


def _flat(
    function: Callable, problem: Problem, poses: Array, which: ArrayLike | None, *more: Array, rows: Array | None = None
) -> Any:
    """Call a function of poses [B, N, 4], which [B], ``more`` poses and ``rows`` [B, D] with any leading dimensions."""
    if not isinstance(problem, Problem):
        raise InputError(f"problem: {type(problem).__name__} is no Problem; sceneweaver.compile makes one")
    poses = _placed(problem, poses)
    if poses.ndim < 2 or poses.shape[-2:] != (problem.objects, 4):
        raise InputError(f"poses: an array of shape {poses.shape}; poses are [..., {problem.objects}, 4]")
    if poses.dtype != jnp.float32:
        raise InputError(f"poses: numbers of type {poses.dtype}; poses are float32")
    lead, scenes = poses.shape[:-2], len(problem.mask)
    if which is None:
        if scenes > 1 and (len(lead) != 1 or lead[0] % scenes):
            raise InputError(f"which: left out, poses are [B, N, 4] with B a multiple of the {scenes} scenes")
        which = np.repeat(np.arange(scenes, dtype=np.int32), prod(lead) // scenes).reshape(lead)
    which = jnp.asarray(which)
    if not jnp.issubdtype(which.dtype, jnp.integer):
        raise InputError(f"which: numbers of type {which.dtype}; scenes are whole numbers")
    try:
        which = jnp.broadcast_to(jnp.clip(which.astype(jnp.int32), 0, scenes - 1), lead)
    except ValueError:
        raise InputError(f"which: an array of shape {which.shape}; there are {lead} layouts") from None
    flat = [jnp.broadcast_to(x, poses.shape).reshape(-1, *poses.shape[-2:]) for x in (poses, *more)]
    flat += [] if rows is None else [rows.reshape(-1, rows.shape[-1])]
    found = function(problem, flat[0], which.reshape(-1), *flat[1:])
    return jax.tree.map(lambda values: values.reshape(*lead, *values.shape[1:]), found)


@cache
def _device_of(name: str) -> Any:
    return wp.device_to_jax(name)


def _placed(problem: Problem, values: Array) -> jax.Array:
    """Values on the problem's device, if they are not bound to one; what is traced goes where its function runs."""
    if isinstance(values, Tracer) or (isinstance(values, jax.Array) and values.committed):
        return values
    return jax.device_put(values, _device_of(problem.device))


_static = partial(jax.jit, static_argnums=0)  # without it each call from outside of jit would be compiled anew


@_static
def _launch_energy(problem: Problem, poses: jax.Array, which: jax.Array) -> tuple[jax.Array, jax.Array]:
    dims = {"energy": poses.shape[:1], "gradient": poses.shape[:2]}
    energies, gradients = calls.call(calls.energy, problem, poses, which, output_dims=dims)
    return energies, gradients


@_static
def _launch_residuals(problem: Problem, poses: jax.Array, which: jax.Array) -> tuple[jax.Array, jax.Array]:
    dims = {"residual": (len(poses), problem.items), "slope": (len(poses), problem.items, 3)}
    values, slopes = calls.call(calls.residuals, problem, poses, which, output_dims=dims)
    return values, slopes


@_static
def _launch_feasible(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    return calls.call(calls.feasible, problem, poses, which, output_dims=poses.shape[:1])[0]


@_static
def _launch_project(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    return calls.call(calls.project, problem, poses, which, output_dims=poses.shape[:2])[0]


@_static
def _launch_sample(problem: Problem, rng: jax.Array, which: jax.Array) -> jax.Array:
    return calls.call(calls.sample, problem, rng, which, output_dims=(len(rng), problem.objects))[0]


def _without_derivative(function: Callable, says: str) -> Callable:
    """The function, with one line where JAX asks for a derivative of it."""

    @partial(jax.custom_jvp, nondiff_argnums=(0,))
    def measured(problem: Problem, poses: jax.Array, which: jax.Array) -> Any:
        return function(problem, poses, which)

    @measured.defjvp
    def _(problem: Problem, primals: tuple, tangents: tuple) -> Any:
        raise InputError(f"{says}; jax.lax.stop_gradient takes it as a constant")

    return measured


_ONCE = "second derivatives are not available: energy and residuals are differentiable once"
_measured_energy = _without_derivative(_launch_energy, _ONCE)
_measured_residuals = _without_derivative(_launch_residuals, _ONCE)
_projected = _without_derivative(_launch_project, "project has no derivative")


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _energy(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    return _launch_energy(problem, poses, which)[0]


@_energy.defjvp
def _energy_jvp(problem: Problem, primals: tuple, tangents: tuple) -> tuple[jax.Array, jax.Array]:
    """The derivative along a tangent is linear in it, so JAX turns it round for ``grad`` itself."""
    value, gradient = _measured_energy(problem, *primals)
    return value, jnp.sum(gradient * tangents[0], axis=(1, 2))


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _residuals(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    return _launch_residuals(problem, poses, which)[0]


@_residuals.defjvp
def _residuals_jvp(problem: Problem, primals: tuple, tangents: tuple) -> tuple[jax.Array, jax.Array]:
    """Each item moves with its three objects at most."""
    value, slope = _measured_residuals(problem, *primals)
    objects = jnp.maximum(jnp.asarray(problem.item_objects)[primals[1]], 0)  # slopes of missing ones are zero
    moved = jax.vmap(lambda tangent, rows: tangent[rows])(tangents[0], objects)
    return value, jnp.sum(slope * moved, axis=(2, 3))


def _carry(problem: Problem, poses: jax.Array, which: jax.Array, like: jax.Array | None = None) -> jax.Array:
    """`geometry.se2` says the same in NumPy: ``absolute(relative(like, its root), root)``."""
    model, roots = jnp.asarray(problem.home)[which] if like is None else like, jnp.asarray(problem.roots)[which]
    old, new = (jnp.take_along_axis(x, roots[..., None], axis=1) for x in (model, poses))
    turn, d = new[..., 3] - old[..., 3], model - old
    cos, sin = jnp.cos(turn), jnp.sin(turn)
    x = new[..., 0] + cos * d[..., 0] - sin * d[..., 1]
    y = new[..., 1] + sin * d[..., 0] + cos * d[..., 1]
    carried = jnp.stack([x, y, new[..., 2] + d[..., 2], model[..., 3] + turn], axis=-1)
    return jnp.where((roots != jnp.arange(problem.objects))[..., None], carried, poses)


def _free_index(problem: Problem) -> np.ndarray:
    """Where the free coordinates [S, D] stand among all 4 N; 4 N behind a smaller scene's."""
    rows = [np.flatnonzero(free) for free in problem.free]
    index = np.full((len(rows), max(map(len, rows))), 4 * problem.objects, dtype=np.int32)
    for row, found in zip(index, rows, strict=True):
        row[: len(found)] = found
    return index


def _ravel(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    index = jnp.asarray(_free_index(problem))[which]
    return jax.vmap(lambda row, at: row.at[at].get(mode="fill", fill_value=0.0))(poses.reshape(len(poses), -1), index)


def _unravel(problem: Problem, like: jax.Array, which: jax.Array, vector: jax.Array) -> jax.Array:
    index = jnp.asarray(_free_index(problem))[which]
    rows = jax.vmap(lambda row, at, v: row.at[at].set(v, mode="drop"))(like.reshape(len(like), -1), index, vector)
    return _carry(problem, rows.reshape(like.shape), which, like)
