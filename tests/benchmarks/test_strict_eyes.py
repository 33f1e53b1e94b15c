"""The comparison of the critic with strict eyes, on a made-up room and made-up labels."""

from __future__ import annotations

import pytest

from benchmarks.families.critic import tabulate
from benchmarks.results import Result
from benchmarks.strict_eyes import Comparison, labels, load_scene, read_labels
from sceneweaver.critic import Fault, Review
from sceneweaver.rules.design import design_rules

OLDER = {"askew", "away_from_wall", "wrong_orientation"}
"""Kinds of older checks that labels name."""


def row(*faults: dict, grade: int = 5) -> dict:
    grades = dict.fromkeys(("realism", "functionality", "layout", "completion"), grade)
    return {"grades": grades, "faults": list(faults)}


def fault(kind: str, *objects: str) -> Fault:
    return Fault(criterion="layout", kind=kind, objects=objects, reason="so")


def compared(data: dict, *reviews: tuple[float, tuple[Fault, ...]]) -> list[Comparison]:
    """Each graded scene of the data with a review of that grade and those faults."""
    made = [
        Review(grades=dict.fromkeys(("realism", "functionality", "layout", "completion"), grade), faults=faults)
        for grade, faults in reviews
    ]
    return [Comparison(g, r) for g, r in zip(read_labels(data), made, strict=True)]


def test_a_fault_is_found_on_its_objects_alone() -> None:
    data = {"a": row({"rules": ["door_frame", "swing_free"], "objects": ["bed-0", "bed-1"]})}
    (label,) = read_labels(data)[0].labels
    assert label.found_by(fault("door_frame", "bed-1", "lamp-0"))
    assert label.found_by(fault("swing_free", "bed-0"))
    assert not label.found_by(fault("door_frame", "lamp-0"))
    assert not label.found_by(fault("door_frame"))
    assert not label.found_by(fault("wall_covered", "bed-0"))


def test_a_fault_of_the_room_is_found_whatever_it_names() -> None:
    (label,) = read_labels({"a": row({"rules": ["wall_covered"], "objects": []})})[0].labels
    assert label.found_by(fault("wall_covered")) and label.found_by(fault("wall_covered", "picture-0"))


def test_a_label_says_either_rules_or_eyes() -> None:
    for wrong in ({"objects": []}, {"rules": ["door_frame"], "eyes": "picture", "objects": []}):
        with pytest.raises(ValueError, match="either rules or eyes"):
            read_labels({"a": row(wrong)})


def test_recall_false_alarms_and_grades_are_counted() -> None:
    data = {
        "a": row(
            {"rules": ["door_frame"], "objects": ["bed-0"]},
            {"rules": ["rug_on_bed_axis"], "objects": ["rug-0"]},
            {"eyes": "picture", "objects": [], "why": "cut away"},
            grade=3,
        ),
        "b": row({"rules": ["wall_covered"], "objects": []}, grade=6),
        "c": row(grade=8),
    }
    found = compared(
        data,
        (4.0, (fault("door_frame", "bed-0"), fault("art_corner", "picture-0"))),
        (5.0, (fault("wall_covered"),)),
        (9.0, ()),
    )
    result = Result("critic", "", "")
    tabulate(result, found)
    kinds = {r["kind"]: (r["labelled"], r["found"], r["beside"]) for r in result.table("kinds").rows}
    assert kinds["door_frame"] == (1, 1, 0) and kinds["rug_on_bed_axis"] == (1, 0, 0)
    assert kinds["art_corner"] == (0, 0, 1) and kinds["picture"] == (1, 0, 0)
    assert kinds["all that a scene shows"] == (3, 2, 1)
    for grade in result.table("grades").rows:
        assert grade["spearman"] == pytest.approx(1.0) and grade["error"] == pytest.approx(1.0)
    assert {(r["scene"], r["what"]) for r in result.table("faults").rows} == {
        ("a", "missed"),
        ("a", "only eyes"),
        ("a", "critic alone"),
    }


def test_the_stored_labels_name_rules_and_objects_that_there_are() -> None:
    graded = labels()
    assert len(graded) == 30 and sum(len(g.labels) for g in graded) == 253
    for g in graded:
        ids = set(load_scene(g.name).ids)
        for label in g.labels:
            assert label.objects <= ids, g.name
            assert set(label.rules) <= set(design_rules()) | OLDER, g.name
            assert not label.eyes or (label.eyes in ("picture", "drawing") and label.why), g.name
