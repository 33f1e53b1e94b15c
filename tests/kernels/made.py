"""Scenes made for the kernels' tests: one for every relation type, and a few that hold one thing each."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.scene import Scene
from tests.verify.build import box, rectangle, relation

Json = dict[str, Any]

ANGLE = 0.37  # the L-shaped room is turned by this
L_SHAPE = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.5), (3.5, 3.5), (3.5, 6.0), (0.0, 6.0))


def centred(depth: float, width: float, x: float = 0.0, y: float = 0.0) -> list[list[float]]:
    """A rectangle about a point."""
    return rectangle(x - depth / 2, y - width / 2, x + depth / 2, y + width / 2)


def octagon(radius: float) -> list[list[float]]:
    turns = np.arange(8) * np.pi / 4 + np.pi / 8
    return [[float(radius * np.cos(t)), float(radius * np.sin(t))] for t in turns]


def l_room() -> Json:
    """An L-shaped room, turned by `ANGLE`, with a door and two windows."""
    c, s = np.cos(ANGLE), np.sin(ANGLE)
    return {
        "outline": [[float(c * x - s * y), float(s * x + c * y)] for x, y in L_SHAPE],
        "height": 2.7,
        "doors": [
            {"id": "door", "wall": 0, "offset": 0.4, "width": 0.9, "height": 2.0, "swing": "in-left"},
            {"id": "gate", "wall": 4, "offset": 0.5, "width": 1.2, "height": 2.1, "swing": "slide"},
        ],
        "windows": [
            {"id": "window", "wall": 5, "offset": 1.5, "width": 1.4, "sill": 0.9, "height": 1.2},
            {"id": "pane", "wall": 0, "offset": 2.5, "width": 0.5, "sill": 1.2, "height": 0.6},
        ],
    }


def chair(id: str, x: float, y: float, **more) -> Json:
    parts = [
        {"polygon": centred(0.45, 0.48), "z": [0.0, 0.46]},
        {"polygon": centred(0.08, 0.48, -0.185), "z": [0.46, 0.9]},
    ]
    return box(id, (0.45, 0.48, 0.9), x, y, **{"parts": parts, **more})


def table(id: str, x: float, y: float, **more) -> Json:
    """A round table on a column: things reach under it, and stand on it."""
    parts = [{"polygon": octagon(0.6), "z": [0.7, 0.74]}, {"polygon": centred(0.3, 0.3), "z": [0.0, 0.7]}]
    surfaces = [{"name": "top", "polygon": centred(0.8, 0.8), "z": 0.74, "headroom": None}]
    size = 2 * 0.6 * float(np.cos(np.pi / 8))
    return box(id, (size, size, 0.74), x, y, **{"parts": parts, "surfaces": surfaces, **more})


def sofa(id: str, x: float, y: float, **more) -> Json:
    """An L of two prisms with a hard zone before it."""
    parts = [
        {"polygon": centred(0.9, 1.8, -0.45), "z": [0.0, 0.8]},
        {"polygon": centred(0.9, 0.8, 0.45, 0.5), "z": [0.0, 0.45]},
    ]
    zones = [{"name": "legs", "polygon": centred(0.8, 0.9, 0.5, -0.4), "z": [0.0, 1.5], "hard": True}]
    return box(id, (1.8, 1.8, 0.8), x, y, **{"parts": parts, "zones": zones, **more})


def shelf(id: str, x: float, y: float, **more) -> Json:
    """A cabinet of two boards and a back, open in front; a hard zone before it."""
    parts = [
        {"polygon": centred(0.4, 0.9), "z": [0.0, 0.05]},
        {"polygon": centred(0.4, 0.9), "z": [0.95, 1.0]},
        {"polygon": centred(0.03, 0.9, -0.185), "z": [0.0, 1.0]},
    ]
    zones = [{"name": "front", "polygon": centred(0.5, 0.9, 0.45), "z": [0.0, 1.0], "hard": True}]
    surfaces = [
        {"name": "board", "polygon": centred(0.34, 0.86, 0.02), "z": 0.05, "headroom": 0.9},
        {"name": "top", "polygon": centred(0.4, 0.9), "z": 1.0, "headroom": None},
    ]
    return box(id, (0.4, 0.9, 1.0), x, y, **{"parts": parts, "zones": zones, "surfaces": surfaces, **more})


def picture(id: str, x: float, y: float, z: float, **more) -> Json:
    return box(id, (0.04, 0.8, 0.5), x, y, z=z, mount="wall", **more)


def cup(id: str, carrier: str, surface: str, x: float, y: float, z: float) -> Json:
    return box(id, (0.1, 0.08, 0.12), x, y, z=z, mount="surface", support={"object": carrier, "surface": surface})


PARAMS: dict[str, Json] = {
    "against_wall": {"gap": [0.02, 0.2], "overlap": 0.6},
    "side_against_wall": {"degrees": 12.0, "side": "front"},
    "front_against": {"gap": [0.3, 0.5]},
    "front_to_front": {"gap": [0.3, 0.5], "overlap": 0.8},
    "leftright_to_leftright": {"gap": [0.1, 0.4]},
    "side_by_side": {"overlap": 0.9},
    "back_to_back": {"degrees": 20.0},
    "near": {"max": 0.4},
    "facing": {"degrees": 40.0},
    "aligned": {"degrees": 8.0},
    "parallel": {"degrees": 8.0},
    "left_of": {"max": 0.9},
    "right_of": {"band": 0.5},
    "in_front_of": {"max": 0.9, "min": 0.2},
    "behind": {"band": 0.5},
    "centered_on": {"offset": 0.03},
    "in_corner": {"to_corner": 0.6},
    "at_window": {"overlap": 0.9, "offset": 0.1},
    "between": {"along": [0.4, 0.7], "aside": 0.2},
    "away_from_door": {"min": 1.7},
    "above": {"lateral": 0.2},
    "below": {"lateral": 0.2},
    "same_height": {"tolerance": 0.2},
    "seated_at": {"side": "left", "k": 2, "n": 3, "offset": 0.2},
    "next_to": {"side": "back", "gap": [0.2, 0.9]},
    "arranged": {"ahead": -0.8, "left": 1.1, "turn": 150.0, "offset": 0.4, "degrees": 40.0},
    "run_on": {"side": "left", "gap": [0.0, 0.4], "offset": 0.3},
    "in_middle": {"offset": 1.5},
    "over": {"inset": 0.1},
    "near_window": {"min": 0.2, "max": 3.0},
    "near_door": {"min": 0.2, "max": 3.0},
    "across_from": {"side": "left", "k": 1, "n": 2, "gap": [0.1, 1.4], "offset": 0.5},
    "facing_door": {"degrees": 70.0, "aside": 0.7},
    "off_walls": {"min": 1.6},
    "on_grid": {"k": 1, "n": 4, "offset": 1.2},
}
"""Numbers other than the defaults, for the types that take any."""


def related(kind: str, **params) -> Scene:
    """A scene with relations of one type, in the L-shaped room: one hard as given, one soft with other numbers."""
    other = {"distance": {"min": 0.3, "max": 1.8}}.get(kind, PARAMS.get(kind, {}))
    params = params or {"distance": {"min": 0.5, "max": 2.5}, "arranged": {"ahead": 1.6, "left": 0.3}}.get(kind, {})
    objects = [chair("a", 1.0, 2.5), table("b", 1.6, 4.0), sofa("c", 3.0, 3.2, yaw=40.0)]
    target: Any = "b"
    second: tuple[str, Any] = ("c", "b")
    if kind in ("on_floor", "in_corner", "in_middle", "on_grid", "off_walls"):
        target, second = None, ("c", None)
    elif kind in ("against_wall", "side_against_wall"):
        target, second = None, ("c", "wall:3")
    elif kind == "at_window":
        target, second = "window", ("c", "pane")
    elif kind == "near_window":
        target, second = None, ("c", "pane")
    elif kind in ("away_from_door", "near_door", "facing_door"):
        target, second = None, ("c", "gate")
    elif kind == "between":
        target, second = ("b", "c"), ("b", ("c", "a"))
    elif kind == "around":
        return _around(objects, params)
    elif kind in ("above", "below", "same_height"):
        objects += [picture("p", 0.0, 3.0, 1.3), picture("q", 1.0, 0.4, 1.5)]
        hung = {"above": ("p", "c"), "below": ("a", "p"), "same_height": ("p", "q")}[kind]
        second = {"above": ("q", "a"), "below": ("c", "q"), "same_height": ("a", "q")}[kind]
        return _scene(kind, objects, [relation(kind, *hung, **params), relation(kind, *second, hard=False, **other)])
    elif kind in ("on_top", "inside"):
        objects += [
            shelf("s", 2.5, 1.8, yaw=200.0),
            cup("u", "b", "top", 1.6, 4.1, 0.74),
            cup("v", "s", "board", 2.5, 1.8, 0.05),
        ]
        pairs = {"on_top": ("u", "b"), "inside": ("v", "s")}
        return _scene(kind, objects, [relation(kind, *pairs[kind])])
    links = [relation(kind, "a", target, **params), relation(kind, *second, hard=False, **other)]
    return _scene(kind, objects, links)


def _around(objects: list[Json], params: Json) -> Scene:
    """Four chairs at the table, all by the same numbers, and two at the sofa by others."""
    objects += [chair(id, x, y) for id, x, y in (("d", 2, 2), ("e", 0.2, 4), ("f", 1, 1), ("g", 4, 1), ("h", 5, 1))]
    links = [relation("around", id, "b", **params) for id in "adef"]
    return _scene("around", objects, links + [relation("around", id, "c", hard=False, spread=60.0) for id in "gh"])


def mixed_around(**last) -> Scene:
    """Chairs around a table at 0, 135 and 270 degrees: even enough, but for the 90 degrees from the last to the first.

    ``last`` is what the last one's relation has of its own.
    """
    x, y = 1.3, 3.0  # inside the L
    objects = [table("b", x, y)]
    for id, degrees in (("a", 0.0), ("d", 135.0), ("e", 270.0)):
        way = np.exp(1j * np.radians(degrees)) * 0.8
        objects.append(chair(id, float(x + way.real), float(y + way.imag), yaw=degrees + 180.0))
    links = [relation("around", "a", "b"), relation("around", "d", "b"), relation("around", "e", "b", **last)]
    return _scene("mixed", objects, links)


def _scene(name: str, objects: list[Json], relations: list[Json]) -> Scene:
    data = {"schema": "sceneweaver.scene/1", "id": name, "room": l_room(), "objects": objects, "relations": relations}
    return Scene.model_validate(data)


def gallery() -> Scene:
    """Wall-mounted objects, a cabinet with things on and in it, a sofa, in the L-shaped room."""
    objects = [
        picture("p", 0.0, 3.0, 1.3),
        picture("q", 1.0, 0.4, 1.5),
        box("tv", (0.08, 1.2, 0.7), 2.0, 2.0, z=1.0, mount="wall"),
        box("lamp", (0.5, 0.3, 0.2), 2.0, 3.0, z=2.5, mount="ceiling"),
        shelf("s", 2.5, 1.8, yaw=200.0),
        sofa("c", 3.0, 3.2, yaw=40.0),
        table("b", 1.6, 4.0),
        chair("a", 1.0, 2.5),
        cup("u", "b", "top", 1.6, 4.1, 0.74),
        cup("v", "s", "board", 2.5, 1.8, 0.05),
        cup("w", "s", "top", 2.5, 1.75, 1.0),
    ]
    relations = [
        relation("above", "p", "s"),
        relation("same_height", "p", "q"),
        relation("above", "tv", "c", hard=False),
        relation("against_wall", "s"),
        relation("side_against_wall", "c", hard=False),
        relation("facing", "c", "tv"),
        relation("front_against", "a", "b"),
        relation("in_corner", "b", hard=False),
        relation("at_window", "a", "window", hard=False),
        relation("away_from_door", "c", "gate"),
        relation("left_of", "b", "c", hard=False),
        relation("right_of", "a", "c", hard=False),
        relation("between", "b", ["c", "s"], hard=False),
        relation("parallel", "b", "c", hard=False),
        relation("near", "a", "w"),
    ]
    return _scene("gallery", objects, relations)
