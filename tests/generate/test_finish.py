"""Finishes of rooms: by the palette, tiles where there is water, and the accent behind the main piece."""

from __future__ import annotations

import math

import pytest

from sceneweaver.assets import make
from sceneweaver.generate.finish import accent_wall, accented, finished
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import read_request
from sceneweaver.scene import Door, Pose, Room, RoomFinish, Scene, WallAccent, Window

DOOR = Door(id="door-0", wall=0, offset=0.2, width=0.9, height=2.0)
WINDOW = Window(id="window-0", wall=2, offset=1.5, width=1.4, sill=0.9, height=1.2)
ROOM = Room(outline=((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), doors=(DOOR,), windows=(WINDOW,))


def test_walls_and_floor_follow_the_palette():
    palette = palette_for("bedroom", "modern", (), 1)
    looks = [finished(ROOM, room_type("bedroom"), palette, seed).finish for seed in range(30)]
    assert {look.walls for look in looks} == {palette.walls}
    assert {look.floor.material for look in looks} == {"wood", "carpet"}
    assert all(look.floor.tone == palette.floors[look.floor.material] for look in looks)
    kinds = {look.accent.kind if look.accent else "plain" for look in looks}
    assert kinds == {"plain", "paint", "paper", "panelling"}
    assert all(look.accent is None or look.accent.color == palette.accent for look in looks)


@pytest.mark.parametrize(("name", "low", "high"), [("bathroom", 0.0, 2.1), ("kitchen", 0.9, 1.5)])
def test_rooms_with_water_have_tiles(name, low, high):
    palette = palette_for(name, "modern", (), 1)
    finish = finished(ROOM, room_type(name), palette, 1).finish
    assert (finish.tiles.low, finish.tiles.high, finish.accent) == (low, high, None)
    assert finish.tiles.color != finish.walls


def test_an_accent_needs_a_wall_without_openings():
    assert accent_wall(ROOM) in (1, 3)
    lit = [WINDOW.model_copy(update={"id": f"w{k}", "wall": k}) for k in (1, 2, 3)]
    assert accent_wall(ROOM.model_copy(update={"windows": tuple(lit)})) is None


def furnished(yaw: float, x: float, y: float, accent: bool = True) -> Scene:
    finish = RoomFinish(accent=WallAccent(color="sage", walls=(1,)) if accent else None)
    bed = make("bed", seed=1).object("bed-0", pose=Pose.from_yaw(x, y, 0.0, yaw))
    return Scene(id="s", room=ROOM.model_copy(update={"finish": finish}), objects=(bed,))


def test_the_accent_is_behind_the_bed():
    half = make("bed", seed=1).size[0] / 2
    assert accented(furnished(0.0, half + 0.02, 2.0)).room.finish.accent.walls == (3,)
    assert accented(furnished(-math.pi / 2, 2.5, 4 - half - 0.02)).room.finish.accent.walls == (2,)
    free = furnished(0.5, 2.5, 2.0)
    assert accented(free) == free
    plain = furnished(0.0, half + 0.02, 2.0, accent=False)
    assert accented(plain) == plain


@pytest.mark.parametrize(
    ("text", "walls", "accent"),
    [
        ("a bedroom with navy walls", "navy", None),
        ("a bedroom with sage green walls and a black wall clock", "sage green", None),
        ("a bedroom with white-painted walls and a red accent wall", "white", "red"),
        ("a bedroom with brick walls", "brick red", None),
    ],
)
def test_colours_that_the_request_says_of_walls(text, walls, accent):
    palette = palette_for("bedroom", "modern", (), 1)
    for seed in range(8):
        finish = finished(ROOM, room_type("bedroom"), palette, seed, read_request(text)).finish
        assert finish.walls == (walls or palette.walls)
        assert not (walls and accent is None and finish.accent)
        assert accent is None or finish.accent.color == accent
