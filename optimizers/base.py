"""The interface that every optimiser shares, and the registry of those there are."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from .batch import Batch

Start = str  # "given": from the batch's poses; "random": anywhere; "sample": drawn from the relations


@dataclass
class Monitor:
    """Reports progress and says when time is up. Shared by the threads of a run."""

    total: int
    deadline: float | None = None
    report: Callable[[int, int, int, float], None] | None = None
    done: int = 0
    valid: int = 0
    best: float = float("inf")
    timed_out: bool = False
    _last: float = field(default=0.0, repr=False)

    def expired(self) -> bool:
        """True once the deadline has passed; remembered."""
        if self.deadline is not None and time.monotonic() > self.deadline:
            self.timed_out = True
        return self.timed_out

    @property
    def watched(self) -> bool:
        """True when someone wants to hear of progress or to cut the run off."""
        return self.deadline is not None or self.report is not None

    def add(self, done: int, valid: int, best: float) -> None:
        """Candidates finished, how many of them valid, and the lowest energy seen."""
        self.done += done
        self.valid += valid
        self.best = min(self.best, best)
        now = time.monotonic()
        if self.report is not None and (now - self._last > 0.1 or self.done >= self.total):
            self._last = now
            self.report(self.done, self.total, self.valid, self.best)


@dataclass
class OptimizerResult:
    """What an optimiser leaves besides the poses in the batch: energy [B] float32 (lowest total found)."""

    energy: np.ndarray


Solve = Callable[[Batch, Start, int | None, Monitor], OptimizerResult]
"""``solve(batch, start, budget, monitor)`` moves the batch's poses in place; budget in its own work units."""


@dataclass(frozen=True)
class Optimizer:
    """An entry of the registry: the function, and the kernel modules that it launches, to compile ahead."""

    solve: Solve
    modules: tuple[str, ...]
    on_gpu: tuple[str, ...]

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The modules that it launches on a device."""
        return self.modules if device == "cpu" else self.on_gpu

    def __call__(self, batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
        """Move the batch's poses in place."""
        return self.solve(batch, start, budget, monitor)


OPTIMIZERS: dict[str, Optimizer] = {}


def register(
    name: str, modules: tuple[str, ...] | None = None, on_gpu: tuple[str, ...] | None = None
) -> Callable[[Solve], Solve]:
    """Enter an optimiser under a name; ``modules`` of ``kernels`` hold its kernels (default: the one of its name),
    ``on_gpu`` those that it launches on a GPU (default: the same)."""

    def enter(solve: Solve) -> Solve:
        own = modules or (name,)
        OPTIMIZERS[name] = Optimizer(solve, own, on_gpu or own)
        return solve

    return enter
