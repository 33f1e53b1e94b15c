"""A glTF 2.0 binary file while it grows: nodes, meshes, materials and images, each once."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from sceneweaver.assets import Material, Mesh

from .corners import Surface, surfaces
from .images import images, linear, tinted

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_LINEAR, _MIPMAPS, _REPEAT = 9729, 9987, 10497


class GlbFile:
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
