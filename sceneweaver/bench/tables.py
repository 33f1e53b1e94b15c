"""Tables of a comparison: quality next to time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from .curves import COSTS, FLOOR, Target, best_found, cost_to, gap_at, interval, methods, table
from .results import Run


@dataclass(frozen=True)
class Line:
    """What a method did on all problems.

    Attributes:
        runs, failed: how many there were, and how many failed or were killed.
        solved: share of runs in which a candidate is valid at the end.
        valid, low, high: share of candidates that are valid at the end, mean over runs, and its 95 % interval.
        distinct: distinct valid layouts at the end, mean over runs.
        gap: median over solved runs of how far the best valid layout is from the best known [m].
        reached: share of runs that reach the target.
        seconds, evaluations, energy_calls: medians over all runs of what the target cost; inf: half of them or more
            do not reach it.
        setup: median wall time of the uncounted first go [s].

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> (line,) = bench.compare(bench.read_runs(path))
        >>> line.method, line.runs, line.failed
        ('adam', 1, 0)
    """

    method: str
    runs: int
    failed: int
    solved: float
    valid: float
    low: float
    high: float
    distinct: float
    gap: float
    reached: float
    seconds: float
    evaluations: float
    energy_calls: float
    setup: float

    def to_dict(self) -> dict[str, Any]:
        """As JSON data; null for what is not a number."""
        return {k: None if isinstance(v, float) and not np.isfinite(v) else v for k, v in asdict(self).items()}


def compare(runs: Sequence[Run], target: Target | None = None) -> list[Line]:
    """A line for each method, the largest share of valid candidates first.

    Args:
        runs: of several methods on the same problems and seeds.
        target: what has to be reached; half of the candidates valid unless said.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> len(bench.compare(bench.read_runs(path), bench.Target("objective", 0.1)))
        2
    """
    target = target or Target("valid", 0.5)
    best, shares = best_found(runs), table(runs, lambda run: float(run.last("valid")))
    lines = [_line(method, [r for r in runs if r.key[0] == method], shares[method], target, best) for method in shares]
    return sorted(lines, key=lambda line: (-line.valid, line.seconds))


def _line(method: str, runs: list[Run], shares: np.ndarray, target: Target, best: dict[str, float]) -> Line:
    def middle(values: list[float]) -> float:
        return float(np.percentile(values, 50, method="higher")) if values else np.inf

    needed = {cost: [cost_to(run, target, cost, best) for run in runs] for cost in COSTS}
    gaps = [float(gap_at(run, "seconds", np.array([np.inf]), best)[0]) for run in runs]
    return Line(
        method,
        runs=len(runs),
        failed=sum(run.failed for run in runs),
        solved=float(np.mean([run.last("valid") > 0 for run in runs])),
        valid=float(np.nanmean(shares)),
        **dict(zip(("low", "high"), interval(shares), strict=True)),
        distinct=float(np.mean([run.last("distinct") for run in runs])),
        gap=middle([gap for gap in gaps if np.isfinite(gap)]),
        reached=float(np.mean(np.isfinite(needed["seconds"]))),
        **{cost: middle(values) for cost, values in needed.items()},
        setup=float(np.median([run.last("setup_seconds") for run in runs])),
    )


def by_family(runs: Sequence[Run]) -> dict[str, dict[str, float]]:
    """For each method and family the share of candidates that are valid at the end."""
    found: dict[str, dict[str, list[float]]] = {method: {} for method in methods(runs)}
    for run in runs:
        found[run.key[0]].setdefault(str(run.last("family")), []).append(float(run.last("valid")))
    return {method: {name: float(np.mean(v)) for name, v in rows.items()} for method, rows in found.items()}


def failures(runs: Sequence[Run]) -> list[str]:
    """What went wrong: a line for each method and reason, with how often."""
    found: dict[tuple[str, str], list[str]] = {}
    for run in runs:
        if run.failed:
            found.setdefault((run.key[0], str(run.last("reason"))), []).append(run.key[1])
    return [
        f"{method}: {reason} ({len(p)} runs: {p[0]}{' ...' if len(p) > 1 else ''})"
        for (method, reason), p in found.items()
    ]


def markdown(runs: Sequence[Run], target: Target | None = None) -> str:
    """The tables as Markdown. Arguments as for `compare`.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> bench.markdown(bench.read_runs(path)).splitlines()[0]
        'Target: 50% of candidates valid.'
    """
    target = target or Target("valid", 0.5)
    lines = compare(runs, target)
    rows = [[cell(line) for cell in _CELLS.values()] for line in lines]
    parts = [f"Target: {target}.", "", *rows_in_markdown([*_CELLS], rows)]
    families = by_family(runs)
    names = sorted({name for row in families.values() for name in row})
    if len(names) > 1:
        values = [[line.method, *(_share(families[line.method].get(name)) for name in names)] for line in lines]
        parts += ["", "Valid at the end, by family:", "", *rows_in_markdown(["method", *names], values)]
    if wrong := failures(runs):
        parts += ["", "Failed:", "", *(f"- {text}" for text in wrong)]
    return "\n".join(parts)


_CELLS: dict[str, Callable[[Line], str]] = {
    "method": lambda line: line.method,
    "valid": lambda line: f"{line.valid:.1%}",
    "95 %": lambda line: f"{line.low:.1%} to {line.high:.1%}",
    "solved": lambda line: f"{line.solved:.1%}",
    "distinct": lambda line: f"{line.distinct:.1f}",
    "gap [m]": lambda line: "0" if line.gap < FLOOR else _number(line.gap),
    "reached": lambda line: f"{line.reached:.1%}",
    "seconds": lambda line: _number(line.seconds),
    "evaluations": lambda line: _number(line.evaluations),
    "energy calls": lambda line: _number(line.energy_calls),
    "setup [s]": lambda line: _number(line.setup),
    "failed": lambda line: f"{line.failed}/{line.runs}",
}
"""The table of methods: heads, and what stands below them."""


def _share(value: float | None) -> str:
    return "-" if value is None else f"{value:.0%}"


def _number(value: float) -> str:
    if not np.isfinite(value):
        return "-"
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"


def rows_in_markdown(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """A table in Markdown, line by line; all but the first column is to the right."""
    rule = ["---", *["---:"] * (len(head) - 1)]
    return ["| " + " | ".join(cells) + " |" for cells in (head, rule, *rows)]
