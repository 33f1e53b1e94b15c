"""A walk through a home at eye level: from the entrance from door to door, one view a room."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import shapely
from PIL import Image

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Mesh
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.walls import Wall
from sceneweaver.home import Home, HomeDoor, HomeRoom
from sceneweaver.scene import Scene

from ..blocks import Finishes, finishes_of
from ..camera import Camera
from ..instances import Instance, instances_of
from ..interior.build import fittings_of, trim_of
from ..interior.outside import outside_mesh
from ..probe import object_mesh
from ..tracing import Lights, Quality, Tracer, interior_lights
from ..tracing.lights import portals_of
from ..tracing.rays import Triangles
from ..viewpoints import onward_camera, walk_camera
from . import shell

_LOOK = (480, 360)  # pixels of the look that says what of other rooms is seen
_LEAST_SEEN = 40  # of these, from which on a room counts as seen
_INNER = 2.6  # how much brighter lamps are seen from a room without windows
_CELL = 0.15  # side of the cells in which light is gathered [m]


@dataclass(frozen=True)
class Stop:
    """A stop on a walk.

    Attributes:
        room: Where it is.
        door: By which that room is entered; None: it is the first one, or one comes by a stair.
        before: The room from which one comes.
        onward: A door through which one looks on, and the room behind it; None: the room itself is looked at.
    """

    room: str
    door: str | None = None
    before: str | None = None
    onward: tuple[str, str] | None = None

    def caption(self, titles: Mapping[str, str]) -> str:
        """What its picture shows, in words by the titles of rooms: "Kitchen, from the hall"."""
        if self.onward is not None:
            return f"{titles[self.room]}, to the {titles[self.onward[1]].lower()}"
        if self.before is not None:
            return f"{titles[self.room]}, from the {titles[self.before].lower()}"
        return f"{titles[self.room]}, from the entrance" if self.door is not None else titles[self.room]


def walk_order(home: Home) -> list[Stop]:
    """All indoor rooms in the order of a walk from the entrance: into each room, and back, before the next one.

    From a room through which the walk goes on one looks through one of the doors that it takes: to the largest room.
    """
    graph, found, seen = home.graph(), [], set()
    doors = {door.id for door in home.doors}
    entrances = [Stop(door.room, door.id) for door in home.entrances]
    begins = [*entrances, *(Stop(room.id) for room in home.rooms if not room.outdoor)]

    def visit(stop: Stop) -> None:
        if stop.room in seen or home.room(stop.room).outdoor:
            return
        seen.add(stop.room)
        found.append(stop)
        ways = sorted(graph[stop.room], key=lambda way: way[1] not in doors)  # stairs last
        ahead = [(by, room) for room, by in ways if by in doors and room not in seen and not home.room(room).outdoor]
        if ahead:
            found.append(replace(stop, onward=max(ahead, key=lambda way: signed_area(home.room(way[1]).outline))))
        for room, by in ways:
            visit(Stop(room, by if by in doors else None, stop.room))

    for begin in begins:
        visit(begin)
    return found


class Walk:
    """The views of a walk, one by one.

    Attributes:
        stops: Where it stops, in order.
    """

    def __init__(
        self, home: Home, load: Callable[[str], Asset] | None = None, aspect: float = 4 / 3, device: str = "cpu"
    ) -> None:
        """``load`` gives the asset of an id, ``aspect`` is width over height of the pictures."""
        self.home, self.stops = home, walk_order(home)
        self._load, self._aspect, self._device = load, aspect, device
        self._outside: dict[str, Mesh | None] = {}

    @cached_property
    def _looks(self) -> dict[str, Finishes]:
        return {room.id: finishes_of(shell.scene_of(self.home, room)) for room in self.home.rooms}

    def camera(self, number: int) -> Camera:
        """From where a stop looks."""
        stop = self.stops[number]
        scene = shell.scene_of(self.home, self.home.room(stop.room))
        found = onward_camera(scene, self._aspect, stop.onward[0]) if stop.onward is not None else None
        return found or walk_camera(scene, self._aspect, stop.door, self._passable(stop.room))

    def picture(self, number: int, width: int, height: int, quality: Quality | None = None) -> Image.Image:
        """The view of a stop, in any size of the aspect."""
        room, camera = self.home.room(self.stops[number].room), self.camera(number)
        near = self.near(room, camera)
        building = list(self.building(room, near, camera))
        shown_of = seen(near, building, camera)
        near = [one for one in near if one.id in shown_of or one is room]
        meshes = [*building, *self._trim(near)]
        instances = [Instance(mesh, np.eye(4)) for mesh in meshes]
        for one in near:
            if one.scene is not None:
                shown = tuple(o for o in one.scene.objects if one is room or o.id in shown_of[one.id])
                instances += instances_of(one.scene.model_copy(update={"objects": shown}), self._load)
        outside = self._world(room.storey)
        if outside is not None:
            place = np.eye(4)
            place[2, 3] = -self.home.storey_of(room.id).elevation
            instances.append(Instance(outside, place))
        tracer = Tracer(instances, self._lights(room, near), self._device)
        return Image.fromarray(tracer.picture(camera, width, height, quality or Quality.normal()).rgb)

    def _passable(self, room: str) -> set[str]:
        """The doors of a room that stand open: those to other rooms."""
        return {door.id for door in self.home.doors_of(room) if door.to is not None}

    def near(self, room: HomeRoom, camera: Camera) -> list[HomeRoom]:
        """The room, those behind its doors that are before the camera or around it, and those open to these."""
        found = {room.id: room}
        for door in self.home.doors_of(room.id):
            other = door.to if door.room == room.id else door.room
            if other is None:
                continue
            wall, own = self._own(room.id, door)
            middle = np.array([*wall.point(own[0] + own[1] / 2), 1.0])
            ahead = float((middle - camera.eye) @ camera.axis) > -0.2 or is_near(wall, own, camera)
            if ahead:
                found.setdefault(other, self.home.room(other))
        for name in list(found):
            for door in self.home.doors_of(name):
                other = door.to if door.room == name else door.room
                if door.kind == "open" and other is not None:
                    found.setdefault(other, self.home.room(other))
        return list(found.values())

    def _own(self, room: str, door: HomeDoor) -> tuple[Wall, tuple[float, float]]:
        """The wall of a room that a door is in, and offset and width there [m]."""
        shape = self.home.shell(room)
        own = next(d for d in shape.doors if d.id == door.id)
        return shape.walls[own.wall], (own.offset, own.width)

    def building(self, room: HomeRoom, near: list[HomeRoom], camera: Camera) -> Iterator[Mesh]:
        """Walls, floors, doors, windows, stairs and ceilings; doors between the rooms that may be seen stand open."""
        home, storey, looks = self.home, room.storey, self._looks
        here = {one.id for one in near}

        def ajar(door: HomeDoor) -> float | None:
            wall = home.room(door.room).walls[door.wall]
            if door.to is None or not {door.room, door.to} <= here:
                return 0.0
            at, depth = wall.coordinates(camera.eye[:2])
            beside = door.offset - 0.9 < at < door.offset + door.width + 0.9
            return None if beside and abs(depth) < 1.0 else shell.OPEN

        of_storey = {one.id: looks[one.id] for one in home.rooms_of(storey)}
        found = [shell.walls_mesh(home, storey, of_storey, home.storey(storey).height)]
        found += shell.floors_of(home, storey, of_storey)
        found += [mesh for _, mesh in shell.doors_of(home, storey, of_storey, ajar)]
        found += [mesh for _, mesh in shell.windows_of(home, storey, of_storey)]
        found += [shell.stairs_mesh(home, storey), shell.railings_mesh(home, storey)]
        found += [shell.ceiling_mesh(home, one, looks[one.id]) for one in near if not one.outdoor]
        return (mesh for mesh in found if mesh is not None)

    def _trim(self, near: list[HomeRoom]) -> Iterator[Mesh]:
        """Skirting boards, coving, sockets and so on of some rooms."""
        for one in near:
            if not one.outdoor:
                scene, look = shell.scene_of(self.home, one), self._looks[one.id]
                for part in (*trim_of(scene, look), fittings_of(scene, look)):
                    if part is not None:
                        yield part.mesh

    def _world(self, storey: str) -> Mesh | None:
        if storey not in self._outside:
            self._outside[storey] = outside_mesh(shell.around(self.home, storey))
        return self._outside[storey]

    def _lights(self, room: HomeRoom, near: list[HomeRoom]) -> Lights:
        """The light of a room, with the windows of all that are seen with it."""
        indoor = [one for one in near if not one.outdoor]
        lit = [self._with_glass(one) for one in indoor]
        sunny = next((scene for scene in lit if scene.room.windows), lit[0])
        light = interior_lights(lit[0] if lit[0].room.windows else sunny)
        points = np.concatenate([np.asarray(one.outline) for one in indoor])
        reach = 2 * self.home.walls.inner
        (x0, y0), (x1, y1) = points.min(axis=0) - reach, points.max(axis=0) + reach
        low = shell.lowest(self.home, room.storey) if any(one.type == "stairs" for one in near) else -0.3
        box = ((float(x0), float(y0), low), (float(x1), float(y1), self.home.storey_of(room.id).height + 0.4))
        if not lit[0].room.windows:  # else an eye that is used to its lamps sees all beyond the doors too bright
            light = replace(light, lamp_flux=_INNER * light.lamp_flux)
        return replace(light, portals=tuple(p for scene in lit for p in portals_of(scene.room)), room=box, cell=_CELL)

    def _with_glass(self, room: HomeRoom) -> Scene:
        scene = shell.scene_of(self.home, room)
        windows = tuple(shell.glass_of(self.home, room))
        return scene.model_copy(update={"room": scene.room.model_copy(update={"windows": windows})})


def seen(rooms: list[HomeRoom], building: list[Mesh], camera: Camera) -> dict[str, set[str]]:
    """Of each room of which something is seen, the ids of the objects that are."""
    pieces = [(mesh.vertices, mesh.faces) for mesh in building]
    owners: list[tuple[str, str] | None] = [None] * len(pieces)
    for room in rooms:
        for thing in room.scene.objects if room.scene is not None else ():
            pieces.append(object_mesh(thing))
            owners.append((room.id, thing.id))
    starts = np.cumsum([0, *(len(points) for points, _ in pieces)])
    faces = np.concatenate([own + start for (_, own), start in zip(pieces, starts, strict=False)])
    piece = np.repeat(np.arange(len(pieces)), [len(own) for _, own in pieces])
    width, height = _LOOK
    hits = Triangles(np.concatenate([points for points, _ in pieces]), faces).first_hits([camera], width, height)
    met, distance = hits.face[0], hits.distance[0]
    points = (camera.origins(width, height) + camera.rays(width, height) * distance[..., None])[met >= 0]
    found: dict[str, set[str]] = {}
    for room in rooms:
        inside = shapely.contains_xy(shapely.Polygon(room.outline).buffer(0.02), points[:, 0], points[:, 1])
        if int(inside.sum()) >= _LEAST_SEEN:
            found[room.id] = set()
    for number in np.unique(piece[met[met >= 0]]).tolist():
        owner = owners[number]
        if owner is not None and owner[0] in found:
            found[owner[0]].add(owner[1])
    return found


def is_near(wall: Wall, opening: tuple[float, float], camera: Camera) -> bool:
    """Whether a camera stands in an opening (offset, width) or close to it."""
    at, depth = wall.coordinates(camera.eye[:2])
    return opening[0] - 0.2 < at < opening[0] + opening[1] + 0.2 and abs(depth) < 0.8
