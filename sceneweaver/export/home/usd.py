"""Homes as USD stages, with the physics of `sceneweaver.export.usd`.

::

    /PhysicsScene               gravity, and settings of the solvers
    /World                      the default prim: metres, kilograms, z up
      Looks, PhysicsMaterials, Prototypes
      Rooms/<room>              a group for each room: its Floor, Objects/<room>_<object>, Spawns
      Structure                 Ground; Walls, Floors of upper storeys, Railings, Stairs, Windows, each once; Ceilings,
                                invisible, so that light and eyes come in; Collision: what all of it collides as
      Doors                     leaves on hinges or slides
      Lights, Cameras

Prims of objects, bodies and joints have names that are there once in the stage, as engines take the last part of a
path.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.home import Home, HomeWindow
from sceneweaver.io import read_bytes
from sceneweaver.physics.enclosure import Standing
from sceneweaver.physics.shell import FLOOR_FRICTION
from sceneweaver.physics.solids import Solid
from sceneweaver.runtime.deadline import checkpoint

from ..names import Names
from ..shared import SharedFiles
from ..usd import filter_coverings, head, save_layer, usd_path
from ..usd_bodies import Solids, filter_pair
from ..usd_layer import Prim, attribute, label, place, prim, prim_names, usd
from ..usd_looks import Looks
from ..usd_mesh import box_collider, collider, render_mesh
from ..usd_objects import Prototypes, add_object
from ..usd_room import add_door
from ..usd_views import add_cameras, add_frames, light, sun_behind
from .built import BuiltHome
from .meshes import Part
from .pieces import plan_of

_GROUND = (1.0, 0.5)  # [m] that it goes on outside, and deep
_TOUCHES = 0.02  # [m] from the opening, a wall carries the leaf


def write_home_usd(
    home: Home, path: str | os.PathLike[str], load: Load | None = None, *, textures: bool = True
) -> None:
    """Write a home as USD; arguments and errors are those of `sceneweaver.export.usd.write_usd`."""
    name = usd_path(path)
    layer, files = home_layer(BuiltHome.of(home, load), textures=textures)
    save_layer(layer, name, files)


def home_usd_bytes(home: Home, load: Load | None, *, shared: SharedFiles) -> bytes:
    """The home as a binary stage whose images are shared files."""
    layer, _ = home_layer(BuiltHome.of(home, load), shared=shared)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "home.usdc"
        layer.Export(str(path))
        return read_bytes(path, max_bytes=2**32)


def home_layer(
    built: BuiltHome, *, textures: bool = True, shared: SharedFiles | None = None
) -> tuple[Any, dict[str, bytes]]:
    """The home as a ``pxr.Sdf.Layer`` in memory, and the images that it names by path relative to it, or none where
    they are shared files."""
    home = built.home
    layer = usd().Sdf.Layer.CreateAnonymous(".usda")
    with usd().Sdf.ChangeBlock():
        head(layer, {"id": home.id, "prompt": home.prompt, "rooms": {r.id: r.type for r in home.rooms}})
        world = prim(layer, "World", kind="assembly", displayName=home.id)
        looks = Looks(prim(world, "Looks", "Scope"), prim(world, "PhysicsMaterials", "Scope"), textures, shared)
        prototypes = Prototypes(prim(world, "Prototypes", "Scope"), looks)
        names = prim_names()
        titles = {thing.object.id: names(thing.object.id) for thing in built.things}
        walls = _structure(prim(world, "Structure", kind="group"), built, looks)
        doors = _doors(prim(world, "Doors", kind="group"), built, walls, names, looks)
        light(prim(world, "Lights", "Scope"), _to_the_sun(built), _over(built))
        add_cameras(prim(world, "Cameras", "Scope"), built.views())
        rooms = prim(world, "Rooms", kind="group")
        floors = {part.room: part for part in built.parts if part.kind == "floor"}
        things, folders = dict((room.id, things) for room, things in built.rooms), prim_names()
        for room in home.rooms:
            checkpoint()
            made = prim(rooms, folders(room.id), kind="group", displayName=room.id)
            made.SetInfo("customData", {"sceneweaver": {"id": room.id, "type": room.type, "storey": room.storey}})
            label(made, room.type, room.id)
            if room.id in floors:
                _seen(made, "Floor", floors[room.id], looks)
            add_frames(prim(made, "Spawns", kind="group"), built.spawns(room.id))
            objects, mine = prim(made, "Objects", kind="group"), things.get(room.id, [])
            solids = [add_object(objects, titles[t.object.id], t, prototypes, names) for t in mine]
            here = {door.id for door in home.doors_of(room.id)}
            filter_coverings(mine, solids, [solid for name, solid in doors if name in here], layer)
    return layer, looks.files


Walls = list[list[tuple[Standing, Solids]]]
"""Of each storey its walls with their colliders."""


def _structure(parent: Prim, built: BuiltHome, looks: Looks) -> Walls:
    """All that stands still."""
    low, high = built.corners
    out, deep = _GROUND
    half = np.array([*(high - low)[:2] / 2 + out, deep / 2])
    ground = prim(parent, "Ground", kind="component")
    label(ground, "ground")
    middle = np.array([*(low + high)[:2] / 2, low[2] - deep / 2])
    box_collider(prim(ground, "Collision", "Scope"), "part_0", middle, half, looks, FLOOR_FRICTION)
    names = prim_names()
    groups = {kind: prim(parent, f"{kind.capitalize()}s", kind="group") for kind in ("wall", "window")}
    for part in built.parts:
        if part.kind == "floor" and part.room is not None:
            continue  # in the group of its room
        group = groups.get(part.kind)
        if group is None:
            group = groups[part.kind] = prim(parent, f"{part.kind.capitalize()}s", kind="group")
        _seen(group, names(part.name), part, looks)
    if "ceiling" in groups:
        attribute(groups["ceiling"], "visibility", "Token", "invisible")
    colliders = prim(parent, "Collision", "Scope")
    walls = [
        [(body, Solids((), _collides(colliders, names(body.name), body, looks))) for body in storey]
        for storey in built.walls
    ]
    for body in built.fixed:
        _collides(colliders, names(body.name), body, looks)
    return walls


def _seen(parent: Prim, name: str, part: Part, looks: Looks) -> None:
    made = prim(parent, name, kind="component", displayName=part.name)
    label(made, part.kind)
    render_mesh(made, "Mesh", part.mesh, looks)


def _collides(parent: Prim, name: str, body: Standing, looks: Looks) -> tuple[Any, ...]:
    """The colliders of a body that stands still; returns their paths."""
    made = prim(parent, name, displayName=body.name)
    place(made, body.position, from_yaw(body.yaw))
    for k, slab in enumerate(body.slabs):
        if slab.points is None:
            box_collider(made, f"part_{k}", slab.centre, slab.half, looks, FLOOR_FRICTION)
        else:
            collider(made, f"part_{k}", Solid(slab.points, 0.0), looks, FLOOR_FRICTION)
    return tuple(made.path.AppendChild(f"part_{k}") for k in range(len(body.slabs)))


def _doors(parent: Prim, built: BuiltHome, walls: Walls, names: Names, looks: Looks) -> list[tuple[str, Solids]]:
    """The leaves of all doors with the ids of these. One may touch the walls that carry it, and no more than touch."""
    found = []
    for plan, leaves, bodies in zip(built.plans, built.leaves, walls, strict=True):
        near = {o.opening.id: plan.hole(o).buffer(_TOUCHES) for o in plan.openings}
        for leaf in leaves:
            solid = add_door(parent, names, leaf, looks)
            found.append((leaf.door, solid))
            for body, colliders in bodies:
                if near[leaf.door].intersects(plan_of(body)):
                    filter_pair(solid, colliders, parent.layer)
    return found


def _to_the_sun(built: BuiltHome) -> np.ndarray:
    """Behind the wall with most glass of all rooms."""
    glass: dict[tuple[str, int], float] = {}
    for window in built.home.windows:
        assert isinstance(window, HomeWindow)
        key = (window.room, window.wall)
        glass[key] = glass.get(key, 0.0) + window.width * window.height
    if not glass:
        return sun_behind(None)
    room, wall = max(glass, key=lambda key: round(glass[key], 6))
    return sun_behind(built.home.room(room).walls[wall])


def _over(built: BuiltHome) -> tuple[float, float, float]:
    low, high = built.corners
    return float(low[0]), float(low[1]), 2 * float(high[2])
