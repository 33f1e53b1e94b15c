"""Rooms as a model may write them down."""

from __future__ import annotations

from typing import Any


def item(name: str, what: str | list[str], **more: Any) -> dict[str, Any]:
    """An item of a room."""
    return {"id": name, "what": [what] if isinstance(what, str) else what, **more}


def place(kind: str, to: str | None = None, soft: bool = False, **params: Any) -> dict[str, Any]:
    """A relation of an item."""
    return {"type": kind, **({"to": to} if to else {}), "soft": soft, "params": params}


HUT_ITEMS = [
    item("bunk", "bunk_bed", need="needed", count=[2, 2], place=[place("against_wall")]),
    item("table", "dining_table", need="needed", top="dining", width=[1.4, 1.6], place=[]),
    item("chair", "chair", need="needed", count=[4, 4], **{"with": "table"}, place=[place("front_against", "table")]),
    item("stove", "wood stove", place=[place("against_wall"), place("away_from_door", None, True, min=0.5)]),
    item("shelf", "bookcase", place=[place("against_wall")], fill="books"),
    item("lamp", "ceiling_light", place=[place("on_grid")]),
    item("curtain", "curtain", place=[place("at_window", "window")]),
]

PROGRAMME: dict[str, Any] = {
    "kind": "mountain hut",
    "area": 26,
    "people": 4,
    "style": "rustic",
    "groups": [],
    "items": HUT_ITEMS,
}

ROOM: dict[str, Any] = {
    "words": ["alpine hut"],
    "description": "A hut in the mountains where a few people eat, sit at a stove and sleep.",
    "area": [16, 26, 45],
    "people": 4,
    "height": 2.4,
    "doors": {"count": [1, 1], "width": [0.85, 0.95], "height": [2.0, 2.05]},
    "windows": {"count": [1, 2], "width": [0.8, 1.1], "height": [0.9, 1.1], "sill": [0.9, 1.0]},
    "styles": ["rustic"],
    "floor": "wood",
    "fill": 0.36,
    "groups": [],
    "items": HUT_ITEMS,
}


def changed(data: dict[str, Any], at: int, **fields: Any) -> dict[str, Any]:
    """A room with other fields in one item."""
    items = [{**one, **fields} if k == at else one for k, one in enumerate(data["items"])]
    return {**data, "items": items}
