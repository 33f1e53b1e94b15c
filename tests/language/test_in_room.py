"""Plain nouns mean what their kind of room needs; what is named in full, or of the room's own, stays."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


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
    assert [entity.category for entity in read_by_rules(text).entities] == categories


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
    assert [entity.category for entity in read_by_rules(text).entities] == [category]


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a kickboxing gym with four bags", "heavy_bag"),
        ("a wine cellar with racks and a lamp", "wine_rack"),
        ("a distillery with two tanks", "brewing_tank"),
        ("a cinema with ninety seats", "theater_seat"),
        ("a bowling alley with four lanes", "bowling_lane"),
        ("Boxing gym. Ring, a clock.", "boxing_ring"),
        ("a yoga studio with blocks", "yoga_block"),
        ("a bike workshop with two stands", "bike_repair_stand"),
        ("a dance studio with a bar", "ballet_barre"),
        ("a toy shop with trains and a till", "toy_train"),
        ("an optician with frames on the wall", "eyewear_display"),
        ("a lecture hall with a desk and a screen", "projector_screen"),
    ],
)
def test_a_noun_without_a_thing_of_its_own_is_what_the_room_has(text: str, category: str) -> None:
    assert category in {entity.category for entity in read_by_rules(text).entities}


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a living room with a canary in a cage on a stand", "stand"),
        ("a living room with a fern on a stand", "plant_stand"),
        ("a kitchen with a block for knives", "knife_block"),
        ("a hallway with a stand for umbrellas", "umbrella_stand"),
        ("a courtroom with a bench for the judge", "judge_bench"),
    ],
)
def test_what_is_on_it_or_what_it_is_for_tells_what_a_noun_means(text: str, category: str) -> None:
    assert category in {entity.category for entity in read_by_rules(text).entities}


@pytest.mark.parametrize(
    ("text", "category"),
    [("a hallway with a box for gloves", "storage_box"), ("a bedroom with a rack for sheets", "metal_shelf")],
)
def test_what_it_is_for_makes_no_thing_of_another_place(text: str, category: str) -> None:
    assert [entity.category for entity in read_by_rules(text).entities] == [category]


def test_a_noun_that_the_room_explains_leaves_no_note() -> None:
    assert read_by_rules("a distillery with two tanks").notes == ()


def test_a_compound_of_another_thing_is_not_what_the_room_has() -> None:
    (station,) = read_by_rules("a break room with a charging station").entities
    assert station.category != "coffee_station"
