"""How full a room is told to be."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    "text",
    [
        "a room with a sofa, otherwise empty",
        "a table and two chairs, that's all",
        "a hall, empty but for a bench",
        "a bed and nothing else in the room",
        "it should only have a bed",
    ],
)
def test_nothing_else(text: str) -> None:
    assert read_by_rules(text).only


@pytest.mark.parametrize("text", ["a bed and little else", "a study with a desk and hardly anything else"])
def test_little_else(text: str) -> None:
    found = read_by_rules(text)
    assert (found.only, found.density) == (False, "sparse")


@pytest.mark.parametrize("text", ["a bedroom for two but only one chair", "They only talk about pirates. A bunk bed"])
def test_only_of_a_number_is_no_word_about_the_room(text: str) -> None:
    assert not read_by_rules(text).only


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("plants absolutely everywhere in a living room", {("potted_plant", "everywhere")}),
        ("bottles and mugs on every surface", {("bottle", "surfaces"), ("mug", "surfaces")}),
        ("a shelf packed with books", {("book", "many")}),
        ("newspapers all over the floor", {("newspaper", "floor")}),
    ],
)
def test_many(text: str, said: set[tuple[str, str]]) -> None:
    graph = read_by_rules(text)
    by_id = {entity.id: entity.category for entity in graph.entities}
    assert {(by_id[amount.entity], amount.spread) for amount in graph.amounts} == said


def test_what_was_said_of_things_before_makes_no_list():
    brief = read_by_rules("a student's room, bed unmade, clothes all over the floor")
    assert [brief.entity(one.entity).category for one in brief.amounts] == ["scattered_clothes"]
    brief = read_by_rules("an office, paper around the bin, mugs everywhere")
    assert [brief.entity(one.entity).category for one in brief.amounts] == ["mug"]
