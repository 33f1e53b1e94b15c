"""From the entrance through all doors to every room and everything that is used: does a round base get there?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.assets.roles import has_role
from sceneweaver.home import Home
from sceneweaver.verify import walkable
from sceneweaver.verify.solids import Body, Placed

from .floors import AT_STAIR, RADIUS, TIE, Floor, floors_of, stair_ends
from .reports import HomeAccess, HomeViolation

Place = tuple[str, int]
"""A region of a storey: id of the storey, number of the region."""


@dataclass(frozen=True, eq=False)
class Ways:
    """The regions of all storeys, and which are joined by stairs.

    Attributes:
        home: the home.
        placed: its furnished rooms, by id.
        floors: the floor of each storey.
        stairs: by id of the stair, the regions from which it is got on below, and those that it leads to above.
    """

    home: Home
    placed: Mapping[str, Placed]
    floors: Mapping[str, Floor]
    stairs: Mapping[str, tuple[frozenset[Place], frozenset[Place]]]

    @classmethod
    def of(cls, home: Home, placed: Mapping[str, Placed] | None = None, radius: float = RADIUS) -> Ways:
        """Those of a home for a base of some radius [m]."""
        made = placed_rooms(home) if placed is None else placed
        floors = floors_of(home, made, radius)
        stairs = {}
        for stair in home.stairs:
            ends = zip((stair.lower, stair.upper), stair_ends(stair), strict=True)
            joined = []
            for room, edge in ends:
                floor = floors[home.room(room).storey]
                joined.append(frozenset((floor.storey, k) for k in floor.near(room, [edge], radius + AT_STAIR)))
            stairs[stair.id] = (joined[0], joined[1])
        return cls(home, made, floors, stairs)

    def from_entrance(self, door_id: str) -> frozenset[Place]:
        """The regions that begin outside a door of the home."""
        door = next(d for d in self.home.doors if d.id == door_id)
        floor = self.floors[self.home.room(door.room).storey]
        return frozenset((floor.storey, k) for k in floor.passes(floor.doorways[door_id]))

    @cached_property
    def entered(self) -> tuple[str | None, frozenset[Place]]:
        """The entrance from which the base gets into most rooms, the first of equals, and all regions that it gets to
        from there; None where it gets in nowhere."""
        best, found, most = None, frozenset[Place](), -1
        for door in self.home.entrances:
            there = self.reached(self.from_entrance(door.id))
            rooms = sum(self.holds(there, room.id) for room in self.home.rooms)
            if there and rooms > most:
                best, found, most = door.id, there, rooms
        return best, found

    def reached(self, start: frozenset[Place], *, stairs: bool = True) -> frozenset[Place]:
        """All regions that can be got to from some of them."""
        found, left = set(start), list(start)
        while left:
            here = left.pop()
            for below, above in self.stairs.values() if stairs else ():
                for one, other in ((below, above), (above, below)):
                    if here in one:
                        left += other - found
                        found |= other
        return frozenset(found)

    def holds(self, places: frozenset[Place], room_id: str) -> bool:
        """Whether the base gets into a room as a whole in one of some regions; to a room that is too small for it,
        whether it gets so near that an arm reaches in."""
        import shapely

        room = self.home.room(room_id)
        floor = self.floors[room.storey]
        outline = shapely.Polygon(room.outline)
        inside, within = outline.buffer(-(floor.radius - TIE), join_style="mitre"), TIE
        if inside.is_empty:
            inside, within = outline, walkable.ARM
        return any((room.storey, k) in places for k in floor.near(room_id, [inside], within))

    def touches(self, places: frozenset[Place], room_id: str, body: Body) -> bool:
        """Whether a functional side of a thing is within reach of the base in one of some regions."""
        floor = self.floors[self.home.room(room_id).storey]
        near = floor.near(room_id, used_sides(self.placed[room_id], body), floor.radius + walkable.ARM)
        return any((floor.storey, k) in places for k in near)


def placed_rooms(home: Home) -> dict[str, Placed]:
    """The furnished rooms of a home, placed, by id."""
    return {room.id: Placed.of(room.scene) for room in home.rooms if room.scene is not None}


def used_sides(placed: Placed, body: Body) -> list[Any]:
    """The sides from which a thing is used, as shapes of shapely: see `sceneweaver.verify.walkable.Access`."""
    import shapely

    others = walkable.other_sides(placed, body)
    return [shapely.LineString(walkable.front_of(body)), *(shapely.MultiPoint(s).convex_hull for s in others)]


def used_things(placed: Placed) -> list[Body]:
    """The things of a room that a way has to lead to."""
    return [b for b in placed.bodies if has_role(b.item.category, "used") and b.item.mount in ("floor", "wall")]


def measure(ways: Ways, radius: float = RADIUS) -> tuple[HomeAccess, list[HomeViolation]]:
    """How far a base gets, and everything that it does not get to."""
    home = ways.home
    best, reached = ways.entered
    wheels = ways.reached(ways.from_entrance(best), stairs=False) if best is not None else reached
    missed = tuple(room.id for room in home.rooms if not ways.holds(reached, room.id))
    stairs = tuple(r.id for r in home.rooms if r.id not in missed and not ways.holds(wheels, r.id))
    needed, left = 0, []
    for name, placed in ways.placed.items():
        for body in used_things(placed):
            needed += 1
            if not ways.touches(reached, name, body):
                left.append((name, body, _gap(ways, reached, name, body)))
    blocked = tuple(name for f in ways.floors.values() for name, d in f.doorways.items() if not f.passes(d))
    areas = [(region.area, (s, k) in reached) for s, f in ways.floors.items() for k, region in enumerate(f.regions)]
    share = sum(area for area, there in areas if there) / max(TIE, sum(area for area, _ in areas))
    objects = tuple(f"{name}/{body.id}" for name, body, _ in left)
    access = HomeAccess(radius, best, share, missed, needed, objects, blocked, stairs)
    found = [*_violations(ways, access)]
    for name, body, gap in left:
        where = f"{gap:.2f} m from it at the nearest" if np.isfinite(gap) else "on no way"
        detail = f"a base of {radius:g} m does not get to {body.id} of {name}: its edge is {where}"
        amount = gap if np.isfinite(gap) else 0.0
        found.append(HomeViolation("unreached_object", (name,), (f"{name}/{body.id}",), detail, amount))
    return access, found


def _gap(ways: Ways, reached: frozenset[Place], room_id: str, body: Body) -> float:
    """From the edge of the base, where it gets nearest, to a functional side of a thing [m]."""
    floor = ways.floors[ways.home.room(room_id).storey]
    sides = used_sides(ways.placed[room_id], body)
    gaps = floor.gaps(room_id, sides)
    return min((gap for k, gap in gaps.items() if (floor.storey, k) in reached), default=np.inf) - floor.radius


def _violations(ways: Ways, access: HomeAccess) -> Iterator[HomeViolation]:
    base, home = f"a base of {access.robot_radius:g} m", ways.home
    if access.entrance is None:
        some = tuple(door.id for door in home.entrances)
        why = f"does not get in by {', '.join(some)}" if some else "finds no door that leads out of the home"
        yield HomeViolation("no_entrance", (), some, f"{base} {why}")
    doors = {door.id: door for door in home.doors}
    for name in access.blocked_doors:
        door = doors[name]
        sides = tuple(room for room in (door.room, door.to) if room is not None)
        where = f"between {' and '.join(sides)}" if len(sides) > 1 else f"of {door.room}"
        yield HomeViolation("blocked_door", sides, (name,), f"{base} does not get through {name} {where}")
    for stair in home.stairs:
        if not all(ways.stairs[stair.id]):
            ends = (stair.lower, stair.upper)
            where = next(room for room, side in zip(ends, ways.stairs[stair.id], strict=True) if not side)
            yield HomeViolation("blocked_stair", ends, (stair.id,), f"{base} does not get to {stair.id} in {where}")
    for room in access.unreached_rooms:
        yield HomeViolation("unreached_room", (room,), (), f"{base} does not get into {room} from the entrance")
