"""What a request says of floor, walls and woods."""

from __future__ import annotations

import pytest

from sceneweaver.generate.finish import finished
from sceneweaver.generate.stated_finish import stated_finish
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.scene import Room

ROOM = Room(outline=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), height=2.6)


@pytest.mark.parametrize(
    ("text", "material", "tone"),
    [
        ("A loft with a polished concrete floor", "concrete", None),
        ("bedroom, floor of dark oak", "wood", "walnut"),
        ("a hall with terracotta floor", "tile", "terracotta"),
        ("a lobby with a white marble floor", "stone", "white"),
        ("grey carpet floor, two desks", "carpet", "grey"),
        ("a study with herringbone parquet", "wood", None),
    ],
)
def test_floors(text: str, material: str, tone: str | None) -> None:
    floor = stated_finish(text).floor
    assert floor is not None and (floor.material, floor.tone) == (material, tone)


def test_walls_in_words_before_and_after() -> None:
    assert stated_finish("a kitchen with dark green walls").walls == "dark green"
    assert stated_finish("The walls are painted dusty pink.").walls == "dusty pink"
    assert stated_finish("one navy accent wall behind the bed").accent == "navy"
    assert stated_finish("a mirror on the left wall, floor lamp").walls is None


def test_a_wood_of_one_thing_is_not_that_of_the_room() -> None:
    assert stated_finish("a walnut desk by the wall").woods == ()
    assert stated_finish("everything in oak").woods == ("oak",)
    assert stated_finish("dark wood everywhere").woods == ("walnut",)


def test_what_is_said_shows_in_the_room() -> None:
    kind = room_type("living_room")
    panelled = finished(ROOM, kind, palette_for("living_room"), 1, "wood panelled, dark wood").finish
    assert panelled is not None and panelled.accent is not None
    assert (panelled.accent.kind, len(panelled.accent.walls)) == ("panelling", 4)
    for seed in range(8):
        look = palette_for("living_room", None, ("sage green",), seed)
        finish = finished(ROOM, kind, look, seed, "in sage green", ("sage green",)).finish
        assert finish is not None and finish.accent is not None and finish.accent.color == "sage green"
