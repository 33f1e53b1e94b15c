"""Homes made by hand, with boxes for furniture, and the same homes turned and mirrored."""

from __future__ import annotations

import math
from typing import Any

from sceneweaver.home import Home
from sceneweaver.scene import Scene
from tests.verify.build import box

Json = dict[str, Any]


def furnished(home: Home, **rooms: list[Json]) -> Home:
    """A home with boxes in some rooms, whose ids are written with _ for -."""
    for name, things in rooms.items():
        room = name.replace("_", "-")
        shell = home.shell(room).model_dump(mode="json")
        data = {"schema": "sceneweaver.scene/1", "id": room, "room": shell, "objects": things}
        home = home.with_scene(room, Scene.model_validate(data))
    return home


def flat(**rooms: list[Json]) -> Home:
    """The flat that ships with the library, with boxes in some rooms."""
    return furnished(Home.example("flat"), **rooms)


def thing(name: str, category: str, size: tuple[float, float, float], x: float, y: float, yaw: float = 0.0) -> Json:
    """A box of some category; its front looks along yaw [degrees]."""
    return box(name, size, x, y, yaw, category=category)


def bars(gap: float) -> list[Json]:
    """A row of boxes across the hall of the flat, near the front door, but for a gap at the right [m]."""
    return [box("bar", (0.2, 1.6 - gap, 1.0), 4.6 + (1.6 - gap) / 2, 1.6, 90.0)]


def turned(home: Home) -> Home:
    """The home turned by a quarter about the origin."""
    return _mapped(home, lambda x, y: (-y, x), lambda yaw: yaw + math.pi / 2, mirror=False)


def mirrored(home: Home) -> Home:
    """The home seen in a mirror along y; stairs that turn go to their left in it as well."""
    return _mapped(home, lambda x, y: (-x, y), lambda yaw: math.pi - yaw, mirror=True)


def _mapped(home: Home, place: Any, direction: Any, mirror: bool) -> Home:
    data = home.model_dump(mode="json", by_alias=True)
    rooms = {room["id"]: room for room in data["rooms"]}

    def outline(points: list) -> list:
        found = [[round(value, 6) + 0.0 for value in place(*point)] for point in points]
        return found[::-1] if mirror else found

    def opening(one: Json, corners: list) -> None:
        if mirror:
            count, k = len(corners), one["wall"]
            length = math.dist(corners[k], corners[(k + 1) % count])
            one["wall"] = (count - 2 - k) % count
            one["offset"] = round(length - one["offset"] - one["width"], 6)

    for one in (*data["doors"], *data["windows"]):
        opening(one, rooms[one["room"]]["outline"])
        if mirror and "hinge" in one:
            one["hinge"] = {"left": "right", "right": "left"}[one["hinge"]]
    for stair in data["stairs"]:
        stair["outline"], stair["up"] = outline(stair["outline"]), list(place(*stair["up"]))
    scenes = {name: room.pop("scene", None) for name, room in rooms.items()}
    for room in rooms.values():
        room["outline"] = outline(room["outline"])
    made = Home.model_validate(data)
    for name, scene in scenes.items():
        if scene is None:
            continue
        for obj in scene["objects"]:
            x, y, z = obj["pose"]["position"]
            _, _, s, c = obj["pose"]["quaternion"]
            yaw = direction(2 * math.atan2(s, c)) / 2
            obj["pose"] = {"position": [*place(x, y), z], "quaternion": [0.0, 0.0, math.sin(yaw), math.cos(yaw)]}
        made = furnished(made, **{name.replace("-", "_"): scene["objects"]})
    return made


def house(landing: float = 1.2, shape: str = "straight") -> Home:
    """A house of two storeys: a stairwell with a room beside it on each, joined by a stair of 15 steps.

    Args:
        landing: free floor before the first step and behind the last one [m].
        shape: of the stair, straight or u.
    """
    run = 14 * 0.25 if shape == "straight" else 7 * 0.25 + 1.0
    wide = 1.0 if shape == "straight" else 2.0
    length = round(run + (2 if shape == "straight" else 1) * landing, 3)
    well = [[0.0, 0.0], [wide, 0.0], [wide, length], [0.0, length]]
    room = [[wide + 0.1, 0.0], [wide + 4.1, 0.0], [wide + 4.1, length], [wide + 0.1, length]]
    steps = [[0.0, landing], [wide, landing], [wide, round(landing + run, 3)], [0.0, round(landing + run, 3)]]

    def storey(name: str, at: float) -> tuple[list[Json], list[Json]]:
        rooms = [
            {"id": f"well-{name}", "type": "stairs", "storey": name, "outline": well},
            {"id": f"room-{name}", "type": "living_room", "storey": name, "outline": room},
        ]
        door = {"id": f"door-{name}", "room": f"well-{name}", "wall": 1, "offset": at, "width": 0.8}
        return rooms, [{**door, "to": f"room-{name}", "opens_into": f"room-{name}"}]

    above = length - landing + 0.2 if shape == "straight" else 0.2
    lower, upper = storey("ground", 0.2), storey("first", round(above, 3))
    outside = {"id": "front-door", "room": "room-ground", "wall": 0, "offset": 1.0, "width": 0.9, "height": 2.0}
    stair = {"id": "stair", "lower": "well-ground", "upper": "well-first", "outline": steps, "up": [0.0, 1.0]}
    data = {
        "schema": "sceneweaver.home/1",
        "id": "house",
        "storeys": [
            {"id": "ground", "elevation": 0.0, "height": 2.5},
            {"id": "first", "elevation": 2.7, "height": 2.5},
        ],
        "rooms": lower[0] + upper[0],
        "doors": [{**outside, "to": None, "opens_into": "room-ground"}, *lower[1], *upper[1]],
        "stairs": [{**stair, "shape": shape, "width": 1.0, "risers": 15, "going": 0.25}],
    }
    return Home.model_validate(data)
