"""Rooms have the surfaces that a request tells, and they are drawn so."""

import numpy as np

from sceneweaver.assets import textures
from sceneweaver.assets.room_looks import room_looks
from sceneweaver.assets.textures.relief import to_linear
from sceneweaver.generate.finish import finished
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import read_request
from sceneweaver.scene import Door, Room

ROOM = Room(
    outline=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)),
    height=2.6,
    doors=(Door(id="door-0", wall=0, offset=1.0, width=0.9, height=2.0),),
)


def made(text):
    kind = room_type("cafe")
    return finished(ROOM, kind, palette_for(kind.name), 1, read_request(text))


def test_bands_tiles_and_doors():
    finish = made("a cafe, white tiles to 1.4 m, sage above, a navy door").finish
    assert (finish.tiles.low, finish.tiles.high, finish.tiles.color) == (0.0, 1.4, "white")
    assert (finish.walls, finish.doors) == ("sage", "navy")
    finish = made("a cafe, walls teal to waist height, white above").finish
    assert (finish.accent.color, finish.accent.high, len(finish.accent.walls)) == ("teal", 1.0, 4)
    assert room_looks(ROOM.model_copy(update={"finish": finish})).wall.name == "white wall"


def test_a_wall_on_the_side_that_is_told():
    finish = made("a cafe, the far wall is bare brick").finish
    assert (finish.accent.of, finish.accent.walls) == ("brick", (2,))


def test_checks_show_both_colors():
    look = room_looks(made("a cafe with a black and white checkered floor")).floor
    maps = textures.maps(look.texture)
    seen = to_linear(maps.tint[40::128, 40::128] / 255.0) * maps.gain * to_linear(np.array(look.color))
    assert seen.min() < 0.1 and seen.max() > 0.6
