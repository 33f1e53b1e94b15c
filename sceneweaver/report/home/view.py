"""A home packed for the 3D view: a scope for each storey without its roof, and one for each room with walls of its own.

Objects of different rooms may have the same id; here an object's id is ``<room>/<id>``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.home import Home, HomeRoom
from sceneweaver.scene import Scene

from ..facts import faults_of, object_facts, relation_rows
from ..view3d import (
    Packed,
    Store,
    best_side,
    object_items,
    packed_meshes,
    room_box,
    room_items,
    room_walls,
    solid_item,
    stored,
)
from .data import HomePage

_SOUTH = -math.pi / 2 + 0.28
"""Where a storey is looked at from [rad]: north is up, as in its plan."""

_PITCH, _STEEP = 0.62, 0.95
"""How steeply rooms and storeys are looked down at, at first [rad]."""

_HIGH = 1.6  # height [m] that a storey without its roof fills


def pack_home(page: HomePage, titles: Mapping[str, str]) -> Packed:
    """Pack a home; objects whose asset cannot be loaded are shown as their parts.

    Args:
        page: The home.
        titles: What its rooms are called.
    """
    home, store = page.home, Store()
    items: list[dict[str, Any]] = []
    objects: dict[str, Any] = {}
    notes: list[str] = []
    inside: dict[str, list[int]] = {}  # numbers of the items of each room's objects
    low: dict[str, list[int]] = {}  # the same without those that walls cut low cannot hold

    def take(found: list[dict[str, Any]]) -> list[int]:
        items.extend(found)
        return list(range(len(items) - len(found), len(items)))

    for room in home.rooms:
        inside[room.id] = low[room.id] = []
        if room.scene is not None:
            found, missing = object_items(store, room.scene, page.load, f"{room.id}/")
            inside[room.id] = take(found)
            gone = {f"{room.id}/{name}" for name in page.hidden.get(room.id, ())}
            low[room.id] = [k for k in inside[room.id] if items[k]["id"] not in gone]
            notes += missing
            objects |= _facts(room, (page.metrics.get("rooms") or {}).get(room.id) or {})
    scopes = []
    for storey in home.storeys:
        rooms = home.rooms_of(storey.id)
        if storey.id in page.solids:
            solids = [
                solid_item(store, f"{storey.id}/{k}", mesh, kind, 0 if kind == "wall" else None)
                for k, (kind, mesh) in enumerate(page.solids[storey.id])
            ]
            shown = [*take(solids), *(k for room in rooms for k in low[room.id])]
            title = storey.id if len(home.storeys) > 1 else "Whole home"
            scopes.append(_storey_scope(home, storey.id, title, shown))
    for room in home.rooms:
        if room.outdoor:
            continue
        scene = room.scene if room.scene is not None else Scene(id=room.id, room=home.shell(room.id))
        shown = [*take(room_items(store, scene.room, f"{room.id}/")), *inside[room.id]]
        scopes.append(
            {
                "id": f"room:{room.id}",
                "title": titles[room.id],
                "room": room_box(scene.room),
                "walls": room_walls(scene.room),
                "yaw": best_side(scene),
                "pitch": _PITCH,
                "items": shown,
            }
        )
    first = scopes[0] if scopes else {"room": {"low": [0, 0], "high": [1, 1], "height": 1}, "walls": [], "yaw": 0.0}
    data = {
        "room": first["room"],
        "walls": first["walls"],
        "yaw": first["yaw"],
        **stored(store),
        "items": items,
        "objects": objects,
        "scopes": scopes,
        "request": [],
        "seen": [],
    }
    return Packed(data, packed_meshes(store), tuple(dict.fromkeys(notes)))


def _storey_scope(home: Home, storey: str, title: str, items: list[int]) -> dict[str, Any]:
    """A storey as one room whose walls stand: they are cut low, and sink only when all are hidden."""
    points = np.concatenate([np.asarray(room.outline) for room in home.rooms_of(storey)])
    reach = home.walls.outer - WALL_THICKNESS
    low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
    return {
        "id": f"storey:{storey}",
        "title": title,
        "room": {"low": low.tolist(), "high": high.tolist(), "height": _HIGH},
        "walls": [{"point": [0.0, 0.0], "outward": [0.0, 0.0]}],
        "yaw": _SOUTH,
        "pitch": _STEEP,
        "items": items,
    }


def _facts(room: HomeRoom, metrics: Mapping[str, Any]) -> dict[str, Any]:
    """What the panel shows of the objects of a room, by their ids in the view."""
    scene = room.scene
    assert scene is not None
    found = object_facts(scene, relation_rows(scene, metrics), faults_of(metrics))
    for facts in found.values():
        facts["carries"] = [f"{room.id}/{name}" for name in facts["carries"]]
        if facts["support"] is not None:
            facts["support"] = {**facts["support"], "object": f"{room.id}/{facts['support']['object']}"}
    return {f"{room.id}/{name}": facts for name, facts in found.items()}
