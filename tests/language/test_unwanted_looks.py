"""Looks that are not wanted: of the whole room, of some things, or all but a few."""

import pytest

from sceneweaver.language.read import read_by_rules


def only(text):
    (found,) = read_by_rules(text).exclusions
    return found


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("a bathroom, no orange at all", {"orange"}),
        ("Guest room. Nothing red or purple please.", {"red", "burgundy", "purple"}),
        ("a playroom, my son hates green", {"green", "dark green", "sage"}),
        ("an office, navy is out", {"navy"}),
        ("cafe with anything but grey", {"grey", "light grey"}),
    ],
)
def test_a_color_that_is_not_wanted_is_no_color_of_the_room(text, colors):
    brief = read_by_rules(text)
    assert set(only(text).colors) == colors
    assert not only(text).within
    assert not brief.colors and not brief.unread


def test_before_a_noun_it_is_said_of_these_things_alone():
    found = only("a canteen, without red plastic chairs")
    assert found.within and not found.categories
    assert "seating" in only("a den with no brown seats").within


def test_what_begins_after_a_comma_is_wanted():
    brief = read_by_rules("a den, no orange, navy walls")
    assert only("a den, no orange, navy walls").colors == ("orange",)
    assert brief.finish_of("walls").color == "navy"


def test_all_other_hues_are_not_wanted_where_a_few_are():
    found = only("a surgery, no colours but white and teal")
    assert "teal" not in found.colors and "red" in found.colors and "white" not in found.colors


def test_a_thing_that_is_not_wanted_is_no_look():
    assert not only("a bedroom with no desk").colors


def test_a_style_that_is_not_wanted_is_not_taken():
    brief = read_by_rules("a parlour, nothing modern")
    assert brief.style is None and brief.exclusions[0].styles == ("modern",)


def test_nothing_with_a_thing_wants_none_of_it():
    brief = read_by_rules("a boy's bedroom, nothing with dinosaurs")
    assert not brief.entities and "toy_dinosaur" in brief.without


@pytest.mark.parametrize(
    "text",
    ["a den with a desk. NO green nothing green she keeps asking", "no red nothing red please, a sofa"],
)
def test_a_colour_that_is_ruled_out_twice_is_not_wanted(text: str) -> None:
    graph = read_by_rules(text)
    assert not graph.colors
    assert {shade for one in graph.exclusions for shade in one.colors} & {"green", "red"}
