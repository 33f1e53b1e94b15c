"""A scene as a MuJoCo model: the text of an MJCF file and the meshes that it names.

Floor and walls stand still; so do what hangs on walls and ceilings, what the scene calls fixed, the fixtures of
``fixtures.yaml`` (sanitary ware and the kitchen run, which are plumbed in or screwed together). All else is a free
body, however heavy: nothing that a person would call movable is welded. A body has the name of its object; its frame is
the object's (bottom centre, front +x), so that its position and rotation are the scene's.

What lies in or on an object as part of it, as fruit in a bowl, is a free body of its own, ``<object>.<item>``, in the
frame of the object. Doors and drawers are bodies in the object's, ``<object>.<link>``, closed at 0 and held there by
friction; so are the leaves of the room's doors, ``room:door:<id>``. Contacts are left out in two places only: between a
piece and its own doors, and between floor coverings (at most ``COVERING`` thick) and what stands or swings over them,
which share that layer by construction.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import from_yaw, wxyz
from sceneweaver.geometry.shell import PANE_THICKNESS, WALL_THICKNESS, wall_pieces
from sceneweaver.scene import Room, Scene, SceneObject, Window

from .hulls import Solid
from .leaves import Leaf, leaves, wall_ends
from .things import RigidBody, Thing, joint_of, things_of
from .xml import child

COVERING = 0.03
"""Things on the floor that are at most this thick [m] lie under what stands over them: rugs and mats."""

STEP = 0.004
"""Time step [s]."""

UNSET = "0.5 0.5 0.5 1"
"""MuJoCo's own colour of geoms, which is the only one that leaves a geom that of its material."""

MEMORY = "1G"
"""Room for contacts; what is not needed is never touched."""

_STOP = "0.008 1"  # ends of doors and drawers: as stiff as the time step allows, as many weigh little


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


Dress = Callable[[Xml.Element, Xml.Element, Thing, RigidBody], None]
"""Adds what is seen of a thing's body: (assets, body, thing, which of its bodies)."""


def build(scene: Scene, load: Load | None = None, dress: Dress | None = None, *, loose: bool = True) -> Model:
    """The MuJoCo model of a scene.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        dress: Adds visual meshes; None: only collision parts.
        loose: Whether what lies in or on an object as part of it is a body of its own, as `things_of` says.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    things = things_of(scene, load, loose=loose)
    root = Xml.Element("mujoco", model=scene.id)
    child(root, "compiler", angle="radian", meshdir="meshes", texturedir="textures", boundinertia="1e-7")
    # No noslip pass: its cost grows with the square of the contacts, and over 3 s nothing creeps without it.
    child(root, "option", timestep=STEP, integrator="implicitfast", cone="elliptic", impratio="10")
    # Contacts and their constraints live here; the default is too small for a hundred pieces of many parts each.
    child(root, "size", memory=MEMORY)
    child(root, "statistic", center=_middle(scene.room), extent=_reach(scene.room))
    look = child(root, "visual")
    child(look, "headlight", ambient="0.42 0.42 0.44", diffuse="0.3 0.3 0.3", specular="0 0 0")
    child(look, "quality", shadowsize="4096")
    default = child(root, "default")
    child(default, "geom", group="3", rgba="0.7 0.7 0.72 1")
    seen = child(default, "default", {"class": "visual"})
    child(seen, "geom", type="mesh", group="2", contype="0", conaffinity="0", mass="0", rgba=UNSET)
    assets = child(root, "asset")
    if dress is not None:
        child(
            assets,
            "texture",
            type="skybox",
            builtin="gradient",
            rgb1="0.8 0.84 0.88",
            rgb2="0.97 0.96 0.94",
            width="64",
            height="384",
        )
    world = child(root, "worldbody")
    child(
        world,
        "light",
        directional="true",
        pos=(*_middle(scene.room)[:2], 2 * scene.room.height),
        dir="-0.35 0.25 -1",
        diffuse="0.55 0.53 0.5",
        specular="0.1 0.1 0.1",
    )
    _shell(world, scene.room)
    contact = child(root, "contact")
    made: set[str] = set()
    for thing in things:
        _body(world, assets, contact, thing, made, dress)
    doors = leaves(scene.room)
    for leaf in doors:
        _leaf(world, leaf)
        if leaf.stuck:
            for k in range(len(scene.room.outline)):
                child(contact, "exclude", body1=leaf.name, body2=f"room:wall:{k}")
    _exclude_coverings(contact, things, doors)
    Xml.indent(root, " ")
    free = tuple(t.object.id for t in things if t.free)
    fixed = tuple(t.object.id for t in things if not t.free)
    items = tuple(body.name for t in things for body in t.bodies if body.loose)
    return Model(Xml.tostring(root, encoding="unicode") + "\n", {}, free, fixed, items)


def _shell(world: Xml.Element, room: Room) -> None:
    """The floor, and each wall as boxes around its openings; windows have a pane, doorways are open."""
    middle = _middle(room)
    child(
        world,
        "geom",
        name="room:floor",
        type="plane",
        pos=(*middle[:2], 0),
        size=(_reach(room),) * 2 + (0.1,),
        group="0",
        rgba="0.74 0.62 0.48 1",
        friction="0.8",
    )
    for wall in room.walls:
        frame = child(
            world, "body", name=f"room:wall:{wall.index}", pos=(*wall.start, 0), quat=wxyz(from_yaw(wall.yaw))
        )
        ends = wall_ends(room, wall.index)
        for span, z, opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height, ends):
            if opening is None:
                _slab(frame, *span, *z, WALL_THICKNESS)
            elif isinstance(opening, Window):
                _slab(frame, *span, *z, PANE_THICKNESS, rgba="0.75 0.85 0.9 0.25")


def _slab(frame: Xml.Element, x0: float, x1: float, z0: float, z1: float, thick: float, rgba: str = "") -> None:
    size = ((x1 - x0) / 2, thick / 2, (z1 - z0) / 2)
    pos = ((x0 + x1) / 2, -thick / 2, (z0 + z1) / 2)
    child(frame, "geom", type="box", pos=pos, size=size, group="0", rgba=rgba or "0.92 0.91 0.88 1")


def _leaf(world: Xml.Element, leaf: Leaf) -> None:
    """The leaf of a door: friction keeps it where it is; a robot's pull at the handle is more."""
    frame = child(world, "body", name=leaf.name, pos=leaf.position, quat=wxyz(from_yaw(leaf.yaw)))
    _joint(frame, leaf.name, leaf.joint, leaf.axis, leaf.limits, leaf.hold)
    volumes = [float(np.prod(half)) for _, half in leaf.boxes]
    for (centre, half), volume in zip(leaf.boxes, volumes, strict=True):
        child(
            frame,
            "geom",
            type="box",
            pos=centre,
            size=half,
            group="0",
            rgba="0.82 0.74 0.62 1",
            mass=leaf.mass * volume / sum(volumes),
            friction="0.5",
        )


def _joint(
    frame: Xml.Element, name: str, kind: str, axis: Any, limits: tuple[float, float], hold: float, **more: Any
) -> None:
    """A joint that friction and a damper, both ``hold`` [N m] or [N], keep where it is."""
    held = {"damping": hold, "frictionloss": hold, "armature": "0.001", "solreflimit": _STOP}
    place = {"axis": axis, **more, "limited": "true", "range": limits}
    child(frame, "joint", {"name": name, "type": kind, **place, **held})


def _body(
    world: Xml.Element, assets: Xml.Element, contact: Xml.Element, thing: Thing, made: set[str], dress: Dress | None
) -> None:
    pose = thing.object.pose
    base, *moving = thing.bodies
    top = child(world, "body", name=base.name, pos=pose.position, quat=wxyz(pose.quaternion))
    if thing.free:
        child(top, "freejoint", name=base.name)
    _fill(assets, top, thing, base, made, dress)
    for body in moving:
        assert body.link is not None
        if body.loose:
            frame = child(world, "body", name=body.name, pos=pose.position, quat=wxyz(pose.quaternion))
            child(frame, "freejoint", name=body.name)
        else:
            frame = child(top, "body", name=body.name)
            axis, limits, hold = joint_of(body.link, thing.scale, body.mass)
            anchor = np.asarray(body.link.anchor) * np.asarray(thing.scale)
            _joint(frame, body.name, body.link.joint, axis, limits, hold, pos=anchor)
            if not thing.free:  # a body that is part of the world is not left out as a parent is
                child(contact, "exclude", body1=base.name, body2=body.name)
        _fill(assets, frame, thing, body, made, dress)


def _fill(
    assets: Xml.Element, frame: Xml.Element, thing: Thing, body: RigidBody, made: set[str], dress: Dress | None
) -> None:
    """The collision parts of a body, its mass spread over them by volume, and what is seen of it."""
    volume = sum(solid.volume for solid in body.solids)
    for k, solid in enumerate(thing.solids):
        if thing.body_of(solid.link) == body.number:
            _geom(assets, frame, thing, k, solid, max(body.mass * solid.volume / volume, 1e-7), made)
    if dress is not None:
        dress(assets, frame, thing, body)


def _geom(
    assets: Xml.Element, frame: Xml.Element, thing: Thing, k: int, solid: Solid, mass: float, made: set[str]
) -> None:
    share: dict[str, Any] = {"mass": mass, "friction": thing.friction}
    if thing.asset is None:
        share["group"] = "0"  # nothing else of it is to be seen
    if solid.box is not None:
        child(frame, "geom", {"type": "box", "pos": solid.box[0], "size": solid.box[1], **share})
        return
    name = f"{thing.key}/{k}"
    if name not in made:
        made.add(name)
        child(assets, "mesh", name=name, inertia="convex", vertex=solid.points.reshape(-1))
    child(frame, "geom", {"type": "mesh", "mesh": name, **share})


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


def _exclude_coverings(contact: Xml.Element, things: list[Thing], doors: list[Leaf]) -> None:
    """Rugs and mats take part in no contact with what stands on the floor over them, nor with the doors' leaves."""
    for cover, above in coverings(things):
        names = [leaf.name for leaf in doors]
        for other in (things[k] for k in above):
            names += [body.name for body in other.bodies]
        for name in names:
            child(contact, "exclude", body1=things[cover].object.id, body2=name)


def _middle(room: Room) -> tuple[float, float, float]:
    low, high = np.min(room.outline, axis=0), np.max(room.outline, axis=0)
    return float(low[0] + high[0]) / 2, float(low[1] + high[1]) / 2, room.height / 2


def _reach(room: Room) -> float:
    return float(np.linalg.norm(np.max(room.outline, axis=0) - np.min(room.outline, axis=0)))
