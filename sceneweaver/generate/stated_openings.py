"""Doors and windows that a request describes: the walls that suit all that is said of them, and their places there."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product

from sceneweaver.geometry.seen import ahead_of, are_opposite, is_wall
from sceneweaver.geometry.walls import Point, Wall
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import StatedOpening
from sceneweaver.language.told_openings import entry_stated, is_high_up
from sceneweaver.scene.room import Swing

SAME_LENGTH = 0.15
"""Length [m] by which a wall may differ from what was said of it."""

EDGE = 0.15
"""Wall [m] that is left at its ends and between two openings."""

ASSIGNMENTS = 2000
"""Assignments of walls that are tried for one entry, about."""

MOST_APART = 5
"""Openings in walls of their own for which all assignments are tried."""

CORNER = 0.15
"""Distance [m] from the corner of what is said to be in it."""

LOW_DOOR, CRAWL = 1.2, 0.75
"""Heights [m] of a low door, and of a way in to crawl through, which is as wide."""

SLIT = 0.25, 0.9
"""Sides [m] of a small slit."""

UP, LOW = 1.6, 0.4
"""Sills [m] of windows that are said to be high up, at least, and of low ones."""

DOUBLE, WIDE, LARGE, SMALL = 1.5, 1.2, 1.8, 0.6
"""Widths [m]: of a double door, of a wide one, of a large window and of a small one."""


@dataclass(frozen=True)
class Opened:
    """An opening in a wall: its number, where it begins, and its width [m]."""

    wall: int
    offset: float
    width: float


@dataclass(frozen=True)
class Told:
    """The wall of the first door, and that of each opening that is described, by its id."""

    entry: int
    where: Mapping[str, int]


def walls_stated(brief: SceneGraph, walls: Sequence[Wall], entries: Sequence[int], rng: random.Random) -> Told:
    """The wall of the first door, and that of each opening that is described.

    Of all assignments that suit what is said the one is drawn in which openings have most wall. Where none suits, what
    was said last is left out, one by one.
    """
    stated = [one for one in brief.openings if one.part in ("door", "window")]
    first = entry_stated(brief)
    names = [one.id for one in stated]
    for many in range(len(stated), -1, -1):
        kept = stated[:many]
        found: list[tuple[float, int, dict[str, int]]] = []
        least = sum("apart" in one.features for one in kept)
        for entry in range(len(walls)) if first in kept or kept else entries:
            ahead = ahead_of(walls[entry], first.wall if first is not None and first in kept else "any")
            alone = [_walls_for(one, walls, entry, ahead, kept, one is first) for one in stated]
            for chosen in product(*(_longest(several, walls, len(stated), least) for several in alone)):
                where = dict(zip(names, chosen, strict=True))
                if all(_faces(one, where, walls, entry) for one in kept) and _are_apart(kept, where):
                    beside = 2.0 * (first not in kept and entry not in entries)
                    found.append((_score(stated, where, walls, entry, rng) - beside, entry, where))
        if found:
            _, entry, where = max(found, key=lambda row: row[0])
            return Told(entry, where)
    raise AssertionError("without any statement every wall suits")


def place(
    one: StatedOpening, wall: Wall, width: float, taken: Sequence[Opened], usual: float, number: int, many: int
) -> float | None:
    """Where an opening begins [m] in its wall, off those that are there; None where it has no room.

    Args:
        one: what is said of it.
        wall: in which it is.
        width: of it [m].
        taken: the openings of the room so far.
        usual: where it would begin [m] if nothing was said.
        number, many: which of how many of one statement in this wall it is.
    """
    play = wall.length - width
    # A wall runs counter-clockwise: who looks at it from the room has its end at the left.
    wanted = {"middle": play / 2, "left": play - CORNER, "right": CORNER, "corner": CORNER, "along": play / 2}
    if many > 1:
        gap = (wall.length - many * width) / (many + 1)
        first = gap + number * (width + gap)
    else:
        first = wanted.get(one.at, min(max(usual, min(EDGE, play / 2)), play - min(EDGE, play / 2)))
    others = [(row.offset - EDGE, row.offset + row.width + EDGE) for row in taken if row.wall == wall.index]
    steps = [first + sign * 0.05 * k for k in range(int(wall.length / 0.05) + 1) for sign in (1, -1)]
    for start in steps if one.at == "any" or many > 1 else steps[:9]:
        inside = start - min(EDGE, play / 2) >= -1e-9 and start + width <= wall.length - min(EDGE, play / 2) + 1e-9
        if inside and all(start + width <= low or start >= high for low, high in others):
            return round(start, 3)
    return None


def door_width(one: StatedOpening, usual: float) -> float:
    """The width [m] of a door that is described."""
    if one.width is not None:
        return one.width
    if {"double", "french", "patio"} & set(one.features) or {"sliding", "glass"} <= set(one.features):
        return DOUBLE
    if CRAWLED & set(one.features):
        return CRAWL
    return WIDE if "wide" in one.features else 2.4 if "garage" in one.features else usual


CRAWLED = frozenset(("crawl in", "crawl through"))
"""Kinds of doors that one crawls through."""


def door_height(one: StatedOpening, usual: float) -> float:
    """The height [m] of a door that is described."""
    if one.height is not None:
        return one.height
    kinds = set(one.features)
    return CRAWL if kinds & CRAWLED else LOW_DOOR if kinds & {"low", "tiny"} else usual


def door_swing(one: StatedOpening, usual: Swing) -> Swing:
    """How a door that is described opens, where that is said; else as is usual."""
    kinds = set(one.features)
    if kinds & {"sliding", "pocket"}:
        return "slide"
    if kinds & {"outward", "outward opening"}:
        return "out"
    return "in-left" if kinds & {"inward", "inward opening"} else usual


def window_shape(
    one: StatedOpening, width: float, sill: float, tall: float, height: float
) -> tuple[float, float, float]:
    """Width, sill and height [m] of a window that is described, from those of usual ones under a ceiling."""
    kinds = set(one.features)
    if kinds & {"slot", "slit", "ribbon", "strip", "horizontal"}:
        width, sill, tall = max(2.4, width), min(1.45, height - 1.0), 0.4
    if kinds & {"floor to ceiling", "full height", "french", "patio", "glass"}:
        sill, tall = 0.0 if "glass" not in kinds else 0.3, height
    if kinds & {"tall", "high", "sash", "arched", "pointed"}:
        sill, tall = 0.4, height
    if kinds & {"slit"} and kinds & {"vertical", "tall", "narrow"}:
        width, sill, tall = SLIT[0], 0.6, height
    if is_high_up(one):
        sill, tall = max(UP, height - 0.75), 0.5
    elif kinds & {"low"}:
        sill = LOW
    if kinds & {"shop", "picture", "panoramic", "display", "bay", "bow"}:
        width, sill, tall = max(width, 2.0), min(sill, 0.5), max(tall, 1.6)
    if kinds & {"large", "big", "huge", "wide"}:
        width = max(1.25 * width, LARGE)
    if kinds & {"small", "little", "tiny", "narrow", "slim"}:
        width, tall = (SLIT[1], SLIT[0]) if kinds & {"slit", "slot"} and width > SLIT[0] else (min(width, SMALL), tall)
    width = one.width if one.width is not None else width
    sill = one.sill if one.sill is not None else sill
    sill = round(max(0.0, min(sill, height - (0.45 if one.sill is not None else 0.6))), 2)
    tall = one.height if one.height is not None else tall
    return round(width, 2), sill, round(max(0.3, min(tall, height - 0.15 - sill)), 2)


def _walls_for(
    one: StatedOpening, walls: Sequence[Wall], entry: int, ahead: Point, kept: Sequence[StatedOpening], first: bool
) -> list[int]:
    """The walls that suit what is said of an opening by itself; all where nothing of it is kept."""
    if first:
        # Left, right, far and near are seen from this very door.
        seen = "any" if one.wall in ("left", "right", "side", "far", "near") else one.wall
        return [entry] if one not in kept or _is_told(one, seen, walls[entry], walls, entry, ahead) else []
    return [w.index for w in walls if one not in kept or _is_told(one, one.wall, w, walls, entry, ahead)]


def _is_told(one: StatedOpening, seen: str, wall: Wall, walls: Sequence[Wall], entry: int, ahead: Point) -> bool:
    suits = is_wall(seen, wall, walls, walls[entry], ahead, one.run)
    return suits and (one.wall_length is None or abs(wall.length - one.wall_length) <= SAME_LENGTH)


def _longest(several: Sequence[int], walls: Sequence[Wall], many: int, least: int = 1) -> list[int]:
    """The longest of some walls, as many as leave a bounded number of assignments to so many openings, or ``least``."""
    most = max(1, min(least, MOST_APART), int(ASSIGNMENTS ** (1.0 / max(1, many))))
    return sorted(several, key=lambda k: -walls[k].length)[:most]


def _faces(one: StatedOpening, where: Mapping[str, int], walls: Sequence[Wall], entry: int) -> bool:
    """Whether an opening is across from the one that it is said to be opposite of."""
    if not one.opposite:
        return True
    other = entry if one.opposite == "door" else where.get(one.opposite)
    return other is None or are_opposite(walls[where[one.id]], walls[other])


def _are_apart(kept: Sequence[StatedOpening], where: Mapping[str, int]) -> bool:
    """Whether those of which no two may be in one wall are not."""
    own = [where[one.id] for one in kept if "apart" in one.features]
    return len(set(own)) == len(own)


def _score(
    stated: Sequence[StatedOpening], where: Mapping[str, int], walls: Sequence[Wall], entry: int, rng: random.Random
) -> float:
    """How well openings share the walls: apart, in long ones, windows not beside the door one comes in by."""
    used = [where[one.id] for one in stated]
    apart = len(set(used))
    lengths = sum(walls[where[one.id]].length for one in stated if one.wall != "short")
    beside = sum(one.part == "window" and where[one.id] == entry for one in stated)
    longest = max(wall.length for wall in walls)
    narrow = sum(walls[k].length < 1.0 for k in used)
    return 3.0 * apart + lengths / longest - 4.0 * beside - 5.0 * narrow + rng.random()


__all__ = [
    "Opened",
    "Told",
    "door_height",
    "door_swing",
    "door_width",
    "place",
    "walls_stated",
    "window_shape",
]
