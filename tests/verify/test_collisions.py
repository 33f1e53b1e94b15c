"""Collisions of prisms and of tilted bodies on both sides of each threshold, and the depth of convex bodies."""

import importlib
import math
import tracemalloc

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from sceneweaver.verify import check, convex
from sceneweaver.verify.overlap import CHUNK, MOST_PAIRS, overlaps
from sceneweaver.verify.solids import Placed
from tests.verify.build import box, judge, only, rectangle, scene, times, turned


@pytest.mark.parametrize(
    ("dx", "dz", "count"),
    [
        (1.0, 0.0, 0),
        (0.9992, 0.0, 0),
        (0.9988, 0.0, 1),
        (0.5, 0.9992, 0),
        (0.5, 0.9988, 1),
        (0.5, 1.2, 0),
        (0.9, 0.9, 1),
    ],
)
def test_boxes(dx, dz, count):
    report = judge([box("a", (1, 1, 1), 4, 4), box("b", (1, 1, 1), 4 + dx, 4, z=dz)])
    assert report.collisions == count
    if count:
        assert only(report, "collision").amount == pytest.approx(1 - max(dx, dz))


def test_volume():
    """Boxes whose edges cross: 1.5 mm deep, sharing 1.5 mm x 1.5 mm x height; 1e-6 m3 is a height of 0.44 m."""
    for height, count in ((0.44, 0), (0.45, 1)):
        low = box("a", (1, 1, height), 4, 4)
        assert judge([low, box("b", (1, 1, 1), 4.9985, 4.9985)]).collisions == count


def test_one_percent_of_a_small_body():
    """A cube of 4 cm counts from 0.64e-6 m3: crossing edges 3.5 mm deep share less than that, 4.5 mm more."""
    for depth, count in ((0.0035, 0), (0.0045, 1)):
        near = 4.5 + 0.02 - depth
        assert judge([box("a", (1, 1, 1), 4, 4), box("b", (0.04, 0.04, 0.04), near, near)]).collisions == count


def test_what_is_said():
    chair = {**box("chair-0", (0.5, 0.5, 0.9), 4.368, 4.0)}
    found = only(judge([chair, box("desk-0", (0.3, 1.0, 0.7), 4.0, 4.0)]), "collision")
    assert found.objects == ("chair-0", "desk-0")
    assert found.detail == "chair-0 sinks 3.2 cm into desk-0"
    assert found.amount == pytest.approx(0.032)


def test_parts_of_one_object_may_overlap():
    halves = [rectangle(-0.5, -0.5, 0.2, 0.5), rectangle(0, -0.5, 0.5, 0.5)]
    two = [{"polygon": half, "z": [0, 1]} for half in halves]
    assert judge([box("a", (1, 1, 1), 4, 4, parts=two)]).valid


def test_a_chair_under_a_table():
    legs = [{"polygon": rectangle(x, y, x + 0.05, y + 0.05), "z": [0, 0.7]} for x in (-0.4, 0.35) for y in (-0.6, 0.55)]
    top = {"polygon": rectangle(-0.4, -0.6, 0.4, 0.6), "z": [0.7, 0.74]}
    table = box("table", (0.8, 1.2, 0.74), 4, 4, parts=[*legs, top])
    chair = box(
        "chair",
        (0.5, 0.5, 0.9),
        4.4,
        4,
        180.0,
        parts=[
            {"polygon": rectangle(-0.2, -0.25, 0.25, 0.25), "z": [0, 0.45]},
            {"polygon": rectangle(-0.25, -0.25, -0.2, 0.25), "z": [0.45, 0.9]},
        ],
    )
    assert judge([table, chair]).valid
    inside = {**chair, "pose": {"position": [4.15, 4, 0], "quaternion": turned(180.0)}}
    assert only(judge([table, inside]), "collision").amount == pytest.approx(0.04)


# ---- tilted


def plank(z, x=4.0, degrees=30.0):
    """A board 2 x 0.2 x 0.02 m that rises from left to right."""
    return box("plank", (2.0, 0.2, 0.02), x, 4.0, z=z, quaternion=turned(-degrees, "y"))


def test_a_tilted_board_over_a_box():
    """The shadow of the board covers the box and its heights overlap, yet it passes over the box."""
    low = box("box", (0.4, 0.4, 0.4), 4.5, 4.0)
    a = math.radians(30)
    edge = 0.4 + (0.0 - 0.3) * math.tan(a)  # where the underside must be at the origin to touch the box's left top edge
    assert judge([plank(edge + 0.002), low]).collisions == 0
    report = judge([plank(edge - 0.02), low])
    assert report.collisions == 1
    assert only(report, "collision").amount == pytest.approx(0.02 * math.cos(a), abs=2e-4)
    assert judge([plank(edge - 0.001), low]).collisions == 0  # 0.87 mm deep


def test_two_tilted_bodies():
    """Equally tilted cubes side by side touch face to face, whatever their shadows do."""
    lean = times(turned(20.0), turned(12.0, "x"))
    x, y, z, w = lean
    axis = np.array([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)])
    first = np.array([4.0, 4.0, 0.5])
    for gap, count in ((0.0, 0), (-0.0008, 0), (-0.002, 1)):
        second = first + axis * (0.5 + gap)
        things = [
            box(name, (0.5, 0.5, 0.5), *p[:2], z=p[2], quaternion=lean) for name, p in (("a", first), ("b", second))
        ]
        assert judge(things).collisions == count


def test_tilted_like_upright_just_above_half_a_degree():
    """The exact arithmetic of tilted bodies agrees with that of prisms where the tilt hardly matters."""
    rng = np.random.default_rng(3)
    for _ in range(60):
        x, y, yaw = *rng.uniform(3.2, 4.8, 2), rng.uniform(0, 360)
        still = box("a", (0.8, 0.5, 0.4), 4, 4)
        upright = judge([still, box("b", (0.6, 0.6, 0.5), x, y, yaw)])
        lean = times(turned(yaw), turned(0.51, "x"))
        tilted = judge([still, box("b", (0.6, 0.6, 0.5), x, y, quaternion=lean)])
        if upright.collisions and only(upright, "collision").amount > 0.01:
            assert only(tilted, "collision").amount == pytest.approx(only(upright, "collision").amount, abs=0.01)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(0, 2**32 - 1))
def test_depth_in_space_is_that_of_prisms(seed):
    rng = np.random.default_rng(seed)
    sizes = rng.uniform(0.2, 1.0, (2, 3))
    things = [
        box(name, tuple(s), *rng.uniform(3.7, 4.3, 2), rng.uniform(0, 360), rng.uniform(0, 0.3))
        for name, s in zip("ab", sizes, strict=True)
    ]
    placed = Placed.of(scene(things))
    pairs = overlaps(placed.parts, placed.parts)
    (a0, a1), (b0, b1) = (body.z for body in placed.bodies)
    flat = min(pairs.depth[0], a1 - b0, b1 - a0) if len(pairs) else 0.0
    corners = [
        b.to_world(np.array([[x, y, z] for x in (-d / 2, d / 2) for y in (-w / 2, w / 2) for z in (0, h)]))
        for b in placed.bodies
        for d, w, h in [b.size]
    ]
    exact = convex.depth(*corners)
    assert exact == pytest.approx(flat, abs=1e-9) or (flat == 0.0 and exact <= 1e-3)
    if len(pairs):
        volume = convex.shared_volume(*map(convex.solid, corners))
        assert volume == pytest.approx(pairs.area[0] * pairs.rise[0], rel=1e-6, abs=1e-12)


def test_depth_of_large_hulls_is_nearly_exact():
    rng = np.random.default_rng(0)
    ball = rng.normal(size=(400, 3))
    ball /= np.linalg.norm(ball, axis=1)[:, None]
    assert len(ball) ** 2 > convex.EXACT_POINTS
    assert convex.depth(ball, ball + (1.5, 0.3, 0.2)) == pytest.approx(2 - np.linalg.norm((1.5, 0.3, 0.2)), abs=0.03)
    assert convex.depth(ball, ball + (3.0, 0.0, 0.0)) == 0.0


def test_flat_bodies_have_no_depth():
    sheet = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    assert convex.depth(sheet, sheet) == 0.0
    assert convex.hull_vertices(sheet).shape == (4, 3)


def test_a_heap_of_objects_is_judged_without_filling_the_memory():
    heap = scene([box(f"a{i}", (1, 1, 1), 4, 4) for i in range(2000)])
    tracemalloc.start()
    try:
        report = check(heap, walkable=False)
        assert tracemalloc.get_traced_memory()[1] < 200 << 20
    finally:
        tracemalloc.stop()
    assert not report.valid and report.collisions == MOST_PAIRS
    assert f"over {MOST_PAIRS} pairs of parts overlap; no more of them were counted" in report.warnings


def test_a_tower_is_no_heap():
    tower = scene([box(f"a{i}", (1, 1, 0.001), 4, 4, 0, 0.001 * i) for i in range(2000)])
    report = check(tower, walkable=False)
    assert report.collisions == 0 and not report.warnings


def test_overlaps_of_many_are_those_of_all_pairs():
    rng = np.random.default_rng(1)
    some = [box(f"a{i}", (1, 1, 1), *rng.uniform(0, 8, 2), rng.uniform(0, 360)) for i in range(3 * CHUNK)]
    parts = Placed.of(scene(some)).parts
    found = overlaps(parts, parts)
    crossing = shapely.area(shapely.intersection(parts.polygons[:, None], parts.polygons[None, :])) > 0.05
    assert {(i, j) for i, j in zip(*np.nonzero(np.triu(crossing, 1)), strict=True)} <= set(
        zip(found.i.tolist(), found.j.tolist(), strict=True)
    )
    assert not found.cut and len(set(zip(found.i.tolist(), found.j.tolist(), strict=True))) == len(found)


def test_the_judge_ends_with_the_block_that_it_runs_in(monkeypatch):
    """Each of its loops comes to a checkpoint: none of them goes on for long after the deadline."""
    made = scene([box(f"a{i}", (0.2, 0.2, 0.2), 0.1 + 0.25 * i, 4) for i in range(20)])
    for name in ("check", "overlap", "bounds", "support"):
        looked = []
        module = importlib.import_module(f"sceneweaver.verify.{name}")
        monkeypatch.setattr(module, "checkpoint", lambda looked=looked: looked.append(1))
        check(made)
        assert looked, name
