"""Parts of things that lie in or on each other, cut so that they touch and do not reach into each other."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.geometry.hulls import hull_faces

from .solids import Solid

_SETTLED = 1e-6  # [m]; what reaches less into another lies on it
_GAP = 1e-6  # [m] that is left between two parts that were cut
_LEAST = 0.6  # share of its volume that a part keeps at least: what reaches deeper than that is as it was meant


def cut_apart(
    solids: Sequence[Solid], loose: Collection[int], make: Callable[[np.ndarray, Solid], Solid]
) -> list[Solid]:
    """The parts of an asset, those of its loose links cut where they reach into parts of other links.

    Parts are convex hulls, which are coarser than what they stand for: plates of a stack reach into each other by half
    a millimetre, fruit into its bowl by some, and a simulator would push them apart at the start. Two parts are parted
    by the plane between them in which they overlap least, a face of one of them. Of two loose ones each loses half,
    else the loose one all.

    Args:
        solids: The parts.
        loose: Numbers of the links that hang on nothing and can be taken.
        make: From points [V, 3] to a part like another.
    """
    found = list(solids)
    low = np.array([s.points.min(axis=0) for s in found])
    high = np.array([s.points.max(axis=0) for s in found])
    for k in range(len(found)):
        if found[k].link not in loose:
            continue
        near = ((low <= high[k] - _SETTLED) & (high >= low[k] + _SETTLED)).all(axis=1)
        for other in np.flatnonzero(near).tolist():
            mutual = found[other].link in loose
            if found[other].link == found[k].link or (mutual and other < k):
                continue
            plane = _between(found[k], found[other])
            if plane is None:
                continue
            normal, mine, theirs = plane
            at = (mine + theirs) / 2 if mutual else theirs
            pieces = {k: _kept(found[k], normal, at - _GAP, make)}
            if mutual:
                pieces[other] = _kept(found[other], -normal, -at - _GAP, make)
            if all(piece is not None for piece in pieces.values()):
                for number, piece in pieces.items():
                    assert piece is not None
                    found[number] = piece
                    low[number], high[number] = piece.points.min(axis=0), piece.points.max(axis=0)
    return found


def _between(one: Solid, two: Solid) -> tuple[np.ndarray, float, float] | None:
    """The unit vector [3] from one to the other along which they overlap least, how far one reaches along it and where
    the other begins; None: they do not overlap."""
    best, depth = None, np.inf
    for sign, planes in ((1.0, one.planes), (-1.0, two.planes)):
        normals = sign * planes[:, :3]
        mine, theirs = (one.points @ normals.T).max(axis=0), (two.points @ normals.T).min(axis=0)
        k = int(np.argmin(mine - theirs))
        if mine[k] - theirs[k] < depth:
            depth, best = mine[k] - theirs[k], (normals[k], float(mine[k]), float(theirs[k]))
    return best if depth > _SETTLED else None


def _kept(solid: Solid, normal: np.ndarray, at: float, make: Callable[[np.ndarray, Solid], Solid]) -> Solid | None:
    """What of a part lies below a plane; None: too little, or nothing that has a volume."""
    side = solid.points @ normal - at
    below = solid.points[side <= 0]
    try:
        faces = hull_faces(solid.points)
    except ValueError:
        return None
    edges = np.unique(np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
    a, b = edges[side[edges[:, 0]] * side[edges[:, 1]] < 0].T
    share = (side[a] / (side[a] - side[b]))[:, None]
    points = np.concatenate([below, solid.points[a] + share * (solid.points[b] - solid.points[a])])
    if len(points) < 4:
        return None
    piece = make(points, solid)
    if piece.box is not None and piece.box[0] @ normal + piece.box[1] @ np.abs(normal) > at + _SETTLED:
        piece = replace(piece, box=None)  # nearly a box, whose corner reaches over the plane
    return piece if piece.volume >= _LEAST * solid.volume else None
