"""Adam of optax on the energy of roots, with the noise and the schedule of `optimizer="adam"` from drawn starts."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import optax

import sceneweaver.jax as swj
from sceneweaver.layout import Problem

INNER = 20  # steps of Adam in one of the protocol


class Walk(NamedTuple):
    problem: Problem
    given: jax.Array  # [B, N, 4]
    scale: jax.Array  # [B, D]: 1 [m], of yaw how far an object's edge goes in a turn of one radian, about
    vector: jax.Array  # [B, D]: free coordinates by their scale
    adam: Any
    key: jax.Array
    best: jax.Array  # [B, D]
    lowest: jax.Array  # [B]
    steps: jax.Array  # []


@dataclass(frozen=True)
class OptaxAdam:
    rate: float = 0.12  # [m] at the start; falls to a hundredth
    noise: float = 0.06  # [m] standard deviation at the start; falls to zero at 60 % of the steps
    steps: int = 20

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"rate": [0.03, 0.12, 0.3], "noise": [0.0, 0.06, 0.2]}

    @property
    def rule(self) -> optax.GradientTransformation:
        rate = optax.cosine_decay_schedule(self.rate, INNER * self.steps, alpha=0.005)
        return optax.adam(rate, b2=0.99, eps=1e-6)

    def init(self, problem: Problem, poses: Any, key: int) -> Walk:
        given = jnp.from_dlpack(poses)
        arms = [[(1, 1, 1, 0.15 * np.hypot(*o.size[:2]) + 0.05) for o in each.objects] for each in problem.metadata]
        filled = [np.pad(np.array(arm), ((0, problem.objects - len(arm)), (0, 0))) for arm in arms]
        scale = swj.ravel(problem, jnp.asarray(filled, jnp.float32)[problem.scene_of(len(given))])
        vector = scale * swj.ravel(problem, given)
        adam, lowest = self.rule.init(vector), jnp.full(len(given), jnp.inf, dtype=jnp.float32)
        return Walk(problem, given, scale, vector, adam, jax.random.key(key), vector, lowest, jnp.zeros((), jnp.int32))

    @partial(jax.jit, static_argnums=0)
    def step(self, state: Walk) -> Walk:
        def energies(vector: jax.Array) -> tuple[jax.Array, jax.Array]:
            each = swj.energy(state.problem, self._layouts(state, vector))
            return jnp.sum(each), each

        def one(walk: Walk, _: None) -> tuple[Walk, None]:
            (_, energy), gradient = jax.value_and_grad(energies, has_aux=True)(walk.vector)
            better = energy < walk.lowest
            best = jnp.where(better[:, None], walk.vector, walk.best)
            update, adam = self.rule.update(gradient, walk.adam)
            noise = self.noise * jnp.maximum(0.0, 1 - walk.steps / (0.6 * INNER * self.steps))
            update += noise * jax.random.normal(jax.random.fold_in(walk.key, walk.steps), update.shape)
            lowest = jnp.minimum(energy, walk.lowest)
            walk = walk._replace(vector=walk.vector + update, adam=adam, best=best, lowest=lowest, steps=walk.steps + 1)
            return walk, None

        return jax.lax.scan(one, state, None, length=INNER)[0]

    def best(self, state: Walk) -> jax.Array:
        return self._layouts(state, state.best)

    def _layouts(self, state: Walk, vector: jax.Array) -> jax.Array:
        return swj.unravel(state.problem, vector / jnp.maximum(state.scale, 0.05), state.given)

    def counts(self, state: Walk) -> tuple[int, int]:
        return int(state.steps), int(state.steps) * len(state.given)
