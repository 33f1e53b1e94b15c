"""Every feature of relation rows: value through the penalty and gradient for every role, in and out of intervals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sceneweaver.kernels import tables as k
from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.layout.rows import INF, CompiledRelation, Row
from tests.kernels import compare, twin
from tests.kernels.harness import as_float32
from tests.kernels.made import chair, sofa, table
from tests.sizes import sizes
from tests.verify.build import scene

ALONE = {"collision": 0.0, "bounds": 0.0, "zone": 0.0, "opening": 0.0, "relation": 1.4}
EXCESS = {"inside": -0.1, "near side of the knee": 0.03, "far side of the knee": 0.5}

# Features and the objects that they are about: subject, first target, second target; -1 is the room.
CASES = {
    "line to the room": (k.FEATURE_LINE, (0, -1, -1)),
    "line to an object": (k.FEATURE_LINE, (0, 1, -1)),
    "yaw to the room": (k.FEATURE_YAW, (0, -1, -1)),
    "yaw to an object": (k.FEATURE_YAW, (0, 1, -1)),
    "bearing": (k.FEATURE_BEARING, (0, 1, -1)),
    "distance of objects": (k.FEATURE_DISTANCE, (0, 1, -1)),
    "distance of several prisms": (k.FEATURE_DISTANCE, (2, 1, -1)),
    "distance to a polygon": (k.FEATURE_DISTANCE, (2, -1, -1)),
    "distance to a point": (k.FEATURE_DISTANCE, (0, -1, -1)),
    "extent": (k.FEATURE_EXTENT, (0, -1, -1)),
    "window": (k.FEATURE_WINDOW, (0, -1, -1)),
    "height above the floor": (k.FEATURE_HEIGHT, (0, -1, -1)),
    "height above an object": (k.FEATURE_HEIGHT, (0, 1, -1)),
    "between": (k.FEATURE_BETWEEN, (0, 1, 2)),
    "aside": (k.FEATURE_ASIDE, (0, 1, 2)),
    "spread": (k.FEATURE_SPREAD, (0, 1, 2)),
    "constant": (k.FEATURE_CONSTANT, (0, 1, -1)),
}


def base() -> LayoutProblem:
    objects = [chair("a", 1.0, 1.0), table("b", 3.0, 3.0), sofa("c", 5.0, 5.0)]
    return compile_scene(scene(objects)).room


def blank(name: str, rng: np.random.Generator) -> Row:
    """A row of a feature with random numbers and no interval yet."""
    feature = CASES[name][0]
    free = (-INF, INF)
    turn = rng.uniform(-np.pi, np.pi)
    normal = (float(np.cos(turn)), float(np.sin(turn)))
    point = tuple(rng.uniform(-1.0, 1.0, 2).tolist())
    row = Row(feature, free, free, point, normal, float(rng.uniform(-2.0, 2.0)), scale=float(rng.uniform(0.3, 1.5)))
    if feature == k.FEATURE_YAW:
        return row._replace(normal=(float(rng.choice([np.pi / 2, np.pi, 2 * np.pi])), 0.0))
    if feature == k.FEATURE_WINDOW:
        return row._replace(point=(float(rng.uniform(0.1, 0.6)), float(rng.uniform(0.2, 1.0))))
    if name == "distance to a polygon":
        return row._replace(polygon=np.array([[2.0, 2.0], [3.0, 2.2], [3.1, 2.9], [2.2, 3.1]]))
    if name == "distance to a point":
        return row._replace(polygon=np.array([[2.6, 2.7]]))
    return row


def asked(
    problem: LayoutProblem, row: Row, ids: tuple[int, int, int], layout: np.ndarray, excess: float, above: bool
) -> LayoutProblem:
    """The problem with one relation of one row, whose interval the layout misses by the excess [m]."""
    poses = {i: layout[None, i] for i in ids if i >= 0}
    value = float(twin.row_value(problem, row, ids, poses)[0])
    edge = value - excess / row.scale if above else value + excess / row.scale
    aim = (-INF, edge) if above else (edge, INF)
    if abs(edge) < INF and excess < 0:  # closed at both ends where the value lies inside
        aim = (edge - 2 * abs(excess) / row.scale, edge) if above else (edge, edge + 2 * abs(excess) / row.scale)
    relation = CompiledRelation(ids, [[row._replace(aim=aim, hold=aim)]], 0.7, 2, True)
    return replace(problem, relations=[relation], relation_ids=[0])


@pytest.mark.parametrize("above", [False, True], ids=["below", "above"])
@pytest.mark.parametrize("excess", EXCESS.values(), ids=EXCESS.keys())
@sizes("count", 8, 30)
@pytest.mark.parametrize("name", CASES)
def test_feature(device, name, excess, above, count):
    rng = np.random.default_rng(3)
    problem, ids = base(), CASES[name][1]
    layouts = as_float32(rng.normal(size=(count, 3, 4)) * (0.9, 0.9, 0.4, 2.5) + (2.5, 2.5, 0.5, 0.0))
    rows = [blank(name, rng) for _ in layouts]
    problems = [asked(problem, row, ids, layout, excess, above) for row, layout in zip(rows, layouts, strict=True)]
    options = [np.zeros(1, dtype=int)] * count
    tally = compare.check(problems, range(count), layouts, options, device, weights=ALONE, name=name)
    parts = len([i for i in ids if i >= 0])
    assert tally.active == (0 if excess < 0 else count if name == "constant" else count * parts)
