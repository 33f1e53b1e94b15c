"""Walls of a storey in plan: what lies between the clear floors of its rooms and around them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .content import HomeContent
from .parts import HomeDoor, HomeWindow
from .shells import place_in

if TYPE_CHECKING:
    from shapely import Polygon


@dataclass(frozen=True, eq=False)
class WallOpening:
    """A door or window with the rectangle [4, 2] that it takes of its wall in plan, counter-clockwise [m].

    The rectangle reaches from the face of the wall in ``opening.room`` to its other face: the other room's, or the
    outside. The last two corners lie on the face of the room, against the order of its wall.
    """

    opening: HomeDoor | HomeWindow
    corners: tuple[tuple[float, float], ...]
    thickness: float


def wall_polygons(home: HomeContent, storey_id: str) -> list[Polygon]:
    """The walls of a storey in plan, without openings taken out: disjoint polygons, holes where rooms are [m].

    Rooms are grown by the outer thickness with square corners; what is between the grown rooms and none of them is
    wall. A gap between two rooms that is up to twice as wide is wall as well; balconies have none.
    """
    import shapely

    indoors = [shapely.Polygon(r.outline) for r in home.rooms_of(storey_id) if not r.outdoor]
    outdoors = [shapely.Polygon(r.outline) for r in home.rooms_of(storey_id) if r.outdoor]
    if not indoors:
        return []
    grown = shapely.union_all([p.buffer(home.walls.outer, join_style="mitre", mitre_limit=4.0) for p in indoors])
    solid = grown.difference(shapely.union_all([*indoors, *outdoors]))
    parts = solid.geoms if isinstance(solid, shapely.MultiPolygon) else [solid]
    kept = [p for p in parts if isinstance(p, shapely.Polygon) and p.area > 1e-6]
    return [shapely.geometry.polygon.orient(shapely.set_precision(p, 1e-6)) for p in kept]


def wall_openings(home: HomeContent, storey_id: str) -> list[WallOpening]:
    """The doors and windows of a storey with what they take of the walls, doors first."""
    found: list[WallOpening] = []
    rooms = {r.id: r for r in home.rooms_of(storey_id)}
    for opening in (*home.doors, *home.windows):
        if opening.room not in rooms:
            continue
        wall = rooms[opening.room].walls[opening.wall]
        depth = home.walls.outer
        if isinstance(opening, HomeDoor) and opening.to is not None:
            index, offset = place_in(home, opening, opening.to)
            other = home.room(opening.to).walls[index]
            depth = -wall.coordinates(other.point(offset))[1]
        found.append(WallOpening(opening, wall.strip(opening.offset, opening.width, -depth, 0.0), depth))
    return found
