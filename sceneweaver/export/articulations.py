"""What URDF and SDF have in common: a room as articulations with their meshes, and where each of them stands.

The room itself is one (floor, walls, leaves of doors), every object is one, and so is what can be taken off an object.

An articulation is a base link and the doors, drawers and controls that hang on it. The base link has the frame of the
object: origin at the bottom centre, x to the front, y to the left, z up, metres. The frame of every other link stands
at its joint's anchor, turned as the base; at 0 it is closed. What can be taken off is one link in the object's frame.

Collision parts are boxes where they are boxes, else convex meshes.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import Quaternion, from_yaw, matrix
from sceneweaver.geometry.se2 import SE2
from sceneweaver.physics.enclosure import Standing, room_enclosure
from sceneweaver.physics.inertia import Inertia, triangles
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.physics.model import COVERING
from sceneweaver.physics.shell import FLOOR_FRICTION, Slab, floor_slab
from sceneweaver.physics.solids import Solid
from sceneweaver.physics.things import Joint, RigidBody, Thing, things_of
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import Scene

from .bodies import body_of
from .names import Names, legal_name, model_name
from .obj import material_library, obj
from .room import floor_mesh, wall_mesh

BASE = "base"
"""Name of the link that all others hang on."""

OURS = r"(meshes/)?(room|home|[a-z0-9_]+-[0-9a-f]{10})(-.*)?\.(obj|mtl|urdf)"
"""Paths of the files of articulations in a folder of their own."""

KINDS = {"hinge": "revolute", "slide": "prismatic"}
"""Kinds of joints, as URDF and SDF call them."""

_EFFORT = {"hinge": 50.0, "slide": 200.0}  # [N m], [N]: what a person's pull comes to
_SPEED = {"hinge": 3.0, "slide": 2.0}  # [rad/s], [m/s]
_LOOKS = {
    "glass": Material("glass", (0.86, 0.93, 0.95), opacity=0.2),
    "leaf": Material("leaf", (0.82, 0.74, 0.62)),
    "handle": Material("handle", (0.62, 0.62, 0.63), metallic=1.0),
}
_STANDING = Inertia(1000.0, np.zeros(3), 1000.0 * np.eye(3))  # of floor and walls: readers want one, and use none


@dataclass(frozen=True)
class Shape:
    """A body in its link's frame: a box of ``size`` [3] about ``centre`` [3], turned by ``yaw`` [rad] about z, or the
    mesh ``file`` as it is. ``points`` [N, 3] are the corners of a collision part of a piece."""

    size: np.ndarray | None = None
    centre: np.ndarray = field(default_factory=lambda: np.zeros(3))
    yaw: float = 0.0
    file: str = ""
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))


@dataclass(frozen=True)
class ArticulatedLink:
    """A link, its frame at its joint's anchor; ``visuals`` are shapes with the name of their material."""

    name: str
    inertia: Inertia
    shapes: tuple[Shape, ...]
    visuals: tuple[tuple[Shape, str], ...]
    joint: Joint | None = None


@dataclass(frozen=True)
class Articulation:
    """A base link, first, and what hangs on it; ``files`` are its meshes by name, ``looks`` its materials by name."""

    name: str
    links: tuple[ArticulatedLink, ...]
    friction: float
    looks: Mapping[str, Material]
    files: Mapping[str, bytes]


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
    return [standing_still("room", _room(scene)), *placed_things(things_of(scene, load, loose=loose))]


def standing_still(category: str, model: Articulation) -> PlacedArticulation:
    """An articulation in the frame of the world, with its own name."""
    return PlacedArticulation(model.name, category, model, (0, 0, 0), (0, 0, 0, 1), True)


def placed_things(things: Iterable[Thing]) -> list[PlacedArticulation]:
    """All things in their order, each followed by what can be taken off it; see `placed_articulations`."""
    found: list[PlacedArticulation] = []
    made: dict[str, Articulation] = {}
    for thing in things:
        checkpoint()
        pose = thing.object.pose
        hanging = [body for body in thing.bodies if not body.loose]
        for bodies in (hanging, *([body] for body in thing.bodies if body.loose)):
            base = bodies[0]
            kind = thing.object.category if base.link is None else base.link.category or base.link.name
            stem = model_name(f"{thing.key}:{base.number}:{thing.friction}:{thing.mass}", kind)
            if stem not in made:
                made[stem] = articulation_of(thing, bodies, stem, prefix=f"{stem}-")
            covers = thing.object.mount == "floor" and thing.object.size[2] <= COVERING
            fixed = covers or (not thing.free and base.link is None)
            model = _without_collisions(made[stem]) if covers else made[stem]
            found.append(PlacedArticulation(base.name, kind, model, pose.position, pose.quaternion, fixed))
    return found


def _without_collisions(model: Articulation) -> Articulation:
    return replace(model, links=tuple(replace(link, shapes=()) for link in model.links))


def _room(scene: Scene) -> Articulation:
    room = scene.room
    pieces: list[tuple[dict[str, Mesh], Standing | None]] = [({"floor": floor_mesh(room)}, None)]
    for k, standing in enumerate(room_enclosure(scene).standing):
        pieces.append(({f"wall_{k}": wall_mesh(room, k)}, standing))
    return building("room", [floor_slab(room)], pieces, leaves(room))


def building(
    name: str,
    floors: Sequence[Slab],
    pieces: Iterable[tuple[Mapping[str, Mesh], Standing | None]],
    doors: Sequence[Leaf],
) -> Articulation:
    """What is around things: a base link in the frame of the world, and the leaves of the doors.

    Args:
        name: Of the articulation, with which the names of its files begin.
        floors: Slabs in the world.
        pieces: Meshes of what is seen by names that all readers take, each of one material, and what they collide as.
        doors: Their leaves.
    """
    files: dict[str, bytes] = {}
    looks = dict(_LOOKS)
    library = f"{name}-materials.mtl"
    shapes = [Shape(2 * floor.half, floor.centre) for floor in floors]
    visuals = []
    for meshes, standing in pieces:
        for title, mesh in meshes.items():
            (looks[title],) = mesh.materials
            file = f"{name}-{title}.obj"
            files[file] = obj(mesh.vertices, mesh.faces, material=(library, title))
            visuals.append((Shape(file=file), title))
        for k, slab in enumerate(standing.slabs if standing is not None else ()):
            assert standing is not None
            shapes.append(_standing(standing, slab, f"{name}-{legal_name(standing.name)}-part-{k}.obj", files))
            if slab.pane:
                visuals.append((shapes[-1], "glass"))
    links = [ArticulatedLink(BASE, _STANDING, tuple(shapes), tuple(visuals))]
    titles = [f"door_{leaf.name.partition(':door:')[2]}" for leaf in doors]
    for title, leaf in zip(legal_names([BASE, *titles])[1:], doors, strict=True):
        links.append(_leaf(title, leaf))
    files[library] = material_library(looks)
    return Articulation(name, tuple(links), FLOOR_FRICTION, looks, files)


def _standing(standing: Standing, slab: Slab, file: str, files: dict[str, bytes]) -> Shape:
    """A slab in the world; a hull is a file."""
    x, y, z = standing.position
    frame = SE2(x, y, standing.yaw)
    if slab.points is None:
        return Shape(2 * slab.half, np.array([*frame.world(*slab.centre[:2]), z + slab.centre[2]]), standing.yaw)
    corners = triangles(slab.points)[1].reshape(-1, 3)
    points, packed = np.unique(corners, axis=0, return_inverse=True)
    points = np.column_stack([*frame.world(points[:, 0], points[:, 1]), points[:, 2] + z])
    files[file] = obj(points, packed.reshape(-1, 3))
    return Shape(file=file, points=points)


def _leaf(name: str, leaf: Leaf) -> ArticulatedLink:
    """The leaf of a door; the frame of its link stands on the hinge, turned as the world."""
    turn = matrix(from_yaw(leaf.yaw))
    shapes = tuple(Shape(2 * np.asarray(half), turn @ np.asarray(centre), leaf.yaw) for centre, half in leaf.boxes)
    own = leaf.inertia
    inertia = Inertia(own.mass, turn @ own.centre, turn @ own.tensor @ turn.T)
    looks = ("leaf", *("handle" for _ in shapes[1:]))
    joint = replace(leaf.moves, axis=turn @ leaf.moves.axis, anchor=np.asarray(leaf.position, dtype=float))
    return ArticulatedLink(name, inertia, shapes, tuple(zip(shapes, looks, strict=True)), joint)


def articulation_of(thing: Thing, bodies: Sequence[RigidBody], name: str, prefix: str = "") -> Articulation:
    """Some bodies of a thing: the first is the base, the others have joints; ``prefix`` begins the names of files."""
    mesh = body_of(thing).mesh
    names = legal_names([BASE, *(b.link.name for b in bodies[1:] if b.link is not None)])
    meshes, links = _Meshes(mesh, np.asarray(thing.scale), prefix), []
    face_body = thing.face_body if thing.asset is not None else mesh.face_link
    for body, own in zip(bodies, names, strict=True):
        anchor = np.zeros(3) if body.joint is None else body.joint.anchor
        inertia = replace(body.inertia, centre=body.inertia.centre - anchor)
        shapes = meshes.shapes(own, body.solids, anchor)
        visuals = meshes.visuals(own, face_body == body.number, anchor)
        links.append(ArticulatedLink(own, inertia, shapes, visuals, body.joint))
    return Articulation(name, tuple(links), thing.friction, meshes.looks, meshes.files)


def legal_names(names: Sequence[str]) -> list[str]:
    """Names that every reader takes, and no two alike."""
    return list(map(Names(legal_name), names))


def limits_of(joint: Joint) -> dict[str, float]:
    """The ends of a joint [rad] or [m], and its most effort and speed, as URDF and SDF call them."""
    low, high = joint.limits
    return {"lower": low, "upper": high, "effort": _EFFORT[joint.kind], "velocity": _SPEED[joint.kind]}


def tensor_entries(inertia: Inertia) -> dict[str, str]:
    """The six numbers of an inertia tensor [kg m2] by their names in URDF and SDF."""
    pairs = itertools.combinations_with_replacement(range(3), 2)
    return {f"i{'xyz'[i]}{'xyz'[k]}": f"{float(inertia.tensor[i, k]):.12g}" for i, k in pairs}


class _Meshes:
    """The mesh files of an articulation: one for each link and material, as most readers take one colour a mesh."""

    def __init__(self, mesh: Mesh, scale: np.ndarray, prefix: str):
        self._mesh, self._scale, self._prefix = mesh, scale, prefix
        used = np.unique(mesh.face_material).tolist()
        self._names = dict(zip(used, legal_names([mesh.materials[k].name for k in used]), strict=True))
        self._library = f"{prefix}materials.mtl"
        self.looks = {name: mesh.materials[k] for k, name in self._names.items()}
        self.files = {self._library: material_library(self.looks)}

    def visuals(self, link: str, chosen: np.ndarray, anchor: np.ndarray) -> tuple[tuple[Shape, str], ...]:
        """What is seen of a link: the faces [F] that are ``chosen``."""
        found = []
        for number, look in self._names.items():
            faces = self._mesh.faces[chosen & (self._mesh.face_material == number)]
            if not len(faces):
                continue
            kept, packed = np.unique(faces, return_inverse=True)
            points = self._mesh.vertices[kept] * self._scale - anchor
            file = f"{self._prefix}{link}-{look}.obj"
            self.files[file] = obj(points, packed.reshape(-1, 3), material=(self._library, look))
            found.append((Shape(file=file), look))
        return tuple(found)

    def shapes(self, link: str, solids: Sequence[Solid], anchor: np.ndarray) -> tuple[Shape, ...]:
        """The collision parts of a link."""
        found = []
        for k, solid in enumerate(solids):
            at = solid.points - anchor
            if solid.box is not None:
                centre, half = (np.asarray(v, dtype=float) for v in solid.box)
                found.append(Shape(2 * half, centre - anchor, points=at))
                continue
            file = f"{self._prefix}{link}-part-{k}.obj"
            corners = triangles(solid.points)[1].reshape(-1, 3)
            points, packed = np.unique(corners, axis=0, return_inverse=True)
            self.files[file] = obj(points - anchor, packed.reshape(-1, 3))
            found.append(Shape(file=file, points=at))
        return tuple(found)
