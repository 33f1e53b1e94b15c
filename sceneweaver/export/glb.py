"""Scenes as glTF 2.0 binary: one node for each object, named by its id.

glTF is y up; one root node turns the scene, so that everything below it is in metres and z up, as in scene.json.
An object's node carries its pose, its mesh is in the object's own frame with a primitive for each material: whoever
loads the file finds each body whole under its name. Materials of one texture share its images and tint them.
"""

from __future__ import annotations

import json
import math
import os
import struct
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import uv_of
from sceneweaver.scene import Room, Scene, write_atomic

from .bodies import Body, Missing, bodies_of
from .corners import Surface, surfaces
from .images import images, tinted
from .models import with_mesh
from .room import floor_mesh, wall_mesh

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_LINEAR, _MIPMAPS, _REPEAT = 9729, 9987, 10497
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


def glb_bytes(scene: Scene, load: Load | None = None, missing: Missing = "error", *, textures: bool = True) -> bytes:
    """A scene as glTF 2.0 binary.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        missing: Whether an asset that cannot be loaded is an error, or its object is shown as its parts.
        textures: Whether materials have their maps, or are plain: a fraction of the size.

    Raises:
        InputError: when an asset cannot be loaded or has no mesh, and ``missing`` is "error".
    """
    found = bodies_of(scene, with_mesh(load), missing)
    file = _File(textures)
    ids = set(scene.ids)
    children = [
        file.node(_free(name, ids), {"mesh": file.mesh(f"\0{name}", mesh, name)})
        for name, mesh in room_meshes(scene.room).items()
    ]
    children += [file.node(b.object.id, _placed(b, file.mesh(b.key, b.mesh))) for b in found]
    top = file.node(_free("scene", ids), {"rotation": _Y_UP, "children": children})
    extras = {"prompt": scene.prompt, "room": scene.room.model_dump(mode="json")}
    return file.bytes(top, {"name": scene.id, "extras": extras})


def model_bytes(mesh: Mesh, name: str) -> bytes:
    """One mesh as glTF 2.0 binary: a single node without a transform, so that its vertices are the model's frame.

    Args:
        mesh: In the frame of an object: z up, front +x, left +y. In the file it is y up with the front along +z, as
            glTF has it: a vertex (x, y, z) stands there as (y, z, x).
        name: Of the node and the mesh.
    """
    file = _File()
    turned = replace(mesh, vertices=mesh.vertices[:, [1, 2, 0]], uv=uv_of(mesh))
    return file.bytes(file.node(name, {"mesh": file.mesh(name, turned)}), {"name": name})


def room_meshes(room: Room) -> dict[str, Mesh]:
    """Floor and walls by the name of their node: ``room:floor``, ``room:wall:0`` ..."""
    meshes = {"room:floor": floor_mesh(room)}
    for k in range(len(room.outline)):
        meshes[f"room:wall:{k}"] = wall_mesh(room, k)
    return {name: mesh for name, mesh in meshes.items() if len(mesh.faces)}  # a wall may be all opening


def _free(name: str, ids: set[str]) -> str:
    """The name, or a longer one when an object has it: objects keep theirs."""
    while name in ids:
        name += " (room)"
    return name


def linear(color: Sequence[float]) -> list[float]:
    """Linear light of an sRGB colour."""
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 6) for c in color]


def _placed(body: Body, mesh: int) -> dict[str, Any]:
    """The node of an object, without its name: mesh, pose and what else is known of it."""
    thing = body.object
    extras: dict[str, Any] = {"category": thing.category, "mount": thing.mount, "size": list(thing.size)}
    if thing.asset is not None:
        extras["asset"] = thing.asset
    if thing.support is not None:
        extras["support"] = {"object": thing.support.object, "surface": thing.support.surface}
    if body.note:
        extras["note"] = body.note
    node: dict[str, Any] = {
        "mesh": mesh,
        "translation": list(thing.pose.position),
        "rotation": list(thing.pose.quaternion),
        "extras": extras,
    }
    if body.scale != (1.0, 1.0, 1.0):
        node["scale"] = list(body.scale)
    return node


class _File:
    """A glTF document while it grows: its JSON lists and its one buffer."""

    def __init__(self, textured: bool = True):
        self._textured = textured
        self._json: dict[str, list[Any]] = {name: [] for name in ("nodes", "meshes", "accessors", "bufferViews")}
        self._data = bytearray()
        self._meshes: dict[str, int] = {}
        self._materials: dict[Material, int] = {}
        self._made: list[dict[str, Any]] = []
        self._textures: dict[str, dict[str, dict[str, int]]] = {}
        self._images: list[dict[str, Any]] = []

    def node(self, name: str, node: dict[str, Any]) -> int:
        """Add a node; returns its number, as all of these do."""
        self._json["nodes"].append({"name": name, **node})
        return len(self._json["nodes"]) - 1

    def mesh(self, key: str, mesh: Mesh, name: str = "") -> int:
        """Add a mesh, unless one of this key is there."""
        if key not in self._meshes:
            self._meshes[key] = len(self._json["meshes"])
            primitives = [self._primitive(surface) for surface in surfaces(mesh, not self._textured)]
            self._json["meshes"].append({"name": name or key, "primitives": primitives})
        return self._meshes[key]

    def bytes(self, root: int, scene: dict[str, Any]) -> bytes:
        """The finished file."""
        document: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "sceneweaver"},
            "scene": 0,
            "scenes": [{**scene, "nodes": [root]}],
            **self._json,
            "materials": self._made,
        }
        if self._images:
            document["images"] = self._images
            document["textures"] = [{"source": k, "sampler": 0} for k in range(len(self._images))]
            document["samplers"] = [{"magFilter": _LINEAR, "minFilter": _MIPMAPS, "wrapS": _REPEAT, "wrapT": _REPEAT}]
        document["buffers"] = [{"byteLength": len(self._data)}]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self._data) + b"\0" * (-len(self._data) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data))
        return head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data

    def _primitive(self, surface: Surface) -> dict[str, Any]:
        material = self._material(surface.material)
        vectors = {"POSITION": (surface.points, "VEC3"), "NORMAL": (surface.normals, "VEC3")}
        if surface.uv is not None:
            vectors["TEXCOORD_0"] = (surface.uv * (1.0, -1.0) + (0.0, 1.0), "VEC2")  # here v grows downward
            if "normalTexture" in self._made[material] and surface.tangents is not None:
                vectors["TANGENT"] = (surface.tangents, "VEC4")
        attributes = {
            name: self._accessor(values.astype("<f4"), kind, _FLOAT, _VERTICES, bounds=name == "POSITION")
            for name, (values, kind) in vectors.items()
        }
        wide = len(surface.points) > 0xFFFF  # 0xFFFF itself is the mark for a restart, and no index
        order = surface.faces.reshape(-1).astype("<u4" if wide else "<u2")
        indices = self._accessor(order, "SCALAR", _INT if wide else _SHORT, _INDICES)
        return {"attributes": attributes, "indices": indices, "material": material, "mode": 4}

    def _accessor(self, values: np.ndarray, kind: str, component: int, target: int, bounds: bool = False) -> int:
        view = self._view(values.tobytes(), {"target": target})
        accessor: dict[str, Any] = {"bufferView": view, "componentType": component, "count": len(values), "type": kind}
        if bounds:
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self._json["accessors"].append(accessor)
        return len(self._json["accessors"]) - 1

    def _view(self, data: bytes, more: dict[str, Any]) -> int:
        self._data += b"\0" * (-len(self._data) % 4)
        self._json["bufferViews"].append({"buffer": 0, "byteOffset": len(self._data), "byteLength": len(data), **more})
        self._data += data
        return len(self._json["bufferViews"]) - 1

    def _material(self, material: Material) -> int:
        """The glTF material of a finish: numbers, and the images of its texture that they are multiplied with."""
        if material in self._materials:
            return self._materials[material]
        base, roughness = linear(material.color), material.roughness
        found = self._maps(material.texture) if self._textured else {}
        if found:
            base, roughness = tinted(material, base)
        surface: dict[str, Any] = {
            "baseColorFactor": [*base, material.opacity],
            "metallicFactor": material.metallic,
            "roughnessFactor": roughness if "metallicRoughnessTexture" in found else material.roughness,
        }
        surface |= {name: found[name] for name in found if name != "normalTexture"}
        made: dict[str, Any] = {"name": material.name, "pbrMetallicRoughness": surface}
        if "normalTexture" in found:
            made["normalTexture"] = found["normalTexture"]
        if material.opacity < 1:
            made["alphaMode"] = "BLEND"
            made["doubleSided"] = True
        if material.emission > 0:
            made["emissiveFactor"] = [round(min(1.0, c * material.emission), 6) for c in linear(material.color)]
        if material.texture != "plain":
            made["extras"] = {key: getattr(material, key) for key in ("texture", "color", "roughness")}
        self._materials[material] = len(self._made)
        self._made.append(made)
        return self._materials[material]

    def _maps(self, texture: str) -> dict[str, dict[str, int]]:
        """References to the images of a texture, which are there once, by their place in a material."""
        if texture not in self._textures:
            files = images(texture)
            places = (
                {}
                if files is None
                else {
                    "baseColorTexture": files.color,
                    "metallicRoughnessTexture": files.rough,
                    "normalTexture": files.normal,
                }
            )
            self._textures[texture] = {
                place: self._image(f"{texture} {place.removesuffix('Texture')}", data)
                for place, data in places.items()
                if data is not None
            }
        return self._textures[texture]

    def _image(self, name: str, data: bytes) -> dict[str, int]:
        self._images.append({"name": name, "mimeType": "image/jpeg", "bufferView": self._view(data, {})})
        return {"index": len(self._images) - 1}
