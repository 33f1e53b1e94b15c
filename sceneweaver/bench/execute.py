"""One run: an optimiser on a problem from one seed, measured while it goes on."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.layout import BuiltIn, MinimiseSteps, Problem, StepOptimizer, refine
from sceneweaver.layout.arrays import poses_from
from sceneweaver.layout.solution import differ

from .entries import Method, Task
from .results import Row
from .settings import Settings


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


ROUND = 1_000_003  # between the seeds of a run's rounds


@dataclass
class Starts:
    """Starts of one task by seed and round.

    What stands on surfaces is solved beforehand, with as little change as that takes: an optimiser moves roots alone,
    and no layout could become valid. That is done once a seed; later rounds carry what the first one had.
    """

    task: Task
    settings: Settings
    _solved: dict[int, np.ndarray] = field(default_factory=dict)

    def draw(self, seed: int, attempt: int = 0) -> tuple[np.ndarray, int]:
        """Poses [B, N, 4] of a round, and its seed."""
        task, settings, own = self.task, self.settings, (seed + attempt * ROUND) % 2**32
        drawn = np.asarray(task.start(settings.start, settings.candidates, own), dtype=np.float32)
        problem = task.compile(settings.device)
        if not problem.surfaces:
            return drawn, own
        if seed not in self._solved:
            first = drawn if attempt == 0 else self.draw(seed)[0]
            kept = refine(task.scene, init=first, optimizer=_Keep(), seed=seed, device=settings.device, walk=False)
            self._solved[seed] = kept.poses.astype(np.float32)
        return problem.carry(drawn, like=self._solved[seed]), own


class _Keep:
    """Leaves everything where it is; `refine` has solved surfaces before it begins."""

    steps = 1

    def init(self, problem: Any, poses: Any, key: int) -> Any:
        return poses

    def step(self, state: Any) -> Any:
        return state

    def best(self, state: Any) -> Any:
        return state


MOST_DISTINCT = 256  # valid layouts that are compared with one another: the first of them


@dataclass(frozen=True)
class Layouts:
    """Candidates of one problem, measured.

    Poses [B, N, 4], energy [B] (inf where it is no number), feasible [B], objective [B] float64 or None without one.
    """

    poses: np.ndarray
    energy: np.ndarray
    feasible: np.ndarray
    objective: np.ndarray | None = None

    @property
    def score(self) -> np.ndarray:
        """What tells valid layouts apart [B]: the lower the better."""
        return self.energy if self.objective is None else np.where(self.feasible, self.objective, self.energy)

    def better_of(self, other: Layouts | None) -> Layouts:
        """Of two layouts of each candidate the better: a feasible one, then that of lower objective or energy."""
        if other is None:
            return self
        mine = np.where(self.feasible == other.feasible, self.score <= other.score, self.feasible)
        objective = None
        if self.objective is not None and other.objective is not None:
            objective = np.where(mine, self.objective, other.objective)
        return Layouts(
            np.where(mine[:, None, None], self.poses, other.poses),
            np.where(mine, self.energy, other.energy),
            self.feasible | other.feasible,
            objective,
        )

    def best(self) -> int | None:
        """The best valid candidate; None: none is valid."""
        return int(np.where(self.feasible, self.score, np.inf).argmin()) if self.feasible.any() else None

    def columns(self) -> dict[str, Any]:
        """What goes into columns of `results.COLUMNS`."""
        finite, good = self.energy[np.isfinite(self.energy)], self.energy[self.feasible]
        best = self.best()
        return {
            "valid": float(self.feasible.mean()),
            "distinct": count_distinct(self.poses[self.feasible][:MOST_DISTINCT]),
            "best_energy": float(finite.min()) if finite.size else None,
            "best_valid_energy": float(good.min()) if good.size else None,
            "best_objective": None if best is None or self.objective is None else float(self.objective[best]),
            "median_energy": float(np.median(finite)) if finite.size else None,
        }


def measure(problem: Problem, poses: np.ndarray, task: Task) -> Layouts:
    """Measure poses [B, N, 4] of a task."""
    energy = np.asarray(problem.energy(poses), dtype=np.float64)
    energy[~np.isfinite(energy)] = np.inf
    feasible = np.asarray(problem.feasible(poses), dtype=bool) & np.isfinite(energy)
    return Layouts(poses, energy, feasible, task.objective_of(poses) if task.objective else None)


def look(optimizer: StepOptimizer, state: Any, problem: Problem, given: np.ndarray, task: Task) -> Layouts:
    """An optimiser's best, as `sceneweaver.refine` takes it: free coordinates, and what is carried goes along.

    ``given`` [B, N, 4] is where it began.
    """
    best = np.asarray(poses_from(optimizer.best(state), problem.objects, problem.device).numpy())
    if best.shape != given.shape:
        raise ValueError(f"best gave an array of shape {best.shape}; poses are {given.shape}")
    return measure(problem, problem.carry(np.where(problem.free[0], best, given), like=given), task)


def configured(optimizer: StepOptimizer, task: Task, settings: Settings) -> StepOptimizer:
    """The optimiser of a run: told of the objective and the budget, where it wants to know (``configure``).

    The built-in search minimises the objective once it has found layouts.
    """
    if isinstance(optimizer, BuiltIn) and optimizer.name == "search" and task.objective:
        return MinimiseSteps(task.objective, settings.seconds, optimizer)
    configure = getattr(optimizer, "configure", None)
    return optimizer if configure is None else configure(task.objective, settings.seconds)


def count_distinct(layouts: np.ndarray) -> int:
    """Of how many layouts [K, N, 4], taken in turn, any two have an object 0.5 m or 45 degrees apart."""
    found = 0
    while len(layouts):
        layouts, found = layouts[differ(layouts, layouts[0])], found + 1
    return found


@dataclass
class Prepared:
    """What runs of the same process share: the last task, and optimisers that are warm on it."""

    starts: dict[str, Starts] = field(default_factory=dict)
    optimizers: dict[str, tuple[StepOptimizer, float]] = field(default_factory=dict)

    def of(self, task: Task, settings: Settings) -> Starts:
        """The task of that name with its starts, and with what it has compiled; others are let go."""
        if task.name not in self.starts or self.starts[task.name].settings != settings:
            self.starts, self.optimizers = {task.name: Starts(task, settings)}, {}
        return self.starts[task.name]

    def optimizer(
        self, method: Method, problem: Problem, given: np.ndarray, seed: int, starts: Starts
    ) -> tuple[StepOptimizer, float]:
        """The method's optimiser, after a first step that compiles what there is to compile; its wall time [s]."""
        if method.name not in self.optimizers:
            began = time.perf_counter()
            optimizer = configured(method.make(), starts.task, starts.settings)
            state = optimizer.step(optimizer.init(problem, _on_device(problem, given), seed))
            look(optimizer, state, problem, given, starts.task)
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
        optimizer, setup = prepared.optimizer(method, problem, given, seed, starts)
        row = replace(row, checkpoint=0, setup_seconds=setup, **measure(problem, given, task).columns())
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
        known_objective=task.best_objective,
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
        optimizer, problem, task = self.optimizer, self.problem, self.starts.task
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
            now = look(optimizer, state, problem, given, task).better_of(self.kept)
            outcome = "budget" if spent else "running"
            if over and not spent:
                self.kept = now
                if (now.feasible.all() and not task.objective) or not self.settings.restarts:
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
        best = layouts.best()
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
            layout=None if outcome == "running" or best is None else _bytes_of(layouts.poses[best]),
            **layouts.columns(),
        )


def _bytes_of(poses: np.ndarray) -> bytes:
    """Poses [N, 4] as the column ``layout`` has them."""
    return np.ascontiguousarray(poses, dtype="<f4").tobytes()


def _on_device(problem: Problem, poses: np.ndarray) -> Any:
    """Poses as the protocol hands them over: a Warp array [B, N, 4] of the optimiser's own."""
    return wp.array(poses, dtype=wp.float32, device=problem.device)
