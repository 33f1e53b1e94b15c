"""A home as a graph: rooms joined by doors and stairs, with how far a round base goes from one to another."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.home import Home
from sceneweaver.io import write_atomic
from sceneweaver.verify.home import RADIUS, Ways
from sceneweaver.verify.home.floors import stair_ends

from .roadmap import Distances, Roadmap

SCHEMA = "sceneweaver.navigation-graph/1"

_AREA = 1e-6  # [m2] of floor at least on which a base stands for a room; the circle of a sliver is not found
_WITHIN = 0.5  # [m] from the middle of a room or an opening to where a base stands for it


@dataclass(frozen=True)
class RoomNode:
    """A room: where a base stands for it (``point`` [3], the middle of the largest free disc that is got to, or else of
    all; None: nowhere), the area [m2] of its floor, and whether it is got to from the entrance."""

    id: str
    type: str
    storey: str
    area: float
    point: tuple[float, float, float] | None
    reached: bool


@dataclass(frozen=True)
class JointEdge:
    """A door or a stair.

    Attributes:
        id: of the door or stair.
        kind: of the door (hinged, double, sliding, open), or "stair".
        rooms: the two that it joins; the second is None for a door out of the home.
        point: the middle of the opening, or the foot of the stair [3].
        width: of the opening or the flight [m].
        passable: whether the base gets through.
        length: the shortest way between the points of the two rooms through the home [m]; None where there is none.
    """

    id: str
    kind: str
    rooms: tuple[str, str | None]
    point: tuple[float, float, float]
    width: float
    passable: bool
    length: float | None


@dataclass(frozen=True)
class NavigationGraph:
    """Rooms and what joins them.

    Attributes:
        home: id of the home.
        radius: of the base [m].
        rooms: a node a room, in the order of the home.
        joints: an edge a door or stair.
        between_doors: for two doors of one room, the shortest way [m] between the middles of their openings:
            (room, door, door, length).

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import navigation_graph
        >>> graph = navigation_graph(sw.Home.example("flat"))
        >>> len(graph.rooms), len(graph.joints), graph.route("bedroom", "kitchen")
        (6, 6, ('bedroom', 'hall', 'living', 'kitchen'))
    """

    home: str
    radius: float
    rooms: tuple[RoomNode, ...]
    joints: tuple[JointEdge, ...]
    between_doors: tuple[tuple[str, str, str, float], ...]

    def route(self, start: str, goal: str) -> tuple[str, ...]:
        """The rooms on the way that is shortest by the lengths of the joints; empty where there is none."""
        away: dict[str, float] = {start: 0.0}
        left: dict[str, tuple[str, ...]] = {start: (start,)}
        while left:
            here = min(left, key=lambda name: (away[name], name))
            way = left.pop(here)
            if here == goal:
                return way
            for joint in self.joints:
                other = {joint.rooms[0]: joint.rooms[1], joint.rooms[1]: joint.rooms[0]}.get(here)
                if other is None or not joint.passable or joint.length is None:
                    continue
                length = away[here] + joint.length
                if length < away.get(other, np.inf):
                    away[other], left[other] = length, (*way, other)
        return ()

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON, which ``networkx.node_link_graph`` reads as a multigraph: a node a room, and one for outside."""
        nodes = [{**asdict(room), "kind": "room"} for room in self.rooms]
        if any(joint.rooms[1] is None for joint in self.joints):
            nodes.append({"id": OUTSIDE, "kind": "outside"})
        edges = []
        for joint in self.joints:
            named = {name: value for name, value in asdict(joint).items() if name not in ("rooms", "id")}
            ends = {"source": joint.rooms[0], "target": joint.rooms[1] or OUTSIDE, "key": joint.id}
            edges.append({**ends, **named})
        return {
            "schema": SCHEMA,
            "directed": False,
            "multigraph": True,
            "graph": {"home": self.home, "radius": self.radius, "between_doors": [list(r) for r in self.between_doors]},
            "nodes": nodes,
            "edges": edges,
        }

    def to_json(self) -> str:
        """The text of ``navigation.json``."""
        return json.dumps(self.to_dict(), indent=1, ensure_ascii=False, allow_nan=False)

    def save(self, path: str | Path) -> None:
        """Write ``navigation.json``, whole or not at all."""
        write_atomic(path, self.to_json() + "\n")


OUTSIDE = "outside"
"""The node of all that is not in the home."""


def navigation_graph(home: Home, radius: float = RADIUS, *, roadmap: Roadmap | None = None) -> NavigationGraph:
    """The graph of a home for a round base.

    Args:
        home: the home, furnished or not.
        radius: of the base [m].
        roadmap: one of this home that there is already; its radius counts.
    """
    roadmap = Roadmap(home, radius) if roadmap is None else roadmap
    ways = roadmap.ways
    _, reached = ways.entered
    points = {room.id: _middle(ways, room.id) for room in home.rooms}
    fields: dict[str, Distances] = {}

    def away(a: str, b: str) -> float | None:
        here, there = points[a], points[b]
        if here is None or there is None:
            return None
        if a not in fields:
            fields[a] = roadmap.to([here])
        return _number(fields[a].distance(there))

    rooms = []
    for room in home.rooms:
        area = _area(room.outline)
        rooms.append(RoomNode(room.id, room.type, room.storey, area, points[room.id], ways.holds(reached, room.id)))
    joints, middles = [], dict[str, tuple[float, float, float]]()
    for storey in home.storeys:
        floor = ways.floors[storey.id]
        for name, doorway in floor.doorways.items():
            door, passable = doorway.door, bool(floor.passes(doorway))
            middle = _point(doorway.middle, storey.elevation)
            length = None if door.to is None else away(door.room, door.to)
            joints.append(JointEdge(name, door.kind, (door.room, door.to), middle, door.width, passable, length))
            if passable:
                middles[name] = middle
    for stair in home.stairs:
        foot = np.asarray(stair_ends(stair)[0].centroid.coords[0])
        at = _point(foot, home.storey_of(stair.lower).elevation)
        passable = all(ways.stairs[stair.id])
        length = away(stair.lower, stair.upper) if passable else None
        joints.append(JointEdge(stair.id, "stair", (stair.lower, stair.upper), at, stair.width, passable, length))
    pairs = [
        (room.id, a.id, b.id)
        for room in home.rooms
        for a, b in combinations([d for d in home.doors_of(room.id) if d.id in middles], 2)
    ]
    return NavigationGraph(home.id, roadmap.radius, tuple(rooms), tuple(joints), _between(roadmap, pairs, middles))


def _between(
    roadmap: Roadmap, pairs: list[tuple[str, str, str]], middles: dict[str, tuple[float, float, float]]
) -> tuple[tuple[str, str, str, float], ...]:
    found, fields = [], dict[str, Distances]()
    for room, a, b in pairs:
        if a not in fields:
            fields[a] = roadmap.to([middles[a]], _WITHIN)
        length = _number(fields[a].distance(middles[b], _WITHIN))
        if length is not None:
            found.append((room, a, b, length))
    return tuple(found)


def _number(length: float) -> float | None:
    return round(length, 6) if np.isfinite(length) else None


def _point(at: np.ndarray, height: float) -> tuple[float, float, float]:
    return round(float(at[0]), 6), round(float(at[1]), 6), height


def _area(outline: Any) -> float:
    import shapely

    return round(shapely.Polygon(outline).area, 6)


def _middle(ways: Ways, room_id: str) -> tuple[float, float, float] | None:
    """The middle of the largest free disc of a room: of the largest piece of its floor that is got to from the
    entrance, or of all pieces where none is."""
    import shapely

    room = ways.home.room(room_id)
    outline = shapely.Polygon(room.outline)
    inside, reached = ways.floors[room.storey].inside[room_id], ways.entered[1]
    some = {k: part for k, part in inside.items() if (room.storey, k) in reached} or inside
    parts = [shapely.intersection(part, outline) for part in some.values()]
    pieces = [piece for part in parts for piece in shapely.get_parts(part) if piece.area > _AREA]
    if not pieces:
        return None
    largest = max(pieces, key=lambda piece: (round(piece.area, 9), piece.bounds))
    disc = shapely.maximum_inscribed_circle(largest, tolerance=0.01)
    return _point(np.array(disc.coords[0]), ways.home.storey_of(room_id).elevation)
