"""The features of relation rows, each from its meaning, in float64; see `twin`.

A feature takes the problem, the row, the objects (subject, first and second target; -1: the room) and their poses
[K, 4], and gives [K] values.
"""

from __future__ import annotations

import numpy as np

from sceneweaver.kernels import tables as k
from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.layout.rows import Row
from tests.kernels import polygons
from tests.kernels.polygons import placed

Ids = tuple[int, int, int]
Array = np.ndarray


def _heading(yaw: Array) -> Array:
    return np.stack([np.cos(yaw), np.sin(yaw)], axis=-1)


def _dot(a: Array, b: Array) -> Array:
    return np.sum(a * b, axis=-1)


def _cross(a: Array, b: Array) -> Array:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _turn(v, pose: Array) -> Array:
    """A vector fixed to an object, in the world: [K, 2]."""
    front = _heading(pose[:, 3])
    left = _heading(pose[:, 3] + np.pi / 2)
    return v[0] * front + v[1] * left


def _fold(angle: Array, period: float) -> Array:
    """The angle modulo the period, between minus and plus half of it."""
    return (angle + period / 2) % period - period / 2


def line(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """How far a point of the subject is beyond a line that is fixed to the target."""
    point = a[:, :2] + _turn(row.point, a)
    return _dot(point - b[:, :2], _turn(row.normal, b)) - row.offset


def yaw(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Yaw of the subject less the target's, off the wanted one."""
    return _fold(a[:, 3] - b[:, 3] - row.offset, row.normal[0])


def bearing(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Angle from the subject's front to the direction of the target."""
    front, to = _heading(a[:, 3]), b[:, :2] - a[:, :2]
    return np.arctan2(_cross(front, to), _dot(front, to))


def distance(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Euclidean distance of footprints, or of footprint and polygon of the room; minus the depth of an overlap."""
    theirs = problem.footprints[ids[1]] if row.polygon is None else [row.polygon]
    pairs = ((placed(mine, a), placed(other, b)) for mine in problem.footprints[ids[0]] for other in theirs)
    return np.min([polygons.distance(p, q) for p, q in pairs], axis=0)


def _shadow(problem: LayoutProblem, row: Row, ids: Ids, a: Array) -> tuple[Array, Array]:
    """Lowest and highest coordinate of the subject's box along the row's direction, from its offset."""
    depth, width, _ = problem.sizes[ids[0]] / 2
    corners = np.stack([_turn((x, y), a) for x in (-depth, depth) for y in (-width, width)], axis=1) + a[:, None, :2]
    along = corners @ np.asarray(row.normal) - row.offset
    return along.min(axis=1), along.max(axis=1)


def extent(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """How far the subject's box is beyond a line of the room."""
    return _shadow(problem, row, ids, a)[0]


def window(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """What the overlap of the subject's box and a window lacks; centres may be so far apart that the share is met."""
    low, high = _shadow(problem, row, ids, a)
    half, share = row.point
    shared = (high - low) / 2 + half - np.abs(high + low) / 2
    return share * np.minimum(high - low, 2 * half) - shared


def height(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Height of the subject above the target."""
    return a[:, 2] - b[:, 2] - row.offset


def between(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Where along the line between the targets the subject is: 0 at the first, 1 at the second."""
    line_ = c[:, :2] - b[:, :2]
    return _dot(a[:, :2] - b[:, :2], line_) / _dot(line_, line_)


def aside(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """How far left of the line from the first to the second target the subject is."""
    line_ = c[:, :2] - b[:, :2]
    return _cross(line_, a[:, :2] - b[:, :2]) / np.linalg.norm(line_, axis=1)


def spread(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """Angle about the first target from the second target to the subject, off the wanted one."""
    to_a, to_c = a[:, :2] - b[:, :2], c[:, :2] - b[:, :2]
    return _fold(np.arctan2(_cross(to_c, to_a), _dot(to_c, to_a)) - row.offset, 2 * np.pi)


def constant(problem: LayoutProblem, row: Row, ids: Ids, a: Array, b: Array, c: Array) -> Array:
    """The row's own number, whatever the poses."""
    return np.full(len(a), row.offset)


FEATURES = {
    k.FEATURE_LINE: line,
    k.FEATURE_YAW: yaw,
    k.FEATURE_BEARING: bearing,
    k.FEATURE_DISTANCE: distance,
    k.FEATURE_EXTENT: extent,
    k.FEATURE_WINDOW: window,
    k.FEATURE_HEIGHT: height,
    k.FEATURE_BETWEEN: between,
    k.FEATURE_ASIDE: aside,
    k.FEATURE_SPREAD: spread,
    k.FEATURE_CONSTANT: constant,
}
