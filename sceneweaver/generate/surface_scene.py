"""What the surface tools read from a scene: supports with what stands near them, seats, ids that are free."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import members
from sceneweaver.geometry.angles import dot, heading
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.geometry.rotations import is_upright
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.shell import WINDOW_CLEARANCE, heights
from sceneweaver.io.messages import suggest
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.small_things import most_of
from sceneweaver.scene import CATALOGUE, Door, InputError, Room, Scene, SceneObject, Surface

from .surface_field import EDGE, Array, Field, Prism

TIES = CATALOGUE.with_role("seat")
"""Relations by which a chair belongs to a table."""

BESIDE = ("leftright_to_leftright", "beside", "next_to", "left_of", "right_of", "side_by_side")
"""Relations by which a thing stands at the side of another."""

CEILING = 0.05
"""Free height [m] left under the ceiling."""

TILT = 1e-3
"""Largest x and y of a quaternion that counts as upright."""


@dataclass(frozen=True)
class Frame(SE2):
    """A support's frame in the room; ``z`` [m] is its height."""

    z: float = 0.0


@dataclass(frozen=True)
class Seat:
    """A chair at a table, in the table's frame: where it is [m], and the way it looks (a unit vector)."""

    id: str
    place: Array
    look: Array


class Surroundings:
    """A scene, read once for many supports; what is added while they are filled is put into their fields."""

    def __init__(self, scene: Scene, room_type: RoomType):
        self.scene = scene
        self.items: Mapping[str, Item] = {item.id: item for item in room_type.items}
        self.carried: set[tuple[str, str]] = {(o.support.object, o.support.surface) for o in scene.objects if o.support}
        self._ids = {*scene.ids, *(d.id for d in scene.room.doors), *(w.id for w in scene.room.windows)}
        self._next: dict[str, int] = {}
        self.room = room_type.name
        self.there = Counter(o.category for o in scene.objects)

    def may_add(self, category: str) -> bool:
        """Whether such a room has one more of a thing, as far as nobody asks for it."""
        most = most_of(category, self.room)
        return most is None or self.there[category] < most

    def item(self, obj: SceneObject) -> Item | None:
        """The item of the kind of room that an object stands for, if any."""
        return self.items.get(obj.intent.program_item or "")

    def supports(self, ids: Any) -> list[SceneObject]:
        """The supports of these ids, all upright ones with surfaces when there are none.

        Raises:
            InputError: for what is no list of ids, an id that is not there or one without surfaces.
        """
        if isinstance(ids, str) or not isinstance(ids, Sequence) or not all(isinstance(i, str) for i in ids):
            raise InputError('supports: give a list of object ids, such as ["desk-0"], or an empty one for all')
        if not ids:
            return [o for o in self.scene.objects if o.surfaces and is_upright(o.pose.quaternion, TILT)]
        known = {o.id: o for o in self.scene.objects}
        for id in ids:
            if id not in known:
                raise InputError(f"supports: '{id}' is no object of the scene{suggest(id, known)}")
            if not known[id].surfaces:
                raise InputError(f"supports: '{id}' has no surface that carries things; name another object")
        return [known[id] for id in dict.fromkeys(ids)]

    def new_id(self, category: str) -> str:
        """An id that nothing in the scene has, such as mug-0; it and its thing count as there from then on."""
        self.there[category] += 1
        k = self._next.get(category, 0)
        while f"{category}-{k}" in self._ids:
            k += 1
        self._next[category] = k + 1
        self._ids.add(f"{category}-{k}")
        return f"{category}-{k}"

    def frame(self, obj: SceneObject, back: bool = False) -> Frame:
        """The frame of an object, with +x toward its user: turned about when that is at its back."""
        x, y, z = obj.pose.position
        return Frame(x, y, obj.pose.yaw + (math.pi if back else 0.0), z)

    def field(self, obj: SceneObject, surface: Surface, frame: Frame, edge: float = EDGE) -> Field:
        """The surface in ``frame`` with all that reaches over it: things on it, above it, and spaces to keep free."""
        above = self.scene.room.height - CEILING - frame.z - surface.z
        return on_surface(obj, surface, (p for own, p in self._solids if own != obj.id), frame, edge, above)

    def seats(self, obj: SceneObject) -> list[Seat]:
        """The chairs that a relation ties to an object, else those before it that look at it, by angle around it."""
        tied = []
        for r in self.scene.relations:
            if r.type in TIES and obj.id in (r.subject, *r.targets):
                tied += [id for id in (r.subject, *r.targets) if id != obj.id]
        chairs = [o for o in self.scene.objects if o.category in seats() and is_upright(o.pose.quaternion, TILT)]
        found = [c for c in chairs if c.id in tied] or [c for c in chairs if self._looks(c, obj)]
        frame = self.frame(obj)
        out = []
        for c in found:
            yaw = c.pose.yaw - frame.yaw
            place = frame.to_local(np.array([c.pose.position[:2]]))[0]
            out.append(Seat(c.id, place, np.array(heading(yaw))))
        return sorted(out, key=lambda s: math.atan2(s.place[1], s.place[0]))

    def outer_side(self, obj: SceneObject) -> int:
        """The side of an object, 1 for its user's right, that is away from the larger thing that it stands beside.

        Those at either side of a bed are laid out as mirror images. 0 for what stands beside nothing.
        """
        sizes = {o.id: o for o in self.scene.objects}
        for r in self.scene.relations:
            other = sizes.get(r.targets[0]) if r.subject == obj.id and len(r.targets) == 1 else None
            if r.type in BESIDE and other is not None and math.prod(other.size[:2]) > math.prod(obj.size[:2]):
                y = float(self.frame(obj).to_local(np.array([other.pose.position[:2]]))[0][1])
                return -1 if y > 0 else 1
        return 0

    def _looks(self, chair: SceneObject, obj: SceneObject) -> bool:
        yaw = chair.pose.yaw - obj.pose.yaw
        place = self.frame(obj).to_local(np.array([chair.pose.position[:2]]))[0]
        half = np.array(obj.size[:2]) / 2
        outside = float(np.hypot(*np.maximum(np.abs(place) - half, 0)))
        way = np.clip(place, -half * 0.8, half * 0.8) - place
        length = float(np.hypot(*way))
        return length > 0 and outside < 0.6 and dot(way, heading(yaw)) > 0.9 * length

    @cached_property
    def _solids(self) -> list[tuple[str, Prism]]:
        """Everything that may be in the way, in the room, with its owner."""
        own = [(o.id, prism) for o in self.scene.objects for prism in solids_of(o)]
        return [*clear_space(self.scene.room), *own]


def solids_of(obj: SceneObject, zones: bool = True) -> Iterator[Prism]:
    """The parts of an object in the room, and with ``zones`` the spaces that it needs free."""
    shapes = [(p.polygon, p.z) for p in obj.solids]
    shapes += [(z.polygon, z.z) for z in obj.zones if z.hard and zones]
    if not is_upright(obj.pose.quaternion, TILT):  # anything within its reach, whichever way it lies
        r = math.hypot(*obj.size)
        shapes = [(((-r, -r), (r, -r), (r, r), (-r, r)), (-r, r))]
    z, frame = obj.pose.position[2], obj.pose.frame
    for polygon, span in shapes:
        yield Prism(frame.to_world(counter_clockwise(polygon)), z + span[0], z + span[1])


def clear_space(room: Room, doors: bool = True) -> Iterator[tuple[str, Prism]]:
    """The spaces before windows, and doors, with their ids."""
    for opening in (*room.windows, *(room.doors if doors else ())):
        depth = opening.width if isinstance(opening, Door) else WINDOW_CLEARANCE
        ring = np.array(room.walls[opening.wall].strip(opening.offset, opening.width, 0.0, depth))
        yield opening.id, Prism(ring, *heights(opening))


def on_surface(
    obj: SceneObject,
    surface: Surface,
    solids: Iterable[Prism],
    frame: Frame | None = None,
    edge: float = EDGE,
    above: float = math.inf,
) -> Field:
    """The free space of a surface in the frame of its object, or in one that looks out of its back.

    Args:
        obj: what has the surface.
        surface: one of its own.
        solids: what is in the room; the part of it that reaches over the surface is taken.
        frame: that of the object if None.
        edge: free space [m] kept to the edge.
        above: free height [m] up to the ceiling.
    """
    frame = frame or Frame(*obj.pose.position[:2], obj.pose.yaw, obj.pose.position[2])
    ring = counter_clockwise(surface.polygon)
    if abs(frame.yaw - obj.pose.yaw) > 1.0:
        ring = -ring
    base = frame.z + surface.z
    made = Field(ring, min(math.inf if surface.headroom is None else surface.headroom, above), edge=edge)
    middle = ring.mean(axis=0)
    x, y = frame.world(*middle.tolist())
    reach = float(np.hypot(*(ring - middle).T).max())
    for prism in solids:
        x0, y0, x1, y1 = prism.box
        near = x0 <= x + reach and y0 <= y + reach and x1 >= x - reach and y1 >= y - reach
        if near and prism.high > base + 1e-4:
            made.taken.append(Prism(frame.to_local(prism.polygon), prism.low - base, prism.high - base))
    return made


@cache
def seats() -> frozenset[str]:
    """The categories that people sit on."""
    return frozenset(members("seating")) & frozenset(categories())
