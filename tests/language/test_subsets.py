"""Some of several things: one by its place in a row, one and the other, each of them, half of them."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


def _related(text: str) -> list[tuple[str, str, tuple[str, ...], int]]:
    return [(r.type, r.subject, r.targets, r.nth) for r in read_by_rules(text).relations if not r.implied]


@pytest.mark.parametrize(
    ("text", "nth"),
    [
        ("a hall with six hooks, a raincoat hanging from the fourth", 4),
        ("a hall with six hooks. A raincoat hangs from the last hook.", -1),
        ("a gym with five mats, a ball on the middle one", 3),
    ],
)
def test_one_of_a_row_is_meant_by_its_place(text, nth):
    graph = read_by_rules(text)
    assert [e.count for e in graph.entities][0] in ((6, 6), (5, 5))
    assert [said[3] for said in _related(text)] == [nth]
    assert not graph.unread


def test_of_two_things_each_is_one_of_its_own():
    graph = read_by_rules("Two beds, a book on the first, a doll on the second.")
    assert [e.count for e in graph.entities if e.category == "bed"] == [(1, 1), (1, 1)]
    assert {r.targets for r in graph.relations} == {("bed",), ("bed-2",)}
    assert all(r.nth == 0 for r in graph.relations)


def test_one_of_a_row_comes_with_something():
    graph = read_by_rules("A yard with four benches. A towel on each, the third with a ball too.")
    assert [(e.category, e.count) for e in graph.entities if e.category in ("ball", "folded_towel")] == [
        ("folded_towel", (4, 4)),
        ("ball", (1, 1)),
    ]
    assert 3 in [r.nth for r in graph.relations]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Two tables, one round, the other black.", {(1, "round"), (1, "black")}),
        ("Five stools, two white, the others black.", {(2, "white"), (3, "black")}),
        ("Six chairs, one broken.", {(1, "broken"), (5, "")}),
    ],
)
def test_words_of_quality_are_said_of_some(text, said):
    graph = read_by_rules(text)
    found = {(e.count[0], e.attributes[0].words if e.attributes else "") for e in graph.entities if e.count}
    assert found == said


def test_words_before_one_noun_are_not_said_of_what_was_named_before():
    graph = read_by_rules("Two chairs. One red, one yellow and one blue vase.")
    assert [e.count for e in graph.entities if e.category == "chair"] == [(2, 2)]


def test_each_means_what_was_parted_as_well():
    graph = read_by_rules("Four booths, one low. A towel in each booth.")
    assert sorted(e.count for e in graph.entities if e.category == "folded_towel") == [(1, 1), (3, 3)]


def test_people_who_share_a_room_have_each_their_own():
    graph = read_by_rules("Two sisters share this bedroom: a bed, a desk and a lamp each.")
    assert graph.people == 2
    assert {e.count for e in graph.entities} == {(2, 2)}
    assert not graph.unread


def test_a_bare_list_before_each_is_as_many_things():
    graph = read_by_rules("For two boys. Bed wardrobe lamp each.")
    assert {(e.category, e.count) for e in graph.entities} == {
        ("bed", (2, 2)),
        ("wardrobe", (2, 2)),
        ("table_lamp", (2, 2)),
    }


def test_small_things_own_no_furniture():
    graph = read_by_rules("A room for two boys. Four mugs on the floor. A bed, a desk and a wardrobe each.")
    assert [e.count for e in graph.entities if e.category in ("bed", "desk", "wardrobe")] == [(2, 2)] * 3


def test_what_one_is_of_may_be_named_after_it():
    graph = read_by_rules("A coat on the third of six hooks.")
    assert [(r.subject, r.targets, r.nth) for r in graph.relations] == [("apron", ("coat_hooks",), 3)]


def test_one_of_a_pair_is_on_its_side():
    graph = read_by_rules(
        "A bed with two nightstands, a lamp on the left nightstand and a book on the right nightstand."
    )
    said = {r.subject: (r.type, r.targets) for r in graph.relations}
    assert said["nightstand"] == ("left_of", ("bed",))
    assert said["table_lamp"] == ("on", ("nightstand",))
    assert said["book"] == ("on", ("nightstand-2",))


def test_which_one_a_superlative_means_is_told():
    graph = read_by_rules("Three cages, the largest by the window.")
    assert [r.subject for r in graph.relations] == ["bird_cage"]
    assert [e.count for e in graph.entities] == [(1, 1), (2, 2)]
    assert [u.words for u in graph.unread] == ["the largest"]


def test_all_but_one_are_told_of():
    assert "but one" in [u.words for u in read_by_rules("All the desks but one face the window.").unread]
