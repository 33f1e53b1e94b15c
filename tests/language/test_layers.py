"""Each turn of speech that the reader knows, in sentences of our own: nouns, clauses, references, and their spans."""

from __future__ import annotations

import time

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules
from sceneweaver.language.spelling import mended


def counts(graph: SceneGraph) -> dict[str, tuple[int, int] | None]:
    return {e.id: e.count for e in graph.entities}


def said(graph: SceneGraph) -> set[tuple[str, ...]]:
    return {(r.subject, r.type, *r.targets) for r in graph.relations}


COUNTS = [
    ("a studio with dual monitors on a desk", "monitor", (2, 2)),
    ("a set of four stools around a bar table", "bar_stool", None),
    ("a trio of vases on the sideboard", "vase", (3, 3)),
    ("a shelf with a stack of three books", "book", (3, 3)),
    ("a pair of headphones on the desk", "headphones", (1, 1)),
    ("a desk with notebooks", "notebook", (2, 6)),
    ("a plant in each corner of the room", "potted_plant", (4, 4)),
    ("both armchairs face the sofa", "armchair", (2, 2)),
    ("a kitchen with a table, four chairs and one stool", "stool", (1, 1)),
    ("three benches stand along the wall", "bench", (3, 3)),
    ("a shelf holds two teddy bears and a ball", "teddy_bear", (2, 2)),
    ("a desk with a 35 mm camera", "camera", (1, 1)),
    ("a bathroom with two sinks and a mirror", "sink_cabinet", (2, 2)),
    ("three tubs of paint on a shelf", "paint_jar", (3, 3)),
    ("a tray with a tea set of four cups", "cup_and_saucer", (4, 4)),
    ("a dining table surrounded by eight upholstered chairs", "dining_chair", (8, 8)),
]

RELATIONS = [
    ("On the desk sits a laptop.", ("laptop", "on", "desk")),
    ("On the desk sit a laptop, a mug and a book.", ("book", "on", "desk")),
    ("The sideboard holds a vase and a clock.", ("vase", "on", "sideboard")),
    ("A bookcase displaying three trophies", ("trophy", "inside", "bookcase")),
    ("A basket filled with apples", ("apple", "inside", "basket")),
    ("A sofa flanked by two floor lamps", ("floor_lamp", "flanking", "sofa")),
    ("Two floor lamps flank the sofa.", ("floor_lamp", "flanking", "sofa")),
    ("A table surrounded by six chairs", ("chair", "around", "dining_table")),
    ("A dresser topped with a mirror and a vase", ("vase", "on", "dresser")),
    ("An armchair faces the fireplace.", ("armchair", "facing", "fireplace")),
    ("A bench occupies the corner.", ("bench", "at", "corner")),
    ("A bookcase lines the back wall.", ("bookcase", "along", "wall:far")),
    ("A desk with a lamp on top and a rug underneath", ("rug", "below", "desk")),
    ("A bed stands against the wall. Beside it, a bench.", ("bench", "next_to", "bed")),
    ("A bed, with a bench at its foot", ("bench", "at_foot", "bed")),
    ("A sofa faces the TV. To its left stands a plant.", ("potted_plant", "left_of", "sofa")),
    ("A table with four chairs, two on each long side", ("chair", "along", "dining_table")),
    ("A desk stands by the door. Its top carries a globe.", ("desk_globe", "on", "desk")),
    ("A vanity is under the window. A candle rests on the countertop.", ("candle", "on", "vanity")),
    ("A bed, a desk and a sofa facing them", ("sofa", "facing", "bed")),
    ("A rug in the center of the room", ("rug", "at", "middle")),
    ("A table with a vase in the center", ("vase", "centered_on", "dining_table")),
    ("A wardrobe stands against the opposite wall of a bedroom with a bed.", ("wardrobe", "against", "wall:far")),
    ("A bed is by the door. Across the room stands a wardrobe.", ("wardrobe", "opposite", "bed")),
    ("A lamp hangs from the ceiling above a table.", ("pendant", "above", "dining_table")),
    ("A mirror leans against the wall.", ("wall_mirror", "leaning_on", "wall")),
    ("A desk holds a monitor with a keyboard in front of it.", ("keyboard", "in_front_of", "monitor")),
    ("A desk holds a monitor with a keyboard in front of it.", ("keyboard", "on", "desk")),
    ("A stool that stands beside the piano", ("stool", "next_to", "upright_piano")),
    ("A bookcase next to a desk against the wall", ("bookcase", "against", "wall")),
    ("A bench faces a bookcase set against the left wall.", ("bookcase", "against", "wall:left")),
    ("A wall-mounted cabinet above a toilet", ("wall_cabinet", "on", "wall")),
    ("A bedroom centered on a bed flanked by two lamps", ("bed", "at", "middle")),
    ("Three wardrobes lined the left wall.", ("wardrobe", "along", "wall:left")),
    ("An office chair faces a desk, and a floor lamp stands nearby.", ("floor_lamp", "near", "desk")),
    ("On the table, a bowl stands beside a mug, and a candle is by the mug.", ("candle", "on", "dining_table")),
    ("A toy chest sits open to reveal two balls.", ("ball", "inside", "toy_chest")),
    ("A desk with a laptop on it and a lamp beside it", ("table_lamp", "next_to", "laptop")),
    ("A cutting board with a knife on top lies on a table.", ("knife", "on", "cutting_board")),
    ("Light falls through the window onto a bench, and beside it stands a plant.", ("bench", "near", "window")),
    ("A tapestry is fixed to the wall above a trunk.", ("tapestry", "on", "wall")),
    ("A desk in the far left corner of the room", ("desk", "at", "corner:far+left")),
    ("A wardrobe stands between the window and the door.", ("wardrobe", "near", "door")),
    ("There's a bed in the middle, and at its foot a chest.", ("chest", "at_foot", "bed")),
    ("Four bean bags form a circle on a rug.", ("bean_bag", "on", "rug")),
    ("A desk with a monitor with a keyboard and a mouse in front", ("keyboard", "in_front_of", "monitor")),
    ("A desk with a monitor with a keyboard and a mouse in front", ("mouse", "in_front_of", "monitor")),
    ("A tablet lies on a desk, a lamp to the right of it, a book to its left.", ("book", "left_of", "tablet")),
    ("A desk with a laptop at its center and a lamp to its left", ("table_lamp", "left_of", "laptop")),
    (
        "A room with a glass-topped round table and a wooden desk. The glass table holds a vase.",
        ("vase", "on", "round_dining_table"),
    ),
    (
        "A desk stands by the door. A lamp hangs above a dining table. On the tabletop lies a book.",
        ("book", "on", "dining_table"),
    ),
    (
        "A cabinet stands by the door. A bathtub fills a corner, its ledge decorated with candles.",
        ("candle", "on", "bathtub"),
    ),
    ("Light falls through a tall window onto a desk placed beneath it.", ("desk", "below", "window")),
    ("Three candles stand on the floor beside the bathtub.", ("candle", "on", "floor")),
]


@pytest.mark.parametrize(("text", "name", "count"), COUNTS, ids=[t for t, _, _ in COUNTS])
def test_counts(text: str, name: str, count: tuple[int, int] | None) -> None:
    found = counts(read_by_rules(text))
    assert (found[name] if count is not None else sum(c[0] for c in found.values() if c and c[0] > 1)) == (count or 4)


@pytest.mark.parametrize(("text", "relation"), RELATIONS, ids=[f"{t} {r[0]}" for t, r in RELATIONS])
def test_relations(text: str, relation: tuple[str, ...]) -> None:
    assert relation in said(read_by_rules(text))


def test_one_and_the_other_are_two_entities() -> None:
    graph = read_by_rules("Two armchairs: one stands by the window, the other next to the door.")
    assert counts(graph) == {"armchair": (1, 1), "armchair-2": (1, 1)}
    assert {("armchair", "at", "window"), ("armchair-2", "next_to", "door")} <= said(graph)


def test_sides_have_counts_of_their_own() -> None:
    graph = read_by_rules("A long table with eight chairs, four on each long side")
    (row,) = (r for r in graph.relations if r.type == "along")
    assert (row.count, row.each, row.side) == ((4, 4), True, "long")
    assert counts(graph)["chair"] == (8, 8)


def test_several_rooms() -> None:
    graph = read_by_rules("A living room with a sofa, and a kitchen with a stove")
    assert (graph.room_type, graph.other_rooms) == ("living_room", ("kitchen",))


def test_what_must_not_be_there() -> None:
    graph = read_by_rules("A study with a desk but no chair, and without curtains")
    assert {"chair_group", "curtain"} & set(graph.without) and "desk" in counts(graph)
    assert all(e.span is not None for e in graph.exclusions)


def test_spans_are_those_of_the_request() -> None:
    text = "A Bedroom — with a tall OAK wardrobe  next to the  window"
    graph = read_by_rules(text)
    (wardrobe,) = graph.entities
    assert wardrobe.span is not None
    assert text[slice(*wardrobe.span)] == "a tall OAK wardrobe"
    assert {text[slice(*a.span)] for a in wardrobe.attributes if a.span} == {"tall", "OAK"}
    (relation,) = graph.relations
    assert relation.span is not None
    assert text[slice(*relation.span)] == "next to"


def test_parts_are_said_of_what_has_them() -> None:
    graph = read_by_rules("a bed with a tufted headboard and a dresser with six drawers")
    assert set(counts(graph)) == {"bed", "dresser"}
    parts = {e.id: [a.value for a in e.attributes if a.kind == "part"] for e in graph.entities}
    assert "headboard" in parts["bed"] and "drawers" in parts["dresser"]
    assert set(counts(read_by_rules("a vanity with an integrated basin"))) == {"vanity"}
    assert set(counts(read_by_rules("a shelf with two photo frames with color prints"))) == {
        "wall_shelf",
        "photo_frames",
    }


def test_colors_of_a_thing_are_no_place() -> None:
    graph = read_by_rules("A board stands by the wall, beside two bean bags in lime green and violet.")
    assert not any(r.subject == "bean_bag" for r in graph.relations)


def test_matching_things_look_alike() -> None:
    graph = read_by_rules("a white oak desk with a matching chair")
    chair = graph.entity("chair")
    assert chair is not None and (chair.color, chair.material) == (graph.entities[0].color, graph.entities[0].material)


@pytest.mark.parametrize(
    "word", ["dressed", "cartoon", "carton", "plaster", "pulses", "printed", "benched", "cabinetry"]
)
def test_real_words_stay(word: str) -> None:
    assert mended(word, []) is None


@pytest.mark.parametrize(
    ("word", "meant"), [("wardrope", "wardrobe"), ("matress", "mattress"), ("nighstand", "nightstand")]
)
def test_slips_are_mended(word: str, meant: str) -> None:
    notes: list[str] = []
    assert mended(word, notes) == meant
    assert notes


def test_time_grows_with_the_text_only() -> None:
    sentence = "A desk stands by the window with a lamp on it, and a zebrine chair faces it. "
    read_by_rules(sentence)

    def seconds(times: int) -> float:
        start = time.process_time()
        read_by_rules(sentence * times)
        return time.process_time() - start

    short = min(seconds(10) for _ in range(3))
    assert min(seconds(80) for _ in range(2)) < 40 * short


def test_what_flanks_a_thing_without_a_number_is_a_pair() -> None:
    graph = read_by_rules("a study with a fireplace and tall bookshelves on either side of it")
    assert {e.category: e.count for e in graph.entities}["bookcase"] == (2, 2)


def test_several_things_hold_in_the_base_form() -> None:
    graph = read_by_rules("A study. Open shelves against the far wall hold folded towels and six vases.")
    assert {e.category: e.count for e in graph.entities}["vase"] == (6, 6)
    assert {(r.type, r.targets) for r in graph.relations} >= {("against", ("wall:far",))}
    assert not graph.unread
