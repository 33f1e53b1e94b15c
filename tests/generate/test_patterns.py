"""Patterns: where each thing stands to the first one."""

from __future__ import annotations

import math

import pytest

from sceneweaver.generate.patterns import Pitch, Spot, back_to_back, block, circle, extent, ring, u_shape

PITCH = Pitch(0.8, 0.6, 0.1, 0.9)


def in_room(spot: Spot) -> tuple[float, float, float]:
    """A spot as it is where the leader stands at the origin and looks along +x."""
    return round(spot.ahead, 6), round(spot.left, 6), round(spot.turn % 360.0, 6)


def test_a_block_has_even_rows_behind_its_leader():
    spots = block(2, 3, 6, PITCH)
    assert spots[0] == Spot(0.0, 0.0, 0.0)
    assert sorted({in_room(s)[0] for s in spots}) == [-1.7, 0.0]
    assert sorted({in_room(s)[1] for s in spots}) == [-0.7, 0.0, 0.7]


def test_rows_that_look_at_each_other_do_so_across_the_gap():
    spots = block(2, 2, 4, PITCH, opposed=True)
    first = [s for s in spots if s.turn == 0.0]
    second = [s for s in spots if s.turn == 180.0]
    assert len(first) == len(second) == 2
    assert {round(s.ahead - f.ahead - PITCH.depth, 6) for s in second for f in first} == {PITCH.between}


def test_an_aisle_parts_the_columns():
    lefts = sorted({in_room(s)[1] for s in block(3, 2, 6, PITCH, aisle=1.2)})
    assert lefts[1] - lefts[0] == pytest.approx(PITCH.width + 1.2)


@pytest.mark.parametrize("count", [3, 6, 9])
def test_a_circle_looks_at_its_middle(count: int):
    spots = circle(count, PITCH)
    x, y = (sum(s[k] for s in spots) / count for k in (0, 1))
    for s in spots:
        bearing = math.degrees(math.atan2(y - s.left, x - s.ahead))
        assert math.remainder(bearing - s.turn, 360.0) == pytest.approx(0.0, abs=1e-6)
    near = min(math.dist(a[:2], b[:2]) for i, a in enumerate(spots) for b in spots[:i])
    assert near > PITCH.width  # none in another


def test_a_u_is_open_ahead_and_looks_inward():
    spots = u_shape(9, PITCH)
    assert [s.turn for s in spots].count(0.0) == 3
    for s in spots:
        if s.turn:
            assert s.turn == (-90.0 if s.left > 0 else 90.0) and s.ahead > 0


def test_backs_touch_in_pairs():
    spots = back_to_back(4, PITCH)
    assert [s.turn for s in spots] == [0.0, 180.0, 0.0, 180.0]
    assert spots[0].ahead - spots[1].ahead == pytest.approx(PITCH.depth, abs=0.02)


@pytest.mark.parametrize("count", [2, 4, 7])
def test_a_ring_looks_at_its_table(count: int):
    for s in ring(count, (0.8, 1.2), 0.9, 0.3):
        bearing = math.degrees(math.atan2(-s.left, -s.ahead))
        assert abs(math.remainder(bearing - s.turn, 360.0)) < 1e-6


def test_the_box_about_a_pattern():
    assert extent([Spot(0.0, 0.0), Spot(0.0, 1.0, 90.0)], 0.8, 0.6) == pytest.approx((0.8, 1.7))
