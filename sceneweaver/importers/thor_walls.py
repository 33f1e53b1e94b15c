"""Walls of AI2-THOR's houses: how high they are, and the doors, windows and gaps in them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .model import SourceOpening
from .plans import Outline, along, holds, on_wall
from .values import Entry


def wall_heights(house: Entry) -> dict[str, float]:
    """Height [m] of the walls of each room; under "" that of the house, where it gives one."""
    heights: dict[str, float] = {}
    if house.has("wall_height"):
        heights[""] = house["wall_height"].length()
    for wall in house.listed("walls"):
        if wall.has("polygon"):
            ups = [corner["y"].number() for corner in wall["polygon"].entries()]
            room = wall.word("roomId")
            heights[room] = max(heights.get(room, 0.0), max(ups, default=0.0) - min(ups, default=0.0))
    return {room: height for room, height in heights.items() if height > 0}


def openings_of(
    house: Entry, outlines: Mapping[str, Outline], notes: dict[str, list[str]]
) -> dict[str, list[SourceOpening]]:
    """The openings of each room. Those that lie on no wall are told in ``notes``."""
    found: dict[str, list[SourceOpening]] = {name: [] for name in outlines}
    walls = {wall["id"].text(): wall for wall in house.listed("walls")}
    for key in ("doors", "windows"):
        for item in house.listed(key):
            rooms = [item.word(k) for k in ("room0", "room1", "roomId") if item.word(k) in outlines]
            opening = _opening(item, walls, key == "doors")
            for room in dict.fromkeys(rooms):
                if opening is None:
                    notes[room].append(f"{item.word('id', key)}: it has no wall with a hole; left out")
                    continue
                others = [r for r in rooms if r != room]
                swings = key == "doors" and not item.has("doorSegment") and _swings_out(opening, outlines[room])
                found[room].append(_leading(opening, others[0] if others else None, swings))
            if not rooms:
                notes[next(iter(outlines))].append(f"{item.word('id', key)}: belongs to no room; left out")
    for name, start, end in _gaps(house, walls):
        rooms = [room for room, outline in outlines.items() if on_wall(outline, start, end)]
        for room in rooms:
            others = [r for r in rooms if r != room]
            if not any(o.kind == "passage" and _same(o, start, end) for o in found[room]):
                gap = SourceOpening(name, "passage", start, end, 0.0, None)
                found[room].append(_leading(gap, others[0] if others else None, False))
    return found


def _leading(opening: SourceOpening, room: str | None, out: bool) -> SourceOpening:
    swing = "out" if out and opening.kind == "door" else None
    return replace(opening, swing=swing, leads_to=room)


def _swings_out(opening: SourceOpening, outline: Outline) -> bool:
    """Whether a door turns away from a room: ProcTHOR's turn to the left of their wall's direction, seen from above."""
    start, end = np.array(opening.start), np.array(opening.end)
    along = (end - start) / np.hypot(*(end - start))
    x, y = (start + end) / 2 + 0.1 * np.array((-along[1], along[0]))
    return not holds(outline, float(x), float(y))


def _opening(item: Entry, walls: Mapping[str, Entry], is_door: bool) -> SourceOpening | None:
    """A door or window, from its hole in the wall; None where it has none."""
    if item.has("holePolygon"):
        corners = list(item["holePolygon"].entries())
        if len(corners) < 2:
            return None
        hole = np.array([corner.named("xy") for corner in corners])
    elif item.has("boundingBox"):  # before schema 1.0.0
        hole = np.array([item["boundingBox"][k].named("xy") for k in ("min", "max")])
    else:
        return None
    (left, bottom), (right, top) = hole.min(axis=0).tolist(), hole.max(axis=0).tolist()
    segment = next((item[k] for k in ("doorSegment", "windowSegment") if item.has(k)), None)
    if segment is not None:
        ends = [end.numbers(2) for end in segment.entries()]
        if len(ends) != 2:
            raise segment.error("must hold two ends [x, z]")
        start, end = (tuple(p) for p in ends)
    else:
        wall = next((walls[item.word(k)] for k in ("wall0", "wall1") if item.word(k) in walls), None)
        base = _base(wall) if wall is not None else None
        if base is None:
            return None
        start, end = along(*base, left, right)
    kind = "window" if not is_door else "passage" if _is_frame(item) else "door"
    return SourceOpening(
        item["id"].text(), kind, (start[0], start[1]), (end[0], end[1]), max(0.0, bottom), top - bottom
    )


def _is_frame(item: Entry) -> bool:
    """Whether a door has no leaf."""
    return item.word("assetId").lower().startswith("doorframe") or item.word("type").lower() == "doorframe"


def _base(wall: Entry) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """The two lower corners (x, z) of a wall, in the order of the file; holes count from the first."""
    if wall.has("polygon"):
        corners = [corner.named("xyz") for corner in wall["polygon"].entries()]
        low = min((c[1] for c in corners), default=0.0)
        ends = [(c[0], c[2]) for c in corners if c[1] <= low + 1e-4]
    elif wall.has("segment"):
        ends = [(a, b) for a, b in (end.numbers(2) for end in wall["segment"].entries())]
    else:
        return None
    if len(ends) != 2 or np.hypot(*np.subtract(ends[0], ends[1])) < 1e-6:
        return None
    return ends[0], ends[1]


def _gaps(house: Entry, walls: Mapping[str, Entry]) -> list[tuple[str, tuple[float, float], tuple[float, float]]]:
    """Walls that are not built: those that ProcTHOR calls empty, and the open walls of Holodeck."""
    gaps = []
    for name, wall in walls.items():
        base = _base(wall) if wall.get("empty") is True else None
        if base is not None:
            gaps.append((name, *base))
    open_walls = house.find("open_walls")
    if open_walls is not None and isinstance(open_walls.value, dict):
        for i, segment in enumerate(open_walls.listed("segments")):
            ends = [end.numbers(2) for end in segment.entries()]
            if len(ends) == 2:
                gaps.append((f"open wall {i}", (ends[0][0], ends[0][1]), (ends[1][0], ends[1][1])))
    return gaps


def _same(opening: SourceOpening, start: tuple[float, float], end: tuple[float, float]) -> bool:
    """Whether an opening has these two ends, in either order."""
    pairs = ((opening.start, start), (opening.end, end)), ((opening.start, end), (opening.end, start))
    return any(all(np.hypot(*np.subtract(p, q)) < 0.02 for p, q in pair) for pair in pairs)
