"""The bodies of a scene as convex parts in the world: what opens, and what may be in its way."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from sceneweaver.assets import Asset, Link, categories
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.geometry.rotations import from_yaw, matrix
from sceneweaver.geometry.shell import FLOOR_THICKNESS, PANE_THICKNESS, WALL_THICKNESS, wall_pieces
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.physics.model import COVERING
from sceneweaver.physics.shell import wall_ends
from sceneweaver.physics.things import Joint, Thing, things_of
from sceneweaver.scene import Room, Scene, Window
from sceneweaver.verify.solids import Array
from sceneweaver.verify.sweeps import Block, Motion

LIGHT, LIGHT_SEAT = 3.0, 30.0
"""Mass [kg] up to which a free thing, or a seat, is not in the way: a hand moves it."""

ROLES = ("door", "drawer", "lid")
"""Roles of links that have to open."""

_SEATS = frozenset(("chair_group", "seating"))
_MARGIN = 5.0  # [m] by which floor and ceiling reach beyond the room


class Body(NamedTuple):
    """What a part belongs to: the ``name`` of its object, door or wall, the number of its object (-1: the room), the
    number of the body within that, and whether a hand moves it aside."""

    name: str
    object: int
    number: int
    yields: bool = False


class Opening(NamedTuple):
    """Something that opens: the number of its body, how it moves, and the share of its range that its joint allows."""

    body: int
    link: str
    role: str
    motion: Motion
    most: float = 1.0


class Bodies(NamedTuple):
    """All bodies of a scene, their parts, and what of them opens."""

    bodies: list[Body]
    blocks: list[Block]
    openings: list[Opening]

    @classmethod
    def of(cls, scene: Scene, load: Callable[[str], Asset] | None = None) -> Bodies:
        """Those of a scene; ``load`` is from asset id to asset, None: the library of this user.

        Raises:
            InputError: an asset that cannot be loaded.
        """
        made = cls([], [], [])
        for index, thing in enumerate(things_of(scene, load, loose=False)):
            made._add_thing(index, thing)
        for leaf in leaves(scene.room):
            made._add_leaf(leaf)
        for name, points in _shell(scene.room):
            made.blocks.append(Block(points, made._number(Body(name, -1, 0))))
        return made

    def _number(self, body: Body) -> int:
        self.bodies.append(body)
        return len(self.bodies) - 1

    def _add_thing(self, index: int, thing: Thing) -> None:
        links = thing.asset.links if thing.asset is not None else ()
        yields = _yields(thing)
        if yields and not any(map(_opens, links)):  # in the way of nothing
            return
        turn, shift = matrix(thing.object.pose.quaternion), np.asarray(thing.object.pose.position)
        for body in thing.bodies:
            number = self._number(Body(thing.object.id, index, body.number, yields))
            if not body.solids:
                continue
            points = np.concatenate([solid.points for solid in body.solids]) @ turn.T + shift
            ends = np.cumsum([len(solid.points) for solid in body.solids])
            self.blocks.extend(Block(part, number) for part in np.split(points, ends[:-1]))
            if body.link is not None and body.joint is not None and _opens(body.link):
                motion = _motion(body.joint, turn, shift)
                self.openings.append(Opening(number, body.link.name, body.link.role, motion))

    def _add_leaf(self, leaf: Leaf) -> None:
        turn, shift = matrix(from_yaw(leaf.yaw)), np.asarray(leaf.position)
        number = self._number(Body(leaf.door, -1, 0))
        for centre, half in leaf.boxes:
            points = prism_vertices(rectangle(2 * half[0], 2 * half[1]), (-half[2], half[2])) + np.asarray(centre)
            self.blocks.append(Block(points @ turn.T + shift, number))
        motion = Motion(leaf.joint, turn @ np.asarray(leaf.axis), shift, leaf.full)
        self.openings.append(Opening(number, "leaf", "door", motion, min(1.0, leaf.limits[1] / leaf.full)))


def _opens(link: Link) -> bool:
    return link.role in ROLES and link.joint != "free"


def _motion(joint: Joint, turn: Array, shift: Array) -> Motion:
    low, high = joint.limits
    return Motion(joint.kind, turn @ joint.axis, turn @ joint.anchor + shift, high if abs(high) >= abs(low) else low)


def _yields(thing: Thing) -> bool:
    """Whether a hand moves it aside, or a door passes over it."""
    item = thing.object
    if item.mount == "floor" and item.size[2] <= COVERING:
        return True
    kind = categories().get(item.category.strip().lower().replace(" ", "_"))
    seat = kind is not None and kind.parent in _SEATS
    return thing.free and thing.mass <= (LIGHT_SEAT if seat else LIGHT)


def _shell(room: Room) -> Iterator[tuple[str, Array]]:
    """Floor, ceiling and walls around their openings."""
    plan = np.asarray(room.outline)
    (x0, y0), (x1, y1) = plan.min(axis=0) - _MARGIN, plan.max(axis=0) + _MARGIN
    over = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    yield "floor", prism_vertices(over, (-FLOOR_THICKNESS, 0.0))
    yield "ceiling", prism_vertices(over, (room.height, room.height + FLOOR_THICKNESS))
    for wall in room.walls:
        pieces = wall_pieces(wall.length, room.openings_of(wall.index), room.height, wall_ends(room, wall.index))
        for (low, high), z, opening in pieces:
            if opening is None or isinstance(opening, Window):
                thick = WALL_THICKNESS if opening is None else PANE_THICKNESS
                yield f"wall:{wall.index}", prism_vertices(wall.strip(low, high - low, -thick, 0.0), z)
