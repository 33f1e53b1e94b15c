"""Kinds of rooms on small floors: known items, less with less floor, and never without what the room is for."""

from __future__ import annotations

import pytest

from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.model import check_items
from sceneweaver.knowledge.small_floors import on_floor, small_floors

KINDS = sorted({name for row in small_floors() for name in row.rooms})


@pytest.mark.parametrize("name", KINDS)
def test_a_smaller_floor_holds_no_more(name: str) -> None:
    kind, counts = room_types()[name], []
    for area in sorted({row.below + d for row in small_floors() if name in row.rooms for d in (-0.01, 0.01)}):
        items = on_floor(kind, area).items
        check_items(items)
        counts.append(len(items))
    assert counts == sorted(counts)
    assert on_floor(kind, 1000.0) is kind


def test_rows_name_items_that_there_are() -> None:
    for row in small_floors():
        assert row.rooms and set(row.rooms) <= set(room_types())
        known = {item.id for name in row.rooms for item in room_types()[name].items}
        assert set(row.leave_out) | set(row.items) <= known, row


@pytest.mark.parametrize(
    ("kind", "area", "there"),
    [
        ("bathroom", 3.5, {"toilet", "shower", "vanity"}),
        ("bathroom", 5.5, {"toilet", "tub", "vanity"}),
        ("living_room", 13.0, {"sofa", "tv", "coffee_table"}),
        ("bedroom", 8.0, {"bed", "wardrobe", "nightstand"}),
        ("kitchen", 6.0, {"sink", "stove", "fridge"}),
        ("guest_toilet", 1.4, {"toilet", "basin"}),
    ],
)
def test_what_a_room_is_for_stays(kind: str, area: float, there: set[str]) -> None:
    needed = {item.id for item in on_floor(room_types()[kind], area).items if item.need == "needed"}
    assert there <= needed
