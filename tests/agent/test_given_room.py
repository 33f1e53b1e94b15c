"""A design in a shell that is given: it stays as it is, and all else is as in a room of our own."""

from __future__ import annotations

import math
from typing import Any

import pytest

import sceneweaver as sw
from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.relaxation import relaxed
from sceneweaver.generate.room import kept
from sceneweaver.generate.squared import squared
from sceneweaver.generate.ways import BASE, THROUGH, WAYS, ways_of
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import read_request
from sceneweaver.scene.finish import FloorFinish, RoomFinish
from sceneweaver.verify.report import Violation

FAST: dict[str, Any] = {"steps": 1, "candidates": 8, "device": "cpu", "time_limit": None}
SHELL = (
    sw.Room.polygon([(3.1, 1.2), (6.3, 1.2), (6.3, 3.4), (5.2, 3.4), (5.2, 5.1), (3.1, 5.1)], height=2.6, kind="study")
    .with_door(0, at=0.1, swing="out")
    .with_window("west")
)
LIVING = sw.Room.rectangle(3.64, 6.2, height=2.7, kind="living_room").with_door("east", at=0.6).with_window("west")


def test_a_shell_stays_as_it_is() -> None:
    result = sw.design(room=SHELL, seed=1, **FAST)
    room = result.scene.room
    assert (room.outline, room.height, room.doors, room.windows) == (
        SHELL.outline,
        SHELL.height,
        SHELL.doors,
        SHELL.windows,
    )
    assert result.report.valid and room.type == "study"
    assert {"desk", "standing_desk"} & {o.category for o in result.scene.objects}
    assert any(area.id == WAYS for area in result.scene.free_areas)


def test_a_finish_and_a_palette_stay_as_they_are() -> None:
    finish = RoomFinish(walls="sage", floor=FloorFinish(material="stone", tone="slate"), trim="walnut")
    palette = kept(palette_for("bathroom", seed=5), "rustic", 5)  # which no study has by itself
    shell = SHELL.model_copy(update={"finish": finish})
    result = sw.design("a study", room=shell, palette=palette, seed=1, **FAST)
    assert result.scene.room.finish == finish and result.scene.palette == palette


def test_the_room_says_its_kind_where_the_request_does_not() -> None:
    assert chosen_room(read_request("a desk and a lamp"), SHELL)[0].name == "study"
    assert chosen_room(read_request("a bedroom"), SHELL)[0].name == "bedroom"


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"room": "a study"}, "room: str"),
        ({"room": SHELL, "init": "library"}, "leave out init library"),
        ({"room": SHELL, "start": sw.Scene.example("bedroom")}, "leave out start"),
        ({"room": SHELL, "palette": "oak"}, "palette: str"),
    ],
)
def test_bad_arguments_are_named(options: dict, named: str) -> None:
    with pytest.raises(sw.InputError, match=named):
        sw.design("a study", **FAST, **options)


def test_ways_join_doors_as_far_as_they_are_straight() -> None:
    assert ways_of(sw.Room.rectangle(3, 3)) == ()
    two = sw.Room.rectangle(3, 6).with_door("south").with_door("north")
    assert [area.size for area in ways_of(two)] == [(BASE, BASE)]
    three = two.with_door("east")
    pairs = [area.targets for area in ways_of(three) if area.targets]
    assert len(three.doors) == THROUGH and len(pairs) == 2
    assert {name for pair in pairs for name in pair} == {door.id for door in three.doors}
    ell = sw.Room.l_shape(6, 6, cut=(4.6, 4.6)).with_door("south", at=0.9)
    ell = ell.with_door("west", at=0.1).with_door("west", at=0.9)
    for area in ways_of(ell):
        if area.targets:  # none of them leaves the room
            assert set(area.targets) == {"door-1", "door-2"} or "door-0" in area.targets


def test_in_a_fixed_room_what_is_needed_goes_last() -> None:
    scene = sw.Scene.example("bedroom")
    objects = []
    for k, one in enumerate(o for o in scene.objects if o.mount == "floor"):
        priority = "needed" if k == 0 else "usual"
        objects.append(one.model_copy(update={"intent": one.intent.model_copy(update={"priority": priority})}))
    first = objects[0]
    scene = scene.model_copy(update={"objects": tuple(objects), "relations": (), "free_areas": ()})
    fault = Violation("out_of_bounds", (first.id,), f"{first.id} is 0.1 m outside the room", 0.1)
    fixed = relaxed(scene, [fault], fixed=True)
    free = relaxed(scene, [fault])
    assert fixed is not None and first.id in fixed.scene.ids and len(fixed.scene.ids) < len(scene.ids)
    assert free is not None and first.id not in free.scene.ids


def test_large_furniture_stands_square_to_a_shell_and_may_be_turned_later() -> None:
    result = sw.design("a living room with a sofa and a dining table for 4 people", room=LIVING, seed=7, **FAST)
    large = [o for o in result.scene.objects if o.category in ("sofa", "dining_table", "tv_stand", "bookcase")]
    assert len(large) >= 2
    assert all(abs(math.remainder(o.pose.yaw, math.pi / 2)) < math.radians(0.6) for o in large)
    assert all(o.yaw_domain is None for o in result.scene.objects)
    askew = sw.Room.polygon([(0, 0), (4, 1), (3, 5), (-1, 4)])
    assert squared(result.scene.objects, askew) == result.scene.objects
