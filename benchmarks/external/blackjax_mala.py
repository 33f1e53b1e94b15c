"""MALA of blackjax: samples layouts by exp(-energy / temperature), and keeps the lowest energy that it passes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, NamedTuple

import blackjax
import jax
import jax.numpy as jnp

import sceneweaver.jax as swj
from sceneweaver.layout import Problem

INNER = 20  # draws in a step


class Chains(NamedTuple):
    problem: Problem
    given: jax.Array  # [B, N, 4]
    which: jax.Array  # [B]
    key: jax.Array
    chain: Any  # position [B, D], log density [B] and its gradient
    best: jax.Array  # [B, D]
    highest: jax.Array  # [B]
    draws: jax.Array  # []


@dataclass(frozen=True)
class Mala:
    temperature: float = 0.02  # [m], in units of the energy
    step_size: float = 2e-4
    steps: int = 20

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"temperature": [0.005, 0.02, 0.1], "step_size": [5e-5, 2e-4, 1e-3]}

    def init(self, problem: Problem, poses: Any, key: int) -> Chains:
        given = jnp.from_dlpack(poses)
        which, vector = jnp.asarray(problem.scene_of(len(given))), swj.ravel(problem, given)
        chain = jax.vmap(lambda v, *args: self._sampler(problem, *args).init(v))(vector, given, which)
        lowest = chain.logdensity
        return Chains(problem, given, which, jax.random.key(key), chain, vector, lowest, jnp.zeros((), jnp.int32))

    def _sampler(self, problem: Problem, given: jax.Array, which: jax.Array) -> blackjax.SamplingAlgorithm:
        def log_density(vector: jax.Array) -> jax.Array:
            return -swj.energy(problem, swj.unravel(problem, vector, given, which), which) / self.temperature

        return blackjax.mala(log_density, self.step_size)

    @partial(jax.jit, static_argnums=0)
    def step(self, state: Chains) -> Chains:
        def draw(key: jax.Array, chain: Any, *args: jax.Array) -> Any:
            return self._sampler(state.problem, *args).step(key, chain)[0]

        def one(state: Chains, _: None) -> tuple[Chains, None]:
            key, own = jax.random.split(state.key)
            keys = jax.random.split(own, len(state.given))
            chain = jax.vmap(draw)(keys, state.chain, state.given, state.which)
            better = chain.logdensity > state.highest
            best = jnp.where(better[:, None], chain.position, state.best)
            highest = jnp.maximum(chain.logdensity, state.highest)
            return state._replace(key=key, chain=chain, best=best, highest=highest, draws=state.draws + 1), None

        return jax.lax.scan(one, state, None, length=INNER)[0]

    def best(self, state: Chains) -> jax.Array:
        return swj.unravel(state.problem, state.best, state.given)

    def counts(self, state: Chains) -> tuple[int, int]:
        return int(state.draws) + 1, (int(state.draws) + 1) * len(state.given)
