"""Treads of stairs: equal goings, no gaps on the way up, all within the footprint."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sceneweaver.home import Stair
from sceneweaver.home.treads import treads
from sceneweaver.scene import InputError


def stair(shape: str, outline: tuple, up: tuple[float, float], risers: int = 16) -> Stair:
    return Stair.model_validate(
        {
            "id": "s",
            "lower": "a",
            "upper": "b",
            "outline": outline,
            "up": up,
            "shape": shape,
            "width": 1.0,
            "risers": risers,
            "going": 0.25,
        }
    )


def turned(outline, quarter: int):
    """An outline turned by quarters about the origin, on the grid of millimetres."""
    c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarter]
    return tuple((round(c * x - s * y, 3), round(s * x + c * y, 3)) for x, y in outline)


STRAIGHT = ((0, 0), (1, 0), (1, 4), (0, 4))
U = ((0, 0), (2.1, 0), (2.1, 3), (0, 3))
LEFT = ((2, 0), (3, 0), (3, 3), (0, 3), (0, 2), (2, 2))
RIGHT = ((0, 0), (1, 0), (1, 2), (3, 2), (3, 3), (0, 3))


@pytest.mark.parametrize("quarter", range(4))
@pytest.mark.parametrize(
    ("shape", "outline", "risers"),
    [("straight", STRAIGHT, 16), ("u", U, 17), ("u", U, 16), ("l", LEFT, 17), ("l", RIGHT, 17)],
)
def test_one_goes_up_step_by_step_within_the_footprint(shape, outline, risers, quarter) -> None:
    up = [(0, 1), (-1, 0), (0, -1), (1, 0)][quarter]
    found = treads(stair(shape, turned(outline, quarter), up, risers))
    assert [tread.number for tread in found] == list(range(1, risers))
    plans = [shapely.Polygon(tread.plan) for tread in found]
    footprint = shapely.Polygon(turned(outline, quarter)).buffer(3e-3)
    assert all(plan.exterior.is_ccw and footprint.contains(plan) for plan in plans)
    for before, after in zip(plans, plans[1:], strict=False):
        # A step is as wide as the flight where one goes over it; the two do not lie over each other.
        assert before.intersection(after).area < 1e-9
        assert before.intersection(after).length == pytest.approx(1.0, abs=1e-6)
    areas = np.array([plan.area for plan in plans])
    assert (np.isclose(areas, 0.25) | (areas > 0.9)).all()
    assert (areas > 0.9).sum() == (0 if shape == "straight" else 1)


def test_the_first_tread_lies_at_the_edge_against_the_way_up() -> None:
    assert treads(stair("straight", STRAIGHT, (0, 1)))[0].plan[:, 1].min() == 0.0
    assert treads(stair("straight", STRAIGHT, (0, -1)))[0].plan[:, 1].max() == 4.0


def test_a_stair_that_is_too_long_is_refused() -> None:
    with pytest.raises(InputError, match="do not fit its outline; give it a larger outline, a smaller going"):
        treads(stair("straight", STRAIGHT, (0, 1), risers=18))
    with pytest.raises(InputError, match="do not fit"):
        treads(stair("u", U, (0, 1), risers=22))
