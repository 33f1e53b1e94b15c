"""Whose two sides are: the room's, of floor to keep free, of a thing, or of nothing that is known."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("home gym 3.5x4m, rack, bench, and 2x2 for stretching", (4.0, 3.5)),
        ("Living room 5 by 4 with rug 2 x 3 m", (5.0, 4.0)),
        ("Kids room, play mat 1.5 x 2 m between the beds, room is 3 x 4 m", (4.0, 3.0)),
        ("dorm room: 2.8 x 5.1, loft bed 90x200", (5.1, 2.8)),
        ("pool room for a 9 ft table, 5 x 6.5", (6.5, 5.0)),
        ("Garage for one car 6x3, bikes", (6.0, 3.0)),
        ("hospital bed 1 x 2.1 m in a room of 3.6 x 4.2", (4.2, 3.6)),
        ("Hall with pews on two sides. Keep the centre clear for the dancers, 2.5 x 2.5 m.", None),
        ("Zoo shop, cage 4x4 m at the rear, three perches.", None),
        ("Restaurant with an open kitchen (3 x 4 m) behind glass, 8 tables", None),
        ("Bedroom with a king bed, dance floor 3 x 3 m in the corner", None),
        ("Dance school. The centre, 3 x 3 m, stays free.", None),
        ("Nursery. There should be about 2x2 m where they can play", None),
    ],
)
def test_sides_of_the_room(text: str, size: tuple[float, float] | None) -> None:
    assert read_by_rules(text).size == size


def test_what_is_not_the_rooms_is_of_something_else_or_told() -> None:
    free = read_by_rules("Hall with two pews. Keep the centre clear so people may dance, 2.5 x 2.5 m.")
    assert [(area.kind, area.size) for area in free.free_areas] == [("rectangle", (2.5, 2.5))]
    thing = read_by_rules("Bathroom. 2.10 x 1.80. Shower 90 x 90.")
    assert thing.size == (2.1, 1.8)
    assert [e.size[:2] for e in thing.entities if e.category == "shower"] == [(0.9, 0.9)]
    told = read_by_rules("Restaurant with an open kitchen (3 x 4 m) behind glass, 8 tables")
    assert "3 x 4 m" in [left.words for left in told.unread]


def test_mats_are_a_floor() -> None:
    assert read_by_rules("a washitsu, 6 tatami, with a low table").area == pytest.approx(9.92)
