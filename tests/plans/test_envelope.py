"""Envelopes: faces, areas, walls with windows, and those that are chosen for a programme."""

from __future__ import annotations

import math
from typing import Any

import pytest
import shapely

from sceneweaver.io import InputError
from sceneweaver.plans import Envelope, Programme, envelope_for, programme_names

CORNERS = ("south-west", "south-east", "north-east", "north-west")


@pytest.mark.parametrize("corner", CORNERS)
def test_inner_faces_are_those_of_the_outline_less_the_walls(corner: Any):
    envelope = Envelope.l_shape(9.0, 8.0, cut=(3.0, 2.5), corner=corner)
    assert envelope.area == 64.5
    expected = shapely.Polygon(envelope.outline).buffer(-0.3, join_style="mitre")
    assert shapely.Polygon(envelope.inner).symmetric_difference(expected).area < 1e-9
    for a, b in zip(envelope.outline, envelope.inner, strict=True):
        assert math.isclose(math.dist(a, b), 0.3 * math.sqrt(2), abs_tol=1e-6)


@pytest.mark.parametrize("name", programme_names())
def test_chosen_envelopes(name: str):
    programme = Programme.example(name)
    chosen = [envelope_for(programme, seed) for seed in range(8)]
    assert chosen == [envelope_for(programme, seed) for seed in range(8)]
    assert len(set(chosen)) > 4
    for envelope in chosen:
        assert envelope.storeys == programme.storeys
        if programme.use in ("flat", "office"):
            assert envelope.entrance_wall in envelope.closed_walls and len(envelope.closed_walls) <= 2
        else:
            assert envelope.entrance_wall is None and not envelope.closed_walls


def test_windows_have_walls_to_lie_in():
    """In every envelope the open walls are as long as the rooms that need one are wide."""
    for name in programme_names():
        programme = Programme.example(name).with_storeys()
        for seed in range(4):
            envelope = envelope_for(programme, seed)
            ends = (*envelope.outline[1:], envelope.outline[0])
            open_length = sum(math.dist(envelope.outline[w], ends[w]) - 0.6 for w in envelope.open_walls)
            for storey in range(programme.storeys):
                needy = [room for room in programme.rooms if room.storey == storey and room.needs_daylight]
                assert open_length >= sum((room.side or 2.4) + 0.1 for room in needy), (name, seed)


@pytest.mark.parametrize(
    ("make", "line"),
    [
        (lambda: Envelope.rectangle(-1, 3), "width is -1; give metres above 0"),
        (lambda: Envelope.rectangle(float("nan"), 3), "width is NaN"),
        (lambda: Envelope.rectangle(0.5, 3), "nothing is left between the outer walls"),
        (lambda: Envelope.rectangle(9, 8, entrance_wall=4), "entrance_wall is 4; the outline has walls 0 to 3"),
        (lambda: Envelope.l_shape(5, 5, cut=(6, 1)), "cut is a list; it must be smaller"),
        (lambda: Envelope.l_shape(5, 5, cut=3), "cut is 3; give width and depth"),  # type: ignore[arg-type]
        (lambda: Envelope.l_shape(5, 5, cut=(1, 1), corner="top"), 'corner is "top"'),  # type: ignore[arg-type]
        (lambda: Envelope(outline=((0, 0), (5, 0), (4, 5)), open_walls=()), "wall 1 is oblique"),
        (lambda: Envelope(outline=((0, 0), (5.0004, 0), (5.0004, 4), (0, 4)), open_walls=()), "give whole millimetres"),
        (lambda: Envelope(outline=((0, 0), (5, 0), (5, 4), (0, 4)), open_walls=(7,)), "open_walls[0] is 7"),
        (lambda: envelope_for(Programme.example("flat-studio"), 1.5), "seed is 1.5"),  # type: ignore[arg-type]
    ],
)
def test_bad_envelopes(make: Any, line: str):
    with pytest.raises(InputError) as said:
        make()
    assert line in str(said.value) and "\n" not in str(said.value)
