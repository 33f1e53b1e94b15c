"""Where the front of a mesh is, from its shape: flat closed back, left equal to right, and where things are reached.

Each side is looked at straight on as a depth picture, on a grid. What a person would use speaks for the front: a
shelf is open there, a seat's back rest stands behind it, a cupboard's back is one flat board.
"""

from __future__ import annotations

import numpy as np

from ..category import Category

_CELLS = 40


def front_of(points: np.ndarray, faces: np.ndarray, category: Category | None = None) -> tuple[int, float]:
    """The front as quarter turns counter-clockwise from +x, and how sure it is (0 to 1).

    ``points`` [V, 3] with z up, ``faces`` [F, 3].
    """
    samples = _surface_samples(points, faces)
    low, high = points.min(axis=0), points.max(axis=0)
    unit = (samples - low) / np.maximum(high - low, 1e-9)
    scores = np.array([_score(_turned(unit, k), (high - low)[[0, 1, 2]] if k % 2 == 0 else (high - low)[[1, 0, 2]])
                       for k in range(4)])  # fmt: skip
    if category is not None and category.size is not None:
        # A wide thing is used from its long side, where the category says so.
        (d0, d1), (w0, w1), _ = category.size.ranges
        lean = np.log(((w0 + w1) / (d0 + d1)) + 1e-9)
        shape = np.log((high[1] - low[1]) / max(high[0] - low[0], 1e-9))
        fit = -np.abs(shape - lean) + np.abs(-shape - lean)
        scores += 0.8 * np.clip(fit, -1, 1) * np.array([0.5, -0.5, 0.5, -0.5])
    order = np.argsort(-scores)
    gap = float(scores[order[0]] - scores[order[1]])
    return int(order[0]), float(np.clip(gap / 0.5, 0.0, 1.0))


def _surface_samples(points: np.ndarray, faces: np.ndarray, count: int = 60_000) -> np.ndarray:
    a, b, c = (points[faces[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    rng = np.random.default_rng(0)
    pick = rng.choice(len(faces), size=count, p=area / area.sum())
    u, v = rng.random((2, count, 1))
    flip = u + v > 1
    u, v = np.where(flip, 1 - u, u), np.where(flip, 1 - v, v)
    return a[pick] + u * (b[pick] - a[pick]) + v * (c[pick] - a[pick])


def _turned(unit: np.ndarray, quarter: int) -> np.ndarray:
    """The samples so that the side in question looks along +x."""
    x, y, z = unit.T
    if quarter == 1:
        x, y = y, 1 - x
    elif quarter == 2:
        x, y = 1 - x, 1 - y
    elif quarter == 3:
        x, y = 1 - y, x
    return np.stack([x, y, z], axis=1)


def _depth(unit: np.ndarray, far: bool) -> np.ndarray:
    """Distance of the first sample seen from +x (or -x), on a grid over y and z; 1 where nothing is."""
    i = np.minimum((unit[:, 1] * _CELLS).astype(int), _CELLS - 1)
    j = np.minimum((unit[:, 2] * _CELLS).astype(int), _CELLS - 1)
    picture = np.ones((_CELLS, _CELLS))
    np.minimum.at(picture, (i, j), unit[:, 0] if far else 1 - unit[:, 0])
    return picture


def _score(unit: np.ndarray, extent: np.ndarray) -> float:
    """How much +x looks like a front."""
    front, back = _depth(unit, far=False), _depth(unit, far=True)
    flat_front, flat_back = (float((picture < 0.06).mean()) for picture in (front, back))
    even = float(np.abs(front - front[::-1]).mean() + np.abs(back - back[::-1]).mean())
    # What stands high stands behind: a back rest, a head board, a splash back.
    top = np.zeros(_CELLS)
    column = np.minimum((unit[:, 0] * _CELLS).astype(int), _CELLS - 1)
    np.maximum.at(top, column, unit[:, 2])
    tall = float(top[: _CELLS // 4].mean() - top[-_CELLS // 4 :].mean())
    # Handles, knobs and door gaps: the front is rougher than the back where both are closed.
    rough = float(np.abs(np.diff(front, axis=0)).mean() - np.abs(np.diff(back, axis=0)).mean())
    open_ = float(np.minimum(front, 0.8).mean() - np.minimum(back, 0.8).mean())
    return 1.2 * (flat_back - flat_front) + 1.5 * tall + 0.6 * open_ + 0.8 * rough - 1.5 * even
