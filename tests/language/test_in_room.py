"""Plain nouns mean what their kind of room needs; what is named in full, or of the room's own, stays."""

from __future__ import annotations

import pytest

from sceneweaver.language import read_request


@pytest.mark.parametrize(
    ("text", "categories"),
    [
        ("a pottery studio with six wheels", ["pottery_wheel"]),
        ("a record shop with five bins and a trash can", ["record_bin", "trash_can"]),
        ("a polling station with four booths and a box", ["voting_booth", "ballot_box"]),
        ("a courtroom with a judge's bench and three benches", ["judge_bench", "public_bench"]),
        ("a barbershop with three chairs and a folding chair", ["barber_chair", "folding_chair"]),
    ],
)
def test_a_plain_noun_means_what_the_room_needs(text: str, categories: list[str]) -> None:
    assert [entity.category for entity in read_request(text).entities] == categories


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a room with six wheels", "wheel"),
        ("a hallway with a bench", "bench"),
        ("an office with two chairs", "chair"),
        ("a kitchen with a bin", "trash_can"),
        ("a living room with a table", "dining_table"),
    ],
)
def test_elsewhere_it_keeps_its_own_meaning(text: str, category: str) -> None:
    assert [entity.category for entity in read_request(text).entities] == [category]
