"""Second mentions, what is said of things in clauses of their own, and slips of the pen: nothing is made twice."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules
from sceneweaver.language.spelling import mended


def named(text: str) -> dict[str, tuple[int, int] | None]:
    return {e.id: e.count for e in read_by_rules(text).entities}


def related(text: str) -> set[tuple[str, ...]]:
    return {(r.subject, r.type, *r.targets) for r in read_by_rules(text).relations}


SAID = [
    ("A den with a sofa, over it a clock, under it a basket.", ("basket", "below", "sofa")),
    ("Two stools and a bench between the two.", ("bench", "between", "stool", "stool")),
    ("A small cabinet and a big cabinet, the bigger one by the door.", ("cabinet-2", "near", "door")),
    ("Two desks, a bin beside each desk, a stool behind each", ("stool", "behind", "desk")),
    ("A table, a lamp above it and a rug under it.", ("rug", "below", "dining_table")),
    ("Two desks, each desk has a stool in front of it.", ("stool", "in_front_of", "desk")),
    ("Three lamps, the first on the desk, the third on the shelf.", ("table_lamp-2", "on", "wall_shelf")),
    ("A shower and a tub; the former in the corner.", ("shower", "at", "corner")),
    ("Bed, desk. Bed by the window. Desk opposite the bed.", ("desk", "opposite", "bed")),
    ("Two sofas facing each other with a coffee table in between.", ("coffee_table", "between", "sofa", "sofa-2")),
]


@pytest.mark.parametrize(("text", "relation"), SAID)
def test_what_was_named_is_meant(text, relation):
    assert relation in related(text)


@pytest.mark.parametrize(
    ("text", "color", "shape"),
    [
        ("A den with a coffee table by the sofa, the table is round and made of glass.", "glass", "round"),
        ("A hall with a table and a bench. It is made of dark oak.", "oak", None),
        ("A den with a bench and a plant, bench should be narrow and white.", "white", None),
        ("A rug under the desk, red and round.", "red", "round"),
    ],
)
def test_clauses_about_things_are_no_relations_and_no_bodies(text, color, shape):
    graph = read_by_rules(text)
    assert len(graph.entities) == 2
    assert {r.type for r in graph.relations} <= {"near", "next_to", "below"}
    values = {a.value for e in graph.entities for a in e.attributes} | {e.color for e in graph.entities}
    values |= {e.material for e in graph.entities}
    assert color in values and (shape is None or shape in values)
    assert not graph.colors


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("Meeting room with chairs x8, whiteboard x 1", {"chair": (8, 8), "whiteboard": (1, 1)}),
        ("A playroom with beanbags (4 pcs)", {"bean_bag": (4, 4)}),
        ("A den, chairs are black, four chairs", {"chair": (4, 4)}),
        ("A bistro with bar stools, five of them", {"bar_stool": (5, 5)}),
        ("Two chairs on each side of the desk", {"chair": (4, 4), "desk": None}),
        ("Two tables with three chairs on each side", {"dining_table": (2, 2), "chair": (12, 12)}),
        ("A nightstand on each side of the bed", {"nightstand": (2, 2), "bed": None}),
    ],
)
def test_numbers(text, counts):
    assert named(text) == counts


def test_what_can_be_seen_from_somewhere_hangs_from_nothing():
    graph = read_by_rules("An aquarium that is visible from the sofa.")
    assert not graph.relations
    assert any("visible" in u.words for u in graph.unread)


@pytest.mark.parametrize(
    ("slip", "meant"),
    [("undr", "under"), ("chiar", "chair"), ("miror", "mirror"), ("eachother", "each other"), ("deskk", "desk")],
)
def test_slips_of_common_words_are_mended_and_told(slip, meant):
    notes: list[str] = []
    assert mended(slip, notes) == meant
    assert notes == [f"'{slip}' was read as '{meant}'"]


@pytest.mark.parametrize("word", ["tale", "pants", "planets", "chai", "loving", "dinning", "zzyx"])
def test_words_of_their_own_stay(word):
    assert mended(word, []) is None


def test_slips_make_no_bodies():
    text = "a livingroom with two sofas facing eachother and a miror abov the firplace"
    graph = read_by_rules(text)
    assert not any(e.generic for e in graph.entities)
    assert graph.room_type == "living_room"
    assert ("wall_mirror", "above", "fireplace") in related(text)
    assert not graph.unread
