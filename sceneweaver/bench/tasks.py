"""The problems of a comparison: those of the zoo, by name or family, and scenes."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Protocol

import numpy as np

from sceneweaver import problems
from sceneweaver.layout import Problem
from sceneweaver.layout import compile as compile_problem
from sceneweaver.scene import InputError, Scene

NOISE_M, NOISE_RAD = 0.3, np.deg2rad(15.0)  # of perturbed starts


class Task(Protocol):
    """What the harness asks of a problem."""

    @property
    def name(self) -> str:
        """In results."""
        ...

    @property
    def family(self) -> str:
        """That of the zoo, or "scenes"."""
        ...

    @property
    def hash(self) -> str:
        """SHA-256 of what it is."""
        ...

    @property
    def scene(self) -> Scene:
        """What is laid out; it is left as it is."""
        ...

    @property
    def best_energy(self) -> float | None:
        """The lowest energy of a valid layout that is known [m]."""
        ...

    def compile(self, device: str = "auto") -> Problem:
        """The problem on a device."""
        ...

    def start(self, name: str, count: int, seed: int) -> np.ndarray:
        """Poses [count, N, 4] float32 to start from."""
        ...


@dataclass(frozen=True)
class SceneTask:
    """A scene as a problem. "perturbed" starts are the scene's own poses, N(0, 0.3 m) and N(0, 15 degrees) off."""

    scene: Scene
    name: str
    family: str = "scenes"
    best_energy: float | None = None

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
    tasks = [task for each in given for task in _found(each)]
    if not tasks:
        raise InputError("problems: give at least one")
    names = [task.name for task in tasks]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f'problems: "{name}" is there twice')
    return tasks


def _found(given: str | Scene | Task) -> list[Task]:
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
