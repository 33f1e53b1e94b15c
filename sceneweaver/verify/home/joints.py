"""What rooms share: do their scenes, outlines, openings, walls and door leaves agree?"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

import numpy as np

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.home import Home, HomeDoor, HomeRoom, wall_openings
from sceneweaver.scene import Room
from sceneweaver.verify import walkable
from sceneweaver.verify.grid import padded
from sceneweaver.verify.overlap import ZONE_AREA, ZONE_DEPTH, overlaps
from sceneweaver.verify.solids import Placed, Prisms

from .floors import AGREED
from .reports import HomeViolation

SAME = 1e-6
"""How far [m] a scene's room may differ from the home's: rounding, no more."""

_ARC = 12  # corners of a quarter of a circle, along which a leaf turns


def shells(home: Home) -> Iterator[HomeViolation]:
    """Scenes whose room is not that of the home: outline, height, doors and windows."""
    for room in home.rooms:
        if room.scene is not None and (what := _difference(home.shell(room.id), room.scene.room)):
            yield HomeViolation("shell", (room.id,), (), f"the scene of {room.id} has another room: {what}")


def _difference(shell: Room, other: Room) -> str:
    """The first difference between two rooms in words; empty where they are the same."""
    if len(shell.outline) != len(other.outline) or _far(shell.outline, other.outline):
        return "its outline differs"
    if _far(shell.height, other.height):
        return f"it is {other.height:g} m high, not {shell.height:g} m"
    for noun, ours, theirs in (("door", shell.doors, other.doors), ("window", shell.windows, other.windows)):
        here, there = ({o.id: o for o in openings} for openings in (ours, theirs))
        if here.keys() != there.keys():
            return f"{noun} {min(here.keys() ^ there.keys())} is only in one of them"
        for name in here:
            a, b = here[name].model_dump(), there[name].model_dump()
            for field, value in a.items():
                if _far(value, b[field]) if isinstance(value, float) else value != b[field]:
                    return f"{field} of {noun} {name} is {b[field]}, not {value}"
    return ""


def _far(a: Any, b: Any) -> bool:
    return bool(np.abs(np.asarray(a, dtype=float) - np.asarray(b, dtype=float)).max() > SAME)


def rooms(home: Home) -> Iterator[HomeViolation]:
    """Rooms of one storey whose floors overlap."""
    import shapely

    for storey in home.storeys:
        floors = [(room.id, shapely.Polygon(room.outline)) for room in home.rooms_of(storey.id)]
        for (a, first), (b, second) in combinations(floors, 2):
            area = first.intersection(second).area
            if area > ZONE_AREA:
                yield HomeViolation("rooms_overlap", (a, b), (), f"{a} and {b} share {area:.4g} m2 of floor", area)


def openings(home: Home) -> Iterator[HomeViolation]:
    """Doors and windows that do not go straight through one wall to where they say."""
    import shapely

    for storey in home.storeys:
        floors = {room.id: shapely.Polygon(room.outline) for room in home.rooms_of(storey.id) if not room.outdoor}
        outlines = {room.id: shapely.Polygon(room.outline).boundary for room in home.rooms_of(storey.id)}
        for found in wall_openings(home, storey.id):
            opening, hole = found.opening, shapely.Polygon(found.corners)
            behind = opening.to if isinstance(opening, HomeDoor) else None
            wall = home.room(opening.room).walls[opening.wall]
            for name, depth in ((opening.room, 0.0), (behind, -found.thickness)):
                if name is None:
                    continue
                face = shapely.LineString([wall.point(opening.offset + x, depth) for x in (0.0, opening.width)])
                if not outlines[name].buffer(AGREED).covers(face):
                    detail = f"{opening.id} has no wall of {name} over its whole width"
                    yield HomeViolation("opening", (name,), (opening.id,), detail)
            for name, floor in floors.items():
                area = floor.intersection(hole).area
                if area > max(ZONE_AREA, 2 * AGREED * opening.width):
                    detail = f"{opening.id} of {opening.room} goes {area:.4g} m2 into {name}"
                    yield HomeViolation("opening", (opening.room, name), (opening.id,), detail, area)


def through_walls(home: Home, placed: Mapping[str, Placed]) -> Iterator[HomeViolation]:
    """Things of one room that reach into another, or stand in the opening of a door."""
    import shapely

    for storey in home.storeys:
        here = home.rooms_of(storey.id)
        places: list[tuple[str, tuple[str, ...], Any, float]] = [
            (room.id, (), shapely.Polygon(room.outline), storey.height) for room in here
        ]
        for found in wall_openings(home, storey.id):
            if isinstance(door := found.opening, HomeDoor):
                places.append((f"the opening of {door.id}", (door.id,), shapely.Polygon(found.corners), door.height))
        tree = shapely.STRtree([place[2] for place in places])
        for room in here:
            if room.id in placed:
                yield from _reaching(room, placed[room.id], places, tree)


def _reaching(room: HomeRoom, placed: Placed, places: list[Any], tree: Any) -> Iterator[HomeViolation]:
    """What of a room is in other places: (name, openings, polygon, height [m]) with a tree over their polygons."""
    import shapely

    parts, deepest = placed.parts, dict[tuple[int, int], float]()
    if not len(parts):
        return
    for row, k in zip(*tree.query(parts.polygons), strict=True):
        name, doors, polygon, height = places[k]
        if (name == room.id and not doors) or parts.z[row, 0] >= height or parts.z[row, 1] <= walkable.STEP:
            continue
        area = float(shapely.area(shapely.intersection(parts.polygons[row], polygon)))
        if area > ZONE_AREA:
            key = int(parts.owner[row]), int(k)
            deepest[key] = max(deepest.get(key, 0.0), area)
    for (owner, k), area in sorted(deepest.items()):
        name, doors, _, _ = places[k]
        thing = placed.bodies[owner].id
        detail = f"{thing} of {room.id} takes {area:.4g} m2 of {name}"
        others = () if doors else (name,)
        yield HomeViolation("through_wall", (room.id, *others), (f"{room.id}/{thing}", *doors), detail, area)


def leaves(home: Home, placed: Mapping[str, Placed]) -> Iterator[HomeViolation]:
    """Things in the way of door leaves, on whichever side they swing to."""
    for door in home.doors:
        name = door.opens_into
        if name is None or name not in placed or door.kind not in ("hinged", "double"):
            continue
        room, swept = placed[name], leaf_sweeps(home, door)
        height = (walkable.STEP, door.height)
        zones = Prisms(padded(swept), np.tile(height, (len(swept), 1)), np.zeros(len(swept), dtype=np.intp))
        pairs, deepest = overlaps(zones, room.parts, depth=ZONE_DEPTH), dict[int, float]()
        for k in np.flatnonzero(pairs.area > ZONE_AREA):
            owner = int(room.parts.owner[pairs.j[k]])
            deepest[owner] = max(deepest.get(owner, 0.0), float(pairs.depth[k]))
        for owner, depth in sorted(deepest.items()):
            thing = room.bodies[owner].id
            detail = f"{thing} of {name} stands {depth:.3f} m in the way of the leaf of {door.id}"
            yield HomeViolation("blocked_leaf", (name,), (f"{name}/{thing}", door.id), detail, depth)


def leaf_sweeps(home: Home, door: HomeDoor) -> list[np.ndarray]:
    """The quarter discs [v, 2] that the leaves of a hinged or double door sweep in the room that they open into [m].

    They lie before the face of that room's wall; a leaf on the left of somebody who comes in hangs at the end of the
    opening nearer to the first corner of the wall.
    """
    shell = home.shell(door.opens_into or door.room)
    own = next(o for o in shell.doors if o.id == door.id)
    wall, leaf = shell.walls[own.wall], own.width if door.kind == "hinged" else own.width / 2
    left, right = (own.offset, 1.0), (own.offset + own.width, -1.0)
    hung = (left, right) if door.kind == "double" else (left if door.hinge == "left" else right,)
    angles = np.linspace(0.0, math.pi / 2, _ARC + 1)
    reach = leaf / math.cos(angles[1] / 2)  # of corners outside of the arc, so that the polygon holds all of it
    found = []
    for offset, side in hung:
        turns = (angles[1:] + angles[:-1]) / 2
        rim = [(offset + side * leaf, 0.0)]
        rim += [(offset + side * reach * math.cos(a), reach * math.sin(a)) for a in turns]
        points = [(offset, 0.0), *rim, (offset, leaf)]
        found.append(convex_hull(np.array([wall.point(x, y) for x, y in points])))
    return found
