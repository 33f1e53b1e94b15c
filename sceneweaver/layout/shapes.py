"""From the scene's polygons to convex prisms in plain arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.polygons import convex_pieces, is_convex, tidy
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.geometry.rotations import from_yaw, is_upright, matrix, multiply
from sceneweaver.scene import SceneObject

Points = np.ndarray  # [V, 2] float64, counter-clockwise
Corners = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Prism:
    """A convex polygon [V, 2] times a z interval; ``real[k]`` is False where edge k is no way out."""

    polygon: Points
    z: tuple[float, float]
    real: tuple[bool, ...] | None = None


def solids_of(obj: SceneObject) -> list[Prism]:
    """Collision prisms of an object; a tilted one stands in the upright hulls of its turned parts."""
    prisms = [Prism(_tidied(part.polygon), part.z) for part in obj.solids]
    if is_upright(obj.pose.quaternion):
        return prisms
    tilt = matrix(multiply(from_yaw(-obj.pose.yaw), obj.pose.quaternion))  # without the yaw that the engine keeps
    leaning = []
    for prism in prisms:
        corners = prism_vertices(prism.polygon, prism.z) @ tilt.T
        heights = (float(corners[:, 2].min()), float(corners[:, 2].max()))
        leaning.append(Prism(tidy(convex_hull(corners[:, :2])), heights))
    return leaning


@lru_cache(maxsize=1024)
def _tidied(polygon: Corners) -> Points:
    """A polygon as a tidy array, to be read only: scenes share polygons, and are compiled again and again."""
    return _read_only(tidy(polygon))


def footprint_of(solids: list[Prism]) -> list[Points]:
    """The polygons that make up the footprint, without those that lie inside another."""
    return [solids[i].polygon for i in _outermost(tuple(p.polygon.tobytes() for p in solids))]


@lru_cache(maxsize=1024)
def _outermost(polygons: tuple[bytes, ...]) -> tuple[int, ...]:
    """Which of some polygons [V, 2] float64 lie inside no other, the largest first."""
    import shapely

    shapes = [shapely.Polygon(np.frombuffer(p).reshape(-1, 2)) for p in polygons]
    order = sorted(range(len(shapes)), key=lambda i: -shapes[i].area)
    kept: list[int] = []
    for i in order:
        if not any(shapes[j].buffer(1e-9).covers(shapes[i]) for j in kept):
            kept.append(i)
    return tuple(kept)


def zones_of(obj: SceneObject) -> list[Prism]:
    """Hard access zones as convex prisms.

    The judge lets a body 5 mm into a convex zone. Of a concave one it measures depth over the whole, so that hardly
    any overlap is free: its pieces are made larger by what the engine's verdict would otherwise let in.
    """
    return [Prism(piece, zone.z) for zone in obj.zones if zone.hard for piece in _zone_pieces(zone.polygon)]


@lru_cache(maxsize=512)
def _zone_pieces(polygon: Corners) -> tuple[Points, ...]:
    """The convex pieces of a zone, read only."""
    import shapely

    points = tidy(polygon)
    if not is_convex(points):
        points = shapely.get_coordinates(shapely.Polygon(points).buffer(5e-3, join_style="mitre"))[:-1]
    return tuple(_read_only(piece) for piece in convex_pieces(points))


def _read_only(points: Points) -> Points:
    points = np.array(points, dtype=np.float64)
    points.setflags(write=False)
    return points


def reach_of(polygons: list[Points]) -> float:
    """Largest distance of a vertex from the origin."""
    return max((float(np.max(np.hypot(p[:, 0], p[:, 1]))) for p in polygons), default=0.0)
