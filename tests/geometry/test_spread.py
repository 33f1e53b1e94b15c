"""Even places on a floor."""

import math

import pytest
import shapely

from sceneweaver.geometry.spread import even_count, even_places

OBLONG = [(0, 0), (8, 0), (8, 6), (0, 6)]
ELL = [(0, 0), (6, 0), (6, 3), (3.3, 3), (3.3, 5), (0, 5)]


def test_a_grid_over_an_oblong_floor():
    assert even_places(OBLONG, 1) == ((4.0, 3.0),)
    assert even_places(OBLONG, 2) == ((2.0, 3.0), (6.0, 3.0))
    assert even_places(OBLONG, 4) == ((2.0, 1.5), (6.0, 1.5), (2.0, 4.5), (6.0, 4.5))
    assert [p[0] for p in even_places(OBLONG, 3)] == pytest.approx([4 / 3, 4, 20 / 3])


@pytest.mark.parametrize("count", range(1, 13))
@pytest.mark.parametrize("outline", [OBLONG, ELL])
def test_as_many_places_as_asked_and_all_inside(outline, count):
    places = even_places(outline, count)
    floor = shapely.Polygon(outline)
    assert len(set(places)) == count and all(floor.contains(shapely.Point(p)) for p in places)


def test_a_turned_room_has_turned_places():
    c, s = math.cos(0.4), math.sin(0.4)
    turned = [(x * c - y * s + 1.0, x * s + y * c - 2.0) for x, y in OBLONG]
    expected = [(x * c - y * s + 1.0, x * s + y * c - 2.0) for x, y in even_places(OBLONG, 6)]
    for place, wanted in zip(even_places(turned, 6), expected, strict=True):
        assert place == pytest.approx(wanted)


def test_counts_that_make_full_grids():
    assert [even_count(OBLONG, n) for n in (1, 2, 5, 7, 11)] == [1, 2, 6, 6, 12]
