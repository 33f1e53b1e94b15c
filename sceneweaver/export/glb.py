"""Scenes as glTF 2.0 binary: one node for each object, named by its id.

glTF is y up; one root node turns the scene, so that everything below it is in metres and z up, as in scene.json.
An object's node carries its pose, its mesh is in the object's own frame and one primitive: whoever loads the file
finds each body whole under its name. Where a body has several materials, they are cells of a palette texture.
"""

from __future__ import annotations

import io
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
from sceneweaver.scene import Room, Scene, write_atomic

from .bodies import Body, Missing, bodies_of
from .models import with_mesh
from .room import floor_mesh, wall_mesh

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_NEAREST, _CLAMP = 9728, 33071
_CELL, _COLUMNS = 4, 16  # pixels of a material in the palette, materials in a row
_Y_UP = [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]


def write_glb(scene: Scene, path: str | os.PathLike[str], load: Load | None = None, missing: Missing = "error") -> None:
    """Write a scene as GLB under a temporary name and rename it; for the arguments see ``glb_bytes``."""
    write_atomic(path, glb_bytes(scene, load, missing))


def glb_bytes(scene: Scene, load: Load | None = None, missing: Missing = "error") -> bytes:
    """A scene as glTF 2.0 binary.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        missing: Whether an asset that cannot be loaded is an error, or its object is shown as its parts.

    Raises:
        InputError: when an asset cannot be loaded or has no mesh, and ``missing`` is "error".
    """
    found = bodies_of(scene, with_mesh(load), missing)
    file = _File([material for body in found for material in body.mesh.materials])
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
    file = _File(mesh.materials)
    turned = replace(mesh, vertices=mesh.vertices[:, [1, 2, 0]])
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

    def __init__(self, materials: Sequence[Material]):
        self._json: dict[str, list[Any]] = {name: [] for name in ("nodes", "meshes", "accessors", "bufferViews")}
        self._data = bytearray()
        self._meshes: dict[str, int] = {}
        self._materials: list[dict[str, Any]] = []
        self._single: dict[Material, int] = {}
        self._cells = {m: k for k, m in enumerate(dict.fromkeys(materials))}
        self._palette: int | None = None
        self._images: list[dict[str, Any]] = []
        self._extensions: set[str] = set()

    def node(self, name: str, node: dict[str, Any]) -> int:
        """Add a node; returns its number, as all of these do."""
        self._json["nodes"].append({"name": name, **node})
        return len(self._json["nodes"]) - 1

    def mesh(self, key: str, mesh: Mesh, name: str = "") -> int:
        """Add a mesh, unless one of this key is there."""
        if key not in self._meshes:
            self._meshes[key] = len(self._json["meshes"])
            self._json["meshes"].append({"name": name or key, "primitives": [self._primitive(mesh)]})
        return self._meshes[key]

    def bytes(self, root: int, scene: dict[str, Any]) -> bytes:
        """The finished file."""
        document: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "sceneweaver"},
            "scene": 0,
            "scenes": [{**scene, "nodes": [root]}],
            **self._json,
            "materials": self._materials,
        }
        if self._images:
            document["images"] = self._images
            document["textures"] = [{"source": k, "sampler": 0} for k in range(len(self._images))]
            document["samplers"] = [{"magFilter": _NEAREST, "minFilter": _NEAREST, "wrapS": _CLAMP, "wrapT": _CLAMP}]
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        document["buffers"] = [{"byteLength": len(self._data)}]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self._data) + b"\0" * (-len(self._data) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data))
        return head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data

    def _primitive(self, mesh: Mesh) -> dict[str, Any]:
        faces, used = mesh.faces, np.unique(mesh.face_material)
        attributes: dict[str, int] = {}
        if len(used) == 1:
            material = self._factors(mesh.materials[int(used[0])])
            kept, packed = np.unique(faces, return_inverse=True)
        else:
            # A vertex between two materials is there twice, once for each cell of the palette.
            material = self._textured()
            corners = faces.astype(np.int64) * len(mesh.materials) + mesh.face_material[:, None]
            pairs, packed = np.unique(corners, return_inverse=True)
            kept = pairs // len(mesh.materials)
            cell = np.array([self._cells[m] for m in mesh.materials])[pairs % len(mesh.materials)]
            rows = self._rows
            places = np.stack([(cell % _COLUMNS + 0.5) / _COLUMNS, (cell // _COLUMNS + 0.5) / rows], 1)
            attributes["TEXCOORD_0"] = self._accessor(places.astype("<f4"), "VEC2", _FLOAT, _VERTICES)
        points = mesh.vertices[kept].astype("<f4")
        attributes["POSITION"] = self._accessor(points, "VEC3", _FLOAT, _VERTICES, bounds=True)
        wide = len(kept) > 0xFFFF  # 0xFFFF itself is the mark for a restart, and no index
        order = packed.reshape(-1).astype("<u4" if wide else "<u2")
        indices = self._accessor(order, "SCALAR", _INT if wide else _SHORT, _INDICES)
        return {"attributes": attributes, "indices": indices, "material": material, "mode": 4}

    @property
    def _rows(self) -> int:
        """Rows of the palette: a power of two, as the sides of textures should be."""
        return 1 << (max(1, -(-len(self._cells) // _COLUMNS)) - 1).bit_length()

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

    def _factors(self, material: Material) -> int:
        """The glTF material of a body that is of one material."""
        if material not in self._single:
            base = linear(material.color)
            made: dict[str, Any] = {
                "name": material.name,
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*base, material.opacity],
                    "metallicFactor": material.metallic,
                    "roughnessFactor": material.roughness,
                },
            }
            if material.opacity < 1:
                made["alphaMode"] = "BLEND"
                made["doubleSided"] = True
            if material.emission > 0:
                made["emissiveFactor"] = [round(min(1.0, c * material.emission), 6) for c in base]
            self._single[material] = len(self._materials)
            self._materials.append(made)
        return self._single[material]

    def _textured(self) -> int:
        """The glTF material of all bodies that are of several materials: its numbers stand in textures."""
        if self._palette is not None:
            return self._palette
        made: dict[str, Any] = {
            "name": "palette",
            "pbrMetallicRoughness": {
                "baseColorTexture": self._image("color", [(*m.color, 1.0) for m in self._cells]),
                "metallicRoughnessTexture": self._image(
                    "roughness and metal", [(1.0, m.roughness, m.metallic, 1.0) for m in self._cells]
                ),
            },
        }
        if any(m.emission > 0 for m in self._cells):
            # Emission is kept in sRGB, so the share of light is taken in linear numbers and turned back.
            shine = [tuple(_srgb(c * min(1.0, m.emission)) for c in linear(m.color)) for m in self._cells]
            made["emissiveTexture"] = self._image("emission", [(*s, 1.0) for s in shine])
            made["emissiveFactor"] = [1.0, 1.0, 1.0]
        if any(m.opacity < 1 for m in self._cells):
            # Blending would apply to the whole body and spoil its depth; light let through is told for each texel.
            through = self._image("transmission", [(1 - m.opacity, 0.0, 0.0, 1.0) for m in self._cells])
            made["extensions"] = {
                "KHR_materials_transmission": {"transmissionFactor": 1.0, "transmissionTexture": through}
            }
            self._extensions.add("KHR_materials_transmission")
        self._palette = len(self._materials)
        self._materials.append(made)
        return self._palette

    def _image(self, name: str, cells: Sequence[tuple[float, ...]]) -> dict[str, int]:
        """A texture with one cell of equal pixels for each of the values [4] in 0..1; returns its reference."""
        from PIL import Image

        values = np.zeros((self._rows * _COLUMNS, 4), dtype=np.uint8)
        values[: len(cells)] = np.round(np.clip(np.asarray(cells), 0, 1) * 255)
        grid = values.reshape(self._rows, _COLUMNS, 4)[:, :, :3]
        picture = io.BytesIO()
        Image.fromarray(np.ascontiguousarray(grid.repeat(_CELL, 0).repeat(_CELL, 1))).save(picture, "PNG")
        self._images.append({"name": name, "mimeType": "image/png", "bufferView": self._view(picture.getvalue(), {})})
        return {"index": len(self._images) - 1}


def _srgb(value: float) -> float:
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
