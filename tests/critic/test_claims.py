"""What is said to be met is met in all of its words."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.critic.asked_words import of_its_own
from sceneweaver.knowledge.capacity import edge_places
from sceneweaver.knowledge.kin import is_several
from sceneweaver.language import SceneGraph, read_request
from tests.critic.measuring import CHAIR, SOFA, TABLE, aligned, box, holds


def lost(text: str) -> str:
    """The words of a request that are told as not understood."""
    return " ".join(one.words for one in read_request(text).unread)


def test_words_of_place_and_of_emptiness_that_nothing_covers_are_told():
    assert "opposite" in lost("a hall with a bench, a glorpy quux opposite, and a mirror")
    assert "nothing" in lost("an office with a desk; on the shelves is nothing")
    assert "nothing" not in lost("an office with a desk, nothing fancy")
    assert "above" not in lost("an office with a clock above the desk")


def test_a_word_of_a_noun_phrase_that_nothing_speaks_for_is_found():
    graph = read_request("a den with a sofa and a coffee table")
    table = graph.entity("coffee_table")
    assert table is not None and of_its_own(graph, table) == ""
    text = graph.text.replace("a coffee table", "a pallet table")
    assert of_its_own(graph.model_copy(update={"text": text}), table) == "pallet"


def test_a_half_circle_is_no_circle():
    found = read_request("a hall with a half circle of seven stools").arrangements
    assert [one.pattern for one in found] == ["semicircle"]


def test_one_straight_thing_is_around_nothing():
    said: dict[str, Any] = {"type": "around", "subject": "sofa", "targets": ("dining_table",)}
    table = box("dining_table-0", TABLE, 3.0, 2.5)
    assert not holds(table, box("sofa-0", SOFA, 1.4, 2.5), **said)


def test_what_hangs_on_another_wall_is_not_in_front():
    said: dict[str, Any] = {"type": "in_front_of", "subject": "curtain", "targets": ("wall_rail",)}
    rail = box("wall_rail-0", (0.1, 1.0, 0.1), 1.0, 0.05, 90, mount="wall", z=1.6)
    before = box("curtain-0", (0.1, 1.0, 1.6), 1.0, 0.2, 90, mount="wall", z=0.2)
    aside = box("curtain-0", (0.1, 1.0, 1.6), 0.05, 0.9, 0, mount="wall", z=0.2)
    assert holds(rail, before, **said) and not holds(rail, aside, **said)


def test_one_looks_at_something_from_a_desk_and_the_desk_does_not():
    said: dict[str, Any] = {"type": "facing", "subject": "desk", "targets": ("sofa",), "words": "looking at"}
    desk, sofa = box("desk-0", (0.7, 1.4, 0.75), 3.0, 2.5, 180), box("sofa-0", SOFA, 5.4, 2.5, 180)
    chair = box("office_chair-0", CHAIR, 2.45, 2.5, 0)
    assert not holds(desk, sofa, **said), "nobody sits there"
    assert holds(desk, sofa, chair, **said)
    assert not holds(desk, sofa, box("office_chair-0", CHAIR, 2.45, 2.5, 180), **said)


def test_the_side_of_a_table_at_a_wall_has_no_places():
    assert edge_places(0.9, 2.4) == 10
    assert edge_places(0.9, 2.4, {"front", "left", "right"}) == 6
    assert edge_places(0.9, 2.4, {"front"}) == 4


@pytest.mark.parametrize(("side", "square", "round_"), [(0.7, 4, 4), (1.2, 4, 6), (1.5, 8, 7), (1.8, 8, 9)])
def test_a_large_table_with_equal_sides_has_more_than_four_places(side: float, square: int, round_: int):
    assert (edge_places(side, side), edge_places(side, side, round_=True)) == (square, round_)


def test_a_rail_of_hooks_is_no_hook():
    assert is_several("coat_hooks", "hook") and not is_several("coat_hooks", "coat rack")
    assert not is_several("chair", "chair")


def test_a_length_of_each_is_not_that_of_one():
    measure = {"id": "m", "entity": "bench", "quantity": "width", "low": 1.2, "high": 1.2}
    bench = box("bench-0", (0.4, 1.2, 0.45), 3.0, 2.5)
    entity = {"id": "bench", "noun": "bench", "category": "bench"}
    for words, status in (("1.2 m wide", "met"), ("1.2 m wide each", "partly")):
        data = {"text": "", "entities": [entity], "measures": [{**measure, "words": words}]}
        assert aligned((bench,), SceneGraph.model_validate(data)).of("m").status == status
