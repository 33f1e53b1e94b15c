"""Mesh files as raw triangles with a look each: GLB, glTF, OBJ, STL, PLY, OFF and USD."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import open_regular, read_arrays, read_meshes, reason
from sceneweaver.io.meshes import MAX_BYTES
from sceneweaver.scene import InputError, MissingDependencyError

from ..body import Material
from .limited import LimitedError, run_limited
from .usd_mesh import MAX_TRIANGLES

MAX_COORDINATE = 1e9
"""Largest coordinate in a file's own unit: squares and products of such still fit."""

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


def load(path: Path, seconds: float = 60.0) -> RawMesh:
    """Read a mesh file; USD takes ``seconds`` at most.

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
        if suffix in _USD:
            raw = _load_usd(path, seconds)
        elif suffix == _ARRAYS:
            raw = _load_arrays(path)
        else:
            raw = _load_mesh(path, suffix)
    except (InputError, MissingDependencyError):
        raise
    except Exception as error:  # libraries raise whatever they like for damaged files
        raise InputError(f"{path.name}: the file is damaged or cut off ({reason(error)})") from error
    if len(raw.faces) == 0:
        raise InputError(f"{path.name}: the file has no triangles")
    if not np.isfinite(raw.vertices).all() or np.abs(raw.vertices).max() > MAX_COORDINATE:
        raise InputError(f"{path.name}: some vertices are NaN, infinite or beyond {MAX_COORDINATE:g}")
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
        with np.errstate(over="ignore", invalid="ignore"):  # `load` looks at what comes out
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


def _load_usd(path: Path, seconds: float) -> RawMesh:
    """In another process: the reader is native code, which a damaged file may crash."""
    try:
        found = run_limited("read_usd", {"path": np.array(os.path.abspath(path))}, seconds)
    except LimitedError as error:
        raise InputError(f"{path.name}: the file is damaged, too large or takes too long ({error})") from None
    if "refused" in found:
        raise InputError(str(found["refused"]))
    rows = zip(found["names"], found["looks"], strict=True)
    looks = [
        Material(str(name), _rgb(row), roughness=float(row[3]), metallic=float(row[4]), opacity=float(row[5]))
        for name, row in rows
    ]
    metres = float(found["metres"])
    return RawMesh(
        found["vertices"],
        found["faces"],
        found["face_material"],
        tuple(looks),
        up=str(found["up"]),
        metres=None if np.isnan(metres) else metres,
    )
