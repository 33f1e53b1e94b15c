"""No word of a request is lost without a word: it is read, it is one of grammar, or it is told."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sceneweaver.language.coverage import function_words
from sceneweaver.language.read import read_by_rules

NONSENSE = ("glorp", "wuffled", "zindering", "quaxly", "brenthic")


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(NONSENSE), st.integers(0, 9))
def test_a_word_of_no_meaning_is_told_wherever_it_stands(word: str, at: int) -> None:
    spoken = ["a", "quiet", "study", "with", "an", "oak", "desk", "by", "the", "window", "and", "two", "lamps"]
    text = " ".join([*spoken[:at], word, *spoken[at:]])
    graph = read_by_rules(text)
    told = " ".join(unread.words for unread in graph.unread) + " ".join(entity.noun for entity in graph.entities)
    said = " ".join(a.words for entity in graph.entities for a in entity.attributes)
    assert word in told or word in said or word in graph.room_words, graph


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("a study with a desk. Reclaimed bricks everywhere.", "everywhere"),
        ("a bedroom for our grandfather with 37 owls", "37"),
        ("a hall, zinc panelled", "zinc"),
    ],
)
def test_what_nothing_accounts_for_is_unread(text: str, word: str) -> None:
    graph = read_by_rules(text)
    spans = [unread.span for unread in graph.unread if unread.span is not None]
    read = " ".join(a.words + e.noun for e in graph.entities for a in e.attributes) + " ".join(map(str, graph.entities))
    assert any(word in text[span.start : span.end].lower() for span in spans) or word in read


def test_what_was_understood_is_not_unread() -> None:
    graph = read_by_rules("a bedroom of 4 x 3.5 m with a bed, two oak nightstands beside it and a lamp on each")
    assert graph.unread == ()


def test_grammar_needs_no_account() -> None:
    assert {"the", "with", "please", "would"} <= function_words() and "desk" not in function_words()


def test_a_noun_of_which_only_the_head_is_known_says_which_words_are_lost() -> None:
    graph = read_by_rules("a room with a zeppelin table and a round table")
    assert [entity.unnamed for entity in graph.entities] == [("zeppelin",), ()]


@pytest.mark.parametrize(
    ("text", "lost"),
    [
        ("A study. A lamp sits on the desk, a pendant hangs from the ceiling above it.", []),
        ("A study. Two vases are arranged on a console table.", []),
        ("A study. A console table runs along the wall beneath the window.", []),
        ("A study with a desk. A lamp rests.", ["rests"]),
        ("A study with a hammock that hangs. A desk on a rug.", ["hangs"]),
    ],
)
def test_how_a_thing_is_somewhere_needs_no_account_where_it_was_read_where(text: str, lost: list[str]) -> None:
    assert [unread.words for unread in read_by_rules(text).unread] == lost


@pytest.mark.parametrize("verb", ["anchors", "grounds", "crowns", "transforms"])
def test_what_a_thing_does_to_the_room_is_no_name_of_it(verb: str) -> None:
    graph = read_by_rules(f"A velvet sofa {verb} the room, facing a TV.")
    assert graph.room_words == "" and [entity.category for entity in graph.entities] == ["sofa", "tv"]


@pytest.mark.parametrize(
    ("text", "noun", "untold"),
    [
        ("a hall with a basket of tennis balls", "basket", {"tennis", "balls"}),
        ("a shop with a barrel of herrings", "barrel", {"herrings"}),
        ("a kitchen with a basket of magnets", "basket", {"magnets"}),
        ("a study with a stack of books", "book_stack", set()),
        ("a bedroom with a chest of drawers", "dresser", set()),
        ("a bedroom with a bench of oak", "bench", set()),
    ],
)
def test_what_is_in_a_vessel_is_told_where_its_drawing_does_not_show_it(text: str, noun: str, untold: set[str]) -> None:
    thing = next(entity for entity in read_by_rules(text).entities if entity.category == noun)
    assert set(thing.unnamed) == untold


@pytest.mark.parametrize("quality", ["fresh", "wilted", "ripe", "different", "wet"])
def test_a_quality_of_what_is_in_a_vessel_is_told(quality: str) -> None:
    assert quality in {left.words for left in read_by_rules(f"a hall with a vase of {quality} tulips").unread}


@pytest.mark.parametrize("word", ["of", "please", "put", "and", "good"])
def test_words_that_link_are_no_qualities(word: str) -> None:
    graph = read_by_rules(f"a hall with a mirror and {word} a bench of oak")
    assert word not in {a.words for entity in graph.entities for a in entity.attributes}


@pytest.mark.parametrize("verb", ["casting", "giving", "providing", "emitting", "spreading", "throwing"])
@pytest.mark.parametrize("given", ["light", "warm light", "heat"])
def test_what_a_thing_gives_off_is_no_other_thing(verb: str, given: str) -> None:
    graph = read_by_rules(f"a study with a floor lamp {verb} {given} and a bench")
    assert {entity.category for entity in graph.entities} == {"floor_lamp", "bench"}
