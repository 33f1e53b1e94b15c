"""Optimisers of one's own: what they have to be, how they are found, and the loop that runs them."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import entry_points
from typing import Any, Protocol, runtime_checkable

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import OPTIMIZERS, Batch, Descent, Monitor, OptimizerResult, streams
from sceneweaver.optimizers.descent import REASSIGN, DescentRun
from sceneweaver.optimizers.starts import draw_starts
from sceneweaver.scene import InputError

from .arrays import Array, handed_out, poses_from
from .problem import Problem

GROUP = "sceneweaver.optimizers"  # of entry points
STEPS = 200  # unless the optimiser says or is told how many
MODULES = ("starts", "step", "gradients", "residuals")  # kernels that such a run is likely to need


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


@dataclass(frozen=True)
class StepDescent:
    """A built-in update rule as a `StepOptimizer`: a step is 20 of the rule's own.

    ``name`` is "adam" or "langevin", ``total`` the number of the rule's steps that its schedule spans. The same as
    ``optimizer=name`` of `sceneweaver.refine` from drawn starts, to look into or to compare with.
    """

    name: str = "adam"
    total: int = 399

    @property
    def steps(self) -> int:
        """Steps of a run: the last measures where the one before led."""
        return -(-(self.total + 1) // REASSIGN)

    def init(self, problem: Problem, poses: Array, key: int) -> DescentRun:
        """The descent before its first step."""
        rule = OPTIMIZERS.get(self.name)
        if not isinstance(rule, Descent):
            raise InputError(f'optimizer: "{self.name}" is no update rule')
        batch = problem.batch(poses)
        batch.state.rng.assign(streams(key, np.arange(batch.size)))
        return DescentRun(batch, rule.rule, rule.drawn.schedule(self.total))

    def step(self, state: DescentRun) -> DescentRun:
        """The same descent, 20 steps on."""
        state.play(Monitor(state.batch.size), REASSIGN)
        return state

    def best(self, state: DescentRun) -> Array:
        """Poses of the lowest energies so far."""
        state.finish()
        return wp.clone(state.batch.state.poses)


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
