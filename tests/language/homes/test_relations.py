"""Requests as strangers say them: whose rooms, on which storey, what lies beside what, widths, things."""

from collections import Counter

import pytest

from benchmarks.home_requests import home_requests, verdicts
from sceneweaver.language.homes import read_home
from sceneweaver.plans import Profile


def types(text):
    return Counter(room.type for room in read_home(text).programme.rooms)


def storeys(text):
    return {room.id: room.storey for room in read_home(text).programme.rooms}


def joints(text):
    return {(a.a, a.kind, a.b) for a in read_home(text).programme.adjacencies}


def wishes(text):
    return {room.id: " ".join(room.wishes) for room in read_home(text).rooms}


@pytest.mark.parametrize("name", ["relations"])
def test_what_was_tuned_on_is_read(name):
    wrong = [
        (one.id, words) for one in home_requests(name) for words, met in verdicts(one, read_home(one.text)) if not met
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("text", "sleeping"),
    [
        ("a house with a bedroom for each of my three sons and one for us", 4),
        ("a flat for a couple and two girls, the girls share a room", 2),
        ("house for us and four boys, the boys sleep together in one room", 2),
        ("a flat for me and my cousin who visits, one bathroom", 1),
        ("single mum here, two kids (a girl 4, a boy 9), a flat where my son gets a desk", 3),
        ("a house for my wife, our baby boy and me", 2),
        ("two-bedroom house, eight grandchildren come on Sundays", 2),
        ("flat with three bedrooms, one for each nurse", 3),
    ],
)
def test_a_room_for_people_is_theirs(text, sleeping):
    found = types(text)
    kinds = ("bedroom", "master_bedroom", "childrens_room", "nursery", "guest_room")
    assert sum(found[kind] for kind in kinds) == sleeping


def test_storeys_of_clauses():
    found = storeys(
        "Two-storey house. My father gets the downstairs with his own bedroom and bathroom, we live above with two "
        "bedrooms and a kitchen, and one storage room downstairs."
    )
    assert (found["bedroom"], found["bathroom"], found["storage_room"]) == (0, 0, 0)
    assert (found["bedroom-2"], found["bedroom-3"], found["kitchen"], found["bathroom-2"]) == (1, 1, 1, 1)


def test_storeys_of_those_who_sleep_and_live_there():
    found = storeys("House on two storeys, upstairs everybody sleeps, downstairs a study, for a couple with twins")
    assert (found["master_bedroom"], found["childrens_room"], found["study"]) == (1, 1, 0)
    found = storeys("House with two floors: a shop and a garage at the bottom. Upstairs a flat with one bedroom.")
    assert (found["bedroom"], found["living_room"], found["kitchen"], found["garage"]) == (1, 1, 1, 0)
    found = storeys("Two-storey house, two bedrooms, a painting studio. I live above the studio.")
    assert (found["art_studio"], found["bedroom"], found["kitchen"]) == (0, 1, 1)
    found = storeys("Three-storey house, kitchen on the first floor, the bedrooms on top, a garage below")
    assert (found["garage"], found["kitchen"], found["bedroom"]) == (0, 1, 2)


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("office, nine workstations in one open room, a meeting room", {"open_office": 1, "private_office": 0}),
        ("agency: six people together in one large room, a toilet", {"open_office": 1, "private_office": 0}),
        ("office with an open space for 12 people, two private offices", {"open_office": 1, "private_office": 2}),
        ("office with a meeting room, a server in its own locked room", {"private_office": 0, "meeting_room": 1}),
    ],
)
def test_one_open_room_is_for_all(text, rooms):
    found = types(text)
    assert {name: found[name] for name in rooms} == rooms


def test_relations():
    apart = joints("a flat where the bedroom is as far from the kitchen and the front door as possible")
    assert {("bedroom", "apart", "kitchen"), ("bedroom", "apart", "entrance_hall")} <= apart
    assert ("study", "apart", "living_room") in joints("flat, a study that shares no wall with the living room")
    doors = joints("doctor's practice with two exam rooms and a laboratory between them with a door to each")
    assert {("laboratory", "door", "examination_room"), ("laboratory", "door", "examination_room-2")} <= doors
    assert types("doctor's practice with two exam rooms and a laboratory with a door to each")["laboratory"] == 1


def test_an_annex_between_rooms_that_are_no_way_has_a_door_to_the_hall():
    text = "doctor's practice with two exam rooms and a sterilisation room between them with a door to both"
    found = [(x.a, x.b) for x in read_home(text).programme.adjacencies if x.hard]
    assert ("sterilisation", "hallway") in found and len(found) == 3


@pytest.mark.parametrize(
    ("text", "doors", "ways"),
    [
        ("flat, two bedrooms, all doors at least 90 cm wide", 0.9, None),
        ("house with three bedrooms, doors of 1 m and corridors of 1.4 m", 1.0, 1.4),
        ("bungalow, two bedrooms, 120 cm wide hallways", None, 1.2),
        ("flat with a bedroom with a desk of 120 cm and a sliding door", None, None),
        ("house on a plot 8 m wide, two bedrooms", None, None),
    ],
)
def test_widths_are_rows_of_the_profile(text, doors, ways):
    asked = read_home(text)
    assert (asked.doors, asked.ways) == (doors, ways)
    rows = {row.id: row for row in asked.rules.rows}
    assert (rows["asked-doors"].least if "asked-doors" in rows else None) == doors
    assert (rows["asked-ways"].least if "asked-ways" in rows else None) == ways
    assert all(row.hard for name, row in rows.items() if name.startswith("asked-"))
    if doors is ways is None:
        assert asked.rules is Profile.named(asked.profile)


def test_corridors_of_a_width_are_one_corridor():
    assert types("house with three bedrooms, corridors of 1.4 m")["hallway"] == 1


def test_things_are_where_their_clause_says():
    found = wishes(
        "Law firm. Reception facing the entrance with a sofa and six guest chairs, two offices each with a bookcase, "
        "an archive with steel shelves on each wall and no windows, a toilet"
    )
    assert "chairs" in found["reception"] and "shelves" in found["archive"] and "bookcase" in found["private_office"]
    assert "chairs" not in found["private_office"]
    found = wishes(
        "flat with a room for each of our two girls with a desk, and our room, a long table - nine chairs or so"
    )
    assert "desk" in found["bedroom"] and "desk" in found["bedroom-2"]
    table = next(name for name, words in found.items() if "table" in words)
    assert "nine chairs" in found[table]


def test_rooms_of_one_size():
    rooms = [
        r for r in read_home("student flat, three bedrooms of the same size").programme.rooms if r.type == "bedroom"
    ]
    assert len(rooms) == 3 and max(r.area[2] for r in rooms) < 1.15 * min(r.area[0] for r in rooms)


def test_doors_outside():
    outside = {
        text: [room.id for room in read_home(text).rooms if room.outside]
        for text in (
            "house with a workshop with its own entrance, a kitchen and two bedrooms",
            "cottage with a storage room that is only reached from the garden, two bedrooms",
            "house with a study with its own bathroom, two bedrooms",
        )
    }
    assert list(outside.values()) == [["workshop"], ["storage_room"], []]


def test_rooms_that_lead_nowhere_get_a_corridor():
    assert types("office with a meeting room, two private offices and a toilet")["hallway"] == 1
