"""Objects as MJCF: RoboCasa's ``model.xml`` and MolmoSpaces' ``<name>.xml``, a folder an object.

Visual meshes are geoms of group 1 or without contact, collision meshes the others; z up. RoboCasa's fixtures face -y,
which a ``front`` may overrule.
"""

from __future__ import annotations

import os
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.geometry.rotations import euler, matrix, xyzw
from sceneweaver.io import load_mjcf
from sceneweaver.scene import InputError

from ..imports.hints import Hints
from .tables import number


def fits(path: Path) -> bool:
    """True for an MJCF file, or a folder with model.xml files, or folders with an XML of their own name."""
    if path.is_file():
        return path.suffix.lower() == ".xml"
    return next(iter(_models(path)), None) is not None


def read(path: Path) -> Iterator[Hints]:
    """One entry a model: its largest visual mesh file, in its body's frame."""
    for model in [path] if path.is_file() else _models(path):
        yield _hints(model, path)


def _models(path: Path) -> list[Path]:
    found = set(path.rglob("model.xml")) | {p for p in path.rglob("*.xml") if p.stem == p.parent.name}
    return sorted(found)


def _hints(model: Path, root: Path) -> Hints:
    tree = load_mjcf(model, root if root.is_dir() else root.parent)
    compiler = tree.find("compiler")
    base = model.parent / ((compiler.get("meshdir") or compiler.get("assetdir") or "") if compiler is not None else "")
    meshes = {m.get("name") or Path(m.get("file", "")).stem: m for m in tree.iter("mesh") if m.get("file")}
    visual, solid = [], []
    for geom in tree.iter("geom"):
        mesh = meshes.get(geom.get("mesh", ""))
        if mesh is None:
            continue
        free = geom.get("contype") == "0" and geom.get("conaffinity") == "0"
        looks = free or geom.get("group") in ("1", "2") or "visual" in (geom.get("class") or geom.get("name") or "")
        (visual if looks else solid).append((geom, mesh))
    chosen = visual or solid
    if not chosen:
        raise InputError(f"{model.name}: no geom with a mesh")
    chosen.sort(key=lambda pair: -_bytes(base, pair[1]))
    geom, mesh = chosen[0]
    scale = _numbers(mesh.get("scale") or "1 1 1", 3, model.name)
    pose = np.eye(4)
    degrees = compiler is None or compiler.get("angle", "degree") != "radian"
    pose[:3, :3] = _rotation(geom, degrees, model.name) @ np.diag(scale)
    pose[:3, 3] = _numbers(geom.get("pos") or "0 0 0", 3, model.name)
    same = [pair for pair in solid if _placed(*pair) == _placed(geom, mesh)]
    names = [part for part in model.parent.relative_to(root).parts if part] if model != root else []
    return Hints(
        path=_file(base, mesh),
        name=model.parent.name if model.stem == "model" else model.stem,
        category=(names[0] if len(names) > 1 else names[-1] if names else model.parent.name).rstrip("0123456789_"),
        up="z",
        front="-y",
        metres=1.0,
        transform=tuple(tuple(float(v) for v in row) for row in pose),
        mass=sum(v for g, _ in solid if (v := number(g.get("mass"))) is not None) or None,
        source="mjcf",
        hulls=tuple(_file(base, m) for _, m in same) if len(same) == len(solid) and visual else (),
    )


def _placed(geom: ET.Element, mesh: ET.Element) -> tuple[str | None, ...]:
    """Where a geom's mesh stands in its body, as it is written."""
    return (*(geom.get(key) for key in ("pos", "quat", "euler")), mesh.get("scale"))


def _file(base: Path, mesh: ET.Element) -> Path:
    """Where the file of a mesh lies, without ``..`` in its path."""
    return Path(os.path.abspath(base / mesh.get("file", "")))


def _bytes(base: Path, mesh: ET.Element) -> int:
    file = _file(base, mesh)
    return file.stat().st_size if os.path.isfile(file) else 0


def _numbers(text: str, count: int, name: str) -> list[float]:
    """So many numbers of an attribute; InputError names the model when they are not there."""
    found = [number(v) for v in text.split()]
    if len(found) != count or any(v is None for v in found):
        raise InputError(f"{name}: '{text[:40]}' are not {count} numbers")
    return [float(v) for v in found if v is not None]


def _rotation(geom: ET.Element, degrees: bool, name: str) -> np.ndarray:
    """A geom's ``quat`` (wxyz) or ``euler`` (x, y, z, applied in this order about moving axes), as MJCF has them."""
    if geom.get("quat"):
        turn = xyzw(_numbers(geom.get("quat", ""), 4, name))
        return matrix(turn) if turn.any() else np.eye(3)
    angles = _numbers(geom.get("euler") or "0 0 0", 3, name)
    return euler(np.radians(angles) if degrees else angles)
