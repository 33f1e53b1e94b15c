"""What is in a vessel that is told to be full, half full or overflowing: a drink, grain, or crumpled paper in a bin."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..body import Interior, Material
from ..materials import contents_of, finish
from ..states import states
from .tree import Piece

LEVELS = {"nearly_empty": 0.14, "half_full": 0.5, "full": 0.92, "overflowing": 1.0}
"""Up to which share of its height a vessel is filled, by posture."""

SIDES, RINGS = 20, 6
"""Corners of a round filling, and levels at which its width is taken."""

WALL = 0.86
"""Radius of what is in a closed vessel by the vessel's own."""

HEAP = 0.07
"""How far [m] what overflows stands over the rim at most."""

_UNIT = np.array(
    [[0, 1, 1.618], [0, -1, 1.618], [0, 1, -1.618], [0, -1, -1.618], [1, 1.618, 0], [-1, 1.618, 0], [1, -1.618, 0]]
    + [[-1, -1.618, 0], [1.618, 0, 1], [-1.618, 0, 1], [1.618, 0, -1], [-1.618, 0, -1]]
) / math.hypot(1, 1.618)


def filled(pieces: Sequence[Piece], interiors: Sequence[Interior], posture: str | None, category: str) -> list[Piece]:
    """The bodies of what is in a vessel; none where the posture says nothing of it or it holds nothing.

    Args:
        pieces: The vessel as drawn.
        interiors: Its room inside.
        posture: One of `LEVELS`, or another.
        category: What is drawn: a mug holds coffee, a bin paper.
    """
    if posture not in LEVELS or not any(row.posture == posture and row.holds_for(category) for row in states()):
        return []
    name = contents_of(category)
    material, share = finish(name).material, LEVELS[posture]
    rooms = [room for room in interiors if room.link == 0 and room.entry[2] > 0.9]
    if name == "paper":
        return [ball for room in rooms[:1] for ball in _crumpled(room, share, material)]
    if rooms:
        return [_column(room, share, material) for room in rooms]
    if posture == "overflowing" or not pieces:
        return []
    body = max(pieces, key=lambda piece: float(np.prod(np.ptp(piece.placed, axis=0))))
    return [_poured(body, share, material)]


def _piece(vertices: np.ndarray, faces: np.ndarray, material: Material) -> Piece:
    return Piece(np.asarray(vertices, dtype=float), np.asarray(faces, dtype=np.int32), np.eye(4), material, 0)


def _rings(
    radii: Sequence[tuple[float, float]], levels: Sequence[float], at: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a closed body of round slices: half sides (x, y) and height of each."""
    turn = np.arange(SIDES) * 2 * math.pi / SIDES
    rows = [
        np.stack([at[0] + rx * np.cos(turn), at[1] + ry * np.sin(turn), np.full(SIDES, z)], 1)
        for (rx, ry), z in zip(radii, levels, strict=True)
    ]
    vertices = np.concatenate([*rows, [[*at, levels[0]], [*at, levels[-1]]]])
    last, bottom = (len(rows) - 1) * SIDES, len(vertices) - 2
    faces: list[tuple[int, int, int]] = []
    for k in range(SIDES):
        n = (k + 1) % SIDES
        faces += [(bottom, n, k), (bottom + 1, last + k, last + n)]
        for row in range(0, last, SIDES):
            faces += [(row + k, row + n, row + SIDES + n), (row + k, row + SIDES + n, row + SIDES + k)]
    return vertices, np.array(faces)


def _column(room: Interior, share: float, material: Material) -> Piece:
    """What fills an open vessel up to a share of its height."""
    low, high = np.array(room.low), np.array(room.high)
    middle, half = (low + high) / 2, (high - low) / 2
    top = low[2] + share * (high[2] - low[2])
    if room.oval:
        sides = (float(half[0]), float(half[1]))
        return _piece(*_rings([sides, sides], [float(low[2]), float(top)], (middle[0], middle[1])), material)
    x, y = half[:2] * 0.99
    plan = np.array([[-x, -y], [x, -y], [x, y], [-x, y]]) + middle[:2]
    vertices = np.concatenate([np.column_stack([plan, np.full(4, z)]) for z in (low[2], top)])
    faces = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7)]
    faces += [t for k in range(4) for t in ((k, (k + 1) % 4, 4 + (k + 1) % 4), (k, 4 + (k + 1) % 4, 4 + k))]
    return _piece(vertices, np.array(faces), material)


def _poured(body: Piece, share: float, material: Material) -> Piece:
    """What is in a closed vessel that one sees through, by its outline."""
    placed = body.placed
    low, high = placed.min(axis=0), placed.max(axis=0)
    middle = (low + high) / 2
    radius = np.hypot(*(placed[:, :2] - middle[:2]).T)
    heights = np.unique(np.round(placed[:, 2], 4))
    wide = [float(radius[np.abs(placed[:, 2] - z) < 6e-5].max()) for z in heights]
    tall = high[2] - low[2]
    levels = np.linspace(low[2] + 0.03 * tall, low[2] + max(0.06, 0.96 * share) * tall, RINGS)
    sides = [max(0.002, WALL * float(np.interp(z, heights, wide))) for z in levels]
    return _piece(*_rings([(r, r) for r in sides], [float(z) for z in levels], (middle[0], middle[1])), material)


def _crumpled(room: Interior, share: float, material: Material) -> list[Piece]:
    """Balls of paper up to a share of a bin, and over its rim where it overflows."""
    dice = np.random.default_rng(5)
    low, high = np.array(room.low), np.array(room.high)
    half, middle = (high - low) / 2, (low + high) / 2
    size = float(np.clip(0.42 * min(half[:2]), 0.02, 0.05))
    heap = HEAP if share >= 1.0 else 0.0
    top = low[2] + share * (high[2] - low[2]) + heap
    faces = _hull_faces()
    found = []
    for k in range(26):
        turn, out = 2.4 * k, math.sqrt((k % 9 + 0.5) / 9)
        reach = half[:2] - size
        z = top - size - (k // 9) * 1.3 * size - (heap * out if heap else 0.0) - 0.3 * size * dice.random()
        if z < low[2] + size:
            continue
        at = (middle[0] + out * reach[0] * math.cos(turn), middle[1] + out * reach[1] * math.sin(turn), z)
        vertices = _UNIT * size * dice.uniform(0.7, 1.1, (12, 1)) + at
        found.append(_piece(vertices, faces, material))
    return found


def _hull_faces() -> np.ndarray:
    """The triangles of an icosahedron, outward."""
    near = [
        (a, b, c)
        for a in range(12)
        for b in range(a + 1, 12)
        for c in range(b + 1, 12)
        if max(np.linalg.norm(_UNIT[p] - _UNIT[q]) for p, q in ((a, b), (b, c), (a, c))) < 1.1
    ]
    outward = [
        (a, b, c) if np.dot(np.cross(_UNIT[b] - _UNIT[a], _UNIT[c] - _UNIT[a]), _UNIT[a]) > 0 else (a, c, b)
        for a, b, c in near
    ]
    return np.array(outward, dtype=np.int32)


__all__ = ["LEVELS", "filled"]
