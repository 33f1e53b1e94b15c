"""CMA-ES of evosax: every layout is the mean of a population of its own. It sees energies only."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, NamedTuple

import jax
import jax.numpy as jnp
from evosax.algorithms import CMA_ES

import sceneweaver.jax as swj
from sceneweaver.layout import Problem


class Populations(NamedTuple):
    problem: Problem
    given: jax.Array  # [B, N, 4]
    which: jax.Array  # [B]
    key: jax.Array
    strategy: Any  # CMA-ES's own state, of each layout
    generations: jax.Array  # []


@dataclass(frozen=True)
class CmaEs:
    population: int = 32
    spread: float = 0.2  # standard deviation [m] and [rad] to begin with
    steps: int = 100

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"population": [16, 32, 64], "spread": [0.05, 0.2, 0.5]}

    def init(self, problem: Problem, poses: Any, key: int) -> Populations:
        given = jnp.from_dlpack(poses)
        vector, keys = swj.ravel(problem, given), jax.random.split(jax.random.key(key), len(given) + 1)
        evolution, params = self._evolution(vector.shape[1])
        strategy = jax.vmap(lambda own, mean: evolution.init(own, mean, params))(keys[1:], vector)
        which = jnp.asarray(problem.scene_of(len(given)))
        return Populations(problem, given, which, keys[0], strategy, jnp.zeros((), jnp.int32))

    def _evolution(self, dimensions: int) -> tuple[CMA_ES, Any]:
        evolution = CMA_ES(self.population, jnp.zeros(dimensions))
        return evolution, evolution.default_params.replace(std_init=self.spread)

    @partial(jax.jit, static_argnums=0)
    def step(self, state: Populations) -> Populations:
        evolution, params = self._evolution(state.strategy.mean.shape[1])

        def generation(key: jax.Array, strategy: Any, given: jax.Array, which: jax.Array) -> Any:
            ask, tell = jax.random.split(key)
            population, strategy = evolution.ask(ask, strategy, params)
            layouts = jax.vmap(lambda vector: swj.unravel(state.problem, vector, given, which))(population)
            return evolution.tell(tell, population, swj.energy(state.problem, layouts, which), strategy, params)[0]

        key, own = jax.random.split(state.key)
        strategy = jax.vmap(generation)(
            jax.random.split(own, len(state.given)), state.strategy, state.given, state.which
        )
        return state._replace(key=key, strategy=strategy, generations=state.generations + 1)

    def best(self, state: Populations) -> jax.Array:
        found = state.strategy.best_solution  # not a number before the first generation
        vector = jnp.where(jnp.isnan(found), state.strategy.mean, found)
        return swj.unravel(state.problem, vector, state.given)

    def counts(self, state: Populations) -> tuple[int, int]:
        calls = int(state.generations)
        return calls, calls * self.population * len(state.given)
