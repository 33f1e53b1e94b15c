"""Rows, runs, even places and the middle of the room, on both sides of each threshold."""

from __future__ import annotations

import math

import pytest

from tests.verify.build import beside, box, judge, only, relation

YAWS = (0.0, 30.0, 205.0)


def holds(objects, rel, **room) -> bool:
    tally = judge(objects, [rel], **room).relations.hard
    assert tally.total == 1
    return tally.satisfied == 1


def _table(yaw: float = 0.0) -> dict:
    parts = [{"polygon": [[-0.4, -0.9], [0.4, -0.9], [0.4, 0.9], [-0.4, 0.9]], "z": [0.7, 0.74]}]
    return box("t", (0.8, 1.8, 0.74), 4.0, 4.0, yaw, parts=parts)


def _seat(ahead: float, left: float, turned: float, yaw: float) -> dict:
    parts = [{"polygon": [[-0.2, -0.2], [0.2, -0.2], [0.2, 0.2], [-0.2, 0.2]], "z": [0.0, 0.45]}]
    return box("s", (0.5, 0.5, 0.6), *beside(_table(yaw), ahead, left), yaw + turned, parts=parts)


@pytest.mark.parametrize("yaw", YAWS)
@pytest.mark.parametrize(
    ("params", "ahead", "left", "turned", "expected"),
    [
        ({"side": "front", "k": 0, "n": 3}, 0.65, -0.6, 180.0, True),  # parts of 0.6 m, from the right
        ({"side": "front", "k": 1, "n": 3}, 0.65, 0.0, 180.0, True),
        ({"side": "front", "k": 1, "n": 3}, 0.65, 0.6, 180.0, False),
        ({"side": "back", "k": 0, "n": 3}, -0.65, 0.6, 0.0, True),
        ({"side": "left", "k": 0, "n": 1}, 0.0, 1.15, -90.0, True),
        ({"side": "left", "k": 1, "n": 2}, -0.2, 1.15, -90.0, True),
        ({"side": "right"}, 0.0, -1.15, 90.0, True),
        ({"side": "right"}, 0.0, 1.15, -90.0, False),
        ({"side": "front", "k": 0, "n": 3}, 0.65, -0.6508, 180.0, True),  # 5 cm off and the tolerance
        ({"side": "front", "k": 0, "n": 3}, 0.65, -0.6515, 180.0, False),
        ({"side": "front", "k": 0, "n": 3, "offset": 0.2}, 0.65, -0.45, 180.0, True),
        ({"side": "front"}, 0.7008, 0.0, 180.0, True),  # a gap of 5 cm
        ({"side": "front"}, 0.7015, 0.0, 180.0, False),
        ({"side": "front"}, 0.2495, 0.0, 180.0, True),  # 0.8 of its depth into the table
        ({"side": "front"}, 0.2485, 0.0, 180.0, False),
        ({"side": "front", "gap": [0.2, 0.3]}, 0.9, 0.0, 180.0, True),
        ({"side": "front", "offset": 0.3}, 0.65, 0.0, 194.9, True),
        ({"side": "front", "offset": 0.3}, 0.65, 0.0, 195.1, False),
        ({"side": "front", "offset": 0.3, "degrees": 30}, 0.65, 0.0, 205.0, True),
    ],
)
def test_seated_at(params, ahead, left, turned, expected, yaw):
    objects = [_table(yaw), _seat(ahead, left, turned, yaw)]
    assert holds(objects, relation("seated_at", "s", "t", **params)) is expected


@pytest.mark.parametrize("yaw", YAWS)
@pytest.mark.parametrize(
    ("params", "ahead", "left", "turned", "expected"),
    [
        ({"gap": [0.4, 0.9]}, 1.2, 0.0, 180.0, True),  # the target is 0.6 m deep, the subject 0.6 m: a gap of 0.6 m
        ({"gap": [0.4, 0.9]}, 0.9, 0.0, 180.0, False),
        ({"gap": [0.4, 0.9]}, 1.2, 0.0, 0.0, False),  # its back to the target
        ({"gap": [0.4, 0.9], "side": "back"}, 1.2, 0.0, 180.0, False),
        ({"gap": [0.4, 0.9], "side": "ends"}, 1.2, 0.0, 180.0, False),
        ({"gap": [0.4, 0.9], "side": "ends"}, 0.0, 1.4, -90.0, True),
        ({"gap": [0.4, 0.9]}, 1.2, 0.1508, 180.0, True),
        ({"gap": [0.4, 0.9]}, 1.2, 0.1515, 180.0, False),
        ({"gap": [0.4, 0.9], "k": 1, "n": 2}, 1.2, 0.25, 180.0, True),
        ({"gap": [0.4, 0.9], "k": 0, "n": 2}, 1.2, 0.25, 180.0, False),
    ],
)
def test_across_from(params, ahead, left, turned, expected, yaw):
    target = box("t", (0.6, 1.0, 0.7), 4.0, 4.0, yaw)
    subject = box("s", (0.6, 0.6, 0.7), *beside(target, ahead, left), yaw + turned)
    assert holds([target, subject], relation("across_from", "s", "t", **params)) is expected


@pytest.mark.parametrize(
    ("k", "n", "x", "y", "expected"),
    [
        (0, 1, 4.0, 3.0, True),
        (1, 2, 6.0, 3.0, True),
        (0, 2, 6.0, 3.0, False),
        (5, 6, 6.67, 4.5, True),
        (5, 6, 6.9, 4.5, True),
        (5, 6, 7.1, 4.5, False),
        (6, 6, 6.67, 4.5, False),
    ],
)
def test_on_grid(k, n, x, y, expected):
    outline = [[0, 0], [8, 0], [8, 6], [0, 6]]
    assert (
        holds([box("s", (0.3, 0.3, 0.3), x, y)], relation("on_grid", "s", None, k=k, n=n), outline=outline) is expected
    )


@pytest.mark.parametrize("yaw", YAWS)
@pytest.mark.parametrize(
    ("params", "ahead", "left", "turned", "expected"),
    [
        ({}, 0.0, 0.9, 0.0, True),  # the target is 1 m wide, the subject 0.6 m: a gap of 0.1 m
        ({}, 0.0, -0.9, 0.0, False),
        ({"side": "right"}, 0.0, -0.9, 0.0, True),
        ({}, 0.0, 0.7992, 0.0, True),
        ({}, 0.0, 0.7985, 0.0, False),
        ({}, 0.0, 1.4008, 0.0, True),
        ({}, 0.0, 1.4015, 0.0, False),
        ({"gap": [0.5, 1.0]}, 0.0, 1.5, 0.0, True),
        ({}, 0.0508, 0.9, 0.0, True),  # the backs out of line
        ({}, 0.0515, 0.9, 0.0, False),
        ({"offset": 0.2}, -0.15, 0.9, 0.0, True),
        ({"offset": 0.2}, 0.0, 0.9, 2.9, True),
        ({"offset": 0.2}, 0.0, 0.9, 3.1, False),
        ({"offset": 0.2, "degrees": 10}, 0.0, 0.9, 8.0, True),
        ({}, 0.0, 0.9, 180.0, False),
        ({"side": "front"}, 0.9, 0.0, 0.0, True),
        ({"side": "back"}, -0.9, 0.0, 0.0, True),
        ({"side": "back"}, -0.9, 0.0508, 0.0, True),  # the middles out of line
        ({"side": "back"}, -0.9, 0.0515, 0.0, False),
    ],
)
def test_next_to(params, ahead, left, turned, expected, yaw):
    target = box("t", (0.6, 1.0, 0.7), 4.0, 4.0, yaw)
    subject = box("s", (0.6, 0.6, 0.7), *beside(target, ahead, left), yaw + turned)
    assert holds([target, subject], relation("next_to", "s", "t", **params)) is expected


def test_neighbours_of_other_depths_have_their_backs_in_line():
    target = box("t", (0.6, 1.0, 0.7), 4.0, 4.0)
    level, middle = (box("s", (0.4, 0.6, 0.7), *beside(target, ahead, 0.9)) for ahead in (-0.1, 0.0))
    assert holds([target, level], relation("next_to", "s", "t"))
    assert not holds([target, middle], relation("next_to", "s", "t"))


@pytest.mark.parametrize("yaw", YAWS)
@pytest.mark.parametrize(
    ("params", "ahead", "left", "turned", "expected"),
    [
        ({}, 0.0, -0.81, 0.0, True),  # straight on
        ({}, 0.0, 0.81, 0.0, False),
        ({"side": "left"}, 0.0, 0.81, 0.0, True),
        ({}, 0.0, -0.8308, 0.0, True),
        ({}, 0.0, -0.8315, 0.0, False),
        ({"gap": [0.1, 0.2]}, 0.0, -0.95, 0.0, True),
        # around the corner: 0.5 deep and 0.6 wide, before the target, back at its right
        ({}, 0.61, -0.25, 90.0, True),
        ({}, 0.61, -0.25, -90.0, False),
        ({}, 0.61, 0.25, 90.0, False),
        ({"side": "left"}, 0.61, 0.25, -90.0, True),
        ({}, 0.6308, -0.25, 90.0, True),
        ({}, 0.6315, -0.25, 90.0, False),
        ({}, 0.61, -0.3008, 90.0, True),
        ({}, 0.61, -0.3015, 90.0, False),
        ({"offset": 0.3}, 0.61, -0.45, 90.0, True),
        ({"gap": [0.1, 0.5]}, 0.9, -0.25, 90.0, True),
        ({"offset": 0.3, "gap": [0.0, 0.1]}, 0.63, -0.25, 92.9, True),
        ({"offset": 0.3, "gap": [0.0, 0.1]}, 0.63, -0.25, 93.1, False),
        ({"offset": 0.3, "gap": [0.0, 0.1], "degrees": 10}, 0.63, -0.25, 98.0, True),
    ],
)
def test_run_on(params, ahead, left, turned, expected, yaw):
    target = box("t", (0.6, 1.0, 0.7), 4.0, 4.0, yaw)
    straight = turned == 0.0
    ahead -= 0.05 if straight else 0.0  # 0.5 m deep beside 0.6 m
    subject = box("s", (0.5, 0.6, 0.7), *beside(target, ahead, left), yaw + turned)
    assert holds([target, subject], relation("run_on", "s", "t", **params)) is expected


@pytest.mark.parametrize(
    ("x", "y", "offset", "expected"),
    [
        (4.0, 4.0, 0.0, True),
        (4.3, 3.7, 0.3, True),
        (4.3008, 4.0, 0.3, True),
        (4.3015, 4.0, 0.3, False),
        (4.0, 3.6985, 0.3, False),
        (4.4, 4.4, None, True),
        (4.6, 4.0, None, False),
    ],
)
def test_in_middle(x, y, offset, expected):
    params = {} if offset is None else {"offset": offset}
    outline = [[0, 0], [8, 0], [8, 8], [0, 8]]
    thing = box("s", (0.3, 0.3, 0.3), x, y, 77.0)
    assert holds([thing], relation("in_middle", "s", None, **params), outline=outline) is expected


def test_the_middle_of_a_room_is_inside_of_it():
    """A U around a yard: its centroid is outside, so any place that shapely says is inside will do."""
    import shapely

    outline = [[0, 0], [8, 0], [8, 6], [7, 6], [7, 1], [1, 1], [1, 6], [0, 6]]
    middle = shapely.point_on_surface(shapely.Polygon(outline))
    near, far = (box("s", (0.1, 0.1, 0.3), middle.x + off, middle.y) for off in (0.0, 0.2))
    rel = relation("in_middle", "s", None, offset=0.1)
    assert holds([near], rel, outline=outline) and not holds([far], rel, outline=outline)


def test_what_is_said_when_they_fail():
    target = box("t", (0.6, 1.0, 0.7), 4.0, 4.0)
    subject = box("s", (0.6, 0.6, 0.7), *beside(target, 0.1, 1.6), math.degrees(0.0))
    text = only(judge([target, subject], [relation("next_to", "s", "t")]), "relation").detail
    assert text == "s next_to t: gap 0.8 m, allowed 0 to 0.6 m; out of line 0.1 m, at most 0.05 m"
