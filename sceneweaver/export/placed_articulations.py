"""The articulations of a whole room: floor, walls and doors as one, every object, and what can be taken off it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import Quaternion, from_yaw, matrix
from sceneweaver.geometry.shell import PANE_THICKNESS, WALL_THICKNESS, wall_pieces
from sceneweaver.physics.hulls import Solid
from sceneweaver.physics.inertia import Inertia, inertia_of
from sceneweaver.physics.leaves import Leaf, leaves, wall_ends
from sceneweaver.physics.model import COVERING
from sceneweaver.physics.things import RigidBody, Thing, things_of
from sceneweaver.scene import Door, Room, Scene

from .articulations import (
    BASE,
    ArticulatedLink,
    Articulation,
    Joint,
    Shape,
    articulation_of,
    legal_names,
    material_library,
    obj,
)
from .bodies import bodies_of
from .models import model_name
from .room import floor_mesh, wall_mesh

_DEEP = 0.5  # [m] of the floor's collision part: nothing falls through it in one step
_FRICTION = 0.8  # of the floor
_LIBRARY = "room-materials.mtl"
_LOOKS = {
    "glass": Material("glass", (0.86, 0.93, 0.95), opacity=0.2),
    "leaf": Material("leaf", (0.82, 0.74, 0.62)),
    "handle": Material("handle", (0.62, 0.62, 0.63), metallic=1.0),
}
_STANDING = Inertia(1000.0, np.zeros(3), 1000.0 * np.eye(3))  # of floor and walls: readers want one, and use none


@dataclass(frozen=True)
class PlacedArticulation:
    """Where an articulation stands: ``position`` [m] and ``quaternion`` (x, y, z, w) of its base; a ``fixed`` one
    stands still. ``name`` is that of its base in the other formats."""

    name: str
    category: str
    model: Articulation
    position: tuple[float, float, float]
    quaternion: Quaternion
    fixed: bool


def placed_articulations(scene: Scene, load: Load | None = None, *, loose: bool = True) -> list[PlacedArticulation]:
    """The room, then all objects in their order, each followed by what can be taken off it.

    Objects with equal bodies have the same articulation. Rugs and mats are seen only, and fixed: what stands over them
    stands on the floor, by construction, and no format that is written from here can leave out contacts of two pieces.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        loose: Whether what can be taken off is an articulation of its own, as `things_of` says.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    found = [PlacedArticulation("room", "room", _room(scene.room), (0, 0, 0), (0, 0, 0, 1), True)]
    made: dict[str, Articulation] = {}
    for thing, look in zip(things_of(scene, load, loose=loose), bodies_of(scene, load), strict=True):
        pose = thing.object.pose
        for bodies in _apart(thing):
            base = bodies[0]
            kind = thing.object.category if base.link is None else base.link.category or base.link.name
            stem = model_name(f"{thing.key}:{base.number}:{thing.friction}:{thing.mass}", kind)
            if stem not in made:
                made[stem] = articulation_of(thing, look, bodies, stem, prefix=f"{stem}-")
            covers = thing.object.mount == "floor" and thing.object.size[2] <= COVERING
            fixed = covers or (not thing.free and base.link is None)
            model = _without_collisions(made[stem]) if covers else made[stem]
            found.append(PlacedArticulation(base.name, kind, model, pose.position, pose.quaternion, fixed))
    return found


def _apart(thing: Thing) -> Iterator[list[RigidBody]]:
    """Bodies that hang together: the base with its joints, then one by one what can be taken off."""
    yield [body for body in thing.bodies if not body.loose]
    for body in thing.bodies:
        if body.loose:
            yield [body]


def _without_collisions(model: Articulation) -> Articulation:
    return replace(model, links=tuple(replace(link, shapes=()) for link in model.links))


def _room(room: Room) -> Articulation:
    """Floor and walls as the base link in the frame of the world, and the leaves of the doors."""
    files: dict[str, bytes] = {}
    looks = dict(_LOOKS)
    low, high = np.min(room.outline, axis=0) - WALL_THICKNESS, np.max(room.outline, axis=0) + WALL_THICKNESS
    shapes = [Shape(np.array([*(high - low), _DEEP]), np.array([*(low + high) / 2, -_DEEP / 2]))]
    visuals = [_seen("floor", floor_mesh(room), looks, files)]
    for wall in room.walls:
        visuals.append(_seen(f"wall_{wall.index}", wall_mesh(room, wall.index), looks, files))
        pieces = wall_pieces(wall.length, room.openings_of(wall.index), room.height, wall_ends(room, wall.index))
        for (x0, x1), (z0, z1), opening in pieces:
            if isinstance(opening, Door):
                continue
            thick = WALL_THICKNESS if opening is None else PANE_THICKNESS
            centre = np.array([*wall.point((x0 + x1) / 2, -thick / 2), (z0 + z1) / 2])
            shapes.append(Shape(np.array([x1 - x0, thick, z1 - z0]), centre, wall.yaw))
            if opening is not None:
                visuals.append((shapes[-1], "glass"))
    links = [ArticulatedLink(BASE, np.zeros(3), _STANDING, tuple(shapes), tuple(visuals))]
    found = leaves(room)
    for name, leaf in zip(legal_names([BASE, *(f"door_{leaf.door}" for leaf in found)])[1:], found, strict=True):
        links.append(_leaf(name, leaf))
    files[_LIBRARY] = material_library(looks)
    return Articulation("room", tuple(links), _FRICTION, looks, files)


def _seen(name: str, mesh: Mesh, looks: dict[str, Material], files: dict[str, bytes]) -> tuple[Shape, str]:
    """A mesh of one material as a file."""
    (looks[name],) = mesh.materials
    files[f"room-{name}.obj"] = obj(mesh.vertices, mesh.faces, _LIBRARY, name)
    return Shape(file=f"room-{name}.obj"), name


def _leaf(name: str, leaf: Leaf) -> ArticulatedLink:
    """The leaf of a door; the frame of its link stands on the hinge, turned as the world."""
    turn = matrix(from_yaw(leaf.yaw))
    shapes = tuple(Shape(2 * np.asarray(half), turn @ np.asarray(centre), leaf.yaw) for centre, half in leaf.boxes)
    boxes = [(np.asarray(centre), np.asarray(half)) for centre, half in leaf.boxes]
    solids = [Solid(np.stack([c - h, c + h]), float(8 * np.prod(h)), box=(c, h)) for c, h in boxes]
    total = sum(solid.volume for solid in solids)
    own = inertia_of(solids, [leaf.mass * solid.volume / total for solid in solids])
    inertia = Inertia(own.mass, turn @ own.centre, turn @ own.tensor @ turn.T)
    looks = ("leaf", *("handle" for _ in shapes[1:]))
    joint = Joint(
        "prismatic" if leaf.joint == "slide" else "revolute", turn @ np.asarray(leaf.axis), leaf.limits, leaf.hold
    )
    anchor = np.asarray(leaf.position, dtype=float)
    return ArticulatedLink(name, anchor, inertia, shapes, tuple(zip(shapes, looks, strict=True)), joint)
