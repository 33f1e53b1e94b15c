"""A GLB file as a scene to look at. Of our own files room and objects come back as they were; of others, every node
with a mesh is an object, in a room around them."""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, Hull, Link, Material, Mesh
from sceneweaver.assets.asset import Origin
from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import maps
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.io import parse_json, read_bytes, read_meshes
from sceneweaver.io.meshes import MAX_BYTES
from sceneweaver.scene import InputError, MissingDependencyError, Pose, Room, Scene, SceneObject

_GREY = Material("grey", (0.75, 0.74, 0.72))
_Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)


def read_glb(path: str | os.PathLike[str]) -> tuple[Scene, Load]:
    """The scene of a y-up GLB file in metres, and the loader of its meshes.

    Raises:
        InputError: when the file cannot be read or shows nothing.
    """
    name = Path(path)
    try:
        data = read_bytes(name, max_bytes=MAX_BYTES)
        found: Any = read_meshes(name)  # looks whether all that the document describes is in the file
        own = OwnFile(data)
        ours = own.document.get("asset", {}).get("generator") == "sceneweaver"
        bodies = list(_own_bodies(own) if ours else ((*body, ()) for body in _other_bodies(found)))
    except (InputError, MissingDependencyError):
        raise
    except Exception as error:  # a broken file fails in many ways inside the reader
        raise InputError(f"{name}: is no GLB file that can be read ({type(error).__name__}); export it anew") from None
    objects: list[SceneObject] = []
    assets: dict[str, Asset] = {}
    corners: list[np.ndarray] = []
    for thing, mesh, links in bodies:
        if not np.isfinite(mesh.vertices).all():
            raise InputError(f"{name}: node '{thing.id}' has numbers that are not finite; export it anew")
        corners += list(mesh.bounds + np.asarray(thing.pose.position))
        asset = f"{len(assets)}"
        objects.append(thing.model_copy(update={"asset": asset}))
        assets[asset] = _asset(asset, thing.category, mesh, links)
    if not objects:
        raise InputError(f"{name}: shows no mesh; export it anew")
    scene = own.document["scenes"][0] if ours else {}
    extras = scene.get("extras") or {}
    room = Room.model_validate(extras["room"]) if "room" in extras else _around(corners)
    return (
        Scene(id=scene.get("name") or name.stem, prompt=extras.get("prompt", ""), room=room, objects=tuple(objects)),
        assets.__getitem__,
    )


def _own_bodies(own: OwnFile) -> Iterator[tuple[SceneObject, Mesh, tuple[Link, ...]]]:
    """The objects of a file that we wrote, their meshes in their frames and what of these moves."""
    for node in own.document["nodes"]:
        extras = node.get("extras", {})
        if "category" not in extras:
            continue  # floor and walls
        mount = extras.get("mount", "floor")
        thing = SceneObject(
            id=node["name"],
            category=extras["category"],
            size=tuple(extras["size"]),
            pose=Pose(position=own.vector(node["translation"]), quaternion=own.rotation(node["rotation"])),
            mount="floor" if mount == "surface" else mount,
        )
        mesh = _whole(own, node)
        scale = np.abs(own.vector(node.get("scale", (1.0, 1.0, 1.0))))
        yield thing, replace(mesh, vertices=mesh.vertices * scale), tuple(own.links(node))


def _whole(own: OwnFile, node: dict[str, Any]) -> Mesh:
    """The mesh of an object with those of its doors, drawers and things to take, all as they are in the file; faces
    say which of the nodes below they are of, from 1."""
    nodes = [(node, np.zeros(3))]
    nodes += [(below, np.asarray(own.vector(below["translation"]))) for below in own.below(node)]
    numbers = [number for number, (one, _) in enumerate(nodes) if "mesh" in one]
    meshes = [(own.mesh(nodes[number][0]["mesh"]), nodes[number][1]) for number in numbers]
    points = np.concatenate([mesh.vertices + off for mesh, off in meshes])
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh, _ in meshes)])
    kinds = np.cumsum([0, *(len(mesh.materials) for mesh, _ in meshes)])
    return Mesh(
        points,
        np.concatenate([mesh.faces + start for (mesh, _), start in zip(meshes, starts, strict=False)]),
        np.concatenate([mesh.face_material + kind for (mesh, _), kind in zip(meshes, kinds, strict=False)]),
        np.repeat(np.asarray(numbers, dtype=np.int32), [len(mesh.faces) for mesh, _ in meshes]),
        tuple(material for mesh, _ in meshes for material in mesh.materials),
        np.concatenate([mesh.uv for mesh, _ in meshes if mesh.uv is not None]),
    )


def _other_bodies(found: Any) -> Iterator[tuple[SceneObject, Mesh]]:
    """The nodes of anybody's file as objects that are not turned, and their meshes in their frames."""
    import trimesh

    for node in found.graph.nodes_geometry:
        matrix, geometry = found.graph[node]
        shape = found.geometry[geometry]
        if not isinstance(shape, trimesh.Trimesh) or not len(shape.faces):
            continue
        world = trimesh.transform_points(shape.vertices, _Z_UP @ matrix)
        if not np.isfinite(world).all():
            raise InputError(f"node '{node}' has numbers that are not finite; export it anew")
        yield _others(str(node), world, shape)


def _others(object_id: str, world: np.ndarray, shape: Any) -> tuple[SceneObject, Mesh]:
    low, high = world.min(axis=0), world.max(axis=0)
    base = np.array([*(low + high)[:2] / 2, low[2]])
    x, y, z = base.tolist()
    d, w, h = np.maximum(high - low, 1e-3).tolist()
    clean = " ".join("".join(c if c.isprintable() else " " for c in object_id).split()) or "node"
    clean = clean.replace("wall:", "wall ")
    faces = np.asarray(shape.faces, dtype=np.int32)
    colors, kinds = _colors(shape, faces)
    materials = tuple(Material(f"color {k}", (r, g, b)) for k, (r, g, b) in enumerate(colors)) or (_GREY,)
    mesh = Mesh(world - base, faces, kinds, np.zeros_like(kinds), materials)
    return SceneObject(id=clean, category="mesh", size=(d, w, h), pose=Pose(position=(x, y, z))), mesh


def _around(corners: list[np.ndarray]) -> Room:
    """A room a little larger than what is in it."""
    low, high = np.min(corners, axis=0) - 0.2, np.max(corners, axis=0) + 0.2
    (x0, y0, _), (x1, y1, z1) = low.tolist(), high.tolist()
    return Room(outline=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), height=max(0.5, z1))


def _asset(object_id: str, category: str, mesh: Mesh, links: Sequence[Link] = ()) -> Asset:
    """An asset to look at; boxes stand for the collision parts of what moves, as the file has none."""
    boxes = tuple(_box(mesh, number) for number in np.unique(mesh.face_link).tolist()) if links else ()
    return Asset(
        id=object_id,
        category=category,
        mesh=mesh,
        hulls=boxes,
        parts=(),
        mount="floor",
        mass=1.0,
        friction=0.5,
        origin=Origin("glb", "unknown"),
        links=tuple(links),
    )


def _box(mesh: Mesh, link: int) -> Hull:
    """What is around the faces of one link."""
    corners = mesh.vertices[mesh.faces[mesh.face_link == link]].reshape(-1, 3)
    (x0, y0, z0), (x1, y1, z1) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    return Hull(*prism_mesh(((x0, y0), (x1, y0), (x1, y1), (x0, y1)), (z0, z1)), link)


def _colors(shape: Any, faces: np.ndarray) -> tuple[list[tuple[float, float, float]], np.ndarray]:
    """The sRGB colours of a mesh and which one each face has, textures read at the face's first corner."""
    try:
        corners = np.asarray(shape.visual.to_color().vertex_colors)[faces[:, 0], :3]
    except Exception:  # no colour, or one that trimesh cannot work out
        return [], np.zeros(len(faces), dtype=np.int32)
    # A photograph has too many colours for a table of materials: a few levels of each are enough to look at.
    table, kinds = np.unique(corners // 16 * 16 + 8, axis=0, return_inverse=True)
    return [(r, g, b) for r, g, b in (table / 255.0).tolist()], kinds.reshape(-1).astype(np.int32)


_KINDS = {5123: np.dtype("<u2"), 5125: np.dtype("<u4"), 5126: np.dtype("<f4")}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class OwnFile:
    """A GLB file of ours: its document, and its meshes by number, all in frames that are z up.

    Files of older releases had such frames below a root node that turned them.
    """

    def __init__(self, data: bytes):
        length = struct.unpack_from("<I", data, 12)[0]
        self.document: dict[str, Any] = parse_json(data[20 : 20 + length])
        self._binary = data[28 + length :]
        roots = self.document["scenes"][0]["nodes"] if self.document.get("scenes") else []
        self._z_up = any("rotation" in self.document["nodes"][root] for root in roots)

    def vector(self, values: Sequence[float]) -> tuple[float, float, float]:
        """A vector [3] of a node in a frame that is z up."""
        x, y, z = (float(v) for v in values)
        return (x, y, z) if self._z_up else (x, -z, y)

    def rotation(self, values: Sequence[float]) -> tuple[float, float, float, float]:
        """A rotation (x, y, z, w) of a node in a frame that is z up."""
        x, y, z = self.vector(values[:3])
        return x, y, z, float(values[3])

    def mesh(self, number: int) -> Mesh:
        """A mesh with the materials of its primitives, in the frame of its node, texture coordinates in metres."""
        points, faces, kinds, uv, materials = [], [], [], [], []
        count = 0
        for primitive in self.document["meshes"][number]["primitives"]:
            attributes = primitive["attributes"]
            vertices = self._values(attributes["POSITION"])
            if not self._z_up:
                vertices = vertices[:, [0, 2, 1]] * (1.0, -1.0, 1.0)
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

    def links(self, node: dict[str, Any]) -> Iterator[Link]:
        """How each of the nodes below one moves in its frame."""
        for below in self.below(node):
            joint: dict[str, Any] = below.get("extras", {}).get("joint", {"type": "free"})
            name = below["name"].removeprefix(f"{node['name']}.")
            if joint["type"] == "free":
                yield Link(name, "free", role="item", category=joint.get("category", ""))
                continue
            axis = self.vector(joint["axis"])
            low, high = joint["limits"]
            yield Link(name, joint["type"], axis, self.vector(below["translation"]), (low, high), joint["role"])

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
