"""Lengths and numbers as people say them, written out before they are read; limits on all things of a kind."""

from __future__ import annotations

import pytest

from sceneweaver.language.quantities import plain_quantities, spelt
from sceneweaver.language.read import read_by_rules
from tests.language.graphs import consistent

WRITTEN = [
    ("a yard and a half off", "1.5 yard off"),
    ("two and a half metres", "2.5 metres"),
    ("i am five foot eleven", "i am 1.80 m"),
    ("a door 6'8\" high", 'a door 2.03 m high'),
    ("3m20 by 2m05", "3.20 m by 2.05 m"),
    ("forty five centimetres", "45 centimetres"),
    ("turning circle 160 by the bed", "turning circle 160 cm by the bed"),
    ("a door 85 wide", "a door 85 cm wide"),
    ("clear opening 900, please", "clear opening 900 mm, please"),
    ("ceiling 2.6, walls white", "ceiling 2.6 m, walls white"),
    ("aisles 110 at the narrowest", "aisles at least 110 cm"),
    ("a bench 70 high, stools 45.", "a bench 70 cm high, stools 45 cm high."),
    ("the bench is 3 ft long, the shelf 40 high", "the bench is 3 ft long, the shelf 40 in high"),
    ("a bed 150 wide, no wider", "a bed at most 150 cm wide"),
    ("thirty chairs minimum", "at least thirty chairs"),
    ("25+ books", "at least 25 books"),
    ("between 8 and 12 stools", "8 to 12 stools"),
    ("20 or so jars", "about 20 jars"),
    ("paths >= 80 cm", "paths at least 80 cm"),
]  # fmt: skip


@pytest.mark.parametrize(("said", "plain"), WRITTEN)
def test_numbers_are_written_out(said: str, plain: str) -> None:
    text, places = plain_quantities(said, range(len(said)))
    assert text == plain and len(places) == len(text)
    assert places == sorted(places) and places[-1] == len(said) - 1


@pytest.mark.parametrize(
    "said",
    [
        "two rows of 20 chairs in a hall",
        "the top 20 games on a shelf",
        "a shelf above 30 books",
        "a path 50 to 60 cm wide",
        "between two chairs and a table",
        "a bathtub on four feet with a tap",
        "5 metres by 4",
    ],
)
def test_other_numbers_stay(said: str) -> None:
    assert plain_quantities(said, range(len(said)))[0] == said


def test_numbers_in_words() -> None:
    assert [spelt(n) for n in ("seven", "forty-two", "a hundred and five", "two hundred", "3,5")] == [
        7,
        42,
        105,
        200,
        3.5,
    ]


@pytest.mark.parametrize(
    ("text", "noun"),
    [
        ("a kitchen with a 3 ring hob and a table", "hob"),
        ("a van with a 24v cool box", "cool box"),
        ("a hall with an A1 poster", "poster"),
        ("a den with an 8K television", "television"),
        ("a shop with a four drawer cabinet", "cabinet"),
        ("a hall with size 7 boots", "boots"),
    ],
)
def test_what_a_number_says_of_a_thing_is_no_count(text: str, noun: str) -> None:
    graph = read_by_rules(text)
    consistent(graph)
    thing = next(e for e in graph.entities if e.noun == noun)
    assert thing.count in (None, (1, 1)) and thing.attributes


def test_numbers_before_what_they_count_stay_counts() -> None:
    graph = read_by_rules("a bar with 4 bar stools, two door mats and six plates")
    assert {e.category: e.count for e in graph.entities if e.count} == {
        "bar_stool": (4, 4), "doormat": (2, 2), "plate": (6, 6),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("Workshop, 5 m long and 3 m wide, a bench 2 m long.", (5.0, 3.0)),
        ("A ship's galley, inside width 1.9 m, this part 3 m long, a sink.", (3.0, 1.9)),
        ("A study whose width is 3 m and whose length is 4 m.", (4.0, 3.0)),
        ("A den with a rug 3 m long and 2 m wide.", None),
        ("The counter must be 2.2 m by 0.9 m. A kitchen with a sink.", None),
    ],
)
def test_sides_that_are_told_one_by_one(text: str, size: tuple[float, float] | None) -> None:
    assert read_by_rules(text).size == size


@pytest.mark.parametrize(
    ("text", "params"),
    [
        ("a den, the armchair at least 2 m from the door", {"min": 2.0}),
        ("a den, the armchair within 1.5 m of the window", {"max": 1.5}),
        ("a den, the armchair 1 m away from the stove", {"min": 0.9, "max": 1.25}),
        ("a den, the armchair about 2 yards off the stove", {"min": 1.463, "max": 2.743}),
    ],
)
def test_a_distance_belongs_to_its_relation(text: str, params: dict[str, float]) -> None:
    (relation,) = read_by_rules(text).relations
    assert relation.subject == "armchair" and relation.params == params


@pytest.mark.parametrize(
    ("text", "quantity", "ends"),
    [
        ("a nursery with no shelf above 120", "upper", (None, 1.2)),
        ("a nursery without any bookcase taller than 1.3 m", "height", (None, 1.3)),
        ("a cafe with no table lower than 68 cm", "lowest", (0.68, None)),
        ("a den, no shelf over 30 cm deep", "depth", (None, 0.3)),
        ("a hall with nothing above waist height", "upper", (None, 1.1)),
    ],
)
def test_a_limit_is_no_exclusion(text: str, quantity: str, ends: tuple[float | None, float | None]) -> None:
    graph = read_by_rules(text)
    (limit,) = graph.measures
    assert limit.quantity == quantity and (limit.low, limit.high) == ends and limit.categories
    assert not graph.exclusions and not graph.entities and not graph.unread


def test_a_limit_on_what_stands_on_something() -> None:
    graph = read_by_rules("a dining room with a table. Nothing taller than 25 cm on the table.")
    (limit,) = graph.measures
    assert (limit.categories, limit.on, limit.high) == (("object",), "dining_table", 0.25)


def test_a_place_is_still_where_something_must_not_be() -> None:
    graph = read_by_rules("a bedroom with a bed, no shelf above the bed")
    assert not graph.measures and graph.exclusions[0].targets == ("bed",)


@pytest.mark.parametrize(
    ("text", "entity", "quantity", "ends"),
    [
        ("a vet's room, the table no lower than 90 cm", "vet_table", "top", (0.9, None)),
        ("a den with a sofa not wider than 2 m", "sofa", "width", (None, 2.0)),
        ("a den with a wardrobe taller than 2 m", "wardrobe", "height", (2.0, None)),
        ("a workshop, workbench at counter height, not lower", "workbench", "top", (0.85, None)),
        ("an office, a desk with knee room 70", "desk", "knee", (0.7, None)),
        ("a nursery with a bookcase with toys no higher than 95 cm", "bookcase", "top", (None, 0.95)),
    ],
)
def test_comparisons_with_a_length(text: str, entity: str, quantity: str, ends: tuple[float, float]) -> None:
    (measure,) = read_by_rules(text).measures
    assert (measure.entity, measure.quantity, (measure.low, measure.high)) == (entity, quantity, ends)


def test_gaps_between_things_of_a_kind() -> None:
    (row,) = read_by_rules("a hall with six chairs in a row, gaps of 30 cm").arrangements
    assert row.spacing == 0.3
    (area,) = read_by_rules("a studio, five easels, 1.4 m apart").free_areas
    assert (area.kind, area.size, area.targets) == ("gap", (1.4, 1.4), ("easel",))


def test_room_behind_people_is_behind_their_seats() -> None:
    (area,) = read_by_rules("a den with three stools, a metre to pass behind a seated person").free_areas
    assert (area.kind, area.size[0], area.targets, area.side) == ("clearance", 1.0, ("stool",), "back")


def test_a_door_that_must_not_swing_in_swings_out() -> None:
    (door,) = read_by_rules("a bathroom. Door clear opening 900, must not swing in.").openings
    assert door.width == 0.9 and door.features == ("outward",)
