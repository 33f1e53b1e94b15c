"""Free areas of a scene as bodies of its layout problem: stand-ins that are searched with the furniture.

Why bodies: a place that is to stay free is found as a place for furniture is, by the same moves, the same terms and
the same verdict. A stand-in is a plate on the floor that has to be inside of the room and meets nothing; what keeps
its floor free is its zone, as high as a person. So it is walked on, may lie under zones, rugs, other free areas and
where doors swing to, if that is what it is for, and no kernel knows of it. A clearance is carried along by its
target. What has no place of its own is said by rows: a gap by distances between its targets. A path has no shape
before the furniture stands; its width is that of who walks when candidates are ranked by walkable floor.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from sceneweaver.geometry.se2 import absolute
from sceneweaver.kernels import tables as k
from sceneweaver.scene import Door, FreeArea, Part, Pose, Relation, Scene, SceneObject, Support, Zone

PLATE = 0.01
"""Height of a stand-in [m]: it is walked on."""

LOW, HIGH = 0.03, 1.9
"""Heights between which a free area is free [m]: over rugs, under lamps."""

FAR = 1000.0
"""Largest distance of a gap that has none [m]."""

NEAR = 0.4
"""How far from its target a free area may lie [m]."""

MOST_PAIRS = 400
"""Pairs of things of one gap that are kept apart."""

CATEGORY = "free floor"


@dataclass
class StandIns:
    """What free areas add to a room's problem.

    ``objects`` come behind those of the scene at ``home`` [F, 4]; ``area`` says whose each is (by its place in the
    scene; None: of a way between doors) and ``owner`` the object that carries it (-1: none). ``over_doors`` are those
    that lie where doors swing to. ``relations`` are about them and about the scene's objects.
    """

    objects: list[SceneObject] = field(default_factory=list)
    home: list[tuple[float, float, float, float]] = field(default_factory=list)
    area: list[int | None] = field(default_factory=list)
    owner: list[int] = field(default_factory=list)
    over_doors: list[bool] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)

    def add(
        self,
        obj: SceneObject,
        home: Sequence[float],
        *,
        area: int | None = None,
        owner: int = -1,
        over_doors: bool = False,
    ) -> None:
        """Append a stand-in."""
        self.objects.append(obj)
        self.home.append((float(home[0]), float(home[1]), float(home[2]), float(home[3])))
        self.area.append(area)
        self.owner.append(owner)
        self.over_doors.append(over_doors)

    def poses(self, world: np.ndarray) -> np.ndarray:
        """Poses [B, F, 4] of all stand-ins where a scene's objects are at poses [B, N, 4]: as given, or carried."""
        home = np.array(self.home, dtype=np.float64).reshape(-1, 4)
        found = np.repeat(home[None], len(world), axis=0)
        for at, (obj, owner) in enumerate(zip(self.objects, self.owner, strict=True)):
            if owner >= 0:
                offset = np.zeros((len(world), 4))
                offset[:, 2] = -obj.pose.position[2]
                found[:, at] = absolute(offset, world[:, owner])
        return found


def stand_ins(scene: Scene, home: np.ndarray) -> StandIns:
    """What the free areas of a scene add to its problem, whose objects are at ``home`` [N, 4]."""
    found = StandIns()
    doors = {door.id: door for door in scene.room.doors}
    index = {obj.id: i for i, obj in enumerate(scene.objects)}
    for at, area in enumerate(scene.free_areas):
        if area.kind in ("rectangle", "circle"):
            _add_place(found, scene, at, doors)
        elif area.kind == "clearance":
            for target in area.targets:
                if target in index:
                    _add_clearance(found, area, scene.objects[index[target]], index[target], home[index[target]])
        elif area.kind == "gap":
            found.relations += _gaps(scene, area)
        elif len(ends := [doors[name] for name in (*area.targets, *area.others) if name in doors]) == 2:
            _add_way(found, scene, area, ends)
    return found


def area_poses(scene: Scene, areas: Sequence[int | None], poses: np.ndarray) -> dict[str, Pose]:
    """Where the free areas of a scene lie in one layout, by id; ``poses`` [F, 4] are those of the stand-ins."""
    return {
        scene.free_areas[at].id: Pose.from_yaw(float(x), float(y), 0.0, float(yaw))
        for at, (x, y, _, yaw) in zip(areas, poses.astype(float), strict=True)
        if at is not None
    }


def flags_of(flags: np.ndarray, stand_in: StandIns, ties: Collection[tuple[int, int]], roots: np.ndarray) -> np.ndarray:
    """Pair flags [n, n] of a room's bodies, of which the last are stand-ins: those meet nothing, and things are kept
    out of their zones alone.

    What is tied to the owner of a clearance may stand in it, with all that it carries: a chair at its table.
    """
    flags = flags.copy()
    first = len(flags) - len(stand_in.objects)
    flags[first:, first:] = 0
    rigid = np.uint8(k.PAIR_RIGID)
    flags[first:, :first] &= np.uint8(k.PAIR_ZONE_OF_FIRST) | rigid
    flags[:first, first:] &= np.uint8(k.PAIR_ZONE_OF_SECOND) | rigid
    for at, owner in enumerate(stand_in.owner, first):
        if owner >= 0:
            tied = np.isin(roots, [roots[owner], *(roots[b] for a, b in ties if a == owner)])
            flags[at, tied] = flags[tied, at] = 0
    return flags


def walker(scene: Scene) -> float | None:
    """Radius [m] of who walks the widest path of a scene; None where it has no paths."""
    return max((area.size[0] / 2 for area in scene.free_areas if area.kind == "path"), default=None)


def _plate(area: FreeArea, polygon: np.ndarray, free: Sequence[np.ndarray], name: str, **more: object) -> SceneObject:
    """A stand-in that lies on a polygon, with what it keeps free."""
    points = np.asarray(polygon)
    low, high = points.min(axis=0), points.max(axis=0)
    size = (*(2 * max(abs(a), abs(b)) for a, b in zip(low, high, strict=True)), PLATE)
    zones = [Zone(name=f"free {n}", polygon=_corners(part), z=(LOW, HIGH)) for n, part in enumerate(free)]
    return SceneObject(
        id=name,
        category=CATEGORY,
        size=size,
        parts=(Part(polygon=_corners(points), z=(0.0, PLATE)),),
        zones=tuple(zones),
        **more,  # pyright: ignore[reportArgumentType]
    )


def _corners(points: np.ndarray) -> tuple[tuple[float, float], ...]:
    return tuple((float(x), float(y)) for x, y in points)


def rectangle(depth: float, width: float, ahead: float = 0.0, left: float = 0.0) -> np.ndarray:
    """Corners [4, 2] of a rectangle about a point in a frame."""
    x, y = depth / 2, width / 2
    return np.array([(ahead - x, left - y), (ahead + x, left - y), (ahead + x, left + y), (ahead - x, left + y)])


def disc(diameter: float) -> np.ndarray:
    """Corners [8, 2] of the octagon about a disc."""
    angles = (np.arange(8) + 0.5) * (math.pi / 4)
    return diameter / 2 / math.cos(math.pi / 8) * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _add_place(found: StandIns, scene: Scene, at: int, doors: dict[str, Door]) -> None:
    """A rectangle or circle: anywhere, at its targets, or inside of a door."""
    area = scene.free_areas[at]
    name = _name(area)
    polygon = disc(area.size[0]) if area.kind == "circle" else rectangle(*area.size)
    home = (*area.pose.position[:2], 0.0, area.pose.yaw)
    door = next((doors[target] for target in area.targets if target in doors), None)
    if door is not None:
        home = _inside(scene, door, area.size)
    obj = _plate(area, polygon, [polygon], name, fixed=door is not None)
    found.add(obj, home, area=at, over_doors=door is not None)
    ids = set(scene.ids)
    windows = {window.id for window in scene.room.windows}
    for target in area.targets:
        half = max(area.size) / 2
        if target in ids and area.side in ("front", "back", "left", "right"):
            kind = {"front": "in_front_of", "back": "behind", "left": "left_of", "right": "right_of"}[area.side]
            params = {"min": max(min(area.size) / 2 - 0.02, 0.0), "max": half + NEAR}
            found.relations.append(Relation(type=kind, subject=name, target=target, params=params))
        elif target in ids:
            found.relations.append(Relation(type="near", subject=name, target=target, params={"max": NEAR}))
        elif target in windows:
            params = {"max": NEAR}
            found.relations.append(Relation(type="near_window", subject=name, target=target, params=params))
        elif target == "middle":
            found.relations.append(Relation(type="in_middle", subject=name))


def _inside(scene: Scene, door: Door, size: tuple[float, float]) -> tuple[float, float, float, float]:
    """Where a rectangle lies that borders on a door, within the ends of its wall."""
    wall = scene.room.walls[door.wall]
    depth, width = size
    along = door.offset + door.width / 2
    along = min(max(along, width / 2), max(wall.length - width / 2, width / 2))
    (sx, sy), (ax, ay), (nx, ny) = wall.start, wall.along, wall.inward
    gap = depth / 2 + 2e-3
    return sx + ax * along + nx * gap, sy + ay * along + ny * gap, 0.0, math.atan2(ny, nx)


def _add_clearance(found: StandIns, area: FreeArea, obj: SceneObject, owner: int, home: np.ndarray) -> None:
    """Strips along sides of an object, that it takes along."""
    depth, width = obj.size[:2]
    free = area.size[0]
    sides = area.sides_of(depth, width)
    low = np.array([-depth / 2 - free * ("back" in sides), -width / 2 - free * ("right" in sides)])
    high = np.array([depth / 2 + free * ("front" in sides), width / 2 + free * ("left" in sides)])
    strips = {
        "front": (depth / 2, low[1], high[0], high[1]),
        "back": (low[0], low[1], -depth / 2, high[1]),
        "left": (-depth / 2, width / 2, depth / 2, high[1]),
        "right": (-depth / 2, low[1], depth / 2, -width / 2),
    }
    boxes = [_box(*strips[side]) for side in sides]
    lift = float(home[2])
    plate = _plate(
        area,
        _box(low[0], low[1], high[0], high[1]),
        boxes,
        f"{_name(area)} of {obj.id}",
        mount="surface",
        support=Support(object=obj.id, surface=CATEGORY),
    )
    offset = np.array([0.0, 0.0, -lift, 0.0])
    plate = plate.model_copy(update={"pose": Pose.from_yaw(0.0, 0.0, lift, 0.0)})
    found.add(plate, absolute(offset, home), owner=owner, over_doors=True)


def _box(x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def _add_way(found: StandIns, scene: Scene, area: FreeArea, doors: Sequence[Door]) -> None:
    """A straight way between two doors: what of its strip is in the room."""
    import shapely

    middles = []
    for door in doors:
        wall = scene.room.walls[door.wall]
        along = door.offset + door.width / 2
        middles.append(np.asarray(wall.start) + along * np.asarray(wall.along))
    strip = shapely.LineString(middles).buffer(area.size[0] / 2, cap_style="square")
    room = shapely.Polygon(scene.room.outline).buffer(-2e-3, join_style="mitre")
    inside = shapely.convex_hull(strip.intersection(room))
    if inside.geom_type != "Polygon" or not room.buffer(1e-6).covers(inside):
        return
    centre = np.array(inside.centroid.coords[0])
    corners = shapely.get_coordinates(shapely.geometry.polygon.orient(inside))[:-1] - centre
    found.add(_plate(area, corners, [corners], _name(area), fixed=True), (*centre, 0.0, 0.0), over_doors=True)


def _gaps(scene: Scene, area: FreeArea) -> Iterator[Relation]:
    """The two sides of a gap are its width apart."""
    ids = set(scene.ids)
    least, most = area.size[0], area.most
    if "wall" in area.others:
        for target in area.targets:
            if target in ids:
                yield Relation(type="off_walls", subject=target, params={"min": least})
    pairs = area.pairs(ids, scene.relations)
    upper = most if most is not None and len(pairs) == 1 else FAR
    for a, b in pairs[:MOST_PAIRS]:
        yield Relation(type="distance", subject=a, target=b, params={"min": least, "max": upper})


def _name(area: FreeArea) -> str:
    return f"{CATEGORY} {area.id}"


__all__ = ["CATEGORY", "StandIns", "area_poses", "flags_of", "stand_ins", "walker"]
