"""What must not be there, or not in one place."""

from __future__ import annotations

import pytest

from sceneweaver.language import read_request

ELSEWHERE = [
    ("a den with a piano. The piano must not stand in front of the window.", "upright_piano", "in_front_of", "window"),
    ("don't put the bed near the door", "bed", "near", "door"),
    ("a hall with benches, not lined up along the wall", "bench", "along", "wall"),
    ("A study with a desk. The wardrobe should not be next to the desk.", "wardrobe", "next_to", "desk"),
]
BANNED_THERE = [
    ("a nursery with a crib, no shelves above the crib, a rug", "wall_shelf", "above", "crib"),
    ("a den with a desk and no lamp on the desk", "lighting", "on", "desk"),
]


@pytest.mark.parametrize(("text", "subject", "relation", "target"), ELSEWHERE)
def test_what_must_not_be_in_one_place_is_wanted_elsewhere(text, subject, relation, target):
    graph = read_request(text)
    assert graph.entity(subject) is not None
    assert graph.without == ()
    assert [(x.subject, x.relation, x.targets) for x in graph.exclusions] == [(subject, relation, (target,))]
    assert all(r.subject != subject for r in graph.relations)


@pytest.mark.parametrize(("text", "category", "relation", "target"), BANNED_THERE)
def test_what_is_banned_from_one_place_may_be_in_others(text, category, relation, target):
    graph = read_request(text)
    assert graph.without == ()
    (found,) = graph.exclusions
    assert category in found.categories
    assert (found.subject, found.relation, found.targets) == ("", relation, (target,))


@pytest.mark.parametrize(
    ("text", "gone", "stays"),
    [
        ("a kitchen without cabinets", {"cabinet", "wall_cabinet", "kitchen_cabinet", "sink_cabinet"}, "shelving_unit"),
        ("an office without wall cabinets", {"wall_cabinet"}, "filing_cabinet"),
        ("a hall, no clocks", {"wall_clock", "table_clock"}, "picture"),
        ("a living room but not a sofa", {"sofa", "sectional_sofa"}, "armchair"),
    ],
)
def test_a_plain_noun_rules_out_all_that_bears_its_name(text, gone, stays):
    without = set(read_request(text).without)
    assert gone <= without
    assert stays not in without


@pytest.mark.parametrize("text", ["a playroom, loud but not sad", "a hall with stools, no stool on one side"])
def test_what_rules_out_no_thing_rules_out_nothing(text):
    graph = read_request(text)
    assert graph.exclusions == ()
    assert graph.unread


@pytest.mark.parametrize(
    ("text", "only"),
    [
        ("a bedroom with only a bed and a desk", True),
        ("a den with a sofa and a table, but only two chairs", False),
        ("a hall with a bench. The stool is the only seat.", False),
        ("a vault with a safe, otherwise empty", True),
    ],
)
def test_only_is_said_of_the_room_where_nothing_was_named(text, only):
    assert read_request(text).only is only
