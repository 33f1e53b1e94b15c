"""The families of benchmarks: each a function from settings and judge to a result."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from benchmarks.judging import Judge
from benchmarks.results import Result
from benchmarks.settings import Settings

from . import (
    ablations,
    by_model,
    choice,
    cold,
    critic,
    derivatives,
    design,
    edits,
    environments,
    field_repair,
    home_requests,
    jax_calls,
    large,
    live,
    looks,
    memory,
    navigation,
    objectives,
    odd,
    openable,
    optimizers,
    patterns,
    physics,
    pictures,
    plans,
    prior,
    projection,
    quality,
    requests,
    scaling,
    soft_rows,
    soundness,
    stability,
    throughput,
    tight,
    variables,
    variety,
    weights,
)

Family = Callable[[Settings, Judge], Result]

FAMILIES: Mapping[str, Family] = MappingProxyType(
    {
        "quality": quality.run,
        "optimizers": optimizers.run,
        "throughput": throughput.run,
        "large": large.run,
        "cold": cold.run,
        "scaling": scaling.run,
        "memory": memory.run,
        "soundness": soundness.run,
        "field_repair": field_repair.run,
        "edits": edits.run,
        "live": live.run,
        "tight": tight.run,
        "soft_rows": soft_rows.run,
        "weights": weights.run,
        "projection": projection.run,
        "design": design.run,
        "critic": critic.run,
        "looks": looks.run,
        "patterns": patterns.run,
        "choice": choice.run,
        "objectives": objectives.run,
        "variables": variables.run,
        "ablations": ablations.run,
        "variety": variety.run,
        "prior": prior.run,
        "jax": jax_calls.run,
        "derivatives": derivatives.run,
        "requests": requests.run,
        "home_requests": home_requests.run,
        "odd": odd.run,
        "by_model": by_model.run,
        "physics": physics.run,
        "environments": environments.run,
        "navigation": navigation.run,
        "stability": stability.run,
        "openable": openable.run,
        "pictures": pictures.run,
        "plans": plans.run,
    }
)

__all__ = ["FAMILIES", "Family"]
