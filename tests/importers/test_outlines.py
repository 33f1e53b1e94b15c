"""Outlines from floor meshes, loose edges and walls, against shapes that were drawn first."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sceneweaver.importers.outlines import holds, middle_line, near_wall, of_triangles, of_walls, ring_of_edges
from tests.importers.boxes import same_ring

L_SHAPE = np.array([(0.0, 0.0), (4.2, 0.0), (4.2, 1.7), (2.6, 1.7), (2.6, 3.9), (0.0, 3.9)])


def mesh(shape: shapely.Polygon, noise: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """A triangulation whose triangles share no vertices, as exporters write them."""
    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(shape))
    points = np.concatenate([shapely.get_coordinates(piece)[:3] for piece in pieces])
    jitter = np.random.default_rng(4).uniform(-noise, noise, points.shape)
    return points + jitter, np.arange(len(points)).reshape(-1, 3)


def test_a_floor_of_loose_triangles() -> None:
    outline, notes = of_triangles(*mesh(shapely.Polygon(L_SHAPE)))
    same_ring(outline, L_SHAPE)
    assert not notes


@pytest.mark.parametrize("turn", [0.0, 0.37])
def test_vertices_of_single_precision(turn: float) -> None:
    """Cracks and overlaps of a micrometre leave neither slivers nor corners of their own."""
    c, s = np.cos(turn), np.sin(turn)
    turned = L_SHAPE @ np.array([[c, s], [-s, c]])
    outline, notes = of_triangles(*mesh(shapely.Polygon(turned), 1e-6))
    assert outline is not None and len(outline) == 6 and not notes
    assert shapely.Polygon(outline).symmetric_difference(shapely.Polygon(turned)).area < 1e-4


def test_what_is_left_out_is_told() -> None:
    ring = shapely.Polygon(L_SHAPE, [[(0.5, 0.5), (1.0, 0.5), (1.0, 1.0), (0.5, 1.0)]])
    island = shapely.box(6, 0, 6.5, 0.5)
    (a, f), (b, g) = mesh(ring), mesh(island)
    outline, notes = of_triangles(np.concatenate((a, b)), np.concatenate((f, g + len(a))))
    same_ring(outline, L_SHAPE)
    assert "2 separate parts" in notes[0] and "0.25 m2" in notes[0] and "1 holes" in notes[1]


def test_nothing_with_an_area() -> None:
    assert of_triangles(np.zeros((3, 2)), np.array([[0, 1, 2]])) == (None, [])
    assert of_triangles(np.zeros((0, 2)), np.zeros((0, 3), dtype=int)) == (None, [])


def test_a_ring_of_edges_in_any_order() -> None:
    edges = np.hstack((L_SHAPE, np.roll(L_SHAPE, -1, axis=0)))
    edges[2] = edges[2][[2, 3, 0, 1]]
    same_ring(ring_of_edges(edges[[3, 0, 5, 2, 4, 1]], 0.01), L_SHAPE)
    assert ring_of_edges(edges[:5], 0.01) is None and ring_of_edges(edges[:2], 0.01) is None


def test_walls_enclose_what_they_enclose() -> None:
    walls = np.hstack((L_SHAPE, np.roll(L_SHAPE, -1, axis=0)))
    inner = np.array([[0.0, 2.0, 2.6, 2.0]])  # between the middles of two walls
    large, small = of_walls(np.concatenate((walls, inner)), 0.05)
    same_ring(small, [(0, 2.0), (2.6, 2.0), (2.6, 3.9), (0, 3.9)])
    same_ring(large, [(0, 0), (4.2, 0), (4.2, 1.7), (2.6, 1.7), (2.6, 2.0), (0, 2.0)])
    assert of_walls(walls[:4], 0.05) == [] and of_walls(np.zeros((0, 4)), 0.05) == []


def test_points_and_openings() -> None:
    assert holds(L_SHAPE, (2.0, 3.0)) and holds(L_SHAPE, (4.2, 0.3)) and not holds(L_SHAPE, (3.0, 3.0))
    assert near_wall(L_SHAPE, (1.0, -0.1), (1.9, -0.1), 0.2)
    assert not near_wall(L_SHAPE, (1.0, -0.3), (1.9, -0.3), 0.2)
    assert not near_wall(L_SHAPE, (1.0, -0.1), (1.0, 0.8), 0.2)  # across the wall
    assert not near_wall(L_SHAPE, (4.4, 0.0), (5.3, 0.0), 0.2)  # on its line, past its end
    a, b, thick = middle_line(np.array([(1.0, 2.0), (1.9, 2.0), (1.9, 2.2), (1.0, 2.2)]))
    np.testing.assert_allclose(sorted([a.tolist(), b.tolist()]), [(1.0, 2.1), (1.9, 2.1)], atol=1e-9)
    assert thick == pytest.approx(0.2)
    a, b, thick = middle_line(np.array([(1.0, 2.0), (1.5, 2.0), (1.9, 2.0)]))
    assert sorted([a.tolist(), b.tolist()]) == [[1.0, 2.0], [1.9, 2.0]] and thick == 0.0
