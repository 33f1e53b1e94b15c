"""How much each design rule costs: points fitted to the grades of strict eyes, and tried on scenes that were left out.

A grade is ``10 exp(-lost / 10)``. Lost points are a baseline for what only eyes can tell, those of the older checks,
and for each rule its points times its breaches up to a most, times how much the criterion feels breaches of its own
rules (`weights`) or of the others' (`others`): who sees one thing wrong marks down the rest. In ``-10 ln(grade / 10)``
that is linear in the points, so they come from a non-negative least squares problem that is held at the drafted points
by a ridge; how much each criterion feels comes from another, with two unknowns for a criterion, that is held at 1; both
in turn. Rows are weighted by the grade, so that errors count as errors of grades. The baseline is a share of all that
strict eyes took off: that of the faults that only eyes can tell, or a few times as much, as not all that they see is
named. This and the strengths of the two ridges are those with the best mean rank correlation on scenes that were left
out, as grades are there to tell better from worse.

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
from sceneweaver.rules import design as knowledge

Array = NDArray[np.float64]

RIDGES = (0.05, 0.1, 0.2, 1.0)
"""Strengths of the pull toward the drafted points, in squared points of a grade for a point that is twice the
draft; weaker ones let a rule cost ten times its draft for a single scene."""

HOLDS = (0.1, 0.3, 1.0)
"""Strengths of the pull of what a criterion feels toward 1, in shares of what its breaches say."""

UNNAMED = (1.0, 2.0, 3.0, 4.0)
"""How much eyes alone take off, in shares of the faults that they name."""

LEAST = 0.25
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
    """Points of each rule [rules], how much each criterion feels those of its own rules and of the others' [4, 2], its
    baseline [4], and the common scale of the draft."""

    points: Array
    felt: Array
    baseline: Array
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
    """What is chosen by scenes that were left out: see `RIDGES`, `HOLDS`, `UNNAMED`."""

    ridge: float
    hold: float
    unnamed: float


def fit(data: Counted, rows: NDArray[np.intp], options: Options) -> Fit:
    """The points that explain the grades of some scenes best, and how much each criterion feels them."""
    lost, weight = data.lost[rows], data.grades[rows] / FULL
    baseline = options.unnamed * data.eyes * lost.mean(axis=0)
    target = (lost - data.older[rows] - baseline) * weight
    blocks = [_split(data, rows, c) * weight[:, c, None, None] for c in range(len(GRADED))]
    felt = np.ones((len(GRADED), 2))
    points, scale = data.drafted, 1.0
    for _ in range(ROUNDS):
        matrix = np.vstack([np.einsum("nrk,k->nr", block, w) for w, block in zip(felt, blocks, strict=True)])
        right = target.T.reshape(-1)
        scale = max(1e-3, float(nnls((matrix @ data.drafted)[:, None], right)[0][0]))
        draft = scale * data.drafted
        low, held = LEAST * draft, np.sqrt(options.ridge)
        # points = low + x with x >= 0, and held * (points / draft - 1) small
        system = np.vstack([matrix, np.diag(held / draft)])
        points = low + nnls(system, np.hstack([right, np.full(len(draft), held)]) - system @ low)[0]
        felt = np.array([_felt(block, points, target[:, c], options.hold) for c, block in enumerate(blocks)])
        felt /= felt.mean()
    return Fit(points, felt, baseline, scale)


def _split(data: Counted, rows: NDArray[np.intp], criterion: int) -> Array:
    """Breaches [rows, rules, 2] of a criterion's own rules and of the others'."""
    own = data.own == criterion
    return data.breaches[rows][:, :, None] * np.stack([own, ~own], axis=1)


def _felt(block: Array, points: Array, target: Array, hold: float) -> Array:
    """How much a criterion feels the breaches of its own rules and of the others' [2], held at 1."""
    lost = np.einsum("nrk,r->nk", block, points)
    held = np.sqrt(hold) * np.linalg.norm(lost, axis=0)
    return nnls(np.vstack([lost, np.diag(held)]), np.hstack([target, held]))[0]


def predicted(data: Counted, rows: NDArray[np.intp], found: Fit) -> Array:
    """Grades [rows, 4] by a fit."""
    columns = []
    for c in range(len(GRADED)):
        breaches = np.einsum("nrk,r,k->n", _split(data, rows, c), found.points, found.felt[c])
        columns.append(FULL * np.exp(-(found.baseline[c] + data.older[rows, c] + breaches) / FULL))
    return np.stack(columns, axis=1)


def left_out(data: Counted, options: Options) -> Array:
    """Grades [n, 4] of each scene by the fit to all others."""
    rows = np.arange(len(data.grades))
    return np.vstack([predicted(data, rows[[k]], fit(data, np.delete(rows, k), options)) for k in rows])


def chosen(data: Counted) -> Options:
    """The options with the best mean rank correlation on scenes that were left out."""

    def ranks(options: Options) -> float:
        return sum(rank for _, rank, _ in agreement(data.grades, left_out(data, options)))

    return max((Options(*row) for row in product(RIDGES, HOLDS, UNNAMED)), key=ranks)


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

    def row(name: str, values: Array) -> str:
        return f"{name}: {{" + ", ".join(f"{c}: {v:.3f}" for c, v in zip(GRADED, values, strict=True)) + "}"

    lines = [
        "# What a breach of each design rule costs. Written by `python -m benchmarks.critic_fit --write`; not by hand.",
        row("baseline", found.baseline),
        row("weights", found.felt[:, 0]),
        row("others", found.felt[:, 1]),
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
