"""The scene packed for the 3D view: plain data, and all meshes in one deflated block.

Each mesh is there once: positions as three planes of uint16 within its box, then three planes of corner numbers
(uint16, or uint32 above 65536 vertices), faces in order of material; then, of the faces whose material has a texture,
u of all corners and v of all, uint16 in steps. Textures are small images. ``web/decode.js`` reads it.
"""

from __future__ import annotations

import base64
import math
import zlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import maps
from sceneweaver.export.bodies import bodies_of, moving_parts
from sceneweaver.export.corners import texture_coordinates
from sceneweaver.export.glb import room_meshes
from sceneweaver.export.images import has_relief, square
from sceneweaver.export.openings import door_leaves, opening_meshes
from sceneweaver.geometry.angles import heading
from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.geometry.walls import wall_behind
from sceneweaver.scene import Room, Scene, SceneObject

from .facts import RelationRow, ViolationRow, object_facts

_PIXELS = (512, 256)  # sides of the images of tints and of normals
_MOST = 64  # textures that the view takes
_FLAT = {"position": [0.0, 0.0, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0], "scale": [1.0, 1.0, 1.0]}


@dataclass(frozen=True)
class Packed:
    """The view's data for JSON, the meshes as base64, and what had to be done without."""

    data: dict[str, Any]
    meshes: str
    warnings: tuple[str, ...]


@dataclass
class Store:
    """Meshes and materials as they are collected, each once."""

    meshes: list[dict[str, Any]] = field(default_factory=list)
    materials: dict[Material, int] = field(default_factory=dict)
    known: dict[str, int] = field(default_factory=dict)
    textures: dict[str, int] = field(default_factory=dict)
    data: bytearray = field(default_factory=bytearray)

    def add(self, key: str, mesh: Mesh) -> int:
        """The number of a mesh, which is added when it is new."""
        if key in self.known:
            return self.known[key]
        order = np.argsort(mesh.face_material, kind="stable")
        used, packed = np.unique(mesh.faces[order], return_inverse=True)
        points = mesh.vertices[used]
        low, high = points.min(axis=0), points.max(axis=0)
        step = np.maximum((high - low) / 65535, 1e-12)
        corner = packed.reshape(-1, 3).T.astype("<u2" if len(used) <= 65536 else "<u4")
        kinds, counts = np.unique(mesh.face_material[order], return_counts=True)
        row = {
            "vertices": len(used),
            "faces": len(order),
            "low": low.tolist(),
            "high": high.tolist(),
            "step": step.tolist(),
            "offset": len(self.data),
            "runs": [
                [self.materials.setdefault(mesh.materials[int(k)], len(self.materials)), int(count)]
                for k, count in zip(kinds, counts, strict=True)
            ],
        }
        self.data += np.ascontiguousarray(np.round((points - low) / step).T).astype("<u2").tobytes()
        self.data += np.ascontiguousarray(corner).tobytes()
        laid = np.array([self.texture(m) > 0 for m in mesh.materials])[mesh.face_material[order]]
        if laid.any() and (places := texture_coordinates(mesh)) is not None:
            places = places[order][laid].reshape(-1, 2)
            places = places - np.floor(places.min(axis=0))
            steps = np.maximum(places.max(axis=0) / 65535, 1e-12)
            row["uv"] = {"offset": len(self.data), "faces": int(laid.sum()), "step": steps.tolist()}
            self.data += np.ascontiguousarray(np.round(places / steps).T).astype("<u2").tobytes()
        self.known[key] = len(self.meshes)
        self.meshes.append(row)
        return self.known[key]

    def texture(self, material: Material) -> int:
        """The number of a material's texture from 1 on; 0: it has none, or the view takes no more."""
        name = material.texture
        if maps(name) is None or (name not in self.textures and len(self.textures) >= _MOST):
            return 0
        return self.textures.setdefault(name, len(self.textures) + 1)


def pack(scene: Scene, rows: list[RelationRow], faults: list[ViolationRow], load: Load | None = None) -> Packed:
    """Pack a scene; objects whose asset cannot be loaded are shown as their parts."""
    store = Store()
    items = room_items(store, scene.room)
    found, notes = object_items(store, scene, load)
    data = {
        "room": room_box(scene.room),
        "walls": room_walls(scene.room),
        **stored(store),
        "items": [*items, *found],
        "objects": object_facts(scene, rows, faults),
        "yaw": best_side(scene),
    }
    return Packed(data, packed_meshes(store), notes)


def room_items(store: Store, room: Room, key: str = "") -> list[dict[str, Any]]:
    """Floor, walls, doors and windows of a room; ``key`` tells those of several rooms apart."""
    items: list[dict[str, Any]] = []
    for name, mesh in room_meshes(room).items():
        kind, wall = ("floor", None) if name == "room:floor" else ("wall", int(name.rpartition(":")[2]))
        items.append({"id": None, "kind": kind, "wall": wall, "mesh": store.add(f"\0{key}{name}", mesh), **_FLAT})
    for wall, name, mesh in opening_meshes(room):
        items.append({"id": None, "kind": "opening", "wall": wall, "mesh": store.add(f"\0{key}{name}", mesh), **_FLAT})
    for wall, leaf, mesh in door_leaves(room):
        item = {"id": leaf.door, "kind": "leaf", "wall": wall, "mesh": store.add(f"\0{key}{leaf.name}", mesh), **_FLAT}
        moves = {"name": leaf.door, "kind": leaf.joint, "axis": leaf.axis, "anchor": (0.0, 0.0, 0.0)}
        place = {"position": leaf.position, "quaternion": from_yaw(leaf.yaw)}
        items.append({**item, **place, "joint": {**moves, "limits": leaf.limits}})
    return items


def solid_item(store: Store, key: str, mesh: Mesh, kind: str, wall: int | None = None) -> dict[str, Any]:
    """A part of a building that stands still, in the world's frame."""
    return {"id": None, "kind": kind, "wall": wall, "mesh": store.add(f"\0{key}", mesh), **_FLAT}


def object_items(
    store: Store, scene: Scene, load: Load | None, prefix: str = ""
) -> tuple[list[dict[str, Any]], tuple[str, ...]]:
    """The objects of a scene, their ids after a prefix, and what had to be done without."""
    items: list[dict[str, Any]] = []
    bodies = bodies_of(scene, load, missing="parts")
    for body in bodies:
        thing = body.object
        item = {
            "id": prefix + thing.id,
            "kind": "object",
            "wall": _wall_of(scene.room, thing),
            "position": list(thing.pose.position),
            "quaternion": list(thing.pose.quaternion),
            "scale": list(body.scale),
        }
        rest, parts = moving_parts(body)
        if rest is not None:
            items.append({**item, "mesh": store.add(f"{body.key}.0" if parts else body.key, rest)})
        for part in parts:
            joint = {"name": part.name, "kind": part.kind, "axis": part.axis, "anchor": part.anchor}
            mesh = store.add(f"{body.key}.{part.number}", part.mesh)
            items.append({**item, "mesh": mesh, "joint": {**joint, "limits": part.limits}})
    return items, tuple(b.note for b in bodies if b.note)


def room_box(room: Room) -> dict[str, Any]:
    """What a room fills, for the camera."""
    outline = np.asarray(room.outline)
    return {"low": outline.min(axis=0).tolist(), "high": outline.max(axis=0).tolist(), "height": room.height}


def room_walls(room: Room) -> list[dict[str, Any]]:
    """The walls of a room, that sink where they stand before the camera."""
    return [{"point": list(wall.start), "outward": list(wall.outward)} for wall in room.walls]


def stored(store: Store) -> dict[str, Any]:
    """Materials, textures and meshes of a store, for JSON."""
    return {
        "materials": [_material(m, store.texture(m)) for m in store.materials],
        "textures": [_texture(name) for name in store.textures],
        "pixels": _PIXELS,
        "meshes": store.meshes,
    }


def packed_meshes(store: Store) -> str:
    """All meshes of a store as base64 of one deflated block."""
    return base64.b64encode(zlib.compress(bytes(store.data), 9)).decode()


def _texture(name: str) -> dict[str, Any]:
    """A texture's images as data addresses, and the gain of its tint."""
    found = maps(name)
    assert found is not None
    tint, normal = square(found.tint, _PIXELS[0], 72), None
    if has_relief(found):
        normal = square(found.normal, _PIXELS[1], 75)
    urls = [data and "data:image/jpeg;base64," + base64.b64encode(data).decode() for data in (tint, normal)]
    return {"color": urls[0], "normal": urls[1], "gain": round(found.gain, 5)}


def _material(m: Material, texture: int) -> dict[str, Any]:
    return {
        "color": list(m.color),
        "roughness": m.roughness,
        "metallic": m.metallic,
        "opacity": m.opacity,
        "emission": m.emission,
        "texture": texture,
    }


def _wall_of(room: Room, thing: SceneObject) -> int | None:
    """The wall that a wall-mounted object hangs on."""
    return wall_behind(room.walls, thing.pose.position, thing.pose.frame.axis) if thing.mount == "wall" else None


def best_side(scene: Scene) -> float:
    """The yaw [rad] of the camera around the room's middle that shows most fronts and has least behind tall things."""
    x0, y0 = np.mean(np.asarray(scene.room.outline), axis=0)
    best = (-math.inf, 0.0)
    for k in (7, 5, 1, 3):  # the corners, the one at right front first
        yaw = k * math.pi / 4 + 0.12
        side = heading(yaw)
        score = 0.0
        for thing in scene.objects:
            d, w, h = thing.size
            dx, dy = thing.pose.position[0] - x0, thing.pose.position[1] - y0
            facing = float(np.dot(thing.pose.frame.axis, side))
            if thing.mount == "wall":
                score += 0.6 * w * h * facing
            elif thing.mount == "floor":
                score += w * h * (0.3 * facing - max(0.0, h - 0.9) * max(0.0, dx * side[0] + dy * side[1]))
        if score > best[0] + 1e-9:
            best = (score, yaw)
    return best[1]


__all__ = ["Packed", "pack"]
