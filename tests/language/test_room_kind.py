"""The kind of room that a request is about, by its name, its purpose, where it is and what it is as well."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

KINDS = {
    "a room to fix bicycles in, bench, tools": "bike_shop",
    "somewhere to practise the violin, a stand and a chair": "music_room",
    "the bridge of a container ship": "ship_bridge",
    "quiet prayer room for our airport": "prayer_room",
    "studio for recording singers, desk, microphone": "recording_studio",
    "ten chairs, a low table. it's the waiting room of a garage": "waiting_room",
    "a gym in our basement": "home_gym",
    "a gym": "gym",
    "hall with two lathes and a milling machine": "metal_workshop",
    "place where patients wait for their turn, eight chairs": "waiting_room",
    "massage room at a hotel with a table": "massage_room",
    "Küche mit Kochinsel": "kitchen",
}


@pytest.mark.parametrize("text", KINDS)
def test_kind(text: str) -> None:
    graph = read_by_rules(text)
    assert graph.room_type == KINDS[text]
    assert not graph.other_rooms


@pytest.mark.parametrize("text", ["a bench in the corner", "plants everywhere in a living room", "a pair of armchairs"])
def test_things_name_no_room(text: str) -> None:
    assert read_by_rules(text).room_type in (None, "living_room")
    assert read_by_rules(text).entities


def test_a_name_that_nobody_knows_is_no_other_room() -> None:
    graph = read_by_rules("toll booth with a seat and a counter")
    assert (graph.room_type, graph.room_words) == (None, "toll booth")


def test_a_second_function_brings_its_furniture() -> None:
    graph = read_by_rules("living room that is also a gym, with a sofa and a treadmill")
    things = {entity.category: entity for entity in graph.entities}
    assert graph.room_type == "living_room" and not graph.other_rooms
    assert things["spin_bike"].implied and not things["treadmill"].implied
    corner = read_by_rules("bedroom with a sewing corner")
    assert "sewing_machine_table" in {entity.category for entity in corner.entities}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("she uses the shed as a gym now, rack and mats", "gym"),
        ("An empty storage room turned into a home cinema", "home_theatre"),
        ("pantry ideas please", "pantry"),
        ("please make the guest room upstairs nicer: bed, wardrobe", "guest_room"),
        ("workshop of my uncle, bench in the middle", "workshop"),
        ("Turkish salon, cushions and tea set", "living_room"),
        ("we use the sofa as a bed in our living room", "living_room"),
    ],
)
def test_rooms_that_become_others_and_whose_they_are(text: str, kind: str) -> None:
    assert read_by_rules(text).room_type == kind


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Concrete everywhere. A kitchen for a couple", "kitchen"),
        ("toddler photo studio, backdrop and two lights", "photo_studio"),
        ("internet cafe with eight PCs", "computer_lab"),
        ("pottery studio with a wheel", "pottery_studio"),
    ],
)
def test_whole_names_tell_and_real_words_are_no_slips(text: str, kind: str) -> None:
    assert read_by_rules(text).room_type == kind


def test_what_stands_somewhere_is_a_thing_and_no_name_of_the_room() -> None:
    graph = read_by_rules("An oak table sits at the room center. On its surface, a vase stands in the middle.")
    assert [e.category for e in graph.entities] == ["dining_table", "vase"] and graph.room_words == ""
    assert ("on", "vase", ("dining_table",)) in {(r.type, r.subject, r.targets) for r in graph.relations}


def test_a_part_that_begins_another_noun_is_no_part() -> None:
    graph = read_by_rules("A worktable by the wall. On the worktable, a red stand mixer stands beside a bowl.")
    said = {(r.type, r.subject, r.targets) for r in graph.relations}
    assert ("on", "stand_mixer", ("workbench",)) in said and ("next_to", "stand_mixer", ("bowl",)) in said


def test_a_two_seat_sofa_is_a_kind_of_its_own() -> None:
    for text in ("a two-seat gray sofa", "a two-seater sofa"):
        assert [e.category for e in read_by_rules(text).entities] == ["loveseat"], text


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("This is not a kitchen but a living room with a sofa.", "living_room"),
        ("A study, not a home office: a desk and a chair.", "study"),
        ("A room that isn't a bathroom, with a bed.", None),
    ],
)
def test_what_a_room_is_not_is_told_and_names_none(text, kind):
    graph = read_by_rules(text)
    assert graph.room_type == kind
    assert any("not a" in unread.words or "isn't a" in unread.words for unread in graph.unread)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Wish list of a bassist. Nail salon, 4 x 3 m, two mirrors.", "nail_salon"),
        ("Sunday was grim, thirty cousins, village canteen. A hatch.", "canteen"),
        ("I sold my boat. Please model a chapel with ten pews.", "chapel"),
        ("Brief: law office, two desks.", "law_office"),
        ("Refurbishment of a stone-floor sauna, 2 x 2 m.", "sauna"),
        ("Our cellar, 3 x 4 m, for the wine of my uncle.", "wine_cellar"),
        ("The attic is to be a pottery studio.", "pottery_studio"),
        ("A snug with two armchairs.", "living_room"),
        ("A snug bedroom.", "bedroom"),
        ("A banquet hall. Low stage, 3 x 2 m, on a short wall.", "banquet_hall"),
    ],
)
def test_the_kind_is_found_behind_what_else_is_told(text: str, kind: str) -> None:
    assert read_by_rules(text).room_type == kind
