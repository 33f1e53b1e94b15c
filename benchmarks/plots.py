"""Pictures of tables as PNG, when matplotlib is there (a development dependency)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from benchmarks.results import Plot, Result, Table

MISSING = "matplotlib is not installed: no plots were drawn"


def draw(result: Result, folder: Path, *, page: bool = False) -> list[Path] | None:
    """Write ``<plot>.png`` for every plot, or for those that the page shows, named by the kind of device too.

    None when there is no matplotlib.
    """
    try:
        import matplotlib
    except ImportError:
        return None
    matplotlib.use("Agg")
    paths = []
    for plot in result.plots:
        table = result.table(plot.table)
        if table.rows and (plot.page or not page):
            folder.mkdir(parents=True, exist_ok=True)
            name = f"{plot.name}-{result.machine['device'].partition(':')[0]}" if page else plot.name
            paths.append(_draw(plot, table, folder / f"{name}.png", result.machine))
    return paths


def _groups(plot: Plot, rows: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    if plot.series is None:
        return {"": rows}
    found: dict[str, list[dict[str, Any]]] = {}
    for row in rows:
        found.setdefault(str(row[plot.series]), []).append(row)
    return found


def _draw(plot: Plot, table: Table, path: Path, machine: dict[str, Any]) -> Path:
    from matplotlib.figure import Figure

    labels = {c.key: c.label for c in table.columns}
    bars = isinstance(table.rows[0][plot.x], str)
    figure = Figure(figsize=(8, 4.5), layout="constrained")
    axes = figure.subplots()
    groups = _groups(plot, table.rows)
    if bars:
        _bars(axes, plot, groups, labels)
    else:
        for key in plot.y:
            for name, rows in groups.items():
                points = [(r[plot.x], r[key]) for r in rows if r.get(key) is not None]
                axes.plot(*zip(*points, strict=True) if points else ((), ()), marker="o", label=name or labels[key])
        axes.set_xlabel(labels[plot.x])
        if plot.log_x:
            axes.set_xscale("log")
        if plot.log:
            axes.set_xscale("log")
            ticks = sorted({row[plot.x] for row in table.rows})
            axes.set_xticks(ticks, [f"{t:,}" for t in ticks])
            axes.minorticks_off()
    if plot.log:
        axes.set_yscale("log")
    else:
        axes.set_ylim(bottom=0)
    if plot.log_x:
        axes.set_ylabel(", ".join(labels[key] for key in plot.y))
    axes.set_title(plot.title)
    axes.grid(alpha=0.3)
    if len(groups) * len(plot.y) > 1:
        letters = sum(len(name) for name in groups) * len(plot.y)
        figure.legend(loc="outside lower left", ncols=4 if letters <= 48 else 2, fontsize=8)
    figure.supxlabel(
        f"{machine.get('device_name', '')}, commit {machine.get('commit', '')}", fontsize=7, x=1, ha="right"
    )
    figure.savefig(path, dpi=120)
    return path


def _bars(axes: Any, plot: Plot, groups: dict[str, list[dict[str, Any]]], labels: dict[str, str]) -> None:
    """Bars side by side, one group for each text on the x axis."""
    names = list(dict.fromkeys(str(r[plot.x]) for rows in groups.values() for r in rows))
    width = 0.8 / (len(groups) * len(plot.y))
    slot = 0
    for name, rows in groups.items():
        for key in plot.y:
            values = {str(r[plot.x]): r.get(key) for r in rows}
            heights = [values.get(n) or 0.0 for n in names]
            where = [k - 0.4 + (slot + 0.5) * width for k in range(len(names))]
            axes.bar(where, heights, width, label=name or labels[key])
            slot += 1
    axes.set_xticks(range(len(names)), names, rotation=40, ha="right", fontsize=8)
