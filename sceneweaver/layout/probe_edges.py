"""What a relation of the user's own is tried with beside samples anywhere: edge, jumps, slopes, ids, other params."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from sceneweaver.scene import InputError

from .probe_samples import Samples

Values = Callable[[Samples], np.ndarray]  # a residual [K] at samples
Said = Callable[[Samples, int, Mapping[str, float], tuple[str, str]], bool]
"""What the predicate says of the k-th of some samples, with params and the ids of the two things."""

BEYOND, WITHIN = 0.02, 0.01
"""[m] from its edge, outside and inside, a residual is compared with the predicate."""

HALVINGS = 14
EDGE_WRONG = 0.5  # share of the poses near the edge that the predicate may deny
STRIDE, JUMPS = 0.05, 0.05  # [m] of a small movement, and the share of those that may jump
STEEPEST, FLATTEST = 30.0, 1.0 / 300.0  # [m/m] that a movement may change a residual by, times its scale
NAMED = 24  # samples with other ids
OTHER = (0.8, 1.25)  # times the defaults of the params
OTHER_WRONG = 0.25  # share of the poses of a verdict that the predicate may deny with those
SURE = 0.03  # [m] from 0: what is compared there


def check_jumps(label: str, values: Values, at: Samples, value: np.ndarray, slope: np.ndarray) -> None:
    """Refuse a residual that jumps: a small movement changes it by far more than its slope says.

    Args:
        label: names it in messages.
        values: the residual.
        at: sample poses.
        value: the residual there [K].
        slope: its slopes there by the pose of the first thing [K, 4].
    """
    rng = np.random.default_rng(1)
    way = rng.normal(size=(len(value), 2))
    a = at.a.copy()
    a[:, :2] += (STRIDE * way / np.linalg.norm(way, axis=1, keepdims=True)).astype(np.float32)
    moved = replace(at, a=a)
    change = np.abs(values(moved) - value)
    steepest = np.maximum(np.linalg.norm(slope, axis=1), np.linalg.norm(_slopes(values, moved), axis=1))
    spread = float(np.subtract(*np.percentile(value, (75, 25))))
    jumps = change > 3.0 * STRIDE * steepest + 0.02 * spread
    if jumps.mean() > JUMPS:
        k = int(np.flatnonzero(jumps)[0])
        raise InputError(
            f"{label}: the residual jumps: {STRIDE * 100:g} cm change it by {change[k]:.3g} at {at.words(k)}, where "
            f"its slope says {STRIDE * steepest[k]:.2g}, and so at {jumps.mean():.0%} of the sample poses; make it "
            "continuous"
        )


def _slopes(values: Values, at: Samples, step: float = 1.0e-3) -> np.ndarray:
    found = np.zeros((len(at.a), 2))
    for c in range(2):
        up, down = at.a.copy(), at.a.copy()
        up[:, c] += step
        down[:, c] -= step
        found[:, c] = (values(replace(at, a=up)) - values(replace(at, a=down))) / (2 * step)
    return found


def check_scale(label: str, value: np.ndarray, slope: np.ndarray, scale: float) -> None:
    """Refuse a residual whose slopes [K, 4] say that its unit is not the metre that ``scale`` makes of it."""
    missing = np.linalg.norm(slope, axis=1)[value > 0] * scale
    missing = missing[missing > 1.0e-6 * scale]
    if not missing.size:
        return
    middle, high = float(np.median(missing)), float(np.percentile(missing, 90))
    if middle > STEEPEST or high < FLATTEST:
        off = middle if middle > STEEPEST else high
        raise InputError(
            f"{label}: a metre of movement changes the residual by {off / scale:.3g}, which counts as {off:.3g} m; its "
            f"unit seems to be another: give scale={scale / off:.2g} or so, or mend the residual"
        )


def check_edge(
    label: str, values: Values, starts: Samples, ends: Samples, said: Said, params: Mapping[str, float], scale: float
) -> None:
    """Refuse a predicate that says otherwise 2 cm beyond the edge of the residual, or 1 cm within.

    Args:
        label: names it in messages.
        values: the residual.
        starts, ends: poses at which something is missing, and where a descent from there leads.
        said: the predicate.
        params: their defaults.
        scale: metres that a unit of the residual counts as.
    """
    depth = -values(ends)
    for wanted, holds, words in (
        (np.full(len(depth), BEYOND / scale), False, "beyond"),
        (-np.minimum(WITHIN / scale, 0.5 * depth), True, "within"),
    ):
        at, usable = _between(values, starts, ends, wanted)
        rows = np.flatnonzero(usable & (depth > 0.1 * WITHIN / scale))
        wrong = [k for k in rows if said(at, int(k), params, ("a", "b")) != holds]
        if len(rows) and len(wrong) > EDGE_WRONG * len(rows):
            k, value = wrong[0], float(values(at)[wrong[0]])
            raise InputError(
                f"{label}: engine and judge draw the line elsewhere: where the residual is {value:.2g}, just {words} "
                f"its edge, `holds` says {not holds} at {len(wrong)} of {len(rows)} sample poses, "
                f"as at {at.words(int(k))}"
            )


def _between(values: Values, starts: Samples, ends: Samples, wanted: np.ndarray) -> tuple[Samples, np.ndarray]:
    """Poses on the way from start to end where the residual is about what is wanted [K], and which there are."""
    usable = (values(starts) > wanted) & (values(ends) < wanted)
    low, high = np.zeros(len(wanted)), np.ones(len(wanted))
    at = starts
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        a = starts.a + (ends.a - starts.a) * middle[:, None].astype(np.float32)
        at = replace(starts, a=a)
        above = values(at) > wanted
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    return at, usable & (np.abs(values(at) - wanted) < 0.3 * np.abs(wanted) + 1.0e-4)


def check_ids(label: str, at: Samples, said: Said, params: Mapping[str, float]) -> None:
    """Refuse a predicate that says something else of the same two things under other ids."""
    for k in np.linspace(0, len(at.a) - 1, NAMED).astype(int):
        one, other = (said(at, int(k), params, names) for names in (("a", "b"), ("z", "y")))
        if one != other:
            raise InputError(
                f"{label}: holds says {one} of things called a and b, and {other} of the same called z and y, with "
                f"{at.words(int(k))}; it may depend on poses, sizes and params alone"
            )


def check_other_params(
    label: str, values: Values, at: Samples, said: Said, params: Mapping[str, float], scale: float
) -> None:
    """Refuse a predicate that goes by other params than the residual: both are asked with a fifth less and more."""
    for factor in OTHER if params else ():
        changed = {name: value * factor for name, value in params.items()}
        row = at.params.copy()
        row[:, : len(params)] = list(changed.values())
        moved = replace(at, params=row)
        value = values(moved)
        for verdict, rows in ((True, value < -SURE / scale), (False, value > SURE / scale)):
            places = np.flatnonzero(rows & np.isfinite(value))
            try:
                wrong = [k for k in places if said(moved, int(k), changed, ("a", "b")) != verdict]
            except InputError:  # what a predicate does not take is no fault of the defaults
                break
            if len(wrong) > OTHER_WRONG * len(places):
                k, text = wrong[0], ", ".join(f"{n} {v:.3g}" for n, v in changed.items())
                raise InputError(
                    f"{label}: with other params ({text}) engine and judge disagree at {len(wrong)} of {len(places)} "
                    f"sample poses: the residual is {value[k]:.3g}, `holds` says {not verdict}, as at "
                    f"{at.words(int(k))}; both have to go by the same params in the same order"
                )
