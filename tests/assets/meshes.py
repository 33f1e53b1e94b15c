"""Mesh files for the tests, made from our own furniture so that the truth is known."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import trimesh

from sceneweaver.assets.asset import Asset

Y_UP = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1.0]])
"""Our frame (front +x, left +y, up +z) as glTF has it: up +y, front +z, left +x."""


def body(
    asset: Asset, *, matrix: np.ndarray | None = None, scale: float = 1.0, shift=(0.0, 0.0, 0.0)
) -> trimesh.Trimesh:
    """The visual mesh of an asset, moved: first ``matrix``, then the scale, then the shift."""
    mesh = trimesh.Trimesh(asset.mesh.vertices, asset.mesh.faces, process=False)
    if matrix is not None:
        mesh.apply_transform(matrix)
    mesh.apply_scale(scale)
    mesh.apply_translation(shift)
    return mesh


def turned(quarters: int) -> np.ndarray:
    """A turn about z by quarters."""
    return trimesh.transformations.rotation_matrix(quarters * np.pi / 2, [0, 0, 1])


def write(mesh: trimesh.Trimesh, path: Path) -> Path:
    """Export by suffix."""
    path.parent.mkdir(parents=True, exist_ok=True)
    mesh.export(path)
    return path


def write_usd(asset: Asset, path: Path, *, up: str = "Z", metres: float = 1.0) -> Path:
    """One mesh as USD, in the axes and unit that it states."""
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, up)
    UsdGeom.SetStageMetersPerUnit(stage, metres)
    mesh = UsdGeom.Mesh.Define(stage, "/thing/mesh")
    points = asset.mesh.vertices / metres
    if up == "Y":
        points = points @ Y_UP[:3, :3].T
    mesh.CreatePointsAttr(points.tolist())
    mesh.CreateFaceVertexCountsAttr([3] * len(asset.mesh.faces))
    mesh.CreateFaceVertexIndicesAttr(asset.mesh.faces.reshape(-1).tolist())
    mesh.CreateDisplayColorAttr([(0.5, 0.1, 0.1)])
    stage.GetRootLayer().Save()
    return path
