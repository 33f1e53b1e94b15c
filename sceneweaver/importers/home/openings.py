"""Doors and windows of a storey: each once, in the walls of the rooms on its two sides."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.home.shells import FACING

from ..model import SourceOpening

BEFORE, BEHIND = 0.3, 0.7
"""How far [m] the middle of an opening may lie inside a room, and behind the face of its wall."""

MERGE = 0.2
"""Openings of one kind whose middles are nearer than this [m] are one, which two rooms have."""

LEAST = 0.4
"""Least width [m] of a door or window that is kept."""

APART = 0.01
"""Least distance [m] of two openings of one wall."""

SLANTED = 0.004
"""Play [m] at both ends of an opening in a slanted wall: the wall behind it is parallel but for the grid."""

MOST = 0.5
"""Most distance [m] that an opening is moved along its wall."""


@dataclass(frozen=True)
class Opening:
    """An opening of a storey: as the file has it, and the rooms that have it."""

    source: SourceOpening
    rooms: tuple[int, ...]


@dataclass(frozen=True)
class Placed:
    """An opening in a wall of ``room``, from ``offset`` [m] of that wall on; ``to`` is the room behind, None: none."""

    source: SourceOpening
    room: int
    wall: int
    offset: float
    width: float
    to: int | None


@dataclass
class Walls:
    """The walls of a storey's rooms, and what of them is taken."""

    rooms: list[tuple[Wall, ...]]
    taken: dict[tuple[int, int], list[tuple[float, float]]] = field(default_factory=dict)

    @classmethod
    def of(cls, outlines: Sequence[Sequence[Sequence[float]]]) -> Walls:
        """The walls of rooms by their outlines, counter-clockwise."""
        return cls([walls_of(outline) for outline in outlines])


def unified(found: Iterable[tuple[int, SourceOpening]]) -> list[Opening]:
    """Openings, each once: what two rooms have under one name or at one place is one."""
    kept: list[Opening] = []
    for room, source in found:
        for k, other in enumerate(kept):
            if _same(other.source, source):
                swing = other.source.swing if other.source.swing not in (None, "out") else source.swing
                leads = other.source.leads_to or source.leads_to
                swung = other.source if swing == other.source.swing else replace(other.source, swing=swing)
                kept[k] = Opening(replace(swung, leads_to=leads), (*other.rooms, room))
                break
        else:
            kept.append(Opening(source, (room,)))
    return kept


def _same(a: SourceOpening, b: SourceOpening) -> bool:
    if a.kind != b.kind:
        return False
    apart = math.dist(_middle(a), _middle(b))
    return apart < MERGE or (a.name == b.name != "" and apart < BEHIND)


def _middle(o: SourceOpening) -> tuple[float, float]:
    return (o.start[0] + o.end[0]) / 2, (o.start[1] + o.end[1]) / 2


def place(opening: Opening, walls: Walls, *, only: bool = False) -> Placed | str:
    """The opening in a wall of a room and, where there is one, of the room behind; or why it has none.

    Args:
        opening: with its rooms as the file has them.
        walls: get what the opening takes.
        only: whether no other rooms than those come into question.
    """
    source = opening.source
    sides = _sides(opening, walls, only)
    if only and len(sides) != len(opening.rooms):
        return "its rooms have no walls there"
    if not sides:
        return "no wall of a room is near it"
    room, wall, low, high = sides[0]
    other = sides[1] if len(sides) > 1 else None
    wanted, least, most = high - low, 0.0, wall.length
    if other is not None:
        back = other[1].along
        if wall.along[0] * back[0] + wall.along[1] * back[1] > FACING:
            return "the walls on its two sides are not parallel"
        faced = _behind(wall, other[1])
        least, most = max(0.0, faced[0]), min(wall.length, faced[1])
    fitted = _fitted(low, high, least, most)
    if fitted is None:
        return "its wall is elsewhere" if other is None else "the walls on its two sides do not lie behind each other"
    low, high = _whole(*fitted, least, most)
    free = _free(low, high, room, wall, other, walls, 0.0 if source.kind == "passage" else APART)
    if free is None:
        return "another opening is there"
    play = 0.0 if 0.0 in (round(wall.along[0], 9), round(wall.along[1], 9)) else SLANTED
    low, high = (_up(free[0] + play), _down(free[1] - play))
    if high - low < LEAST:
        return f"{high - low:.2f} m of its {wanted:.2f} m are left; {LEAST:g} m are needed"
    walls.taken.setdefault((room, wall.index), []).append((low, high))
    if other is not None:
        first, last = other[1].coordinates(wall.point(low))[0], other[1].coordinates(wall.point(high))[0]
        walls.taken.setdefault((other[0], other[1].index), []).append((min(first, last), max(first, last)))
    return Placed(source, room, wall.index, low, round(high - low, 3), None if other is None else other[0])


def _whole(low: float, high: float, least: float, most: float) -> tuple[float, float]:
    """An interval in whole millimetres, as wide as before where there is room."""
    width = _down(high - low)
    start = min(max(round(low, 3), _up(least)), _down(most - width))
    return start, start + width


def _up(value: float) -> float:
    return math.ceil(value * 1000 - 1e-4) / 1000


def _down(value: float) -> float:
    return math.floor(value * 1000 + 1e-4) / 1000


def _sides(opening: Opening, walls: Walls, only: bool) -> list[tuple[int, Wall, float, float]]:
    """The nearest wall on each of the two sides of an opening, with its extent along that wall; one or two."""
    source = opening.source
    width = math.dist(source.start, source.end)
    if width < 1e-6:
        return []
    way = ((source.end[0] - source.start[0]) / width, (source.end[1] - source.start[1]) / width)
    middle = _middle(source)
    best: dict[bool, tuple[float, int, Wall, float, float]] = {}
    for room, mine in enumerate(walls.rooms):
        if only and room not in opening.rooms:
            continue
        for wall in mine:
            cosine = wall.along[0] * way[0] + wall.along[1] * way[1]
            if abs(cosine) < 0.97:
                continue
            s, depth = wall.coordinates(middle)
            if not -BEHIND <= depth <= BEFORE:
                continue
            (a, _), (b, _) = wall.coordinates(source.start), wall.coordinates(source.end)
            low, high = min(a, b), max(a, b)
            shared = min(high, wall.length) - max(low, 0.0)
            if shared < 0.5 * min(width, 1.2) and not 0 <= s <= wall.length:
                continue
            # a room that the file names comes before one that only lies near
            cost = abs(depth) + (0.0 if room in opening.rooms else 0.15) + 0.2 * max(0.0, width - shared)
            side = cosine > 0
            if side not in best or cost < best[side][0]:
                best[side] = (cost, room, wall, low, high)
    found = sorted(best.values(), key=lambda b: b[0])
    if len(found) == 2 and (found[0][1] == found[1][1] or source.leads_to == "outside"):
        found = found[:1]
    return [(room, wall, low, high) for _, room, wall, low, high in found]


def _behind(wall: Wall, other: Wall) -> tuple[float, float]:
    """What of a wall another that faces it lies behind, as its ends along the wall [m]."""
    a, b = wall.coordinates(other.start)[0], wall.coordinates(other.end)[0]
    return min(a, b), max(a, b)


def _fitted(low: float, high: float, least: float, most: float) -> tuple[float, float] | None:
    """An interval moved, and where that is not enough shortened, into another; None: it would have to move too far."""
    if most - least < LEAST:
        return None
    width = min(high - low, most - least)
    start = min(max((low + high - width) / 2 if width < high - low else low, least), most - width)
    return (start, start + width) if abs(start + width / 2 - (low + high) / 2) <= MOST else None


def _free(
    low: float,
    high: float,
    room: int,
    wall: Wall,
    other: tuple[int, Wall, float, float] | None,
    walls: Walls,
    apart: float,
) -> tuple[float, float] | None:
    """What of an interval of a wall no other opening has, on either side; None: nothing of use."""
    low, high = max(0.0, low), min(wall.length, high)
    taken = list(walls.taken.get((room, wall.index), []))
    if other is not None:
        for a, b in walls.taken.get((other[0], other[1].index), []):
            ends = [wall.coordinates(other[1].point(t))[0] for t in (a, b)]
            taken.append((min(ends), max(ends)))
    for a, b in taken:
        if low < b + apart and high > a - apart:
            before, after = a - apart - low, high - b - apart
            if max(before, after) < LEAST:
                return None
            low, high = (low, a - apart) if before >= after else (b + apart, high)
    return low, high
