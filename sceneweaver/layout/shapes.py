"""From the scene's polygons to convex prisms in plain arrays."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import SceneObject

Points = np.ndarray  # [V, 2] float64, counter-clockwise


@dataclass(frozen=True)
class Prism:
    """A convex polygon [V, 2] times a z interval; ``real[k]`` is False where edge k is no way out."""

    polygon: Points
    z: tuple[float, float]
    real: tuple[bool, ...] | None = None


def signed_area(polygon: Points) -> float:
    """Area of a polygon, positive when it runs counter-clockwise."""
    x, y = polygon[:, 0], polygon[:, 1]
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def tidy(polygon, tolerance: float = 1e-9) -> Points:
    """The polygon counter-clockwise, without repeated and collinear vertices."""
    points = np.asarray(polygon, dtype=np.float64)
    if signed_area(points) < 0:
        points = points[::-1]
    before, after = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    scale = np.hypot(before[:, 0], before[:, 1]) * np.hypot(after[:, 0], after[:, 1])
    keep = np.abs(cross) > tolerance * np.maximum(1e-12, scale)
    return points[keep] if keep.sum() >= 3 else points


def is_convex(polygon: Points, tolerance: float = 1e-9) -> bool:
    """True when a counter-clockwise polygon never turns right."""
    a = np.roll(polygon, -1, axis=0) - polygon
    b = np.roll(a, -1, axis=0)
    return bool(np.all(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] >= -tolerance))


def convex_pieces(polygon) -> list[Points]:
    """A simple polygon as few convex pieces: triangles, merged while the union stays convex (Hertel and Mehlhorn)."""
    points = tidy(polygon)
    if is_convex(points):
        return [points]
    import shapely

    triangles = shapely.constrained_delaunay_triangles(shapely.Polygon(points)).geoms
    pieces = [p for p in triangles if p.area > 1e-10]
    merged = True
    while merged:
        merged = False
        for i in range(len(pieces)):
            for j in range(i + 1, len(pieces)):
                if pieces[i].intersection(pieces[j]).length < 1e-9:
                    continue
                union = pieces[i].union(pieces[j])
                if union.geom_type == "Polygon" and union.convex_hull.area - union.area < 1e-9:
                    pieces[i] = union
                    del pieces[j]
                    merged = True
                    break
            if merged:
                break
    return [tidy(shapely.get_coordinates(p)[:-1]) for p in pieces]


def solids_of(obj: SceneObject) -> list[Prism]:
    """Collision prisms of an object; a tilted one stands in the upright hulls of its turned parts."""
    prisms = [Prism(tidy(part.polygon), part.z) for part in obj.solids]
    x, y, z, w = obj.pose.quaternion
    if abs(x) < 1e-9 and abs(y) < 1e-9:
        return prisms
    yaw = obj.pose.yaw
    c, s = math.cos(yaw), math.sin(yaw)
    spin = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])  # back by the yaw that the engine keeps
    tilt = spin @ np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    import shapely

    leaning = []
    for prism in prisms:
        corners = np.concatenate([np.c_[prism.polygon, np.full(len(prism.polygon), z)] for z in prism.z]) @ tilt.T
        hull = shapely.MultiPoint(corners[:, :2]).convex_hull
        leaning.append(
            Prism(tidy(shapely.get_coordinates(hull)[:-1]), (float(corners[:, 2].min()), float(corners[:, 2].max())))
        )
    return leaning


def footprint_of(solids: list[Prism]) -> list[Points]:
    """The polygons that make up the footprint, without those that lie inside another."""
    import shapely

    shapes = [shapely.Polygon(p.polygon) for p in solids]
    order = sorted(range(len(shapes)), key=lambda i: -shapes[i].area)
    kept: list[int] = []
    for i in order:
        if not any(shapes[j].buffer(1e-9).covers(shapes[i]) for j in kept):
            kept.append(i)
    return [solids[i].polygon for i in kept]


def zones_of(obj: SceneObject) -> list[Prism]:
    """Hard access zones as convex prisms.

    The judge lets a body 5 mm into a convex zone. Of a concave one it measures depth over the whole, so that hardly
    any overlap is free: its pieces are made larger by what the engine's verdict would otherwise let in.
    """
    import shapely

    prisms = []
    for zone in obj.zones:
        polygon = tidy(zone.polygon)
        if not is_convex(polygon):
            polygon = shapely.get_coordinates(shapely.Polygon(polygon).buffer(5e-3, join_style="mitre"))[:-1]
        if zone.hard:
            prisms += [Prism(piece, zone.z) for piece in convex_pieces(polygon)]
    return prisms


def reach_of(polygons: list[Points]) -> float:
    """Largest distance of a vertex from the origin."""
    return max((float(np.max(np.hypot(p[:, 0], p[:, 1]))) for p in polygons), default=0.0)
