"""The functions: shapes are made [B, N, 4], the engine is called, derivatives are said in JAX's own terms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, partial
from math import prod
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import warp as wp
from jax.core import Tracer
from jax.typing import ArrayLike

from sceneweaver.layout import PARAMETER_KINDS, Problem, bits_of
from sceneweaver.scene import InputError

from . import calls
from .measurements import EnergyOf, ProjectionOf, ResidualsOf, measure, nearest

Array = jax.Array | np.ndarray


def energy(
    problem: Problem,
    poses: Array,
    which: ArrayLike | None = None,
    parameters: Mapping[str, Array] | None = None,
) -> jax.Array:
    """Energy [...] float32 [m] of layouts [..., N, 4]: `Problem.energy`, differentiable twice, forwards and backwards.

    The second derivative is a difference of gradients over 1 mm and 1 mrad, at a kink that of one side.

    Args:
        problem: from `sceneweaver.compile`; static under ``jit``.
        poses: x, y, z [m] and yaw [rad], float32.
        which: the scene of each layout, whole numbers that broadcast against the leading dimensions; numbers out of
            range count as the nearest. Left out, [B, N, 4] has equal parts, scene after scene.
        parameters: other values of some kinds of `Problem.parameters`, of the shapes there, for all layouts; the energy
            is differentiable by them as well. A scene is compiled anew for values that were not seen lately.

    Raises:
        InputError: another shape or type of number, or no ``which`` where it takes one; a third derivative.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 8)
        >>> jax.jit(jax.vmap(jax.grad(lambda x: swj.energy(problem, x))))(poses).shape == poses.shape
        True
        >>> by_size = jax.grad(lambda size: swj.energy(problem, poses, parameters={"size": size}).sum())
        >>> by_size(problem.parameters.values["size"]).shape == problem.parameters.values["size"].shape
        True
    """
    return _measured(EnergyOf, problem, poses, which, parameters)[..., 0]


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


def residuals(
    problem: Problem,
    poses: Array,
    which: ArrayLike | None = None,
    parameters: Mapping[str, Array] | None = None,
) -> jax.Array:
    """Residuals [..., M] in metres: `Problem.residuals`; ``jacfwd``, ``jacrev`` and least-squares solvers take it.

    The energy is the sum of their squares over 0.1 m. Arguments, derivatives and errors as for `energy`.

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
    return _measured(ResidualsOf, problem, poses, which, parameters)


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


def project(
    problem: Problem,
    poses: Array,
    which: ArrayLike | None = None,
    parameters: Mapping[str, Array] | None = None,
) -> jax.Array:
    """The feasible layouts [..., N, 4] nearest to poses: `Problem.project`, differentiable once, backwards.

    The derivative is that of the equation that nearest layouts solve, see `Problem.sensitivity`: by the coordinates of
    poses that are free, and by ``parameters``. It is worked out on the host, layout by layout. Arguments and errors as
    for `energy`.

    Examples:
        >>> import jax, sceneweaver as sw, sceneweaver.jax as swj
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = swj.sample(problem, jax.random.key(0), 2)
        >>> near = swj.project(problem, poses)
        >>> bool((swj.energy(problem, near) <= swj.energy(problem, poses)).all())
        True
        >>> walls = problem.parameters.values["outline"]
        >>> north = lambda o: swj.project(problem, poses[:1], parameters={"outline": o})[..., 1].mean()
        >>> bool(jax.numpy.isfinite(jax.grad(north)(walls)).all())
        True
    """
    return _measured(ProjectionOf, problem, poses, which, parameters)


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


def _measured(
    kind: type[EnergyOf | ResidualsOf | ProjectionOf],
    problem: Problem,
    poses: Array,
    which: ArrayLike | None,
    parameters: Mapping[str, Array] | None,
) -> jax.Array:
    """A measurement of layouts, at values of parameters where there are any."""
    kinds, values = _values(problem, parameters)
    of = kind(problem, kinds)

    def flat(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
        u = poses.reshape(len(poses), -1)
        if values is not None:
            u = jnp.concatenate([u, jnp.broadcast_to(values, (len(u), *values.shape))], axis=1)
        return nearest(of, u, which) if isinstance(of, ProjectionOf) else measure(of, u, which)

    return _flat(flat, problem, poses, which)


def _values(problem: Problem, parameters: Mapping[str, Array] | None) -> tuple[int, jax.Array | None]:
    """Values of parameters as an array [F], and the bits of their kinds."""
    if not parameters:
        return 0, None
    unknown = [kind for kind in parameters if kind not in PARAMETER_KINDS]
    if unknown:
        raise InputError(f"parameters: no kind {unknown[0]!r}; there are {', '.join(PARAMETER_KINDS)}")
    kinds = [kind for kind in PARAMETER_KINDS if kind in parameters]
    rows = []
    for kind in kinds:
        shape = problem.parameters.values[kind].shape
        given = jnp.asarray(parameters[kind], dtype=jnp.float32)
        if given.shape != shape:
            raise InputError(f"parameters: {kind} is an array of shape {given.shape}; give {shape}")
        rows.append(_placed(problem, given).ravel())
    return bits_of(kinds), jnp.concatenate(rows)


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
def _launch_feasible(problem: Problem, poses: jax.Array, which: jax.Array) -> jax.Array:
    return calls.call(calls.feasible, problem, poses, which, output_dims=poses.shape[:1])[0]


@_static
def _launch_sample(problem: Problem, rng: jax.Array, which: jax.Array) -> jax.Array:
    return calls.call(calls.sample, problem, rng, which, output_dims=(len(rng), problem.objects))[0]


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _measured_energy(problem: Problem, poses: jax.Array, which: jax.Array) -> tuple[jax.Array, jax.Array]:
    energies, gradients = EnergyOf(problem).measured(poses.reshape(len(poses), -1), which)
    return energies[:, 0], gradients.reshape(poses.shape)


@_measured_energy.defjvp
def _(problem: Problem, primals: tuple, tangents: tuple) -> Any:
    raise InputError("energy_and_grad has no derivative; take those of energy, or jax.lax.stop_gradient of it")


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
