"""The architecture of SceneState files (``arch@1.0.x``): walls with holes and floors become rooms with openings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from .model import SourceOpening
from .plans import along
from .values import Entry

Outline = tuple[tuple[float, float], ...]

_NEAR = 0.02
"""Ends of walls nearer than this [m] are one corner."""


@dataclass(frozen=True, eq=False)
class Hole:
    """A hole of a wall: [along, up] of its two corners from the first point of the wall [m]."""

    name: str
    kind: str
    low: tuple[float, float]
    high: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Element:
    """A wall, a floor or a ceiling: its points [n, 3] and its height and depth [m]."""

    kind: str
    room: str
    points: np.ndarray
    height: float | None = None
    depth: float = 0.0
    holes: tuple[Hole, ...] = ()


@dataclass(frozen=True)
class ArchRoom:
    """A room of the architecture."""

    name: str
    type: str
    outline: Outline | None
    height: float | None
    openings: tuple[SourceOpening, ...]


@dataclass(frozen=True, eq=False)
class Arch:
    """All elements of an architecture, in the frame of the file until `turned`."""

    elements: tuple[Element, ...] = ()
    types: dict[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    @property
    def up(self) -> str | None:
        """The axis, y or z, across which all floors (without any, the feet of all walls) are flat; None: not told."""
        floors = [e.points for e in self.elements if e.kind == "Floor"]
        walls = [e.points for e in self.elements if e.kind == "Wall"]
        if not floors and not walls:
            return None
        groups = floors or [np.concatenate(walls)]
        spans = np.max([np.ptp(points, axis=0) for points in groups], axis=0)
        flat = [name for name, span in zip("xyz", spans, strict=True) if span < 1e-6]
        return flat[0] if len(flat) == 1 and flat[0] in "yz" else None

    @property
    def level(self) -> float:
        """Height [m] of the lowest floor, or of the feet of the walls; 0 without either."""
        for kind in ("Floor", "Wall"):
            heights = [float(e.points[:, 2].min()) for e in self.elements if e.kind == kind]
            if heights:
                return min(heights)
        return 0.0

    @property
    def floor_depth(self) -> float:
        """Thickness [m] of the floor slabs, 0 where they have none or several."""
        depths = {round(e.depth, 6) for e in self.elements if e.kind == "Floor"}
        return depths.pop() if len(depths) == 1 else 0.0

    def turned(self, frame: np.ndarray) -> Arch:
        """The same in another frame."""
        return replace(self, elements=tuple(replace(e, points=e.points @ frame.T) for e in self.elements))

    @cached_property
    def rooms(self) -> tuple[ArchRoom, ...]:
        """The rooms, in the order in which the file first names them."""
        named = list(dict.fromkeys(e.room for e in self.elements if e.kind in ("Floor", "Wall")))
        return tuple(self._room(name) for name in named)

    def _room(self, name: str) -> ArchRoom:
        mine = [e for e in self.elements if e.room == name]
        walls = [e for e in mine if e.kind == "Wall"]
        floors = [e.points for e in mine if e.kind == "Floor"]
        heights = [e.height for e in walls if e.height]
        return ArchRoom(
            name,
            self.types.get(name, ""),
            _union(floors) if floors else _ring([wall.points[[0, -1], :2] for wall in walls]),
            max(heights) if heights else None,
            tuple(opening for wall in walls for opening in _openings(wall)),
        )


def arch_of(entry: Entry | None) -> Arch:
    """The architecture of a file; an empty one where it has none."""
    if entry is None:
        return Arch()
    unit = entry["scaleToMeters"].number(1e-6, 1e3) if entry.has("scaleToMeters") else 1.0
    defaults = {kind: value for kind, value in entry["defaults"].items()} if entry.has("defaults") else {}
    elements: list[Element] = []
    notes: list[str] = []
    for item in entry.listed("elements"):
        kind = item["type"].text()
        if kind not in ("Wall", "Floor", "Ceiling"):
            if kind != "Ground":
                notes.append(f"{item.place}: elements of type {kind} are left out")
            continue
        elements.append(_element(item, kind, defaults.get(kind), unit))
    types = {_word(r, "id"): r.word("type") for r in entry.listed("regions") if r.word("type") not in ("", "Other")}
    return Arch(tuple(elements), types, tuple(notes))


def _element(item: Entry, kind: str, default: Entry | None, unit: float) -> Element:
    rows = list(item["points"].entries())
    if rows and isinstance(rows[0].value, list) and rows[0].value and isinstance(rows[0].value[0], list):
        rows = list(rows[0].entries())  # rings: the outer one
    points = np.array([row.numbers(3) for row in rows]) * unit
    if len(points) < (2 if kind == "Wall" else 3):
        raise item["points"].error(f"{len(points)} points; a {kind.lower()} needs {2 if kind == 'Wall' else 3}")
    depth = item["depth"] if item.has("depth") else default["depth"] if default and default.has("depth") else None
    return Element(
        kind,
        _word(item, "roomId"),
        points,
        item["height"].length() * unit if item.has("height") else None,
        depth.length() * unit if depth is not None else 0.0,
        tuple(_hole(hole, unit) for hole in item.listed("holes")),
    )


def _hole(item: Entry, unit: float) -> Hole:
    box = item["box"]
    low, high = ([v.number() * unit for v in box[key].entries()][:2] for key in ("min", "max"))
    if len(low) < 2 or len(high) < 2 or not (low[0] < high[0] and low[1] < high[1]):
        raise box.error("must hold min and max as [along, up], min below max")
    return Hole(_word(item, "id") or item.place, item.word("type", "Door"), (low[0], low[1]), (high[0], high[1]))


def _word(item: Entry, key: str) -> str:
    """An id as text, whether it was written as a number, as text or as a list of one."""
    value = item.mapping().get(key)
    if isinstance(value, list) and value:
        value = value[0]
    return str(value) if isinstance(value, str | int) and not isinstance(value, bool) else ""


def _openings(wall: Element) -> Iterator[SourceOpening]:
    for hole in wall.holes:
        start, end = along(wall.points[0].tolist(), wall.points[-1].tolist(), hole.low[0], hole.high[0])
        word = hole.kind.lower()
        kind = "door" if word == "door" else "window" if word == "window" else "passage"
        bottom = hole.low[1] if kind == "window" else max(0.0, hole.low[1])
        yield SourceOpening(hole.name, kind, start, end, bottom, hole.high[1] - hole.low[1])


def _union(floors: list[np.ndarray]) -> Outline | None:
    """The outline of all floors of a room together [m]; None where they enclose nothing."""
    import shapely

    if len(floors) == 1:
        return tuple((float(x), float(y)) for x, y, _ in floors[0])
    shape = shapely.unary_union([shapely.Polygon(points[:, :2]).buffer(0) for points in floors])
    parts = [p for p in getattr(shape, "geoms", [shape]) if p.geom_type == "Polygon" and p.area > 0]
    if not parts:
        return None
    outer = max(parts, key=lambda p: p.area).exterior.coords
    return tuple((float(x), float(y)) for x, y in outer[:-1])


def _ring(ends: list[np.ndarray]) -> Outline | None:
    """The outline [m] along walls, each [2, 2], in whatever order and direction; None where they form no ring."""
    if len(ends) < 3:
        return None
    ring, (_, at), rest = [ends[0][0]], ends[0], list(ends[1:])
    while rest:
        gaps = [(float(np.hypot(*(wall[k] - at))), i, k) for i, wall in enumerate(rest) for k in (0, 1)]
        gap, i, k = min(gaps)
        if gap > _NEAR:
            return None
        ring.append(rest[i][k])
        at = rest.pop(i)[1 - k]
    return tuple((float(x), float(y)) for x, y in ring) if np.hypot(*(at - ring[0])) <= _NEAR else None
