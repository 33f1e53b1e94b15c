"""Scenes as glTF 2.0 binary: one node for each object, named by its id.

glTF is y up, and so is the frame of every node: what is (x, y, z) in scene.json is (x, z, -y) here. Importers of tools
that are z up, as Blender, turn each node's frame, which then is that of scene.json: z up, an object's front +x.
An object's node carries its pose, its mesh is in the object's own frame with a primitive for each material: whoever
loads the file finds each body whole under its name. Doors, drawers, lids, knobs and what can be taken are nodes below
their object's, `<object>.<link>`, with their origin on the hinge; ``extras.joint`` says how they move: ``axis`` in the
node's own frame as it is in the file, ``axis_z_up`` the same in that of scene.json. So are the leaves of the room's
doors, ``room:door:<id>``. Materials of one texture share its images and tint them.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from sceneweaver.assets import Link, Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import uv_of
from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.io import write_atomic
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.physics.things import Joint, moving_links
from sceneweaver.scene import Room, Scene

from .bodies import Body, Missing, bodies_of, some_faces, with_mesh
from .glb_file import GlbFile
from .glb_mesh import y_up
from .openings import window_mesh
from .room import floor_mesh, leaf_mesh, wall_mesh
from .shared import SharedFiles

_SAME = (1.0, 1.0, 1.0)


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
    top = file.node(free_name("scene", ids), {"children": children})
    extras = {"prompt": scene.prompt, "room": scene.room.model_dump(mode="json")}
    return file.bytes(top, {"name": scene.id, "extras": extras})


def model_bytes(mesh: Mesh, name: str) -> bytes:
    """One mesh as glTF 2.0 binary: a single node without a transform, so that its vertices are the model's frame.

    Args:
        mesh: In the frame of an object: z up, front +x, left +y. In the file it is y up with the front along +z, as
            glTF has it: a vertex (x, y, z) stands there as (y, z, x).
        name: Of the node and the mesh.
    """
    file = GlbFile()
    turned = replace(mesh, vertices=mesh.vertices[:, [1, 0, 2]] * (1.0, -1.0, 1.0), uv=uv_of(mesh))
    return file.bytes(file.node(name, {"mesh": file.mesh(name, lambda: turned)}), {"name": name})


def room_meshes(room: Room) -> dict[str, Mesh]:
    """Floor and walls by the name of their node: ``room:floor``, ``room:wall:0`` ..."""
    meshes = {"room:floor": floor_mesh(room)}
    for k in range(len(room.outline)):
        meshes[f"room:wall:{k}"] = wall_mesh(room, k)
    return {name: mesh for name, mesh in meshes.items() if len(mesh.faces)}  # a wall may be all opening


def free_name(name: str, taken: set[str]) -> str:
    """The name, or a longer one where it is taken, which it is from now on: objects keep theirs."""
    while name in taken:
        name += " (room)"
    taken.add(name)
    return name


def add_object(file: GlbFile, body: Body, taken: set[str]) -> int:
    """An object's node: its mesh, its pose and what else is known of it; below it what moves of it.

    Args:
        file: Where it goes.
        body: The object; its id is its node's name.
        taken: Names that no other node may have.
    """
    thing = body.object
    extras: dict[str, Any] = {"category": thing.category, "mount": thing.mount, "size": list(thing.size)}
    if thing.asset is not None:
        extras["asset"] = thing.asset
    if thing.support is not None:
        extras["support"] = {"object": thing.support.object, "surface": thing.support.surface}
    if body.note:
        extras["note"] = body.note
    node: dict[str, Any] = {"translation": _vector(thing.pose.position), "rotation": _rotation(thing.pose.quaternion)}
    moving = moving_links(body.asset) if body.asset is not None else frozenset()
    if not moving:
        if body.scale != _SAME:
            x, y, z = body.scale
            node["scale"] = [x, z, y]
        mesh = file.mesh(body.key, lambda: body.mesh, asset=body.asset)
        return file.node(thing.id, {"mesh": mesh, **node, "extras": extras})
    assert body.asset is not None
    # The scale goes into the meshes: a door that turns below a node of uneven scale would be sheared.
    key = body.key if body.scale == _SAME else f"{body.key}*{body.scale}"
    link_of = np.where(np.isin(body.mesh.face_link, list(moving)), body.mesh.face_link, 0)
    children = []
    for number in sorted(moving):
        link = body.asset.links[number - 1]
        anchor = np.asarray(link.anchor if link.joint == "hinge" else (0.0, 0.0, 0.0)) * body.scale
        below = {"translation": _vector(anchor), "extras": {"joint": _joint(link, body.scale)}}
        if (link_of == number).any():
            part = partial(_part, body, link_of == number, anchor)
            place = (number, body.scale)
            below["mesh"] = file.mesh(f"{key}.{number}", part, f"{key}.{link.name}", body.asset, place)
        children.append(file.node(free_name(f"{thing.id}.{link.name}", taken), below))
    if (link_of == 0).any():
        base = partial(_part, body, link_of == 0, np.zeros(3))
        node["mesh"] = file.mesh(f"{key}.0", base, key, body.asset, (0, body.scale))
    return file.node(thing.id, {**node, "children": children, "extras": extras})


def add_leaf(file: GlbFile, leaf: Leaf, taken: set[str]) -> int:
    """The node of a door's leaf, closed."""
    joint = {"type": leaf.joint, **_axes(leaf.axis), "limits": list(leaf.limits), "role": "door"}
    node: dict[str, Any] = {
        "mesh": file.mesh(f"\0{leaf.name}", lambda: leaf_mesh(leaf), leaf.name),
        "translation": _vector(leaf.position),
        "rotation": _rotation(from_yaw(leaf.yaw)),
        "extras": {"joint": joint},
    }
    return file.node(free_name(leaf.name, taken), node)


def _joint(link: Link, scale: tuple[float, float, float]) -> dict[str, Any]:
    """How a node moves in its parent, with which it shares its axes: it turns about ``axis`` or goes along it by
    ``limits`` [rad] or [m], 0 is as it is; a free one can be taken. ``axis_z_up`` is the axis in a z-up frame."""
    joint = Joint.of(link, scale, 0.0)  # what it weighs matters to its friction alone
    if joint is None:
        return {"type": "free", "role": link.role, "category": link.category}
    return {"type": joint.kind, **_axes(joint.axis), "limits": list(joint.limits), "role": link.role}


def _vector(vector: Sequence[float] | np.ndarray) -> list[float]:
    """A vector [3] of a z-up frame in the frame of the file."""
    return y_up(np.asarray(vector, dtype=float)).tolist()


def _rotation(quaternion: Sequence[float]) -> list[float]:
    """A rotation (x, y, z, w) of a z-up frame as one of the file."""
    return [*_vector(quaternion[:3]), float(quaternion[3])]


def _axes(axis: Sequence[float] | np.ndarray) -> dict[str, list[float]]:
    return {"axis": _vector(axis), "axis_z_up": [float(v) for v in axis]}


def _part(body: Body, chosen: np.ndarray, origin: np.ndarray) -> Mesh:
    """Some faces of an object's mesh in its size, with their origin at a point of the object's frame."""
    mesh = some_faces(body.mesh, chosen)
    return replace(mesh, vertices=mesh.vertices * body.scale - origin)
