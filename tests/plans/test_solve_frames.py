"""Frames: bays and stairwells tile the floor, inward corners are cut both ways; stairs by the rules."""

from __future__ import annotations

import pytest
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from sceneweaver.plans import Envelope
from sceneweaver.plans.solve_frames import LEAST_BAY, MAX_FRAMES, frames_of, millimetres
from sceneweaver.plans.solve_stairs import Stairwell

WALL = 100
CORNERS = ("south-west", "south-east", "north-east", "north-west")


def stairwell() -> Stairwell:
    return Stairwell.between(2900, 196, 254, 910, 910)


def test_a_rectangle_is_one_bay():
    (frame,) = frames_of(Envelope.rectangle(10, 8), None)
    assert frame.bays == (((300, 300, 9700, 7700),),) and frame.fixed == ()


@pytest.mark.parametrize("corner", CORNERS)
def test_an_l_is_cut_both_ways(corner):
    envelope = Envelope.l_shape(12, 9, cut=(4, 3), corner=corner)
    frames = frames_of(envelope, None)
    floor = Polygon(millimetres(envelope.inner))
    assert len(frames) == 2
    for frame in frames:
        a, b = (box(*bay) for bay in frame.bays[0])
        assert floor.covers(a) and floor.covers(b) and a.distance(b) == WALL
        walls = floor.difference(unary_union([a, b]))
        assert walls.area == WALL * min(walls.bounds[2] - walls.bounds[0], walls.bounds[3] - walls.bounds[1]) or (
            walls.area == WALL * max(walls.bounds[2] - walls.bounds[0], walls.bounds[3] - walls.bounds[1])
        )


def test_a_u_is_cut_into_three():
    outline = ((0, 0), (14, 0), (14, 9), (10, 9), (10, 5), (4, 5), (4, 9), (0, 9))
    envelope = Envelope(outline=outline, open_walls=tuple(range(8)))
    frames = frames_of(envelope, None)
    floor = Polygon(millimetres(envelope.inner))
    assert len(frames) >= 3
    for frame in frames:
        bays = [box(*bay) for bay in frame.bays[0]]
        assert len(bays) == 3 and all(floor.covers(bay) for bay in bays)
        assert sum(bay.area for bay in bays) == unary_union(bays).area >= 0.95 * floor.area


@pytest.mark.parametrize("storeys", [2, 3])
def test_stairs_stand_in_one_place_and_bays_around(storeys):
    envelope = Envelope.rectangle(9.5, 8.5, storeys=storeys)
    floor = Polygon(millimetres(envelope.inner))
    frames = frames_of(envelope, stairwell())
    assert 10 <= len(frames) <= MAX_FRAMES
    assert len(set(frames)) == len(frames)
    for frame in frames:
        well = unary_union([box(*part.rect) for part in frame.fixed])
        assert len(frame.bays) == storeys and len(frame.fixed) == 2
        for bays in frame.bays:
            shapes = [*(box(*bay) for bay in bays), well]
            assert all(floor.covers(shape) for shape in shapes)
            assert all(a.distance(b) >= WALL for k, a in enumerate(shapes) for b in shapes[:k])
            grown = unary_union([s.buffer(WALL / 2, join_style="mitre") for s in shapes])
            assert floor.difference(grown.buffer(WALL / 2, join_style="mitre")).area == 0  # nothing is left over
            assert min(min(b[2] - b[0], b[3] - b[1]) for b in bays) >= LEAST_BAY


def test_stairs_keep_their_bounds():
    well = stairwell()
    assert well.risers % 2 == 0 and 2900 / well.risers <= 196 and well.going >= 254 and well.flight >= 910
    floor, flights = (rect for rect, _ in well.parts((0, 0, well.width, well.length), 1, 1))
    assert floor[3] == flights[1] == well.floor >= 910
    assert flights[3] - flights[1] == (well.risers // 2 - 1) * well.going + well.flight
    assert 2 * well.flight <= well.width


def test_no_place_for_stairs():
    assert frames_of(Envelope.rectangle(3, 3, storeys=2), stairwell()) == []
