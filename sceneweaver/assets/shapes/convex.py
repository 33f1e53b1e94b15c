"""Convex hulls: exact ones, and simple ones that contain a shape."""

from __future__ import annotations

import numpy as np

from sceneweaver.geometry import polygons
from sceneweaver.geometry.hulls import hull_mesh

Shape = tuple[np.ndarray, np.ndarray]  # vertices [V, 3], faces [F, 3]

# Normals of the 26 faces of a cube with cut edges and corners.
_DIRECTIONS = np.array(
    [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if (x, y, z) != (0, 0, 0)]
)
_DIRECTIONS = _DIRECTIONS / np.linalg.norm(_DIRECTIONS, axis=1, keepdims=True)


def hull(points: np.ndarray) -> Shape:
    """The convex hull of points [N, 3], outward faces; ValueError when they lie in one plane."""
    return hull_mesh(points)


def hull_of(shapes: list[Shape]) -> Shape:
    """The convex hull of several shapes together."""
    return hull(np.concatenate([vertices for vertices, _ in shapes]))


def containing_hull(points: np.ndarray) -> Shape:
    """A convex body of at most 26 faces that contains the points: tight for boxes, cushions and balls."""
    from scipy.spatial import HalfspaceIntersection

    reach = (points @ _DIRECTIONS.T).max(axis=0)
    middle = points.mean(axis=0)  # inside the hull, and so inside the body
    halfspaces = np.c_[_DIRECTIONS, -reach]
    corners = HalfspaceIntersection(halfspaces, middle).intersections
    # The same corner arises once for every three planes through it; unequal copies would make slivers.
    _, first = np.unique(np.round(corners, 7), axis=0, return_index=True)
    return hull(corners[np.sort(first)])


def convex_pieces(polygon: np.ndarray) -> list[np.ndarray]:
    """A simple polygon [V, 2], counter-clockwise, as few convex polygons: triangles merged while they stay convex."""
    import shapely

    pieces = polygons.convex_pieces(polygon)
    if len(pieces) == 1:
        return [np.asarray(polygon, dtype=np.float64)]
    return [shapely.get_coordinates(shapely.Polygon(piece).normalize())[:-1][::-1] for piece in pieces]
