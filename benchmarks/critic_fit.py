"""How much each design rule costs: points fitted to the grades of strict eyes, and tried on scenes that were left out.

A grade is ``10 exp(-lost / 10)``. Lost points are a baseline for what only eyes can tell, those of the older checks,
for each rule its points times its breaches up to a most, and a share of those of the other criteria's rules (`spill`),
all of it times how much the criterion feels breaches. In ``-10 ln(grade / 10)`` that is linear in the points, so they
come from a non-negative least squares problem that is held at the drafted points by a ridge, and the weights of the
criteria from another, in turn. Rows are weighted by the grade, so that errors count as errors of grades. The
baseline is a share of all that strict eyes took off: that of the faults that only eyes can tell, or a few times as
much, as not all that they see is named. This, the strength of the ridge and the spill are those with the best mean rank
correlation on scenes that were left out, as grades are there to tell better from worse.

    python -m benchmarks.critic_fit [--write]
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls
from scipy.stats import spearmanr

from benchmarks.console import say
from benchmarks.strict_eyes import GRADED, Comparison, comparisons, labels
from sceneweaver.critic.grade import FULL, older_lost
from sceneweaver.knowledge import design_rules as knowledge

Array = NDArray[np.float64]

RIDGES = (0.05, 0.1, 0.2, 0.5, 1.0)
"""Strengths of the pull toward the drafted points, in squared points of a grade for a point that is twice the draft."""

SPILLS = (0.25, 0.5, 0.75)
"""Shares of a breach that the other criteria lose."""

UNNAMED = (1.0, 2.0, 3.0, 4.0)
"""How much eyes alone take off, in shares of the faults that they name."""

LEAST = 0.5
"""Share of its drafted points that a rule costs at least: no breach is free."""

ROUNDS = 8
"""Times that points and weights of the criteria are fitted in turn."""

FILE = Path(knowledge.__file__).with_name("design_points.yaml")


@dataclass(frozen=True)
class Counted:
    """Graded scenes in numbers: breaches [n, rules] up to the most, points of older checks [n, 4], grades [n, 4].

    ``drafted`` [rules] are the points before the fit, ``own`` [rules] the index of each rule's criterion, ``eyes`` the
    share of faults that only eyes can tell.
    """

    rules: tuple[str, ...]
    drafted: Array
    own: NDArray[np.intp]
    breaches: Array
    older: Array
    grades: Array
    eyes: float

    @property
    def lost(self) -> Array:
        """Points that strict eyes took off [n, 4]."""
        return -FULL * np.log(self.grades / FULL)


@dataclass(frozen=True)
class Fit:
    """Points of each rule [rules], how much each criterion feels them [4] and its baseline [4], the spill, and the
    common scale of the draft."""

    points: Array
    weights: Array
    baseline: Array
    spill: float
    scale: float


def counted(found: Sequence[Comparison]) -> Counted:
    """The numbers of graded scenes."""
    fitted = knowledge.design_rules()
    rules = [r for r in knowledge.drafted_rules().values() if r.drafted > 0.0]
    breaches, older = np.zeros((len(found), len(rules))), np.zeros((len(found), len(GRADED)))
    for n, comparison in enumerate(found):
        points: dict[tuple[str, str], float] = defaultdict(float)
        for fault in comparison.review.faults:
            points[fault.criterion, fault.kind] += fault.points
        for k, rule in enumerate(rules):
            times = points[rule.criterion, rule.id] / max(fitted[rule.id].points, 1e-9)
            breaches[n, k] = min(times, rule.most / rule.drafted)
        for c, name in enumerate(GRADED):
            older[n, c] = older_lost(f for f in comparison.review.faults if f.criterion == name)
    every = [label for c in found for label in c.graded.labels]
    return Counted(
        rules=tuple(r.id for r in rules),
        drafted=np.array([r.drafted for r in rules]),
        own=np.array([GRADED.index(r.criterion) for r in rules]),
        breaches=breaches,
        older=older,
        grades=np.array([[c.graded.grades[name] for name in GRADED] for c in found]),
        eyes=sum(bool(label.eyes) for label in every) / max(1, len(every)),
    )


class Options(NamedTuple):
    """What is chosen by scenes that were left out: see `RIDGES`, `SPILLS`, `UNNAMED`."""

    ridge: float
    spill: float
    unnamed: float


def fit(data: Counted, rows: NDArray[np.intp], options: Options) -> Fit:
    """The points that explain the grades of some scenes best, and how much each criterion feels them."""
    lost, weight = data.lost[rows], data.grades[rows] / FULL
    baseline = options.unnamed * data.eyes * lost.mean(axis=0)
    target = (lost - data.older[rows] - baseline) * weight
    felt = [data.breaches[rows] * np.where(data.own == c, 1.0, options.spill) for c in range(len(GRADED))]
    blocks = [block * weight[:, c, None] for c, block in enumerate(felt)]
    weights = np.ones(len(GRADED))
    points, scale = data.drafted, 1.0
    for _ in range(ROUNDS):
        matrix = np.vstack([w * block for w, block in zip(weights, blocks, strict=True)])
        right = target.T.reshape(-1)
        scale = max(1e-3, float(nnls((matrix @ data.drafted)[:, None], right)[0][0]))
        draft = scale * data.drafted
        low, held = LEAST * draft, np.sqrt(options.ridge)
        # points = low + x with x >= 0, and held * (points / draft - 1) small
        system = np.vstack([matrix, np.diag(held / draft)])
        points = low + nnls(system, np.hstack([right, np.full(len(draft), held)]) - system @ low)[0]
        weights = np.array([nnls((block @ points)[:, None], target[:, c])[0][0] for c, block in enumerate(blocks)])
        weights /= weights.mean()
    return Fit(points, weights, baseline, options.spill, scale)


def predicted(data: Counted, rows: NDArray[np.intp], found: Fit) -> Array:
    """Grades [rows, 4] by a fit."""
    columns = []
    for c in range(len(GRADED)):
        share = np.where(data.own == c, 1.0, found.spill)
        breaches = (data.breaches[rows] * share) @ found.points
        lost = found.baseline[c] + data.older[rows, c] + found.weights[c] * breaches
        columns.append(FULL * np.exp(-lost / FULL))
    return np.stack(columns, axis=1)


def left_out(data: Counted, options: Options) -> Array:
    """Grades [n, 4] of each scene by the fit to all others."""
    rows = np.arange(len(data.grades))
    return np.vstack([predicted(data, rows[[k]], fit(data, np.delete(rows, k), options)) for k in rows])


def chosen(data: Counted) -> Options:
    """The options with the best mean rank correlation on scenes that were left out."""

    def ranks(options: Options) -> float:
        return sum(rank for _, rank, _ in agreement(data.grades, left_out(data, options)))

    return max((Options(*row) for row in product(RIDGES, SPILLS, UNNAMED)), key=ranks)


def agreement(strict: Array, ours: Array) -> list[tuple[str, float, float]]:
    """For each criterion and the mean of all: name, rank correlation and mean error of grades [n, 4]."""
    found = []
    for name, a, b in (
        *((name, strict[:, k], ours[:, k]) for k, name in enumerate(GRADED)),
        ("mean", strict.mean(axis=1), ours.mean(axis=1)),
    ):
        ranks: Any = spearmanr(a, b) if len(set(a)) > 1 and len(set(b)) > 1 else (0.0,)
        rank = float(ranks[0])
        found.append((name, rank, float(np.abs(a - b).mean())))
    return found


def text(data: Counted, found: Fit) -> str:
    """The file of fitted points."""
    lines = [
        "# What a breach of each design rule costs. Written by `python -m benchmarks.critic_fit --write`; not by hand.",
        "baseline: {" + ", ".join(f"{c}: {b:.2f}" for c, b in zip(GRADED, found.baseline, strict=True)) + "}",
        "weights: {" + ", ".join(f"{c}: {w:.3f}" for c, w in zip(GRADED, found.weights, strict=True)) + "}",
        f"spill: {found.spill:g}",
        f"scale: {found.scale:.3f}",
        "points:",
        *(f"  {name}: {value:.2f}" for name, value in zip(data.rules, found.points, strict=True)),
    ]
    return "\n".join(lines) + "\n"


def main(arguments: Sequence[str] | None = None) -> None:
    """Fit, say how well it holds on scenes that were left out, and write the points where asked."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.critic_fit", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--write", action="store_true", help=f"write {FILE.name}")
    options = parser.parse_args(arguments)
    data = counted(list(comparisons(labels())))
    best = chosen(data)
    found = fit(data, np.arange(len(data.grades)), best)
    say(f"{best}, scale {found.scale:.3f}, baseline {np.round(found.baseline, 2)}")
    inside = predicted(data, np.arange(len(data.grades)), found)
    for what, ours in (("fitted", inside), ("left out", left_out(data, best))):
        rows = ", ".join(f"{name} {rank:.2f} ({error:.2f})" for name, rank, error in agreement(data.grades, ours))
        say(f"{what}: rank correlation (mean error): {rows}")
    if options.write:
        FILE.write_text(text(data, found), "utf-8")


if __name__ == "__main__":
    main()
