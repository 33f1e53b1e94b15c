"""One run: an optimiser on a problem from one seed, looked at while it goes on."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.layout import Problem, StepOptimizer

from .clock import Stopwatch, settle
from .looks import Layouts, look, measure
from .methods import Method
from .schema import Row
from .settings import Settings
from .starts import Starts
from .tasks import Task


@dataclass
class Prepared:
    """What runs of the same process share: the last task, and optimisers that are warm on it."""

    starts: dict[str, Starts] = field(default_factory=dict)
    optimizers: dict[str, tuple[StepOptimizer, float]] = field(default_factory=dict)

    def of(self, task: Task, settings: Settings) -> Starts:
        """The task of that name with its starts, and with what it has compiled; others are let go."""
        if task.name not in self.starts:
            self.starts, self.optimizers = {task.name: Starts(task, settings)}, {}
        return self.starts[task.name]

    def optimizer(self, method: Method, problem: Problem, given: np.ndarray, seed: int) -> tuple[StepOptimizer, float]:
        """The method's optimiser, after a first step that compiles what there is to compile; its wall time [s]."""
        if method.name not in self.optimizers:
            began = time.perf_counter()
            optimizer = method.make()
            state = optimizer.step(optimizer.init(problem, _on_device(problem, given), seed))
            look(optimizer, state, problem, given)
            settle(problem.device, state)
            self.optimizers[method.name] = optimizer, time.perf_counter() - began
        return self.optimizers[method.name]


def execute(method: Method, task: Task, seed: int, settings: Settings, prepared: Prepared) -> Iterator[Row]:
    """The rows of a run, one for every look at it. Whatever goes wrong is the last row's reason."""
    row = blank(method, task, seed, settings)
    try:
        starts = prepared.of(task, settings)
        problem = starts.task.compile(settings.device)
        row = replace(row, objects=problem.objects, variables=int(problem.free.sum()))
        given, _ = starts.draw(seed)
        optimizer, setup = prepared.optimizer(method, problem, given, seed)
        row = replace(row, checkpoint=0, setup_seconds=setup, **measure(problem, given).columns())
        yield row
        for seen in _Course(optimizer, problem, starts, row).rows():
            row = seen
            yield row
    except Exception as error:  # an optimiser may raise anything
        text = " ".join(str(error).split())[:300]
        yield replace(row, checkpoint=row.checkpoint + 1, outcome="failed", reason=f"{type(error).__name__}: {text}")


def blank(method: Method, task: Task, seed: int, settings: Settings) -> Row:
    """A row before anything is known of the run."""
    return Row(
        method.name,
        task.name,
        task.family,
        task.hash,
        objects=0,
        variables=0,
        best_known=task.best_energy,
        seed=seed,
        candidates=settings.candidates,
        checkpoint=-1,
    )


class _Course:
    """The course of a run: rounds of an optimiser, the best of each candidate kept, until the budget is spent."""

    def __init__(self, optimizer: StepOptimizer, problem: Problem, starts: Starts, first: Row) -> None:
        self.optimizer, self.problem, self.starts, self.settings = optimizer, problem, starts, starts.settings
        self.row, self.watch = first, Stopwatch(problem.device)
        self.looks = iter(self.settings.looks)
        self.due = next(self.looks)
        self.kept: Layouts | None = None
        self.counted = [0, 0]  # energy calls and evaluations in rounds that are over, or so far
        self.rounds = 0

    @property
    def seconds(self) -> float:
        """Time spent, by the run's clock."""
        return self.watch.cpu if self.settings.clock == "cpu" else self.watch.wall

    def rows(self) -> Iterator[Row]:
        """Rows until the run ends. An optimiser that ends early begins again, if that is wanted and of use."""
        while self.row.outcome == "running":
            yield from self._round()

    def _round(self) -> Iterator[Row]:
        optimizer, problem = self.optimizer, self.problem
        most, done = (getattr(optimizer, name, None) for name in ("steps", "done"))
        given, seed = self.starts.draw(self.row.seed, self.rounds)
        poses, before = _on_device(problem, given), tuple(self.counted)
        state = self._timed(lambda: optimizer.init(problem, poses, seed))
        steps, over = 0, False
        while not over:
            state = self._timed(lambda now=state: optimizer.step(now))
            steps += 1
            over = steps == most or (done is not None and done(state))
            if (own := getattr(optimizer, "counts", None)) is not None:
                self.counted = [b + int(n) for b, n in zip(before, own(state), strict=True)]
            spent = self.seconds >= self.settings.seconds or self.counted[1] >= (self.settings.evaluations or np.inf)
            if not (over or spent or self.seconds >= self.due):
                self.row = replace(self.row, steps=self.row.steps + 1)
                continue
            now = look(optimizer, state, problem, given).better_of(self.kept)
            outcome = "budget" if spent else "running"
            if over and not spent:
                self.kept = now
                if now.feasible.all() or not self.settings.restarts:
                    outcome = "ended"
            self.row = self._seen(now, outcome)
            if outcome != "running" or self.seconds >= self.due:
                self.row = replace(self.row, checkpoint=self.row.checkpoint + 1)
                yield self.row
            while self.due <= self.seconds:
                self.due = next(self.looks, np.inf)
            over = over or spent
        self.rounds += 1

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

    def _seen(self, layouts: Layouts, outcome: str) -> Row:
        return replace(
            self.row,
            steps=self.row.steps + 1,
            rounds=self.rounds + 1,
            seconds=self.seconds,
            wall_seconds=self.watch.wall,
            cpu_seconds=self.watch.cpu,
            energy_calls=self.counted[0],
            evaluations=self.counted[1],
            outcome=outcome,
            **layouts.columns(),
        )


def _on_device(problem: Problem, poses: np.ndarray) -> Any:
    """Poses as the protocol hands them over: a Warp array [B, N, 4] of the optimiser's own."""
    return wp.array(poses, dtype=wp.float32, device=problem.device)
