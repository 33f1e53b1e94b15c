"""Shortest ways: against all lines of sight with networkx, against a fine grid, and what they are by themselves."""

import networkx
import numpy as np
import pytest
import shapely

from sceneweaver.home import Home
from sceneweaver.navigation import Roadmap, shortest_path
from sceneweaver.scene import InputError
from tests.navigation.full import full_flat, largest, on_grid, places, seen_from_everywhere
from tests.sizes import often
from tests.verify.home.homes import bars, flat, house, mirrored, turned


def test_lengths_are_those_of_all_lines_of_sight_by_networkx():
    roadmap = Roadmap(full_flat())
    points = places(roadmap, 6, 1)
    graph = seen_from_everywhere(largest(roadmap), points)
    for k in range(6):
        known = networkx.single_source_dijkstra_path_length(graph, k)
        away = roadmap.to([points[k]])
        for j in range(6):
            assert away.distance(points[j]) == pytest.approx(known[j], abs=1e-5)


@pytest.mark.parametrize("seed", often(range(3), [0]))
def test_lengths_are_those_of_a_fine_grid(seed):
    """A grid of 1 cm with steps to up to 5 cells away: shorter by cells and jumps, longer by turns, to 1 %."""
    roadmap = Roadmap(full_flat(seed))
    start, goal = places(roadmap, 2, seed + 20)
    path = roadmap.path(start, goal)
    assert path is not None
    grid = on_grid(largest(roadmap), start, goal, 0.01)
    assert path.length == pytest.approx(grid, rel=0.01, abs=0.02)


def test_a_path_stays_on_the_floor_and_is_as_long_as_it_says():
    roadmap = Roadmap(full_flat())
    floor = largest(roadmap).buffer(1e-5)
    points = places(roadmap, 20, 3)
    for a, b in zip(points[::2], points[1::2], strict=True):
        path = roadmap.path(a, b)
        assert path is not None
        assert path.length == pytest.approx(np.linalg.norm(np.diff(path.points, axis=0), axis=1).sum(), abs=1e-9)
        assert floor.covers(shapely.LineString(path.points[:, :2]))
        np.testing.assert_allclose(path.points[[0, -1], :2], [a, b])
        back = roadmap.path(b, a)
        assert back is not None and back.length == pytest.approx(path.length, abs=1e-9)


def test_lengths_do_not_depend_on_how_the_home_lies():
    home = full_flat()
    a, b = places(Roadmap(home), 2, 7)
    known = Roadmap(home).to([b]).distance(a)
    seen = {turned: lambda p: (-p[1], p[0]), mirrored: lambda p: (-p[0], p[1])}
    for how, place in seen.items():
        assert Roadmap(how(home)).to([place(b)]).distance(place(a)) == pytest.approx(known, abs=1e-5)


def test_distance_is_to_the_nearest_of_some_goals():
    roadmap = Roadmap(full_flat())
    points = places(roadmap, 5, 11)
    alone = [roadmap.to([goal]).distance(points[0]) for goal in points[1:]]
    assert roadmap.to(points[1:]).distance(points[0]) == pytest.approx(min(alone), abs=1e-9)
    path = roadmap.to(points[1:]).path(points[0])
    assert path is not None
    np.testing.assert_allclose(path.points[-1, :2], points[1:][int(np.argmin(alone))])


def test_there_is_no_way_where_the_base_does_not_pass():
    assert shortest_path(flat(hall=bars(0.49)), (5.4, 1.0), (5.4, 4.0)) is None
    assert shortest_path(flat(hall=bars(0.51)), (5.4, 1.0), (5.4, 4.0)) is not None
    assert Roadmap(flat(hall=bars(0.49))).to([(5.4, 4.0)]).distance((5.4, 1.0)) == np.inf


def test_the_way_over_a_stair_is_as_long_as_its_slope():
    home = house()
    path = shortest_path(home, (0.5, 0.6, 0.0), (0.5, 5.4, 2.7))
    assert path is not None
    assert path.length == pytest.approx(0.6 + np.hypot(3.5, 2.7) + 0.7, abs=1e-3)
    assert set(path.points[:, 2].tolist()) == {0.0, 2.7}
    assert Roadmap(home, stairs=False).path((0.5, 0.6, 0.0), (0.5, 5.4, 2.7)) is None


@pytest.mark.parametrize("bad", [(0.0,), (np.nan, 1.0), "here", (5.4, 1.0, 0.0, 1.0)])
def test_a_point_that_is_none_is_refused(bad):
    with pytest.raises((InputError, ValueError)):
        shortest_path(Home.example("flat"), bad, (5.4, 1.0))


def test_a_point_off_the_floor_is_refused_with_its_distance():
    with pytest.raises(InputError, match=r"a base of 0.25 m cannot stand there, the nearest is 0.2\d m away"):
        shortest_path(Home.example("flat"), (4.6, 1.0), (5.4, 1.0))
