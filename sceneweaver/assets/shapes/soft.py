"""Soft things: cushions, and thin sheets such as cloth and leaves."""

from __future__ import annotations

from functools import cache

import numpy as np

from .convex import Shape


def cushion(
    x: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    radius: float = 0.04,
    puff: float = 0.0,
    steps: int = 3,
) -> Shape:
    """A box with round edges of ``radius``; ``puff`` in 0..1 swells its faces until it is an ellipsoid-like pillow.

    It fills its box exactly and is convex.
    """
    low, high = np.array([x[0], y[0], z[0]], dtype=np.float64), np.array([x[1], y[1], z[1]], dtype=np.float64)
    half = (high - low) / 2
    r = min(radius, 0.999 * float(half.min()))
    directions, faces = _pattern(steps, puff > 0)
    core = half - r
    # A sphere of radius r at each corner of the core box: the hull of those spheres is the rounded box.
    sign = np.where(directions >= 0, 1.0, -1.0)
    flat = np.abs(directions) < 1e-12
    points = np.where(flat, 0.0, sign) * core + directions * r
    if puff > 0:
        # A superellipsoid through the same box, mixed in by how much it puffs.
        power = 2.0 + 4.0 * (1 - puff)
        norm = (np.abs(directions) ** power).sum(axis=1, keepdims=True) ** (1 / power)
        points = (1 - puff) * points + puff * (directions / norm) * half
        points *= half / np.abs(points).max(axis=0)
    return points + (low + high) / 2, faces.copy()


@cache
def _pattern(steps: int, soft: bool) -> Shape:
    return _sphere_grid(steps, 1.0 if soft else 0.0)


def _sphere_grid(steps: int, puff: float) -> Shape:
    """Unit directions over a cube's faces, with a doubled row in the middle where ``puff`` is 0, and their faces."""
    t = np.tan(np.linspace(0, np.pi / 4, steps + 1))
    line = np.concatenate([-t[::-1], t[1:]]) if puff > 0 else np.concatenate([-t[::-1], t])
    if puff <= 0:
        line[steps], line[steps + 1] = -1e-6, 1e-6
    n = len(line)
    vertices, faces = [], []
    for axis in range(3):
        for side in (1.0, -1.0):
            u, v = np.meshgrid(line, line, indexing="ij")
            grid = np.empty((n, n, 3))
            grid[..., axis] = side
            grid[..., (axis + 1) % 3] = u
            grid[..., (axis + 2) % 3] = v
            start = sum(len(p) for p in vertices)
            vertices.append(grid.reshape(-1, 3))
            i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
            a = (start + i * n + j).ravel()
            quads = np.concatenate([np.c_[a, a + n, a + n + 1], np.c_[a, a + n + 1, a + 1]])
            faces.append(quads if side > 0 else quads[:, ::-1])
    points = np.concatenate(vertices)
    points = points / np.linalg.norm(points, axis=1, keepdims=True)
    # Corners and edges arise once a face; welded, the body is closed.
    _, first, inverse = np.unique(np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True)
    triangles = inverse.reshape(-1)[np.concatenate(faces)]
    alive = (
        (triangles[:, 0] != triangles[:, 1])
        & (triangles[:, 1] != triangles[:, 2])
        & (triangles[:, 0] != triangles[:, 2])
    )
    return points[first], triangles[alive].astype(np.int32)


def sheet(grid: np.ndarray, thickness: float) -> Shape:
    """A bent sheet: points [N, M, 3] of its middle surface, thickened along the normals; closed."""
    grid = np.asarray(grid, dtype=np.float64)
    n, m = grid.shape[:2]
    du = np.gradient(grid, axis=0)
    dv = np.gradient(grid, axis=1)
    normal = np.cross(du, dv)
    normal /= np.maximum(1e-12, np.linalg.norm(normal, axis=-1, keepdims=True))
    upper = (grid + normal * thickness / 2).reshape(-1, 3)
    lower = (grid - normal * thickness / 2).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n - 1), np.arange(m - 1), indexing="ij")
    a = (i * m + j).ravel()
    quads = np.concatenate([np.c_[a, a + m, a + m + 1], np.c_[a, a + m + 1, a + 1]])
    rim = np.concatenate(
        [np.arange(m), m - 1 + m * np.arange(1, n), (n - 1) * m + np.arange(m - 2, -1, -1), m * np.arange(n - 2, 0, -1)]
    )
    after = np.roll(rim, -1)
    k = n * m
    edge = np.concatenate([np.c_[rim, k + after, k + rim], np.c_[rim, after, k + after]])
    return np.concatenate([upper, lower]), np.concatenate([quads, quads[:, ::-1] + k, edge]).astype(np.int32)


def sheet_uv(grid: np.ndarray) -> np.ndarray:
    """Texture coordinates of the vertices of `sheet`, [2 N M, 2] in metres: lengths along both ways of the grid."""
    grid = np.asarray(grid, dtype=np.float64)
    lengths = []
    for axis in (0, 1):
        step = np.linalg.norm(np.diff(grid, axis=axis), axis=-1).mean(axis=1 - axis)
        lengths.append(np.concatenate([[0.0], np.cumsum(step)]))
    uv = np.stack(np.meshgrid(*lengths, indexing="ij"), axis=-1).reshape(-1, 2)
    return np.concatenate([uv, uv])


def pillow(depth: float, width: float, thick: float) -> Shape:
    """A stuffed pillow with full corners that fills its box about the origin, its foot at z = 0.

    Its seam runs around its middle; edges are drawn in a little between the corners.
    """
    n = 9
    t = np.sin(np.linspace(-1, 1, n) * np.pi / 2)
    u, v = np.meshgrid(t, t, indexing="ij")
    x = depth / 2 * u * (1 - 0.04 * (1 - v**2))
    y = width / 2 * v * (1 - 0.04 * (1 - u**2))
    z = np.maximum(thick / 2 * np.clip((1 - u**4) * (1 - v**4), 0, 1) ** 0.5, 0.004)
    top, low = (np.stack([x, y, thick / 2 + s * z], axis=-1) for s in (1, -1))
    i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
    a = (i * n + j).ravel()
    quads = np.concatenate([np.c_[a, a + n, a + n + 1], np.c_[a, a + n + 1, a + 1]])
    rim = np.concatenate(
        [np.arange(n), n - 1 + n * np.arange(1, n), (n - 1) * n + np.arange(n - 2, -1, -1), n * np.arange(n - 2, 0, -1)]
    )
    after = np.roll(rim, -1)
    edge = np.concatenate([np.c_[rim, n * n + after, n * n + rim], np.c_[rim, after, n * n + after]])
    points = np.concatenate([top.reshape(-1, 3), low.reshape(-1, 3)])
    points[:, :2] *= np.array([depth, width]) / np.ptp(points[:, :2], axis=0)
    return points, np.concatenate([quads, quads[:, ::-1] + n * n, edge]).astype(np.int32)
