"""How many of what: bounds, rows of so many, so many each, of which only some are told of."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

COUNTS = [
    ("A cinema with two rows of five recliners.", "recliner", (10, 10)),
    ("A lounge with leather armchairs in three groups of four.", "armchair", (12, 12)),
    ("A workshop with six workbenches in two rows of three.", "workbench", (6, 6)),
    ("A loft with plants everywhere (min. 15) and a bench.", "potted_plant", (15, 19)),
    ("A loft with bottles and cups on the table, at least 20 of them.", "bottle", (10, 12)),
    ("A cafe with six tables. At least two tables stand by the window.", "dining_table", (6, 6)),
    ("A bedroom for three guests, a towel for each guest.", "folded_towel", (3, 3)),
    ("A studio with a round table for four people, a stool and headphones for each.", "headphones", (4, 4)),
    ("A bedroom with two nightstands, a lamp on both nightstands.", "table_lamp", (2, 2)),
    ("A dormitory for three boys. Everybody has an own locker.", "locker", (3, 3)),
    ("A bunk house with four beds, one locker per bed.", "locker", (4, 4)),
    ("Bedroom: 2x nightstands, a bed", "nightstand", (2, 2)),
    ("A hall: max. 3 stools, about 10 books, a lamp or two", "stool", (1, 3)),
    ("A hall: max. 3 stools, about 10 books, a lamp or two", "book", (10, 10)),
    ("A hall: max. 3 stools, about 10 books, a lamp or two", "table_lamp", (1, 2)),
    ("a bedroom with one or two stools", "stool", (1, 2)),
    ("a dining room with a rack + 2 benches", "bench", (2, 2)),
    ("Twelve items: cups, plates and forks.", "fork", (4, 4)),
    ("A hall with a bench, five hooks above it.", "coat_hooks", (5, 5)),
    ("A fort with cannonballs and a cannon.", "cannonball_stack", (1, 1)),
    ("A boathouse with six kayaks.", "boat_rack", (2, 2)),
    ("A tailor's with a rail of ball gowns.", "gown_rail", (1, 1)),
]


@pytest.mark.parametrize(("text", "category", "count"), COUNTS)
def test_counts(text, category, count):
    assert read_by_rules(text).entity(category).count == count


def test_so_many_each_belong_to_their_owners():
    graph = read_by_rules("An office with two desks side by side, three chairs each.")
    chairs = [e for e in graph.entities if e.category == "chair"]
    assert sum(e.count[0] for e in chairs) == 6
    assert {(r.subject, r.targets[0]) for r in graph.relations if r.type == "at"} == {
        ("chair", "desk"),
        ("chair-2", "desk-2"),
    }


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("An oak table, two chairs on one side, three on the other.", (2, 3)),
        ("A meeting room with a table, three chairs on one side, two on the other.", (3, 2)),
        ("A hall with a long table and a rug. Four chairs on one side of the table, three on the other side", (4, 3)),
    ],
)
def test_so_many_on_one_side_and_on_the_other_are_one_arrangement(text: str, sides: tuple[int, int]):
    graph = read_by_rules(text)
    assert [e.count for e in graph.entities if e.category == "chair"] == [(sum(sides), sum(sides))]
    (one,) = graph.arrangements
    assert (one.pattern, one.entity, one.sides, one.around) == ("sides", "chair", sides, "dining_table")


def test_some_of_those_that_were_named_are_no_others():
    graph = read_by_rules("A cafe with six tables. At least two tables stand by the window.")
    (relation,) = graph.relations
    assert (relation.subject, relation.count[0]) == ("dining_table", 2)


def test_a_table_that_seats_so_many_says_for_how_many_people():
    graph = read_by_rules("A dining room. Table seats eight, plate and fork for each guest.")
    assert graph.people == 8
    assert graph.entity("plate").count == (8, 8)


@pytest.mark.parametrize(
    ("text", "count", "told"),
    [
        ("a kitchen with 1000000000000 chairs", 400, "is no number that a room has"),
        ("a kitchen with exactly 123456789 chairs", 400, "was brought to 400"),
        ("a hall with a thousand chairs", 400, "1000 x chairs"),
        ("a hall with two thousand chairs", 400, "2000 x chairs"),
        ("a study with 2.5 chairs", 2, "'2.5' is no number of things"),
        ("a study with -3 chairs", 3, "'-3' is no number of things"),
        ("a study with minus three chairs", 3, "'minus three' is no number of things"),
        ("a study with half a chair", 1, "'half a' is no number of things"),
    ],
)
def test_what_is_no_number_of_things_is_told(text, count, told):
    graph = read_by_rules(text)
    assert [entity.count for entity in graph.entities] == [(count, count)]
    assert any(told in note for note in graph.notes), graph.notes


@pytest.mark.parametrize(
    "text", ["a desk 2.5 m from the door", "half a dozen chairs", "a 1.5 m wide desk", "a table half a metre high"]
)
def test_measures_and_half_a_dozen_are_numbers(text):
    assert not any("no number" in note for note in read_by_rules(text).notes)
