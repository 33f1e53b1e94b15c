"""Where a round base can stand on the storeys of a home, as exact regions of the plane.

The base is a disc. Its middle may be wherever it is at least the radius from every wall and from every solid that
`sceneweaver.verify.walkable` counts as an obstacle: what begins below 1.8 m and ends more than 2 cm above the floor.
The floor goes through the openings of doors, whose leaves stand open and take no room. The floor is cut into no cells,
so that a gap of 0.49 m stops a base of 0.25 m however the home lies in its frame, and one of 0.51 m does not; arcs
about corners are polygons that differ by at most `_ARC` of the radius.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.home import Home, HomeDoor, HomeRoom, Stair, wall_openings
from sceneweaver.home.treads import treads
from sceneweaver.verify import walkable
from sceneweaver.verify.solids import Placed

if TYPE_CHECKING:
    from shapely import LineString, Polygon

RADIUS = 0.25
"""Radius [m] of the base that homes are judged for, unless another is given."""

TIE = 1e-6
"""By how much [m] a base may be too wide: rounding, no more."""

BEFORE = 0.3
"""How far [m] the ground outside an entrance reaches beyond a base that stands on it."""

AT_STAIR = 0.1
"""How far [m] the edge of a base may be from the first or last step of a stair to get on it."""

AGREED = 1e-3
"""How far [m] parts of a home may be from where they meet: the home's grid."""

_SEGMENTS = 16  # of a quarter of a circle
_ARC = 1 - float(np.cos(np.pi / 4 / _SEGMENTS))
_OVERLAP = 1e-3  # [m] by which doorways reach into rooms, so that rounding leaves no gap between them
_GRID = 1e-6  # [m] on which shapes are joined


@dataclass(frozen=True, eq=False)
class Doorway:
    """The opening of a door in plan.

    Attributes:
        door: the door.
        near: two ends [2, 2] of the opening on the face of ``door.room``, in the order of its wall [m].
        out: unit vector [2] from that room through the wall.
        depth: thickness of the wall [m].
    """

    door: HomeDoor
    near: np.ndarray
    out: np.ndarray
    depth: float

    def strip(self, low: float, high: float) -> Polygon:
        """The floor over the width of the opening between two depths [m], counted outwards from the near face."""
        import shapely

        a, b = self.near
        return shapely.Polygon([a + low * self.out, b + low * self.out, b + high * self.out, a + high * self.out])

    def line(self, depth: float) -> LineString:
        """The line across the opening at a depth [m]."""
        import shapely

        return shapely.LineString(self.near + depth * self.out)

    @property
    def middle(self) -> np.ndarray:
        """The middle [2] of the opening, half way through the wall."""
        return self.near.mean(axis=0) + self.depth / 2 * self.out


@dataclass(frozen=True, eq=False)
class Floor:
    """The floor of one storey for a base of one radius.

    Attributes:
        storey: id of the storey.
        radius: of the base [m].
        ground: the floor of rooms and doorways without what stands on it.
        regions: where the middle of the base may be: polygons that no way joins, in a fixed order.
        doorways: those of the storey by id of the door, in the order of the home.
        inside: for each room, by the number of the region, what of it lies in the room and in its doorways: what
            is near behind a wall is not near.
    """

    storey: str
    radius: float
    ground: Any
    regions: tuple[Polygon, ...]
    doorways: Mapping[str, Doorway]
    inside: Mapping[str, Mapping[int, Any]]

    def near(self, room: str, shapes: Sequence[Any] | np.ndarray, within: float) -> frozenset[int]:
        """Numbers of the regions that come as near [m] to one of some shapes in a room."""
        return frozenset(k for k, away in self.gaps(room, shapes).items() if away <= within + TIE)

    def gaps(self, room: str, shapes: Sequence[Any] | np.ndarray) -> dict[int, float]:
        """How near [m] each region of a room comes to the nearest of some shapes."""
        import shapely

        here = self.inside[room]
        if not here or not len(shapes):
            return {}
        parts = np.array(list(here.values()), dtype=object)
        away = shapely.distance(parts[:, None], np.asarray(shapes, dtype=object)[None, :])
        return dict(zip(here, away.min(axis=1).tolist(), strict=True))

    def passes(self, doorway: Doorway) -> frozenset[int]:
        """Numbers of the regions in which the base goes through a doorway: from a whole disc on one side of the wall
        to a whole disc on the other."""
        import shapely

        low, high = -self.radius, doorway.depth + self.radius
        strip, ends = doorway.strip(low - TIE, high + TIE), [doorway.line(end) for end in (low, high)]
        through = set()
        for number, region in enumerate(self.regions):
            for part in shapely.get_parts(shapely.intersection(region, strip)):
                if all(part.distance(end) <= 2 * TIE for end in ends):
                    through.add(number)
        return frozenset(through)


def floors_of(home: Home, placed: Mapping[str, Placed], radius: float = RADIUS) -> dict[str, Floor]:
    """The floor of each storey.

    Args:
        home: the home.
        placed: the furnished rooms, by id.
        radius: of the base [m].
    """
    return {storey.id: floor_of(home, storey.id, placed, radius) for storey in home.storeys}


def floor_of(home: Home, storey: str, placed: Mapping[str, Placed], radius: float = RADIUS) -> Floor:
    """The floor of a storey; as `floors_of`."""
    import shapely

    rooms = home.rooms_of(storey)
    doorways = doorways_of(home, storey)
    pieces = [shapely.Polygon(room.outline) for room in rooms]
    for doorway in doorways.values():
        beyond = _OVERLAP if doorway.door.to is not None else 2 * radius + BEFORE
        pieces.append(doorway.strip(-_OVERLAP, doorway.depth + beyond))
    in_the_way = [solid for room in rooms if room.id in placed for solid in obstacles(placed[room.id])]
    in_the_way += stair_plans(home, storey)
    ground = shapely.union_all(pieces, grid_size=_GRID)
    if in_the_way:
        ground = shapely.difference(ground, shapely.union_all(in_the_way, grid_size=_GRID), grid_size=_GRID)
    free = ground.buffer(-(radius - TIE), quad_segs=_SEGMENTS)
    parts = [part for part in shapely.get_parts(free) if not part.is_empty]
    regions = sorted(parts, key=lambda part: tuple(round(value, 6) for value in part.bounds))
    inside = {room.id: _inside(room, doorways, regions) for room in rooms}
    return Floor(storey, radius, ground, tuple(regions), doorways, inside)


def _inside(room: HomeRoom, doorways: Mapping[str, Doorway], regions: Sequence[Polygon]) -> dict[int, Any]:
    """What of some regions lies in a room and in its doorways, by the number of the region."""
    import shapely

    own = [d.strip(-_OVERLAP, d.depth + _OVERLAP) for d in doorways.values() if room.id in (d.door.room, d.door.to)]
    area = shapely.union_all([shapely.Polygon(room.outline), *own], grid_size=_GRID)
    parts = {k: shapely.intersection(region, area) for k, region in enumerate(regions) if region.intersects(area)}
    return {k: part for k, part in parts.items() if not part.is_empty}


def doorways_of(home: Home, storey: str) -> dict[str, Doorway]:
    """The doorways of a storey by id of the door."""
    found = {}
    for opening in wall_openings(home, storey):
        if isinstance(opening.opening, HomeDoor):
            door = opening.opening
            wall = home.room(door.room).walls[door.wall]
            near = np.array([wall.point(door.offset), wall.point(door.offset + door.width)])
            found[door.id] = Doorway(door, near, np.array(wall.outward), opening.thickness)
    return found


def obstacles(placed: Placed) -> np.ndarray:
    """The solid parts of a room's things from above that a base cannot pass: polygons of shapely [n]."""
    parts = placed.parts
    rows = (parts.z[:, 0] < walkable.CLEARANCE) & (parts.z[:, 1] > walkable.STEP)
    return parts.polygons[rows]


def stair_plans(home: Home, storey: str) -> list[Polygon]:
    """What stairs take of the floor of a storey: below, the treads that a base cannot pass under; above, all of them,
    as they come up through a hole."""
    import shapely

    found = []
    for stair in home.stairs:
        rise = stair_rise(home, stair) / stair.risers
        for tread in treads(stair):
            low = storey == home.room(stair.lower).storey and (tread.number - 1) * rise < walkable.CLEARANCE
            if low or storey == home.room(stair.upper).storey:
                found.append(shapely.Polygon(tread.plan))
    return found


def stair_ends(stair: Stair) -> tuple[LineString, LineString]:
    """The edges of a stair at which it is got on below, and left above: the near edge of its first tread, the far edge
    of its last one."""
    import shapely

    steps = [tread.plan for tread in treads(stair)]
    forward = np.asarray(stair.up, dtype=float)
    edges = []
    for step, way in ((steps[0], -forward), (steps[-1], _last_way(stair, steps))):
        far = step @ way
        edges.append(shapely.LineString(step[far > far.max() - AGREED]))
    return edges[0], edges[1]


def _last_way(stair: Stair, steps: Sequence[np.ndarray]) -> np.ndarray:
    """The direction in which a stair is left: that from the tread before the last one to it."""
    if stair.shape == "straight" or len(steps) < 2:
        return np.asarray(stair.up, dtype=float)
    step = steps[-1].mean(axis=0) - steps[-2].mean(axis=0)
    length = float(np.hypot(*step))
    axes = np.array([stair.up, (-stair.up[1], stair.up[0])])
    along = axes @ step
    return axes[int(np.abs(along).argmax())] * np.sign(along[np.abs(along).argmax()]) if length else -axes[0]


def stair_rise(home: Home, stair: Stair) -> float:
    """Height [m] between the floors that a stair joins."""
    return home.storey_of(stair.upper).elevation - home.storey_of(stair.lower).elevation


def stair_length(home: Home, stair: Stair) -> float:
    """Length [m] of the way over the middles of a stair's treads, up and along."""
    edges = stair_ends(stair)
    middles = [np.asarray(edges[0].centroid.coords[0])]
    middles += [tread.plan.mean(axis=0) for tread in treads(stair)]
    middles.append(np.asarray(edges[1].centroid.coords[0]))
    run = np.linalg.norm(np.diff(middles, axis=0), axis=1).sum()
    return float(np.hypot(run, stair_rise(home, stair)))
