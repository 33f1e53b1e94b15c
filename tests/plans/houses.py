"""A house of two storeys that keeps all rules, and homes with one thing changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sceneweaver.home import Home

Data = dict[str, Any]

BOXES = {
    "hall": ("entrance_hall", "ground", (3.0, 0.3, 5.0, 4.2)),
    "stairs": ("stairs", "ground", (3.0, 4.3, 5.0, 7.1)),
    "living": ("living_dining", "ground", (5.1, 0.3, 8.7, 7.1)),
    "kitchen": ("kitchen", "ground", (0.3, 0.3, 2.9, 3.0)),
    "shower": ("bathroom", "ground", (0.3, 3.1, 2.9, 5.3)),
    "store": ("storage_room", "ground", (0.3, 5.4, 2.9, 7.1)),
    "landing": ("landing", "upper", (3.0, 0.3, 5.0, 4.2)),
    "stairwell": ("stairs", "upper", (3.0, 4.3, 5.0, 7.1)),
    "bedroom": ("master_bedroom", "upper", (5.1, 0.3, 8.7, 7.1)),
    "child": ("childrens_room", "upper", (0.3, 0.3, 2.9, 3.0)),
    "bath": ("bathroom", "upper", (0.3, 3.1, 2.9, 5.3)),
    "closet": ("storage_room", "upper", (0.3, 5.4, 2.9, 7.1)),
}


def outline(box: tuple[float, float, float, float]) -> list[list[float]]:
    """Corners counter-clockwise: walls 0 south, 1 east, 2 north, 3 west."""
    x0, y0, x1, y1 = box
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def _door(name: str, room: str, wall: int, offset: float, to: str | None, **more: Any) -> Data:
    return {
        "id": name,
        "room": room,
        "wall": wall,
        "offset": offset,
        "width": 0.8,
        "to": to,
        "opens_into": room,
        **more,
    }


def _window(name: str, room: str, wall: int, offset: float, width: float, **more: Any) -> Data:
    return {"id": name, "room": room, "wall": wall, "offset": offset, "width": width, **more}


def house() -> Data:
    """The house as data."""
    return {
        "id": "house",
        "storeys": [
            {"id": "ground", "elevation": 0.0, "height": 2.6},
            {"id": "upper", "elevation": 2.9, "height": 2.5},
        ],
        "rooms": [
            {"id": name, "type": kind, "storey": storey, "outline": outline(box)}
            for name, (kind, storey, box) in BOXES.items()
        ],
        "doors": [
            _door("front", "hall", 0, 0.5, None, width=1.0),
            _door("to-stairs", "hall", 2, 0.0, "stairs", width=2.0, kind="open", opens_into=None),
            _door("to-living", "living", 3, 4.5, "hall"),
            _door("to-kitchen", "kitchen", 1, 0.5, "hall"),
            _door("to-shower", "shower", 1, 0.1, "hall"),
            _door("to-store", "store", 0, 0.9, "shower"),
            _door("from-stairs", "landing", 2, 0.0, "stairwell", width=2.0, kind="open", opens_into=None),
            _door("to-bedroom", "bedroom", 3, 4.5, "landing"),
            _door("to-child", "child", 1, 0.5, "landing"),
            _door("to-bath", "bath", 1, 0.1, "landing"),
            _door("to-closet", "closet", 0, 0.9, "bath"),
        ],
        "windows": [
            _window("w-living", "living", 1, 1.0, 2.4),
            _window("w-living-south", "living", 0, 1.0, 1.6),
            _window("w-kitchen", "kitchen", 0, 0.6, 1.2),
            _window("w-bedroom", "bedroom", 1, 1.0, 2.4),
            _window("w-child", "child", 0, 0.6, 1.2),
            _window("w-bath", "bath", 3, 0.6, 0.6),
        ],
        "stairs": [
            {
                **{"id": "s", "lower": "stairs", "upper": "stairwell", "outline": outline((3.0, 4.3, 5.0, 7.1))},
                **{"up": [0, 1], "shape": "u", "width": 0.95, "risers": 15, "going": 0.26},
            }
        ],
    }


def part(data: Data, key: str, name: str) -> Data:
    """A part of the data by its id."""
    return next(item for item in data[key] if item["id"] == name)


def home_with(change: Callable[[Data], object] | None = None) -> Home:
    """The house, with one change."""
    data = house()
    if change is not None:
        change(data)
    return Home.model_validate(data)


def resized(name: str, *box: float) -> Callable[[Data], None]:
    """The change that gives a room another box."""

    def change(data: Data) -> None:
        part(data, "rooms", name)["outline"] = outline(box)  # type: ignore[arg-type]

    return change


def with_part(key: str, name: str, **fields: Any) -> Callable[[Data], None]:
    """The change of fields of one part."""

    def change(data: Data) -> None:
        part(data, key, name).update(fields)

    return change


def without(key: str, *names: str) -> Callable[[Data], None]:
    """The change that takes parts out."""

    def change(data: Data) -> None:
        data[key] = [item for item in data[key] if item["id"] not in names]

    return change


def both(*changes: Callable[[Data], object]) -> Callable[[Data], None]:
    """Several changes, one after the other."""

    def change(data: Data) -> None:
        for one in changes:
            one(data)

    return change
