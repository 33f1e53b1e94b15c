"""A GLB file as a scene to look at. Of our own files room and objects come back as they were; of others, every node
with a mesh is an object, in a room around them."""

from __future__ import annotations

import json
import os
import struct
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, Material, Mesh
from sceneweaver.assets.asset import Origin
from sceneweaver.assets.imports.guarded import MAX_BYTES, read_meshes
from sceneweaver.assets.placed import Load
from sceneweaver.scene import InputError, MissingDependencyError, Pose, Room, Scene, SceneObject, read_bytes

_GREY = Material("grey", (0.75, 0.74, 0.72))
_Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)


def read_glb(path: str | os.PathLike[str]) -> tuple[Scene, Load]:
    """The scene of a y-up GLB file in metres, and the loader of its meshes.

    Raises:
        InputError: when the file cannot be read or shows nothing.
    """
    import trimesh

    name = Path(path)
    try:
        document = _document(read_bytes(name, max_bytes=MAX_BYTES))
        found: Any = read_meshes(name)
        placed = [(str(node), *found.graph[node]) for node in found.graph.nodes_geometry]
    except (InputError, MissingDependencyError):
        raise
    except Exception as error:  # a broken file fails in many ways inside the reader
        raise InputError(f"{name}: is no GLB file that can be read ({type(error).__name__}); export it anew") from None
    ours = document.get("asset", {}).get("generator") == "sceneweaver"
    nodes = {str(row.get("name")): row for row in document.get("nodes", [])} if ours else {}
    objects: list[SceneObject] = []
    assets: dict[str, Asset] = {}
    corners: list[np.ndarray] = []
    for node, matrix, geometry in placed:
        shape = found.geometry[geometry]
        if not isinstance(shape, trimesh.Trimesh) or not len(shape.faces):
            continue
        if ours and "category" not in nodes.get(node, {}).get("extras", {}):
            continue  # floor and walls
        world = trimesh.transform_points(shape.vertices, _Z_UP @ matrix)
        if not np.isfinite(world).all():
            raise InputError(f"{name}: node '{node}' has numbers that are not finite; export it anew")
        corners += [world.min(axis=0), world.max(axis=0)]
        asset = f"{len(assets)}"
        thing, local = _ours(nodes[node], shape) if ours else _others(node, world)
        objects.append(thing.model_copy(update={"asset": asset}))
        assets[asset] = _asset(asset, thing.category, local, shape)
    if not objects:
        raise InputError(f"{name}: shows no mesh; export it anew")
    scene = document["scenes"][0] if ours else {}
    extras = scene.get("extras") or {}
    room = Room.model_validate(extras["room"]) if "room" in extras else _around(corners)
    return (
        Scene(id=scene.get("name") or name.stem, prompt=extras.get("prompt", ""), room=room, objects=tuple(objects)),
        assets.__getitem__,
    )


def _document(data: bytes) -> dict[str, Any]:
    """The JSON part of a GLB file."""
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + length])


def _ours(node: dict[str, Any], shape: Any) -> tuple[SceneObject, np.ndarray]:
    """An object of a file that we wrote, and its vertices in its frame."""
    extras = node["extras"]
    pose = Pose(position=tuple(node["translation"]), quaternion=tuple(node["rotation"]))
    mount = extras.get("mount", "floor")
    thing = SceneObject(
        id=node["name"],
        category=extras["category"],
        size=tuple(extras["size"]),
        pose=pose,
        mount="floor" if mount == "surface" else mount,
    )
    return thing, np.asarray(shape.vertices) * np.asarray(node.get("scale", (1.0, 1.0, 1.0)))


def _others(object_id: str, world: np.ndarray) -> tuple[SceneObject, np.ndarray]:
    """A node of anybody's file as an object that is not turned, and its vertices in its frame."""
    low, high = world.min(axis=0), world.max(axis=0)
    base = np.array([*(low + high)[:2] / 2, low[2]])
    x, y, z = base.tolist()
    d, w, h = np.maximum(high - low, 1e-3).tolist()
    clean = " ".join("".join(c if c.isprintable() else " " for c in object_id).split()) or "node"
    clean = clean.replace("wall:", "wall ")
    return SceneObject(id=clean, category="mesh", size=(d, w, h), pose=Pose(position=(x, y, z))), world - base


def _around(corners: list[np.ndarray]) -> Room:
    """A room a little larger than what is in it."""
    low, high = np.min(corners, axis=0) - 0.2, np.max(corners, axis=0) + 0.2
    (x0, y0, _), (x1, y1, z1) = low.tolist(), high.tolist()
    return Room(outline=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), height=max(0.5, z1))


def _asset(object_id: str, category: str, vertices: np.ndarray, shape: Any) -> Asset:
    faces = np.asarray(shape.faces, dtype=np.int32)
    colors, kinds = _colors(shape, faces)
    materials = tuple(Material(f"color {k}", (r, g, b)) for k, (r, g, b) in enumerate(colors)) or (_GREY,)
    mesh = Mesh(np.asarray(vertices), faces, kinds, np.zeros_like(kinds), materials)
    return Asset(
        id=object_id,
        category=category,
        mesh=mesh,
        hulls=(),
        parts=(),
        mount="floor",
        mass=1.0,
        friction=0.5,
        origin=Origin("glb", "unknown"),
    )


def _colors(shape: Any, faces: np.ndarray) -> tuple[list[tuple[float, float, float]], np.ndarray]:
    """The sRGB colours of a mesh and which one each face has, textures read at the face's first corner."""
    try:
        corners = np.asarray(shape.visual.to_color().vertex_colors)[faces[:, 0], :3]
    except Exception:  # no colour, or one that trimesh cannot work out
        return [], np.zeros(len(faces), dtype=np.int32)
    # A photograph has too many colours for a table of materials: a few levels of each are enough to look at.
    table, kinds = np.unique(corners // 16 * 16 + 8, axis=0, return_inverse=True)
    return [(r, g, b) for r, g, b in (table / 255.0).tolist()], kinds.reshape(-1).astype(np.int32)
