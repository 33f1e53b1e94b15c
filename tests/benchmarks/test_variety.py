"""Signatures of rooms: equal for rooms that look alike from the door, however they are turned, else different."""

from __future__ import annotations

import math

from benchmarks.families.variety import Made, furniture, is_bed, tabulate
from benchmarks.results import Result
from benchmarks.shell_signature import layout_signature, openings, shell_signature
from sceneweaver.assets import make
from sceneweaver.scene import Door, Pose, Room, Scene, Window


def room(width: float = 5.0, depth: float = 4.0, offset: float = 0.3, turned: bool = False, window: int = 2) -> Room:
    """A room with its door in the wall y = 0, or turned by a quarter with its door in the wall x = width."""
    outline = ((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth))
    shift = 0
    if turned:
        outline, shift = ((0.0, 0.0), (depth, 0.0), (depth, width), (0.0, width)), 1
    door = Door(id="door-0", wall=shift, offset=offset, width=0.9, height=2.0)
    pane = Window(id="window-0", wall=(window + shift) % 4, offset=1.5, width=1.2, sill=0.9, height=1.2)
    return Room(type="bedroom", outline=outline, doors=(door,), windows=(pane,))


def test_a_room_that_is_turned_is_the_same():
    assert shell_signature(room()) == shell_signature(room(turned=True))
    assert openings(room()) == "right; far middle usual"


def test_shells_differ_by_sides_door_and_windows():
    different = [room(), room(width=6.0), room(offset=3.8), room(window=1), room(window=3)]
    assert len({shell_signature(one) for one in different}) == len(different)


def scene(x: float, y: float, yaw: float, **shell) -> Scene:
    bed = make("bed", seed=1)
    return Scene(id="s", room=room(**shell), objects=(bed.object("bed-0", pose=Pose.from_yaw(x, y, 0.0, yaw)),))


def test_layouts_differ_by_walls_and_places_and_not_by_a_few_centimetres():
    length = make("bed", seed=1).size[0]
    left = scene(length / 2 + 0.02, 2.0, 0.0)
    nudged = scene(length / 2 + 0.04, 2.1, 0.0)
    far = scene(2.5, 4.0 - length / 2 - 0.02, -math.pi / 2)
    free = scene(2.5, 2.0, 0.4)
    assert layout_signature(left) == layout_signature(nudged) == "bed left middle"
    assert layout_signature(far) == "bed far middle"
    assert layout_signature(free).startswith("bed free")


def test_beds_and_furniture():
    assert is_bed("king_bed") and is_bed("daybed") and not is_bed("sofa") and not is_bed("pet_bed")
    assert furniture("wardrobe", (0.6, 1.2, 2.0)) and not furniture("book", (0.2, 0.3, 0.03))


def test_two_rooms_alike_are_a_failure():
    alike, other = scene(2.5, 2.0, 0.4), scene(2.5, 2.0, 0.4, width=7.0)
    result = Result("variety", "", "")
    tabulate(result, [Made(0, alike, True, 9.0), Made(1, alike, True, 9.0), Made(2, other, True, 9.0)])
    assert result.failures == ["shell and layout: 2 of at least 3"]
    result = Result("variety", "", "")
    tabulate(result, [Made(0, alike, True, 9.0), Made(2, other, True, 9.0)])
    assert not result.failures and len(result.table("rooms").rows) == 2
