"""Doors, windows and niches that a request describes, and sizes of rooms as people write them."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "part", "told"),
    [
        ("a study with a window 1.5 m wide in the long wall", "window", {"wall": "long", "width": 1.5}),
        ("study. Door in the middle of a short side.", "door", {"wall": "short", "at": "middle"}),
        ("a workshop with wide doors in the left wall", "door", {"wall": "left", "features": ("wide",)}),
        ("a kitchen, door 85 cm wide close to the right corner", "door", {"width": 0.85, "at": "right"}),
        ("lounge with floor-to-ceiling windows across the far wall", "window", {"wall": "far", "at": "along"}),
        ("a bedroom with a sliding door to the terrace", "door", {"features": ("sliding", "to the terrace")}),
        ("an office, two tall windows on the 12 ft wall", "window", {"count": 2, "wall_length": 3.6576}),
        ("the door should be wide, 1.1 m", "door", {"width": 1.1}),
        ("sunroom, glass on two sides", "window", {"count": 2, "at": "along"}),
        ("a study with a niche in the wall opposite the door", "niche", {"opposite": "door"}),
    ],
)
def test_what_is_said_of_an_opening(text: str, part: str, told: dict[str, object]) -> None:
    found = [one for one in read_by_rules(text).openings if one.part == part]
    assert found, read_by_rules(text)
    assert {name: getattr(found[0], name) for name in told} == told
    span = found[0].span
    assert span is not None and text[span.start : span.end].lower()[:4] in text.lower()


@pytest.mark.parametrize(
    "text",
    [
        "a desk by the window and a chair near the door",
        "a wide table and a door mat",
        "a window seat with two cushions",
        "a room with two windows and a door",
        "a bench under the long window",
    ],
)
def test_what_stands_at_an_opening_says_nothing_of_it(text: str) -> None:
    assert read_by_rules(text).openings == ()


def test_an_opening_refers_to_the_one_before() -> None:
    graph = read_by_rules("a hall with a door in a short wall, a window opposite")
    assert [one.opposite for one in graph.openings] == ["", "opening-0"]


def test_who_names_a_door_to_another_room_comes_in_by_one_more() -> None:
    assert read_by_rules("a bedroom with a door to the bathroom").doors == 2
    assert read_by_rules("a bedroom, the front door on the left, a door to the bathroom").doors == 2


@pytest.mark.parametrize(
    ("text", "size", "height"),
    [
        ("pantry, 1 meter 80 on 3 meters", (3.0, 1.8), None),
        ("a kitchen of 1 meter 90 on 3 meters", (3.0, 1.9), None),
        ("a sunroom twelve feet by fourteen", (4.267, 3.658), None),
        ("a cellar with a ceiling of at most 2.1 m", None, 2.1),
        ("a den, low ceiling, two metres at most", None, 2.0),
        ("the room is 5 m by 4 m and 3 m high", (5.0, 4.0), 3.0),
        ("a hall with walls 4 m high", None, 4.0),
    ],
)
def test_sizes_as_people_write_them(text: str, size: tuple[float, float] | None, height: float | None) -> None:
    graph = read_by_rules(text)
    if size is not None:
        assert graph.size == pytest.approx(size, abs=1e-3)
    assert graph.height == height


def test_a_length_on_a_length_is_no_room_where_it_is_short() -> None:
    assert read_by_rules("a 1.2 m table on a 2 m rug").size is None


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("an archive, the window is on the far short wall", {"wall": "far", "run": "short"}),
        ("a wet room whose door is on the short wall, opening outwards", {"wall": "short", "features": ("outward",)}),
        ("a bistro with a side door", {"wall": "side", "features": ("side",)}),
        ("a den with a little hatch 60 cm high", {"height": 0.6, "features": ("little",)}),
        ("a booth with a window up high on the end wall", {"wall": "short", "features": ("high up",)}),
        ("a clinic, door with a lock on the left wall", {"wall": "left", "features": ("lockable",)}),
        ("a pantry with a door in the corner of the long wall", {"wall": "long", "at": "corner"}),
        ("a bathroom, window 40 x 60 cm in the left wall", {"wall": "left", "width": 0.4, "height": 0.6}),
        ("a bakery with a door leading to the flour loft", {"features": ("to the flour",)}),
    ],
)
def test_more_that_is_said_of_an_opening(text: str, told: dict[str, object]) -> None:
    (one,) = read_by_rules(text).openings
    assert {name: getattr(one, name) for name in told} == told


def test_a_statement_goes_on_with_one_more_of_the_same() -> None:
    graph = read_by_rules("a loft with three windows on a long wall and two on a short wall")
    assert [(one.count, one.wall) for one in graph.openings] == [(3, "long"), (2, "short")]
    graph = read_by_rules("a hall with two doors, one on the left wall, the other opposite")
    assert [(one.count, one.wall, one.opposite) for one in graph.openings] == [
        (1, "left", ""),
        (1, "any", "opening-0"),
    ]


def test_a_comma_ends_the_place_of_the_opening_before() -> None:
    graph = read_by_rules("a foyer, emergency door at the back, glass double doors at the front")
    told = [(one.wall, one.features) for one in graph.openings]
    assert told == [("far", ("emergency",)), ("near", ("glass", "double"))]


def test_two_openings_look_at_each_other() -> None:
    graph = read_by_rules("a corridor with two doors opposite each other")
    assert [(one.part, one.opposite) for one in graph.openings] == [("door", ""), ("door", "opening-0")]


def test_no_window_says_nothing_of_the_door_after_it() -> None:
    graph = read_by_rules("a darkroom, no window, door on the short wall")
    assert (graph.windows, graph.doors) == (0, 1)


@pytest.mark.parametrize(
    ("text", "doors", "told"),
    [
        ("a galley with a door at both ends", 2, [{"wall": "short"}, {"opposite": "opening-0"}]),
        ("a hall with doors on both sides", 2, [{"wall": "long"}, {"opposite": "opening-0"}]),
        ("a lounge, three doors, no two on the same wall", 3, [{"features": ("apart",)}] * 3),
        ("a bank, in by the left door, out by the right", 2, [{}, {"opposite": "opening-0"}]),
        ("a bank; enter at the left, leave at the right", 2, [{}, {"opposite": "opening-0"}]),
        ("a pantry with a curtain instead of a door", 1, [{"features": ("curtain",)}]),
        ("a wine cellar, iron gate not a door", 1, [{"features": ("iron gate",)}]),
        ("a bathroom. Door 90, must not open inwards", 1, [{"width": 0.9, "features": ("outward",)}]),
        ("a restaurant, swing doors to the kitchen", 2, [{"features": ("swing", "double", "to the kitchen")}]),
        ("a sunroom, double doors at one end and a single one at the other", 2, [{"wall": "far"}, {"features": ()}]),
    ],
)
def test_where_doors_are_and_what_closes_them(text: str, doors: int, told: list[dict[str, object]]) -> None:
    graph = read_by_rules(text)
    assert graph.doors == doors
    assert len(graph.openings) == len(told)
    for one, said in zip(graph.openings, told, strict=True):
        assert {name: getattr(one, name) for name in said} == said


def test_daylight_and_windows_of_cellars() -> None:
    assert read_by_rules("a darkroom, no daylight at all").windows == 0
    assert read_by_rules("a bedroom, no daylight lamps").windows is None
    (one,) = read_by_rules("a laundry room with a basement window").openings
    assert one.features == ("small", "high up")


@pytest.mark.parametrize(
    ("text", "doors"),
    [
        ("a kitchen without a back door", None),
        ("a kitchen with no door to the garden", None),
        ("a gym with no mirrors, doors painted red", None),
        ("a shrine room with no door", 0),
    ],
)
def test_a_room_has_no_door_only_where_that_is_said(text: str, doors: int | None) -> None:
    graph = read_by_rules(text)
    assert (graph.doors, graph.openings) == (doors, ())


def test_an_entrance_in_a_wall_is_a_door() -> None:
    (one,) = read_by_rules("a tailor shop, entrance on the short wall").openings
    assert (one.part, one.wall) == ("door", "short")
    assert read_by_rules("a hallway, a console opposite the entrance").openings == ()
