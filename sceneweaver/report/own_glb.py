"""Meshes of a GLB file that this library wrote, with the materials that they had."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.textures import maps
from sceneweaver.scene import InputError

_KINDS = {5123: np.dtype("<u2"), 5125: np.dtype("<u4"), 5126: np.dtype("<f4")}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class OwnFile:
    """A GLB file of ours: its document, and its meshes by number."""

    def __init__(self, data: bytes):
        length = struct.unpack_from("<I", data, 12)[0]
        self.document: dict[str, Any] = json.loads(data[20 : 20 + length])
        self._binary = data[28 + length :]

    def mesh(self, number: int) -> Mesh:
        """A mesh with the materials of its primitives, in the frame of its node, texture coordinates in metres."""
        points, faces, kinds, uv, materials = [], [], [], [], []
        count = 0
        for primitive in self.document["meshes"][number]["primitives"]:
            attributes = primitive["attributes"]
            vertices = self._values(attributes["POSITION"])
            order = self._values(primitive["indices"]).reshape(-1, 3).astype(np.int32)
            material = self._material(primitive["material"])
            found = maps(material.texture)
            own = np.zeros((len(vertices), 2))
            if found is not None and "TEXCOORD_0" in attributes:
                own = (self._values(attributes["TEXCOORD_0"]) * (1.0, -1.0) + (0.0, 1.0)) * found.size
            points.append(vertices)
            faces.append(order + count)
            kinds.append(np.full(len(order), len(materials), dtype=np.int32))
            uv.append(own[order].astype(np.float32))
            materials.append(material)
            count += len(vertices)
        which = np.concatenate(kinds)
        every = np.concatenate(points).astype(float)
        return Mesh(every, np.concatenate(faces), which, np.zeros_like(which), tuple(materials), np.concatenate(uv))

    def below(self, node: dict[str, Any]) -> list[dict[str, Any]]:
        """The nodes below one."""
        return [self.document["nodes"][k] for k in node.get("children", ())]

    def _values(self, number: int) -> np.ndarray:
        accessor = self.document["accessors"][number]
        view = self.document["bufferViews"][accessor["bufferView"]]
        width = _WIDTH[accessor["type"]]
        kind = _KINDS[accessor["componentType"]]
        values = np.frombuffer(self._binary, kind, accessor["count"] * width, view["byteOffset"])
        return values.reshape(-1, width) if width > 1 else values

    def _material(self, number: int) -> Material:
        row = self.document["materials"][number]
        surface, more = row["pbrMetallicRoughness"], row.get("extras", {})
        base = surface["baseColorFactor"]
        r, g, b = more.get("color") or [_srgb(c) for c in base[:3]]
        glow = max(row.get("emissiveFactor", (0.0,))) / max(*base[:3], 1e-6)
        texture = more.get("texture", "plain")
        try:
            maps(texture)
        except InputError:  # a folder of another user
            texture = "plain"
        return Material(
            row["name"],
            (r, g, b),
            more.get("roughness", surface["roughnessFactor"]),
            surface["metallicFactor"],
            base[3],
            min(1.0, glow),
            texture,
        )


def _srgb(value: float) -> float:
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
