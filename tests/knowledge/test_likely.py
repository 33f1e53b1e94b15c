"""Which kind of room a request means that names none."""

from __future__ import annotations

import pytest

from sceneweaver.agent.design import chosen_room
from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.likely import likeliest_room
from sceneweaver.knowledge.names import room_of_part
from sceneweaver.language import read_request

MEANT = [
    ("an island with four bar stools, a stove and a microwave on a shelf", "kitchen"),
    ("a round table with five chairs under a chandelier", "dining_room"),
    ("a toilet beside the door and a bathtub in the corner", "bathroom"),
    ("a sofa that faces a TV on a TV stand, with a coffee table between them", "living_room"),
    ("a desk with two monitors below the window and an office chair", "study"),
    ("a king-size bed with a bench at its foot", "bedroom"),
    ("a play tent next to a toy chest, and a rocking horse", "childrens_room"),
    ("a workbench with a tool cabinet beside it", "workshop"),
]


@pytest.mark.parametrize(("text", "room"), MEANT)
def test_things_tell_the_room(text: str, room: str) -> None:
    found, said = chosen_room(read_request(text))
    assert found.name == room
    assert said == (f"no kind of room was named; made as a {room.replace('_', ' ')}",)


def test_the_order_of_the_things_does_not_matter() -> None:
    names = ["desk", "office_chair", "monitor", "sofa"]
    assert likeliest_room(names) == likeliest_room(names[::-1])


def test_a_room_in_the_text_tells_more_than_a_thing() -> None:
    assert likeliest_room(["cafe_table"], "a sunny breakfast dining room") == room_types()["dining_room"]
    assert likeliest_room(["bookcase"], "the music room upstairs") == room_types()["music_room"]


def test_nothing_told() -> None:
    assert likeliest_room([]) is None
    assert likeliest_room(["no_such_category"], "something nice") is None
    assert chosen_room(read_request("something nice"))[0].name == "living_room"


def test_a_room_that_is_not_known_holds_what_is_asked_for() -> None:
    hut = "A mountain hut for four hikers: two bunk beds, a stove, a table, baskets and a shelf"
    found, said = chosen_room(read_request(hut))
    assert found.name == "mountain_hut"
    assert said == (
        "'mountain hut' is no kind of room that is known; it holds what was asked for, what that needs, and light",
    )
    assert {"bunk_bed", "ceiling_light"} <= {name for item in found.items for name in item.what}
    assert not any("wardrobe" in item.what for item in found.items)


def test_a_desk_has_its_chair_in_a_room_that_is_not_known() -> None:
    found, _ = chosen_room(read_request("A Podcast Studio with a desk, a mixing console and a microphone"))
    assert found.name == "podcast_studio"
    assert {item.with_ for item in found.items if "office_chair" in item.what} == {"desk"}


def test_a_part_of_a_room_is_one_of_that_kind() -> None:
    assert room_of_part("bakery counter area") == "bakery"
    assert room_of_part("reading corner") is None
    assert room_of_part("bakery") is None


def test_things_of_many_rooms_tell_none() -> None:
    found, said = chosen_room(read_request("a treadmill, a bathtub, a photocopier and a piano"))
    assert found.name == "room" and said[0].startswith("no kind of room was named; it holds")


def test_beds_stand_in_rooms_with_beds() -> None:
    storage = ["bed", "shelving_unit", "washing_machine", "laundry_basket", "ironing_board", "drying_rack"]
    found = likeliest_room(storage)
    assert found is not None and any("bed" in item.what for item in found.items)
