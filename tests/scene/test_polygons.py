"""The polygon checks against shapely's."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import Polygon

from sceneweaver.geometry.polygons import signed_area, union
from sceneweaver.scene.messages import FieldError
from sceneweaver.scene.polygons import check_simple, convex, counter_clockwise
from tests.sizes import examples

grid = st.lists(st.tuples(st.integers(0, 5), st.integers(0, 5)), min_size=3, max_size=8, unique=True)


def ring(n, start=0.0):
    return tuple((math.cos(start + i * math.tau / n), math.sin(start + i * math.tau / n)) for i in range(n))


@examples(100, 300)
@given(grid)
def test_simple_agrees_with_shapely(points):
    points = tuple((float(x), float(y)) for x, y in points)
    try:
        check_simple(points)
    except FieldError:
        assert not Polygon(points).is_valid
    else:
        assert Polygon(points).is_valid and Polygon(points).area == pytest.approx(abs(signed_area(points)))


@examples(100, 300)
@given(grid)
def test_convex_agrees_with_shapely(points):
    shape = Polygon(points)
    try:
        turned = convex(tuple((float(x), float(y)) for x, y in points))
    except FieldError:
        assert not shape.is_valid or shape.area < shape.convex_hull.area
    else:
        assert shape.area == shape.convex_hull.area and signed_area(turned) > 0 and turned[0] == points[0]


@pytest.mark.parametrize("n", [3, 8, 64, 65, 200])
def test_rings_of_any_number_of_corners_pass_and_turn(n):
    points = ring(n, 0.1)
    assert convex(points) == points
    assert set(counter_clockwise(points[::-1])) == set(points) and signed_area(counter_clockwise(points[::-1])) > 0


@pytest.mark.parametrize("turns", [2, 3])
def test_a_star_turns_left_at_every_corner_and_is_no_convex_polygon(turns):
    star = tuple(ring(7)[i * turns % 7] for i in range(7))
    with pytest.raises(FieldError, match="crosses itself"):
        convex(star)


def test_convexity_tolerates_rounding_only():
    assert convex(((0.0, 0.0), (0.5, 1e-11), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)))
    with pytest.raises(FieldError, match="not convex at corner"):
        convex(((0.0, 0.0), (0.5, 1e-6), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)))
    far = tuple((x + 4e5, y - 7e5) for x, y in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)))
    assert convex(far) == far


def test_union_of_what_nearly_coincides() -> None:
    """The parts of a sofa bed as it stood in a room, whose edges differ in the last digits."""
    parts = [shapely.Polygon(p) for p in json.loads((Path(__file__).parent / "nearly_coincident.json").read_text())]
    with pytest.raises(shapely.errors.GEOSException):
        shapely.union_all(parts)  # when this passes, `union` needs no second way
    whole = union(parts)
    assert whole.is_valid and max(p.area for p in parts) < whole.area < sum(p.area for p in parts)
    assert all(shapely.difference(p, whole.buffer(2e-6)).area < 1e-12 for p in parts)
    assert union([]).is_empty and union(iter(parts[:1])).equals(parts[0])
