"""Optimisers that are an update rule on the descent that they share: Adam, and annealed Langevin dynamics."""

from __future__ import annotations

from sceneweaver.kernels.descent import ADAM, LANGEVIN, UpdateRule

from .base import Blocks, Monitor, Start, register_blocks
from .batch import Batch
from .descent import MEASURED, MEASURED_ON_GPU, Settings, descend, outcome
from .starts import draw_starts

STEPS = 400


def register_rule(name: str, rule: UpdateRule, given: Settings, drawn: Settings) -> None:
    """Enter a descent by a rule: ``given`` are the settings from given poses, ``drawn`` those from drawn ones.

    A budget is a number of steps, one energy each; every candidate ends at the lowest energy that it passed.
    """

    @register_blocks(name, (*MEASURED, "descent"), (*MEASURED_ON_GPU, "descent"))
    def blocks(batch: Batch, start: Start, budget: int | None, monitor: Monitor, whole: bool) -> Blocks:
        draw_starts(batch, start)
        schedule = (given if start == "given" else drawn).schedule(budget or STEPS)
        return outcome(batch, (yield from descend(batch, rule, schedule, monitor, whole)), monitor)


register_rule(
    "adam",
    ADAM,
    given=Settings(rate=0.04, rate_end=0.0005, noise=0.01, quiet=0.6),
    drawn=Settings(rate=0.12, rate_end=0.0005, noise=0.06, quiet=0.6),
)
register_rule(
    "langevin",
    LANGEVIN,
    given=Settings(rate=0.05, rate_end=0.0005, noise=0.003, quiet=0.6),
    drawn=Settings(rate=0.15, rate_end=0.0005, noise=0.1, quiet=0.7),
)
