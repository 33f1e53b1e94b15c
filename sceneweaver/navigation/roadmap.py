"""Shortest ways of a disc over the floors of a home, exactly: tangents between the corners that ways turn around.

A shortest way in a polygon is a chain of straight pieces between corners at which the floor's edge turns into the
floor, and touches the edge at each of them without crossing it (Lozano-Perez and Wesley, "An algorithm for planning
collision-free paths among polyhedral obstacles", 1979, with the bitangents alone as in the tangent graph of Liu and
Arimoto, 1991). The polygons are the regions of `sceneweaver.verify.home`, so that ways are as exact as these.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.io.messages import show
from sceneweaver.verify.home import RADIUS, Ways
from sceneweaver.verify.home.floors import stair_ends, stair_length

Array = np.ndarray

SLACK = 1e-6
"""By how much [m] a way may leave the floor, and a side of a corner may be crossed: rounding, no more."""

SNAP = 0.05
"""How far [m] a point that is asked for may be from the floor that the middle of the base can be on."""

_SLIDE = 0.01  # [m] of a step along what is in the way: shorter than what is grown by the radius is thick
_CHUNK = 256  # corners whose tangents to all others are looked at together


class Path(NamedTuple):
    """A shortest way: corners ``points`` [K, 3] and its ``length`` [m]; z is the height of the storey's floor.

    Over a stair it is a straight piece as long as the slope of the steps.
    """

    points: Array
    length: float


@dataclass(frozen=True, eq=False)
class _Corners:
    """Corners of regions that ways may turn around: ``at`` [N, 2], those ``before`` and ``after`` them along the edge
    [N, 2], and the number of the region ``of`` [N]. The ends of stairs are corners as well, with no sides."""

    at: Array
    before: Array
    after: Array
    of: Array

    def tangent(self, rows: Any, there: Array) -> Array:
        """Whether straight lines from some corners [n, 2] to points [m, 2] touch the edge at the corners: [n, m]."""
        at = self.at[rows][:, None]
        along = there[None] - at
        length = np.maximum(np.hypot(along[..., 0], along[..., 1]), 1e-12)
        sides = []
        for other in (self.before[rows][:, None] - at, self.after[rows][:, None] - at):
            sides.append((along[..., 0] * other[..., 1] - along[..., 1] * other[..., 0]) / length)
        low, high = np.minimum(*sides), np.maximum(*sides)
        return (low >= -SLACK) | (high <= SLACK)


class Roadmap:
    """All ways of a base over the floors of a home.

    Points are (x, y) or (x, y, z) in the home's frame [m]; the storey is that of the floor nearest in z, without a z
    the lowest.

    Args:
        home: the home.
        radius: of the base [m].
        stairs: whether it takes stairs.

    Attributes:
        ways: the regions that the middle of the base can be in.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import Roadmap
        >>> roadmap = Roadmap(sw.Home.example("flat"))
        >>> round(roadmap.path((5.4, 1.0), (8.0, 2.0)).length, 2)
        4.09
    """

    def __init__(self, home: Home, radius: float = RADIUS, *, stairs: bool = True, ways: Ways | None = None) -> None:
        """Find the corners of all regions and the tangents between them."""
        self.home, self.radius = home, radius
        self.ways = Ways.of(home, radius=radius) if ways is None else ways
        self._places = [(s, k) for s, floor in self.ways.floors.items() for k in range(len(floor.regions))]
        self._number = {place: n for n, place in enumerate(self._places)}
        self.heights = np.array([home.storey(s).elevation for s, _ in self._places])
        self._shapes = [self._shape(n) for n in range(len(self._places))]
        corners = [_corners_of(self._region(n), n) for n in range(len(self._places))]
        links = self._stair_links() if stairs else []
        corners += [_end(point, n) for link in links for point, n in link[:2]]
        fields = ("at", "before", "after", "of")
        joined = {name: np.concatenate([getattr(c, name) for c in corners]) for name in fields}
        self._corners = _Corners(**joined)
        first = len(joined["at"]) - 2 * len(links)
        self._links = [(first + 2 * k, first + 2 * k + 1, link[2]) for k, link in enumerate(links)]

    def _region(self, number: int) -> Any:
        storey, k = self._places[number]
        return self.ways.floors[storey].regions[k]

    def _shape(self, number: int) -> Any:
        """A region for tests whether lines stay in it, which may run along its edge."""
        import shapely

        grown = self._region(number).buffer(SLACK, join_style="mitre")
        shapely.prepare(grown)
        return grown

    def _stair_links(self) -> list[tuple[tuple[Array, int], tuple[Array, int], float]]:
        """Of each stair and pair of regions that it joins: the points at its ends, and the length between them [m]."""
        from shapely.ops import nearest_points

        found = []
        for stair in self.home.stairs:
            edges = stair_ends(stair)
            length = stair_length(self.home, stair)
            for below in sorted(self.ways.stairs[stair.id][0]):
                for above in sorted(self.ways.stairs[stair.id][1]):
                    ends, away = [], 0.0
                    for place, edge, room in zip((below, above), edges, (stair.lower, stair.upper), strict=True):
                        here = self.ways.floors[place[0]].inside[room][place[1]]
                        point = nearest_points(here, edge.centroid)[0]
                        away += point.distance(edge)
                        ends.append((np.array(point.coords[0]), self._number[place]))
                    found.append((*ends, length + away))
        return found

    @cached_property
    def _edges(self) -> tuple[Array, Array, Array]:
        """Pairs of corners that see each other along a tangent, and their distances [m]."""
        at, of = self._corners.at, self._corners.of
        found: list[tuple[Array, Array]] = []
        for start in range(0, len(at), _CHUNK):
            rows = np.arange(start, min(start + _CHUNK, len(at)))
            good = (of[rows][:, None] == of[None]) & (rows[:, None] < np.arange(len(at))[None])
            good &= self._corners.tangent(rows, at)
            i, j = np.nonzero(good)
            keep = self._corners_tangent(j, rows[i])
            found.append((rows[i[keep]], j[keep]))
        first = np.concatenate([pair[0] for pair in found] or [np.empty(0, int)])
        second = np.concatenate([pair[1] for pair in found] or [np.empty(0, int)])
        seen = self._seen(at[first], at[second], of[first])
        first, second = first[seen], second[seen]
        lengths = np.linalg.norm(at[first] - at[second], axis=1)
        links = np.array(self._links, dtype=float).reshape(-1, 3)
        ends = links[:, :2].astype(int)
        return (
            np.concatenate([first, ends[:, 0]]),
            np.concatenate([second, ends[:, 1]]),
            np.concatenate([lengths, links[:, 2]]),
        )

    def _corners_tangent(self, corners: Array, others: Array) -> Array:
        """Whether lines from corners to others, pair by pair, touch the edge at the former: bool [n]."""
        at, there = self._corners.at[corners], self._corners.at[others]
        along = there - at
        length = np.maximum(np.hypot(*along.T), 1e-12)
        sides = []
        for other in (self._corners.before[corners] - at, self._corners.after[corners] - at):
            sides.append((along[:, 0] * other[:, 1] - along[:, 1] * other[:, 0]) / length)
        low, high = np.minimum(*sides), np.maximum(*sides)
        return (low >= -SLACK) | (high <= SLACK)

    def _seen(self, starts: Array, ends: Array, regions: Array) -> Array:
        """Whether straight lines stay in their regions: bool [n]."""
        import shapely

        lines: Any = shapely.linestrings(np.stack([starts, ends], axis=1)) if len(starts) else np.empty(0, object)
        seen = np.zeros(len(starts), dtype=bool)
        for number in np.unique(regions):
            rows = regions == number
            seen[rows] = shapely.covers(self._shapes[number], lines[rows])
        return seen

    def region(self, point: Sequence[float] | Array, within: float = SNAP) -> tuple[Array, int]:
        """The place nearest to a point where the middle of the base can be, and the number of its region.

        Raises:
            InputError: there is none within a distance [m].
        """
        import shapely
        from shapely.ops import nearest_points

        given = np.asarray(point, dtype=float)
        if given.shape not in ((2,), (3,)) or not np.isfinite(given).all():
            raise InputError(f"point is {show(point)}; give (x, y) or (x, y, z) in metres")
        z = given[2] if len(given) == 3 else min(storey.elevation for storey in self.home.storeys)
        storey = min(self.home.storeys, key=lambda s: abs(s.elevation - z)).id
        place, best = shapely.Point(given[:2]), None
        for number, (name, _) in enumerate(self._places):
            if name == storey:
                away = self._region(number).distance(place)
                best = (away, number) if best is None or away < best[0] else best
        if best is None or best[0] > within:
            far = "" if best is None else f", the nearest is {best[0]:.2f} m away"
            raise InputError(f"point {show(point)}: a base of {self.radius:g} m cannot stand there{far}")
        if best[0] > 0:
            given = np.array(nearest_points(self._region(best[1]), place)[0].coords[0])
        return given[:2], best[1]

    def slide(self, region: int, start: Array, target: Array) -> tuple[Array, bool]:
        """Where the base gets, (x, y), that goes straight from a place to another, and whether something stops it.

        Where something is, it goes in short steps, each to the place nearest to where it would have got, and so slides
        along it.

        Args:
            region: number of the region, from `region`.
            start, target: places (x, y) [m].
        """
        import shapely
        from shapely.ops import nearest_points

        shape, place = self._shapes[region], np.array(start, dtype=float)
        way: Any = shapely.LineString([start, target])
        if shapely.covers(shape, way):
            return np.array(target, dtype=float), False
        step = np.asarray(target, dtype=float) - place
        count = max(1, math.ceil(float(np.linalg.norm(step)) / _SLIDE))
        for _ in range(count):
            beside = nearest_points(self._region(region), shapely.Point(place + step / count))[0]
            following = np.array(beside.coords[0])
            if np.linalg.norm(following - place) > 2 * _SLIDE:  # across what is in the way
                break
            place = following
        return place, True

    def to(self, goals: Sequence[Sequence[float] | Array] | Array, within: float = SNAP) -> Distances:
        """The shortest ways to the nearest of some points.

        Raises:
            InputError: the base cannot stand at one of them.
        """
        return Distances(self, [self.region(goal, within) for goal in goals])

    def path(self, start: Sequence[float] | Array, goal: Sequence[float] | Array, within: float = SNAP) -> Path | None:
        """The shortest way from a point to another; None where there is none.

        Raises:
            InputError: the base cannot stand at one of them.
        """
        return self.to([goal], within).path(start, within)


class Distances:
    """How far it is from anywhere to the nearest of some goals; from `Roadmap.to`."""

    def __init__(self, roadmap: Roadmap, goals: Sequence[tuple[Array, int]]) -> None:
        """Search from the goals over all corners."""
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import dijkstra

        self._map = roadmap
        self._goals = np.array([point for point, _ in goals]).reshape(-1, 2)
        self._regions = np.array([number for _, number in goals], dtype=int)
        count = len(roadmap._corners.at)
        rows, columns, lengths = ([part] for part in roadmap._edges)
        for k, (goal, number) in enumerate(goals):
            corners = self._visible(goal, number)
            rows.append(np.full(len(corners), count + k))
            columns.append(corners)
            lengths.append(np.linalg.norm(roadmap._corners.at[corners] - goal, axis=1))
        size = count + len(goals)
        values = np.maximum(np.concatenate(lengths), 1e-12)  # an edge of length 0 is none to scipy
        graph = csr_array((values, (np.concatenate(rows), np.concatenate(columns))), shape=(size, size))
        if len(goals):
            self._away, before, _ = dijkstra(
                graph, directed=False, indices=count + np.arange(len(goals)), return_predecessors=True, min_only=True
            )
            self._next = before
        else:
            self._away, self._next = np.full(size, np.inf), np.full(size, -1)

    def _visible(self, point: Array, region: int) -> Array:
        """Numbers of the corners that a line from a point touches."""
        corners = self._map._corners
        rows = np.flatnonzero(corners.of == region)
        rows = rows[corners.tangent(rows, point[None])[:, 0]]
        seen = self._map._seen(np.broadcast_to(point, (len(rows), 2)), corners.at[rows], corners.of[rows])
        return rows[seen]

    def _first(self, point: Array, region: int) -> tuple[float, int]:
        """How far it is from a point, and to which corner or goal the way leads first; (inf, -1): to none."""
        there = np.flatnonzero(self._regions == region)
        seen = self._map._seen(np.broadcast_to(point, (len(there), 2)), self._goals[there], self._regions[there])
        straight = np.linalg.norm(self._goals[there[seen]] - point, axis=1)
        corners = self._visible(point, region)
        around = np.linalg.norm(self._map._corners.at[corners] - point, axis=1) + self._away[corners]
        away = np.concatenate([straight, around])
        if not len(away) or not np.isfinite(away.min()):
            return np.inf, -1
        numbers = np.concatenate([there[seen] + len(self._map._corners.at), corners])
        return float(away.min()), int(numbers[away.argmin()])

    def distance(self, start: Sequence[float] | Array, within: float = SNAP) -> float:
        """Length [m] of the shortest way from a point to the nearest goal; infinite where there is none.

        Raises:
            InputError: the base cannot stand there.
        """
        return self._first(*self._map.region(start, within))[0]

    def path(self, start: Sequence[float] | Array, within: float = SNAP) -> Path | None:
        """The shortest way from a point to the nearest goal; None where there is none.

        Raises:
            InputError: the base cannot stand there.
        """
        point, region = self._map.region(start, within)
        length, number = self._first(point, region)
        if number < 0:
            return None
        points, regions, count = [point], [region], len(self._map._corners.at)
        while number >= 0:
            goal = number - count
            points.append(self._goals[goal] if goal >= 0 else self._map._corners.at[number])
            regions.append(int(self._regions[goal] if goal >= 0 else self._map._corners.of[number]))
            number = int(self._next[number]) if goal < 0 else -1
        return Path(np.column_stack([points, self._map.heights[regions]]), length)


def shortest_path(
    home: Home, start: Sequence[float] | Array, goal: Sequence[float] | Array, radius: float = RADIUS
) -> Path | None:
    """The shortest way of a round base between two points of a home; None where there is none.

    Who asks for many keeps a `Roadmap`.

    Args:
        home: the home.
        start, goal: (x, y) or (x, y, z) in its frame [m], where the middle of the base can be.
        radius: of the base [m].

    Raises:
        InputError: the base cannot stand at one of them.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import shortest_path
        >>> path = shortest_path(sw.Home.example("flat"), (5.4, 1.0), (5.4, 4.0))
        >>> path.length, len(path.points)
        (3.0, 2)
    """
    return Roadmap(home, radius).path(start, goal)


def _corners_of(region: Any, number: int) -> _Corners:
    """The corners of a region at which its edge turns into it."""
    from shapely.geometry.polygon import orient

    at, before, after = [], [], []
    oriented = orient(region)
    for ring in (oriented.exterior, *oriented.interiors):
        points = np.asarray(ring.coords)[:-1]
        last, following = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
        one, two = points - last, following - points
        into = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] < 0
        at.append(points[into])
        before.append(last[into])
        after.append(following[into])
    count = sum(map(len, at))
    return _Corners(np.concatenate(at), np.concatenate(before), np.concatenate(after), np.full(count, number))


def _end(point: Array, number: int) -> _Corners:
    """An end of a stair as a corner, which any line touches."""
    return _Corners(point[None], point[None], point[None], np.array([number]))
