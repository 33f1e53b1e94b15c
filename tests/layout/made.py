"""Scenes made for the tests of the engine."""

from __future__ import annotations

import functools
from pathlib import Path

from sceneweaver.scene import Door, Part, Pose, Relation, Room, Scene, SceneObject, Support, Surface, Window

ZOO = Path(__file__).parents[1] / "zoo"


@functools.cache
def zoo(name: str) -> Scene:
    return Scene.load(ZOO / f"{name}.json")


def room(width: float = 5.0, depth: float = 4.0) -> Room:
    return Room(
        outline=((0, 0), (width, 0), (width, depth), (0, depth)),
        height=2.7,
        doors=(Door(id="door", wall=0, offset=0.3, width=0.9, height=2.1),),
        windows=(Window(id="window", wall=2, offset=1.5, width=1.4, sill=0.9, height=1.2),),
    )


def thing(key: str, size=(0.5, 0.6, 0.8), **more) -> SceneObject:
    return SceneObject(id=key, category=more.pop("category", key), size=size, **more)


def table(key: str = "table", size=(0.8, 1.2, 0.75)) -> SceneObject:
    """A table top on two end boards, so that chairs reach under it."""
    d, w, h = size
    top = Part(polygon=((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2)), z=(h - 0.04, h))
    ends = [
        Part(polygon=((-d / 2, y), (d / 2, y), (d / 2, y + 0.04), (-d / 2, y + 0.04)), z=(0.0, h - 0.04))
        for y in (-w / 2, w / 2 - 0.04)
    ]
    return thing(key, size, parts=(top, *ends), surfaces=(Surface(name="top", polygon=top.polygon, z=h),))


def scene(objects, relations, **more) -> Scene:
    return Scene(id="made", room=more.pop("room", room()), objects=tuple(objects), relations=tuple(relations), **more)


def relation(type_: str, subject: str, target=None, **params) -> Relation:
    return Relation(type=type_, subject=subject, target=target, params=params)


BED = thing("bed", (2.0, 1.5, 0.5))
BOX = thing("box")
OTHER = thing("other", (0.6, 1.0, 0.7))
PICTURE = thing("picture", (0.04, 0.6, 0.5), mount="wall", pose=Pose(position=(0, 0, 1.4)))
TELLY = thing("telly", (0.08, 1.0, 0.6), mount="wall", pose=Pose(position=(0, 0, 1.0)))
CUP = thing("cup", (0.1, 0.1, 0.1), mount="surface", support=Support(object="table", surface="top"))
SHELF = thing(
    "shelf",
    (0.35, 0.9, 1.2),
    parts=(
        Part(polygon=((-0.175, -0.45), (-0.155, -0.45), (-0.155, 0.45), (-0.175, 0.45)), z=(0, 1.2)),
        *(
            Part(polygon=((-0.155, -0.45), (0.175, -0.45), (0.175, 0.45), (-0.155, 0.45)), z=(z, z + 0.02))
            for z in (0.0, 0.6, 1.18)
        ),
    ),
    surfaces=(
        Surface(
            name="middle",
            polygon=((-0.15, -0.44), (0.17, -0.44), (0.17, 0.44), (-0.15, 0.44)),
            z=0.62,
            headroom=0.5,
        ),
    ),
)
BOOK = thing("book", (0.2, 0.15, 0.25), mount="surface", support=Support(object="shelf", surface="middle"))
CHAIRS = [thing(f"chair{i}", (0.45, 0.45, 0.7)) for i in range(4)]

LAMP = thing("lamp", (0.4, 0.4, 0.5), mount="ceiling")

PARAMS: dict[str, Scene] = {
    "both axes": scene([OTHER, LAMP], [relation("centered_on", "lamp", "other", axis="both", offset=0.05)]),
    "width": scene([OTHER, LAMP], [relation("centered_on", "lamp", "other", axis="width", offset=0.03)]),
    "ahead": scene([BED, LAMP], [relation("centered_on", "lamp", "bed", ahead=[0.5, 0.6])]),
    "a faced middle": scene([OTHER, BOX], [relation("front_to_front", "box", "other", gap=[0.9, 1.4], offset=0.05)]),
    "on its axis": scene([OTHER, BOX], [relation("facing", "box", "other", degrees=5, offset=0.05)]),
    "backs in line": scene([BED, BOX], [relation("leftright_to_leftright", "box", "bed", gap=[0.0, 0.2], backs=0.05)]),
    "middle of a wall": scene([BED, BOX], [relation("against_wall", "bed", "wall:3", middle=0.2)]),
    "no door's wall": scene([BED, BOX], [relation("against_wall", i, door_walls="avoided") for i in ("bed", "box")]),
}
"""Relations with parameters that make other rows of them."""

ONE_OF_EACH: dict[str, Scene] = {
    "against_wall": scene([BED, BOX], [relation("against_wall", "bed"), relation("against_wall", "box", "wall:3")]),
    "side_against_wall": scene([BED, BOX], [relation("side_against_wall", "bed")]),
    "front_against": scene([table(), BOX], [relation("front_against", "box", "table")]),
    "front_to_front": scene([OTHER, BOX], [relation("front_to_front", "box", "other", gap=[0.3, 0.5])]),
    "leftright_to_leftright": scene([BED, BOX], [relation("leftright_to_leftright", "box", "bed")]),
    "side_by_side": scene([OTHER, BOX], [relation("side_by_side", "box", "other")]),
    "back_to_back": scene([OTHER, BOX], [relation("back_to_back", "box", "other")]),
    "on_floor": scene([BOX], [relation("on_floor", "box")]),
    "on_top": scene([table(), CUP], [relation("on_top", "cup", "table")]),
    "inside": scene([SHELF, BOOK], [relation("inside", "book", "shelf")]),
    "near": scene([OTHER, BOX], [relation("near", "box", "other", max=0.4)]),
    "distance": scene([OTHER, BOX], [relation("distance", "box", "other", min=1.0, max=1.2)]),
    "facing": scene([OTHER, BOX], [relation("facing", "box", "other", degrees=5)]),
    "aligned": scene([OTHER, BOX], [relation("aligned", "box", "other")]),
    "parallel": scene([OTHER, BOX], [relation("parallel", "box", "other")]),
    "left_of": scene([OTHER, BOX], [relation("left_of", "box", "other")]),
    "right_of": scene([OTHER, BOX], [relation("right_of", "box", "other")]),
    "in_front_of": scene([OTHER, BOX], [relation("in_front_of", "box", "other")]),
    "behind": scene([OTHER, BOX], [relation("behind", "box", "other")]),
    "beside": scene([OTHER, BOX], [relation("beside", "box", "other", min=0.4, max=0.6)]),
    "centered_on": scene([OTHER, BOX], [relation("centered_on", "box", "other")]),
    "in_corner": scene([OTHER, BOX], [relation("in_corner", "box")]),
    "at_window": scene(
        [OTHER, BOX], [relation("at_window", "other", "window"), relation("at_window", "box", "window", offset=0.03)]
    ),
    "between": scene([BED, OTHER, BOX], [relation("between", "box", ("bed", "other"))]),
    "around": scene(
        [table(size=(1.0, 1.0, 0.75)), *CHAIRS], [relation("around", c.id, "table") for c in CHAIRS], room=room(6, 5)
    ),
    "away_from_door": scene([BOX], [relation("away_from_door", "box", "door", min=2.0)]),
    "above": scene([OTHER, PICTURE], [relation("above", "picture", "other"), relation("against_wall", "other")]),
    "below": scene([TELLY, BOX], [relation("below", "box", "telly"), relation("against_wall", "box")]),
    "same_height": scene([TELLY, PICTURE], [relation("same_height", "picture", "telly")]),
    "seated_at": scene(
        [table(size=(0.8, 1.6, 0.75)), *CHAIRS],
        [
            relation("seated_at", c.id, "table", side=("back", "front")[k % 2], k=k // 2, n=2)
            for k, c in enumerate(CHAIRS)
        ],
        room=room(6, 5),
    ),
    "next_to": scene([OTHER, BOX], [relation("next_to", "box", "other", side="back", gap=[0.3, 0.4])]),
    "arranged": scene([OTHER, BOX], [relation("arranged", "box", "other", ahead=0.2, left=1.0, turn=180.0)]),
    "run_on": scene([OTHER, BOX], [relation("run_on", "box", "other"), relation("against_wall", "box")]),
    "in_middle": scene([OTHER, BOX], [relation("in_middle", "box", offset=0.1)]),
    "over": scene([table(), LAMP], [relation("over", "lamp", "table", inset=0.2)]),
    "near_window": scene([OTHER, BOX], [relation("near_window", "box", "window", min=0.4, max=0.8)]),
    "near_door": scene([OTHER, BOX], [relation("near_door", "box", min=0.3, max=0.9)]),
    "across_from": scene(
        [table(size=(0.8, 1.6, 0.75)), BOX], [relation("across_from", "box", "table", side="ends", gap=[0.4, 0.6])]
    ),
    "facing_door": scene([OTHER, BOX], [relation("facing_door", "box", degrees=20, aside=0.6)]),
    "off_walls": scene([OTHER, BOX], [relation("off_walls", "box", min=0.8)]),
    "on_grid": scene([OTHER, LAMP], [relation("on_grid", "lamp", k=1, n=2)]),
}
