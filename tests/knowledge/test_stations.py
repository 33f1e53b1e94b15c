"""Which side of a desk a seat is at, and what each of several things has for its own."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.knowledge.belongings import place_with
from sceneweaver.knowledge.desk_sides import OWNER, VISITOR, desk_side
from sceneweaver.knowledge.stations import own_on_floor, own_on_wall
from sceneweaver.language import Entity, SceneGraph, StatedRelation


def graph(*relations: tuple[Any, str, str], each: bool = False, **counts: Any) -> SceneGraph:
    entities = tuple(Entity(id=name, noun=name, category=name, count=(n, n)) for name, n in counts.items())
    stated = tuple(StatedRelation(type=kind, subject=a, targets=(b,), each=each) for kind, a, b in relations)
    return SceneGraph(text="", entities=entities, relations=stated)


@pytest.mark.parametrize(
    ("relations", "counts", "side"),
    [
        ([("behind", "chair", "desk")], {"chair": 1, "desk": 1}, OWNER),
        ([("in_front_of", "chair", "desk")], {"chair": 1, "desk": 1}, OWNER),
        ([("in_front_of", "chair", "desk")], {"chair": 2, "desk": 1}, VISITOR),
        ([("facing", "chair", "desk"), ("behind", "stool", "desk")], {"chair": 1, "stool": 1, "desk": 1}, VISITOR),
        ([("behind", "chair", "sofa")], {"chair": 1, "sofa": 1}, None),
        ([("behind", "chair", "reception_desk")], {"chair": 1, "reception_desk": 1}, None),
        ([("behind", "plant_stand", "desk")], {"plant_stand": 1, "desk": 1}, None),
    ],
)
def test_sides_of_desks(relations: list[tuple[str, str, str]], counts: dict[str, Any], side: str | None) -> None:
    brief = graph(*relations, **counts)
    found = desk_side(brief.relations[0], brief)
    assert (found.side if found is not None else None) == side


def test_pairs_stand_as_the_rooms_have_them():
    assert [p.type for p in place_with("stool", "easel")] == ["front_to_front"]
    assert [p.type for p in place_with("dialysis_machine", "donor_chair")] == ["side_by_side"]
    assert place_with("easel", "wardrobe") == ()


def test_own_things_are_those_that_each_has():
    brief = graph(("near", "stool", "pottery_wheel"), each=True, stool=2, pottery_wheel=2)
    pair = own_on_floor(brief.relations[0], brief)
    assert pair is not None and (pair.one, pair.other, pair.frontal) == ("stool", "pottery_wheel", True)
    assert own_on_floor(graph(("near", "stool", "pottery_wheel"), stool=2, pottery_wheel=2).relations[0], brief) is None
    tables = graph(("near", "chair", "dining_table"), each=True, chair=2, dining_table=2)
    assert own_on_floor(tables.relations[0], tables) is None  # they have places there
    mirrors = graph(("in_front_of", "wall_mirror", "barber_chair"), each=True, wall_mirror=2, barber_chair=2)
    station = own_on_wall(mirrors.relations[0], mirrors)
    assert station is not None and tuple(station) == ("barber_chair", "wall_mirror")
    pictures = graph(("above", "picture", "armchair"), each=True, picture=2, armchair=2)
    assert own_on_wall(pictures.relations[0], pictures) is None
