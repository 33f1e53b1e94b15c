"""Which of two methods is better: paired bootstrap and Wilcoxon's signed-rank test over problems, Holm's correction.

Demšar, *Journal of Machine Learning Research* 7, 2006, on tests of several methods over several data sets; Wilcoxon,
*Biometrics Bulletin* 1, 1945, with zeros ranked as by Pratt 1959; Holm, *Scandinavian Journal of Statistics* 6, 1979.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .curves import interval


@dataclass(frozen=True)
class Pair:
    """Two methods on the same problems.

    Attributes:
        first, second: the methods.
        difference, low, high: mean over problems and seeds of the first's quality without the second's, and its 95 %
            interval by the paired bootstrap (problems, then seeds).
        p: two-sided, of Wilcoxon's test of the differences of the problems' means.
        adjusted: the same after Holm's correction for all pairs.
        problems: how many problems both were run on.

    Examples:
        >>> import numpy as np
        >>> from sceneweaver import bench
        >>> rng = np.random.default_rng(0)
        >>> good = rng.uniform(0.5, 1.0, (30, 5))
        >>> (pair,) = bench.paired({"good": good, "bad": good - 0.1})
        >>> pair.first, round(pair.difference, 3), pair.adjusted < 0.001
        ('good', 0.1, True)
    """

    first: str
    second: str
    difference: float
    low: float
    high: float
    p: float
    adjusted: float
    problems: int


def paired(qualities: Mapping[str, np.ndarray]) -> list[Pair]:
    """Every pair of methods, by arrays [problem, seed] of qualities with NaN where there is no run; the better first.

    Problems and seeds that one of the two has not are left out.

    Examples:
        >>> import numpy as np
        >>> from sceneweaver.bench import paired
        >>> (pair,) = paired({"a": np.zeros((8, 2)), "b": np.ones((8, 2))})
        >>> pair.first, pair.second, float(pair.difference)
        ('b', 'a', 1.0)
    """
    found = []
    for a, b in itertools.combinations(qualities, 2):
        off = np.asarray(qualities[a], dtype=float) - np.asarray(qualities[b], dtype=float)
        off = off[~np.isnan(off).all(axis=1)]
        if not len(off):
            continue
        first, second = a, b
        if np.nanmean(off) < 0:
            first, second, off = b, a, -off
        low, high = interval(off)
        p = wilcoxon(np.nanmean(off, axis=1))
        found.append(Pair(first, second, float(np.nanmean(off)), low, high, p, p, len(off)))
    adjusted = holm([pair.p for pair in found])
    return [Pair(**{**pair.__dict__, "adjusted": value}) for pair, value in zip(found, adjusted, strict=True)]


def wilcoxon(differences: np.ndarray) -> float:
    """The two-sided p of Wilcoxon's signed-rank test; 1 where there is no difference at all."""
    from scipy import stats

    if not np.any(np.abs(differences) > 1e-12):
        return 1.0
    found: Any = stats.wilcoxon(differences, zero_method="pratt", method="approx")
    return float(found.pvalue)


def holm(values: Sequence[float]) -> list[float]:
    """p after Holm's step-down correction.

    Examples:
        >>> from sceneweaver.bench.pairs import holm
        >>> holm([0.01, 0.04, 0.03])
        [0.03, 0.06, 0.06]
    """
    found, most = [0.0] * len(values), 0.0
    for rank, k in enumerate(np.argsort(values, kind="stable")):
        most = max(most, min((len(values) - rank) * values[k], 1.0))
        found[k] = most
    return found
