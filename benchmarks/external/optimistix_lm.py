"""Levenberg-Marquardt of optimistix on the residuals of roots, each layout on its own."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import optimistix as optx

import sceneweaver.jax as swj
from sceneweaver.layout import Problem

from .optimistix_bfgs import Descent, begin


@dataclass(frozen=True)
class LevenbergMarquardt:
    steps: int = 33
    iterations: int = 3  # in a step, after which the damping begins anew; a longer step is over when the budget is

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"iterations": [3, 10, 30]}

    def init(self, problem: Problem, poses: Any, key: int) -> Descent:
        return begin(problem, poses)

    @partial(jax.jit, static_argnums=0)
    def step(self, state: Descent) -> Descent:
        def residuals(vector: jax.Array, args: tuple[jax.Array, jax.Array]) -> jax.Array:
            return swj.residuals(state.problem, swj.unravel(state.problem, vector, *args), args[1])

        def descend(vector: jax.Array, *args: jax.Array) -> tuple[jax.Array, jax.Array]:
            solver = optx.LevenbergMarquardt(rtol=1e-4, atol=1e-5)
            found = optx.least_squares(residuals, solver, vector, args, max_steps=self.iterations, throw=False)
            before, after = (jnp.sum(residuals(v, args) ** 2) for v in (vector, found.value))
            return jnp.where(after < before, found.value, vector), found.stats["num_steps"]

        vector, iterations = jax.vmap(descend)(state.vector, state.given, state.which)
        return state._replace(vector=vector, calls=state.calls + jnp.max(iterations) + 2)

    def best(self, state: Descent) -> jax.Array:
        return swj.unravel(state.problem, state.vector, state.given)

    def counts(self, state: Descent) -> tuple[int, int]:
        return int(state.calls), int(state.calls) * len(state.given)
