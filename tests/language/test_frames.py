"""Whose left and right, which wall, which corner, which end: places of the room as people name them."""

from __future__ import annotations

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules
from sceneweaver.language.wall_names import walls_meant
from sceneweaver.scene import Door, Room, Window


def said(graph: SceneGraph) -> set[tuple[str, str, str]]:
    return {(r.subject, r.type, t) for r in graph.relations for t in r.targets}


PLACED = [
    ("Hall: as you come in a bench is on the right", ("bench", "against", "wall:right")),
    ("Hall: as you come in a bench is on the right, a dresser on the left", ("dresser", "against", "wall:left")),
    ("when you enter through the front door there is a sofa straight ahead", ("sofa", "against", "wall:far")),
    ("A desk to the left of the door as you walk in", ("desk", "right_of", "door")),
    ("A desk to the left of the door", ("desk", "left_of", "door")),
    ("An attic with a bed on the left-hand side and a wardrobe on the right", ("wardrobe", "against", "wall:right")),
    ("A bed with a chair on the left", ("chair", "left_of", "bed")),
    ("A sideboard on the long wall", ("sideboard", "against", "wall:long")),
    ("A piano against the end wall", ("upright_piano", "against", "wall:short")),
    ("An aquarium at one end, a desk at the other end", ("desk", "against", "wall:short")),
    ("A dresser on the window side", ("dresser", "against", "wall:window")),
    ("A workbench at the back of the garage", ("workbench", "against", "wall:far")),
    ("A shop with a counter at the front and shelves at the back", ("shop_counter", "against", "wall:near")),
    ("A safe in the back left corner", ("safe", "at", "corner:far+left")),
    ("Two armchairs look out over the lake", ("armchair", "facing", "window")),
    ("A desk that looks out of the window", ("desk", "facing", "window")),
    ("A bicycle hanging on the wall", ("wall_bicycle", "hanging_from", "wall")),
    ("A basket undr the table", ("basket", "below", "dining_table")),
    ("Two chairs at the table", ("chair", "at", "dining_table")),
    ("A bedroom with a bed and a tapestry, a chest at the foot end", ("chest", "at_foot", "bed")),
]


@pytest.mark.parametrize(("text", "relation"), PLACED, ids=[text for text, _ in PLACED])
def test_places(text: str, relation: tuple[str, str, str]) -> None:
    assert relation in said(read_by_rules(text))


def test_what_is_said_of_who_comes_in_is_understood() -> None:
    graph = read_by_rules("A hall. When you come in there is a bench on the left and a mirror straight ahead.")
    assert graph.unread == ()


def test_facing_away_is_no_distance() -> None:
    graph = read_by_rules("The sofa faces away from the window")
    assert not graph.relations and graph.unread


def test_walls_by_length_side_and_opening() -> None:
    door = Door(id="d", wall=3, offset=1.0, width=0.9, height=2.0)  # in the wall x = 0 of 6 x 4 m
    window = Window(id="w", wall=0, offset=2.0, width=1.0, height=1.2, sill=0.9)
    room = Room(outline=((0, 0), (6, 0), (6, 4), (0, 4)), height=2.5, doors=(door,), windows=(window,))
    assert walls_meant("long", room) == [0, 2] and walls_meant("short", room) == [1, 3]
    assert walls_meant("left", room) == [2] and walls_meant("right", room) == [0]
    assert walls_meant("far", room) == [1] and sorted(walls_meant("side", room)) == [0, 2]
    assert walls_meant("window", room) == [0] and walls_meant("door", room) == [3]
    assert walls_meant("elsewhere", room) == []


NOT_OF_THE_LAST = [
    ("A den with a workbench and a board above the workbench, a flux jack under the workbench", "below"),
    ("A cabin with a bunk along the left wall, drawers under the bunk", "below"),
]


@pytest.mark.parametrize(("text", "kind"), NOT_OF_THE_LAST, ids=[text for text, _ in NOT_OF_THE_LAST])
def test_what_is_no_known_thing_hands_its_place_on_to_nothing(text: str, kind: str) -> None:
    graph = read_by_rules(text)
    known = {r.subject for r in graph.relations if r.type == kind}
    assert known.isdisjoint(e.id for e in graph.entities if not e.generic)


def test_the_other_side_of_it_is_of_the_same_thing() -> None:
    graph = read_by_rules("A lodge with a rack to the left of the fireplace, a basket to the right of it")
    assert ("basket", "right_of", "fireplace") in said(graph)


def test_what_is_behind_one_thing_is_no_second_target() -> None:
    graph = read_by_rules("The armchair faces the fireplace and there is a lamp behind the sofa")
    assert {r for r in said(graph) if r[1] == "facing"} == {("armchair", "facing", "fireplace")}


def test_beams_are_overhead_and_a_bar_of_a_pub_is_none() -> None:
    assert ("fern", "hanging_from", "ceiling") in said(read_by_rules("A greenhouse with ferns hanging from the bars"))
    assert ("hammock", "hanging_from", "ceiling") in said(read_by_rules("An attic, a hammock hanging from the beams"))
