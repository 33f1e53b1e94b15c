"""Niches, chimney breasts and bays are made by the outline, as wide and deep as what stands in them needs."""

from __future__ import annotations

import pytest

from sceneweaver.critic.asked_openings import outcomes
from sceneweaver.generate.shell import shell
from sceneweaver.knowledge.load import room_types
from sceneweaver.language import read_request
from sceneweaver.language.wall_names import walls_meant
from sceneweaver.scene import Room


class _Survey:
    """What the critic reads of a room without furniture."""

    def __init__(self, brief, room):
        self.brief, self.scene, self.placed = brief, self, self
        self.room, self.walls = room, room.walls


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("a study with a desk in an alcove", "niche"),
        ("a study with a recess 1.4 m wide in the left wall", "niche"),
        ("a parlour, a sideboard centred on its chimney breast", "breast"),
        ("a study with a chimney breast in the middle of the long wall", "breast"),
        ("a lounge with a bay window on the short wall", "bay"),
        ("a kitchen with the stove in the chimney breast", "breast_opening"),
    ],
)
def test_parts_of_walls_are_in_the_outline(text: str, part: str) -> None:
    brief = read_request(text)
    kind = room_types()[brief.room_type or "study"]
    for seed in range(3):
        room, notes = shell(kind, brief, 18.0, seed)
        assert walls_meant(part, room), (seed, notes)
        found = [row.outcome for row in outcomes(_Survey(brief, room))]
        assert [one.status for one in found] == ["met"] * len(found), (seed, found)


def test_a_niche_has_room_for_what_stands_in_it() -> None:
    brief = read_request("a study with a sofa in an alcove")
    room, _ = shell(room_types()["study"], brief, 20.0, 0)
    (back,) = walls_meant("niche", room)
    assert room.walls[back].length > 1.4
    assert room.walls[back - 1].length > 0.7


def test_beside_a_breast_are_the_walls_up_to_the_corners() -> None:
    outline = [(0, 0), (5, 0), (5, 4), (3.2, 4), (3.2, 3.6), (1.8, 3.6), (1.8, 4), (0, 4)]
    room = Room.polygon(outline)
    assert walls_meant("breast", room) == [4]
    assert sorted(walls_meant("beside_breast", room)) == [2, 6]
    assert sorted(walls_meant("niche", room)) == [2, 6]
    assert walls_meant("bay", room) == []


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("an attic bedroom with the bed under the slope", "slope"),
        ("a studio with two skylights", "roof_window"),
        ("a lounge with a conversation pit", "sunk_floor"),
        ("a hall with a vaulted ceiling", "ceiling_shape"),
    ],
)
def test_what_is_not_built_is_told(text: str, part: str) -> None:
    brief = read_request(text)
    assert [one.part for one in brief.openings] == [part]
    room, _ = shell(room_types()[brief.room_type or "study"], brief, 18.0, 0)
    assert [row.outcome.status for row in outcomes(_Survey(brief, room))] == ["unmet"]


def test_parts_that_a_room_has_not_are_unmet() -> None:
    plain = Room.rectangle(4, 5).with_door("south").with_window("north")
    for text in ("a study with an alcove", "a study with a chimney breast", "a study with a bay window"):
        found = [row.outcome.status for row in outcomes(_Survey(read_request(text), plain))]
        assert found == ["unmet"], text
