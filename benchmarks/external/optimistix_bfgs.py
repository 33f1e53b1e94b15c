"""BFGS of optimistix on the energy of roots, each layout on its own; begun anew at the start of every step."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, NamedTuple

import jax
import jax.numpy as jnp
import optimistix as optx

import sceneweaver.jax as swj
from sceneweaver.layout import Problem


class Descent(NamedTuple):
    problem: Problem
    given: jax.Array  # [B, N, 4]
    which: jax.Array  # [B]
    vector: jax.Array  # [B, D]
    calls: jax.Array  # []


def begin(problem: Problem, poses: Any) -> Descent:
    """At poses as given."""
    given = jnp.from_dlpack(poses)
    which = jnp.asarray(problem.scene_of(len(given)))
    return Descent(problem, given, which, swj.ravel(problem, given), jnp.zeros((), jnp.int32))


@dataclass(frozen=True)
class Bfgs:
    steps: int = 20
    iterations: int = 20  # of BFGS in a step

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"iterations": [5, 20, 50]}

    def init(self, problem: Problem, poses: Any, key: int) -> Descent:
        return begin(problem, poses)

    @partial(jax.jit, static_argnums=0)
    def step(self, state: Descent) -> Descent:
        def energy(vector: jax.Array, args: tuple[jax.Array, jax.Array]) -> jax.Array:
            return swj.energy(state.problem, swj.unravel(state.problem, vector, *args), args[1])

        def descend(vector: jax.Array, *args: jax.Array) -> tuple[jax.Array, jax.Array]:
            solver = optx.BFGS(rtol=1e-4, atol=1e-5)
            found = optx.minimise(energy, solver, vector, args, max_steps=self.iterations, throw=False)
            better = energy(found.value, args) < energy(vector, args)
            return jnp.where(better, found.value, vector), found.stats["num_steps"]

        vector, iterations = jax.vmap(descend)(state.vector, state.given, state.which)
        return state._replace(vector=vector, calls=state.calls + jnp.max(iterations) + 2)

    def best(self, state: Descent) -> jax.Array:
        return swj.unravel(state.problem, state.vector, state.given)

    def counts(self, state: Descent) -> tuple[int, int]:
        return int(state.calls), int(state.calls) * len(state.given)
