"""The leaderboard of Layout Bench, from results: tables of what methods found, paired tests, curves over time."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import read_text, write_atomic
from sceneweaver.problems import ProblemCase, layout_bench
from sceneweaver.scene import InputError

from .curves import interval, methods, table, value_at
from .pairs import Pair, paired
from .protocol import SOLVED, read_budgets, read_protocol, verdicts, whole_seeds
from .quality import Judged
from .results import Key, Run, needed, read_about
from .tables import rows_in_markdown

BEGIN, END = "<!-- leaderboard: written by a command -->", "<!-- end -->"
POINTS = 40

LINE = 120
"""Characters of a line of the page."""

STYLES = ("-", "--", ":")


@dataclass(frozen=True)
class Place:
    """What a method did with one budget.

    Attributes:
        quality, low, high: mean over problems and seeds of `Judged.quality`, and its 95 % bootstrap interval.
        within: for each of `SOLVED` the share of runs whose valid layout is that near to the best known.
        valid: share of runs with a valid layout, by the judge.
        runs, failed, killed, faults: how many there were, raised an error, were killed, or said what is not so.
        tiers: mean quality by tier.
    """

    method: str
    seconds: float
    quality: float
    low: float
    high: float
    within: tuple[float, ...]
    valid: float
    runs: int
    failed: int
    killed: int
    faults: int
    tiers: Mapping[str, float]


def qualities(runs: Sequence[Run], found: Mapping[Key, Judged]) -> dict[str, np.ndarray]:
    """For each method its qualities [problem, seed]; NaN where there is no run."""
    return table(runs, lambda run: found[run.key].quality)


def places(runs: Sequence[Run], found: Mapping[Key, Judged], seconds: float) -> list[Place]:
    """A place for each method, the best first."""
    rows = []
    for method, values in qualities(runs, found).items():
        own = [run for run in runs if run.key[0] == method]
        good = [found[run.key].quality for run in own]
        tiers: dict[str, list[float]] = {}
        for run, value in zip(own, good, strict=True):
            tiers.setdefault(layout_bench.tier_of(run.key[1]) or "other", []).append(value)
        low, high = interval(values)
        rows.append(
            Place(
                method,
                seconds,
                quality=float(np.nanmean(values)),
                low=low,
                high=high,
                within=tuple(float(np.mean([_solved(found[run.key], share) for run in own])) for share in SOLVED),
                valid=float(np.mean([found[run.key].valid for run in own])),
                runs=len(own),
                failed=sum(run.last("outcome") == "failed" for run in own),
                killed=sum(run.last("outcome") == "killed" for run in own),
                faults=sum(bool(found[run.key].fault) for run in own),
                tiers={tier: float(np.mean(v)) for tier, v in tiers.items()},
            )
        )
    return sorted(rows, key=lambda row: -row.quality)


def _solved(one: Judged, share: float) -> bool:
    return one.valid and one.quality >= 1.0 / (1.0 + share) - 1e-9


def anytime(runs: Sequence[Run], points: np.ndarray, cases: Mapping[str, ProblemCase]) -> dict[str, np.ndarray]:
    """Mean quality at times [K] of each method, by what the engine said at the looks (most keep no layouts)."""
    found: dict[str, list[np.ndarray]] = {}
    for run in runs:
        valid, best = value_at(run, "valid", "seconds", points) > 0, cases[run.key[1]].best_objective
        quality = valid.astype(float)
        if best is not None:
            with np.errstate(divide="ignore", invalid="ignore"):
                quality *= np.minimum(best / value_at(run, "best_objective", "seconds", points), 1.0)
        found.setdefault(run.key[0], []).append(np.nan_to_num(quality))
    return {method: np.mean(rows, axis=0) for method, rows in found.items()}


def leaderboard(out: Path | str, cases: Mapping[str, ProblemCase]) -> dict[str, Any]:
    """All that the page says, as JSON data: places and pairs for each budget, and what the results are of.

    Raises:
        InputError: there are no results, or they are on problems that are not among ``cases``.

    Examples:
        >>> from sceneweaver.bench import leaderboard
        >>> leaderboard("no such folder", {})
        Traceback (most recent call last):
        ...
        sceneweaver.io.errors.InputError: no such folder: no results of Layout Bench; ...
    """
    runs, about = whole_seeds(read_protocol(out)), read_about(out)
    budgets = []
    for seconds, found in verdicts(out, runs, read_budgets(out), cases).items():
        read = [run.at(seconds) for run in runs]
        board, own = places(read, found, seconds), qualities(read, found)
        budgets.append(
            {
                "seconds": seconds,
                "problems": len({run.key[1] for run in runs}),
                "seeds": len({run.key[2] for run in runs}),
                "places": [asdict(row) for row in board],
                "pairs": [asdict(pair) for pair in paired({row.method: own[row.method] for row in board})],
            }
        )
    manifest = layout_bench.manifest()
    return {"version": layout_bench.VERSION, "hash": manifest.get("hash", ""), "budgets": budgets, **about}


def board_markdown(data: Mapping[str, Any]) -> str:
    """The tables of a leaderboard in Markdown.

    Examples:
        >>> from sceneweaver.bench import board_markdown
        >>> of = {"machine": {"system": "Linux", "cores": 2}, "settings": {"clock": "cpu", "device": "cpu"}}
        >>> of["settings"]["candidates"] = 8
        >>> text = board_markdown({**of, "version": "1.0.0", "hash": "0" * 64, "budgets": []})
        >>> text.splitlines()[0]
        'Version 1.0.0 (000000000000); Linux, 2 cores, cpu; budgets in processor time, 8 candidates.'
    """
    machine, settings = data["machine"], data["settings"]
    clock = "processor time" if settings["clock"] == "cpu" else "wall time"
    first = (
        f"Version {data['version']} ({data['hash'][:12]}); {machine['system']}, {machine['cores']} cores, "
        f"{' '.join([settings['device'], machine.get('device') or '']).strip()}; budgets in {clock}, "
        f"{settings['candidates']} candidates."
    )
    parts = [textwrap.fill(first, LINE, break_on_hyphens=False)]
    for budget in data["budgets"]:
        tiers = [tier for tier in layout_bench.TIERS if any(tier in row["tiers"] for row in budget["places"])]
        head = ["method", "quality", "95 %", *(f"within {s:.0%}" for s in SOLVED), "valid", *tiers, "failed", "killed"]
        rows = [
            [
                row["method"],
                f"{row['quality']:.3f}",
                f"{row['low']:.3f} to {row['high']:.3f}",
                *(f"{share:.0%}" for share in row["within"]),
                f"{row['valid']:.0%}",
                *(f"{row['tiers'][tier]:.3f}" if tier in row["tiers"] else "-" for tier in tiers),
                f"{row['failed']}/{row['runs']}",
                f"{row['killed']}/{row['runs']}",
            ]
            for row in budget["places"]
        ]
        title = f"**{budget['seconds']:g} s**, {budget['problems']} problems, {budget['seeds']} seeds:"
        parts += ["", title, "", *rows_in_markdown(head, rows)]
        parts += ["", *_pairs([Pair(**pair) for pair in budget["pairs"]])]
        if false := [f"{row['method']} {row['faults']}" for row in budget["places"] if row["faults"]]:
            parts += ["", f"Runs that said what is not so, and count as nothing found: {', '.join(false)}."]
    return "\n".join(parts)


def _pairs(pairs: Sequence[Pair]) -> list[str]:
    """The pairs that the first method is in: with twenty methods there are 200 in all."""
    count, pairs = len(pairs), [pair for pair in pairs if pairs[0].first in (pair.first, pair.second)]
    if not pairs:
        return []
    rows = [
        [
            f"{pair.first} - {pair.second}",
            f"{pair.difference:+.3f}",
            f"{pair.low:+.3f} to {pair.high:+.3f}",
            f"{pair.p:.2g}",
            f"{pair.adjusted:.2g}",
        ]
        for pair in pairs
    ]
    head = ["first - second", "difference", "95 %", "p (Wilcoxon)", "p (Holm)"]
    return [
        f"The first against each of the others, p after Holm for all {count} pairs:",
        "",
        *rows_in_markdown(head, rows),
    ]


def write_page(page: Path | str, text: str) -> None:
    """Put a leaderboard into a page between its marks.

    Raises:
        InputError: the page has no such marks.
    """
    before = read_text(Path(page))
    pattern = f"{re.escape(BEGIN)}.*?{re.escape(END)}"
    if not re.search(pattern, before, flags=re.DOTALL):
        raise InputError(f"{page}: has no place for a leaderboard; put {BEGIN} and {END} into it")
    whole = f"{BEGIN}\n\n{text}\n\n{END}"
    write_atomic(Path(page), re.sub(pattern, lambda _: whole, before, flags=re.DOTALL))


def plot_anytime(out: Path | str, picture: Path | str, cases: Mapping[str, ProblemCase]) -> Path:
    """Draw the mean quality over time."""
    runs, budgets = whole_seeds(read_protocol(out)), read_budgets(out)
    points = np.geomspace(budgets[-1] / 1000.0, budgets[-1], POINTS)
    figure = needed("matplotlib.figure").Figure(figsize=(7, 4.8), layout="constrained")
    axes, curves = figure.subplots(), anytime(runs, points, cases)
    for k, method in enumerate(sorted(methods(runs), key=lambda name: -curves[name][-1])):
        axes.plot(points, curves[method], label=method, color=f"C{k % 10}", linestyle=STYLES[k // 10 % len(STYLES)])
    for budget in budgets[:-1]:
        axes.axvline(budget, color="0.8", linewidth=0.8, zorder=0)
    axes.set(xscale="log", ylim=(0, 1.02), xlabel="seconds", ylabel="mean quality")
    axes.legend(fontsize=6, loc="upper left", ncols=2)
    figure.savefig(picture, dpi=110)
    return Path(picture)
