"""The scene read once for all checks: where things are, what they are to the room, what ties them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.assets import categories, resolve
from sceneweaver.geometry.angles import dot, wrap_angle
from sceneweaver.geometry.polygons import union
from sceneweaver.geometry.walls import Wall
from sceneweaver.knowledge import RoomType
from sceneweaver.language import Grounded, Meaning, SceneGraph, StatedRelation, Thing, grounded, meanings
from sceneweaver.language.free_floor import alike
from sceneweaver.rules.faults import number as fault_number
from sceneweaver.rules.stated import number
from sceneweaver.scene import CATALOGUE, Scene
from sceneweaver.verify import Report
from sceneweaver.verify.solids import Body, Placed

from .program import Program

FLAT: float = number("flat")
"""Height [m] up to which things are walked on."""

SEAT_TIES = CATALOGUE.with_role("seat") | {"facing", "in_front_of"}
"""Relations that say to which table a seat belongs."""

QUARTER = math.pi / 2
"""Quarter turn [rad]: the axes of a room, a table or a row are the same after one."""

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Survey:
    """All that the checks look at."""

    scene: Scene
    report: Report
    room_type: RoomType
    brief: SceneGraph
    placed: Placed

    @classmethod
    def of(cls, scene: Scene, report: Report, room_type: RoomType, brief: SceneGraph) -> Survey:
        """Read a scene; categories in a user's words are read as those of the taxonomy."""
        scene = in_known_words(scene)
        return cls(scene, report, room_type, brief, Placed.of(scene))

    @cached_property
    def program(self) -> Program:
        """Which object stands for which item of the room and of the request."""
        return Program.of(self.scene, self.room_type, self.brief, self.area)

    @cached_property
    def meanings(self) -> list[tuple[StatedRelation, Meaning]]:
        """The relations that the request states with what they mean in those of the catalogue."""
        return meanings(self.brief)

    def standing_for(self, asked: str) -> list[Body]:
        """The objects that stand for something asked, by its id."""
        return self._standing_for.get(asked, [])

    def ids_of(self, asked: str) -> list[str]:
        """The ids of what stands for something asked, and for what the request calls the same."""
        return [body.id for name in alike(self.brief, asked) for body in self.standing_for(name)]

    @cached_property
    def _standing_for(self) -> dict[str, list[Body]]:
        found: dict[str, list[Body]] = {}
        for body in self.bodies:
            if (name := self.program.asked_of.get(body.id)) is not None:
                found.setdefault(name, []).append(body)
        return found

    @cached_property
    def grounded(self) -> dict[str, list[Grounded]]:
        """By stated relation, what it means in the catalogue between the objects that are there."""
        things = {
            asked.id: [
                Thing(b.id, b.item.category, b.size, b.item.mount, b.item.support and b.item.support.object)
                for b in self.standing_for(asked.id)
            ]
            for asked in self.brief.entities
        }
        found: dict[str, list[Grounded]] = {}
        for row in grounded(self.brief, things)[0]:
            found.setdefault(row.said, []).append(row)
        return found

    def least(self, asked: str) -> int:
        """How many of something were asked for, at least."""
        entity = self.brief.entity(asked)
        return entity.count[0] if entity is not None and entity.count else 1

    @cached_property
    def area(self) -> float:
        """Floor [m2]."""
        return float(self.placed.floor.area)

    @cached_property
    def bodies(self) -> tuple[Body, ...]:
        """All objects."""
        return self.placed.bodies

    @cached_property
    def standing(self) -> tuple[Body, ...]:
        """What stands on the floor and is no rug."""
        return tuple(b for b in self.bodies if b.item.mount == "floor" and b.size[2] > FLAT)

    def of_kind(self, *kinds: Iterable[str]) -> list[Body]:
        """The objects of some categories."""
        wanted = frozenset().union(*kinds)
        return [b for b in self.bodies if b.item.category in wanted]

    def on_floor(self, *kinds: Iterable[str]) -> list[Body]:
        """The objects of some categories that stand on the floor."""
        return [b for b in self.of_kind(*kinds) if b.item.mount == "floor"]

    @cached_property
    def axis(self) -> float:
        """Direction [rad] of the longest wall, modulo 90 degrees."""
        longest = max(self.placed.walls, key=lambda w: round(w.length, 6))
        return longest.yaw % QUARTER

    @cached_property
    def wall_axes(self) -> Array:
        """Directions [rad] of the walls modulo 90 degrees, each once."""
        found: list[float] = []
        for wall in self.placed.walls:
            if wall.length < fault_number("short_wall"):
                continue
            if all(abs(wrap_angle(wall.yaw - other, QUARTER)) > math.radians(1.0) for other in found):
                found.append(wall.yaw % QUARTER)
        return np.array(found or [self.axis])

    @cached_property
    def wall_angles(self) -> Array:
        """Per object the least angle [rad] between its axes and a wall's; [n]."""
        yaws = np.array([b.yaw for b in self.bodies]).reshape(-1, 1)
        return np.abs(wrap_angle(yaws - self.wall_axes, QUARTER)).min(axis=1) if len(self.bodies) else np.empty(0)

    @cached_property
    def wall_gaps(self) -> Array:
        """Distance [m] of each object's box from the nearest wall in plan, [n]; 0 where they touch or cross."""
        import shapely

        if not self.bodies:
            return np.empty(0)
        return np.asarray(shapely.distance(self.boxes, self.placed.floor.exterior))

    @cached_property
    def boxes(self) -> NDArray[Any]:
        """The boxes of the objects in plan as shapely polygons [n]."""
        import shapely

        made: Any = shapely.polygons(np.array([_four(b.corners) for b in self.bodies]).reshape(-1, 4, 2))
        return made

    @cached_property
    def _footprints(self) -> dict[int, Any]:
        return {}

    def footprint(self, body: Body) -> Any:
        """The union of a body's parts in plan as a shapely geometry."""
        found = self._footprints.get(body.index)
        if found is None:
            parts = self.placed.footprint(body)
            found = self._footprints[body.index] = parts[0] if len(parts) == 1 else union(parts)
        return found

    def outline(self, body: Body) -> Array:
        """The corners of the convex hull of a body's footprint [n, 2] [m]."""
        import shapely

        return shapely.get_coordinates(shapely.convex_hull(self.footprint(body)))[:-1]

    @cached_property
    def diagonal(self) -> float:
        """Diagonal [m] of the bounds of the floor."""
        x0, y0, x1, y1 = self.placed.floor.bounds
        return math.hypot(x1 - x0, y1 - y0)

    def kept_gaps(self) -> dict[tuple[int, int], float]:
        """Distances of solids that were measured, by the indices of their bodies."""
        return self.gaps

    @cached_property
    def gaps(self) -> dict[tuple[int, int], float]:
        """Distances [m] between objects that were measured before, by their two indices in order."""
        return {}

    @cached_property
    def tree(self) -> Any:
        """An index of the boxes in plan."""
        import shapely

        return shapely.STRtree(self.boxes)

    def near(self, body: Body, distance: float) -> list[tuple[Body, float]]:
        """Other objects whose box is within ``distance`` [m] of a body's, with their distances, nearest first."""
        import shapely

        rows = self._meeting(self._bounds[:, body.index].tolist(), distance)
        rows = rows[rows != body.index]
        gaps = shapely.distance(self.boxes[rows], self.boxes[body.index])
        rows, gaps = rows[gaps <= distance], gaps[gaps <= distance]
        order = np.lexsort((rows, np.round(gaps, 4)))
        return [(self.bodies[int(rows[k])], float(gaps[k])) for k in order]

    def reaching(self, area: Any) -> list[Body]:
        """The objects whose box meets an area (a shapely geometry), in the order of the scene."""
        import shapely

        rows = self._meeting(area.bounds)
        return [self.bodies[int(k)] for k in rows[shapely.intersects(self.boxes[rows], area)]]

    def taken(self, area: Any, bodies: Sequence[Body]) -> list[float]:
        """The share of an area (a shapely polygon) that each of some bodies covers."""
        import shapely

        if not bodies:
            return []
        shapes = np.array([self.footprint(b) for b in bodies], dtype=object)
        return (shapely.area(shapely.intersection(shapes, area)) / max(1e-9, float(area.area))).tolist()

    @cached_property
    def _bounds(self) -> Array:
        """Bounds of the boxes: x0, y0, x1, y1 [4, n] [m]."""
        import shapely

        return np.ascontiguousarray(shapely.bounds(self.boxes).T)

    def _meeting(self, bounds: Sequence[float], distance: float = 0.0) -> NDArray[np.intp]:
        """The boxes whose bounds come within a distance [m] of some bounds x0, y0, x1, y1."""
        low_x, low_y, high_x, high_y = self._bounds
        x0, y0, x1, y1 = bounds
        apart = distance + 1e-9
        near = (low_x <= x1 + apart) & (low_y <= y1 + apart) & (high_x >= x0 - apart) & (high_y >= y0 - apart)
        return near.nonzero()[0]

    def back_wall(self, body: Body) -> tuple[Wall, float, float] | None:
        """The wall that the back of a body looks at, the gap [m] and the angle [rad] between them; None: none."""
        face, best = body.face("back"), None
        least, past, through = (fault_number(name) for name in ("back_turned", "past_wall", "through_wall"))
        for wall in self.placed.walls:
            turned = dot(face.normal, wall.outward)
            along, gap = wall.coordinates(face.centre)
            if turned < least or not -past <= along <= wall.length + past or gap < -through:
                continue
            if best is None or gap < best[1]:
                best = (wall, max(0.0, gap), math.acos(min(1.0, turned)))
        return best

    def clear_ahead(self, body: Body, side: str = "front") -> float:
        """Distance [m] from the middle of a side to the wall ahead of it."""
        face = body.face(side)
        return self._ray(face.centre, face.normal)

    def _ray(self, start: tuple[float, float], way: tuple[float, float]) -> float:
        best = math.inf
        for wall in self.placed.walls:
            facing = dot(way, wall.outward)
            if facing < 1e-6:
                continue
            along, gap = wall.coordinates(start)
            if gap < -fault_number("at_wall"):
                continue
            t = max(0.0, gap) / facing
            hit, _ = wall.coordinates((start[0] + t * way[0], start[1] + t * way[1]))
            if -1e-6 <= hit <= wall.length + 1e-6:
                best = min(best, t)
        return best

    @cached_property
    def ties(self) -> dict[str, list[tuple[str, str]]]:
        """For each object the (relation type, other object) in which it is a subject."""
        found: dict[str, list[tuple[str, str]]] = {}
        for r in self.scene.relations:
            for target in r.targets:
                if target in self.placed.by_id:
                    found.setdefault(r.subject, []).append((r.type, target))
        return found

    @cached_property
    def pairs(self) -> set[frozenset[str]]:
        """Pairs of objects that some relation names together."""
        return {frozenset((s, t)) for s, all_ties in self.ties.items() for _, t in all_ties}

    @cached_property
    def carried(self) -> dict[str, list[Body]]:
        """What stands on each object."""
        found: dict[str, list[Body]] = {}
        for body in self.bodies:
            if body.item.support is not None:
                found.setdefault(body.item.support.object, []).append(body)
        return found

    @cached_property
    def violated(self) -> dict[str, set[frozenset[str]]]:
        """Per kind of violation the sets of names that take part."""
        found: dict[str, set[frozenset[str]]] = {}
        for v in self.report.violations:
            found.setdefault(v.kind, set()).add(frozenset(v.objects))
        return found


def in_known_words(scene: Scene) -> Scene:
    """The scene with every category by its name in the taxonomy, as far as it is known."""
    known = categories()
    if all(o.category in known for o in scene.objects):
        return scene
    objects = []
    for o in scene.objects:
        match = None if o.category in known else resolve(o.category)
        named = match is not None and match.how != "generic"
        objects.append(o.model_copy(update={"category": match.category}) if match and named else o)
    return scene.model_copy(update={"objects": tuple(objects)})


def turn_to(body: Body, point: tuple[float, float]) -> float:
    """Angle [rad] in 0..pi between a body's front and the way from its centre to a point."""
    ahead, aside = body.local(point)
    return 0.0 if math.hypot(ahead, aside) < 1e-6 else abs(math.atan2(aside, ahead))


def _four(corners: tuple[tuple[float, float], ...]) -> list[tuple[float, float]]:
    """Four corners; those of a tilted box are the corners of the bounds of its shadow."""
    if len(corners) == 4:
        return list(corners)
    xs, ys = [c[0] for c in corners], [c[1] for c in corners]
    return [(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))]
