"""Stated relations between objects: which of them are meant, on which side, by which relations of the catalogue."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

from sceneweaver.language import Entity, SceneGraph, StatedRelation, Thing, grounded
from sceneweaver.scene import CATALOGUE, Relation

SIZES = {
    "bed": (2.1, 1.6, 1.0),
    "nightstand": (0.4, 0.45, 0.55),
    "dining_table": (0.9, 1.8, 0.75),
    "round_dining_table": (1.2, 1.2, 0.75),
    "chair": (0.5, 0.45, 0.9),
    "sofa": (0.9, 2.0, 0.8),
    "rug": (2.0, 3.0, 0.012),
    "floor_lamp": (0.4, 0.4, 1.6),
    "pendant": (0.4, 0.4, 0.4),
    "picture": (0.03, 0.8, 0.6),
    "mug": (0.1, 0.08, 0.1),
    "desk": (0.7, 1.4, 0.75),
}
MOUNTS = {"pendant": "ceiling", "picture": "wall", "mug": "surface"}


def things(**counts: int) -> dict[str, list[Thing]]:
    return {
        name: [Thing(f"{name}-{k}", name, SIZES[name], MOUNTS.get(name, "floor")) for k in range(count)]
        for name, count in counts.items()
    }


def graph(*relations: StatedRelation, **counts: int) -> SceneGraph:
    entities = tuple(Entity(id=name, noun=name, category=name, count=(n, n)) for name, n in counts.items())
    return SceneGraph(text="", entities=entities, relations=relations)


def said(kind: Any, subject: str, *targets: str, **more: Any) -> StatedRelation:
    return StatedRelation(id="r0", type=kind, subject=subject, targets=targets, **more)


def pairs(relation: StatedRelation, **counts: int) -> list[tuple[str, str, Any]]:
    """Type, subject and target of the hard relations, with the side where there is one."""
    rows, unsaid = grounded(graph(relation, **counts), things(**counts))
    assert not unsaid
    for row in rows:  # each is a relation that the catalogue takes
        target = {"window": "window-0", "door": "door-0"}.get(str(row.target), row.target)
        if CATALOGUE[row.type].target_kind != "wall":
            Relation(type=row.type, subject=row.subject, target=target, params=row.params)
    return [(row.params.get("side", row.type), row.subject, row.target) for row in rows if row.hard]


def test_sides_are_those_of_who_looks_at_the_front():
    for stated, own in (("left_of", "right_of"), ("right_of", "left_of"), ("in_front_of", "in_front_of")):
        assert pairs(said(stated, "floor_lamp", "sofa"), floor_lamp=1, sofa=1) == [(own, "floor_lamp-0", "sofa-0")]


def test_all_of_a_thing_is_beyond_the_side_and_within_its_width():
    rows, _ = grounded(graph(said("right_of", "floor_lamp", "bed")), things(floor_lamp=1, bed=1))
    (row,) = rows
    assert row.params["band"] / 2 * 2.1 + 0.2 == pytest.approx(1.25 * 2.1 / 2, abs=0.002)
    rows, _ = grounded(graph(said("in_front_of", "rug", "sofa")), things(rug=1, sofa=1))
    assert rows[0].params["min"] == 1.0  # a rug may reach under a sofa: its centre alone says too little


def test_flanking_is_one_on_either_side():
    found = pairs(said("flanking", "nightstand", "bed"), nightstand=2, bed=1)
    assert sorted(found) == [("left", "nightstand-0", "bed-0"), ("right", "nightstand-1", "bed-0")]
    lamps = pairs(said("flanking", "floor_lamp", "sofa"), floor_lamp=2, sofa=1)
    assert {kind for kind, _, _ in lamps} == {"left_of", "right_of", "near"}


def test_two_kinds_flank_from_different_sides():
    relations = (said("flanking", "floor_lamp", "sofa"), said("flanking", "nightstand", "sofa"))
    counts = {"floor_lamp": 1, "nightstand": 1, "sofa": 1}
    rows, _ = grounded(graph(*relations, **counts), things(**counts))
    sides = {row.subject: row.type for row in rows if row.type.endswith("_of")}
    assert sorted(sides.values()) == ["left_of", "right_of"] and len(sides) == 2


def test_counts_on_each_long_side():
    relation = said("along", "chair", "dining_table", side="long", count=(2, 2), each=True)
    rows, _ = grounded(graph(relation), things(chair=6, dining_table=1))
    placed = [row for row in rows if row.type == "seated_at"]
    at = [(row.params["side"], row.params["k"], row.params["n"]) for row in placed]
    assert sorted(at) == [("back", 0, 2), ("back", 1, 2), ("front", 0, 2), ("front", 1, 2)]


def test_one_on_the_left_and_two_on_the_right_are_different_ones():
    relations = (
        said("left_of", "chair", "sofa", count=(1, 1)),
        said("right_of", "chair", "sofa", count=(2, 2)).model_copy(update={"id": "r1"}),
    )
    rows, _ = grounded(graph(*relations, chair=3, sofa=1), things(chair=3, sofa=1))
    assert [(row.said, row.subject) for row in rows] == [("r0", "chair-0"), ("r1", "chair-1"), ("r1", "chair-2")]


def test_each_target_has_its_own():
    found = pairs(said("next_to", "floor_lamp", "sofa", each=True), floor_lamp=2, sofa=2)
    assert {(a, b) for _, a, b in found} == {("floor_lamp-0", "sofa-0"), ("floor_lamp-1", "sofa-1")}
    four = pairs(said("next_to", "chair", "desk", count=(2, 2), each=True), chair=4, desk=2)
    assert sorted(b for _, _, b in four) == ["desk-0", "desk-0", "desk-1", "desk-1"]


def test_all_of_several_are_meant_where_nothing_is_said():
    found = pairs(said("around", "chair", "round_dining_table"), chair=6, round_dining_table=1)
    assert found == [("around", f"chair-{k}", "round_dining_table-0") for k in range(6)]


def test_around_a_long_table_each_side_has_its_seats():
    rows, _ = grounded(graph(said("around", "chair", "dining_table")), things(chair=8, dining_table=1))
    placed, drawn_up = ([row for row in rows if row.type == name] for name in ("seated_at", "front_against"))
    assert [row.subject for row in placed] == [row.subject for row in drawn_up]
    assert len(rows) == 16 and not any(row.hard for row in drawn_up)
    sides = Counter(row.params["side"] for row in placed)
    assert len(sides) in (2, 4) and max(sides.values()) - min(sides.values()) <= 2 and sides.total() == 8


@pytest.mark.parametrize(
    ("relation", "counts", "expected"),
    [
        (said("on", "sofa", "rug"), {"sofa": 1, "rug": 1}, {("over", "sofa-0", "rug-0")}),
        (said("below", "rug", "dining_table"), {"rug": 1, "dining_table": 1}, {("over", "rug-0", "dining_table-0")}),
        (said("above", "pendant", "bed"), {"pendant": 1, "bed": 1}, {("over", "pendant-0", "bed-0")}),
        (
            said("above", "picture", "sofa"),
            {"picture": 1, "sofa": 1},
            {("above", "picture-0", "sofa-0"), ("near", "picture-0", "sofa-0")},
        ),
        (
            said("below", "sofa", "picture"),
            {"picture": 1, "sofa": 1},
            {("above", "picture-0", "sofa-0"), ("near", "picture-0", "sofa-0")},
        ),
        (
            said("opposite", "sofa", "bed"),
            {"sofa": 1, "bed": 1},
            {("distance", "sofa-0", "bed-0"), ("facing", "sofa-0", "bed-0"), ("facing", "bed-0", "sofa-0")},
        ),
        (said("facing", "sofa", "bed"), {"sofa": 1, "bed": 1}, {("facing", "sofa-0", "bed-0")}),
        (said("near", "sofa", "bed"), {"sofa": 1, "bed": 1}, {("distance", "sofa-0", "bed-0")}),
        (said("next_to", "sofa", "bed"), {"sofa": 1, "bed": 1}, {("near", "sofa-0", "bed-0")}),
        (said("near", "sofa", "window"), {"sofa": 1}, {("near_window", "sofa-0", "window")}),
        (
            said("below", "desk", "window"),
            {"desk": 1},
            {("at_window", "desk-0", "window"), ("against_wall", "desk-0", "window")},
        ),
        (said("next_to", "desk", "door"), {"desk": 1}, {("near_door", "desk-0", "door")}),
        (said("against", "desk", "wall:left"), {"desk": 1}, {("against_wall", "desk-0", "wall:left")}),
        (said("at", "desk", "corner"), {"desk": 1}, {("in_corner", "desk-0", None)}),
        (said("at", "desk", "middle"), {"desk": 1}, {("in_middle", "desk-0", None)}),
        (said("facing", "sofa", "sofa"), {"sofa": 2}, {("facing", "sofa-0", "sofa-1"), ("facing", "sofa-1", "sofa-0")}),
    ],
    ids=lambda value: getattr(value, "type", None),
)
def test_what_is_meant(relation, counts, expected):
    assert set(pairs(relation, **counts)) == expected


def test_what_stands_on_different_things_is_related_through_these():
    made = things(mug=1, desk=1, sofa=1)
    made["mug"] = [Thing("mug-0", "mug", SIZES["mug"], "surface", "desk-0")]
    rows, unsaid = grounded(graph(said("near", "mug", "sofa")), made)
    assert [(row.subject, row.target) for row in rows] == [("desk-0", "sofa-0")] and not unsaid
    rows, unsaid = grounded(graph(said("on", "mug", "desk")), made)
    assert not rows and not unsaid  # it stands there


def test_what_lacks_its_target_is_said():
    relation = said("near", "sofa", "bed")
    assert grounded(graph(relation), things(sofa=1)) == ([], [relation])
    assert grounded(graph(relation), things(bed=1)) == ([], [relation])
