"""Where the front of a mesh is, from its shape.

Two witnesses are heard. Likeness: a mesh of a known category is compared, in all four quarter turns, with our own
drawings of that category, as blurred pictures of where the surface is. And use: what a person would reach for speaks
for the front: a shelf is open there, a seat's back rest stands behind it, a cupboard's back is one flat board, and left
is like right.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ..category import Category

_CELLS = 40
_LIKE_CELLS = 16
_LIKE_SEEDS = 6
_LIKE_WEIGHT = 6.0


def front_of(points: np.ndarray, faces: np.ndarray, category: Category | None = None) -> tuple[int, float]:
    """The front as quarter turns counter-clockwise from +x, and how sure it is (0 to 1).

    ``points`` [V, 3] with z up, ``faces`` [F, 3].
    """
    samples = _surface_samples(points, faces)
    low, high = points.min(axis=0), points.max(axis=0)
    unit = (samples - low) / np.maximum(high - low, 1e-9)
    extent = high - low
    scores = np.array([_score(_turned(unit, k)) for k in range(4)])
    if category is not None and category.size is not None:
        likeness = _likeness(samples - (low + high) / 2, extent, category.name)
        # The more alike the best turn is, the more this witness weighs against the other.
        scores = 0.3 * scores + _LIKE_WEIGHT * likeness
    order = np.argsort(-scores)
    gap = float(scores[order[0]] - scores[order[1]])
    return int(order[0]), float(np.clip(gap / 0.5, 0.0, 1.0))


def _likeness(centred: np.ndarray, extent: np.ndarray, category: str) -> np.ndarray:
    """Cosine of the mesh's picture with the category's, for the four turns, [4]."""
    template = _template(category)
    found = np.zeros(4)
    if template is None:
        return found
    x, y, z = centred.T
    for k, (a, b) in enumerate(((x, y), (y, -x), (-x, -y), (-y, x))):
        picture = _picture(np.stack([a, b, z], axis=1), float(extent.max()))
        found[k] = max(float((picture * one).sum()) for one in template)
    return found


@lru_cache(maxsize=64)
def _template(category: str) -> tuple[np.ndarray, ...] | None:
    """Pictures of our own drawings of a category, in their frame."""
    from ..parametric import make, makers

    if category not in makers():
        return None
    pictures = []
    for seed in range(_LIKE_SEEDS):
        mesh = make(category, seed).mesh
        low, high = mesh.bounds
        samples = _surface_samples(mesh.vertices, mesh.faces) - (low + high) / 2
        pictures.append(_picture(samples, float((high - low).max())))
    return tuple(pictures)


def _picture(centred: np.ndarray, span: float) -> np.ndarray:
    """How much surface is where, on a coarse grid of the given span, blurred and of unit length."""
    from scipy.ndimage import gaussian_filter

    cell = np.clip(((centred / span + 0.5) * _LIKE_CELLS).astype(int), 0, _LIKE_CELLS - 1)
    grid = np.zeros((_LIKE_CELLS,) * 3)
    np.add.at(grid, tuple(cell.T), 1.0)
    grid = gaussian_filter(np.sqrt(grid), 0.7)
    return grid / max(float(np.linalg.norm(grid)), 1e-12)


def areas(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Areas [F] of triangles, from corners [V, 3] and indices [F, 3]."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    found: np.ndarray = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return found


def _surface_samples(points: np.ndarray, faces: np.ndarray, count: int = 60_000) -> np.ndarray:
    a, b, c = (points[faces[:, k]] for k in range(3))
    area = areas(points, faces)
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


def _score(unit: np.ndarray) -> float:
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
