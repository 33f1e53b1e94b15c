"""Scenes to draw."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.scene import Door, Pose, Room, Scene, SceneObject, Support, Surface, Window

ZOO = Path(__file__).parents[1] / "zoo"


@dataclass(frozen=True)
class Violation:
    """What ``check`` reports, as far as a drawing cares."""

    kind: str
    objects: tuple[str, ...]
    detail: str = ""
    amount: float = 0.0


def rectangle(width: float, depth: float) -> tuple[tuple[float, float], ...]:
    return ((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth))


def box(
    object_id: str, x: float, y: float, *, size=(0.5, 0.5, 0.5), yaw: float = 0.0, z: float = 0.0, **more
) -> SceneObject:
    more.setdefault("category", "box")
    return SceneObject(id=object_id, size=size, pose=Pose.from_yaw(x, y, z, yaw), **more)


def room_of(*objects: SceneObject, width: float = 4.0, depth: float = 3.0, **more) -> Scene:
    room = more.pop("room", None) or Room(outline=rectangle(width, depth))
    return Scene(id=more.pop("id", "test"), room=room, objects=objects, **more)


def everything() -> Scene:
    """One of each thing that a plan can show, in a turned room with a reflex corner."""
    c, s = math.cos(0.35), math.sin(0.35)

    def turn(x: float, y: float) -> tuple[float, float]:
        return (x * c - y * s, x * s + y * c)

    def put(object_id: str, x: float, y: float, **more) -> SceneObject:
        return box(object_id, *turn(x, y), yaw=0.35 + more.pop("yaw", 0.0), **more)

    outline = tuple(turn(*p) for p in ((0, 0), (3, 0), (3, 2), (1.8, 2), (1.8, 3), (0, 3)))
    top = ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))
    boards = (Surface(name="in", polygon=top, z=0.2, headroom=0.2), Surface(name="top", polygon=top, z=0.5))
    room = Room(
        outline=outline,
        doors=(
            Door(id="door-in", wall=0, offset=0.3, width=0.8, height=2.0, swing="in-right"),
            Door(id="door-out", wall=1, offset=0.3, width=0.8, height=2.0, swing="out"),
            Door(id="door-slide", wall=5, offset=0.3, width=0.8, height=2.0, swing="slide"),
        ),
        windows=(Window(id="window", wall=5, offset=1.4, width=1.0, sill=0.9, height=1.0),),
    )
    return Scene(
        id="everything",
        prompt="one of each",
        room=room,
        objects=(
            put("shelf", 0.25, 2.0, category="shelf", surfaces=boards),
            put(
                "inside",
                0.25,
                2.0,
                z=0.2,
                size=(0.1, 0.1, 0.1),
                mount="surface",
                support=Support(object="shelf", surface="in"),
            ),
            put(
                "upon",
                0.3,
                2.05,
                z=0.5,
                size=(0.12, 0.12, 0.1),
                mount="surface",
                category="vase",
                support=Support(object="shelf", surface="top"),
            ),
            put("picture", 0.05, 1.0, z=1.2, size=(0.04, 0.5, 0.5), mount="wall"),
            put("lamp", 1.0, 1.6, z=2.4, size=(0.3, 0.3, 0.3), mount="ceiling", category="pendant_lamp"),
            put(
                "chair",
                1.4,
                0.9,
                size=(0.45, 0.45, 0.8),
                category="chair",
                yaw=2.0,
                attributes={"color": "black"},
                zones=(
                    {"name": "front", "polygon": ((0.3, -0.2), (0.6, -0.2), (0.6, 0.2), (0.3, 0.2)), "z": (0, 1)},
                    {
                        "name": "soft",
                        "polygon": ((0.6, -0.2), (0.8, -0.2), (0.8, 0.2), (0.6, 0.2)),
                        "z": (0, 1),
                        "hard": False,
                    },
                ),
            ),
        ),
    )


def zoo(name: str) -> Scene:
    return Scene.load(ZOO / f"{name}.json")
