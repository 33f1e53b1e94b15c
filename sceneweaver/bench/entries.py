"""What is compared: optimisers and problems, by name, by import path, or as objects."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, cast

import numpy as np

from sceneweaver import problems
from sceneweaver.layout import ObjectiveTerm, Problem, StepOptimizer, find_optimizer, step_optimizer
from sceneweaver.layout import compile as compile_problem
from sceneweaver.scene import InputError, Scene


@dataclass(frozen=True)
class Method:
    """An optimiser under the name that it has in results.

    Attributes:
        name: in results.
        source: a name of the registry or of an entry point, ``package.module:Name``, or a `StepOptimizer`.
        settings: fields of the optimiser, a dataclass, that are to be other than its own.

    Examples:
        >>> from sceneweaver import bench
        >>> from sceneweaver.layout import BuiltIn
        >>> bench.Method("adam, short", BuiltIn("adam", budget=99)).make().budget
        99
    """

    name: str
    source: str | StepOptimizer
    settings: Mapping[str, Any] = field(default_factory=dict)

    def make(self) -> StepOptimizer:
        """The optimiser. What its modules need is imported now, and may be missing.

        Raises:
            InputError: what the source names is no `StepOptimizer`. ImportError: something is missing.
        """
        found = self._found()
        if not self.settings:
            return found
        try:
            return cast(StepOptimizer, replace(cast(Any, found), **self.settings))
        except TypeError as error:
            raise InputError(f'optimizers: "{self.name}" does not take {", ".join(self.settings)} ({error})') from None

    def _found(self) -> StepOptimizer:
        if not isinstance(self.source, str):
            return self.source
        if ":" in self.source:
            module, _, attribute = self.source.partition(":")
            found = getattr(import_module(module), attribute, None)
            if found is None:
                raise InputError(f'optimizers: "{module}" has no "{attribute}"')
            found = found() if isinstance(found, type) or not hasattr(found, "step") else found
        else:
            found = self.source
        return step_optimizer(found)


def find_methods(optimizers: Sequence[str | StepOptimizer | Method]) -> list[Method]:
    """The methods that names and objects stand for.

    ``label=source`` gives another name. Where ``package.module:NAME`` in capitals is a mapping of names to sources, all
    of them join.

    Raises:
        InputError: nothing goes by such a name, or two go by the same.
    """
    methods = [method for given in optimizers for method in _methods(given)]
    _require_distinct("optimizers", [method.name for method in methods], "; give label=source")
    return methods


def _require_distinct(what: str, names: Sequence[str], fix: str = "") -> None:
    """At least one name, and none of them twice."""
    if not names:
        raise InputError(f"{what}: give at least one")
    for name in names:
        if names.count(name) > 1:
            raise InputError(f'{what}: "{name}" is there twice{fix}')


def _methods(given: Any) -> list[Method]:
    if isinstance(given, Method):
        return [given]
    if not isinstance(given, str):
        find_optimizer(given)
        return [Method(type(given).__name__, given)]
    label, _, source = given.rpartition("=")
    if ":" not in source:
        find_optimizer(source)
        return [Method(label or source, source)]
    module, _, attribute = source.partition(":")
    try:
        there = find_spec(module) is not None
    except ImportError:
        there = False
    if not there or not attribute:
        raise InputError(f'optimizers: there is no "{source}"; a source is package.module:Name')
    if attribute.isupper():
        mapping = getattr(import_module(module), attribute, None)
        if not isinstance(mapping, Mapping):
            raise InputError(f'optimizers: "{source}" is no mapping of names to optimisers')
        return [Method(str(name), each) for name, each in mapping.items()]
    return [Method(label or attribute, source)]


NOISE_M, NOISE_RAD = 0.3, np.deg2rad(15.0)  # of perturbed starts


@dataclass(frozen=True)
class SceneTask:
    """A scene as a problem. "perturbed" starts are the scene's own poses, N(0, 0.3 m) and N(0, 15 degrees) off."""

    scene: Scene
    name: str
    family: str = "scenes"
    best_energy: float | None = None
    best_objective: float | None = None

    @property
    def objective(self) -> tuple[ObjectiveTerm, ...]:
        """None: being valid is all."""
        return ()

    @property
    def hash(self) -> str:
        """SHA-256 of the scene's JSON."""
        return hashlib.sha256(self.scene.dumps().encode()).hexdigest()

    def compile(self, device: str = "auto") -> Problem:
        """The problem on a device."""
        return _compiled(self.scene.dumps(), device)

    def start(self, name: str, count: int, seed: int) -> np.ndarray:
        """Poses [count, N, 4]: "sample", drawn from the relations; "random", anywhere in the room; "perturbed"."""
        problem = self.compile("cpu")
        if name == "sample":
            return problem.sample(seed, count)
        rng, home = np.random.default_rng(seed), np.repeat(problem.home, count, axis=0)
        if name == "random":
            moved = rng.uniform(problem.lower[0], problem.upper[0], home.shape)
        else:
            moved = home + rng.normal(0.0, (NOISE_M, NOISE_M, 0.0, NOISE_RAD), home.shape)
        return problem.carry(np.where(problem.free[0], moved, home))

    def objective_of(self, poses: np.ndarray) -> np.ndarray:
        """0 for each layout [B, N, 4]: a scene alone has no objective."""
        return np.zeros(len(poses))


Task = problems.ProblemCase | SceneTask
"""A problem of a comparison: of the zoo, or a scene."""


@lru_cache(maxsize=4)
def _compiled(text: str, device: str) -> Problem:
    """The problem of a scene's JSON."""
    return compile_problem(Scene.loads(text), device=device)


def find_tasks(given: Sequence[str | Scene | Task]) -> list[Task]:
    """The problems that names of the zoo, its families, "all", scene files and scenes stand for.

    "all" and families leave out what has no valid layout; the family "infeasible" is nothing else, and is taken whole.

    Raises:
        InputError: nothing goes by such a name.
    """
    tasks = [task for each in given for task in _tasks(each)]
    _require_distinct("problems", [task.name for task in tasks])
    return tasks


def _tasks(given: str | Scene | Task) -> list[Task]:
    if isinstance(given, Scene):
        return [SceneTask(given, given.id)]
    if not isinstance(given, str):
        return [given]
    if given.endswith(".json"):
        return [SceneTask(Scene.load(Path(given)), Path(given).stem)]
    if given in problems.names():
        return [problems.load(given)]
    if given != "all" and given not in problems.families():
        raise InputError(f'problems: there is no "{given}"; give all, {", ".join(problems.families())} or a name')
    family = None if given == "all" else given
    return [problems.load(name) for name in problems.names(family, True) or problems.names(family)]
