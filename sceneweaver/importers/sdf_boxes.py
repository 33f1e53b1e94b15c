"""The box of an SDF model: what its links show, in the frame of the model (z up)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from sceneweaver.io import InputError, load_xml, named_inside

Bounds = tuple[np.ndarray, np.ndarray]
"""Least and largest corner [3] [m]."""


def sdf_bounds(path: Path) -> Bounds | None:
    """Least and largest corner [m] of all visuals of a model, or of its collisions where it has none.

    Meshes are read where they lie in the model's folder; glTF is turned from y up to z up, as Drake turns it.

    Raises:
        InputError: the file is no SDF.
    """
    root = load_xml(path)
    model = root.find("model") if root.tag == "sdf" else None
    if model is None:
        raise InputError(f"{path.name}: no <sdf><model> in it; give the SDF of one model")
    base = _pose(model.find("pose"), path)
    for kind in ("visual", "collision"):
        corners = [c for link in model.iter("link") for c in _shown(link, kind, path)]
        if corners:
            points = _moved(np.concatenate(corners), np.eye(4) if base is None else base)
            return points.min(axis=0), points.max(axis=0)
    return None


def _shown(link: ElementTree.Element, kind: str, path: Path) -> Iterator[np.ndarray]:
    """Points [n, 3] that span what a link shows."""
    frame = _pose(link.find("pose"), path)
    for item in link.findall(kind):
        geometry = item.find("geometry")
        local = None if geometry is None else _geometry(geometry, path)
        if local is not None:
            yield _moved(local, frame @ _pose(item.find("pose"), path))


def _geometry(geometry: ElementTree.Element, path: Path) -> np.ndarray | None:
    for shape in geometry:
        if shape.tag == "box":
            return _corners(np.array(_numbers(shape.findtext("size"), 3, path)) / 2)
        if shape.tag == "sphere":
            return _corners(np.full(3, _numbers(shape.findtext("radius"), 1, path)[0]))
        if shape.tag in ("cylinder", "capsule"):
            r = _numbers(shape.findtext("radius"), 1, path)[0]
            half = _numbers(shape.findtext("length"), 1, path)[0] / 2 + (r if shape.tag == "capsule" else 0.0)
            return _corners(np.array((r, r, half)))
        if shape.tag == "mesh":
            return _mesh(shape, path)
    return None


def _mesh(shape: ElementTree.Element, path: Path) -> np.ndarray | None:
    from sceneweaver.assets.imports.load import load

    uri = (shape.findtext("uri") or "").strip().removeprefix("file://")
    place = named_inside(path.parent, path.parent / uri) if uri and "://" not in uri else None
    if place is None or not place.is_file():
        return None
    raw = load(place)
    scale = np.array(_numbers(shape.findtext("scale") or "1 1 1", 3, path))
    points = raw.vertices[np.unique(raw.faces)] * scale
    if place.suffix.lower() in (".glb", ".gltf"):
        points = points[:, [0, 2, 1]] * (1.0, -1.0, 1.0)
    low, high = points.min(axis=0), points.max(axis=0)
    return _corners((high - low) / 2) + (low + high) / 2


def _corners(half: np.ndarray) -> np.ndarray:
    return np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half


def _moved(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _pose(element: ElementTree.Element | None, path: Path) -> np.ndarray:
    """The matrix [4, 4] of a pose: x y z and roll pitch yaw about fixed axes."""
    matrix = np.eye(4)
    if element is None or not (element.text or "").strip():
        return matrix
    x, y, z, *angles = _numbers(element.text, 6, path)
    if element.get("degrees") == "true":
        angles = [math.radians(v) for v in angles]
    (cr, cp, cy), (sr, sp, sy) = [math.cos(v) for v in angles], [math.sin(v) for v in angles]
    matrix[:3, :3] = (
        np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
        @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    )
    matrix[:3, 3] = x, y, z
    return matrix


def _numbers(text: str | None, count: int, path: Path) -> list[float]:
    try:
        values = [float(v) for v in (text or "").split()]
    except ValueError:
        values = []
    if len(values) != count or not all(math.isfinite(v) and abs(v) < 1e6 for v in values):
        raise InputError(f"{path.name}: '{(text or '')[:40]}' must be {count} finite numbers")
    return values
