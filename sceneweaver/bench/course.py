"""The course of a run: steps in time, and what there was when each budget was spent."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.layout import Problem, StepOptimizer
from sceneweaver.layout.arrays import poses_from

from .layouts import Layouts, measure
from .results import Row
from .starts import Starts


class Stopwatch:
    """Adds up the time inside ``with`` blocks [s]."""

    def __init__(self, device: str) -> None:
        self.device = device
        self.wall = self.cpu = 0.0
        self._began = (0.0, 0.0)

    def __enter__(self) -> Stopwatch:
        settle(self.device)
        self._began = (time.perf_counter(), time.process_time())
        return self

    def __exit__(self, *_: Any) -> None:
        settle(self.device)
        wall, cpu = self._began
        self.wall += time.perf_counter() - wall
        self.cpu += time.process_time() - cpu


def settle(device: str, state: Any = None) -> None:
    """Wait for what is under way on a device, for PyTorch's work as well, and for the arrays of JAX in a state."""
    wp.synchronize_device(device)
    if (torch := sys.modules.get("torch")) and device != "cpu":
        torch.cuda.synchronize(device)
    if state is not None and (jax := sys.modules.get("jax")):
        jax.block_until_ready(state)


def best_of(optimizer: StepOptimizer, state: Any, problem: Problem, given: np.ndarray) -> np.ndarray:
    """A copy of an optimiser's best poses [B, N, 4], as it gives them; ``given`` [B, N, 4] is where it began."""
    best = np.array(poses_from(optimizer.best(state), problem.objects, problem.device).numpy())
    if best.shape != given.shape:
        raise ValueError(f"best gave an array of shape {best.shape}; poses are {given.shape}")
    return best


def taken(problem: Problem, best: np.ndarray, given: np.ndarray) -> np.ndarray:
    """Best poses as `sceneweaver.refine` takes them: free coordinates, and what is carried goes along."""
    return problem.carry(np.where(problem.free[0], best, given), like=given)


@dataclass
class _Left:
    """What a step left, to be measured when somebody wants to know."""

    row: Row  # with what it had cost by then
    best: np.ndarray
    given: np.ndarray
    kept: Layouts | None  # of rounds that are over
    layouts: Layouts | None = None
    shown: bool = False


class Course:
    """Rounds of an optimiser, the best of each candidate kept, until the budget is spent.

    What each step leaves is copied. It is measured once the next step has ended, if a look was due or a budget was
    spent in between: so a budget is read to the step, and a step that ends later does not count.
    """

    def __init__(self, optimizer: StepOptimizer, problem: Problem, starts: Starts, first: Row) -> None:
        self.optimizer, self.problem, self.starts, self.settings = optimizer, problem, starts, starts.settings
        self.watch = Stopwatch(problem.device)
        self.given, self.seed = starts.draw(first.seed)
        self.left = _Left(first, self.given, self.given, None, shown=True)
        looks = [(at, False) for at in self.settings.looks[:-1]]
        self.due = sorted([*looks, *((at, True) for at in self.settings.readings)])
        self.kept: Layouts | None = None
        self.counted = [0, 0]  # energy calls and evaluations in rounds that are over, or so far
        self.checkpoint, self.steps, self.rounds = first.checkpoint, 0, 0
        self.outcome = "running"

    @property
    def seconds(self) -> float:
        """Time spent, by the run's clock."""
        return self.watch.cpu if self.settings.clock == "cpu" else self.watch.wall

    def rows(self) -> Iterator[Row]:
        """Rows until the run ends. An optimiser that ends early begins again, if that is wanted and of use."""
        while self.outcome == "running":
            yield from self._round()
            self.rounds += 1
            self.given, self.seed = self.starts.draw(self.left.row.seed, self.rounds)

    def _round(self) -> Iterator[Row]:
        optimizer, problem = self.optimizer, self.problem
        most, done = (getattr(optimizer, name, None) for name in ("steps", "done"))
        poses, before = on_device(problem, self.given), tuple(self.counted)
        state = self._timed(lambda: optimizer.init(problem, poses, self.seed))
        steps, over = 0, False
        while not over:
            state = self._timed(lambda now=state: optimizer.step(now))
            steps += 1
            over = steps == most or (done is not None and done(state))
            if (own := getattr(optimizer, "counts", None)) is not None:
                self.counted = [b + int(n) for b, n in zip(before, own(state), strict=True)]
            yield from self._spent()
            if self.outcome != "running":
                return
            self.steps += 1
            self.left = self._leave(best_of(optimizer, state, problem, self.given))
            if self.counted[1] >= (self.settings.evaluations or np.inf):
                yield self._seen("budget")
                return
        self.kept = self._measured()
        if self._enough(self.kept) or not self.settings.restarts:
            yield self._seen("ended")

    def _spent(self) -> Iterator[Row]:
        """Rows of what the step before left, for looks and budgets that the time of this one went past."""
        while self.due and self.due[0][0] < self.seconds and self.outcome == "running":
            at, is_budget = self.due.pop(0)
            if is_budget:
                outcome = "budget" if at >= self.settings.seconds else "running"
                yield replace(self._seen(outcome, layout=True), budget=at)
            elif not self.left.shown:
                yield self._seen("running")
            if self.settings.enough and self.outcome == "running" and self._found():
                yield self._seen("ended")

    def _found(self) -> bool:
        """Whether there is a valid layout, and that is all that was wanted."""
        found = self.left.layouts
        return not self.starts.task.objective and found is not None and bool(found.feasible.any())

    def _enough(self, now: Layouts) -> bool:
        """Whether a method that has come to its end need not begin again."""
        if self.starts.task.objective:
            return False
        return bool(now.feasible.any() if self.settings.enough else now.feasible.all())

    def _timed(self, call: Any) -> Any:
        """What a call gives, its time and its energies counted."""
        problem = self.problem
        calls, evaluations = problem.energy_calls, problem.evaluations
        with self.watch:
            state = call()
            settle(problem.device, state)
        self.counted[0] += problem.energy_calls - calls
        self.counted[1] += problem.evaluations - evaluations
        return state

    def _leave(self, best: np.ndarray) -> _Left:
        row = replace(
            self.left.row,
            steps=self.steps,
            rounds=self.rounds + 1,
            seconds=self.seconds,
            wall_seconds=self.watch.wall,
            cpu_seconds=self.watch.cpu,
            energy_calls=self.counted[0],
            evaluations=self.counted[1],
        )
        return _Left(row, best, self.given, self.kept)

    def _measured(self) -> Layouts:
        """What the last step left, with the best of rounds that are over."""
        left = self.left
        if left.layouts is None:
            poses = taken(self.problem, left.best, left.given)
            left.layouts = measure(self.problem, poses, self.starts.task).better_of(left.kept)
        return left.layouts

    def _seen(self, outcome: str, layout: bool = False) -> Row:
        """The row of a look at what the last step left; with its best layout at the end of the run."""
        layouts = self._measured()
        best = layouts.best() if layout or outcome != "running" else None
        self.outcome, self.checkpoint, self.left.shown = outcome, self.checkpoint + 1, True
        return replace(
            self.left.row,
            checkpoint=self.checkpoint,
            outcome=outcome,
            layout=None if best is None else bytes_of(layouts.poses[best]),
            **layouts.columns(),
        )


def bytes_of(poses: np.ndarray) -> bytes:
    """Poses [N, 4] as the column ``layout`` has them."""
    return np.ascontiguousarray(poses, dtype="<f4").tobytes()


def on_device(problem: Problem, poses: np.ndarray) -> Any:
    """Poses as the protocol hands them over: a Warp array [B, N, 4] of the optimiser's own."""
    return wp.array(poses, dtype=wp.float32, device=problem.device)
