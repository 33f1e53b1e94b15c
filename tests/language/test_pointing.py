"""Contrasts, numbers that are names, words that point back, and where they stand in lists."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules
from sceneweaver.language.spelling import mended


def related(text: str) -> set[tuple[str, ...]]:
    return {(r.subject, r.type, *r.targets) for r in read_by_rules(text).relations}


def counted(text: str) -> dict[str, tuple[int, int] | None]:
    return {e.id: e.count for e in read_by_rules(text).entities}


@pytest.mark.parametrize(
    ("text", "wanted", "unwanted"),
    [
        ("An office with no sofas just stools.", {"stool": (2, 6)}, "sofas"),
        ("A hall, no table only a shelf.", {"wall_shelf": (1, 1)}, "table"),
        ("It should not have a bathtub but a shower.", {"shower": (1, 1)}, "bathtub"),
    ],
)
def test_an_exclusion_ends_where_something_is_there_instead(text, wanted, unwanted):
    graph = read_by_rules(text)
    assert {e.id: e.count for e in graph.entities} == wanted
    assert [one.words for one in graph.exclusions] == [unwanted]
    assert not graph.unread


@pytest.mark.parametrize(
    ("text", "name", "count"),
    [
        ("A den, no plants except two by the window.", "potted_plant", (2, 2)),
        ("A hall with no pictures on the walls but three over the bench.", "picture", (3, 3)),
        ("A lobby without chairs apart from one by the door.", "chair", (1, 1)),
    ],
)
def test_what_is_left_of_an_excluded_kind_is_that_many(text, name, count):
    graph = read_by_rules(text)
    assert {e.id: e.count for e in graph.entities}[name] == count
    assert not graph.exclusions
    assert not graph.unread


def test_a_number_behind_a_singular_noun_is_a_name():
    graph = read_by_rules("A restaurant, table 5 by the window and table 6 by the door.")
    assert [e.count for e in graph.entities] == [(1, 1), (1, 1)]
    assert not graph.unread
    assert counted("Hospital room 3 with two beds.") == {"hospital_bed": (2, 2)}


def test_numbers_in_lists_stay_counts():
    assert counted("Desk 1, chair 2, bed 1") == {"desk": (1, 1), "chair": (2, 2), "bed": (1, 1)}
    assert counted("Classroom. Chairs: 4, tables: 2") == {"chair": (4, 4), "dining_table": (2, 2)}


@pytest.mark.parametrize(
    "text",
    [
        "Two beds. Her bed by the window, his bed by the door.",
        "Two beds. The first bed by the window, the second bed by the door.",
    ],
)
def test_one_of_several_is_no_new_one(text):
    graph = read_by_rules(text)
    assert related(text) == {("bed", "at", "window"), ("bed-2", "near", "door")}
    assert [e.count for e in graph.entities] == [(1, 1), (1, 1)]
    assert not graph.unread


SAID = [
    ("A bench. Behind it a shelf. On that shelf a radio.", ("radio", "on", "wall_shelf")),
    ("A fridge and next to that a stove.", ("stove", "next_to", "fridge")),
    ("A sofa and a chair, a lamp at the chair's left side.", ("table_lamp", "left_of", "chair")),
    ("A sofa by the door, behind which is a bookcase.", ("bookcase", "behind", "sofa")),
    ("A sofa by the window, behind it is a bookcase.", ("bookcase", "behind", "sofa")),
    ("A table on which stands a lamp.", ("table_lamp", "on", "dining_table")),
    ("A nightstand left of the bed with a lamp and a radio on it.", ("radio", "on", "nightstand")),
    ("A shelf on the wall, underneath a desk.", ("desk", "below", "wall_shelf")),
    ("A dresser by the door, on top a vase.", ("vase", "on", "dresser")),
    ("Printer on the desk next to the laptop.", ("desk_printer", "next_to", "laptop")),
    ("Lockers down the left side.", ("locker", "along", "wall:left")),
    ("A table with six chairs round, a rug.", ("chair", "around", "dining_table")),
    ("A sofa with a side table either side.", ("side_table", "flanking", "sofa")),
    ("Two beds, each has a lamp on the wall.", ("wall_sconce", "on", "wall")),
]


@pytest.mark.parametrize(("text", "relation"), SAID)
def test_what_words_of_place_are_said_of(text, relation):
    assert relation in related(text)


def test_one_of_several_may_be_of_another_kind():
    assert counted("Six chairs, one of them a high chair.") == {"high_chair": (1, 1), "chair": (5, 5)}


def test_measures_in_brackets_count_nothing():
    (sofa,) = read_by_rules("A sofa (about 2 m, grey).").entities
    assert (sofa.count, sofa.size[1], sofa.color) == ((1, 1), 2.0, "grey")


def test_what_turns_its_back_to_a_door_is_not_against_it():
    graph = read_by_rules("A sofa, the sofa's back to the door.")
    assert not graph.relations
    assert graph.unread


@pytest.mark.parametrize("word", ["thicker", "twice", "rinses", "sharper", "prevents", "raking"])
def test_words_of_all_kinds_are_no_slips(word):
    assert mended(word, []) is None


def test_what_stands_before_a_colon_is_where_the_list_is():
    text = "A ward. On the left: two beds and a chair. On the desk: a lamp."
    assert {("hospital_bed", "against", "wall:left"), ("table_lamp", "on", "desk")} <= related(text)


@pytest.mark.parametrize(
    ("text", "relation"),
    [
        ("Two shelves, the first holds books, the second a radio.", ("radio", "on", "wall_shelf-2")),
        ("A stove next to the sink, then a fridge.", ("fridge", "next_to", "stove")),
        ("A desk with two monitors opposite the bed.", ("desk", "opposite", "bed")),
        ("A lamp, a clock and a phone on the nightstand.", ("table_clock", "on", "nightstand")),
    ],
)
def test_lists_and_chains_go_on(text, relation):
    assert relation in related(text)


@pytest.mark.parametrize(
    ("text", "wanted", "unwanted"),
    [
        ("a workshop where two can pass without touching, a bench and a vise", {"bench", "vise"}, set()),
        ("an attic with a daybed if there is floor for it, if not an armchair", {"daybed", "armchair"}, set()),
        ("a cellar without carpeting or a mirror, a wine rack", {"wine_rack"}, {"wall_mirror"}),
    ],
)
def test_what_does_not_happen_rules_out_nothing(text: str, wanted: set[str], unwanted: set[str]) -> None:
    graph = read_by_rules(text)
    assert {e.category for e in graph.entities} >= wanted
    assert set(graph.without) >= unwanted and not set(graph.without) & wanted
