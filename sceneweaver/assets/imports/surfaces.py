"""Where things can stand on a mesh: upward flat regions with the head room over them."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.geometry.polygons import union
from sceneweaver.scene import Surface

_LEVEL = 0.995  # cosine of about 6 degrees
_SAME = 4e-3  # heights [m] that count as one
_MARGIN = 5e-3  # kept free at the edge
_NARROW = 0.02  # half the width [m] of what is too narrow to stand on
MIN_AREA = 0.008
MIN_HEADROOM = 0.05
MAX_SURFACES = 24


def find_surfaces(vertices: np.ndarray, faces: np.ndarray) -> tuple[Surface, ...]:
    """Support surfaces of a mesh in its own frame (z up), from the lowest to the highest.

    Upward facing triangles of one height are united; what is narrow, small, near the ground or has no room over it
    falls away. Head room is the least distance upward to the mesh over a grid of points.
    """
    import shapely

    corners = vertices[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1)
    flat = (normal[:, 2] > _LEVEL * np.maximum(area, 1e-15)) & (area > 1e-10)
    total = float(np.ptp(vertices[:, 2]))
    heights = corners[:, :, 2].mean(axis=1)
    flat &= heights > min(0.03, 0.2 * total)
    if not flat.any():
        return ()
    order = np.flatnonzero(flat)[np.argsort(heights[flat])]
    cuts = np.flatnonzero(np.diff(heights[order]) > _SAME) + 1
    found: list[tuple[float, np.ndarray, float | None]] = []
    for level in np.split(order, cuts):
        if 0.5 * area[level].sum() < MIN_AREA:
            continue
        z = float(np.average(heights[level], weights=area[level]))
        grown: Any = shapely.buffer(shapely.polygons(corners[level][:, :, :2]), 1e-4)
        region = union(grown)
        region = region.buffer(-_NARROW).buffer(_NARROW - _MARGIN)
        for shape in getattr(region, "geoms", [region]):
            found += _with_headroom(shape, z, corners)
    found.sort(key=lambda row: -_area(row[1]))
    found = sorted(found[:MAX_SURFACES], key=lambda row: row[0])
    surfaces, shelves = [], 0
    for z, ring, room in found:
        if room is None:
            tops = sum(1 for s in surfaces if s.headroom is None)
            name = "top" if not tops else f"top-{tops}"
        else:
            name = f"shelf-{shelves}"
            shelves += 1
        polygon = tuple((round(float(x), 5), round(float(y), 5)) for x, y in ring)
        surfaces.append(Surface(name=name, polygon=polygon, z=round(z, 5), headroom=room))
    return tuple(surfaces)


def _with_headroom(shape, z: float, corners: np.ndarray) -> list[tuple[float, np.ndarray, float | None]]:
    """A region cut into what is free above and what is covered, without holes."""
    import shapely

    if shape.is_empty or shape.area < MIN_AREA:
        return []
    points, cell = _grid(shape)
    room = _upward(corners, points, z)
    rows: list[tuple[float, np.ndarray, float | None]] = []
    for covered in (False, True):
        mine = points[(np.isfinite(room) == covered) & (room > MIN_HEADROOM)]
        if not len(mine):
            continue
        if len(mine) > 0.97 * len(points):
            part = shape
        else:
            boxes = shapely.box(*(mine - cell / 2).T, *(mine + cell / 2).T)
            part = union(boxes.tolist()).intersection(shape).buffer(-_NARROW).buffer(_NARROW)
        least = float(room[(np.isfinite(room) == covered) & (room > MIN_HEADROOM)].min())
        for piece in getattr(part, "geoms", [part]):
            for whole in _without_holes(piece):
                if whole.area >= MIN_AREA:
                    ring = np.asarray(whole.exterior.simplify(2e-3).normalize().reverse().coords)[:-1]
                    rows.append((z, ring, round(least - 2e-3, 4) if covered else None))
    return rows


def _without_holes(piece) -> list:
    """A polygon as simple ones: cut across the middle of each hole that is worth it."""
    import shapely
    from shapely.ops import split

    if piece.is_empty or piece.geom_type != "Polygon":
        return []
    if not piece.interiors:
        return [piece]
    x0, y0, x1, y1 = piece.bounds
    hole = max(piece.interiors, key=lambda ring: shapely.Polygon(ring).area)
    x = hole.centroid.x
    cut = split(piece, shapely.LineString([(x, y0 - 1), (x, y1 + 1)]))
    return [simple for part in cut.geoms for simple in _without_holes(part)]


def _grid(shape) -> tuple[np.ndarray, np.ndarray]:
    import shapely

    x0, y0, x1, y1 = shape.bounds
    nx, ny = (int(np.clip(span / 0.03, 6, 24)) for span in (x1 - x0, y1 - y0))
    cell = np.array([(x1 - x0) / nx, (y1 - y0) / ny])
    x, y = np.meshgrid(x0 + (np.arange(nx) + 0.5) * cell[0], y0 + (np.arange(ny) + 0.5) * cell[1])
    points = np.c_[x.ravel(), y.ravel()]
    inside = points[shapely.contains_xy(shape, points)]
    return (inside if len(inside) else np.array([shape.representative_point().coords[0]])), cell


def _upward(corners: np.ndarray, points: np.ndarray, z: float) -> np.ndarray:
    """Distance from z up to the mesh over each point; inf when there is none."""
    above = corners[corners[:, :, 2].max(axis=1) > z + 2e-3]
    low, high = above[:, :, :2].min(axis=1), above[:, :, :2].max(axis=1)
    room = np.full(len(points), np.inf)
    for i, point in enumerate(points):
        near = above[((low <= point) & (high >= point)).all(axis=1)]
        if not len(near):
            continue
        a, b, c = near[:, 0], near[:, 1], near[:, 2]
        u, v = b[:, :2] - a[:, :2], c[:, :2] - a[:, :2]
        w = point - a[:, :2]
        det = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        good = np.abs(det) > 1e-14
        with np.errstate(divide="ignore", invalid="ignore"):
            s = (w[:, 0] * v[:, 1] - w[:, 1] * v[:, 0]) / det
            t = (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / det
        hit = good & (s >= 0) & (t >= 0) & (s + t <= 1)
        height = (a[:, 2] + s * (b[:, 2] - a[:, 2]) + t * (c[:, 2] - a[:, 2]))[hit] - z
        room[i] = height[height > 2e-3].min(initial=np.inf)
    return room


def _area(ring: np.ndarray) -> float:
    x, y = ring.T
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))
