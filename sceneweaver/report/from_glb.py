"""A GLB file as a scene to look at: every node with a mesh is an object. What is no geometry is not read."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, Material, Mesh
from sceneweaver.assets.asset import Origin
from sceneweaver.export.bodies import Load
from sceneweaver.scene import InputError, Pose, Room, Scene, SceneObject

_GREY = Material("grey", (0.75, 0.74, 0.72))
_Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)


def read_glb(path: str | os.PathLike[str]) -> tuple[Scene, Load]:
    """The scene of a y-up GLB file in metres, and the loader of its meshes; walls named ``room:`` are left out.

    Raises:
        InputError: when the file cannot be read or shows nothing.
    """
    import trimesh

    name = Path(path)
    try:
        found: Any = trimesh.load(str(name), file_type="glb", force="scene")
        nodes = list(found.graph.nodes_geometry)
        placed = [(node, *found.graph[node]) for node in nodes if not str(node).startswith("room:")]
    except Exception as error:  # a broken file fails in many ways inside the reader
        raise InputError(f"{name}: is no GLB file that can be read ({type(error).__name__}); export it anew") from None
    objects: list[SceneObject] = []
    assets: dict[str, Asset] = {}
    corners: list[np.ndarray] = []
    for node, matrix, geometry in placed:
        shape = found.geometry[geometry]
        if not isinstance(shape, trimesh.Trimesh) or not len(shape.faces):
            continue
        world = trimesh.transform_points(shape.vertices, _Z_UP @ matrix)
        low, high = world.min(axis=0), world.max(axis=0)
        base = np.array([*(low + high)[:2] / 2, low[2]])
        if not np.isfinite(world).all():
            raise InputError(f"{name}: node '{node}' has numbers that are not finite; export it anew")
        id = f"{node}".strip() or f"node {len(objects)}"
        size = np.maximum(high - low, 1e-3)
        asset = f"{len(assets)}"
        assets[asset] = _asset(asset, id, world - base, shape)
        x, y, z = (float(v) for v in base)
        d, w, h = (float(v) for v in size)
        category = str((shape.metadata or {}).get("category") or "mesh")
        objects.append(
            SceneObject(id=id, category=category, size=(d, w, h), pose=Pose(position=(x, y, z)), asset=asset)
        )
        corners += [low, high]
    if not objects:
        raise InputError(f"{name}: shows no mesh; export it anew")
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    x0, y0, x1, y1 = (float(v) for v in (low[0] - 0.2, low[1] - 0.2, high[0] + 0.2, high[1] + 0.2))
    room = Room(outline=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), height=max(0.5, float(high[2]) + 0.05))
    return Scene(id=name.stem, room=room, objects=tuple(objects)), assets.__getitem__


def _asset(id: str, category: str, vertices: np.ndarray, shape: Any) -> Asset:
    faces = np.asarray(shape.faces, dtype=np.int32)
    colors, kinds = _colors(shape, faces)
    materials = tuple(Material(f"color {k}", (r, g, b)) for k, (r, g, b) in enumerate(colors)) or (_GREY,)
    mesh = Mesh(np.asarray(vertices), faces, kinds, np.zeros_like(kinds), materials)
    return Asset(
        id=id, category=category, mesh=mesh, hulls=(), parts=(), mount="floor", mass=1.0, friction=0.5,
        origin=Origin("glb", "unknown"),
    )  # fmt: skip


def _colors(shape: Any, faces: np.ndarray) -> tuple[list[tuple[float, float, float]], np.ndarray]:
    """The sRGB colours of a mesh and which one each face has, textures read at the face's first corner."""
    try:
        corners = np.asarray(shape.visual.to_color().vertex_colors)[faces[:, 0], :3]
    except Exception:  # no colour, or one that trimesh cannot work out
        return [], np.zeros(len(faces), dtype=np.int32)
    table, kinds = np.unique(corners // 8 * 8 + 4, axis=0, return_inverse=True)
    return [tuple(row) for row in (table / 255.0).tolist()], kinds.reshape(-1).astype(np.int32)
