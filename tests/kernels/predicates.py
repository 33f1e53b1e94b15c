"""The verdict as its definitions have it, in float64: how far each thing is from being false.

Every margin is positive where the predicate holds, negative where it does not, in metres or the feature's unit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from sceneweaver.kernels import tables as k
from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.layout.pack import MARGINS
from sceneweaver.layout.shapes import Prism
from tests.kernels.polygons import placed, reach, separation, shared_height
from tests.kernels.twin import row_value

VALID, BROKEN, UNMET, DIVERGED = 0, 1, 2, 3


def apart_margin(
    first: Sequence[Prism], one: np.ndarray, second: Sequence[Prism], two: np.ndarray, hold: float, overlap_in_z: float
) -> float:
    """How much further apart two sets of prisms are than they must be, in z or in the plane."""
    margin = np.inf
    for p in first:
        for q in second:
            free = overlap_in_z - float(shared_height(p, one[2], q, two[2]))
            if free < margin:
                gap = separation(placed(p.polygon, one[None]), placed(q.polygon, two[None]), q.real, min(hold, 0.0))
                margin = min(margin, max(free, float(gap[0]) - hold))
    return margin


def room_margin(problem: LayoutProblem, i: int, pose: np.ndarray, m: Mapping[str, float]) -> float:
    """Object i inside the room and clear of its openings."""
    region, hold = problem.region, m["bounds_hold"]
    corners = np.concatenate([placed(f, pose[None])[0] for f in problem.footprints[i]])
    depth = corners @ region.planes[:, :2].T - region.planes[:, 2]
    low, high = min(p.z[0] for p in problem.solids[i]), max(p.z[1] for p in problem.solids[i])
    margins = [float(depth.min()) - hold, pose[2] + low - hold, region.height - hold - pose[2] - high]
    still = np.zeros(4)
    margins.append(apart_margin(problem.solids[i], pose, region.solids, still, hold, m["least_overlap_z"]))
    if problem.clear[i]:
        margins.append(
            apart_margin(problem.solids[i], pose, region.openings, still, m["zone_hold"], m["least_overlap_z"])
        )
    return min(margins)


def pair_margin(problem: LayoutProblem, i: int, j: int, poses: np.ndarray, m: Mapping[str, float]) -> float:
    """Objects i and j neither collide nor stand in each other's hard zones."""
    flags = int(problem.flags[i, j])
    margins = [np.inf]
    for bit, hold, a, b in (
        (k.PAIR_COLLIDE, m["collision_hold"], problem.solids[i], problem.solids[j]),
        (k.PAIR_ZONE_OF_FIRST, m["zone_hold"], problem.zones[i], problem.solids[j]),
        (k.PAIR_ZONE_OF_SECOND, m["zone_hold"], problem.solids[i], problem.zones[j]),
    ):
        if flags & bit:
            margins.append(apart_margin(a, poses[i], b, poses[j], hold, m["least_overlap_z"]))
    return min(margins)


def object_margins(problem: LayoutProblem, poses: np.ndarray, m: Mapping[str, float] = MARGINS) -> np.ndarray:
    """Margin of every object [N]; a pair counts for both."""
    margins = np.array([room_margin(problem, i, poses[i], m) for i in range(problem.size)])
    radius = np.array([reach([*s, *z]) for s, z in zip(problem.solids, problem.zones, strict=True)])
    far = np.hypot(*(poses[:, None, :2] - poses[None, :, :2]).transpose(2, 0, 1)) > radius[:, None] + radius[None, :]
    for i, j in zip(*np.nonzero(np.triu(~far, 1)), strict=True):
        margin = pair_margin(problem, i, j, poses, m)
        margins[i], margins[j] = min(margins[i], margin), min(margins[j], margin)
    return margins


def relation_margins(problem: LayoutProblem, poses: np.ndarray) -> np.ndarray:
    """Margin of every relation [R] under its best option."""
    margins = []
    for rel in problem.relations:
        at = {i: poses[None, i] for i in rel.objects if i >= 0}
        options = []
        for rows in rel.options:
            values = [(float(row_value(problem, row, rel.objects, at)[0]), row.hold) for row in rows]
            options.append(min((min(v - low, high - v) for v, (low, high) in values), default=np.inf))
        margins.append(max(options))
    return np.array(margins)


def status(problem: LayoutProblem, objects: np.ndarray, relations: np.ndarray) -> int:
    """Status of a layout from its margins."""
    faults = np.array([rel.fault for rel in problem.relations], dtype=int)
    if (objects < 0).any() or (faults[relations < 0] == BROKEN).any():
        return BROKEN
    return UNMET if (faults[relations < 0] == UNMET).any() else VALID
