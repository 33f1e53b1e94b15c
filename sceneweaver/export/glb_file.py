"""A glTF 2.0 binary file while it grows: nodes, meshes, materials and images, each once."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Hashable, Sequence
from typing import Any

from sceneweaver.assets import Asset, Material, Mesh
from sceneweaver.runtime.deadline import checkpoint

from .glb_mesh import PackedMesh, layout, packed
from .images import images, linear, tinted
from .shared import SharedFiles

_LINEAR, _MIPMAPS, _REPEAT = 9729, 9987, 10497


class GlbFile:
    """A glTF document while it grows: its JSON lists and its own buffer.

    Args:
        textured: Whether materials have their maps.
        shared: Where images and the meshes of objects go; None: into the file.
    """

    def __init__(self, textured: bool = True, shared: SharedFiles | None = None):
        self._textured, self._shared = textured, shared
        self._json: dict[str, list[Any]] = {name: [] for name in ("nodes", "meshes", "accessors", "bufferViews")}
        self._data = bytearray()
        self._meshes: dict[str, int] = {}
        self._materials: dict[Material, int] = {}
        self._made: list[dict[str, Any]] = []
        self._textures: dict[str, dict[str, dict[str, int]]] = {}
        self._images: list[dict[str, Any]] = []
        self._buffers: list[dict[str, Any]] = []
        self._paths: dict[str, int] = {}

    def node(self, name: str, node: dict[str, Any]) -> int:
        """Add a node; returns its number, as all of these do."""
        self._json["nodes"].append({"name": name, **node})
        return len(self._json["nodes"]) - 1

    def mesh(
        self, key: str, make: Callable[[], Mesh], name: str = "", asset: Asset | None = None, part: Hashable = None
    ) -> int:
        """Add a mesh, unless one of this key is there.

        Args:
            key: Equal for equal meshes.
            make: Gives the mesh when it is needed.
            name: Its name; the key where it has none.
            asset: What it is of, if others may have it: its data go to the shared files, where there are some.
            part: Which part of the asset, in which size; its materials are those of the asset.
        """
        checkpoint()
        if key not in self._meshes:
            if self._shared is None or asset is None:
                mesh = make()
                materials, found = mesh.materials, packed(mesh, self._textured)
                buffer, start = 0, self._append(found.data)
            else:
                materials = asset.mesh.materials
                shape = ("y up", asset.geometry, part, layout(asset.mesh, self._textured))
                found, path = self._shared.mesh(asset.id, shape, lambda: packed(make(), self._textured))
                length = max(view["byteOffset"] + view["byteLength"] for view in found.views)
                buffer, start = self._buffer(path, length), 0
            self._meshes[key] = len(self._json["meshes"])
            primitives = self._primitives(found, materials, buffer, start)
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
        document["buffers"] = [{"byteLength": len(self._data)}, *self._buffers]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self._data) + b"\0" * (-len(self._data) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data))
        return head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data

    def _primitives(
        self, mesh: PackedMesh, materials: Sequence[Material], buffer: int, start: int
    ) -> list[dict[str, Any]]:
        """The primitives of a mesh of those materials whose data begin at an offset of a buffer."""
        views, accessors = self._json["bufferViews"], self._json["accessors"]
        view, first = len(views), len(accessors)
        views += [{"buffer": buffer, **v, "byteOffset": start + v["byteOffset"]} for v in mesh.views]
        accessors += [{"bufferView": view + k, **accessor} for k, accessor in enumerate(mesh.accessors)]
        return [
            {
                "attributes": {name: first + k for name, k in primitive.attributes.items()},
                "indices": first + primitive.indices,
                "material": self._material(materials[primitive.material]),
                "mode": 4,
            }
            for primitive in mesh.primitives
        ]

    def _append(self, data: bytes) -> int:
        """Add to the buffer of the file itself; returns where that begins."""
        self._data += b"\0" * (-len(self._data) % 4)
        self._data += data
        return len(self._data) - len(data)

    def _buffer(self, path: str, length: int) -> int:
        """The number of the buffer that is a shared file."""
        if path not in self._paths:
            self._paths[path] = len(self._buffers) + 1  # the file's own is the first
            self._buffers.append({"uri": path, "byteLength": length})
        return self._paths[path]

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
            found = (None, None, None) if files is None else (files.color, files.rough, files.normal)
            self._textures[texture] = {
                f"{place}Texture": self._image(f"{texture} {place}", data)
                for place, data in zip(("baseColor", "metallicRoughness", "normal"), found, strict=True)
                if data is not None
            }
        return self._textures[texture]

    def _image(self, name: str, data: bytes) -> dict[str, int]:
        image: dict[str, Any] = {"name": name, "mimeType": "image/jpeg"}
        if self._shared is not None:
            image["uri"] = self._shared.path(name, "jpg", lambda: data)
        else:
            image["bufferView"] = len(self._json["bufferViews"])
            start = self._append(data)
            self._json["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": len(data)})
        self._images.append(image)
        return {"index": len(self._images) - 1}
