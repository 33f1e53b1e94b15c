"""Nouns for things of several kinds together stand for a few of them, however many are asked for."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

MOST = 12


@pytest.mark.parametrize(
    ("text", "category", "support"),
    [
        ("a garage with sports gear on a metal shelf", "basketball", "metal_shelf"),
        ("a den with games on the coffee table", "board_game", "coffee_table"),
        ("a hut with kitchen things on the counter", "pot", "kitchen_counter"),
        ("a treatment room with medical equipment on a trolley", "first_aid_kit", "storage_cart"),
    ],
)
def test_a_few_stand_for_all_on_their_support(text: str, category: str, support: str) -> None:
    graph = read_by_rules(text)
    made = [entity for entity in graph.entities if entity.implied]
    assert category in {entity.category for entity in made}
    assert sum(entity.count[1] for entity in made if entity.count) <= MOST
    assert all(any((r.subject, r.type, r.targets) == (e.id, "on", (support,)) for r in graph.relations) for e in made)


def test_a_number_is_shared_among_the_kinds() -> None:
    made = [entity for entity in read_by_rules("a nursery with nine toys on the rug").entities if entity.implied]
    assert len(made) > 1
    assert sum(entity.count[0] for entity in made if entity.count) == 9


def test_what_holds_them_is_none_of_them() -> None:
    graph = read_by_rules("an office with office supplies in the drawer")
    names = {entity.id for entity in graph.entities}
    assert all(r.type == "near" for r in graph.relations if {r.subject, *r.targets} <= names)
