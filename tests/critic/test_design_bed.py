"""The rules for beds, each on a room that keeps it and on one that breaks it."""

from __future__ import annotations

from tests.critic import rooms


def rules(case: rooms.Case) -> set[str | None]:
    """The rules that a case breaks."""
    return {fault.rule for fault in case.review().faults}


def test_the_head_of_a_bed_is_not_on_the_wall_of_the_door() -> None:
    case = rooms.bedroom()
    assert "bed_off_door_wall" not in rules(case)
    turned = case.but({"id": "bed-0", "x": 1.8, "y": 1.08, "yaw": 90})
    assert "bed_off_door_wall" in rules(turned)
