"""Tuning with the same budget for all: a random search over the settings that a method declares, on problems apart.

A method declares ``space``, a mapping of names of its fields to ("float" or "log", low, high), ("int" or "logint",
low, high) or ("choice", values). Bergstra and Bengio, *Journal of Machine Learning Research* 13, 2012, on why random.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import write_atomic
from sceneweaver.problems import ProblemCase
from sceneweaver.scene import InputError

from .entries import Method, find_methods
from .protocol import settings_of
from .quality import judge_all
from .results import read_runs
from .runner import Progress, run

TRIALS = 16
SECONDS = 1.0
BUILT_IN: Mapping[str, Mapping[str, Any]] = {
    name: {"budget": ("logint", low, high)}
    for name, low, high in (
        ("search", 4, 200),
        ("adam", 100, 2000),
        ("langevin", 100, 2000),
        ("lbfgs", 100, 2000),
        ("tempering", 50, 1000),
        ("projection", 2, 50),
    )
}
"""What is drawn for the built-in optimisers: how long a round is before it begins again."""


def space_of(method: Method) -> Mapping[str, Any]:
    """The settings that may be drawn for a method; none: it runs as it is."""
    if isinstance(method.source, str) and method.source in BUILT_IN:
        return BUILT_IN[method.source]
    made = method.make()
    choices = {name: ("choice", values) for name, values in getattr(made, "SETTINGS", {}).items()}
    return getattr(made, "space", choices)


def draw(space: Mapping[str, Any], rng: np.random.Generator) -> dict[str, Any]:
    """Settings from a space.

    Raises:
        InputError: a row that is none of the kinds.
    """
    found: dict[str, Any] = {}
    for name, row in space.items():
        kind, *values = row
        if kind == "choice":
            found[name] = values[0][int(rng.integers(len(values[0])))]
        elif kind in ("float", "int") and len(values) == 2:
            drawn = float(rng.uniform(values[0], values[1]))
            found[name] = round(drawn) if kind == "int" else drawn
        elif kind in ("log", "logint") and len(values) == 2 and 0 < values[0] < values[1]:
            drawn = math.exp(float(rng.uniform(math.log(values[0]), math.log(values[1]))))
            found[name] = round(drawn) if kind == "logint" else drawn
        else:
            raise InputError(f"space: {name}: {row!r} is no range; give (float|log|int|logint, low, high)")
    return found


def trials_of(method: Method, count: int, seed: int = 0) -> list[Method]:
    """The method as it is, and with so many settings more that were drawn."""
    space, rng = space_of(method), np.random.default_rng(seed)
    found = [Method(f"{method.name}#0", method.source, method.settings)]
    while space and len(found) < count:
        candidate = Method(f"{method.name}#{len(found)}", method.source, draw(space, rng))
        try:
            candidate.make()
        except InputError:
            raise
        except ValueError:  # settings that do not go together
            continue
        found.append(candidate)
    return found


def tune(
    optimizers: Sequence[Any],
    cases: Sequence[ProblemCase],
    out: Path | str,
    *,
    trials: int = TRIALS,
    seconds: float = SECONDS,
    seeds: int = 1,
    device: str = "cpu",
    candidates: int | None = None,
    jobs: int = 1,
    until: float = math.inf,
    progress: Progress | None = None,
) -> Path:
    """Choose for each method the settings of the highest mean quality; its own are the first trial and win ties.

    Every trial has the same seconds on the same problems, and every method as many trials.

    Returns:
        ``tuned.json`` in ``out``: for each method its settings, its quality with them and with its own.

    Raises:
        InputError: a space that is none; as for `run`.
    """
    if trials < 1:
        raise InputError(f"trials: {trials!r} is not at least 1")
    methods, known, chosen = find_methods(optimizers), {case.name: case for case in cases}, {}
    drawn = {method.name: trials_of(method, trials) for method in methods}
    everything = [trial for rows in drawn.values() for trial in rows]
    folder, settings = Path(out) / "trials", settings_of([seconds], device, candidates)
    run(
        everything, cases, folder, seeds=seeds, settings=settings, isolate=True, jobs=jobs, until=until,
        progress=progress,
    )  # fmt: skip
    runs = read_runs(folder)
    found = judge_all(runs, known, folder)
    for name, rows in drawn.items():
        means = [np.mean([v.quality for key, v in found.items() if key[0] == trial.name] or [0.0]) for trial in rows]
        best = int(np.argmax(means))
        kept = dict(rows[best].settings)
        chosen[name] = {"settings": kept, "quality": float(means[best]), "own": float(means[0]), "trials": len(rows)}
    about = {"trials": trials, "seconds": seconds, "seeds": seeds, "problems": sorted(known), "device": device}
    path = Path(out) / "tuned.json"
    write_atomic(path, json.dumps({"about": about, "methods": chosen}, indent=1) + "\n")
    return path
