"""Plots of a comparison: anytime curves and profiles, as PNG or SVG."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.scene import InputError

from .curves import (
    COSTS,
    Profile,
    Target,
    best_found,
    data_profile,
    instances,
    interval,
    left_at,
    methods,
    performance_profile,
    table,
    value_at,
)
from .results import Run, needed

FORMATS = ("png", "svg")
POINTS = 60
QUANTITIES = {
    "valid": "share valid",
    "left": "way to the best known objective that is left",
    "distinct": "distinct valid layouts",
}
LEAST = 1e-4  # of what is drawn on logarithmic axes
MOST_CURVES = 10  # colours, after which lines are dashed


def plot(runs: Sequence[Run], out: Path, *, target: Target | None = None, form: str = "png") -> list[Path]:
    """Write ``curves`` and ``profiles`` into a folder.

    Args:
        runs: what is drawn.
        out: the folder.
        target: of the profiles; half of the candidates valid unless said.
        form: "png" or "svg".

    Returns:
        The two files.

    Raises:
        InputError: another form. MissingDependencyError: matplotlib is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> from pathlib import Path
        >>> [str(each) for each in bench.plot(bench.read_runs(path), Path("plots"))]
        ['plots/curves.png', 'plots/profiles.png']
    """
    if form not in FORMATS:
        raise InputError(f'format: "{form}" is not one of {", ".join(FORMATS)}')
    out.mkdir(parents=True, exist_ok=True)
    drawn = {"curves": _curves(runs), "profiles": _profiles(runs, target or Target("valid", 0.5))}
    paths = []
    for name, picture in drawn.items():
        paths.append(out / f"{name}.{form}")
        picture.savefig(paths[-1], dpi=110)
    return paths


def _curves(runs: Sequence[Run]) -> Any:
    """Share valid, best objective and distinct layouts, against each cost: means over problems and seeds."""
    best, picture = best_found(runs), needed("matplotlib.figure").Figure(figsize=(15, 11), layout="constrained")
    axes = picture.subplots(len(QUANTITIES), len(COSTS), sharey="row", sharex="col")
    for j, (cost, words) in enumerate(COSTS.items()):
        points = _points(runs, cost)
        for i, (name, label) in enumerate(QUANTITIES.items()):
            for k, method in enumerate(methods(runs)):
                mine = [run for run in runs if run.key[0] == method]
                if any(np.any(run[cost] > 0) for run in mine):
                    _line(axes[i, j], _style(method, k), mine, name, cost, points, best)
            axes[i, j].set_xscale("log")
            axes[i, j].set_yscale("log" if name == "left" else "linear")
            axes[i, j].grid(alpha=0.3)
            axes[i, 0].set_ylabel(label)
        axes[-1, j].set_xlabel(words)
    _legend(picture, axes[0, 0])
    return picture


def _line(
    axes: Any, style: dict[str, Any], runs: list[Run], name: str, cost: str, points: np.ndarray, best: dict[str, float]
) -> None:
    """One method's mean; of the share valid its 95 % interval as well."""

    def value(run: Run) -> np.ndarray:
        return left_at(run, cost, points, best) if name == "left" else value_at(run, name, cost, points)

    (values,) = table(runs, value).values()
    if np.isnan(values).all():
        return
    mean = np.nanmean(values, axis=(0, 1))
    axes.plot(points, np.maximum(mean, LEAST) if name == "left" else mean, **style)
    if name == "valid":
        bands = np.array([interval(values[..., k]) for k in range(len(points))]).T
        axes.fill_between(points, *bands, color=style["color"], alpha=0.12)


def _points(runs: Sequence[Run], cost: str) -> np.ndarray:
    values = np.concatenate([run[cost] for run in runs])
    values = values[values > 0]
    return np.geomspace(values.min(), values.max(), POINTS) if values.size else np.zeros(0)


def _profiles(runs: Sequence[Run], target: Target) -> Any:
    """Performance profiles by seconds and evaluations, data profiles by evaluations, for two targets."""
    picture = needed("matplotlib.figure").Figure(figsize=(15, 9), layout="constrained")
    axes = picture.subplots(2, 3)
    for row, aim in enumerate((target, Target("objective", 0.1) if target.kind == "valid" else Target("valid", 0.5))):
        _panel(axes[row, 0], performance_profile(runs, aim, "seconds"), "multiple of the fastest, seconds", aim)
        _panel(axes[row, 1], performance_profile(runs, aim, "evaluations"), "multiple of the least, evaluations", aim)
        _panel(axes[row, 2], data_profile(runs, aim), "evaluations for each variable and one more", aim)
    _legend(picture, axes[0, 0])
    picture.suptitle(f"{len(instances(runs))} instances")
    return picture


def _panel(axes: Any, profile: Profile, label: str, target: Target) -> None:
    for k, (method, shares) in enumerate(zip(profile.methods, profile.shares, strict=True)):
        axes.step(profile.at, shares, where="post", **_style(method, k))
    axes.set_xscale("log")
    axes.set_ylim(-0.02, 1.02)
    axes.set_xlabel(label)
    axes.set_ylabel("share of instances")
    axes.set_title(str(target), fontsize=10)
    axes.grid(alpha=0.3)


def _style(method: str, k: int) -> dict[str, Any]:
    return {
        "label": method,
        "color": f"C{k % MOST_CURVES}",
        "linestyle": "-" if k < MOST_CURVES else "--",
        "linewidth": 1.4,
    }


def _legend(picture: Any, axes: Any) -> None:
    handles, labels = axes.get_legend_handles_labels()
    picture.legend(handles, labels, loc="outside lower center", ncols=8, fontsize=9)
