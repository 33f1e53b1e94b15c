"""Realistic requests, short and long, and the fields that matter of what is read."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.knowledge import match_room
from sceneweaver.language import SceneGraph, meanings, read_request

FIELDS: list[tuple[str, dict[str, Any]]] = [
    ("12 ft by 10 ft bedroom", {"size": (3.6576, 3.048)}),
    ("a 15' x 12' living room", {"size": (4.572, 3.6576), "room_type": "living_room"}),
    ("a 5m x 4m x 2.7m bedroom", {"size": (5.0, 4.0), "height": 2.7}),
    ("bedroom measuring 5 m long and 4 m wide", {"size": (5.0, 4.0)}),
    ("a room 6 metres long by 4 metres wide", {"size": (6.0, 4.0)}),
    ("bedroom; ceiling 2.5 m; 4 x 3 m", {"size": (4.0, 3.0), "height": 2.5}),
    ("a 200 sq ft studio", {"room_type": "studio_apartment", "area": 200 * 0.3048**2}),
    ("a spacious living room (around 30 square metres)", {"area": 30.0, "scale": 1.3, "notes": ()}),
    ("a bed 2.1 m by 1.6 m in the bedroom", {"size": None}),
    ("a desk (140 x 70 cm) and a chair", {"size": None, "notes": ()}),
    ("meeting room with room for 4", {"people": 4}),
    ("a meeting room with room for 10 people", {"people": 10}),
    ("a dining room with a table for six", {"room_type": "dining_room", "people": 6}),
    ("a dining room with a table that seats eight", {"room_type": "dining_room", "people": 8}),
    ("a twin room", {"room_type": "bedroom", "people": 2}),
    ("kids room for twins", {"room_type": "childrens_room", "for_whom": ("kids", "twins")}),
    ("a bedroom for a teenage girl", {"for_whom": ("teenage girl",)}),
    ("a dining room", {"room_type": "dining_room", "unread": (), "notes": ()}),
    ("an office with no plants, two desks and a cabinet", {"without": ("plant_group",)}),
    ("a bedroom with a bed, a desk and no rug, curtains or plants", {"without": ("rug", "curtain", "plant_group")}),
    ("a living room without a TV, a rug or plants, but with a piano", {"without": ("tv", "rug", "plant_group")}),
    ("living room with neither a TV nor a rug", {"without": ("tv", "rug")}),
    ("living room, no tv, rug, or curtains.", {"without": ("tv", "rug", "curtain")}),
    ("a study without a TV. A desk by the window.", {"without": ("tv",)}),
    ("a minimalist bedroom. just a bed and a lamp. nothing else.", {"only": True, "density": "sparse"}),
    ("a sofa and a bed, and nothing else", {"only": True}),
    ("living room with two large windows", {"windows": 2, "scale": 1.0}),
    ("a living room with a sofa. It should be red.", {"colors": ()}),
    ("a room 3 m wide", {"room_type": None}),
    ("BEDROOM WITH TWO WINDOWS", {"windows": 2, "room_type": "bedroom"}),
    ("living room in grey", {"colors": ("grey",)}),
    ("living room in gray", {"colors": ("gray",)}),
    ("centre of the city bedroom with a colour TV", {"room_type": "bedroom"}),
]

COUNTS: list[tuple[str, dict[str, Any]]] = [
    ("a bed with a nightstand on either side", {"bed": (1, 1), "nightstand": (2, 2)}),
    ("a nightstand on each side of the bed", {"nightstand": (2, 2), "bed": None}),
    ("no more than 2 chairs", {"chair": (1, 2)}),
    ("several plants", {"potted_plant": (3, 5)}),
    ("at least 3 desks, fewer than 5 plants", {"desk": (3, 7), "potted_plant": (1, 4)}),
    ("a king-size bed and a queen size bed", {"king_bed": (1, 1), "bed": (1, 1)}),
    ("a single bed", {"single_bed": (1, 1)}),
    ("a single chair", {"chair": (1, 1)}),
    ("an office with no plants, two desks and a cabinet", {"desk": (2, 2), "cabinet": (1, 1)}),
    ("a living room without a TV, a rug or plants, but with a piano", {"upright_piano": (1, 1)}),
    ("open-plan office with 8 workstations", {"desk": (8, 8), "office_chair": (8, 8)}),
    (
        "living room with a dining area with a round table and six chairs",
        {"round_dining_table": (1, 1), "dining_chair": (6, 6)},
    ),
    ("Living room:\n- sofa\n- 2 armchairs\n- TV", {"sofa": None, "armchair": (2, 2), "tv": None}),
    ("* a grey sofa\n* a colour TV\n* gray rug", {"sofa": (1, 1), "tv": (1, 1), "rug": None}),
    ("a bedrooom with a wardrope and a matress", {"wardrobe": (1, 1), "mattress": (1, 1)}),
    ("a bedroom with two beds and a nightstand between the two beds", {"bed": (2, 2), "nightstand": (1, 1)}),
    ("a music room with 4 chairs, and a music stand in front of each chair", {"chair": (4, 4), "music_stand": (4, 4)}),
    ("a restaurant with 10 tables, 4 chairs at each table", {"dining_table": (10, 10), "chair": (40, 40)}),
    ("two sofas facing each other", {"sofa": (1, 1), "sofa-2": (1, 1)}),
    ("classroom with 24 desks in 4 rows, a teacher's desk", {"desk": (24, 24), "teacher_desk": (1, 1)}),
    ("bookshelf full of books", {"bookcase": None, "book": (2, 6)}),
    ("a table and six chairs, two of them at the window", {"dining_table": (1, 1), "chair": (2, 2), "chair-2": (4, 4)}),
    ("no rug, put a plant in the corner", {"potted_plant": (1, 1)}),
]


def over(subject: str, target: str) -> set[tuple[str, str, Any]]:
    """What hangs above something hangs at the wall right behind it."""
    return {("above", subject, target), ("near", subject, target)}


RELATIONS: list[tuple[str, set[tuple[str, str, Any]]]] = [
    ("a bed with a nightstand on either side", {("next_to", "nightstand", "bed")}),
    ("two bedside tables flanking a double bed", {("next_to", "nightstand", "bed")}),
    (
        "two armchairs and a side table by the window",
        {("at_window", "armchair", "window"), ("at_window", "side_table", "window")},
    ),
    ("a bed and a desk by the window", {("at_window", "desk", "window")}),
    ("a wardrobe, a bed and a desk by the window", {("at_window", "desk", "window")}),
    ("a desk with a lamp on it", {("on_top", "table_lamp", "desk")}),
    (
        "a bedroom with a desk with a lamp and a laptop on it",
        {("on_top", "table_lamp", "desk"), ("on_top", "laptop", "desk")},
    ),
    ("two sofas facing each other", {("facing", "sofa", "sofa-2"), ("facing", "sofa-2", "sofa")}),
    (
        "two desks facing each other and a plant in the corner",
        {("facing", "desk", "desk-2"), ("facing", "desk-2", "desk"), ("in_corner", "potted_plant", None)},
    ),
    ("two beds side by side", {("side_by_side", "bed", "bed-2")}),
    ("a nightstand between the two beds", {("between", "nightstand", ("bed", "bed"))}),
    ("two beds and a nightstand between the two beds", {("between", "nightstand", ("bed", "bed"))}),
    (
        "a bed against the left wall, a desk against the right wall and a wardrobe against the back wall",
        {
            ("against_wall", "bed", "wall:left"),
            ("against_wall", "desk", "wall:right"),
            ("against_wall", "wardrobe", "wall:far"),
        },
    ),
    ("a bookshelf against the wall", {("against_wall", "bookcase", None)}),
    ("a picture on the wall", {("against_wall", "picture", None)}),
    ("a clock on the wall above the desk", {("against_wall", "wall_clock", None), *over("wall_clock", "desk")}),
    (
        "a table in the middle of the room with four chairs around it",
        {("in_middle", "dining_table", "middle"), ("seated_at", "chair", "dining_table")},
    ),
    ("a rug under the table", {("over", "rug", "dining_table")}),
    (
        "a rug in the middle of the room, and some posters on the wall above the desk",
        {("in_middle", "rug", "middle"), ("against_wall", "poster", None), *over("poster", "desk")},
    ),
    (
        "a bed with a nightstand next to it, a white desk by the window",
        {("leftright_to_leftright", "nightstand", "bed"), ("at_window", "desk", "window")},
    ),
    (
        "a sofa opposite the door, a plant in the corner",
        {("near_door", "sofa", "door"), ("in_corner", "potted_plant", None)},
    ),
    (
        "standing desk, ergonomic chair, two monitors on the desk, printer on a cabinet",
        {("on_top", "monitor", "standing_desk"), ("on_top", "desk_printer", "cabinet")},
    ),
    ("a king-size bed. The bed should be by the window.", {("at_window", "king_bed", "window")}),
    ("A round coffee table. Two armchairs beside the coffee table.", {("near", "armchair", "round_coffee_table")}),
    (
        "24 desks in 4 rows, a teacher's desk in front of the whiteboard",
        {("in_front_of", "teacher_desk", "whiteboard")},
    ),
    (
        "a workbench on the right wall, gizmos hanging above it, and a bicycle",
        {("against_wall", "workbench", "wall:right")},
    ),
    ("a desk by the window and next to the wardrobe", {("at_window", "desk", "window"), ("near", "desk", "wardrobe")}),
    ("A bed and a wardrobe. Next to the bed stands a lamp.", {("near", "table_lamp", "bed")}),
    ("a chair at the desk", {("front_against", "chair", "desk")}),
    ("bookshelf full of books", {("inside", "book", "bookcase")}),
    ("a shelf with books and a vase on it", {("on_top", "book", "wall_shelf"), ("on_top", "vase", "wall_shelf")}),
    (
        "sink under the window; fridge next to the oven",
        {("at_window", "sink_cabinet", "window"), ("near", "fridge", "stove")},
    ),
]

LOOKS: list[tuple[str, str, dict[str, Any]]] = [
    ("a large, comfortable sofa", "sofa", {"scale": 1.2}),
    ("A living room with a sofa. It should be red.", "sofa", {"color": "red"}),
    ("The sofa is blue and the rug is white.", "rug", {"color": "white"}),
    (
        "a dark green velvet sofa, 2.2 m long",
        "sofa",
        {"color": "dark green", "material": "velvet", "size": (None, 2.2, None)},
    ),
    ("a walnut coffee table 1.2m x 0.6m", "coffee_table", {"material": "walnut", "size": (0.6, 1.2, None)}),
    ("a desk (140 x 70 cm)", "desk", {"size": (0.7, 1.4, None)}),
    ("a 160 x 80 cm desk", "desk", {"size": (0.8, 1.6, None)}),
    ("a bed 2.1 m by 1.6 m", "bed", {"size": (2.1, 1.6, None)}),
    ("a tall wardrobe", "wardrobe", {"scale": 1.2}),
    ("a grey sofa", "sofa", {"color": "grey"}),
]

NOTED: list[tuple[str, str]] = [
    ("a narrow kitchen", "narrow"),
    ("a long hallway", "long"),
    ("a bedrooom", "bedrooom"),
    ("a twin room", "bedroom"),
    ("a kitchen with three chairs. There are two chairs in the kitchen.", "3 and 2"),
    ("open-plan office with 8 workstations", "workstations"),
    ("a 4 x 5 m bedroom, 6 x 7 m", "other sides"),
    ("9 desks side by side", "side by side"),
    ("a 99999999999999 m2 room", "no number"),
]

UNREAD: list[tuple[str, str]] = [
    ("24 desks in 4 rows", "rows"),
    ("don't put the bed near the door", "not near the door"),
]

LONG = """I'd like a cosy Scandinavian bedroom for a teenage girl, roughly 4 m by 3.5 m with a 2.6 m ceiling. There
should be a single bed against the left wall with a nightstand next to it, a white desk by the window with an office
chair in front of it, and a tall wardrobe opposite the bed. Please add a rug in the middle of the room, and some posters
on the wall above the desk. No TV."""


@pytest.mark.parametrize(("text", "fields"), FIELDS, ids=[t for t, _ in FIELDS])
def test_fields(text: str, fields: dict[str, Any]) -> None:
    brief = read_request(text)
    for name, value in fields.items():
        found = getattr(brief, name)
        assert found == (pytest.approx(value) if name in ("size", "area", "height") and value else value), name


@pytest.mark.parametrize(("text", "counts"), COUNTS, ids=[t for t, _ in COUNTS])
def test_counts(text: str, counts: dict[str, Any]) -> None:
    assert {a.id: a.count for a in read_request(text).entities} == counts


def said(brief: SceneGraph) -> set[tuple[str, str, Any]]:
    return {(meant.type, r.subject, meant.target) for r, meant in meanings(brief)}


@pytest.mark.parametrize(("text", "expected"), RELATIONS, ids=[t for t, _ in RELATIONS])
def test_relations(text: str, expected: set[tuple[str, str, Any]]) -> None:
    assert said(read_request(text)) == expected


@pytest.mark.parametrize(("text", "object_id", "looks"), LOOKS, ids=[t for t, _, _ in LOOKS])
def test_looks(text: str, object_id: str, looks: dict[str, Any]) -> None:
    (asked,) = (a for a in read_request(text).entities if a.id == object_id)
    assert {name: getattr(asked, name) for name in looks} == looks


@pytest.mark.parametrize(("text", "word"), NOTED)
def test_noted(text: str, word: str) -> None:
    assert word in " ".join(read_request(text).notes)


@pytest.mark.parametrize(("text", "word"), UNREAD)
def test_unread(text: str, word: str) -> None:
    assert word in " ".join(word.words for word in read_request(text).unread)


def test_a_whole_paragraph() -> None:
    brief = read_request(LONG)
    assert (brief.room_type, brief.size, brief.height, brief.style) == ("bedroom", (4.0, 3.5), 2.6, "scandinavian")
    assert (brief.for_whom, brief.without, brief.unread) == (("teenage girl",), ("tv",), ())
    assert {a.id for a in brief.entities} == {
        "single_bed",
        "nightstand",
        "desk",
        "office_chair",
        "wardrobe",
        "rug",
        "poster",
    }
    assert said(brief) == {
        ("against_wall", "single_bed", "wall:left"),
        ("leftright_to_leftright", "nightstand", "single_bed"),
        ("at_window", "desk", "window"),
        ("front_to_front", "office_chair", "desk"),
        ("distance", "wardrobe", "single_bed"),
        ("in_middle", "rug", "middle"),
        ("against_wall", "poster", None),
        *over("poster", "desk"),
    }


@pytest.mark.parametrize("words", ["throne room", "escape room", "boiler room", "zorb room"])
def test_an_unknown_room_is_no_other_room(words: str) -> None:
    found = match_room(words)
    assert found is None or found[1] == 1.0, found
