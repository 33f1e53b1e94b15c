"""Problems whose objects may be packed as rectangles: what the blocks of a problem are."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.kernels.tables import FREE_PLANE, FREE_TURNS, FREE_YAW
from sceneweaver.optimizers.objective import Blocks

from .compile import LayoutProblem
from .yaw_domain import SAME

LEAST = 3
"""Blocks from which on orders of them are worth trying."""

AIR = 1.0e-4
"""[m] left between blocks."""

EVERY_QUARTER = 15


def blocks_of(room: LayoutProblem, roots: Sequence[int]) -> Blocks | None:
    """The blocks of a problem whose roots ``roots`` may move; None where packing is not what it is about.

    It is where every root may go anywhere on the floor and turn by quarters at least, and nothing hard says where: no
    fixed object, no hard relation. Blocks are rectangles around all that has to stay apart: bodies with hard zones.
    """
    kinds = (FREE_PLANE | FREE_YAW, FREE_PLANE | FREE_TURNS)
    every = [i for i in range(room.size) if room.roots[i] == i]
    bound = any(relation.fault for relation in room.relations)
    if len(roots) < LEAST or bound or any(room.free[i] not in kinds for i in every) or not len(room.region.planes):
        return None
    n = room.region.planes[0]
    angle = math.atan2(n[1], n[0])
    axes = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    corners = np.array(
        [_meet(room.region.planes[k - 1], room.region.planes[k]) for k in range(len(room.region.planes))]
    )
    low, high = (corners @ axes.T).min(axis=0), (corners @ axes.T).max(axis=0)
    rectangles = np.array([[_rectangle(room, i, quarter) for quarter in range(4)] for i in roots])
    origin = axes.T @ low
    extent = (float(high[0] - low[0]), float(high[1] - low[1]))
    turns = np.array([_quarters(room, i, angle) for i in roots], dtype=np.int32)
    if not turns.all():
        return None
    return Blocks(np.array(roots), rectangles, turns, (float(origin[0]), float(origin[1])), angle, extent)


def _quarters(room: LayoutProblem, root: int, angle: float) -> int:
    """Which quarters from an angle [rad] a root may be turned by, as bits."""
    if not room.yaws[root]:
        return EVERY_QUARTER
    turned = (angle + quarter * math.pi / 2 for quarter in range(4))
    allowed = [any(abs(wrap_angle(yaw - t)) <= SAME for yaw in room.yaws[root]) for t in turned]
    return sum(1 << quarter for quarter, good in enumerate(allowed) if good)


def _meet(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Where the edges of two neighbouring half planes (n, c) meet."""
    return np.linalg.solve(np.array([a[:2], b[:2]]), np.array([a[2], b[2]]))


def _rectangle(room: LayoutProblem, root: int, quarter: int) -> tuple[float, float, float, float]:
    """Lowest x and y, width and height of a root with what it carries and hard zones, turned by quarters."""
    points = [prism.polygon for prism in (*room.solids[root], *room.zones[root])]
    for i in range(room.size):
        if room.roots[i] == root and i != root:
            x, y, _, yaw = room.home[i]
            u, v, _, base = room.home[root]
            c, s = math.cos(-base), math.sin(-base)
            at = np.array([c * (x - u) - s * (y - v), s * (x - u) + c * (y - v)])
            c, s = math.cos(yaw - base), math.sin(yaw - base)
            turn = np.array([[c, -s], [s, c]])
            points += [prism.polygon @ turn.T + at for prism in room.solids[i]]
    c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter]
    placed = np.concatenate(points) @ np.array([[c, -s], [s, c]]).T
    low, high = placed.min(axis=0), placed.max(axis=0)
    return float(low[0]), float(low[1]), float(high[0] - low[0]) + AIR, float(high[1] - low[1]) + AIR
