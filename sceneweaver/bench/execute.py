"""One run: an optimiser on a problem from one seed, measured while it goes on."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from sceneweaver.layout import BuiltIn, MinimiseSteps, Problem, StepOptimizer
from sceneweaver.layout.stepwise import load_modules

from .course import Course, best_of, on_device, settle
from .entries import Method, Task
from .layouts import measure
from .results import Row
from .settings import Settings
from .starts import Starts


def configured(optimizer: StepOptimizer, task: Task, settings: Settings) -> StepOptimizer:
    """The optimiser of a run: told of the objective and the budget, where it wants to know (``configure``).

    The built-in search minimises the objective once it has found layouts.
    """
    if isinstance(optimizer, BuiltIn) and optimizer.name == "search" and task.objective:
        return MinimiseSteps(task.objective, settings.seconds, optimizer)
    configure = getattr(optimizer, "configure", None)
    return optimizer if configure is None else configure(task.objective, settings.seconds)


@dataclass
class Prepared:
    """What runs of the same process share: problems with what they have compiled, and optimisers that are warm on them.

    Attributes:
        most: problems that are kept; None: all.
    """

    most: int | None = None
    starts: dict[str, Starts] = field(default_factory=dict)
    optimizers: dict[tuple[str, str], tuple[StepOptimizer, float]] = field(default_factory=dict)

    def of(self, task: Task, settings: Settings) -> Starts:
        """The task of that name with its starts, and with what it has compiled."""
        kept = self.starts.get(task.name)
        if kept is None or kept.settings != settings or kept.task.hash != task.hash:
            self._let_go(task.name)
            while self.most is not None and len(self.starts) >= self.most:
                self._let_go(next(iter(self.starts)))
            self.starts[task.name] = Starts(task, settings)
        return self.starts[task.name]

    def _let_go(self, name: str) -> None:
        self.starts.pop(name, None)
        self.optimizers = {key: each for key, each in self.optimizers.items() if key[0] != name}

    def optimizer(
        self, method: Method, problem: Problem, given: np.ndarray, seed: int, starts: Starts
    ) -> tuple[StepOptimizer, float]:
        """The method's optimiser, after a first go that compiles what there is to compile; its wall time [s]."""
        key = starts.task.name, method.name
        if key not in self.optimizers:
            began = time.perf_counter()
            optimizer = configured(method.make(), starts.task, starts.settings)
            load_modules(optimizer, problem.device)
            warm_up = getattr(optimizer, "warm_up", None)
            poses = on_device(problem, given)
            if warm_up is not None:
                state = warm_up(problem, poses, seed)
            else:  # two steps: what JAX compiled for the first state is often not what the second needs
                state = optimizer.step(optimizer.step(optimizer.init(problem, poses, seed)))
            best_of(optimizer, state, problem, given)
            settle(problem.device, state)
            self.optimizers[key] = optimizer, time.perf_counter() - began
        return self.optimizers[key]


def execute(method: Method, task: Task, seed: int, settings: Settings, prepared: Prepared) -> Iterator[Row]:
    """The rows of a run, one for every look at it. Whatever goes wrong is the last row's reason."""
    row = blank(method, task, seed, settings)
    try:
        starts = prepared.of(task, settings)
        problem = starts.task.compile(settings.device)
        row = replace(row, objects=problem.objects, variables=int(problem.free.sum()))
        given, _ = starts.draw(seed)
        optimizer, setup = prepared.optimizer(method, problem, given, seed, starts)
        row = replace(row, checkpoint=0, setup_seconds=setup, **measure(problem, given, task).columns())
        yield row
        for seen in Course(optimizer, problem, starts, row).rows():
            row = seen
            yield row
    except Exception as error:  # an optimiser may raise anything
        text = " ".join(str(error).split())[:300]
        last = replace(row, checkpoint=row.checkpoint + 1, budget=None, layout=None)
        yield replace(last, outcome="failed", reason=f"{type(error).__name__}: {text}")


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
        known_objective=task.best_objective,
        seed=seed,
        candidates=settings.candidates,
        checkpoint=-1,
    )
