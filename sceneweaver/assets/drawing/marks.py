"""What a posture adds to a drawing: cracks on its front, a sheet over all of it, what ran out of it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from .. import shapes
from ..materials import contents_of, finish
from .tree import Piece

CRACKS, STEPS = 7, 5
"""Cracks that run from where something was hit, and pieces of each."""

PROUD = 0.0006
"""How far [m] a crack stands out of what it is in."""

JUMP = 0.05
"""A crack ends where the surface leaps by more than this [m]."""

CELLS = 26
"""Cells of a sheet along each side of what it lies over."""

AROUND = 0.02
"""How far [m] a sheet hangs off the sides of what is under it."""

FLAT = 0.35
"""Height by the shorter side from which down a thing is seen from above."""


def marked(pieces: Sequence[Piece], posture: str | None, category: str) -> list[Piece]:
    """The bodies that a posture adds; none where it adds nothing.

    Args:
        pieces: The thing as drawn, upright.
        posture: "cracked", "sheeted" or "spilled", or another.
        category: What is drawn: what it holds runs out.
    """
    if not pieces or posture not in ("cracked", "sheeted", "spilled"):
        return []
    triangles = np.concatenate([piece.placed[piece.faces] for piece in pieces])
    if posture == "cracked":
        return _cracks(triangles)
    return [_sheet(triangles)] if posture == "sheeted" else [_puddle(triangles, category)]


def levels(triangles: np.ndarray, points: np.ndarray, axis: int) -> np.ndarray:
    """The highest of some triangles [F, 3, 3] along an axis at points [P, 2] of the other two; -inf where none is."""
    across = [k for k in range(3) if k != axis]
    a, b, c = (triangles[:, k][:, across] for k in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    area = ux * vy - uy * vx
    flat = np.abs(area) < 1e-12
    area = np.where(flat, 1.0, area)
    found = np.full(len(points), -np.inf)
    for k, point in enumerate(points):
        wx, wy = (point - a).T
        s, t = (wx * vy - wy * vx) / area, (ux * wy - uy * wx) / area
        there = ~flat & (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
        if there.any():
            at = triangles[there][:, :, axis]
            share = np.stack([1 - s[there] - t[there], s[there], t[there]], 1)
            found[k] = float((at * share).sum(axis=1).max())
    return found


def _cracks(triangles: np.ndarray) -> list[Piece]:
    """Cracks that spread from one place of what is seen of a thing, from in front or from above."""
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    size = high - low
    axis = 2 if size[2] < FLAT * min(size[:2]) else 0
    across = [k for k in range(3) if k != axis]
    span, dice = size[across], np.random.default_rng(11)
    start = low[across] + span * (0.56, 0.62)
    wide = 0.006 * float(min(span)) + 0.0006
    look, found = finish("ink pigment").material, []
    for k in range(CRACKS):
        turn = 2 * math.pi * (k + 0.3 * dice.random()) / CRACKS
        reach = dice.uniform(0.3, 0.62)
        path = [start]
        for step in range(1, STEPS + 1):
            bend = turn + dice.uniform(-0.45, 0.45)
            path.append(path[-1] + span * reach / STEPS * np.array([math.cos(bend), math.sin(bend)]))
            if step == 3:  # a branch
                found += _strips(
                    triangles,
                    axis,
                    [path[-1], path[-1] + 0.12 * span * (math.cos(turn + 1), math.sin(turn + 1))],
                    0.6 * wide,
                    look,
                )
        found += _strips(triangles, axis, path, wide, look)
    return found


def _strips(triangles: np.ndarray, axis: int, path: Sequence[np.ndarray], wide: float, look) -> list[Piece]:
    """Thin bodies along a path over what is highest along an axis."""
    points = np.array(path)
    high = levels(triangles, points, axis)
    across, made = [k for k in range(3) if k != axis], []
    for k in range(len(points) - 1):
        ends = high[k : k + 2]
        if not np.isfinite(ends).all() or abs(ends[1] - ends[0]) > JUMP:
            break
        way = points[k + 1] - points[k]
        side = np.array([-way[1], way[0]]) / max(1e-9, float(np.hypot(*way))) * wide / 2
        corners = []
        for at, level in zip(points[k : k + 2], ends, strict=True):
            for s in (-1, 1):
                for up in (-PROUD, PROUD):
                    corner = np.empty(3)
                    corner[across], corner[axis] = at + s * side, level + up
                    corners.append(corner)
        vertices, faces = shapes.hull(np.array(corners))
        made.append(Piece(vertices, faces, np.eye(4), look, 0))
    return made


def _sheet(triangles: np.ndarray) -> Piece:
    """A cloth that lies over all of a thing and hangs down to the floor in folds."""
    from scipy.ndimage import gaussian_filter, maximum_filter

    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    x, y = (np.linspace(low[k], high[k], CELLS) for k in (0, 1))
    inner = [np.clip(side, side[0] + 0.004, side[-1] - 0.004) for side in (x, y)]
    points = np.stack(np.meshgrid(*inner, indexing="ij"), axis=-1).reshape(-1, 2)
    top = levels(triangles, points, 2).reshape(CELLS, CELLS)
    top = np.where(np.isfinite(top), top, low[2])
    cloth = gaussian_filter(maximum_filter(top, 3), 0.7)
    cloth = np.maximum(cloth, top) + 0.008
    grid = np.empty((CELLS + 2, CELLS + 2, 3))
    place = [np.r_[side[0] - AROUND, side, side[-1] + AROUND] for side in (x, y)]
    grid[:, :, 0], grid[:, :, 1] = np.meshgrid(*place, indexing="ij")
    grid[:, :, 2] = low[2] + 0.012
    grid[1:-1, 1:-1, 2] = cloth
    fold = AROUND * 0.8 * np.abs(np.sin(1.3 * np.arange(CELLS + 2)))
    grid[0, :, 0] -= fold
    grid[-1, :, 0] += fold
    grid[:, 0, 1] -= fold
    grid[:, -1, 1] += fold
    vertices, faces = shapes.sheet(grid, 0.008)
    vertices[:, 2] = np.maximum(vertices[:, 2], low[2])
    return Piece(vertices, faces, np.eye(4), finish("white cotton").material, 0)


def _puddle(triangles: np.ndarray, category: str) -> Piece:
    """What ran out of a vessel, where it will lie when the vessel is on its side: flat on its right, before its rim."""
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    tall = high[2] - low[2]
    turn = np.linspace(0, 2 * math.pi, 24, endpoint=False)
    radius = tall * (0.42 + 0.07 * np.sin(2 * turn + 1) + 0.05 * np.sin(3 * turn))
    z, x = high[2] + 0.2 * tall + 1.15 * radius * np.cos(turn), (low[0] + high[0]) / 2 + 0.8 * radius * np.sin(turn)
    outline = np.concatenate([np.stack([x, np.full(24, y), z], 1) for y in (low[1], low[1] + 0.0009)])
    vertices, faces = shapes.hull(outline)
    name = contents_of(category)
    return Piece(vertices, faces, np.eye(4), finish("smoked glass" if name == "paper" else name).material, 0)


__all__ = ["levels", "marked"]
