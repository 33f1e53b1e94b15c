"""A scene as a MuJoCo model: the text of an MJCF file and the meshes that it names.

Floor and walls stand still; so do what hangs on walls and ceilings, what the scene calls fixed, the fixtures of
``fixtures.yaml`` (sanitary ware and the kitchen run, which are plumbed in or screwed together). All else is a free
body, however heavy: nothing that a person would call movable is welded. A body has the name of its object; its frame is
the object's (bottom centre, front +x), so that its position and rotation are the scene's.

Doors and drawers are bodies of their own in the object's, closed at 0 and held there by friction; so are the leaves of
the room's doors, ``room:door:<id>``. Contacts are left out in two places only: between a piece and its own doors, and
between floor coverings (at most ``COVERING`` thick) and what stands or swings over them, which share that layer by
construction.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets import Asset, Link, categories
from sceneweaver.assets.placed import Load, loader, scaled_asset
from sceneweaver.geometry.rotations import from_yaw, wxyz
from sceneweaver.geometry.shell import PANE_THICKNESS, WALL_THICKNESS, wall_pieces
from sceneweaver.scene import Room, Scene, SceneObject, Window

from .hulls import Solid, solids_of
from .leaves import Leaf, leaves, wall_ends
from .xml import child, text

COVERING = 0.03
"""Things on the floor that are at most this thick [m] lie under what stands over them: rugs and mats."""

STEP = 0.004
"""Time step [s]."""

UNSET = "0.5 0.5 0.5 1"
"""MuJoCo's own colour of geoms, which is the only one that leaves a geom that of its material."""

MEMORY = "1G"
"""Room for contacts; what is not needed is never touched."""

_STOP = "0.008 1"  # ends of doors and drawers: as stiff as the time step allows, as many weigh little
_DENSITY = 150.0  # [kg/m3] of an object's parts, when neither an asset nor its category says what it weighs


@dataclass(frozen=True)
class Thing:
    """An object with what a simulator needs: its parts (in its frame), mass [kg], friction, and whether it may move.

    ``key`` is equal for things with equal bodies; ``scale`` [3] brings the asset to the object's size.
    """

    object: SceneObject
    asset: Asset | None
    key: str
    scale: tuple[float, float, float]
    solids: tuple[Solid, ...]
    mass: float
    friction: float
    free: bool


@dataclass(frozen=True)
class Model:
    """MJCF text, the files it names (by path relative to it), and the ids of bodies that may move and that may not."""

    xml: str
    files: dict[str, bytes]
    free: tuple[str, ...]
    fixed: tuple[str, ...]


Dress = Callable[[Xml.Element, Xml.Element, Thing, int], None]
"""Adds what is seen of a thing's link to a body: (assets, body, thing, link)."""


def build(scene: Scene, load: Load | None = None, dress: Dress | None = None) -> Model:
    """The MuJoCo model of a scene.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        dress: Adds visual meshes; None: only collision parts.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    things = things_of(scene, load)
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
    return Model(Xml.tostring(root, encoding="unicode") + "\n", {}, free, fixed)


def things_of(scene: Scene, load: Load | None = None) -> list[Thing]:
    """All objects, in their order; each asset is loaded once."""
    load, bodies = loader(load), {}
    return [_thing(k, o, load, bodies) for k, o in enumerate(scene.objects)]


def _thing(index: int, thing: SceneObject, load: Load, bodies: dict[str, tuple[Solid, ...]]) -> Thing:
    asset, scale = scaled_asset(index, thing, load)
    size = "" if scale == (1, 1, 1) else f"*{text(scale)}"
    key = f"parts:{thing.id}" if thing.asset is None else f"{thing.asset}{size}"
    if key not in bodies:
        bodies[key] = tuple(solids_of(thing, asset, np.asarray(scale)))
    solids = bodies[key]
    mass, friction = _weight(thing, asset, float(np.prod(scale)), sum(s.volume for s in solids))
    return Thing(thing, asset, key, scale, solids, mass, friction, not is_fixture(thing))


def is_fixture(thing: SceneObject) -> bool:
    """Whether it stands still: see the module's text."""
    named = thing.category.strip().lower().replace(" ", "_") in _fixtures()
    return thing.fixed or thing.mount in ("wall", "ceiling") or named


@cache
def _fixtures() -> frozenset[str]:
    import yaml

    data = yaml.safe_load(resources.files(__package__ or "").joinpath("fixtures.yaml").read_text(encoding="utf-8"))
    return frozenset(data["categories"])


def _weight(thing: SceneObject, asset: Asset | None, scale: float, volume: float) -> tuple[float, float]:
    """Mass [kg] and friction: of the asset, else of the category, else by the volume of the parts."""
    if asset is not None:
        return max(asset.mass * scale, 1e-3), asset.friction
    kind = categories().get(thing.category.strip().lower().replace(" ", "_"))
    if kind is not None:
        return math.sqrt(kind.mass[0] * kind.mass[1]), kind.friction
    return max(_DENSITY * volume, 1e-3), 0.5


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


def joint_of(
    link: Link, scale: tuple[float, float, float], mass: float
) -> tuple[np.ndarray, tuple[float, float], float]:
    """The unit axis [3] of a door or drawer of that mass [kg], its limits [rad] or [m] and its friction.

    The friction, [N m] or [N], keeps it where it is against the little that a tilt or a hinge below brings, and a hand
    moves it with ease. ``scale`` is that of the object: a drawer of a deeper one comes out farther.
    """
    slides = link.joint == "slide"
    axis = np.asarray(link.axis, dtype=float) * (np.asarray(scale) if slides else 1.0)
    stretch = float(np.linalg.norm(axis)) if slides else 1.0
    low, high = (float(end) * stretch for end in link.limits)
    hold = max(1.0, 2.0 * mass) if slides else max(0.2, 0.5 * mass)
    return axis / np.linalg.norm(axis), (low, high), hold


def _body(
    world: Xml.Element, assets: Xml.Element, contact: Xml.Element, thing: Thing, made: set[str], dress: Dress | None
) -> None:
    object_id = thing.object.id
    pose = thing.object.pose
    top = child(world, "body", name=object_id, pos=pose.position, quat=wxyz(pose.quaternion))
    if thing.free:
        child(top, "freejoint", name=object_id)
    links = thing.asset.links if thing.asset is not None else ()
    frames = [top]
    total = sum(s.volume for s in thing.solids)
    for number, link in enumerate(links, 1):
        if not any(s.link == number for s in thing.solids):
            frames.append(top)  # it has no parts, so it does not move
            continue
        frame = child(top, "body", name=f"{object_id}/{link.name}")
        mine = sum(s.volume for s in thing.solids if s.link == number) / total * thing.mass
        axis, limits, hold = joint_of(link, thing.scale, mine)
        anchor = np.asarray(link.anchor) * np.asarray(thing.scale)
        _joint(frame, f"{object_id}/{link.name}", link.joint, axis, limits, hold, pos=anchor)
        frames.append(frame)
        if not thing.free:  # a body that is part of the world is not left out as a parent is
            child(contact, "exclude", body1=object_id, body2=f"{object_id}/{link.name}")
    for k, solid in enumerate(thing.solids):
        _geom(assets, frames[solid.link], thing, k, solid, total, made)
    if dress is not None:
        for number, frame in enumerate(frames):
            dress(assets, frame, thing, number)


def _geom(
    assets: Xml.Element, frame: Xml.Element, thing: Thing, k: int, solid: Solid, total: float, made: set[str]
) -> None:
    share: dict[str, Any] = {"mass": max(thing.mass * solid.volume / total, 1e-7), "friction": thing.friction}
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
            links = enumerate(other.asset.links if other.asset else (), 1)
            moving = [link.name for k, link in links if any(s.link == k for s in other.solids)]
            names += [other.object.id, *(f"{other.object.id}/{name}" for name in moving)]
        for name in names:
            child(contact, "exclude", body1=things[cover].object.id, body2=name)


def _middle(room: Room) -> tuple[float, float, float]:
    low, high = np.min(room.outline, axis=0), np.max(room.outline, axis=0)
    return float(low[0] + high[0]) / 2, float(low[1] + high[1]) / 2, room.height / 2


def _reach(room: Room) -> float:
    return float(np.linalg.norm(np.max(room.outline, axis=0) - np.min(room.outline, axis=0)))
