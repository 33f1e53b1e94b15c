"""Energy, residuals and projection as functions of coordinates [B, U]: poses, then values of parameters."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp

from sceneweaver.layout import Problem
from sceneweaver.scene import InputError

from . import calls
from .products import push

_static = partial(jax.jit, static_argnums=0)  # without it each call from outside of jit would be compiled anew


@dataclass(frozen=True)
class Coordinates:
    """What the coordinates of a problem are: the poses, and values of some kinds of parameters (bits; 0: none)."""

    problem: Problem
    kinds: int = 0

    def taken(self, u: jax.Array) -> tuple[jax.Array, jax.Array]:
        """Poses [B, N, 4] and values [B, F]."""
        size = 4 * self.problem.objects
        return u[:, :size].reshape(-1, self.problem.objects, 4), u[:, size:]

    def call(self, function: Any, u: jax.Array, which: jax.Array, *more: jax.Array, dims: Any) -> tuple:
        """A call of one of `calls` that takes values."""
        poses, values = self.taken(u)
        return calls.call(function, self.problem, poses, which, values, *more, output_dims=dims, kinds=self.kinds)


@dataclass(frozen=True)
class EnergyOf(Coordinates):
    """The energy [B, 1]; what is known of a place is the gradient [B, U]."""

    def hint(self, u: jax.Array, which: jax.Array) -> jax.Array:
        """The gradient."""
        return self.measured(u, which)[1]

    @_static
    def measured(self, u: jax.Array, which: jax.Array) -> tuple[jax.Array, jax.Array]:
        """Value and hint."""
        poses, values = self.taken(u)
        count, objects = poses.shape[:2]
        if not self.kinds:
            dims = {"energy": (count,), "gradient": (count, objects)}
            energy, gradient = calls.call(calls.energy, self.problem, poses, which, output_dims=dims)
            return energy[:, None], gradient.reshape(count, -1)
        dims = {"energy": (count,), "gradient": (count, objects), "slope": values.shape}
        energy, gradient, slope = self.call(calls.energy_with, u, which, dims=dims)
        return energy[:, None], jnp.concatenate([gradient.reshape(count, -1), slope], axis=1)

    def push(self, u: jax.Array, which: jax.Array, hint: jax.Array, v: jax.Array) -> jax.Array:
        """The derivative along a movement [B, 1]."""
        return jnp.sum(hint * v, axis=1, keepdims=True)

    def pull(self, u: jax.Array, which: jax.Array, hint: jax.Array, w: jax.Array) -> jax.Array:
        """The weighted gradient [B, U]."""
        return w * hint


@dataclass(frozen=True)
class ResidualsOf(Coordinates):
    """The residuals [B, M]; what is known of a place is their derivatives [B, M, 3, 4] by an item's objects."""

    def hint(self, u: jax.Array, which: jax.Array) -> jax.Array:
        """The derivatives."""
        return self.measured(u, which)[1]

    @_static
    def measured(self, u: jax.Array, which: jax.Array) -> tuple[jax.Array, jax.Array]:
        """Value and hint."""
        poses, items = self.taken(u)[0], self.problem.items
        dims = {"residual": (len(poses), items), "slope": (len(poses), items, 3)}
        if self.kinds:
            residual, slope = self.call(calls.residuals_with, u, which, dims=dims)
        else:
            residual, slope = calls.call(calls.residuals, self.problem, poses, which, output_dims=dims)
        return residual, slope

    def push(self, u: jax.Array, which: jax.Array, hint: jax.Array, v: jax.Array) -> jax.Array:
        """Their change along a movement [B, M]: each moves with its three objects at most."""
        moves, along = self.taken(v)
        moved = jax.vmap(lambda move, rows: move[rows])(moves, self._objects(which))
        change = jnp.sum(hint * moved, axis=(2, 3))
        if not self.kinds:
            return change
        return change + self.call(calls.residuals_along, u, which, along, dims=change.shape)[0]

    def pull(self, u: jax.Array, which: jax.Array, hint: jax.Array, w: jax.Array) -> jax.Array:
        """The gradient of their weighted sum [B, U]."""
        poses, values = self.taken(u)
        shares = w[:, :, None, None] * hint
        added = jax.vmap(lambda zero, rows, share: zero.at[rows].add(share))
        pulled = added(jnp.zeros_like(poses), self._objects(which), shares).reshape(len(poses), -1)
        if not self.kinds:
            return pulled
        return jnp.concatenate([pulled, self.call(calls.residuals_pulled, u, which, w, dims=values.shape)[0]], axis=1)

    def _objects(self, which: jax.Array) -> jax.Array:
        """The objects of items [B, M, 3]; slopes of missing ones are zero."""
        return jnp.maximum(jnp.asarray(self.problem.item_objects)[which], 0)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def measure(of: EnergyOf | ResidualsOf, u: jax.Array, which: jax.Array) -> jax.Array:
    """The measurement [B, M], differentiable twice."""
    return of.measured(u, which)[0]


@measure.defjvp
def _measure_jvp(of: EnergyOf | ResidualsOf, primals: tuple, tangents: tuple) -> tuple[jax.Array, jax.Array]:
    """The derivative along a tangent is linear in it, so JAX turns it round for ``grad`` itself."""
    u, which = primals
    still = jax.lax.stop_gradient(u)
    _, hint = of.measured(still, which)
    return measure(of, u, which), push(of, u, which, hint, tangents[0])


@dataclass(frozen=True)
class ProjectionOf(Coordinates):
    """The nearest feasible poses [B, N, 4]."""

    @_static
    def measured(self, u: jax.Array, which: jax.Array) -> jax.Array:
        """The poses."""
        poses = self.taken(u)[0]
        if self.kinds:
            return self.call(calls.project_with, u, which, dims=poses.shape[:2])[0]
        return calls.call(calls.project, self.problem, poses, which, output_dims=poses.shape[:2])[0]

    @_static
    def pulled(self, u: jax.Array, which: jax.Array, nearest: jax.Array, up: jax.Array) -> jax.Array:
        """The gradient [B, U] of projected poses weighted by ``up`` [B, N, 4]."""
        poses, values = self.taken(u)
        dims = {"by_poses": poses.shape[:2], "by_values": values.shape}
        if self.kinds:
            by_poses, by_values = self.call(calls.projection_pulled, u, which, nearest, up, dims=dims)
            return jnp.concatenate([by_poses.reshape(len(poses), -1), by_values], axis=1)
        dims["by_values"] = (len(poses), 1)
        spare = jnp.zeros((len(poses), 1), dtype=jnp.float32)
        arguments = (poses, which, spare, nearest, up)
        by_poses, _ = calls.call(calls.projection_pulled, self.problem, *arguments, output_dims=dims, kinds=0)
        return by_poses.reshape(len(poses), -1)


@partial(jax.custom_vjp, nondiff_argnums=(0,))
def nearest(of: ProjectionOf, u: jax.Array, which: jax.Array) -> jax.Array:
    """Projected poses, with a derivative backwards by the implicit function theorem."""
    return of.measured(u, which)


def _nearest_fwd(of: ProjectionOf, u: jax.Array, which: jax.Array) -> tuple[jax.Array, tuple]:
    found = of.measured(jax.lax.stop_gradient(u), which)  # `_once` refuses a second derivative
    return found, (u, which, found)


def _nearest_bwd(of: ProjectionOf, kept: tuple, up: jax.Array) -> tuple[jax.Array, None]:
    u, which, found = kept
    return _once(of, u, which, found, up), None


nearest.defvjp(_nearest_fwd, _nearest_bwd)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _once(of: ProjectionOf, u: jax.Array, which: jax.Array, found: jax.Array, up: jax.Array) -> jax.Array:
    return of.pulled(u, which, found, up)


@_once.defjvp
def _(of: ProjectionOf, primals: tuple, tangents: tuple) -> Any:
    raise InputError("second derivatives of project are not available; jax.lax.stop_gradient takes it as a constant")
