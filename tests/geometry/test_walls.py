"""Walls with their coordinates, and the shell around them, against shapely."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from sceneweaver.geometry import shell
from sceneweaver.geometry.walls import wall_behind, walls_of
from sceneweaver.scene import Door, Window

L_SHAPE = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (3.0, 2.0), (3.0, 4.0), (0.0, 4.0))
KITE = ((0.0, 0.0), (4.0, -1.0), (5.0, 3.0), (0.5, 2.5))
SPLINTER = ((0.0, 0.0), (6.0, 0.0), (0.0, 0.6))
ROOMS = [L_SHAPE, KITE, SPLINTER]


def door(offset, width, height=2.1, swing="in-left", wall=0):
    return Door(id=f"d{offset}", wall=wall, offset=offset, width=width, height=height, swing=swing)


def window(offset, width, sill=0.9, height=1.2, wall=0):
    return Window(id=f"w{offset}", wall=wall, offset=offset, width=width, sill=sill, height=height)


@pytest.mark.parametrize("outline", ROOMS)
@given(st.floats(-2, 8), st.floats(-3, 3))
def test_coordinates_of_a_wall_go_both_ways(outline, offset, depth):
    floor = shapely.Polygon(outline)
    for i, wall in enumerate(walls_of(outline)):
        assert (wall.index, wall.start) == (i, outline[i])
        assert wall.end == pytest.approx(outline[(i + 1) % len(outline)])
        assert wall.coordinates(wall.point(offset, depth)) == pytest.approx((offset, depth), abs=1e-12)
        assert wall.frame.world(offset, depth) == pytest.approx(wall.point(offset, depth), abs=1e-12)
        line = shapely.LineString([wall.start, wall.end])
        assert line.distance(shapely.Point(wall.point(wall.length / 3, depth))) == pytest.approx(abs(depth), abs=1e-12)
        assert floor.contains(shapely.Point(wall.point(wall.length / 2, 0.01)))
        assert not floor.contains(shapely.Point(wall.point(wall.length / 2, -0.01)))
        assert (wall.outward[0] + wall.inward[0], wall.outward[1] + wall.inward[1]) == (0.0, 0.0)


def test_points_of_a_wall_may_be_arrays():
    wall = walls_of(KITE)[1]
    x, y = wall.point(np.array([0.5, 1.0]), np.array([0.1, 0.2]))
    np.testing.assert_allclose(wall.coordinates((x, y)), [[0.5, 1.0], [0.1, 0.2]], atol=1e-12)
    assert (x[1], y[1]) == wall.point(1.0, 0.2)


@pytest.mark.parametrize(
    ("opening", "depth", "z"),
    [
        (door(0.5, 0.8), 0.8, (0.0, 2.1)),
        (door(0.5, 0.9, swing="in-right"), 0.9, (0.0, 2.1)),
        (door(0.5, 0.9, 2.0, swing="out"), 0.6, (0.0, 2.0)),
        (door(0.5, 1.6, swing="slide"), 0.6, (0.0, 2.1)),
        (window(0.5, 1.2), 0.3, (0.9, 2.1)),
    ],
)
def test_what_an_opening_needs_free(opening, depth, z):
    walls = walls_of(KITE)
    zone = shell.clear_zone(opening, walls)
    assert shell.clearance(opening) == depth and shell.heights(opening) == pytest.approx(z)
    ring = shapely.LinearRing(zone)
    assert ring.is_ccw and shapely.Polygon(zone).area == pytest.approx(depth * opening.width)
    found = np.array([walls[0].coordinates(p) for p in zone])
    np.testing.assert_allclose(found.min(axis=0), (0.5, 0.0), atol=1e-12)
    np.testing.assert_allclose(found.max(axis=0), (0.5 + opening.width, depth), atol=1e-12)


@pytest.mark.parametrize("outline", [L_SHAPE, KITE])
def test_walls_fill_the_ring_between_the_outline_and_its_outer_one(outline):
    walls, floor = walls_of(outline), shapely.Polygon(outline)
    outer = shapely.Polygon(shell.outer_outline(walls))
    expected = floor.buffer(shell.WALL_THICKNESS, join_style="mitre", mitre_limit=10)
    assert outer.symmetric_difference(expected).area < 1e-12 and outer.exterior.is_ccw
    plans = [shapely.Polygon(shell.wall_plan(walls, k)) for k in range(len(walls))]
    assert all(plan.exterior.is_ccw for plan in plans)
    assert sum(plan.area for plan in plans) == pytest.approx(outer.area - floor.area, abs=1e-12)
    assert shapely.union_all(plans).symmetric_difference(outer - floor).area < 1e-12


def test_a_sharp_corner_is_cut_straight():
    walls = walls_of(SPLINTER)
    sharp = [math.degrees(math.acos(-np.dot(walls[k - 1].along, walls[k].along))) for k in range(3)]
    assert sharp[1] < 10  # its mitre would be more than ten thicknesses long
    corners = [shell.outer_corner(walls[k - 1], walls[k]) for k in range(3)]
    assert [c is None for c in corners] == [False, True, False]
    outer = shapely.Polygon(shell.outer_outline(walls))
    assert outer.is_valid and len(outer.exterior.coords) == 5
    reach = max(shapely.Point(p).distance(shapely.Polygon(SPLINTER)) for p in shell.outer_outline(walls))
    assert reach <= shell.LONGEST_MITRE * shell.WALL_THICKNESS
    assert all(shapely.Polygon(shell.wall_plan(walls, k)).is_valid for k in range(3))


def test_a_short_wall_between_leaning_corners_does_not_turn_over():
    outline = ((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.1, 1.5), (1.9, 1.5), (0.0, 3.0))
    walls = walls_of(outline)
    for k, wall in enumerate(walls):
        a, b = (wall.coordinates(p)[0] for p in shell.wall_plan(walls, k)[1:3])
        assert b > a


def test_a_wall_around_its_openings():
    openings = [window(2.0, 1.0), door(0.5, 1.0)]
    found = list(shell.wall_pieces(4.0, openings, 2.5, ends=(-0.1, 4.1)))
    area = {None: 0.0, "w2.0": 0.0, "d0.5": 0.0}
    for (a, b), (low, high), opening in found:
        area[getattr(opening, "id", None)] += (b - a) * (high - low)
    assert area == pytest.approx({"w2.0": 1.2, "d0.5": 2.1, None: 4.2 * 2.5 - 3.3})
    boxes = [shapely.box(a, low, b, high) for (a, b), (low, high), _ in found]
    assert shapely.union_all(boxes).area == pytest.approx(4.2 * 2.5)
    assert ((0.5, 1.5), (2.1, 2.5), None) in found and ((2.0, 3.0), (0.0, 0.9), None) in found


def test_openings_that_reach_beyond_the_wall_are_cut():
    lies, none = {"wall": 0, "offset": -0.3, "width": 0.8, "height": 9.0}, {"offset": 1.0, "width": 0.0}
    openings = [SimpleNamespace(**lies), window(3.5, 2.0, 1.0, 5.0), SimpleNamespace(**lies | none)]
    found = list(shell.wall_pieces(4.0, openings, 2.5))
    solid = [((0.5, 1.0), (0.0, 2.5)), ((1.0, 3.5), (0.0, 2.5)), ((3.5, 4.0), (0.0, 1.0))]
    assert [(span, z) for span, z, opening in found if opening is None] == solid


def test_openings_one_above_the_other():
    low, high = window(1.0, 1.0, 0.3, 0.5), window(1.0, 1.0, 1.2, 0.5)
    found = [(z, o) for span, z, o in shell.wall_pieces(3.0, [high, low], 2.0) if span == (1.0, 2.0)]
    np.testing.assert_allclose([z for z, _ in found], [(0, 0.3), (0.3, 0.8), (0.8, 1.2), (1.2, 1.7), (1.7, 2.0)])
    assert [o for _, o in found] == [None, low, None, high, None]


def test_what_hangs_in_a_corner_hangs_on_the_wall_at_its_back():
    walls = walls_of(L_SHAPE)
    assert wall_behind(walls, (0.1, 0.05, 1.5), (1.0, 0.0)) == 5
    assert wall_behind(walls, (0.1, 0.05, 1.5), (0.0, 1.0)) == 0
    assert wall_behind(walls, (3.02, 3.0), (-1.0, 0.0)) == 3
    assert wall_behind(walls, (2.9, 3.95), (0.0, -1.0)) == 4
