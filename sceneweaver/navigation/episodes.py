"""Tasks for robots in a home: go to a point, go to a thing of a kind, each with the shortest way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from sceneweaver.assets.roles import has_role
from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.io.messages import show
from sceneweaver.verify import walkable
from sceneweaver.verify.home import RADIUS, Ways
from sceneweaver.verify.home.access import used_sides
from sceneweaver.verify.solids import Body, Placed

from .roadmap import Distances, Roadmap

Point = tuple[float, float, float]
Task = Literal["pointnav", "objectnav"]

MOST_VIEWS = 12
"""Places at most from which a thing counts as reached."""

TRIES = 200
"""Draws for each episode that is wanted, after which fewer are given."""

_SPACING = 0.2  # [m] between places from which a thing is reached, about
_LEAST = 0.03  # [m]; what is flatter lies on the floor and is no goal


@dataclass(frozen=True)
class Goal:
    """A thing to go to.

    Attributes:
        object: "room/object".
        category: what it is.
        room: id of its room.
        position: x, y and z [m] of its origin in the home's frame.
        views: places (x, y, z) of the base from which it is in reach, each with the yaw [rad] that looks at it.
    """

    object: str
    category: str
    room: str
    position: Point
    views: tuple[tuple[Point, float], ...]


@dataclass(frozen=True)
class Episode:
    """One task.

    Attributes:
        id: its number as text.
        start: x, y and z [m] where the base begins; z is the height of the storey's floor.
        yaw: where it looks [rad], 0 along +x.
        goal: the point (x, y, z) to go to; of a thing to find the nearest place from which one is in reach.
        category: the kind of thing to find; None for a point.
        object: "room/object" of the nearest one; None for a point.
        geodesic: length of the shortest way [m].
        path: its corners, (x, y, z) each.
    """

    id: str
    start: Point
    yaw: float
    goal: Point
    category: str | None
    object: str | None
    geodesic: float
    path: tuple[Point, ...]

    @property
    def euclidean(self) -> float:
        """Straight distance from start to goal [m]."""
        return float(np.linalg.norm(np.subtract(self.start, self.goal)))


@dataclass(frozen=True)
class EpisodeSet:
    """Episodes of one home.

    Attributes:
        home: id of the home.
        task: "pointnav" or "objectnav".
        radius: of the base [m].
        episodes: the tasks.
        goals: by category, the things that count as found; empty for points.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.navigation import point_goal_episodes
        >>> found = point_goal_episodes(sw.Home.example("flat"), count=3, seed=0)
        >>> len(found.episodes), all(e.geodesic >= e.euclidean - 1e-6 for e in found.episodes)
        (3, True)
    """

    home: str
    task: Task
    radius: float
    episodes: tuple[Episode, ...]
    goals: Mapping[str, tuple[Goal, ...]] = field(default_factory=dict)


def point_goal_episodes(
    home: Home,
    count: int = 50,
    seed: int = 0,
    radius: float = RADIUS,
    *,
    nearest: float = 1.0,
    farthest: float = 30.0,
    least_ratio: float = 1.0,
    roadmap: Roadmap | None = None,
) -> EpisodeSet:
    """Tasks to go from a place to another, drawn evenly over the floor that is got to from the entrance.

    Args:
        home: the home, furnished or not.
        count: how many; fewer come where the home has none that are so long.
        seed: of all draws.
        radius: of the base [m].
        nearest, farthest: least and greatest length of the shortest way [m].
        least_ratio: least length of the way over the straight distance, 1 or more: 1.1 leaves out straight ways.
        roadmap: one of this home that there is already; its radius counts.

    Raises:
        InputError: a number is out of its range.
    """
    _check(count, nearest, farthest, least_ratio)
    roadmap = Roadmap(home, radius) if roadmap is None else roadmap
    rng = np.random.default_rng(seed)
    places, episodes = _Places(roadmap.ways), list[Episode]()
    for _ in range(TRIES * count if places else 0):
        if len(episodes) == count:
            break
        start, goal = places.draw(rng), places.draw(rng)
        yaw = rounded(float(rng.uniform(-np.pi, np.pi)))
        if np.linalg.norm(np.subtract(start, goal)[:2]) > farthest:
            continue
        made = _episode(len(episodes), start, yaw, roadmap.to([goal]))
        if made is None or not nearest <= made.geodesic <= farthest:
            continue
        if made.geodesic >= least_ratio * made.euclidean:
            episodes.append(made)
    return EpisodeSet(home.id, "pointnav", roadmap.radius, tuple(episodes))


def object_goal_episodes(
    home: Home,
    count: int = 50,
    seed: int = 0,
    radius: float = RADIUS,
    *,
    categories: Sequence[str] | None = None,
    nearest: float = 1.0,
    farthest: float = 30.0,
    roadmap: Roadmap | None = None,
) -> EpisodeSet:
    """Tasks to find a thing of a kind, from places drawn evenly over the floor that is got to from the entrance.

    A thing counts as found where the base has one of its functional sides in reach (for what is not used, any side), in
    its own room. Kinds are drawn evenly.

    Args:
        home: the furnished home.
        count: how many; fewer come where the home has none that are so long.
        seed: of all draws.
        radius: of the base [m].
        categories: kinds of things; None: all that stand on the floor or hang within reach and can be got to.
        nearest, farthest: least and greatest length of the shortest way [m].
        roadmap: one of this home that there is already; its radius counts.

    Raises:
        InputError: a number is out of its range.
    """
    _check(count, nearest, farthest, 1.0)
    roadmap = Roadmap(home, radius) if roadmap is None else roadmap
    rng = np.random.default_rng(seed)
    goals: dict[str, list[Goal]] = {}
    for goal in _goals(roadmap.ways, categories):
        goals.setdefault(goal.category, []).append(goal)
    names, places, episodes = sorted(goals), _Places(roadmap.ways), list[Episode]()
    fields: dict[str, Distances] = {}
    for _ in range(TRIES * count if names and places else 0):
        if len(episodes) == count:
            break
        name = names[int(rng.integers(len(names)))]
        start, yaw = places.draw(rng), rounded(float(rng.uniform(-np.pi, np.pi)))
        if name not in fields:
            fields[name] = roadmap.to([view for goal in goals[name] for view, _ in goal.views])
        made = _episode(len(episodes), start, yaw, fields[name], name, goals[name])
        if made is not None and nearest <= made.geodesic <= farthest:
            episodes.append(made)
    found = {name: tuple(goals[name]) for name in names}
    return EpisodeSet(home.id, "objectnav", roadmap.radius, tuple(episodes), found)


def _check(count: int, nearest: float, farthest: float, ratio: float) -> None:
    if not isinstance(count, int) or not 0 <= count <= 10**6:
        raise InputError(f"count is {show(count)}; give a number of episodes, 0 to 1000000")
    if not 0 <= nearest <= farthest:
        raise InputError(f"nearest is {show(nearest)} and farthest {show(farthest)}; give 0 <= nearest <= farthest")
    if not ratio >= 1:
        raise InputError(f"least_ratio is {show(ratio)}; give 1 or more")


def _episode(
    number: int, start: Point, yaw: float, away: Distances, category: str | None = None, goals: Sequence[Goal] = ()
) -> Episode | None:
    path = away.path(start)
    if path is None:
        return None
    points = tuple((round(float(x), 6), round(float(y), 6), float(z)) for x, y, z in path.points)
    thing = None
    if goals:
        views = [
            (np.linalg.norm(np.subtract(view, points[-1])), goal.object) for goal in goals for view, _ in goal.views
        ]
        thing = min(views)[1]
    return Episode(str(number), start, yaw, points[-1], category, thing, round(path.length, 6), points)


class _Places:
    """Places of the base that it gets to from the entrance, to draw from evenly by area."""

    def __init__(self, ways: Ways) -> None:
        self._regions = [(ways.floors[s].regions[k], ways.home.storey(s).elevation) for s, k in sorted(ways.entered[1])]
        self._rooms = _rooms(ways)
        areas = np.array([region.area for region, _ in self._regions])
        self._share = areas / areas.sum() if len(areas) else areas

    def __bool__(self) -> bool:
        return bool(self._regions)

    def draw(self, rng: np.random.Generator) -> Point:
        """A place to the millimetre, in a room."""
        import shapely

        while True:
            region, height = self._regions[int(rng.choice(len(self._regions), p=self._share))]
            x0, y0, x1, y1 = region.bounds
            for x, y in np.round(rng.uniform((x0, y0), (x1, y1), (64, 2)), 3).tolist():
                if shapely.contains_xy(region, x, y) and shapely.contains_xy(self._rooms[height], x, y):
                    return x, y, height


def rounded(yaw: float) -> float:
    """A yaw [rad] to four decimals, so that it stays within half a turn to either side."""
    return min(max(round(yaw, 4), -3.1415), 3.1415)


def _rooms(ways: Ways) -> dict[float, Any]:
    """The floors of the rooms, by height: no episode begins or ends outside the entrance."""
    import shapely

    found = {}
    for storey in ways.home.storeys:
        found[storey.elevation] = shapely.union_all([shapely.Polygon(r.outline) for r in ways.home.rooms_of(storey.id)])
        shapely.prepare(found[storey.elevation])
    return found


def _goals(ways: Ways, categories: Sequence[str] | None) -> Iterator[Goal]:
    for room in ways.home.rooms:
        placed = ways.placed.get(room.id)
        height = ways.home.storey_of(room.id).elevation
        for body in placed.bodies if placed is not None else ():
            wanted = _is_goal(body) if categories is None else body.item.category in categories
            if placed is None or not wanted:
                continue
            if views := _views(ways, room.id, placed, body, height):
                x, y, z = body.position
                at = (round(x, 6), round(y, 6), round(z + height, 6))
                yield Goal(f"{room.id}/{body.id}", body.item.category, room.id, at, views)


def _is_goal(body: Body) -> bool:
    """What stands on the floor, rugs aside, or hangs where a person uses it."""
    standing = body.item.mount == "floor" and body.size[2] > _LEAST
    return standing or (body.item.mount == "wall" and has_role(body.item.category, "used"))


def _views(ways: Ways, room_id: str, placed: Placed, body: Body, height: float) -> tuple[tuple[Point, float], ...]:
    """Places in a room from which a thing is in reach, some of them spread evenly."""
    import shapely

    sides: Any = used_sides(placed, body) if has_role(body.item.category, "used") else list(placed.footprint(body))
    floor = ways.floors[ways.home.room(room_id).storey]
    near = shapely.union_all(sides).buffer(floor.radius + walkable.ARM)
    reached = [part for k, part in floor.inside[room_id].items() if (floor.storey, k) in ways.entered[1]]
    area = shapely.intersection(shapely.union_all(reached), near) if reached else shapely.Polygon()
    if area.is_empty or area.area < 1e-6:
        return ()
    x0, y0, x1, y1 = area.bounds
    shapely.prepare(area)
    spacing = _SPACING
    while True:
        x = np.arange(np.ceil(x0 / spacing), np.floor(x1 / spacing) + 1) * spacing
        y = np.arange(np.ceil(y0 / spacing), np.floor(y1 / spacing) + 1) * spacing
        points = np.round(np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2), 3)
        points = points[shapely.contains_xy(area, points[:, 0], points[:, 1])]
        if len(points) or spacing < 0.02:
            break
        spacing /= 2
    if not len(points):
        points = np.round([shapely.point_on_surface(area).coords[0]], 6)
    chosen = points[np.unique(np.linspace(0, len(points) - 1, MOST_VIEWS).round().astype(int))]
    turns = np.arctan2(body.position[1] - chosen[:, 1], body.position[0] - chosen[:, 0])
    return tuple(((x, y, height), rounded(t)) for (x, y), t in zip(chosen.tolist(), turns.tolist(), strict=True))
