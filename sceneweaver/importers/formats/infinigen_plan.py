"""Infinigen's floor plans: ``predefined.json``, rooms and openings as shapes of shapely, by name."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Literal

from sceneweaver.io import load_json

from ..geometry_text import shape
from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..plans import Outline, on_wall
from ..values import Entry

Point = tuple[float, float]
Kind = Literal["door", "window", "passage"]
KINDS: dict[str, Kind] = {"doors": "door", "windows": "window", "opens": "passage"}
DOOR = 2.1
"""Height [m] that doors get, which the file does not give."""
WINDOW = 0.9, 1.2
"""Sill and height [m] that windows get."""


_SHAPE = re.compile(
    rb'"operation"\s*:\s*"shapely\.|"shape"\s*:\s*(?:\{\s*"operation"|"\s*(?:shapely\.|box|Polygon))'
    rb'|:\s*"\s*(?:shapely\.)?(?:geometry\.)?(?:box|Polygon)\s*\('
)


def _matches(path: Path, head: bytes) -> bool:
    return path.suffix.lower() == ".json" and b'"rooms"' in head and _SHAPE.search(head) is not None


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    plan = Entry.of(path, load_json(path))
    outlines: dict[str, Outline] = {}
    for name, item in plan["rooms"].items():
        found = shape(item)
        if not found.closed:
            raise item.error("a room has to be a box or a polygon")
        outlines[name] = found.points
    if not outlines:
        raise plan["rooms"].error("holds no room; give at least one shape by name")
    segments: list[tuple[str, Kind, Point, Point, Entry]] = [
        (f"{name}{f'.{i}' if i else ''}", kind, a, b, item)
        for key, kind in KINDS.items()
        if plan.has(key)
        for name, item in plan[key].items()
        for i, (a, b) in enumerate(pairwise(shape(item).points))
    ]
    levels = {found[1] for room in outlines if (found := re.search(r"_(\d+)/\d+$", room))}
    lost = {name for name, _, a, b, _ in segments if not any(on_wall(o, a, b) for o in outlines.values())}
    for room, outline in outlines.items():
        openings = []
        for name, kind, a, b, item in segments:
            if not on_wall(outline, a, b):
                continue
            others = [r for r, o in outlines.items() if r != room and on_wall(o, a, b)]
            floor = isinstance(item.value, dict) and bool(item.value.get("is_panoramic"))
            bottom, height = (0.0, None) if floor or kind == "passage" else WINDOW if kind == "window" else (0.0, DOOR)
            openings.append(SourceOpening(name, kind, a, b, bottom, height, leads_to=others[0] if others else None))
        notes = [f"{name}: lies on no wall of a room; left out" for name in sorted(lost)]
        if any(o.kind != "passage" for o in openings):
            notes.append(f"doors get {DOOR} m, windows {WINDOW[1]} m from {WINDOW[0]} m: the file has no heights")
        level = re.search(r"_(\d+)/\d+$", room)  # "kitchen_1/0": on the first floor
        yield SourceRoom(
            room,
            re.sub(r"_\d+(?:/\d+)?$", "", room),
            tuple(outline),
            None,
            tuple(openings),
            notes=tuple(notes),
            storey=level[1] if level and len(levels) > 1 else "",
        )


FORMAT = SourceFormat(
    "infinigen-plan",
    "Infinigen's predefined floor plans",
    _matches,
    _read,
    notes=(
        "Read: rooms as shapely.box or Polygon, doors, windows and opens as LineString, as data or as text.",
        "Expressions are read by a grammar of numbers and brackets; nothing is ever evaluated.",
        "A line of several parts is an opening a part; heights are not in the file. Rooms come without furniture.",
    ),
    licence="BSD-3-Clause",
)
