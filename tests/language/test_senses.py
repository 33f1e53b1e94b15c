"""Nouns of several meanings, and words that name nothing."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

SENSES = [
    ("A shop for vinyl with six bins and a till.", "record_bin"),
    ("An office with a desk and a bin.", "trash_can"),
    ("A control room with a console.", "control_console"),
    ("A hallway with a narrow console.", "console_table"),
    ("A den with a console and two controllers for games.", "game_console"),
    ("A cinema with a screen and six seats.", "projector_screen"),
    ("A study with a desk and a screen on it.", "monitor"),
    ("A bedroom with a commode.", "dresser"),
    ("A hut with an iron stove.", "wood_stove"),
    ("A kitchen with a stove and a sink.", "stove"),
    ("A cloakroom with a rack for shoes.", "shoe_rack"),
    ("A pilates studio with eight mats.", "yoga_mat"),
    ("A porch with two glasses on a table.", "drinking_glass"),
    ("A terrace with a string of bulbs.", "string_lights"),
    ("A laundry with two washers and a tumbler.", "dryer"),
    ("A bar with six tumblers on a tray.", "drinking_glass"),
    ("A bedroom with sheets on a shelf.", "bed_sheet"),
    ("An office with sheets on a desk.", "paper_stack"),
    ("A room to quilt with a frame and a stool.", "quilting_machine"),
    ("Two aunts play cards at a table.", "playing_cards"),
    ("A pony stable with three boxes for horses.", "horse_stall"),
    ("A cellar with a potato bin.", "wooden_crate"),
    ("A room with an empty pizza box on a stool.", "pizza_box"),
    ("A chapel with two boards and a bench.", "board"),
    ("A workshop for bikes, wheels hanging from the ceiling.", "bike_wheel"),
]

NOTHING = [
    "A chair that can roll, and a desk.",
    "A desk where you can sit and watch the birds.",
    "A desk for a bench test of 40 to 50 cm.",
    "A desk with a chair, she can't reach anything else.",
    "A desk that looks like a ship, a chair.",
    "A chair at a desk on a step of 20 cm, with a path to the door.",
    "A desk and a chair, all handwritten marks are welcome, for a party.",
    "They only speak about sailing. A desk and a chair.",
    "I restore old radios and clocks. A desk and a chair.",
    "My uncle mends shoes and binds books; a desk, a chair.",
    "A desk and a chair where we iron.",
    "Two slipped discs, so a desk and a chair.",
    "A desk with a chair over the hatch in the loft floor.",
    "For the budgies and me a desk and a chair.",
]


@pytest.mark.parametrize(("text", "category"), SENSES)
def test_the_room_and_the_words_around_tell_what_a_noun_means(text, category):
    assert category in {e.category for e in read_by_rules(text).entities}


@pytest.mark.parametrize("text", NOTHING)
def test_words_that_name_nothing_make_no_bodies(text):
    graph = read_by_rules(text)
    assert {e.category for e in graph.entities} - {"desk", "chair", "bench"} == set()
    assert graph.unread


@pytest.mark.parametrize(
    "text", ["I want a can on the shelf", "a blue can on the shelf", "a green paint can on the shelf"]
)
def test_a_can_is_a_thing_where_it_stands_as_one(text):
    assert any("can" in e.noun.split() for e in read_by_rules(text).entities)


def test_what_stands_where_people_do_something_is_read():
    graph = read_by_rules("An armchair where I can read next to a floor lamp.")
    assert {e.id for e in graph.entities} == {"armchair", "floor_lamp"}
    assert [(r.subject, r.type, r.targets) for r in graph.relations] == [("armchair", "next_to", ("floor_lamp",))]


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a rehearsal room for a choir with a keyboard", "digital_piano"),
        ("an office desk with a laptop and a keyboard", "keyboard"),
        ("a screen between the two treatment couches", "room_divider"),
        ("a letterpress studio with a press", "printing_press"),
    ],
)
def test_the_scene_and_what_stands_near_tell(text: str, category: str) -> None:
    assert category in {entity.category for entity in read_by_rules(text).entities}


def test_what_is_asked_for_by_a_verb_of_a_trade_is_made() -> None:
    graph = read_by_rules("Build shelves and a desk, and make a bench for me.")
    assert [entity.category for entity in graph.entities] == ["wall_shelf", "desk", "bench"]


def test_boards_that_are_counted_are_no_cladding() -> None:
    graph = read_by_rules("A classroom with two boards on the front wall.")
    assert [entity.count for entity in graph.entities] == [(2, 2)]
    assert graph.finishes == ()
    assert read_by_rules("A room with boards on the front wall.").finishes


def test_an_article_before_a_noun_is_no_part_of_its_name() -> None:
    assert [e.category for e in read_by_rules("A shop with a board.").entities] != ["menu_board"]
    assert [e.category for e in read_by_rules("A shop with an A-board.").entities] == ["menu_board"]
