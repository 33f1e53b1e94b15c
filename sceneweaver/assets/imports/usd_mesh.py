"""The meshes of a USD file as arrays, for a process that a damaged file may crash."""

# pxr has no stubs:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from pathlib import Path

import numpy as np

from sceneweaver.io import InputError, open_stage

MAX_TRIANGLES = 10_000_000

_GREY = (0.7, 0.7, 0.7)


def read_usd(path: Path) -> dict[str, np.ndarray]:
    """Triangles of all visible meshes in the file's axes and unit.

    Returns:
        ``vertices`` [V, 3], ``faces`` [F, 3], ``face_material`` [F], ``names`` [M] and ``looks`` [M, 6] of materials
        (sRGB, roughness, metallic, opacity), ``up`` ("y" or "z"), ``metres`` a unit (NaN where nobody says); or
        ``refused``, one line.
    """
    try:
        return _read(path)
    except InputError as error:
        return {"refused": np.array(str(error))}


def _read(path: Path) -> dict[str, np.ndarray]:
    from pxr import Usd, UsdGeom, UsdShade

    stage = open_stage(path)
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
        if sum(map(len, faces)) + len(triangles) > MAX_TRIANGLES:
            raise InputError(f"{path.name}: over {MAX_TRIANGLES} triangles; simplify it to at most so many")
        flipped = mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded
        if flipped != (np.linalg.det(world[:3, :3]) < 0):
            triangles = triangles[:, ::-1]
        bound, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        vertices.append(points)
        faces.append(triangles + start)
        slots.append(np.full(len(triangles), len(looks)))
        looks.append(_look(mesh, bound, len(looks)))
        start += len(points)
    if not vertices:
        raise InputError(f"{path.name}: the file has no triangles")
    stated = UsdGeom.StageHasAuthoredMetersPerUnit(stage)
    return {
        "vertices": np.concatenate(vertices),
        "faces": np.concatenate(faces),
        "face_material": np.concatenate(slots),
        "names": np.array([name for name, _ in looks]),
        "looks": np.array([values for _, values in looks], dtype=float),
        "up": np.array(str(UsdGeom.GetStageUpAxis(stage)).lower()),
        "metres": np.array(float(UsdGeom.GetStageMetersPerUnit(stage)) if stated else np.nan),
    }


def _fans(counts: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Polygons as triangles that share their first corner."""
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    fans = np.maximum(counts - 2, 0)
    which = np.repeat(np.arange(len(counts)), fans)
    step = np.arange(len(which)) - np.repeat(np.cumsum(fans) - fans, fans)
    first = starts[which]
    return np.stack([corners[first], corners[first + step + 1], corners[first + step + 2]], axis=1)


def _look(mesh, bound, index: int) -> tuple[str, list[float]]:
    """Its name, and the inputs of a UsdPreviewSurface or the mesh's display colour."""
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
    color = _GREY if linear is None else [_srgb(float(c)) for c in linear[:3]]
    rest = (float(values.get(key, usual)) for key, usual in (("roughness", 0.6), ("metallic", 0.0), ("opacity", 1.0)))
    roughness, metallic, opacity = rest
    name = bound.GetPrim().GetName() if bound else f"material-{index}"
    return name, [*color, roughness, metallic, max(0.05, opacity)]


def _srgb(c: float) -> float:
    c = min(1.0, max(0.0, c))
    return 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055
