"""Homes as glTF 2.0 binary: a group for each room, in it a node for each object, ``<room>:<object>``.

Walls, decks, stairs, windows and leaves of doors are nodes beside the rooms, each once; the floor and the ceiling of a
room are in its group. Nodes and frames are those of `sceneweaver.export.glb`, all in the home's frame; a mesh is there
once, in however many rooms it stands.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

from sceneweaver.assets import Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.home import Home
from sceneweaver.io import write_atomic
from sceneweaver.runtime.deadline import checkpoint

from ..bodies import bodies_of, with_mesh
from ..glb import add_leaf, add_object, free_name
from ..glb_file import GlbFile
from ..shared import SharedFiles
from .built import BuiltHome
from .meshes import Part


def write_home_glb(
    home: Home, path: str | os.PathLike[str], load: Load | None = None, *, textures: bool = True
) -> None:
    """Write a home as GLB under a temporary name and rename it; for the arguments see ``home_glb``."""
    write_atomic(path, home_glb(BuiltHome.of(home, with_mesh(load)), textures=textures))


def home_glb_bytes(home: Home, load: Load, *, shared: SharedFiles) -> bytes:
    """The home whose objects' meshes and all images are shared files."""
    return home_glb(BuiltHome.of(home, with_mesh(load)), shared=shared)


def home_glb(built: BuiltHome, *, textures: bool = True, shared: SharedFiles | None = None) -> bytes:
    """A home as glTF 2.0 binary.

    Args:
        built: The home.
        textures: Whether materials have their maps, or are plain: a fraction of the size.
        shared: Where the meshes of objects and all images go, as files that the home names; None: into the file.
    """
    home, file = built.home, GlbFile(textures, shared)
    taken = {name for named in built.names.things.values() for name in named.values()}

    def node(part: Part) -> int:
        extras = {"kind": part.kind}
        mesh = file.mesh(f"\0{part.name}", _given(part.mesh), part.name)
        return file.node(free_name(part.name, taken), {"mesh": mesh, "extras": extras})

    rooms, around = [], []
    for part in built.parts:
        if part.kind not in ("floor", "ceiling") or part.room is None:
            around.append(node(part))
    around += [add_leaf(file, leaf, taken) for leaves in built.leaves for leaf in leaves]
    for room in home.rooms:
        checkpoint()
        inside = [node(p) for p in built.parts if p.room == room.id and p.kind in ("floor", "ceiling")]
        up = home.storey_of(room.id).elevation
        for body in bodies_of(room.scene, built.load) if room.scene is not None else ():
            named = built.names.object(room.id, body.object, up)
            inside.append(add_object(file, replace(body, object=named), taken))
        extras: dict[str, Any] = {"kind": "room", "type": room.type, "storey": room.storey}
        rooms.append(file.node(free_name(room.id, taken), {"children": inside, "extras": extras}))
    top = file.node(free_name(built.names.home, taken), {"children": rooms + around})
    extras = {"prompt": home.prompt, "rooms": {r.id: r.type for r in home.rooms}}
    return file.bytes(top, {"name": home.id, "extras": extras})


def _given(mesh: Mesh) -> Callable[[], Mesh]:
    return partial(lambda found: found, mesh)
