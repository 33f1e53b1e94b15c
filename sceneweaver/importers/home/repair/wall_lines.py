"""The walls of a home as lines along the axes: what moves together, and outlines for other places of the lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

from sceneweaver.home import Home, HomeRoom, millimetres

LINK = 350
"""Faces of a wall nearer than this [mm] belong to one wall, which moves as a whole."""

OUTER = 4.0
"""How much more a metre of an outer wall weighs than one between rooms."""

SHARED = 100
"""Least length [mm] along which two faces are of one wall."""


@dataclass(frozen=True)
class Face:
    """A wall of a room along an axis: the room, the wall, its axis (0: x is constant), its place and extent [mm].

    ``way`` is +1 where the room lies on the side of larger coordinates.
    """

    room: int
    wall: int
    axis: int
    at: int
    low: int
    high: int
    way: int


@dataclass
class WallLines:
    """Lines of walls with their places [mm]; a face is at the place of its ``line``, and ``offset`` [mm] on."""

    rooms: tuple[HomeRoom, ...]
    faces: list[Face]
    line: dict[tuple[int, int], int] = field(default_factory=dict)
    offset: dict[tuple[int, int], int] = field(default_factory=dict)
    start: np.ndarray = field(default_factory=lambda: np.zeros(0))
    weight: np.ndarray = field(default_factory=lambda: np.zeros(0))
    fixed: set[int] = field(default_factory=set)

    @classmethod
    def of(cls, home: Home) -> WallLines:
        """The lines of all storeys. Stairwells stay where they are: they lie one above the other."""
        faces = [face for k, room in enumerate(home.rooms) for face in _faces(k, room)]
        made = cls(home.rooms, faces)
        inner = millimetres(home.walls.inner)
        parent = {(f.room, f.wall): (f.room, f.wall) for f in faces}

        def root(node: tuple[int, int]) -> tuple[int, int]:
            while parent[node] != node:
                node = parent[node]
            return node

        joined = [{d.room, d.to} for d in home.doors if d.kind == "open"]
        shared: set[tuple[int, int]] = set()
        for a, b, gap in made.facing():
            passage = {home.rooms[a.room].id, home.rooms[b.room].id} in joined
            if gap <= max(LINK, 2 * inner) and (gap >= inner or (gap == 0 and passage)):
                shared |= {(a.room, a.wall), (b.room, b.wall)}
                parent[root((a.room, a.wall))] = root((b.room, b.wall))
        numbers: dict[tuple[int, int], int] = {}
        places = {(f.room, f.wall): f.at for f in faces}
        length: dict[int, float] = {}
        for f in faces:
            node = (f.room, f.wall)
            top = root(node)
            number = numbers.setdefault(top, len(numbers))
            made.line[node], made.offset[node] = number, f.at - places[top]
            heavy = 1.0 if node in shared else OUTER
            length[number] = length.get(number, 0.0) + heavy * (f.high - f.low) / 1000
            if home.rooms[f.room].type == "stairs":
                made.fixed.add(number)
        made.start = np.array([places[top] for top in numbers], dtype=float)
        made.weight = np.array([(1e6 if k in made.fixed else 1.0) + length[k] for k in range(len(numbers))])
        return made

    def facing(self) -> Iterator[tuple[Face, Face, int]]:
        """Faces of two rooms of a storey that look at each other from outside, the lower first, and their gap [mm]."""
        for a, b in combinations(self.faces, 2):
            if a.axis != b.axis or a.way == b.way or a.room == b.room:
                continue
            if self.rooms[a.room].storey != self.rooms[b.room].storey:
                continue
            low, high = (a, b) if a.way < b.way else (b, a)  # the lower room lies below its face
            if min(a.high, b.high) - max(a.low, b.low) >= SHARED and high.at >= low.at:
                yield low, high, high.at - low.at

    def across(self, room: int) -> Iterator[tuple[Face, Face, int]]:
        """Faces of a room that look at each other through it, the lower first, and how far they are apart [mm]."""
        mine = [f for f in self.faces if f.room == room]
        for a, b in combinations(mine, 2):
            if a.axis != b.axis or a.way == b.way:
                continue
            low, high = (a, b) if a.way > b.way else (b, a)
            if min(a.high, b.high) > max(a.low, b.low) and high.at > low.at:
                yield low, high, high.at - low.at

    def difference(self, low: Face, high: Face) -> tuple[dict[int, float], float]:
        """How far two faces are apart, as factors of the lines and a constant [mm]."""
        a, b = (low.room, low.wall), (high.room, high.wall)
        factors: dict[int, float] = {}
        for node, sign in ((b, 1.0), (a, -1.0)):
            factors[self.line[node]] = factors.get(self.line[node], 0.0) + sign
        return {k: v for k, v in factors.items() if v}, float(self.offset[b] - self.offset[a])

    def outline(self, room: int, places: np.ndarray) -> list[list[float]]:
        """The corners [mm] of a room for places of the lines; corners of slanted walls move with the walls beside."""
        corners = [[float(millimetres(v)) for v in corner] for corner in self.rooms[room].outline]
        n = len(corners)
        for f in self.faces:
            if f.room == room:
                node = (room, f.wall)
                value = float(places[self.line[node]] + self.offset[node])
                for k in (f.wall, (f.wall + 1) % n):
                    corners[k][f.axis] = value
        return corners

    def area(self, room: int, places: np.ndarray) -> tuple[float, dict[int, float]]:
        """Floor [mm2] of a room, and how it changes with each line [mm]."""
        corners = self.outline(room, places)
        n = len(corners)
        total = sum(corners[k][0] * corners[(k + 1) % n][1] - corners[(k + 1) % n][0] * corners[k][1] for k in range(n))
        slope: dict[int, float] = {}
        for f in (f for f in self.faces if f.room == room):
            for k in (f.wall, (f.wall + 1) % n):
                before, after = corners[k - 1], corners[(k + 1) % n]
                part = (after[1] - before[1]) / 2 if f.axis == 0 else (before[0] - after[0]) / 2
                number = self.line[(room, f.wall)]
                slope[number] = slope.get(number, 0.0) + part
        return total / 2, slope


def _faces(number: int, room: HomeRoom) -> Iterator[Face]:
    corners = [(millimetres(x), millimetres(y)) for x, y in room.outline]
    for k, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1], strict=True)):
        if a[0] == b[0]:  # counter-clockwise: going up, the room lies to the left, at smaller x
            yield Face(number, k, 0, a[0], min(a[1], b[1]), max(a[1], b[1]), -1 if b[1] > a[1] else 1)
        elif a[1] == b[1]:
            yield Face(number, k, 1, a[1], min(a[0], b[0]), max(a[0], b[0]), 1 if b[0] > a[0] else -1)
