"""Niches, chimney breasts and bays that a request describes: the outline goes out, or in, where a wall has room for it.

What stands in one or at it decides how wide and deep it is, where the request does not say.
"""

from __future__ import annotations

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.seen import ahead_of, are_opposite, is_wall
from sceneweaver.geometry.walls import Point, Wall, walls_of
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import StatedOpening
from sceneweaver.language.told_openings import entry_stated, is_bay
from sceneweaver.scene import Room, Window

WIDTH, DEPTH = 1.2, 0.45
"""Of a niche of which nothing is said, and in which nothing stands [m]."""

DEEPEST, WIDEST = 2.2, 3.2
"""Of a niche, whatever stands in it [m]."""

BREAST = 1.5, 0.4
"""Width and depth [m] of a chimney breast of which nothing is said."""

BAY = 0.65
"""Depth [m] of a bay of which nothing is said."""

HIGHEST_SILL = 1.05
"""Sill [m] of a bay's window over what stands before it, at most."""

SLANT = 0.3
"""How much narrower [m] a bay is at its back, on each side."""

PLAY = 0.1
"""Width [m] that is left beside what stands in a niche, or by which a breast is wider than what is at it."""

PIER = 0.3
"""Width [m] of a breast on both sides of what is in it."""

EDGE = 0.3
"""Wall [m] that is left on both sides of it."""

LEAST = 0.5
"""Width [m] of what is built at all."""


def with_wall_parts(room: Room, brief: SceneGraph) -> tuple[Room, list[str]]:
    """The room with the niches, breasts and bays that are described, and those for which no wall has room."""
    notes: list[str] = []
    breast = any(one.part == "breast" for one in brief.openings)
    for one in brief.openings:
        if one.part == "niche" and breast and "beside" in one.features:
            continue  # what is left of the wall beside the breast
        for _ in range(one.count if one.part in ("niche", "breast") else 0):
            made = _with_part(room, one, brief)
            if made is None:
                notes.append(f"no wall has room for the {one.words or one.part}")
            room = made or room
        if is_bay(one):
            made = _with_bay(room, one, brief)
            if made is None:
                notes.append(f"no window has wall enough for the {one.words or 'bay'}")
            room = made or room
    return room, notes


def _at(brief: SceneGraph, part: str) -> list[tuple[float, float, float]]:
    """Depth, width and height [m] of what is said to stand at a part of a wall."""
    found: list[tuple[float, float, float]] = []
    for said in brief.relations:
        entity = brief.entity(said.subject)
        if entity is None or f"wall:{part}" not in said.targets or said.type in ("facing", "opposite", "in_front_of"):
            continue
        category = category_named(entity.category)
        if category.size is None or "floor" not in category.mount or {"wall", "surface"} & set(category.mount):
            continue
        usual = (sum(category.size.depth) / 2, sum(category.size.width) / 2, category.size.height[1])
        depth, width, tall = (told or size for told, size in zip(entity.size, usual, strict=True))
        found += [(depth, width, tall)] * (entity.count[0] if entity.count else 1)
    return found


def _sizes(one: StatedOpening, brief: SceneGraph) -> tuple[float, float]:
    """Width and depth [m] of a niche or a breast."""
    inside = _at(brief, "breast_opening") if one.part == "breast" else []
    if inside:  # two piers with what is in it between them
        depth = max(BREAST[1], min(max(d for d, *_ in inside), DEEPEST / 2))
        return one.width or sum(w for _, w, _ in inside) + PLAY + 2 * PIER, one.depth or depth
    there = _at(brief, one.part)
    share = there[: max(1, -(-len(there) // max(1, one.count)))]
    if one.part == "breast":
        width = max([BREAST[0], *(w + PLAY for _, w, _ in share)]) if not share else max(w + PLAY for _, w, _ in share)
        return one.width or min(max(width, 1.0), WIDEST), one.depth or BREAST[1]
    width = sum(w for _, w, _ in share) + PLAY if share else WIDTH
    depth = max((d for d, *_ in share), default=DEPTH)
    return one.width or min(max(width, 0.6), WIDEST), one.depth or min(max(depth + 0.02, 0.35), DEEPEST)


def _with_part(room: Room, one: StatedOpening, brief: SceneGraph) -> Room | None:
    walls = room.walls
    wanted, depth = _sizes(one, brief)
    places: list[tuple[bool, float, Wall, float]] = []
    for wall in _suiting(room, one, brief):
        for low, high in _bare(room, wall):
            middle = wall.length / 2 if low < wall.length / 2 - LEAST < high - 2 * LEAST else (low + high) / 2
            most = 2 * min(middle - low, high - middle)
            places.append((most - 2 * EDGE >= wanted, most, wall, middle))
    if not places:
        return None
    fits, most, wall, middle = max(places, key=lambda row: (row[0], row[1]))
    width = min(wanted, most - 2 * EDGE)
    if width < LEAST:
        return None
    start = round(middle - width / 2, 3)
    into = depth if one.part == "breast" else -depth
    if one.part == "breast" and any("wall:breast_opening" in said.targets for said in brief.relations):
        right = _bent(room, wall, (round(start + width - PIER, 3), round(start + width, 3)), 0.0, into)
        return _bent(right, right.walls[wall.index], (start, round(start + PIER, 3)), 0.0, into)
    return _bent(room, walls[wall.index], (start, start + width), 0.0, into)


def _with_bay(room: Room, one: StatedOpening, brief: SceneGraph) -> Room | None:
    """The room with a bay about one of its windows, which is in the wall that the request says."""
    there = _at(brief, "bay")
    walls, depth = room.walls, one.depth or min(max([BAY, *(d for d, *_ in there)]), DEEPEST / 2)
    suiting = {wall.index for wall in _suiting(room, one, brief)}
    for window in sorted(room.windows, key=lambda window: -window.width):
        if window.wall not in suiting:
            continue
        wall = walls[window.wall]
        low, high = next(
            (row for row in _bare(room, wall, without=window) if row[0] <= window.offset < row[1]), (0.0, 0.0)
        )
        middle = window.offset + window.width / 2
        wanted = max(window.width + 2 * PLAY, sum(w + PLAY for _, w, _ in there) + PLAY)
        half = min(wanted / 2 + SLANT, middle - low - EDGE, high - middle - EDGE)
        back = 2 * (half - SLANT)
        if back < 0.8:
            continue
        bent = _bent(room, wall, (round(middle - half, 3), round(middle + half, 3)), SLANT, -depth, window.id)
        width = round(min(window.width, back - 0.1), 3)
        top = window.sill + window.height
        sill = window.sill if one.sill is not None else min(max([window.sill, *(h for *_, h in there)]), HIGHEST_SILL)
        moved = window.model_copy(
            update={
                "wall": wall.index + 2,
                "offset": round((back - width) / 2, 3),
                "width": width,
                "sill": round(sill, 2),
                "height": round(top - sill, 2),
            }
        )
        return bent.model_copy(update={"windows": tuple(moved if w.id == moved.id else w for w in bent.windows)})
    return None


def _suiting(room: Room, one: StatedOpening, brief: SceneGraph) -> list[Wall]:
    """The walls that what is said of a part of a wall means."""
    walls, found = room.walls, list[Wall]()
    entry = walls[room.doors[0].wall] if room.doors else None
    first = entry_stated(brief)
    ahead = ahead_of(entry, first.wall if first is not None else "any") if entry is not None else None
    for wall in walls:
        across = one.opposite != "door" or entry is None or are_opposite(wall, entry)
        if across and is_wall(one.wall, wall, walls, entry, ahead, one.run):
            found.append(wall)
    return found


def _bare(room: Room, wall: Wall, without: Window | None = None) -> list[tuple[float, float]]:
    """The stretches of a wall [m] without doors and windows."""
    taken = sorted(
        (o.offset, o.offset + o.width) for o in (*room.doors, *room.windows) if o.wall == wall.index and o != without
    )
    starts, ends = [0.0, *(end for _, end in taken)], [*(start for start, _ in taken), wall.length]
    return [(low, high) for low, high in zip(starts, ends, strict=True) if high - low > LEAST]


def _bent(room: Room, wall: Wall, ends: tuple[float, float], slant: float, into: float, about: str = "") -> Room:
    """The room with a part of a wall moved into it [m], or out of it; openings behind it get new numbers of walls.

    Args:
        room: the room.
        wall: which wall.
        ends: where the part begins and ends on it [m].
        slant: how much narrower the part is at its other end [m], on each side.
        into: how far it is moved into the room [m].
        about: the window that the part is about, which the caller moves.
    """
    low, high = ends
    corners = (wall.point(low), wall.point(low + slant, into), wall.point(high - slant, into), wall.point(high))
    outline: list[Point] = list(room.outline)
    outline[wall.index + 1 : wall.index + 1] = [(round(float(x), 3), round(float(y), 3)) for x, y in corners]

    def moved(one):
        if one.wall > wall.index:
            return one.model_copy(update={"wall": one.wall + 4})
        if one.wall == wall.index and one.offset >= high and one.id != about:
            return one.model_copy(update={"wall": one.wall + 4, "offset": round(one.offset - high, 3)})
        return one

    windows = tuple(moved(one) for one in room.windows)
    if about:  # a place that is free until the caller says which
        back = walls_of(outline)[wall.index + 2].length
        at = {"wall": wall.index + 2, "offset": 0.0, "width": round(min(0.3, back), 3)}
        windows = tuple(one.model_copy(update=at) if one.id == about else one for one in windows)
    return Room(
        type=room.type,
        outline=tuple(outline),
        height=room.height,
        doors=tuple(moved(one) for one in room.doors),
        windows=windows,
    )


__all__ = ["with_wall_parts"]
