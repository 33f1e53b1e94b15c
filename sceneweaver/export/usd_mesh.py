"""What is seen and what collides as USD prims: render meshes with normals, convex hulls, boxes."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.geometry.hulls import hull_faces
from sceneweaver.physics.solids import Solid

from .corners import corner_normals, indexed, texture_coordinates
from .usd_engines import tune_collider
from .usd_layer import Prim, attribute, integers, pairs, prim, triple, vectors
from .usd_looks import Looks

_STEPS = 50_000  # of a normal's coordinate, within which two are equal
_WIDE = 2 * _STEPS + 2
_LEAST_AREA = 1e-12  # [m2], twice that of faces that are left out, as nothing of them is seen


def render_mesh(parent: Prim, name: str, mesh: Mesh, looks: Looks, link: int | None = None) -> None:
    """The faces of a mesh, or of one link of it; several materials are subsets of its faces. Without faces: no prim."""
    chosen = np.ones(len(mesh.faces), dtype=bool) if link is None else mesh.face_link == link
    corners = mesh.vertices[mesh.faces]
    chosen &= (np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) ** 2).sum(axis=1) > _LEAST_AREA**2
    faces, material = mesh.faces[chosen], mesh.face_material[chosen]
    if not len(faces):
        return
    kept, packed = np.unique(faces, return_inverse=True)
    faces, points = packed.reshape(-1, 3), mesh.vertices[kept]
    numbers = [int(n) for n in np.unique(material)]
    made = prim(parent, name, "Mesh")
    _shape(made, points, faces)
    normals, index = corner_normals(points, faces)
    _primvar(made, "normals", "Normal3fArray", vectors(normals), index)
    if looks.textured and (places := texture_coordinates(mesh)) is not None:
        values, index = indexed(places[chosen])
        _primvar(made, "st", "TexCoord2fArray", pairs(values), index)
    if any(mesh.materials[n].opacity < 1 for n in numbers):
        attribute(made, "doubleSided", "Bool", True, uniform=True)
    if len(numbers) == 1:
        looks.dress(made, mesh.materials[numbers[0]])
        return
    attribute(made, "subsetFamily:materialBind:familyType", "Token", "partition", uniform=True)
    for number in numbers:
        subset = prim(made, f"material_{number}", "GeomSubset")
        attribute(subset, "elementType", "Token", "face", uniform=True)
        attribute(subset, "familyName", "Token", "materialBind", uniform=True)
        attribute(subset, "indices", "IntArray", integers(np.flatnonzero(material == number)))
        looks.dress(subset, mesh.materials[number])


def collider(parent: Prim, name: str, solid: Solid, looks: Looks, friction: float) -> None:
    """A convex part: a cube for a box along the axes, else a mesh of which the simulator takes the hull."""
    if solid.box is not None:
        box_collider(parent, name, solid.box[0], solid.box[1], looks, friction)
        return
    made = prim(parent, name, "Mesh", ["PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"])
    faces = hull_faces(solid.points)
    _shape(made, solid.points, faces)
    normals, index = _flat_normals(solid.points, faces)
    _primvar(made, "normals", "Normal3fArray", vectors(normals), index, "uniform")
    attribute(made, "purpose", "Token", "guide", uniform=True)
    attribute(made, "physics:approximation", "Token", "convexHull", uniform=True)
    tune_collider(made)
    looks.rub(made, friction)


def box_collider(parent: Prim, name: str, center: np.ndarray, half: np.ndarray, looks: Looks, friction: float) -> None:
    """A box by its centre [3] and half extents [3] in the frame of its parent."""
    made = prim(parent, name, "Cube", ["PhysicsCollisionAPI"])
    attribute(made, "size", "Double", 1.0)
    attribute(made, "extent", "Float3Array", vectors(np.array([[-0.5] * 3, [0.5] * 3])))
    attribute(made, "purpose", "Token", "guide", uniform=True)
    attribute(made, "xformOp:translate", "Double3", triple(center))
    attribute(made, "xformOp:scale", "Double3", triple(2 * half))
    order = ["xformOp:translate", "xformOp:scale"]
    attribute(made, "xformOpOrder", "TokenArray", order, uniform=True)
    tune_collider(made)
    looks.rub(made, friction)


def _primvar(made: Prim, name: str, kind: str, values: Any, index: np.ndarray, each: str = "faceVarying") -> None:
    """Values of a mesh, equal ones once, and which of them each corner has; "uniform": each face."""
    attribute(made, f"primvars:{name}", kind, values).SetInfo("interpolation", each)
    attribute(made, f"primvars:{name}:indices", "IntArray", integers(index))


def _flat_normals(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Different unit normals of faces [N, 3], and which one each face has [F]."""
    a, b, c = (points[faces[:, k]].T for k in range(3))
    (ux, uy, uz), (vx, vy, vz) = b - a, c - a
    normals = np.stack([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], axis=1)
    normals /= np.maximum(np.sqrt((normals**2).sum(axis=1, keepdims=True)), 1e-30)
    key = np.rint((normals + 1) * _STEPS).astype(np.int64) @ np.array([1, _WIDE, _WIDE**2])
    _, first, index = np.unique(key, return_index=True, return_inverse=True)
    return normals[first], index


def _shape(made: Prim, points: np.ndarray, faces: np.ndarray) -> None:
    """Points, triangles and bounds of a mesh prim, shown as they are and not subdivided."""
    attribute(made, "points", "Point3fArray", vectors(points))
    attribute(made, "faceVertexCounts", "IntArray", integers(np.full(len(faces), 3)))
    attribute(made, "faceVertexIndices", "IntArray", integers(faces.reshape(-1)))
    attribute(made, "extent", "Float3Array", vectors(np.stack([points.min(axis=0), points.max(axis=0)])))
    attribute(made, "subdivisionScheme", "Token", "none", uniform=True)
