"""Storeys of a plan: their order, where they lie over each other, how high they are."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import median

import numpy as np

from sceneweaver.home import Storey
from sceneweaver.io.messages import quote

from ..model import SourceRoom
from ..outline import HEIGHT

CEILING = 0.3
"""Thickness [m] of a ceiling between two storeys that no file states."""


@dataclass(frozen=True, eq=False)
class PlanRoom:
    """A room on its way: id, type, storey, the outline in the home's frame, and what the file says of it."""

    name: str
    type: str
    storey: int
    outline: tuple[tuple[float, float], ...]
    source: SourceRoom


def levels_of(rooms: Sequence[SourceRoom]) -> list[str]:
    """The names of storeys from below: in order of the numbers in them, then as the file has them."""
    names = list(dict.fromkeys(room.storey for room in rooms))

    def number(name: str) -> tuple[int, float]:
        found = re.search(r"-?\d+(?:\.\d+)?", name)
        return (0, float(found[0])) if found else (1, names.index(name))

    return sorted(names, key=number)


def stacked(rooms: list[PlanRoom], levels: Sequence[str], notes: list[str]) -> list[PlanRoom]:
    """Storeys that a file draws beside each other laid over each other, by their stairs or least corners."""
    if len(levels) < 2:
        return rooms
    below = [room for room in rooms if room.storey == 0]
    moved = list(below)
    for level in range(1, len(levels)):
        here = [room for room in rooms if room.storey == level]
        base, own = _box(below), _box(here)
        if not below or not here or (base[0] < own[2] and own[0] < base[2] and base[1] < own[3] and own[1] < base[3]):
            moved += here
            continue
        stairs = [[r for r in part if r.type == "stairs"] for part in (below, here)]
        anchor = [_middle(_box(part[:1])) for part in stairs] if all(stairs) else [base[:2], own[:2]]
        dx, dy = (round(anchor[0][k] - anchor[1][k], 3) for k in (0, 1))
        moved += [_shifted(room, dx, dy) for room in here]
        notes.append(
            f"storey {quote(levels[level])} is drawn beside the lowest: laid over it by their "
            f"{'stairs' if all(stairs) else 'least corners'}, moved by ({dx:g}, {dy:g}) m"
        )
    return moved


def _box(rooms: Sequence[PlanRoom]) -> tuple[float, float, float, float]:
    points = np.concatenate([np.asarray(r.outline) for r in rooms]) if rooms else np.zeros((1, 2))
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return float(x0), float(y0), float(x1), float(y1)


def _middle(box: tuple[float, float, float, float]) -> tuple[float, float]:
    return (box[0] + box[2]) / 2, (box[1] + box[3]) / 2


def _shifted(room: PlanRoom, dx: float, dy: float) -> PlanRoom:
    def point(p: tuple[float, float]) -> tuple[float, float]:
        return p[0] + dx, p[1] + dy

    openings = tuple(replace(o, start=point(o.start), end=point(o.end)) for o in room.source.openings)
    outline = tuple((round(x + dx, 3), round(y + dy, 3)) for x, y in room.outline)
    return replace(room, outline=outline, source=replace(room.source, openings=openings))


def storeys_of(rooms: Sequence[PlanRoom], levels: Sequence[str], notes: list[str]) -> list[Storey]:
    """The storeys from below, each as high as the middle of its rooms, a ceiling of 0.3 m between them."""
    found, elevation = [], 0.0
    for level, name in enumerate(levels):
        heights = [r.source.height for r in rooms if r.storey == level and r.source.height]
        height = round(median(heights), 3) if heights else HEIGHT
        if not heights:
            notes.append(f"the file has no height of the ceiling; {height:g} m is assumed")
        found.append(Storey(id=name or "ground", elevation=round(elevation, 3), height=height))
        elevation += height + CEILING
    return found
