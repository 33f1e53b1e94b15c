"""Plans as convex pieces: rectangles where all edges run along x or y, else convex polygons; and these as slabs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.physics.enclosure import Standing
from sceneweaver.physics.shell import Slab

if TYPE_CHECKING:
    from shapely import Polygon

_LEAST = 1e-5  # [m2] of a piece that is none
_SQUARE = 1e-6  # [m] by which the edges of a plan may be off the axes, and corners of a box off a right angle


def polygons(plan: Any) -> Iterator[Polygon]:
    """The polygons of a geometry, without slivers."""
    import shapely

    for part in getattr(plan, "geoms", [plan]):
        if isinstance(part, shapely.Polygon):
            if part.area > _LEAST:
                yield part
        elif hasattr(part, "geoms"):
            yield from polygons(part)


def convex_pieces(plan: Any) -> list[np.ndarray]:
    """A plan as disjoint convex polygons [N, 2], counter-clockwise; those of a rectilinear one are rectangles."""
    found: list[np.ndarray] = []
    for polygon in polygons(plan):
        edges = np.concatenate([np.diff(np.asarray(r.coords), axis=0) for r in (polygon.exterior, *polygon.interiors)])
        straight = bool((np.abs(edges).min(axis=1) < _SQUARE).all())
        found += _rectangles(polygon) if straight else _convex(polygon)
    return found


def slab_of(corners: np.ndarray, low: float, high: float, *, pane: bool = False) -> tuple[Slab, float]:
    """A prism over a convex plan [N, 2] from ``low`` to ``high`` [m], about the world's origin, and the yaw by which
    that frame is turned: a box where the plan is a rectangle, else a hull."""
    yaw = _turn(corners)
    c, s = math.cos(yaw), math.sin(yaw)
    local = corners @ np.array([[c, -s], [s, c]]) if yaw else corners
    least, most = np.array([*local.min(axis=0), low]), np.array([*local.max(axis=0), high])
    centre, half = (least + most) / 2, (most - least) / 2
    if len(corners) == 4 and np.minimum(np.abs(local - least[:2]), np.abs(local - most[:2])).max() < _SQUARE:
        return Slab(centre, half, pane), yaw
    points = np.concatenate([np.column_stack([corners, np.full(len(corners), z)]) for z in (low, high)])
    least, most = points.min(axis=0), points.max(axis=0)
    return Slab((least + most) / 2, (most - least) / 2, pane, points), 0.0


def standing(name: str, corners: np.ndarray, *levels: tuple[float, float], pane: bool = False) -> Standing:
    """What stands still over one convex plan [N, 2], from and to some heights [m]."""
    made = [slab_of(corners, low, high, pane=pane) for low, high in levels]
    return Standing(name, tuple(slab for slab, _ in made), yaw=made[0][1])


def plan_of(body: Standing) -> Polygon:
    """What the hull of a body covers in plan."""
    import shapely

    found = []
    for slab in body.slabs:
        a, b = slab.half[:2]
        box = slab.centre[:2] + np.array([(-a, -b), (a, -b), (a, b), (-a, b)])
        found.append(box if slab.points is None else slab.points[:, :2])
    c, s = math.cos(body.yaw), math.sin(body.yaw)
    points = np.concatenate(found) @ np.array([[c, s], [-s, c]]) + body.position[:2]
    return shapely.MultiPoint(points).convex_hull  # pyright: ignore[reportReturnType]


def _turn(corners: np.ndarray) -> float:
    """The direction [rad] of the longest edge, in [0, pi / 2)."""
    edges = np.roll(corners, -1, axis=0) - corners
    x, y = edges[int(np.linalg.norm(edges, axis=1).argmax())]
    yaw = math.atan2(y, x) % (math.pi / 2)
    return 0.0 if min(yaw, math.pi / 2 - yaw) < 1e-9 else yaw


def _rectangles(polygon: Polygon) -> list[np.ndarray]:
    """A rectilinear polygon as rectangles: the largest run of its grid, then that of what is left."""
    import shapely

    rings = [np.asarray(ring.coords) for ring in (polygon.exterior, *polygon.interiors)]
    xs, ys = (_merged(np.concatenate(rings)[:, axis]) for axis in (0, 1))
    middle = np.meshgrid((xs[:-1] + xs[1:]) / 2, (ys[:-1] + ys[1:]) / 2, indexing="ij")
    left = shapely.contains_xy(polygon, *middle)
    found = []
    while left.any():
        runs = [_run(left, *at) for at in np.argwhere(left)[:1]]
        i, j, k, n = runs[0]
        left[i:j, k:n] = False
        found.append(np.array([(xs[i], ys[k]), (xs[j], ys[k]), (xs[j], ys[n]), (xs[i], ys[n])]))
    return found


def _run(left: np.ndarray, i: int, k: int) -> tuple[int, int, int, int]:
    """The longer of the two rectangles of cells from a first one on: along x and then y, or the other way round."""
    j = i + _length(left[i:, k])
    n = k + _length(np.all(left[i:j, k:], axis=0))
    m = k + _length(left[i, k:])
    p = i + _length(np.all(left[i:, k:m], axis=1))
    return (i, j, k, n) if (j - i) * (n - k) >= (p - i) * (m - k) else (i, p, k, m)


def _length(cells: Any) -> int:
    """How many of the first cells are true."""
    return len(cells) if np.all(cells) else int(np.argmin(cells))


def _merged(values: np.ndarray) -> np.ndarray:
    """Different values in order; those nearer to each other than rounding are one."""
    found = np.unique(values)
    return found[np.concatenate([[True], np.diff(found) > 2 * _SQUARE])]


def _convex(polygon: Polygon) -> list[np.ndarray]:
    """Any polygon as convex ones: its triangles, joined across each edge, longest first, where that stays convex.

    Hertel and Mehlhorn, Fast triangulation of simple polygons (1983): at most four times as many as need be.
    """
    import shapely

    numbers: dict[tuple[float, float], int] = {}
    pieces: list[list[int]] = []
    for triangle in polygons(shapely.constrained_delaunay_triangles(polygon)):
        ring = shapely.geometry.polygon.orient(triangle).exterior.coords
        pieces.append([numbers.setdefault((float(x), float(y)), len(numbers)) for x, y, *_ in list(ring)[:-1]])
    points = np.array(list(numbers))
    owner = {edge: k for k, piece in enumerate(pieces) for edge in _edges(piece)}
    inner = [(a, b) for a, b in owner if a < b and (b, a) in owner]
    for a, b in sorted(inner, key=lambda edge: -float(np.linalg.norm(points[edge[0]] - points[edge[1]]))):
        one, two = owner[a, b], owner[b, a]
        first, second = (_from(pieces[k], start) for k, start in ((one, b), (two, a)))
        both = first[:-1] + second[:-1]
        if one != two and _is_convex(points[both]):
            pieces[one], pieces[two] = both, []
            owner |= dict.fromkeys(_edges(both), one)
    return [_corners(shapely.Polygon(points[piece])) for piece in pieces if piece]


def _edges(piece: list[int]) -> list[tuple[int, int]]:
    return list(zip(piece, piece[1:] + piece[:1], strict=True))


def _from(piece: list[int], start: int) -> list[int]:
    """The corners of a piece from one of them on."""
    k = piece.index(start)
    return piece[k:] + piece[:k]


def _is_convex(corners: np.ndarray) -> bool:
    """Whether corners [N, 2] turn left everywhere, or not at all."""
    before, after = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
    return bool((before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0] > -1e-12).all())


def _corners(polygon: Polygon) -> np.ndarray:
    """The corners [N, 2] of a convex polygon, counter-clockwise, none on a straight line between others."""
    import shapely

    hull: Any = polygon.convex_hull.simplify(1e-9)
    return np.asarray(shapely.geometry.polygon.orient(hull).exterior.coords)[:-1]
