"""Mesh files as raw triangles with a look each: GLB, glTF, OBJ, STL, PLY, OFF and USD."""

# pxr has no stubs:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import open_regular, reason
from sceneweaver.scene import InputError, MissingDependencyError

from ..body import Material
from .guarded import MAX_BYTES, read_arrays, read_meshes, require_regular_layers

MAX_TRIANGLES = 10_000_000

_USD = {".usd", ".usda", ".usdc", ".usdz"}
SUFFIXES = frozenset({".glb", ".gltf", ".obj", ".stl", ".ply", ".off"} | _USD)

_ARRAYS = ".npz"
"""Arrays as the Infinigen worker writes them; for our own use, so not among the suffixes."""

_GREY = (0.7, 0.7, 0.7)


@dataclass(frozen=True)
class RawMesh:
    """Triangles as a file has them, in its own axes and unit.

    ``up`` and ``metres`` (metres per unit) are what the file or its format states; None where it states nothing.
    """

    vertices: np.ndarray
    faces: np.ndarray
    face_material: np.ndarray
    materials: tuple[Material, ...]
    up: str | None = None
    metres: float | None = None


def load(path: Path) -> RawMesh:
    """Read a mesh file.

    Raises:
        InputError: for a file that is missing, too large, damaged, of an unknown kind, or without triangles.
        MissingDependencyError: for a file that needs a package which is not installed.
    """
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES and suffix != _ARRAYS:
        raise InputError(
            f"{path.name}: files of type '{suffix}' are not read; use one of {', '.join(sorted(SUFFIXES))}"
        )
    with open_regular(path, MAX_BYTES) as file:
        if not file.read(1):
            raise InputError(f"{path.name}: the file is empty")
    try:
        raw = (
            _load_usd(path) if suffix in _USD else _load_arrays(path) if suffix == _ARRAYS else _load_mesh(path, suffix)
        )
    except (InputError, MissingDependencyError):
        raise
    except Exception as error:  # libraries raise whatever they like for damaged files
        raise InputError(f"{path.name}: the file is damaged or cut off ({reason(error)})") from error
    if len(raw.faces) == 0:
        raise InputError(f"{path.name}: the file has no triangles")
    if not np.isfinite(raw.vertices).all():
        raise InputError(f"{path.name}: some vertices are NaN or infinite")
    if int(raw.faces.min()) < 0 or int(raw.faces.max()) >= len(raw.vertices):
        raise InputError(f"{path.name}: a triangle names a vertex that is not there")
    extent = np.ptp(raw.vertices[np.unique(raw.faces)], axis=0)
    if float(np.sort(extent)[1]) <= 0:
        raise InputError(f"{path.name}: the mesh has no extent")
    return raw


def _load_mesh(path: Path, suffix: str) -> RawMesh:
    import trimesh

    scene = read_meshes(path)
    vertices, faces, slots, looks = [], [], [], []
    start = 0
    for name in scene.graph.nodes_geometry:
        transform, key = scene.graph[name]
        body = scene.geometry[key]
        if not isinstance(body, trimesh.Trimesh) or not len(body.faces):
            continue
        points = np.asarray(body.vertices, dtype=np.float64) @ transform[:3, :3].T + transform[:3, 3]
        triangles = np.asarray(body.faces, dtype=np.int64)
        _require_few(path, sum(map(len, faces)) + len(triangles))
        if np.linalg.det(transform[:3, :3]) < 0:
            triangles = triangles[:, ::-1]
        vertices.append(points)
        faces.append(triangles + start)
        slots.append(np.full(len(triangles), len(looks)))
        looks.append(_look(body, len(looks)))
        start += len(points)
    if not vertices:
        return RawMesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64), np.zeros(0, dtype=np.int64), ())
    stated = suffix in (".glb", ".gltf")  # glTF 2.0: metres, +y up
    return RawMesh(
        np.concatenate(vertices),
        np.concatenate(faces),
        np.concatenate(slots),
        tuple(looks),
        up="y" if stated else None,
        metres=1.0 if stated else None,
    )


def _require_few(path: Path, triangles: int) -> None:
    """A small file may show one mesh any number of times."""
    if triangles > MAX_TRIANGLES:
        raise InputError(f"{path.name}: over {MAX_TRIANGLES} triangles; simplify it to at most so many")


def _load_arrays(path: Path) -> RawMesh:
    found = read_arrays(path)
    looks = [
        Material(str(name), _rgb(row), roughness=float(row[3]), metallic=float(row[4]))
        for name, row in zip(found["names"], found["looks"], strict=True)
    ]
    return RawMesh(
        found["vertices"].astype(np.float64),
        found["faces"].astype(np.int64),
        found["face_material"].astype(np.int64),
        tuple(looks),
        up="z",
        metres=1.0,
    )


def _look(body, index: int) -> Material:
    """Base colour, roughness and metallic of a mesh; the mean of its texture where it has one."""
    visual = body.visual
    name, color, roughness, metallic, opacity = f"material-{index}", _GREY, 0.6, 0.0, 1.0
    material = getattr(visual, "material", None)
    if material is not None:
        name = str(getattr(material, "name", None) or name)
        factor = getattr(material, "baseColorFactor", None)
        factor = getattr(material, "diffuse", None) if factor is None else factor
        if factor is not None:
            rgba = np.asarray(factor, dtype=np.float64) / 255.0
            color = _rgb(rgba)
            opacity = float(rgba[3]) if len(rgba) > 3 else 1.0
        image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
        if image is not None:
            mean = np.asarray(image.convert("RGB").resize((8, 8))).reshape(-1, 3).mean(axis=0) / 255.0
            tint = np.ones(3) if factor is None or getattr(material, "baseColorFactor", None) is None else color
            color = _rgb(mean * tint)
        rough, metal = getattr(material, "roughnessFactor", None), getattr(material, "metallicFactor", None)
        roughness = roughness if rough is None else float(rough)
        # glTF's default is metallic, which files without textures hardly ever mean.
        metallic = metallic if metal is None else float(metal)
    elif getattr(visual, "kind", None) in ("vertex", "face"):
        color = _rgb([float(c) / 255.0 for c in np.asarray(visual.main_color)[:3]])
    return Material(name=name, color=color, roughness=roughness, metallic=metallic, opacity=max(0.05, opacity))


def _rgb(values) -> tuple[float, float, float]:
    r, g, b = (round(float(c), 4) for c in values[:3])
    return r, g, b


def _load_usd(path: Path) -> RawMesh:
    from pxr import Usd, UsdGeom, UsdShade

    require_regular_layers(path)
    stage = Usd.Stage.Open(str(path))
    cache = UsdGeom.XformCache()
    vertices, faces, slots, looks = [], [], [], []
    start = 0
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
        if not prim.IsA(UsdGeom.Mesh):
            continue
        mesh = UsdGeom.Mesh(prim)
        if mesh.ComputePurpose() == UsdGeom.Tokens.guide or mesh.ComputeVisibility() == UsdGeom.Tokens.invisible:
            continue
        points = np.asarray(mesh.GetPointsAttr().Get() or [], dtype=np.float64).reshape(-1, 3)
        counts = np.asarray(mesh.GetFaceVertexCountsAttr().Get() or [], dtype=np.int64)
        corners = np.asarray(mesh.GetFaceVertexIndicesAttr().Get() or [], dtype=np.int64)
        if not len(points) or not len(counts):
            continue
        world = np.array(cache.GetLocalToWorldTransform(prim))  # row vectors
        points = points @ world[:3, :3] + world[3, :3]
        triangles = _fans(counts, corners)
        _require_few(path, sum(map(len, faces)) + len(triangles))
        flipped = mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded
        if flipped != (np.linalg.det(world[:3, :3]) < 0):
            triangles = triangles[:, ::-1]
        bound, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        vertices.append(points)
        faces.append(triangles + start)
        slots.append(np.full(len(triangles), len(looks)))
        looks.append(_usd_look(mesh, bound, len(looks)))
        start += len(points)
    if not vertices:
        raise InputError(f"{path.name}: the file has no triangles")
    return RawMesh(
        np.concatenate(vertices),
        np.concatenate(faces),
        np.concatenate(slots),
        tuple(looks),
        up=str(UsdGeom.GetStageUpAxis(stage)).lower(),
        metres=float(UsdGeom.GetStageMetersPerUnit(stage)) if UsdGeom.StageHasAuthoredMetersPerUnit(stage) else None,
    )


def _fans(counts: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Polygons as triangles that share their first corner."""
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    fans = np.maximum(counts - 2, 0)
    which = np.repeat(np.arange(len(counts)), fans)
    step = np.arange(len(which)) - np.repeat(np.cumsum(fans) - fans, fans)
    first = starts[which]
    return np.stack([corners[first], corners[first + step + 1], corners[first + step + 2]], axis=1)


def _usd_look(mesh, bound, index: int) -> Material:
    """The inputs of a UsdPreviewSurface, or the mesh's display colour."""
    from pxr import UsdShade

    values = {}
    shader = UsdShade.Material(bound).ComputeSurfaceSource()[0] if bound else None
    if shader:
        for key in ("diffuseColor", "roughness", "metallic", "opacity"):
            port = shader.GetInput(key)
            value = port.Get() if port and not port.HasConnectedSource() else None
            if value is not None:
                values[key] = value
    display = mesh.GetDisplayColorAttr().Get()
    linear = values.get("diffuseColor") or (display[0] if display else None)
    color = _GREY if linear is None else _rgb([_srgb(float(c)) for c in linear])
    return Material(
        name=bound.GetPrim().GetName() if bound else f"material-{index}",
        color=color,
        roughness=float(values.get("roughness", 0.6)),
        metallic=float(values.get("metallic", 0.0)),
        opacity=max(0.05, float(values.get("opacity", 1.0))),
    )


def _srgb(c: float) -> float:
    c = min(1.0, max(0.0, c))
    return 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055
