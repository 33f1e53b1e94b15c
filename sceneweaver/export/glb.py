"""Scenes as glTF 2.0 binary: one node for each object, named by its id.

glTF is y up; one root node turns the scene, so that everything below it is in metres and z up, as in scene.json.
An object's node carries its pose, its mesh is in the object's own frame with a primitive for each material: whoever
loads the file finds each body whole under its name. Doors, drawers, lids, knobs and what can be taken are nodes below
their object's, `<object>.<link>`, with their origin on the hinge; ``extras.joint`` says how they move. So are the
leaves of the room's doors, ``room:door:<id>``. Materials of one texture share its images and tint them.
"""

from __future__ import annotations

import math
import os
from dataclasses import replace
from functools import partial
from pathlib import Path

from sceneweaver.assets import Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import uv_of
from sceneweaver.physics.leaves import leaves
from sceneweaver.scene import Room, Scene, write_atomic

from .bodies import Missing, bodies_of, with_mesh
from .glb_file import GlbFile
from .glb_nodes import add_leaf, add_object, free_name
from .openings import window_mesh
from .room import floor_mesh, wall_mesh
from .shared import SharedFiles

_Y_UP = [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]


def write_glb(
    scene: Scene,
    path: str | os.PathLike[str],
    load: Load | None = None,
    missing: Missing = "error",
    *,
    textures: bool = True,
) -> None:
    """Write a scene as GLB under a temporary name and rename it; for the arguments see ``glb_bytes``."""
    write_atomic(path, glb_bytes(scene, load, missing, textures=textures))


def glb_bytes(
    scene: Scene,
    load: Load | None = None,
    missing: Missing = "error",
    *,
    textures: bool = True,
    shared: SharedFiles | None = None,
) -> bytes:
    """A scene as glTF 2.0 binary.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        missing: Whether an asset that cannot be loaded is an error, or its object is shown as its parts.
        textures: Whether materials have their maps, or are plain: a fraction of the size.
        shared: Where the meshes of objects and all images go, as files that the scene names; None: into the file.

    Raises:
        InputError: when an asset cannot be loaded or has no mesh, and ``missing`` is "error".
    """
    found = bodies_of(scene, with_mesh(load), missing)
    file = GlbFile(textures, shared)
    ids = set(scene.ids)
    meshes = room_meshes(scene.room)
    meshes |= {f"room:window:{w.id}": window_mesh(scene.room, w) for w in scene.room.windows}
    children = [
        file.node(free_name(name, ids), {"mesh": file.mesh(f"\0{name}", partial(meshes.__getitem__, name), name)})
        for name in meshes
    ]
    children += [add_leaf(file, leaf, ids) for leaf in leaves(scene.room)]
    children += [add_object(file, body, ids) for body in found]
    top = file.node(free_name("scene", ids), {"rotation": _Y_UP, "children": children})
    extras = {"prompt": scene.prompt, "room": scene.room.model_dump(mode="json")}
    return file.bytes(top, {"name": scene.id, "extras": extras})


def write_file(scene: Scene, path: Path, load: Load, *, textures: bool = True, client: None = None) -> None:
    """As `formats.Format.write` calls it."""
    write_glb(scene, path, load, textures=textures)


def model_bytes(mesh: Mesh, name: str) -> bytes:
    """One mesh as glTF 2.0 binary: a single node without a transform, so that its vertices are the model's frame.

    Args:
        mesh: In the frame of an object: z up, front +x, left +y. In the file it is y up with the front along +z, as
            glTF has it: a vertex (x, y, z) stands there as (y, z, x).
        name: Of the node and the mesh.
    """
    file = GlbFile()
    turned = replace(mesh, vertices=mesh.vertices[:, [1, 2, 0]], uv=uv_of(mesh))
    return file.bytes(file.node(name, {"mesh": file.mesh(name, lambda: turned)}), {"name": name})


def room_meshes(room: Room) -> dict[str, Mesh]:
    """Floor and walls by the name of their node: ``room:floor``, ``room:wall:0`` ..."""
    meshes = {"room:floor": floor_mesh(room)}
    for k in range(len(room.outline)):
        meshes[f"room:wall:{k}"] = wall_mesh(room, k)
    return {name: mesh for name, mesh in meshes.items() if len(mesh.faces)}  # a wall may be all opening
