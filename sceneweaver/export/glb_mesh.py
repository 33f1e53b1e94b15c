"""Meshes as glTF has them: arrays one after the other in a buffer, and what says how to read them."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sceneweaver.assets import Mesh

from .corners import Surface, laid_by, surfaces
from .images import images

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963


@dataclass(frozen=True)
class Primitive:
    """The part of a mesh that is of one material: the number of that in the mesh, those of its accessors, by attribute,
    and that of its indices."""

    material: int
    attributes: Mapping[str, int]
    indices: int


@dataclass(frozen=True)
class PackedMesh:
    """A mesh for a glTF file; numbers and offsets begin at 0.

    ``data`` are the arrays, ``views`` where each begins and how long it is [bytes] and its target, ``accessors`` what
    each holds, one for each view.
    """

    data: bytes
    views: tuple[dict[str, int], ...]
    accessors: tuple[dict[str, Any], ...]
    primitives: tuple[Primitive, ...]

    @property
    def nbytes(self) -> int:
        """About the memory that it takes."""
        return len(self.data) + 1024 * len(self.views)

    def without_data(self) -> PackedMesh:
        """What remains to be known of it when its data lie in a file."""
        return replace(self, data=b"")


def y_up(vectors: np.ndarray) -> np.ndarray:
    """Vectors [..., 3] of a frame that is z up in that of a glTF file, which is y up: (x, y, z) is (x, z, -y) there."""
    return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)


def packed(mesh: Mesh, textured: bool) -> PackedMesh:
    """A mesh of a z-up frame as glTF has it, y up, a primitive for each material; not ``textured``: without texture
    coordinates."""
    pack = _Pack([textured and _has_relief(material.texture) for material in mesh.materials])
    primitives = tuple(pack.primitive(surface) for surface in surfaces(mesh, not textured))
    return PackedMesh(bytes(pack.data), tuple(pack.views), tuple(pack.accessors), primitives)


def layout(mesh: Mesh, textured: bool) -> Hashable:
    """What of its materials `packed` follows from: how their maps lie, and which of them have normals."""
    if not textured:
        return None
    return laid_by(mesh), tuple(_has_relief(material.texture) for material in mesh.materials)


def _has_relief(texture: str) -> bool:
    files = images(texture)
    return files is not None and files.normal is not None


class _Pack:
    def __init__(self, relief: Sequence[bool]) -> None:
        self.relief = relief
        self.data = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def primitive(self, surface: Surface) -> Primitive:
        vectors = {"POSITION": (y_up(surface.points), "VEC3"), "NORMAL": (y_up(surface.normals), "VEC3")}
        if surface.uv is not None:
            vectors["TEXCOORD_0"] = (surface.uv * (1.0, -1.0) + (0.0, 1.0), "VEC2")  # here v grows downward
            if self.relief[surface.number] and surface.tangents is not None:
                along = y_up(surface.tangents[:, :3])
                vectors["TANGENT"] = (np.column_stack([along, surface.tangents[:, 3]]), "VEC4")
        attributes = {
            name: self._accessor(values.astype("<f4"), kind, _FLOAT, _VERTICES, bounds=name == "POSITION")
            for name, (values, kind) in vectors.items()
        }
        wide = len(surface.points) > 0xFFFF  # 0xFFFF itself is the mark for a restart, and no index
        order = surface.faces.reshape(-1).astype("<u4" if wide else "<u2")
        indices = self._accessor(order, "SCALAR", _INT if wide else _SHORT, _INDICES)
        return Primitive(surface.number, attributes, indices)

    def _accessor(self, values: np.ndarray, kind: str, component: int, target: int, bounds: bool = False) -> int:
        self.data += b"\0" * (-len(self.data) % 4)
        self.views.append({"byteOffset": len(self.data), "byteLength": values.nbytes, "target": target})
        self.data += values.tobytes()
        accessor: dict[str, Any] = {"componentType": component, "count": len(values), "type": kind}
        if bounds:
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1
