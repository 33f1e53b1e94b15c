"""Mass, centre and inertia of convex parts of even density."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from sceneweaver.geometry.hulls import hull_mesh

from .solids import Solid

_KNOWN: WeakKeyDictionary[Solid, tuple[np.ndarray, np.ndarray]] = WeakKeyDictionary()


@dataclass(frozen=True)
class Inertia:
    """``mass`` [kg], its ``centre`` [3] [m] and the ``tensor`` [3, 3] [kg m2] about that centre, in the parts' axes."""

    mass: float
    centre: np.ndarray
    tensor: np.ndarray


def shares_of(solids: Sequence[Solid], mass: float) -> list[float]:
    """A mass [kg] spread over parts by their volume."""
    volume = sum(solid.volume for solid in solids)
    return [mass * solid.volume / volume for solid in solids]


def inertia_of(solids: Sequence[Solid], masses: Sequence[float]) -> Inertia:
    """The inertia of parts that move as one.

    Args:
        solids: At least one part.
        masses: Of each part [kg], positive.
    """
    weights = np.asarray(masses, dtype=float)
    made = [_second_moments(solid) for solid in solids]
    centres = np.array([centre for centre, _ in made])
    total = float(weights.sum())
    centre = weights @ centres / total
    spread = np.zeros((3, 3))
    for weight, (own, moments) in zip(weights, made, strict=True):
        off = own - centre
        spread += weight * (moments + np.outer(off, off))
    return Inertia(total, centre, np.trace(spread) * np.eye(3) - spread)


def _second_moments(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    """Centre [3] and the mean of (p - centre)(p - centre)^T [3, 3] over a part's volume."""
    if solid not in _KNOWN:
        _KNOWN[solid] = _integrated(solid)
    return _KNOWN[solid]


def _integrated(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    if solid.box is not None:
        centre, half = (np.asarray(v, dtype=float) for v in solid.box)
        return centre, np.diag(half**2) / 3
    # Tetrahedra from a point within to each triangle; over one with corners 0, a, b, c of volume v the integral of
    # p is v (a + b + c) / 4 and that of p p^T is v (aa^T + bb^T + cc^T + ss^T) / 20 with s = a + b + c.
    within, fans = triangles(solid.points)
    fans = fans - within
    volumes = np.linalg.det(fans) / 6
    sums = fans.sum(axis=1)
    total = float(volumes.sum())
    centre = volumes @ sums / (4 * total)
    outer = np.einsum("fki,fkj->fij", fans, fans) + np.einsum("fi,fj->fij", sums, sums)
    mean = np.einsum("f,fij->ij", volumes, outer) / (20 * total)
    return centre + within, mean - np.outer(centre, centre)


def triangles(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A point [3] within the convex hull of ``points`` [V, 3], and the hull's triangles [F, 3, 3], seen from outside
    counter-clockwise."""
    corners, faces = hull_mesh(points)
    return corners.mean(axis=0), corners[faces]
