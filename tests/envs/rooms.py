"""A small kitchen: a counter with a glass, a sink, a fridge and a table."""

from __future__ import annotations

import math
from functools import cache

from sceneweaver.assets import Asset, make
from sceneweaver.scene import Door, Pose, Room, Scene, Support

SEEDS = {"drinking_glass": 4}  # one that a hand of 8 cm closes around
PLACES = {
    "fridge": (0.45, 3.2),
    "kitchen_counter": (0.34, 2.1),
    "sink_cabinet": (0.34, 0.8),
    "dining_table": (2.9, 3.0),
}


@cache
def assets() -> dict[str, Asset]:
    """By id."""
    return {asset.id: asset for asset in (make(name, SEEDS.get(name, 3)) for name in (*PLACES, "drinking_glass"))}


def load(asset_id: str) -> Asset:
    """The asset of that id."""
    return assets()[asset_id]


def kitchen(turn: float = 0.0) -> Scene:
    """The room; its table turned by ``turn`` [rad]."""
    by_name = {asset.category: asset for asset in assets().values()}
    objects = []
    for name, (x, y) in PLACES.items():
        pose = Pose.from_yaw(x, y, 0.0, turn if name == "dining_table" else 0.0)
        objects.append(by_name[name].object(f"{name}-0", pose=pose))
    counter = objects[1]
    top = counter.surfaces[0]
    pose = Pose.from_yaw(0.45, 2.1, top.z, math.pi / 2)
    support = Support(object=counter.id, surface=top.name)
    objects.append(by_name["drinking_glass"].object("drinking_glass-0", pose=pose, support=support))
    door = Door(id="door-0", wall=1, offset=0.5, width=0.9, height=2.0, swing="in-left")
    room = Room(type="kitchen", outline=((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), doors=(door,))
    return Scene(id="small-kitchen", room=room, objects=tuple(objects))
