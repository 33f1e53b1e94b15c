"""The interface that every optimiser shares, and the registry of those there are."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple, Protocol, TypeVar, cast, runtime_checkable

import numpy as np
import warp as wp

from .batch import Batch

GRACE = 0.3
"""Seconds beyond the deadline, or from its own start on, that a run has to come to an end by itself; then its kernels
break off."""

Moment = float | Callable[[], float]
"""A time by ``time.monotonic()`` [s], or what tells it, where it may come earlier than was thought."""

Start = str
"""Where an optimiser begins: "given": at the batch's poses, to move little; "random": anywhere; "sample": drawn from
the relations; "drawn": at the batch's poses, as at ones that it had drawn itself."""


@dataclass
class Monitor:
    """Reports progress and says when time is up. Shared by the threads of a run.

    ``cut`` [1] int32, on the host, is what kernels on a CPU look at in their loops: from 1 on they break off.
    """

    total: int
    deadline: Moment | None = None
    report: Callable[[int, int, int, float], None] | None = None
    done: int = 0
    valid: int = 0
    best: float = float("inf")
    timed_out: bool = False
    _last: float = field(default=0.0, repr=False)
    _cut: np.ndarray = field(default_factory=lambda: np.zeros(1, dtype=np.int32), repr=False)

    @property
    def end(self) -> float:
        """The deadline by ``time.monotonic()`` [s]; infinite without one."""
        if self.deadline is None:
            return math.inf
        return self.deadline() if callable(self.deadline) else self.deadline

    @cached_property
    def cut(self) -> wp.array:
        """What kernels on a CPU look at."""
        return wp.array(self._cut, dtype=wp.int32, device="cpu", copy=False)

    @property
    def broken_off(self) -> bool:
        """Whether kernels break off."""
        return bool(self._cut[0])

    def expired(self) -> bool:
        """True once the deadline has passed; remembered."""
        if time.monotonic() > self.end:
            self.timed_out = True
        return self.timed_out

    def watch(self, began: float) -> None:
        """Break off kernels when time was up `GRACE` seconds ago, of a run that began then; called again and again."""
        if self.expired() and time.monotonic() > max(self.end, began) + GRACE:
            self.break_off()

    def break_off(self) -> None:
        """End all that is under way, now."""
        self.timed_out = True
        self._cut[0] = 1

    def inner(self, total: int) -> Monitor:
        """One of a part of the run, which ends with it and reports to nobody."""
        return Monitor(total, self.deadline, _cut=self._cut)

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


class Checkpoint(NamedTuple):
    """What there is to see between two blocks of a run.

    ``best()`` gives the best poses [B, N] (vec4) so far, to be read before the next block and never written; the run
    goes on unharmed. ``energies`` are those measured of each candidate so far, see docs/engine.md.
    """

    best: Callable[[], wp.array]
    energies: int


Blocks = Generator[Checkpoint, None, OptimizerResult]
"""A run in blocks that no host looks into; its end gives the batch the best poses, and the result."""


_Result = TypeVar("_Result")


def to_the_end(blocks: Generator[Checkpoint, None, _Result]) -> _Result:
    """Go through what is left of a run."""
    while True:
        try:
            next(blocks)
        except StopIteration as end:
            return end.value


Solve = Callable[[Batch, Start, int | None, Monitor], OptimizerResult]
"""``solve(batch, start, budget, monitor)`` moves the batch's poses in place; budget in its own work units."""


@runtime_checkable
class Optimizer(Protocol):
    """What the registry holds, and what an optimiser of your own has to be."""

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The modules of ``sceneweaver.kernels`` that it launches on a device, to compile ahead; may be empty."""
        ...

    def __call__(self, batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
        """Move the batch's poses [B, N, 4] in place.

        Args:
            batch: candidates of one or several problems, on one device. On a CPU it is called from several threads,
                each with a part of the candidates; a candidate's result must not depend on the others.
            start: whether to begin at the batch's poses, or where (`starts.draw_starts` draws).
            budget: in work units of its own; None: its default.
            monitor: to report to, and to ask whether time is up.

        Returns:
            The energy of every candidate's final poses.
        """
        ...


@dataclass(frozen=True)
class FunctionOptimizer:
    """An optimiser that is a function, with the kernel modules that it launches."""

    solve: Solve
    modules: tuple[str, ...]
    on_gpu: tuple[str, ...]

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The modules that it launches on a device."""
        return self.modules if device == "cpu" else self.on_gpu

    def __call__(self, batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
        """Move the batch's poses in place."""
        return self.solve(batch, start, budget, monitor)


@dataclass(frozen=True)
class BlockOptimizer:
    """An optimiser that runs in blocks, with the kernel modules that it launches.

    ``blocks(batch, start, budget, monitor, whole)`` is its run; ``whole``: no checkpoints are wanted, and blocks may be
    as long as they like.
    """

    blocks: Callable[[Batch, Start, int | None, Monitor, bool], Blocks]
    modules: tuple[str, ...]
    on_gpu: tuple[str, ...]

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The modules that it launches on a device."""
        return self.modules if device == "cpu" else self.on_gpu

    def __call__(self, batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
        """Move the batch's poses in place."""
        return to_the_end(self.blocks(batch, start, budget, monitor, True))


OPTIMIZERS: dict[str, Optimizer] = {}

_Entered = TypeVar("_Entered", bound=Solve)


def register(
    name: str, modules: tuple[str, ...] | None = None, on_gpu: tuple[str, ...] | None = None
) -> Callable[[_Entered], _Entered]:
    """Enter an optimiser under a name: one that is an `Optimizer`, or a function.

    For a function ``modules`` of ``kernels`` hold its kernels (default: the one of its name), ``on_gpu`` those that it
    launches on a GPU (default: the same).
    """

    def enter(solve: _Entered) -> _Entered:
        own = modules if modules is not None else (name,)
        whole = hasattr(solve, "modules_on")
        OPTIMIZERS[name] = cast(Optimizer, solve) if whole else FunctionOptimizer(solve, own, on_gpu or own)
        return solve

    return enter


RunInBlocks = Callable[[Batch, Start, int | None, Monitor, bool], Blocks]


def register_blocks(
    name: str, modules: tuple[str, ...], on_gpu: tuple[str, ...] | None = None
) -> Callable[[RunInBlocks], RunInBlocks]:
    """Enter an optimiser that runs in blocks; arguments as for `register`, see `BlockOptimizer`."""

    def enter(blocks: RunInBlocks) -> RunInBlocks:
        OPTIMIZERS[name] = BlockOptimizer(blocks, modules, on_gpu or modules)
        return blocks

    return enter
