"""The weights of grades: fitted to what strict eyes gave rooms of sixty kinds, tried on rooms of twenty others.

A grade is ``10 exp(-lost / 10)``, and ``lost`` a sum of what faults and missing traits take off, each with a weight of
at least 0 (`sceneweaver.rules.grades`), so that no grade rises with a fault. The weights are those with the least
square error of the grades, held a little toward 0. A trait is enough where a tenth of the rooms have more of it. How
well this holds is measured twice: by leaving out a ninth of the kinds of rooms at a time, and on rooms that had no part
in any choice, each with two judges.

    python -m benchmarks.critic_fit [--write] [--processes N]
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.stats import spearmanr

from benchmarks.console import say
from benchmarks.judged_rooms import DESIGNED, JudgedRoom, Measured, judged_rooms, measured
from benchmarks.strict_eyes import GRADED
from sceneweaver.critic.grade import FULL
from sceneweaver.rules import grades as knowledge
from sceneweaver.rules.grades import TRAITS, CriterionWeights, GradeWeights

Array = NDArray[np.float64]

LID = 0.4
"""Share of its points that a lid takes. What it is for, a room without what it is made of, is not among the rooms; in
these, where it stood for less, a smaller share fitted as well and a whole one worse."""

LEAST_OWN, LEAST = 0.3, 0.1
"""Least weight of a check for its own grade, and of all else that is wrong: nothing is free."""

RIDGE = 0.005
"""Pull of the weights toward 0, in squared grades for a weight that takes a standard deviation off."""

ENOUGH = 0.9
"""Quantile of a trait from which on more of it is no better."""

FOLDS, ROUNDS = 9, 3
"""Parts into which the kinds are dealt, and how often they are dealt anew."""

FILE = Path(knowledge.__file__).with_name("grade_weights.yaml")


def enough_of(rows: Sequence[Measured]) -> dict[str, float]:
    """By trait, how much of it is as good as more."""
    return {name: float(np.quantile([getattr(row.traits, name) for row in rows], ENOUGH)) for name in TRAITS}


def columns(rows: Sequence[Measured], criterion: int, enough: dict[str, float]) -> tuple[Array, Array]:
    """What takes points off one grade [n, 5 + traits], as `CriterionWeights` has it, and the points of lids [n]."""
    checks, rules, lids = (
        np.array([[getattr(one, name) for one in row.lost] for row in rows]) for name in ("checks", "rules", "lid")
    )
    short = [np.maximum(0.0, enough[name] - np.array([getattr(row.traits, name) for row in rows])) for name in TRAITS]
    own = (checks[:, criterion], checks.sum(axis=1) - checks[:, criterion])
    own += (rules[:, criterion], rules.sum(axis=1) - rules[:, criterion])
    return np.stack([np.ones(len(rows)), *own, *short], axis=1), LID * lids[:, criterion]


def fit(rows: Sequence[Measured], grades: Array) -> GradeWeights:
    """The weights that explain grades [n, 4] of rooms best."""
    enough, criteria = enough_of(rows), {}
    for c, name in enumerate(GRADED):
        matrix, lids = columns(rows, c, enough)
        scale = np.maximum(matrix.std(axis=0), 1e-6)
        scale[0] = 1.0
        low = np.array([0.0, LEAST_OWN, LEAST, LEAST, LEAST, *(0.0 for _ in TRAITS)]) * scale
        held = np.sqrt(RIDGE * len(rows)) * np.array([0.0, *np.ones(len(low) - 1)])
        plain, wanted = matrix / scale, grades[:, c]

        def errors(
            weights: Array, plain: Array = plain, lids: Array = lids, wanted: Array = wanted, held: Array = held
        ) -> Array:
            return np.concatenate([graded(plain @ weights + lids) - wanted, 0.5 * held * weights])

        start = np.maximum(low + 1e-6, 0.3)
        start[0] = 4.0
        found = least_squares(errors, start, bounds=(low, np.inf)).x / scale
        criteria[name] = CriterionWeights(*map(float, found[:5]), dict(zip(TRAITS, map(float, found[5:]), strict=True)))
    return GradeWeights(LID, enough, criteria)


def graded(lost: Array) -> Array:
    """Grades after points lost."""
    return FULL * np.exp(-np.clip(lost, 0.0, 20.0 * FULL) / FULL)


def predicted(rows: Sequence[Measured], weights: GradeWeights) -> Array:
    """Grades [n, 4] by weights."""
    found = []
    for c, name in enumerate(GRADED):
        row = weights.criteria[name]
        matrix, lids = columns(rows, c, dict(weights.enough))
        factors = [row.baseline, row.own_checks, row.other_checks, row.own_rules, row.other_rules]
        found.append(graded(matrix @ np.array([*factors, *(row.short[name] for name in TRAITS)]) + lids))
    return np.stack(found, axis=1)


def left_out(rooms: Sequence[JudgedRoom], rows: Sequence[Measured]) -> Array:
    """Grades [n, 4] of each room by fits to rooms of other kinds."""
    wanted, found = means(rooms), np.zeros((len(rooms), len(GRADED)))
    kinds = np.array([room.kind for room in rooms])
    for seed in range(ROUNDS):
        names = np.array(sorted(set(kinds)))
        np.random.default_rng(seed).shuffle(names)
        for k in range(FOLDS):
            out = np.isin(kinds, names[k::FOLDS])
            if out.any() and not out.all():
                weights = fit([row for row, gone in zip(rows, out, strict=True) if not gone], wanted[~out])
                found[out] += predicted([row for row, gone in zip(rows, out, strict=True) if gone], weights) / ROUNDS
    return found


def means(rooms: Sequence[JudgedRoom]) -> Array:
    """Mean grades [n, 4] of the judges of each room."""
    return np.array([room.grades.mean(axis=0) for room in rooms])


def agreement(strict: Array, ours: Array) -> list[tuple[str, float, float, float]]:
    """For each criterion and the mean of all: name, rank correlation, mean error and bias of grades [n, 4]."""
    found = []
    for name, a, b in (
        *((name, strict[:, k], ours[:, k]) for k, name in enumerate(GRADED)),
        ("mean", strict.mean(axis=1), ours.mean(axis=1)),
    ):
        ranks: Any = spearmanr(a, b) if len(set(a)) > 1 and len(set(b)) > 1 else (0.0,)
        found.append((name, float(ranks[0]), float(np.abs(a - b).mean()), float((b - a).mean())))
    return found


def text(weights: GradeWeights) -> str:
    """The file of fitted weights."""

    def row(values: dict[str, float]) -> str:
        return "{" + ", ".join(f"{name}: {value:.3f}" for name, value in values.items()) + "}"

    lines = [
        "# How grades follow from faults and traits. Written by `python -m benchmarks.critic_fit --write`.",
        f"lid: {weights.lid:g}",
        f"enough: {row(dict(weights.enough))}",
        "criteria:",
    ]
    for name, one in weights.criteria.items():
        lines.append(f"  {name}:")
        lines += [
            f"    {key}: {getattr(one, key):.3f}"
            for key in ("baseline", "own_checks", "other_checks", "own_rules", "other_rules")
        ]
        lines.append(f"    short: {row(dict(one.short))}")
    return "\n".join(lines) + "\n"


def main(arguments: Sequence[str] | None = None) -> None:
    """Fit, say how well it holds on kinds of rooms that the fit has not seen, and write the weights where asked."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.critic_fit", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--write", action="store_true", help=f"write {FILE.name}")
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args(arguments)
    rooms, held = judged_rooms("fit"), judged_rooms("held_out")
    rows, others = measured(rooms, options.processes), measured(held, options.processes)
    weights = fit(rows, means(rooms))
    _say("fitted", rooms, means(rooms), predicted(rows, weights))
    _say("kinds left out", rooms, means(rooms), left_out(rooms, rows))
    _say("held-out kinds", held, means(held), predicted(others, weights))
    one, two = (np.array([room.grades[k] for room in held]) for k in (0, 1))
    _say("their two judges", held, one, two)
    if options.write:
        FILE.write_text(text(weights), "utf-8")


def _say(what: str, rooms: Sequence[JudgedRoom], strict: Array, ours: Array) -> None:
    designed = np.array([room.made == DESIGNED for room in rooms])
    for which, chosen in (("all", np.ones(len(rooms), bool)), ("as designed", designed)):
        found = agreement(strict[chosen], ours[chosen])
        parts = ", ".join(f"{name} {rank:.2f} ({error:.2f}, {bias:+.2f})" for name, rank, error, bias in found)
        say(f"{what}, {int(chosen.sum())} {which}: rank correlation (mean error, bias): {parts}")


if __name__ == "__main__":
    main()
