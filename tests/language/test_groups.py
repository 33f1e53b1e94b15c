"""Groups in words: what is read of them, and that it is not read where it is not meant."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.language.read import read_by_rules


def told(text: str) -> list[dict[str, Any]]:
    rows = read_by_rules(text).arrangements
    return [
        {k: v for k, v in row.model_dump().items() if v and k not in ("id", "words", "span", "more")} for row in rows
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a den with two couches at right angles", {"entity": "sofa", "pattern": "right_angle"}),
        ("a den where a sofa and a loveseat form an L", {"pattern": "right_angle", "others": ("loveseat",)}),
        ("six bunk beds, three along each long wall", {"pattern": "walls", "sides": (3, 3), "around": "wall:long"}),
        ("two cots on the right wall and one on the left", {"pattern": "walls", "sides": (1, 2)}),
        ("a hall with pews on both sides of a 1.5 m aisle", {"pattern": "rows", "rows": 2, "aisle": 1.5}),
        ("seats left and right of a centre aisle, three on each side", {"rows": 2, "columns": 3, "aisle": 1.2}),
        ("ten booths for a museum, two rows of five back to back", {"pattern": "back_to_back", "columns": 5}),
        ("tyres stacked three high, four stacks beside one another", {"pattern": "stack", "groups": 4}),
        ("five rows of eight chairs with a gangway in the middle", {"rows": 5, "columns": 8, "aisle": 1.2}),
        ("desks back to back in two rows of three", {"pattern": "back_to_back", "rows": 2, "columns": 3}),
        ("a table with four chairs, one on each side", {"pattern": "sides", "sides": (1, 1, 1, 1)}),
        ("a long table with four chairs on each side and one at the head", {"sides": (4, 4, 1, 0)}),
        ("two single beds head to head", {"pattern": "head_to_head"}),
        ("three benches end to end", {"pattern": "end_to_end"}),
        ("kegs stacked four high in two stacks", {"pattern": "stack", "rows": 4, "groups": 2}),
        ("a den with a whole wall of bookcases", {"pattern": "wall", "entity": "bookcase"}),
        ("four beach chairs beside each other, looking outside", {"pattern": "row", "facing": "window"}),
        ("two islands parallel to each other, 1.1 m apart", {"pattern": "rows", "columns": 1, "spacing": 1.1}),
    ],
)
def test_a_group_is_read(text: str, said: dict[str, Any]) -> None:
    found = told(text)
    assert any(said.items() <= row.items() for row in found), found


def test_what_is_between_each_two_has_its_number() -> None:
    graph = read_by_rules("a ward with five beds in a row and a cabinet between each two")
    counts = {e.category: e.count for e in graph.entities}
    assert counts["cabinet"] == (4, 4)
    assert [(a.pattern, a.around) for a in graph.arrangements if a.entity == "cabinet"] == [("between", "hospital_bed")]


def test_a_u_has_its_seats_outside_and_opens_to_something() -> None:
    rows = told("a seminar hall, desks in a U, the open side towards the whiteboard, chairs on the outside")
    assert {"pattern": "u", "facing": "whiteboard"}.items() <= rows[0].items()
    assert rows[1]["pattern"] == "outside" and rows[1]["entity"] == "chair"


@pytest.mark.parametrize(
    "text",
    [
        "a kitchen in an L-shaped room",
        "a bed with a nightstand on each side",
        "a sofa against the wall of the living room",
        "a lamp on each side of the bed",
        "two beds and a nightstand between the two beds",
        "a middle aisle of 1.2 m from the door to the window",
    ],
)
def test_what_is_no_group_is_left_to_the_clauses(text: str) -> None:
    assert told(text) == []
