"""States of things: which thing, which words, of how many."""

import pytest

from sceneweaver.language.read import read_by_rules

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
    graph = read_by_rules(text)
    (entity,) = [e for e in graph.entities if e.category == category]
    assert [(a.value, a.count) for a in entity.attributes if a.kind == "state"] == [wanted]
    assert not graph.unread


@pytest.mark.parametrize(
    "text", ["a den with a lamp on the desk", "a hall with open shelves", "a den, a rug on the floor"]
)
def test_places_and_kinds_are_no_states(text):
    entities = read_by_rules(text).entities
    assert not [
        a for e in entities for a in e.attributes if a.kind == "state" and a.value in ("on", "door open", "off")
    ]


def test_a_chair_that_is_pulled_out_is_still_at_its_desk():
    (said,) = read_by_rules("a study with a chair pulled out from the desk").relations
    assert (said.subject, said.type, said.targets) == ("chair", "at", ("desk",))


@pytest.mark.parametrize(
    ("request_", "category"),
    [
        ("A blanket lies crumpled on the bench.", "crumpled_cloth"),
        ("Shirts scattered on the bed.", "scattered_clothes"),
        ("Clothes all over the floor.", "scattered_clothes"),
        ("The newspaper on the stool is open.", "open_newspaper"),
        ("A jigsaw, half finished, on the desk.", "jigsaw_begun"),
        ("A map lies half unrolled on the desk.", "table_map"),
        ("A coat is slung over the back of the chair.", "draped_jacket"),
        ("A chair with a jacket over its back.", "draped_jacket"),
    ],
)
def test_what_is_another_thing_in_a_state_becomes_it(request_, category):
    assert category in {entity.category for entity in read_by_rules(request_).entities}


@pytest.mark.parametrize(
    ("request_", "category", "value"),
    [
        ("The vase is cracked.", "vase", "cracked"),
        ("A worn velvet armchair.", "armchair", "worn"),
        ("The sofa is covered with a dust sheet.", "sofa", "covered with a dust sheet"),
        ("The candle has burnt halfway down.", "candle", "burnt halfway down"),
        ("A mug of tea on the stool.", "mug", "full"),
        ("One drawer of the dresser is pulled out.", "dresser", "drawer pulled out"),
        ("A mirror over the dresser. The top drawer of the dresser is open.", "dresser", "drawer open"),
    ],
)
def test_states_are_told_of_the_thing_that_can_be_in_them(request_, category, value):
    graph = read_by_rules(request_)
    found = {a.value for e in graph.entities if e.category == category for a in e.attributes if a.kind == "state"}
    assert value in found
    assert not graph.unread


def test_a_table_that_is_laid_has_a_place_for_each():
    graph = read_by_rules("The dining table is set for six.")
    places = next(entity for entity in graph.entities if entity.category == "place_setting")
    assert places.count == (6, 6)
    assert [(r.type, r.subject) for r in graph.relations] == [("on", places.id)]
    lamp = read_by_rules("A lamp is set for six on the desk.")
    assert "place_setting" not in {entity.category for entity in lamp.entities}


def test_few_patches_of_leaves_are_all_over_a_floor():
    (leaves,) = read_by_rules("Dead leaves all over the floor.").entities
    assert leaves.category == "dead_leaves"
    assert leaves.count is not None and leaves.count[0] < 6
