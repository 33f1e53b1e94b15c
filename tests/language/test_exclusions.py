"""What must not be there, or not in one place."""

from __future__ import annotations

import pytest

from sceneweaver.language.model import ANYTHING
from sceneweaver.language.read import read_by_rules

ELSEWHERE = [
    ("a den with a piano. The piano must not stand in front of the window.", "upright_piano", "in_front_of", "window"),
    ("don't put the bed near the door", "bed", "near", "door"),
    ("a hall with benches, not lined up along the wall", "bench", "along", "wall"),
    ("A study with a desk. The wardrobe should not be next to the desk.", "wardrobe", "next_to", "desk"),
]
BANNED_THERE = [
    ("a nursery with a crib, no shelves above the crib, a rug", "wall_shelf", "above", "crib"),
    ("a den with a desk and no lamp on the desk", "desk_lamp", "on", "desk"),
]


@pytest.mark.parametrize(("text", "subject", "relation", "target"), ELSEWHERE)
def test_what_must_not_be_in_one_place_is_wanted_elsewhere(text, subject, relation, target):
    graph = read_by_rules(text)
    assert graph.entity(subject) is not None
    assert graph.without == ()
    assert [(x.subject, x.relation, x.targets) for x in graph.exclusions] == [(subject, relation, (target,))]
    assert all(r.subject != subject for r in graph.relations)


@pytest.mark.parametrize(("text", "category", "relation", "target"), BANNED_THERE)
def test_what_is_banned_from_one_place_may_be_in_others(text, category, relation, target):
    graph = read_by_rules(text)
    assert graph.without == ()
    (found,) = graph.exclusions
    assert category in found.categories
    assert (found.subject, found.relation, found.targets) == ("", relation, (target,))


@pytest.mark.parametrize(
    ("text", "gone", "stays"),
    [
        ("a kitchen without cabinets", {"cabinet", "wall_cabinet", "kitchen_cabinet", "sink_cabinet"}, "shelving_unit"),
        ("an office without wall cabinets", {"wall_cabinet"}, "filing_cabinet"),
        ("a hall, no clocks", {"wall_clock", "table_clock"}, "picture"),
        ("a living room but not a sofa", {"sofa", "sectional_sofa"}, "armchair"),
    ],
)
def test_a_plain_noun_rules_out_all_that_bears_its_name(text, gone, stays):
    without = set(read_by_rules(text).without)
    assert gone <= without
    assert stays not in without


@pytest.mark.parametrize("text", ["a playroom, loud but not sad", "a hall with stools, no stool on one side"])
def test_what_rules_out_no_thing_rules_out_nothing(text):
    graph = read_by_rules(text)
    assert graph.exclusions == ()
    assert graph.unread


@pytest.mark.parametrize(
    ("text", "only"),
    [
        ("a bedroom with only a bed and a desk", True),
        ("a den with a sofa and a table, but only two chairs", False),
        ("a hall with a bench. The stool is the only seat.", False),
        ("a vault with a safe, otherwise empty", True),
    ],
)
def test_only_is_said_of_the_room_where_nothing_was_named(text, only):
    assert read_by_rules(text).only is only


@pytest.mark.parametrize(
    ("text", "gone", "stays"),
    [
        ("a reading room with carrels, no computers please", {"laptop", "computer", "monitor"}, {"desk_lamp"}),
        ("an exam hall without any electronics", {"laptop", "tv", "phone", "speaker"}, {"typewriter", "tripod"}),
        ("a games cellar, without screens of whatever sort", {"tv", "arcade_machine", "laptop"}, {"room_divider"}),
        ("a corridor with no carpets", {"rug", "runner_rug"}, {"table_runner"}),
        ("a chapel without seating", {"chair", "bench", "sofa"}, {"altar"}),
        ("a cell with nothing breakable", {"vase", "drinking_glass", "mug"}, {"bed"}),
        ("a nursery with no sharp corners", {"coffee_table"}, {"round_coffee_table", "knife"}),
        ("a loft with nothing on the walls", {"picture", "wall_clock", "neon_sign"}, {"curtain", "radiator"}),
    ],
)
def test_classes_properties_and_places_rule_out_their_kinds(text, gone, stays):
    without = {*read_by_rules(text).without}
    assert gone <= without
    assert not stays & without


def test_materials_are_ruled_out_by_themselves_and_not_of_a_thing():
    (found,) = read_by_rules("a waiting room with six chairs and nothing made of glass").exclusions
    assert found.materials == ("glass",)
    assert {"wine_glass", "wall_mirror"} <= {*found.categories}
    graph = read_by_rules("a study, no glass table but a wooden table")
    assert graph.exclusions == ()
    assert [entity.noun for entity in graph.entities] == ["table"]


@pytest.mark.parametrize(
    ("text", "noun"),
    [
        ("a hostel kitchen with no appliances except a kettle", "kettle"),
        ("a chapel with nothing on the walls except one cross", "cross"),
        ("a study without plants, a cactus on the desk", "cactus"),
    ],
)
def test_what_is_named_for_itself_is_wanted(text, noun):
    graph = read_by_rules(text)
    (found,) = (entity for entity in graph.entities if entity.noun == noun)
    assert found.category not in graph.without
    assert len(graph.without) > 5


@pytest.mark.parametrize("words", ["no furniture", "no furniture but a bed", "nothing but a bed", "unfurnished"])
def test_a_room_without_furniture_gets_none(words):
    graph = read_by_rules(f"a bedroom, {words}")
    assert graph.only and len(graph.entities) == ("bed" in words.split())


def test_not_not_is_no_exclusion():
    graph = read_by_rules("a bedroom with not not a sofa")
    assert [entity.category for entity in graph.entities] == ["sofa"] and not graph.exclusions


@pytest.mark.parametrize(
    ("text", "relation", "target", "there"),
    [
        ("a shop with a counter, nothing on it except a bell", "on", "shop_counter", ["bell"]),
        ("nothing on the desk but a lamp", "on", "desk", ["table_lamp"]),
        ("a bench is bare apart from a lamp", "on", "bench", ["table_lamp"]),
        ("a bell on the counter, nothing else on it", "on", "kitchen_counter", ["bell"]),
        ("a study with a bookcase that holds nothing but books", "inside", "bookcase", ["book"]),
        ("a bedroom with a bed and nothing under it", "below", "bed", []),
        ("a hall with six lockers, a ball on the third, nothing on the others", "on", "locker", ["ball"]),
    ],
)
def test_nothing_is_to_be_somewhere_but_what_is_named_there(text, relation, target, there):
    graph = read_by_rules(text)
    (found,) = graph.exclusions
    assert (found.categories, found.relation, found.targets) == ((ANYTHING,), relation, (target,))
    assert [r.subject for r in graph.relations] == there
    assert not graph.only
    assert not graph.unread


def test_no_others_leaves_what_is_named():
    graph = read_by_rules("Two chairs. No other chairs. No other seating.")
    assert [e.category for e in graph.entities] == ["chair"]
    assert all(found.others and "chair" not in found.categories for found in graph.exclusions)


def test_a_list_is_ruled_out_where_its_last_words_say():
    graph = read_by_rules("Ten chairs in one row. No posters, plants or windows near the row.")
    assert [(x.relation, x.targets) for x in graph.exclusions] == [("near", ("chair",)), ("near", ("chair",))]
    assert graph.windows is None
    assert [u.words for u in graph.unread] == ["windows near the row"]


def test_a_limit_rules_out_nothing():
    graph = read_by_rules("a library with no shelf above 140 cm")
    assert not graph.exclusions
    assert [m.high for m in graph.measures] == [1.4]


def test_what_is_ruled_out_except_somewhere_is_there():
    graph = read_by_rules("No rugs except in front of the sofa.")
    assert [(r.type, r.subject, r.targets) for r in graph.relations] == [("in_front_of", "rug", ("sofa",))]
