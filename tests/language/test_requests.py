"""Requests as people write them, and what must be read of each."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.language import SceneGraph, meanings, read_request

ROOMS = {
    "bedroom": "bedroom",
    "Design me a bedroom": "bedroom",
    "BEDROOM PLEASE": "bedroom",
    "a bedrom": "bedroom",
    "a restarant": "restaurant",
    "living-room": "living_room",
    "a livingroom": "living_room",
    "kids room": "childrens_room",
    "a room for yoga, a yoga studio": "yoga_studio",
    "master bedroom": "bedroom",
    "please create a small kitchen for me": "kitchen",
    "I want a cafe with a counter": "cafe",
    "could you make me a meeting room?": "meeting_room",
    "doctor's office": "examination_room",
    "a waiting room\nwith chairs": "waiting_room",
    "a classrom for 20 pupils": "classroom",
    "a gym": "gym",
    "hotel room with a desk": "hotel_room",
    "<b>bathroom</b>": "bathroom",
    "an officee": "office",
    '{"room": "bedroom"}': "bedroom",
    "a server room": "server_room",
    "bedroom, 🛏️ and a desk": "bedroom",
    "an art studio with an easel": "art_studio",
    "hospital room": "hospital_room",
    "a public library": "library",
    "kitchen table in a living room": "living_room",
    "a dorm room for two students": "dormitory",
}

FIELDS: list[tuple[str, dict[str, Any]]] = [
    ("bedroom 4 by 5 m", {"size": (5.0, 4.0)}),
    ("a 4x5 metres bedroom", {"size": (5.0, 4.0)}),
    ("bedroom, 3.5 m x 4.2 m", {"size": (4.2, 3.5)}),
    ("bedroom of four by five metres", {"size": (5.0, 4.0)}),
    ("a 4x5 bedroom", {"size": (5.0, 4.0)}),
    ("a 12 ft by 10 ft office", {"size": (3.6576, 3.048)}),
    ("20 square metres living room", {"area": 20.0}),
    ("living room, 20 m2", {"area": 20.0}),
    ("a 20 sqm living room", {"area": 20.0}),
    ("a living room of 20 m²", {"area": 20.0}),
    ("an office of 25.5 sq m", {"area": 25.5}),
    ("bedroom with 3 m ceiling", {"height": 3.0}),
    ("bedroom with a ceiling height of 2.8 m", {"height": 2.8}),
    ("an L-shaped living room", {"shape": "L"}),
    ("a round restaurant", {"shape": "round"}),
    ("a long narrow office", {"shape": "rectangle"}),
    ("a huge living room", {"scale": 1.6}),
    ("a tiny bathroom", {"scale": 0.55}),
    ("a large kitchen", {"scale": 1.3}),
    ("office for four people", {"people": 4}),
    ("a small office for two", {"people": 2, "scale": 0.75, "room_type": "office"}),
    ("living room for a family of four", {"people": 4}),
    ("living room for a family of 5", {"people": 5}),
    ("twin room with a wardrobe", {"people": 2}),
    ("a meeting room that seats eight", {"people": 8}),
    ("restaurant for 12 guests", {"people": 12}),
    ("bedroom for a couple", {"people": 2, "for_whom": ("couple",)}),
    ("a bedroom for a teenager", {"for_whom": ("teenager",)}),
    ("a modern office", {"style": "modern"}),
    ("a cosy scandinavian bedroom in white and sage", {"style": "scandinavian", "colors": ("white", "sage")}),
    ("an industrial living room", {"style": "industrial"}),
    ("a rustic kitchen", {"style": "rustic"}),
    ("a minimal bedroom", {"density": "sparse"}),
    ("a cluttered office", {"density": "full"}),
    ("a fully furnished living room", {"density": "full"}),
    ("a lived-in living room", {"density": "full"}),
    ("bedroom with two windows", {"windows": 2}),
    ("bathroom with no windows", {"windows": 0}),
    ("office with two doors", {"doors": 2}),
    ("a bedroom with a window", {"windows": 1}),
    ("only a bed and a desk in the bedroom", {"only": True}),
    ("bedroom with a bed and nothing else", {"only": True}),
    ("living room with no TV", {"without": ("tv",)}),
    ("bedroom without curtains", {"without": ("curtain",)}),
    ("don't put plants in the living room", {"without": ("plant_group",), "room_type": "living_room"}),
    ("a bedroom without curtains and rugs", {"without": ("curtain", "rug")}),
    ("a living room with a desk but not a sofa", {"without": ("sofa",)}),
    ("a sofa, no TV, and a desk", {"without": ("tv",)}),
    ("no TV or computer", {"without": ("tv", "computer")}),
    ("don't put the bed near the door", {"without": (), "doors": None}),
    ("bedroom in blue with white furniture", {"entities": (), "colors": ("blue", "white")}),
]

COUNTS: list[tuple[str, dict[str, tuple[int, int] | None]]] = [
    ("bedroom with two nightstands", {"nightstand": (2, 2)}),
    ("a dozen chairs", {"chair": (12, 12)}),
    ("half a dozen chairs", {"chair": (6, 6)}),
    ("a couple of armchairs", {"armchair": (2, 2)}),
    ("a pair of armchairs", {"armchair": (2, 2)}),
    ("up to 4 chairs", {"chair": (1, 4)}),
    ("no more than 2 chairs", {"chair": (1, 2)}),
    ("3-4 chairs", {"chair": (3, 4)}),
    ("3 to 4 chairs", {"chair": (3, 4)}),
    ("twenty-five chairs", {"chair": (25, 25)}),
    ("12 chairs and one desk", {"chair": (12, 12), "desk": (1, 1)}),
    ("chairs", {"chair": (2, 6)}),
    ("a bed, a desk, and a chair", {"bed": (1, 1), "desk": (1, 1), "chair": (1, 1)}),
    ("- bed\n- desk\n- chair", {"bed": None, "desk": None, "chair": None}),
    ("two desks, each with a lamp", {"desk": (2, 2), "table_lamp": (2, 2)}),
    ("ten tables and 4 chairs around each table", {"dining_table": (10, 10), "chair": (40, 40)}),
    ("king-size bed", {"king_bed": None}),
    ("a bookcase and two armchairs", {"bookcase": (1, 1), "armchair": (2, 2)}),
    ("A BED AND A WARDROBE", {"bed": (1, 1), "wardrobe": (1, 1)}),
    ("a wardrob and a nighstand", {"wardrobe": (1, 1), "nightstand": (1, 1)}),
    ("coffee table, tv stand", {"coffee_table": None, "tv_stand": None}),
    ("a bedside table", {"nightstand": (1, 1)}),
    ("a television and a couch", {"tv": (1, 1), "sofa": (1, 1)}),
    ("a reading corner in the living room", {"armchair": (1, 1), "floor_lamp": (1, 1), "bookcase": (1, 1)}),
    ("a living room with a dining area", {"dining_table": (1, 1), "dining_chair": (2, 6)}),
    ("living room with a view", {}),
    ("bedroom", {}),
]

RELATIONS: list[tuple[str, set[tuple[str, str, Any]]]] = [
    (
        "a reading nook with a big armchair and many books",
        {("distance", "floor_lamp", "armchair"), ("distance", "bookcase", "armchair"), ("inside", "book", "bookcase")},
    ),
    ("two nightstands beside the bed", {("leftright_to_leftright", "nightstand", "bed")}),
    ("two nightstands on either side of the bed", {("next_to", "nightstand", "bed")}),
    ("a bed with two nightstands on either side of it", {("next_to", "nightstand", "bed")}),
    ("a floor lamp next to the sofa", {("near", "floor_lamp", "sofa")}),
    ("a coffee table in front of the sofa", {("in_front_of", "coffee_table", "sofa")}),
    ("a console table behind the sofa", {("behind", "console_table", "sofa")}),
    ("a floor lamp to the left of the sofa", {("right_of", "floor_lamp", "sofa")}),
    ("a floor lamp to the right of the sofa", {("left_of", "floor_lamp", "sofa")}),
    ("a side table between the sofa and the armchair", {("between", "side_table", ("sofa", "armchair"))}),
    ("a wardrobe against the wall", {("against_wall", "wardrobe", None)}),
    ("a wardrobe against the left wall", {("against_wall", "wardrobe", "wall:left")}),
    ("a bed against the far wall", {("against_wall", "bed", "wall:far")}),
    ("a bed on the north wall", {("against_wall", "bed", "wall:north")}),
    ("a desk by the window", {("at_window", "desk", "window")}),
    ("a desk under the window", {("at_window", "desk", "window")}),
    ("with a desk near the window", {("near_window", "desk", "window")}),
    ("an armchair in the corner", {("in_corner", "armchair", None)}),
    ("a laptop on the desk", {("on_top", "laptop", "desk")}),
    ("on the desk a laptop", {("on_top", "laptop", "desk")}),
    ("on the desk a lamp and a laptop", {("on_top", "table_lamp", "desk"), ("on_top", "laptop", "desk")}),
    ("a book inside the cabinet", {("inside", "book", "cabinet")}),
    ("a picture above the sofa", {("above", "picture", "sofa"), ("near", "picture", "sofa")}),
    ("a sofa facing the TV", {("facing", "sofa", "tv")}),
    ("a sofa opposite the fireplace", {("distance", "sofa", "fireplace")}),
    ("a bed away from the door", {("away_from_door", "bed", None)}),
    ("a round table in the middle of the room", {("in_middle", "round_dining_table", "middle")}),
    (
        "a desk by the window and a chair in front of it",
        {("at_window", "desk", "window"), ("front_to_front", "chair", "desk")},
    ),
    ("a bed. The bed should be by the window.", {("at_window", "bed", "window")}),
    (
        "a wardrobe against the left wall and a desk on the right wall",
        {("against_wall", "wardrobe", "wall:left"), ("against_wall", "desk", "wall:right")},
    ),
    ("two desks, each with a lamp", {("on_top", "table_lamp", "desk")}),
    ("a plant on the shelf", {("on_top", "small_plant", "wall_shelf")}),
    ("six chairs around the dining table", {("seated_at", "chair", "dining_table")}),
]

LOOKS: list[tuple[str, str, dict[str, Any]]] = [
    ("a red leather armchair", "armchair", {"color": "red", "material": "leather"}),
    ("a large oak desk", "desk", {"scale": 1.2, "material": "oak"}),
    ("a small desk", "desk", {"scale": 0.8}),
    ("a wooden desk", "desk", {"material": "wood"}),
    ("a 1.6 m wide oak desk", "desk", {"size": (None, 1.6, None), "material": "oak"}),
    ("a 160 cm wide desk", "desk", {"size": (None, 1.6, None)}),
    ("a black office chair", "office_chair", {"color": "black"}),
    ("a modern sofa", "sofa", {"style": "modern"}),
    ("a blue velvet sofa", "sofa", {"color": "blue", "material": "velvet"}),
]


@pytest.mark.parametrize("text", ROOMS)
def test_room(text: str) -> None:
    assert read_request(text).room_type == ROOMS[text]


@pytest.mark.parametrize(("text", "fields"), FIELDS, ids=[t for t, _ in FIELDS])
def test_fields(text: str, fields: dict[str, Any]) -> None:
    brief = read_request(text)
    for name, value in fields.items():
        assert getattr(brief, name) == value, name


@pytest.mark.parametrize(("text", "counts"), COUNTS, ids=[t for t, _ in COUNTS])
def test_counts(text: str, counts: dict[str, Any]) -> None:
    assert {a.id: a.count for a in read_request(text).entities} == counts


@pytest.mark.parametrize(("text", "said"), RELATIONS, ids=[t for t, _ in RELATIONS])
def test_relations(text: str, said: set) -> None:
    brief = read_request(text)
    assert {(meant.type, r.subject, meant.target) for r, meant in meanings(brief)} == said
    assert _consistent(brief)


@pytest.mark.parametrize(("text", "object_id", "looks"), LOOKS, ids=[t for t, _, _ in LOOKS])
def test_looks(text: str, object_id: str, looks: dict[str, Any]) -> None:
    (asked,) = (a for a in read_request(text).entities if a.id == object_id)
    assert {name: getattr(asked, name) for name in looks} == looks


def _consistent(brief: SceneGraph) -> bool:
    """Whether every relation names things that are asked for, or places."""
    known = {a.id for a in brief.entities} | {"window", "door", "middle", "corner", "wall"}
    names = [n for r in brief.relations for n in r.targets]
    return all(n in known or n.startswith("wall:") for n in names) and {r.subject for r in brief.relations} <= known
