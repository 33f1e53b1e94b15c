"""Outlines of rooms from what files hold instead: floor meshes, loose edges, walls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sceneweaver.geometry.polygons import signed_area, tidy, union

if TYPE_CHECKING:
    import numpy as np

MAX_TRIANGLES = 50_000
"""Triangles of a floor whose union is taken."""

_STRAIGHT = 1e-4  # sine below which a corner is none: meshes are written in single precision
_SAME = 1e-5  # [m] corners nearer than this are one
_CRACK = 2e-3  # [m] cracks between pieces of a floor that are closed


def of_triangles(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray | None, list[str]]:
    """The outline of a floor mesh.

    Args:
        points: vertices seen from above [n, 2].
        faces: triangles as indices [m, 3].

    Returns:
        The corners [k, 2] counter-clockwise, or None where nothing has an area; and notes on what was left out.
    """
    import numpy as np
    import shapely

    if len(faces) > MAX_TRIANGLES:
        return None, [f"the floor has {len(faces)} triangles; at most {MAX_TRIANGLES} are read"]
    corners = points[faces]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2
    pieces: Any = shapely.polygons(corners[area > 1e-9])
    found = union(list(pieces))
    return of_shape(found.buffer(_CRACK, join_style="mitre").buffer(-_CRACK, join_style="mitre"))


def of_shape(shape: Any) -> tuple[np.ndarray | None, list[str]]:
    """The outline [k, 2] of the largest polygon of a shapely geometry, and notes on what was left out."""
    import numpy as np
    import shapely

    parts = [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon" and part.area > 1e-6]
    if not parts:
        return None, []
    parts.sort(key=lambda part: -part.area)
    notes = []
    if len(parts) > 1:
        rest = sum(part.area for part in parts[1:])
        notes.append(f"the floor has {len(parts)} separate parts; the largest is kept, {rest:.2f} m2 are left out")
    if len(parts[0].interiors):
        notes.append(f"{len(parts[0].interiors)} holes of the floor are filled")
    corners = shapely.get_coordinates(parts[0].exterior)[:-1]
    apart = np.hypot(*(corners - np.roll(corners, 1, axis=0)).T) > _SAME
    return tidy(corners[apart] if apart.sum() >= 3 else corners, _STRAIGHT), notes


def ring_of_edges(edges: np.ndarray, tolerance: float) -> np.ndarray | None:
    """The corners [k, 2] of a ring that edges [n, 4] (x0, y0, x1, y1) form, in any order and either direction.

    Returns:
        Counter-clockwise; None where they do not close.
    """
    import numpy as np

    left = [(edge[:2], edge[2:]) for edge in edges if np.hypot(*(edge[2:] - edge[:2])) > 1e-9]
    if len(left) < 3:
        return None
    start, at = left.pop(0)
    ring = [start, at]
    while left:
        near = min(
            ((float(np.hypot(*(end - at))), k, side) for k, pair in enumerate(left) for side, end in enumerate(pair)),
        )
        if near[0] > tolerance:
            return None
        at = left.pop(near[1])[1 - near[2]]
        ring.append(at)
    if np.hypot(*(ring[-1] - ring[0])) > tolerance:
        return None
    corners = tidy(np.array(ring[:-1]), _STRAIGHT)
    return corners if len(corners) >= 3 and abs(signed_area(corners)) > 1e-9 else None


def of_walls(ends: np.ndarray, tolerance: float) -> list[np.ndarray]:
    """The rooms that walls [n, 4] (x0, y0, x1, y1) enclose, largest first, each as corners [k, 2] counter-clockwise.

    Ends within ``tolerance`` [m] of each other meet in their mean, and an end so near to another wall stands on it.
    """
    import numpy as np
    import shapely

    points = ends.reshape(-1, 2).copy()
    label = np.arange(len(points))
    apart = np.hypot(points[:, None, 0] - points[None, :, 0], points[:, None, 1] - points[None, :, 1])
    for k in range(len(points)):
        for near in label[np.flatnonzero(apart[k] <= tolerance)]:
            label[label == near] = label[k]
    for group in set(label.tolist()):
        points[label == group] = points[label == group].mean(axis=0)
    lines = []
    for a, b in points.reshape(-1, 2, 2):
        length = float(np.hypot(*(b - a)))
        if length <= 1e-9:
            continue
        along = (points - a) @ (b - a) / length
        across = np.abs((points - a) @ np.array([a[1] - b[1], b[0] - a[0]]) / length)
        on = (across <= tolerance) & (along > tolerance) & (along < length - tolerance)
        stops = [a, *points[on][np.argsort(along[on])], b]
        lines += [
            shapely.LineString(pair) for pair in zip(stops, stops[1:], strict=False) if (pair[0] != pair[1]).any()
        ]
    faces = shapely.get_parts(shapely.polygonize([shapely.node(shapely.MultiLineString(lines))])) if lines else []
    rooms = [tidy(shapely.get_coordinates(face.exterior)[:-1], _STRAIGHT) for face in faces if face.area > 1e-6]
    return sorted(rooms, key=lambda ring: -signed_area(ring))


def holds(outline: np.ndarray, point: Sequence[float]) -> bool:
    """Whether a point lies in an outline or on it."""
    import shapely

    return bool(shapely.Polygon(outline).buffer(1e-6).covers(shapely.Point(float(point[0]), float(point[1]))))


def near_wall(outline: Any, a: Any, b: Any, reach: float) -> bool:
    """Whether an opening, whose middle line runs from ``a`` to ``b``, lies in a wall of an outline.

    Args:
        outline: corners [k, 2].
        a: one end [2].
        b: the other end [2].
        reach: how far [m] the middle may lie from the wall's face; the wall must be parallel within 30 degrees.
    """
    import numpy as np

    one, other = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    middle, width = (one + other) / 2, float(np.hypot(*(other - one)))
    starts = np.asarray(outline, dtype=float)
    ways = np.roll(starts, -1, axis=0) - starts
    lengths = np.hypot(ways[:, 0], ways[:, 1])
    starts, ways, lengths = starts[lengths > 1e-9], ways[lengths > 1e-9], lengths[lengths > 1e-9]
    ways = ways / lengths[:, None]
    along = ((middle - starts) * ways).sum(axis=1)
    off = np.abs(ways[:, 0] * (middle - starts)[:, 1] - ways[:, 1] * (middle - starts)[:, 0])
    parallel = np.abs(ways @ (other - one)) >= 0.866 * width
    return bool((parallel & (off <= reach) & (along > -width / 4) & (along < lengths + width / 4)).any())


def middle_line(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """The two ends [2] of the line along the middle of a thin shape [n, 2], and its thickness [m]."""
    import shapely

    box = shapely.MultiPoint(corners).minimum_rotated_rectangle
    ring = shapely.get_coordinates(box)
    if len(ring) < 5:  # all on one line
        return ring[0], ring[-1], 0.0
    p, q, r, s = ring[:4]
    first, second = float(((q - p) ** 2).sum() ** 0.5), float(((r - q) ** 2).sum() ** 0.5)
    if first >= second:
        return (p + s) / 2, (q + r) / 2, second
    return (p + q) / 2, (r + s) / 2, first
