"""Optimisers of one's own: what they have to be, how they are found, and the loop that runs them."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from importlib.metadata import entry_points
from typing import Any, Protocol, cast, runtime_checkable

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import OPTIMIZERS, Batch, Monitor, OptimizerResult, streams
from sceneweaver.optimizers.base import BlockOptimizer, Checkpoint, RunInBlocks
from sceneweaver.optimizers.descent import MEASURED, MEASURED_ON_GPU
from sceneweaver.optimizers.run import cpu_threads, pieces
from sceneweaver.optimizers.starts import draw_starts
from sceneweaver.scene import InputError

from .arrays import Array, handed_out, poses_from
from .pack import PULL, weights
from .problem import Problem

GROUP = "sceneweaver.optimizers"  # of entry points
STEPS = 200  # unless the optimiser says or is told how many


@runtime_checkable
class StepOptimizer(Protocol):
    """An optimiser of one's own. It sees a `Problem` and poses, and keeps what it likes in a state of its own.

    An attribute ``steps`` says how many steps a run takes by default; without it, or where it is None, a run takes 200.
    A method ``counts(state)`` may say how many energy calls and evaluations (layouts measured) the run has cost so far,
    for `sceneweaver bench`; without it those that go through the problem are counted.
    """

    def init(self, problem: Problem, poses: Array, key: int) -> Any:
        """The state before the first step.

        Args:
            problem: of one or several scenes; the poses are equal parts of them, scene after scene.
            poses: [B, N, 4] float32 to begin with, a Warp array on the problem's device, for the optimiser to keep.
            key: the run's seed.
        """
        ...

    def step(self, state: Any) -> Any:
        """The state after one more step."""
        ...

    def best(self, state: Any) -> Array:
        """The best poses [B, N, 4] so far: NumPy, Warp, or an array with DLPack.

        Only coordinates in ``problem.free`` are taken from it; what is carried goes along with its root.
        """
        ...


class BuiltInRun:
    """A run of a built-in optimiser under way: on a CPU in pieces, which threads take on side by side."""

    def __init__(self, batch: Batch, blocks: RunInBlocks, start: str, budget: int | None) -> None:
        """Begin at the batch's poses."""
        self.batch, self.energies, self.done = batch, 0, not (batch.size and batch.objects)
        self._parts = [] if self.done else pieces(batch)
        self._runs = [blocks(part, start, budget, Monitor(part.size), False) for part in self._parts]
        self._last: list[Checkpoint | None] = [None] * len(self._parts)
        self._left = list(range(len(self._parts)))

    def advance(self) -> None:
        """Take every piece on to its next checkpoint, or to its end."""
        with wp.ScopedDevice(self.batch.device):
            if self.energies == 0:  # the first alone: it compiles what is not compiled yet
                ended = [self._next(k) for k in self._left]
            else:
                with ThreadPoolExecutor(cpu_threads()) as pool:
                    ended = list(pool.map(self._next, self._left))
        self._left = [k for k, end in zip(self._left, ended, strict=True) if not end]
        self.energies = max((last.energies for last in self._last if last is not None), default=1)
        self.done = not self._left

    def _next(self, k: int) -> bool:
        """Whether piece k has come to its end, where the batch has its best poses."""
        last = self._last[k]
        try:
            self._last[k] = next(self._runs[k])
        except StopIteration:
            poses = self._parts[k].state.poses
            self._last[k] = Checkpoint(lambda: poses, last.energies if last else 0)
            return True
        return False

    def best(self) -> wp.array:
        """The best poses [B, N] (vec4) so far, in memory of their own."""
        found, first = wp.clone(self.batch.state.poses), 0
        for part, last in zip(self._parts, self._last, strict=True):
            if last is not None:
                wp.copy(cast(wp.array, found[first : first + part.size]), last.best())
            first += part.size
        return found


@dataclass(frozen=True)
class BuiltIn:
    """A built-in optimiser as a `StepOptimizer`, to look into or to compare with; a step is what it does in one go.

    That is 20 steps of "adam", "langevin" and "lbfgs", 10 of "tempering", one round of "search" and one try of
    "projection". From the same poses, seed and budget it ends where ``optimizer=name`` of `sceneweaver.refine` does.

    Attributes:
        name: as in `sceneweaver.refine`.
        budget: in work units of its own, as ``steps`` there; None: its default.
        start: "drawn": the poses are a draw, from which it may go far; "given": it should move little.
    """

    name: str
    budget: int | None = None
    start: str = "drawn"
    steps: None = None  # until it is done

    def init(self, problem: Problem, poses: Array, key: int) -> BuiltInRun:
        """The run before its first step."""
        batch = problem.batch(poses)
        scene = np.asarray(batch.problem.numpy())
        number = np.arange(batch.size) - np.searchsorted(scene, scene)  # of each candidate among those of its scene
        batch.state.rng.assign(streams(key, number))
        if self.start == "given":
            batch = replace(batch, weights=weights(pull=PULL))
        return BuiltInRun(batch, cast(BlockOptimizer, OPTIMIZERS[self.name]).blocks, self.start, self.budget)

    def step(self, state: BuiltInRun) -> BuiltInRun:
        """The same run, one block on."""
        state.advance()
        return state

    def best(self, state: BuiltInRun) -> Array:
        """The best poses of each candidate so far; valid ones, where it found any."""
        return state.best()

    def done(self, state: BuiltInRun) -> bool:
        """Whether nothing is left to do."""
        return state.done

    def counts(self, state: BuiltInRun) -> tuple[int, int]:
        """Energies measured of each candidate so far, and of all."""
        return state.energies, state.energies * state.batch.size

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The kernel modules that it launches on a device."""
        return OPTIMIZERS[self.name].modules_on(device)


def step_optimizer(optimizer: str | StepOptimizer) -> StepOptimizer:
    """Any optimiser as a `StepOptimizer`: a built-in name, the name of an entry point, or one of one's own.

    Raises:
        InputError: no such name, or not an optimiser.
    """
    found = find_optimizer(optimizer)
    if not isinstance(found, str):
        return found
    if not isinstance(OPTIMIZERS[found], BlockOptimizer):
        raise InputError(f'optimizer: "{found}" does not run in blocks')
    return BuiltIn(found)


def modules_of(optimizer: StepOptimizer, device: str) -> tuple[str, ...]:
    """The modules of ``sceneweaver.kernels`` that a run is likely to need on a device."""
    own = getattr(optimizer, "modules_on", lambda _: ())(device)
    return (*own, "starts", *(MEASURED if device == "cpu" else MEASURED_ON_GPU), "residuals")


def load_modules(optimizer: StepOptimizer, device: str) -> None:
    """Compile and load ahead what a run is likely to need on a device, so that no step waits for it."""
    load(device, *modules_of(optimizer, device))


def find_optimizer(optimizer: str | StepOptimizer) -> str | StepOptimizer:
    """What a name or an object stands for: a name in ``OPTIMIZERS``, or an optimiser of one's own.

    An entry point may name an optimiser, or something that makes one when it is called.

    Raises:
        InputError: no such name, or not an optimiser.
    """
    if not isinstance(optimizer, str):
        return _checked(optimizer, f"optimizer: {type(optimizer).__name__}")
    if optimizer in OPTIMIZERS:
        return optimizer
    points = {point.name: point for point in entry_points(group=GROUP)}
    if optimizer not in points:
        raise InputError(f'optimizer: "{optimizer}" is not one of {", ".join(sorted({*OPTIMIZERS, *points}))}')
    found = points[optimizer].load()
    if isinstance(found, type) or not isinstance(found, StepOptimizer):
        found = found() if callable(found) else found
    return _checked(found, f'optimizer: "{optimizer}" of {points[optimizer].value}')


def _checked(found: Any, name: str) -> StepOptimizer:
    missing = [part for part in ("init", "step", "best") if not callable(getattr(found, part, None))]
    if missing or isinstance(found, type):
        raise InputError(f"{name} has no {', '.join(missing)}" if missing else f"{name}: give an instance of it")
    return found


def run_stepwise(
    optimizer: StepOptimizer,
    problem: Problem,
    batch: Batch,
    start: str,
    seed: int,
    budget: int | None,
    monitor: Monitor,
) -> OptimizerResult:
    """Move the batch's poses in place by so many steps of an optimiser of one's own.

    Args:
        optimizer: what takes the steps.
        problem: that of the batch's candidates.
        batch: equal numbers of candidates of each scene, at the poses to begin with.
        start: "given": from those; "random" or "sample": drawn, see `starts.draw_starts`.
        seed: of the run.
        budget: number of steps; None: the optimiser's own, else `STEPS`.
        monitor: asked for the time between steps.

    Returns:
        The energies of the poses that the optimiser calls best.
    """
    draw_starts(batch, start)
    given = wp.clone(batch.state.poses)
    state = optimizer.init(problem, handed_out(wp.clone(given), given), seed)
    for _ in range(budget or getattr(optimizer, "steps", None) or STEPS):
        if monitor.expired():
            break
        state = optimizer.step(state)
    scene, before = np.asarray(batch.problem.numpy(), dtype=np.int32), np.asarray(given.numpy())
    after = poses_from(optimizer.best(state), problem.objects, problem.device).numpy()
    if len(after) != len(before):
        raise InputError(f"optimizer: best gave poses of {len(after)} layouts; there are {len(before)}")
    final = problem.carry(np.where(problem.free[scene], after, before), scene, like=before)
    wp.copy(batch.state.poses, wp.array(final, dtype=wp.vec4, device=batch.device))
    wp.launch(set_turns, before.shape[:2], [batch.state.poses], [batch.state.turns], device=batch.device)
    energy, feasible = problem.energy(final, scene), problem.feasible(final, scene)
    monitor.add(batch.size, int(feasible.sum()), float(np.nanmin(energy)))
    return OptimizerResult(energy)
