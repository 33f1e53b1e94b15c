"""Texture coordinates of drawn pieces: metres on each face, along the grain."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .tree import Piece


def texture_coordinates(pieces: Sequence[Piece]) -> np.ndarray:
    """Texture coordinates of all faces of some pieces, float32 [F, 3, 2] in metres.

    Each face is seen along the axis of the piece's own frame that it faces most. The longer of the other two axes, by
    the extents of the piece, is u: that is how wood grows in a board or a leg. Each piece begins elsewhere in the
    texture, so that no two boards are alike.
    """
    count = np.array([len(piece.faces) for piece in pieces])
    starts = np.cumsum([0] + [len(piece.vertices) for piece in pieces])
    points = np.concatenate([piece.vertices for piece in pieces])
    faces = np.concatenate([piece.faces + start for piece, start in zip(pieces, starts[:-1], strict=True)])
    corners = points[faces]
    normal = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    axis = normal.argmax(axis=1)
    low = np.minimum.reduceat(points, starts[:-1], axis=0)
    high = np.maximum.reduceat(points, starts[:-1], axis=0)
    order = np.argsort(-(high - low).round(6), axis=1, kind="stable")  # axes of each piece, the longest first
    # For each axis that is looked along, the other two of a piece, the longer one first.
    others = np.stack([order[order != k].reshape(-1, 2) for k in range(3)], axis=1)
    piece = np.repeat(np.arange(len(pieces)), count)
    chosen = others[piece, axis]
    uv = np.take_along_axis(corners, chosen[:, None, :].repeat(3, axis=1), axis=2)
    # The golden and the plastic number spread the beginnings evenly (the R2 sequence).
    begin = np.stack([np.arange(len(pieces)) * 0.7548776662 % 1.0, np.arange(len(pieces)) * 0.5698402910 % 1.0], axis=1)
    uv = uv + begin[piece][:, None, :]
    first = np.cumsum(count) - count
    for k, one in enumerate(pieces):
        if one.uv is not None:
            uv[first[k] : first[k] + count[k]] = one.uv
    return uv.astype(np.float32)
