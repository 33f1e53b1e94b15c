"""OpenAI-ES (Salimans, Ho, Chen, Sidor and Sutskever 2017) of evosax (Lange 2022, Apache 2.0), with Adam.

Every layout is the mean of a population of its own, moved along the gradient that antithetic samples estimate from the
ranks of their energies.

Fairness: it sees energies alone, of bodies as they are and any yaw, in one call a generation on the problem's device;
neither gradients nor the verdict, and no objectives.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import jax.numpy as jnp
import optax
from evosax.algorithms import Open_ES

from .evosax_cma import CmaEs


@dataclass(frozen=True)
class OpenEs(CmaEs):
    rate: float = 0.05  # of Adam
    spread: float = 0.05  # standard deviation [m] and [rad] to begin with; falls to a tenth
    steps: int = 300

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "population": [16, 32, 64],
        "spread": [0.02, 0.05, 0.1],
        "rate": [0.02, 0.05, 0.1],
    }

    def _evolution(self, dimensions: int) -> tuple[Any, Any]:
        spread = optax.exponential_decay(self.spread, self.steps, 0.1)
        rule = optax.adam(self.rate)
        evolution = Open_ES(self.population, jnp.zeros(dimensions), optimizer=rule, std_schedule=spread)
        return evolution, evolution.default_params
