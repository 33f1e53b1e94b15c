"""States of things: which thing, which words, of how many."""

import pytest

from sceneweaver.language import read_request

SAID = [
    ("a lounge with two chairs knocked over", "chair", ("knocked over", None)),
    ("a lounge with the curtains half drawn", "curtain", ("half drawn", None)),
    ("a den, an unmade bed in the corner", "bed", ("unmade", None)),
    ("a den with rumpled bedding on the bed", "bed", ("rumpled", None)),
    ("a study, the desk lamp off", "desk_lamp", ("off", None)),
    ("a kitchen with the fridge door open", "fridge", ("door open", None)),
    ("a study with a filing cabinet, one drawer pulled out", "filing_cabinet", ("drawer pulled out", None)),
    ("a cafe with six chairs, two of them upside down", "chair", ("upside down", (2, 2))),
    ("a bar with the blinds down", "window_blind", ("down", None)),
    ("a dormitory with three beds; one of the beds is unmade", "bed", ("unmade", (1, 1))),
    ("a study, the chair pulled out by 35 cm from the desk", "chair", ("pulled out by 0.35", None)),
    ("a study with an office chair without armrests", "office_chair", ("without armrests", None)),
    ("a den with a mug full of tea on the shelf", "mug", ("full of tea", None)),
]


@pytest.mark.parametrize(("text", "category", "wanted"), SAID)
def test_a_state_is_of_its_thing(text, category, wanted):
    graph = read_request(text)
    (entity,) = [e for e in graph.entities if e.category == category]
    assert [(a.value, a.count) for a in entity.attributes if a.kind == "state"] == [wanted]
    assert not graph.unread


@pytest.mark.parametrize(
    "text", ["a den with a lamp on the desk", "a hall with open shelves", "a den, a rug on the floor"]
)
def test_places_and_kinds_are_no_states(text):
    entities = read_request(text).entities
    assert not [
        a for e in entities for a in e.attributes if a.kind == "state" and a.value in ("on", "door open", "off")
    ]


def test_a_chair_that_is_pulled_out_is_still_at_its_desk():
    (said,) = read_request("a study with a chair pulled out from the desk").relations
    assert (said.subject, said.type, said.targets) == ("chair", "at", ("desk",))
