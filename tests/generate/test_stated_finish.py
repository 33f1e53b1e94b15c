"""What a request says of floor, walls, ceiling and woods."""

from __future__ import annotations

import pytest

from sceneweaver.generate.finish import finished
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import read_request
from sceneweaver.scene import Room

ROOM = Room(outline=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), height=2.6)


def said(text: str, part: str) -> tuple[str | None, str | None] | None:
    """Material and colour of a part of the room."""
    found = read_request(text).finish_of(part)
    return found and (found.material, found.color)


def woods(text: str) -> list[str | None]:
    return [one.color for one in read_request(text).finishes if one.part == "furniture"]


@pytest.mark.parametrize(
    ("text", "material", "tone"),
    [
        ("A loft with a polished concrete floor", "concrete", None),
        ("bedroom, floor of dark oak", "wood", "dark oak"),
        ("a hall with terracotta floor", "tile", "terracotta"),
        ("a lobby with a white marble floor", "stone", "white"),
        ("grey carpet floor, two desks", "carpet", "grey"),
        ("a study with herringbone parquet", "wood", None),
    ],
)
def test_floors(text: str, material: str, tone: str | None) -> None:
    assert said(text, "floor") == (material, tone)


def test_walls_in_words_before_and_after() -> None:
    assert said("a kitchen with dark green walls", "walls") == (None, "dark green")
    assert said("The walls are painted dusty pink.", "walls") == (None, "dusty pink")
    assert said("one navy accent wall behind the bed", "accent") == (None, "navy")
    assert said("a mirror on the left wall, floor lamp", "walls") is None
    assert said("pantry, walls white, two shelves", "walls") == (None, "white")
    assert said("a hut with plank walls", "walls") == ("boards", "oak")


def test_two_colours_of_one_wall_and_beams() -> None:
    graph = read_request("a school corridor, blue up to chest height, white above")
    lower, upper = graph.finish_of("lower"), graph.finish_of("walls")
    assert lower is not None and upper is not None
    assert (lower.color, lower.high, upper.color) == ("blue", 1.3, "white")
    beams = read_request("a parlour with oak beams on the ceiling").finish_of("beams")
    assert beams is not None and beams.color == "oak"


def test_a_wood_of_one_thing_is_not_that_of_the_room() -> None:
    assert woods("a walnut desk by the wall") == []
    assert woods("everything in oak") == ["oak"]
    assert woods("dark wood everywhere") == ["walnut"]


def test_what_is_said_shows_in_the_room() -> None:
    kind = room_type("living_room")
    palette = palette_for("living_room")
    panelled = finished(ROOM, kind, palette, 1, read_request("wood panelled, dark wood")).finish
    assert panelled is not None and panelled.accent is not None
    assert (panelled.accent.kind, len(panelled.accent.walls)) == ("panelling", 4)
    assert panelled.accent.high == ROOM.height
    for seed in range(8):
        look = palette_for("living_room", None, ("sage green",), seed)
        finish = finished(ROOM, kind, look, seed, read_request("a living room in sage green")).finish
        assert finish is not None and finish.accent is not None and finish.accent.color == "sage green"
