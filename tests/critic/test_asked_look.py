"""What became of the look of a room, of its time, its light and its finishes."""

from __future__ import annotations

from sceneweaver.assets import make
from sceneweaver.critic import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import CeilingFinish, FloorFinish, Pose, Room, RoomFinish, RoomLight, Scene
from sceneweaver.verify import check

OLD = RoomFinish(
    walls="greige",
    walls_of="stone",
    floor=FloorFinish(material="stone", tone="taupe"),
    ceiling=CeilingFinish(material="boards", color="dark oak", beams="dark oak"),
    electric=False,
)
NEW = RoomFinish(walls="off white", floor=FloorFinish(material="wood", tone="birch"))
DIM = RoomLight(level="dim", kelvin=1900)


def statuses(text: str, finish: RoomFinish, light: RoomLight | None, *categories: str) -> dict[str, str]:
    """What became of each fact about a room of 4 by 3 m with some things along its middle."""
    outline = ((0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0))
    room = Room(type="living_room", outline=outline, height=2.6, finish=finish, light=light)
    made = [(name, Pose.from_yaw(1.0 + k, 2.0, 0.0, 0.0)) for k, name in enumerate(categories)]
    things = tuple(make(name, seed=1).object(f"{name}-0", pose=pose, mount="floor") for name, pose in made)
    scene = Scene(id="s", prompt=text, room=room, objects=things)
    found = review_scene(scene, check(scene), room_type("living_room"), read_request(text))
    return {item.item: item.status for item in found.alignment.items if item.kind == "room"}


def test_a_time_is_more_than_a_word() -> None:
    text = "a medieval living room"
    good = statuses(text, OLD, DIM, "barrel", "candle_wheel")
    assert good["room.look-0"] == "met" and good["room.year"] == "met"
    plain = statuses(text, NEW, None, "barrel")
    assert plain["room.look-0"] == "unmet" and plain["room.year"] == "met"
    assert statuses(text, OLD, None, "barrel", "candle_wheel")["room.look-0"] == "partly"


def test_what_came_later_is_counted() -> None:
    assert statuses("a living room of 1955", NEW, None, "laptop")["room.year"] == "unmet"
    assert statuses("a living room of 1955 with a laptop", NEW, None, "laptop")["room.year"] == "partly"
    assert statuses("a living room of 2015", NEW, None, "laptop")["room.year"] == "met"


def test_finishes_and_light_are_those_of_the_scene() -> None:
    text = "a living room with stone walls, dim light"
    assert statuses(text, OLD, DIM)["room.finish-0"] == "met"
    assert statuses(text, NEW, DIM)["room.finish-0"] == "unmet"
    assert statuses(text, NEW, RoomLight(level="bright"))["room.look-0"] == "unmet"
    beams = "a living room with oak beams"
    assert (statuses(beams, OLD, None)["room.finish-0"], statuses(beams, NEW, None)["room.finish-0"]) == (
        "met",
        "unmet",
    )


def test_only_flames() -> None:
    text = "a living room lit by candles"
    night = RoomLight(level="dim", kelvin=1900, daylight="night")
    assert statuses(text, OLD, night, "candle_wheel", "candle", "candlestick")["room.look-0"] == "met"
    assert statuses(text, OLD, night, "candle", "floor_lamp")["room.look-0"] != "met"


def test_only_the_lamp_that_is_named() -> None:
    text = "a living room with one dim floor lamp"
    dusk = RoomLight(level="dim", kelvin=2500, daylight="dusk")
    assert statuses(text, OLD, dusk, "floor_lamp")["room.look-0"] == "met"
    assert statuses(text, OLD, dusk, "floor_lamp", "table_lamp")["room.look-0"] != "met"


def test_contrast_is_measured() -> None:
    text = "a living room with clear contrast"
    light = RoomLight(level="bright")
    pale = RoomFinish(walls="ivory", floor=FloorFinish(material="tile", tone="white"))
    dark = RoomFinish(walls="ivory", floor=FloorFinish(material="tile", tone="dark grey"))
    assert statuses(text, pale, light)["room.look-0"] != "met"
    assert statuses(text, dark, light)["room.look-0"] == "met"


def test_everything_in_a_colour_is_measured() -> None:
    text = "a living room, everything white"
    white = RoomFinish(walls="white", floor=FloorFinish(material="tile", tone="white"))
    assert statuses(text, white, None)["room.finish-0"] == "met"
    assert statuses(text, NEW, None)["room.finish-0"] == "unmet"
