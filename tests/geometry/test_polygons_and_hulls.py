"""Polygons, hulls and prisms against shapely, trimesh and each other."""

import math

import numpy as np
import pytest
import shapely
import trimesh
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sceneweaver.geometry import hulls, polygons, prisms

clouds = st.lists(st.tuples(st.integers(-6, 6), st.integers(-6, 6)), min_size=1, max_size=12)


def star(radii):
    """A polygon with corners at these distances from the origin, at equal angles."""
    turns = [k * math.tau / len(radii) for k in range(len(radii))]
    return [(r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turns, strict=True)]


rings = st.lists(st.floats(0.3, 2.0), min_size=3, max_size=9).map(star)
solids = st.lists(st.tuples(*[st.floats(-2, 2)] * 3), min_size=5, max_size=20)


@given(rings)
def test_area_and_order(ring):
    area = shapely.Polygon(ring).area
    assert polygons.signed_area(ring) == pytest.approx(area, abs=1e-12)
    assert polygons.signed_area(np.array(ring)[::-1]) == pytest.approx(-area, abs=1e-12)
    assert polygons.signed_area(polygons.counter_clockwise(ring[::-1])) == pytest.approx(area, abs=1e-12)
    assert polygons.counter_clockwise(ring).tolist() == [list(p) for p in ring]


@given(st.floats(0.1, 4), st.floats(0.1, 4))
def test_a_rectangle_has_its_middle_at_the_origin(depth, width):
    box = shapely.Polygon(polygons.rectangle(depth, width))
    assert box.bounds == pytest.approx((-depth / 2, -width / 2, depth / 2, width / 2)) and box.exterior.is_ccw


@given(rings)
def test_tidy_takes_away_what_makes_no_difference(ring):
    doubled = [p for k, a in enumerate(ring) for p in (a, a, tuple((np.array(a) + ring[(k + 1) % len(ring)]) / 2))]
    found = polygons.tidy(doubled[::-1])
    assert polygons.signed_area(found) == pytest.approx(shapely.Polygon(ring).area, abs=1e-9)
    assert {tuple(p) for p in found} <= set(ring)


@given(rings)
def test_pieces_are_convex_and_fill_the_polygon(ring):
    shape = shapely.Polygon(ring)
    pieces = polygons.convex_pieces(ring)
    made = [shapely.Polygon(p) for p in pieces]
    assert all(polygons.is_convex(p, 1e-8) for p in pieces)
    assert sum(p.area for p in made) == pytest.approx(shape.area, abs=1e-8)
    assert polygons.union(made).symmetric_difference(shape).area < 1e-8
    edges = np.roll(ring, -1, axis=0) - ring
    after = np.roll(edges, -1, axis=0)
    reflex = (edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] < 0).sum()
    assert len(pieces) <= 2 * reflex + 1


def test_pieces_of_an_l_and_of_a_square():
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    assert len(polygons.convex_pieces(square)) == 1
    assert len(polygons.convex_pieces([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])) == 2


@given(rings)
def test_normals_point_out_of_a_polygon(ring):
    middles = (np.array(ring) + np.roll(ring, -1, axis=0)) / 2
    assume((np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1) > 1e-3).all())
    for middle, normal in zip(middles, polygons.normals(np.array(ring)), strict=True):
        assert math.hypot(*normal) == pytest.approx(1.0)
        assert not shapely.Polygon(ring).contains(shapely.Point(middle + 1e-6 * normal))


@given(clouds)
def test_hulls_in_the_plane(cloud):
    found = hulls.convex_hull(cloud)
    expected = shapely.MultiPoint(cloud).convex_hull
    assert {tuple(p) for p in found} <= {(float(x), float(y)) for x, y in cloud}
    assert tuple(found[0]) == min((float(x), float(y)) for x, y in cloud)
    if expected.geom_type == "Polygon":
        made = shapely.Polygon(found)
        assert made.equals(expected) and made.exterior.is_ccw
        assert len(polygons.tidy(found)) == len(found)  # no corner is on the line of its neighbours
    else:
        assert len(found) == (1 if expected.geom_type == "Point" else 2)


@settings(deadline=None)
@given(solids)
def test_hulls_in_space_are_closed_outward_and_hold_all_points(cloud):
    points = np.array(cloud)
    assume(np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[-1] > 0.05)
    vertices, faces = hulls.hull_mesh(points)
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    assert mesh.is_watertight and mesh.volume > 0 and len(vertices) == len(np.unique(faces))
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    assert (np.einsum("fk,pfk->pf", normal, points[:, None] - a[None]) <= 1e-9).all()
    assert (points[hulls.hull_faces(points)] == vertices[faces]).all()


def test_a_hull_is_made_once_and_cannot_be_written_to():
    points = np.random.default_rng(0).normal(size=(20, 3))
    hull = hulls.hull_of(points)
    assert hull is not None and hulls.hull_of(points.copy()) is hull
    corners, faces = hulls.hull_mesh(points)
    assert (points[hull.vertices] == corners).all() and (hull.vertices[faces] == hull.faces).all()
    assert hull.volume == pytest.approx(trimesh.Trimesh(corners, faces, process=False).volume)
    assert (corners @ hull.planes[:, :3].T + hull.planes[:, 3]).max() < 1e-9
    for array in (hull.vertices, hull.planes, hull.faces):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    hulls.hull_faces(points)[0] = 0  # its own copy


def test_flat_points_have_no_hull_in_space():
    assert hulls.hull_of(np.zeros((8, 3))) is None
    with pytest.raises(ValueError, match="in one plane"):
        hulls.hull_mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])


@given(clouds, st.floats(-1, 1), st.floats(0.1, 2))
def test_prisms_are_closed_and_outward(cloud, low, tall):
    plan = hulls.convex_hull(cloud)
    assume(len(plan) > 2)
    vertices, faces = prisms.prism_mesh(plan, (low, low + tall))
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    assert mesh.is_watertight and mesh.volume == pytest.approx(polygons.signed_area(plan) * tall)
    n = len(plan)
    assert (vertices[:n, 2] == low).all() and (vertices[n:, 2] == low + tall).all()
    assert (faces[: n - 2] < n).all() and (faces[n - 2 : 2 * n - 4] >= n).all() and len(faces) == 4 * n - 4
