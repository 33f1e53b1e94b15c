"""What a finished home is like, measured in its outlines and doors alone: nothing of the programme is looked at."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.home import Home, HomeRoom
from sceneweaver.plans import room_types

WALL = 0.35
"""Distance [m] of two clear outlines up to which a wall is all that is between them."""

TURN = 1.5
"""Diameter [m] of the circle in which a wheelchair turns."""


@dataclass(frozen=True)
class MeasuredHome:
    """Measures of a home."""

    home: Home

    @cached_property
    def outlines(self) -> Mapping[str, Any]:
        """The clear floor of each room as a shapely polygon."""
        import shapely

        return {room.id: shapely.Polygon(room.outline) for room in self.home.rooms}

    @cached_property
    def joints(self) -> frozenset[tuple[str, str, bool]]:
        """Pairs of rooms that a door joins, in both orders, and whether it is an open passage."""
        found = [(door.room, door.to, door.kind == "open") for door in self.home.doors if door.to is not None]
        return frozenset(pair for a, b, open_ in found for pair in ((a, b, open_), (b, a, open_)))

    def area(self, room: HomeRoom) -> float:
        """Clear floor [m2]."""
        return abs(signed_area(room.outline))

    @property
    def total(self) -> float:
        """Clear floor of all rooms indoors [m2], without stairwells."""
        return sum(self.area(room) for room in self.home.rooms if not room.outdoor and room.type != "stairs")

    def level(self, room: HomeRoom) -> int:
        """On which storey a room is: 0 is the one at the ground."""
        heights = sorted(self.home.storeys, key=lambda s: s.elevation)
        ground = min(range(len(heights)), key=lambda k: abs(heights[k].elevation))
        return next(k for k, s in enumerate(heights) if s.id == room.storey) - ground

    def joined(self, a: str, b: str) -> bool:
        """Whether a door or a passage joins two rooms."""
        return any((a, b, open_) in self.joints for open_ in (True, False))

    def open(self, a: str, b: str) -> bool:
        """Whether an open passage joins two rooms."""
        return (a, b, True) in self.joints

    def gap(self, a: str, b: str) -> float | None:
        """Distance of the clear floors of two rooms [m]; None on different storeys."""
        if self.home.room(a).storey != self.home.room(b).storey:
            return None
        return float(self.outlines[a].distance(self.outlines[b]))

    def entered(self) -> frozenset[str]:
        """The rooms that one comes into from outside."""
        return frozenset(door.room for door in self.home.entrances)

    def steps_from_entrance(self) -> Mapping[str, int]:
        """Through how many doors one goes from the entrance to each room."""
        found = dict.fromkeys(self.entered(), 0)
        ways = self.home.graph()
        now = list(found)
        while now:
            then: list[str] = []
            for here in now:
                for there, _ in ways[here]:
                    if there not in found:
                        found[there] = found[here] + 1
                        then.append(there)
            now = then
        return found

    def reached_without(self, room: str) -> frozenset[str]:
        """The rooms that one gets to from the entrance without going through another one."""
        ways, found = self.home.graph(), {name for name in self.entered() if name != room}
        now = [*found]
        while now:
            now = [there for here in now for there, _ in ways[here] if there != room and there not in found]
            found |= {*now}
        return frozenset(found)

    def opposite(self, a: str, b: str) -> str:
        """The room that lies between two, with a door to each, or between their walls; empty where there is none."""
        one, two = self.outlines[a].centroid, self.outlines[b].centroid
        if self.home.room(a).storey != self.home.room(b).storey:
            return ""
        import shapely

        line = shapely.LineString([one, two])
        for room in self.home.rooms:
            if room.id in (a, b) or room.storey != self.home.room(a).storey:
                continue
            if self.joined(a, room.id) and self.joined(room.id, b) and line.intersects(self.outlines[room.id]):
                return f"across {room.id}"
        return ""

    def at_side(self, room: HomeRoom, side: str) -> bool:
        """Whether a wall of a room is at the front, the side of the home in which the entrance is, or at its back."""
        door = next(iter(self.home.entrances), None)
        if door is None or room.outdoor:
            return False
        along = self.home.room(door.room).walls[door.wall].along
        out = (along[1], -along[0]) if side == "front" else (-along[1], along[0])
        reach = [x * out[0] + y * out[1] for r in self.home.rooms if not r.outdoor for x, y in r.outline]
        return max(x * out[0] + y * out[1] for x, y in room.outline) >= max(reach) - WALL

    def narrowest(self, room: HomeRoom) -> float:
        """Width [m] of the widest disc that can go everywhere in a room but into its corners: its clear width."""
        outline = self.outlines[room.id]
        low, high = 0.0, 6.0
        while high - low > 0.01:
            middle = (low + high) / 2
            core = outline.buffer(-middle / 2, join_style="mitre")
            whole = not core.is_empty and core.geom_type == "Polygon"
            # what a disc of that width cannot sweep is more than corners where a part of the room is narrower
            swept = core.buffer(middle / 2, join_style="mitre") if whole else core
            if whole and outline.difference(swept.buffer(1e-6)).area < 0.02 * outline.area:
                low = middle
            else:
                high = middle
        return round(low, 2)

    def turns(self, room: HomeRoom) -> bool:
        """Whether a wheelchair can turn on the clear floor."""
        return not self.outlines[room.id].buffer(-TURN / 2 + 5e-4).is_empty

    def lit(self, room: HomeRoom) -> bool:
        """Whether a room has a window."""
        return any(window.room == room.id for window in self.home.windows)

    def window_directions(self) -> frozenset[tuple[int, int]]:
        """The directions (outward, rounded) that windows look in."""
        found: set[tuple[int, int]] = set()
        for window in self.home.windows:
            along = self.home.room(window.room).walls[window.wall].along
            found.add((round(along[1]), round(-along[0])))
        return frozenset(found)

    def sides(self) -> tuple[float, float]:
        """Width and depth over the outer walls [m]."""
        points = [p for room in self.home.rooms if not room.outdoor for p in room.outline]
        wall = 2 * self.home.walls.outer
        xs, ys = zip(*points, strict=True)
        return round(max(xs) - min(xs) + wall, 3), round(max(ys) - min(ys) + wall, 3)

    def fills_rectangle(self) -> float:
        """The share of the rectangle over all rooms of a storey that its walls and floors fill, the least of all."""
        import shapely

        shares: list[float] = []
        for storey in self.home.storeys:
            floors = [self.outlines[r.id] for r in self.home.rooms_of(storey.id) if not r.outdoor]
            if floors:
                whole = (
                    shapely.union_all(floors).buffer(WALL / 2, join_style="mitre").buffer(-WALL / 2, join_style="mitre")
                )
                x0, y0, x1, y1 = whole.bounds
                shares.append(whole.area / ((x1 - x0) * (y1 - y0)))
        return round(min(shares), 3)

    def of_role(self, *roles: str) -> list[HomeRoom]:
        """The rooms whose type has one of these roles."""
        return [r for r in self.home.rooms if r.type in room_types() and room_types()[r.type].roles & {*roles}]

    def door_widths(self) -> list[float]:
        """Clear widths of doors that people go through [m]."""
        return [door.width for door in self.home.doors]

    def least_gap(self, a: list[str], b: list[str]) -> float | None:
        """The least distance [m] between rooms of two lists on a storey."""
        found = [gap for x, y in itertools.product(a, b) if x != y and (gap := self.gap(x, y)) is not None]
        return min(found, default=None)
