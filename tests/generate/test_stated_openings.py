"""Doors and windows stand where a request says, in rooms of all seeds; the critic measures them anew."""

from __future__ import annotations

import pytest

from sceneweaver.critic.asked_openings import outcomes
from sceneweaver.generate.shell import shell
from sceneweaver.knowledge.load import room_types
from sceneweaver.language import read_request

REQUESTS = [
    "a bedroom of 3.5 x 4.4 m, window 1.6 m wide in the middle of one short wall, door in the opposite wall",
    "a hallway of 2 x 5 m. Front door in the middle of one short wall, a second door opposite",
    "an office with a door 1 m wide and two windows in the long wall",
    "a dining room with double doors in the left wall and a window opposite the door",
    "a sunroom of 3 x 5 m, glass on three sides",
    "a study with a niche in the wall opposite the door",
    "an office, the window on the far short wall",
    "a kitchen with a side door and a back door",
    "a classroom with four windows on the left wall, door on the right wall opening outwards",
    "a bathroom with a small high window opposite the door",
    "a study with two windows on the same wall",
    "a galley with a door at both ends",
    "a lounge with five doors, no two on the same wall",
    "a laundry room with a cellar window, in by the left door, out by the right",
]


class _Survey:
    """What the critic reads of a room without furniture."""

    def __init__(self, brief, room):
        self.brief, self.scene, self.placed = brief, self, self
        self.room, self.walls = room, room.walls


@pytest.mark.parametrize("text", REQUESTS)
def test_openings_are_as_asked(text: str) -> None:
    brief = read_request(text)
    kind = room_types()[brief.room_type or "study"]
    assert brief.openings
    for seed in range(4):
        room, notes = shell(kind, brief, 16.0, seed)
        found = [row.outcome for row in outcomes(_Survey(brief, room))]
        assert [one.status for one in found] == ["met"] * len(brief.openings), (seed, found, notes)


def test_the_critic_sees_what_is_not_as_asked() -> None:
    asked = read_request("a bedroom of 3.5 x 4.4 m, a window 1.6 m wide in a short wall")
    other = read_request("a bedroom of 3.5 x 4.4 m, a window 1.1 m wide in a long wall")
    room, _ = shell(room_types()["bedroom"], other, 16.0, 1)
    assert [row.outcome.status for row in outcomes(_Survey(asked, room))] == ["unmet"]


def test_more_than_a_wall_holds_is_said() -> None:
    brief = read_request("a pantry of 2 x 2 m with six windows 1 m wide in the left wall")
    room, notes = shell(room_types()["pantry"], brief, 4.0, 0)
    assert notes or len(room.windows) == 6 and all(window.width < 1.0 for window in room.windows)


def test_what_is_not_so_is_told() -> None:
    """Each property of an opening is measured in the finished walls: those of another room fail."""
    plain, _ = shell(room_types()["study"], read_request("a study, one window on the right wall"), 16.0, 1)
    for text in (
        "a study with a side door",
        "a study with a window on the left wall",
        "a study, the door opens outwards",
        "a study with a window with a sill at 1.6 m",
        "a study with a window high up",
        "a study with a low door",
        "a study with two windows on the same wall",
    ):
        brief = read_request(text)
        found = [row.outcome.status for row in outcomes(_Survey(brief, plain))]
        assert found == ["unmet"], (text, found)


def test_doors_in_walls_of_their_own_are_told_apart() -> None:
    brief = read_request("a bedroom with two doors, each in a different wall")
    room, _ = shell(room_types()["bedroom"], brief, 16.0, 1)
    one = room.doors[0]
    both = one.model_copy(update={"id": "door-1", "offset": one.offset + 0.1})
    crammed = room.model_copy(update={"doors": (one, both)})
    assert [row.outcome.status for row in outcomes(_Survey(brief, crammed))] == ["met", "unmet"]
