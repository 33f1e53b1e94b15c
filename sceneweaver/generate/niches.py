"""Niches that a request describes: the outline goes out where a wall has room for one."""

from __future__ import annotations

from sceneweaver.geometry.seen import are_opposite, is_wall
from sceneweaver.geometry.walls import Wall
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import StatedOpening
from sceneweaver.scene import Room

WIDTH, DEPTH = 1.2, 0.45
"""Of a niche that nothing is said of [m]."""

EDGE = 0.3
"""Wall [m] that is left on both sides of a niche."""


def with_niches(room: Room, brief: SceneGraph) -> tuple[Room, list[str]]:
    """The room with the niches that are described, and those for which no wall has room."""
    notes: list[str] = []
    for one in brief.openings:
        for _ in range(one.count if one.part == "niche" else 0):
            made = _with_niche(room, one)
            if made is None:
                notes.append(f"no wall has room for the {one.words or 'niche'}")
            else:
                room = made
    return room, notes


def _with_niche(room: Room, one: StatedOpening) -> Room | None:
    walls = room.walls
    entry = walls[room.doors[0].wall] if room.doors else None
    places: list[tuple[float, Wall, float]] = []
    for wall in walls:
        if not is_wall(one.wall, wall, walls, entry):
            continue
        if one.opposite == "door" and entry is not None and not are_opposite(wall, entry):
            continue
        taken = sorted((o.offset, o.offset + o.width) for o in (*room.doors, *room.windows) if o.wall == wall.index)
        starts, ends = [0.0, *(end for _, end in taken)], [*(start for start, _ in taken), wall.length]
        low, high = max(zip(starts, ends, strict=True), key=lambda row: row[1] - row[0])
        places.append((high - low, wall, (low + high) / 2))
    if not places:
        return None
    room_there, wall, middle = max(places, key=lambda row: row[0])
    width = min(one.width or WIDTH, room_there - 2 * EDGE)
    return None if width < 0.5 else _opened(room, wall, round(middle - width / 2, 3), round(width, 3))


def _opened(room: Room, wall: Wall, start: float, width: float) -> Room:
    """The room with a niche in a wall [m]; what lies behind it in the wall, and in later walls, has new numbers."""
    corners = [
        wall.point(start),
        wall.point(start, -DEPTH),
        wall.point(start + width, -DEPTH),
        wall.point(start + width),
    ]
    outline = list(room.outline)
    outline[wall.index + 1 : wall.index + 1] = [(round(x, 3), round(y, 3)) for x, y in corners]

    def moved(one):
        if one.wall > wall.index:
            return one.model_copy(update={"wall": one.wall + 4})
        if one.wall == wall.index and one.offset >= start + width:
            return one.model_copy(update={"wall": one.wall + 4, "offset": round(one.offset - start - width, 3)})
        return one

    doors, windows = tuple(map(moved, room.doors)), tuple(map(moved, room.windows))
    return Room(type=room.type, outline=tuple(outline), height=room.height, doors=doors, windows=windows)


__all__ = ["with_niches"]
