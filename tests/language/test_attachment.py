"""What words of place are said of: pronouns, fragments, lists, nouns that were said before."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

SAID = [
    ("Kitchen: counter, microwave + kettle on it, fridge next to it", ("microwave", "on", "kitchen_counter")),
    ("Kitchen: counter, microwave + kettle on it, fridge next to it", ("fridge", "next_to", "kitchen_counter")),
    ("Fridge near the door, after it a sink, after it a stove.", ("stove", "next_to", "sink_cabinet")),
    ("A den with a table. Lamp low over the table.", ("pendant", "above", "dining_table")),
    ("A kitchen with a sink full of dishes, a bin by the door.", ("trash_can", "near", "door")),
    ("A poster over the desk, desk with two chairs.", ("chair", "at", "desk")),
]


@pytest.mark.parametrize(("text", "relation"), SAID)
def test_relations(text, relation):
    assert relation in {(r.subject, r.type, *r.targets) for r in read_by_rules(text).relations}


def test_a_noun_without_article_that_was_named_is_no_other_thing():
    entities = read_by_rules("A poster over the desk, desk with two chairs.").entities
    assert [e.category for e in entities] == ["poster", "desk", "chair"]


def test_what_is_beside_a_full_thing_is_not_in_it():
    graph = read_by_rules("A kitchen with a sink full of dishes, a bin by the door.")
    assert {r.subject for r in graph.relations if r.type == "inside"} == {"plate"}
