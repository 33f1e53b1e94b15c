"""A scene as a MuJoCo model: the text of an MJCF file and the meshes that it names.

Floor and walls stand still; so do what hangs on walls and ceilings, what the scene calls fixed, and what is built in
(sanitary ware and the kitchen run, which are plumbed in or screwed together). All else is a free body, however heavy:
nothing that a person would call movable is welded. A body has the name of its object; its frame is the object's
(bottom centre, front +x), so that its position and rotation are the scene's.

What lies in or on an object as part of it, as fruit in a bowl, is a free body of its own, ``<object>.<item>``, in the
frame of the object. Doors and drawers are bodies in the object's, ``<object>.<link>``, closed at 0 and held there by
friction; so are the leaves of the room's doors, ``room:door:<id>``. Contacts are left out in two places only: between a
piece and its own doors, and between floor coverings (at most ``COVERING`` thick) and what stands on the floor or swings
over it, which share that layer by construction. The latter is done by bits of ``contype`` and ``conaffinity``; what has
MuJoCo's own, as a robot and all that stands on furniture, touches everything.

The model joins others: there is no ``compiler`` element (so angles are degrees), all defaults are those of the class
``room``, and each body says its inertia.

====================================  =============================================================================
``<body>:part:<k>``                   geom: a collision part, or all there is of a wall (``room:floor`` is the floor)
``<body>:handle:<k>``                 geom: a collision part of a handle
``<body>:visual:<k>``                 geom: what is seen, where a file shows it
``<body>:grasp:<name>``               site: where a gripper takes hold; +z is the way of the hand, its fingers close
                                      along y, and the box has the length and thickness of what they hold
``<body>:interior:<name>``            site: the box that is free inside
``<body>:surface:<name>``             site: a flat box where things may stand
``room:spawn:<door>``                 site: on the floor inside a door, +x into the room
``room:top``, ``room:eye-door``, ...  cameras; ``room:eye-corner`` and ``room:eye-corner2``
``start``                             keyframe: as the scene has it
====================================  =============================================================================
"""

from __future__ import annotations

import math
import re
import zlib
from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.assets.recent import Recent
from sceneweaver.geometry.rotations import from_yaw, wxyz
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import Scene, SceneObject

from .enclosure import Enclosure, room_enclosure
from .frames import Frame, frames_of, leaf_frames
from .inertia import inertia_of, shares_of
from .leaves import Leaf
from .shell import FLOOR_FRICTION, LEAF_FRICTION
from .solids import Solid
from .things import Joint, RigidBody, Thing, things_of
from .xml import attributes, child, document

COVERING = 0.03
"""Things on the floor that are at most this thick [m] lie under what stands over them: rugs and mats."""

STEP = 0.004
"""Time step [s]."""

ARMATURE = 0.001
"""Inertia [kg m2] or mass [kg] of a joint itself."""

STOP = "0.008 1"
"""Solver reference of the ends of doors and drawers: as stiff as the time step allows, as many weigh little."""

SOLVER = {"integrator": "implicitfast", "cone": "elliptic", "impratio": 10.0}
"""Options of the solver. There is no noslip pass: its cost grows with the square of the contacts, and over 3 s nothing
creeps without it."""

UNSET = "0.5 0.5 0.5 1"
"""MuJoCo's own colour of geoms, which is the only one that leaves a geom that of its material."""

MEMORY = "1G"
"""Room for contacts; what is not needed is never touched."""

ROOM = "room"
"""The default class of all that is exported; those of visual geoms, floor coverings and what stands over these are
``room:visual``, ``room:covering`` and ``room:grounded``."""

_LEAST_INERTIA = 1e-7  # [kg m2] about each axis: less is not stable at the time step
_BUTTON = {"stiffness": 200.0, "springref": -0.003}  # [N/m], [m]: friction alone gives way slowly


@dataclass(frozen=True)
class Model:
    """MJCF text, the files it names (by path relative to it), and the ids of bodies that may move and that may not.

    ``items`` are the names of bodies that lie on or in an object and can be taken, as an apple in a bowl.
    """

    xml: str
    files: dict[str, bytes]
    free: tuple[str, ...]
    fixed: tuple[str, ...]
    items: tuple[str, ...] = ()


class Plain:
    """What a writer of models decides for itself; as it is, collision parts are all there is, by their vertices."""

    visible = False
    """Whether the model is to be looked at."""

    def shape(self, thing: Thing) -> str:
        """Equal for things that have the same meshes."""
        return thing.shape

    def add_meshes(self, assets: Xml.Element, thing: Thing) -> None:
        """Add the meshes that geoms of a thing name, see `hull_name`; called once for all of equal shape."""
        for k, solid in enumerate(thing.solids):
            if solid.box is None:
                child(assets, "mesh", name=hull_name(thing, k), inertia="convex", vertex=solid.points.reshape(-1))

    def dress(self, assets: Xml.Element, frame: Xml.Element, thing: Thing, body: RigidBody) -> None:
        """Add what is seen of a body of a thing."""

    def finish(self, root: Xml.Element) -> None:
        """Change the whole before it becomes text."""


def build(scene: Scene, load: Load | None = None, look: Plain | None = None, *, loose: bool = True) -> Model:
    """The MuJoCo model of a scene.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        look: Meshes, and what is seen; None: only collision parts.
        loose: Whether what lies in or on an object as part of it is a body of its own, as `things_of` says.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    return assemble(room_enclosure(scene), things_of(scene, load, loose=loose), look)


def assemble(around: Enclosure, things: Sequence[Thing], look: Plain | None = None) -> Model:
    """The MuJoCo model of things and what is around them; ``look`` as for `build`."""
    writer = look or Plain()
    things = [replace(thing, shape=writer.shape(thing)) for thing in things]
    root = Xml.Element("mujoco", model=around.id)
    add_options(root)
    child(root, "statistic", center=around.middle, extent=around.reach)
    visual = child(root, "visual")
    child(visual, "headlight", ambient="0.42 0.42 0.44", diffuse="0.3 0.3 0.3", specular="0 0 0")
    child(visual, "quality", shadowsize="4096")
    _defaults(root)
    assets = child(root, "asset")
    if writer.visible:
        sky = {"type": "skybox", "builtin": "gradient", "rgb1": "0.8 0.84 0.88", "rgb2": "0.97 0.96 0.94"}
        child(assets, "texture", {**sky, "width": "64", "height": "384"})
    world = child(root, "worldbody")
    child(
        world,
        "light",
        name=f"{around.name}:light",
        directional="true",
        pos=(*around.middle[:2], 2 * float(around.high[2])),
        dir="-0.35 0.25 -1",
        diffuse="0.55 0.53 0.5",
        specular="0.1 0.1 0.1",
    )
    _shell(world, assets, around)
    contact = child(root, "contact")
    covers = {k for k, _ in coverings(things)}
    bodies = _Bodies(world, assets, contact, writer)
    for k, thing in enumerate(things):
        over = covers and thing.object.mount == "floor"
        bodies.add(thing, "room:covering" if k in covers else "room:grounded" if over else ROOM)
    for leaf in around.leaves:
        _leaf(world, leaf, "room:grounded" if covers else ROOM)
        if leaf.stuck:
            for standing in around.standing:
                child(contact, "exclude", body1=leaf.name, body2=standing.name)
    for frame in around.spawns:
        turn = wxyz(frame.quaternion)
        child(world, "site", {"name": frame.name, "pos": frame.position, "quat": turn, "class": ROOM})
    for view in around.views:
        turn, angle = wxyz(view.quaternion), round(math.degrees(view.angle), 6)
        child(world, "camera", name=view.name, pos=view.position, quat=turn, fovy=angle)
    child(child(root, "keyframe"), "key", name="start")  # without numbers: those of the bodies, whatever joins them
    writer.finish(root)
    free = tuple(t.object.id for t in things if t.free)
    fixed = tuple(t.object.id for t in things if not t.free)
    items = tuple(body.name for t in things for body in t.bodies if body.loose)
    return Model(document(root), {}, free, fixed, items)


def mesh_stem(thing: Thing) -> str:
    """What the names of a thing's meshes begin with: letters, digits and dashes; equal for things of equal shape."""
    category = re.sub(r"[^A-Za-z0-9_]+", "-", thing.object.category if thing.asset is None else thing.asset.category)
    return f"{category}-{zlib.crc32(thing.shape.encode()):08x}"


def add_options(root: Xml.Element, timestep: float = STEP) -> None:
    """How a model is solved, and its memory."""
    option = child(root, "option", timestep=timestep, **SOLVER)
    child(option, "flag", multiccd="enable")  # until MuJoCo 3.6 hulls touch in one point without it, and drift
    # Contacts and their constraints live here; the default is too small for a hundred pieces of many parts each.
    child(root, "size", memory=MEMORY)


def _defaults(root: Xml.Element) -> None:
    """The classes; nothing stands in the top one, which would hold for what joins the room as well."""
    default = child(root, "default")
    # Two geoms touch where the type of one shares a bit with the affinity of the other; MuJoCo's own are 1 and 1.
    bits = {ROOM: ("1", "1"), f"{ROOM}:covering": ("1", "0"), f"{ROOM}:grounded": ("3", "2")}
    for name, (contype, conaffinity) in bits.items():  # beside each other: some readers know of none within others
        room = child(default, "default", {"class": name})
        child(room, "geom", group="3", rgba="0.7 0.7 0.72 1", contype=contype, conaffinity=conaffinity)
        child(room, "site", group="4", rgba="0.2 0.7 0.3 0.4")
    seen = child(default, "default", {"class": f"{ROOM}:visual"})
    child(seen, "geom", type="mesh", group="2", contype="0", conaffinity="0", mass="0", rgba=UNSET)


def _shell(world: Xml.Element, assets: Xml.Element, around: Enclosure) -> None:
    """The floor, and what stands still as boxes, and hulls where they are none."""
    child(
        world,
        "geom",
        {"class": ROOM},
        name=f"{around.name}:floor",
        type="plane",
        pos=(*around.middle[:2], float(around.low[2])),
        size=(around.reach,) * 2 + (0.1,),
        group="0",
        rgba="0.74 0.62 0.48 1",
        friction=FLOOR_FRICTION,
    )
    for standing in around.standing:
        place = {"pos": standing.position, "quat": wxyz(from_yaw(standing.yaw)), "childclass": ROOM}
        frame = child(world, "body", place, name=standing.name)
        for k, slab in enumerate(standing.slabs):
            look = {"group": "0", "rgba": "0.75 0.85 0.9 0.25" if slab.pane else "0.92 0.91 0.88 1"}
            name = f"{standing.name}:part:{k}"
            if slab.points is None:
                shape: dict[str, Any] = {"type": "box", "pos": slab.centre, "size": slab.half}
            else:
                child(assets, "mesh", name=name, inertia="convex", vertex=slab.points.reshape(-1))
                shape = {"type": "mesh", "mesh": name}
            child(frame, "geom", {"name": name, **shape, **look})


def _leaf(world: Xml.Element, leaf: Leaf, kind: str) -> None:
    """The leaf of a door: friction keeps it where it is; a robot's pull at the handle is more."""
    place = {"pos": leaf.position, "quat": wxyz(from_yaw(leaf.yaw)), "childclass": kind}
    frame = child(world, "body", place, name=leaf.name)
    _joint(frame, leaf.name, leaf.moves)
    _add_sites(frame, leaf_frames(leaf))
    for k, ((centre, half), mass) in enumerate(zip(leaf.boxes, shares_of(leaf.solids, leaf.mass), strict=True)):
        child(
            frame,
            "geom",
            name=f"{leaf.name}:{f'handle:{k - 1}' if k else 'part:0'}",
            type="box",
            pos=centre,
            size=half,
            group="0",
            rgba="0.82 0.74 0.62 1",
            mass=mass,
            friction=LEAF_FRICTION,
        )


def _add_sites(element: Xml.Element, frames: Sequence[Frame]) -> None:
    """Frames in a body as boxes of the size of what they mark; they carry no weight and touch nothing."""
    for frame in frames:
        turn: dict[str, Any] = {"quat": wxyz(frame.quaternion)} if frame.kind == "grasp" else {}
        place = {"name": frame.name, "type": "box", "pos": frame.position, "size": frame.half}
        child(element, "site", {**place, **turn})


def _joint(frame: Xml.Element, name: str, joint: Joint, **more: Any) -> None:
    """A joint that friction and a damper keep where it is."""
    ends = np.rad2deg(joint.limits) if joint.kind == "hinge" else joint.limits
    held = {"damping": joint.hold, "frictionloss": joint.hold, "armature": ARMATURE, "solreflimit": STOP}
    place = {"axis": joint.axis, **more, "limited": "true", "range": ends}
    child(frame, "joint", {"name": name, "type": joint.kind, **place, **held})


class _Bodies:
    """Writes things: their bodies with collision parts, inertia and sites; each mesh once, however many use it."""

    def __init__(self, world: Xml.Element, assets: Xml.Element, contact: Xml.Element, writer: Plain) -> None:
        self._world, self._assets, self._contact, self._writer = world, assets, contact, writer
        self._meshed = set[str]()

    def add(self, thing: Thing, kind: str) -> None:
        """A thing, its geoms of the default class ``kind``."""
        checkpoint()
        if thing.shape not in self._meshed:
            self._meshed.add(thing.shape)
            self._writer.add_meshes(self._assets, thing)
        place = {"pos": thing.object.pose.position, "quat": wxyz(thing.object.pose.quaternion)}
        base, *moving = thing.bodies
        top = child(self._world, "body", {"name": base.name, **place, "childclass": kind})
        if thing.free:
            child(top, "freejoint", name=base.name)
        self._fill(top, thing, base)
        for body in moving:
            if body.joint is None or body.link is None:
                frame = child(self._world, "body", {"name": body.name, **place, "childclass": ROOM})
                child(frame, "freejoint", name=body.name)
            else:
                frame = child(top, "body", name=body.name)
                button = body.link.role == "control" and body.joint.kind == "slide"
                _joint(frame, body.name, body.joint, pos=body.joint.anchor, **(_BUTTON if button else {}))
                if not thing.free:  # a body that is part of the world is not left out as a parent is
                    child(self._contact, "exclude", body1=base.name, body2=body.name)
            self._fill(frame, thing, body)

    def _fill(self, frame: Xml.Element, thing: Thing, body: RigidBody) -> None:
        """The collision parts of a body, its mass spread over them by volume, its sites and what is seen of it."""
        key = (thing.solids, thing.shape, thing.welded, thing.friction, body.number, body.mass)
        recurs = thing.asset is not None
        written = _WRITTEN.get(key, lambda: _written(thing, body)) if recurs else _written(thing, body)
        Xml.SubElement(frame, "inertial", written.inertial)
        for name, given in written.geoms:
            Xml.SubElement(frame, "geom", {"name": body.name + name, **given})
        _add_sites(frame, frames_of(thing, body))
        self._writer.dress(self._assets, frame, thing, body)


@dataclass(frozen=True)
class _Written:
    """The collision parts of a body in attributes of their elements: its inertia, and each geom with what its name ends
    in."""

    inertial: dict[str, str]
    geoms: tuple[tuple[str, dict[str, str]], ...]

    @property
    def nbytes(self) -> int:
        """About the memory that it takes."""
        return 2**9 + 3 * 2**8 * len(self.geoms)


_WRITTEN: Recent[Hashable, _Written] = Recent(48 * 2**20, lambda written: written.nbytes)
"""By parts and weights: things recur from room to room."""


def _written(thing: Thing, body: RigidBody) -> _Written:
    """A body of a thing, its mass spread over its parts by volume."""
    masses = [max(share, 1e-7) for share in shares_of(body.solids, body.mass)]
    count, shares, geoms = Counter[str](), iter(masses), []
    for k, solid in enumerate(thing.solids):
        if thing.body_of(solid.link) != body.number:
            continue
        kind = "handle" if solid.handle else "part"
        geoms.append((f":{kind}:{count[kind]}", attributes(_geom(thing, k, solid, next(shares)))))
        count[kind] += 1
    return _Written(attributes(_inertial(body, masses)), tuple(geoms))


def _geom(thing: Thing, k: int, solid: Solid, mass: float) -> dict[str, Any]:
    share: dict[str, Any] = {"mass": mass, "friction": thing.friction}
    if thing.asset is None:
        share["group"] = "0"  # nothing else of it is to be seen
    if solid.box is not None:
        return {"type": "box", "pos": solid.box[0], "size": solid.box[1], **share}
    return {"type": "mesh", "mesh": hull_name(thing, k), **share}


def hull_name(thing: Thing, number: int) -> str:
    """The name of the mesh of a part of a thing that is no box."""
    return f"{mesh_stem(thing)}-hull-{number}"


def _inertial(body: RigidBody, masses: Sequence[float]) -> dict[str, Any]:
    """Mass, centre and inertia of a body of those parts, the inertia bounded from below."""
    found = inertia_of(body.solids, masses)
    least, turn = np.linalg.eigh(found.tensor)
    tensor = turn @ np.diag(np.maximum(least, _LEAST_INERTIA)) @ turn.T
    six = (*np.diag(tensor), tensor[0, 1], tensor[0, 2], tensor[1, 2])
    return {"pos": found.centre, "mass": found.mass, "fullinertia": six}


def coverings(things: Sequence[Thing]) -> list[tuple[int, list[int]]]:
    """Numbers of rugs and mats, each with those of the things on the floor that are near enough to stand over it.

    Of two coverings one has the other, so that no pair is there twice.
    """
    floor = [k for k, t in enumerate(things) if t.object.mount == "floor"]
    flat = [k for k in floor if things[k].object.size[2] <= COVERING]

    def over(cover: SceneObject, k: int) -> bool:
        other = things[k].object
        reach = math.hypot(*cover.size[:2]) / 2 + math.hypot(*other.size[:2]) / 2
        near = math.dist(cover.pose.position[:2], other.pose.position[:2]) < reach
        return near and other is not cover and (k not in flat or other.id > cover.id)

    return [(i, [k for k in floor if over(things[i].object, k)]) for i in flat]
