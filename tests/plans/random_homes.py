"""Random homes, most of them bad ones, on a grid of 50 mm: rows and columns of cells, joined to rooms."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import shapely

from sceneweaver.home import Home
from sceneweaver.io import InputError

STEP = 50
"""Coordinates are multiples of this [mm]."""

TYPES = ("hall", "living_room", "kitchen", "bedroom", "bathroom", "storage_room", "dining_room", "guest_toilet")


def random_home(seed: int, storeys: int = 1) -> Home:
    """A home of rooms that cells of a grid were joined to, some a little moved, with doors and windows anywhere."""
    rng = random.Random(f"random home {seed}")
    rooms: list[dict[str, Any]] = []
    for storey in range(storeys):
        for outline in _outlines(rng):
            kind = rng.choice(TYPES)
            rooms.append({"id": f"r{len(rooms)}", "type": kind, "storey": f"s{storey}", "outline": outline})
    data: dict[str, Any] = {
        "id": "random",
        "storeys": [{"id": f"s{k}", "elevation": 3.0 * k, "height": 2.6} for k in range(storeys)],
        "rooms": rooms,
    }
    for _ in range(8 * len(rooms)):
        _try_door(rng, data)
    for _ in range(2 * len(rooms)):
        _try_window(rng, data)
    return Home.model_validate(data)


def _outlines(rng: random.Random) -> list[list[list[float]]]:
    columns = [0, *_sums(rng, rng.randint(2, 4))]
    rows = [0, *_sums(rng, rng.randint(2, 4))]
    cells = [(i, j) for i in range(len(columns) - 1) for j in range(len(rows) - 1)]
    rng.shuffle(cells)
    rooms: list[set[tuple[int, int]]] = []
    while cells:
        room = {cells.pop()}
        for _ in range(rng.randint(0, 2)):
            beside = [c for c in cells if any(abs(c[0] - d[0]) + abs(c[1] - d[1]) == 1 for d in room)]
            if beside:
                room.add(rng.choice(beside))
                cells = [c for c in cells if c not in room]
        rooms.append(room)
    if len(columns) > 3 and len(rows) > 3 and rng.random() < 0.6:
        rooms = [room for room in rooms if (1, 1) not in room]  # a place within that is no room
    found: list[list[list[float]]] = []
    for room in rooms:
        whole = shapely.union_all([shapely.box(columns[i], rows[j], columns[i + 1], rows[j + 1]) for i, j in room])
        clear = whole.buffer(-50, join_style="mitre").simplify(0)
        if not isinstance(clear, shapely.Polygon) or clear.interiors or clear.is_empty:
            continue
        dx, dy = (rng.choice((0,) * 12 + (50, -50, 150, -150)) for _ in range(2))
        ring = shapely.geometry.polygon.orient(clear).exterior.coords[:-1]
        found.append([[round((x + dx) / STEP) * STEP / 1000, round((y + dy) / STEP) * STEP / 1000] for x, y in ring])
    return found


def _sums(rng: random.Random, count: int) -> list[int]:
    at, found = 0, []
    for _ in range(count):
        at += rng.randrange(900, 4000, STEP)
        found.append(at)
    return found


def _try_door(rng: random.Random, data: dict[str, Any]) -> None:
    rooms: Sequence[dict[str, Any]] = data["rooms"]
    room = rng.choice(rooms)
    place = _place(rng, room["outline"], rng.choice((600, 800, 800, 900, 1200, 1500)))
    if place is None:
        return
    others = [r["id"] for r in rooms if r is not room and r["storey"] == room["storey"]]
    to = rng.choice(others) if others and rng.random() < 0.95 else None
    kind = rng.choice(("hinged", "hinged", "hinged", "double", "sliding", "open"))
    door = {
        "id": f"d{len(data.get('doors', ()))}",
        "room": room["id"],
        **place,
        "to": to,
        "kind": kind,
        "opens_into": rng.choice([room["id"], to]) if kind in ("hinged", "double") else None,
        "hinge": rng.choice(("left", "right")),
    }
    _keep(data, "doors", door)


def _try_window(rng: random.Random, data: dict[str, Any]) -> None:
    room = rng.choice(data["rooms"])
    place = _place(rng, room["outline"], rng.choice((500, 800, 1200, 1800)))
    if place is not None:
        _keep(data, "windows", {"id": f"w{len(data.get('windows', ()))}", "room": room["id"], **place})


def _place(rng: random.Random, outline: list[list[float]], width: int) -> dict[str, Any] | None:
    wall = rng.randrange(len(outline))
    (ax, ay), (bx, by) = outline[wall], outline[(wall + 1) % len(outline)]
    free = round((abs(ax - bx) + abs(ay - by)) * 1000) - width
    if free < 0:
        return None
    return {"wall": wall, "offset": rng.randrange(0, free + 1, STEP) / 1000, "width": width / 1000}


def _keep(data: dict[str, Any], key: str, part: dict[str, Any]) -> None:
    """Add a part where the home takes it."""
    tried = {**data, key: [*data.get(key, ()), part]}
    try:
        Home.model_validate(tried)
    except InputError:
        return
    data[key] = tried[key]
