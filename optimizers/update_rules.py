"""Optimisers that are an update rule on the descent that they share: Adam, and annealed Langevin dynamics."""

from __future__ import annotations

from dataclasses import dataclass

from sceneweaver.kernels.descent import ADAM, LANGEVIN, UpdateRule

from .base import Monitor, OptimizerResult, Start, register
from .batch import Batch
from .descent import MEASURED, MEASURED_ON_GPU, Settings, descend, outcome
from .starts import draw_starts


@dataclass(frozen=True)
class Descent:
    """Steps by an update rule; every candidate ends at the lowest energy that it passed.

    ``given`` are the settings from given poses, ``drawn`` those from drawn ones; ``steps`` is the default budget.
    """

    rule: UpdateRule
    given: Settings
    drawn: Settings
    steps: int = 400

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The kernel modules that it launches on a device."""
        return (*(MEASURED if device == "cpu" else MEASURED_ON_GPU), "descent")

    def __call__(self, batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
        """Refine every candidate by ``budget`` steps."""
        draw_starts(batch, start)
        schedule = (self.given if start == "given" else self.drawn).schedule(budget or self.steps)
        return outcome(batch, descend(batch, self.rule, schedule, monitor), monitor)


register("adam")(
    Descent(
        ADAM,
        given=Settings(rate=0.04, rate_end=0.0005, noise=0.01, quiet=0.6),
        drawn=Settings(rate=0.12, rate_end=0.0005, noise=0.06, quiet=0.6),
    )
)
register("langevin")(
    Descent(
        LANGEVIN,
        given=Settings(rate=0.05, rate_end=0.0005, noise=0.003, quiet=0.6),
        drawn=Settings(rate=0.15, rate_end=0.0005, noise=0.1, quiet=0.7),
    )
)
