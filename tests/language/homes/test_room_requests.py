"""The sentences of single rooms, as the reader of rooms takes them."""

import pytest

from sceneweaver.home import Home
from sceneweaver.language import read_request
from sceneweaver.language.homes import read_home, room_requests
from sceneweaver.language.homes.lexicon import data, room_kinds, uses
from sceneweaver.plans import room_types
from tests.for_each import for_each


@for_each(data("rooms"))
def test_the_reader_of_rooms_knows_every_noun(name):
    kind = room_kinds()[name]
    assert kind.type in room_types()
    assert read_request(f"A {kind.noun}.").room_type is not None


def test_kinds_that_uses_name_are_there():
    for use in uses().values():
        for option in (*use.means.values(), *use.needs, *use.staff.values()):
            assert all(name in room_kinds() for name in option.split("|")), (use.name, option)
    for kind in room_kinds().values():
        assert all(name in room_kinds() for name in kind.counts_as)


def test_what_is_asked_for_a_room_is_in_its_sentence():
    asked = read_home(
        "a rustic flat for a couple with twins: a crib in the parents' bedroom, a kitchen with an island, no bathtub"
    )
    texts = room_requests(asked)
    assert texts["master_bedroom"] == "A rustic parents' bedroom for two people with a crib."
    assert texts["kitchen"] == "A rustic kitchen with an island."
    assert texts["bathroom"].endswith("No bathtub.")
    assert texts["childrens_room"] == "A rustic children's room for two children."
    assert all(text.startswith("A rustic") for text in texts.values())
    assert {row.kind for row in asked.understood} >= {"style", "request", "not wanted", "people"}


def test_things_reach_the_reader_of_rooms():
    texts = room_requests(read_home("an office with two meeting rooms for eight, and a kitchen with a table for six"))
    meeting = read_request(texts["meeting_room"])
    assert meeting.room_type == "meeting_room" and meeting.people == 8
    kitchen = read_request(texts["break_room"])
    assert any("table" in entity.category for entity in kitchen.entities)


def test_told_only_leaves_the_other_rooms_out():
    asked = read_home("a two-bedroom flat with a red kitchen")
    assert set(room_requests(asked, told_only=True)) == {"kitchen"}
    assert set(room_requests(asked)) == {room.id for room in asked.programme.rooms}


def test_rooms_that_the_plan_added_have_one_and_stairs_none():
    home = Home.example("flat")
    texts = room_requests(read_home("a two-bedroom flat"), home)
    assert texts["living"] == "A living room." and texts["bedroom"].startswith("A bedroom")
    with_stairs = read_home("a two-storey house with three bedrooms")
    assert not any("stairs" in name for name in room_requests(with_stairs))
    with pytest.raises(Exception, match="attic"):
        with_stairs.room("attic")
