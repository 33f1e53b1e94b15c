"""Any folder of mesh files, with a manifest or none.

``manifest.json`` is a list of objects, or an object from file name to object; ``manifest.csv`` has the same columns:
file, category, description, up, front, unit (metres per unit), depth, width, height, mass, friction, mount, licence,
attribution, color, material, style, yaw (degrees). All but ``file`` may be left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.io import load_csv, load_packed_json, named_inside
from sceneweaver.io.messages import quote, suggest
from sceneweaver.scene import InputError

from ..imports.hints import Hints
from ..imports.load import SUFFIXES
from .tables import axis_of, number, text

_COLUMNS = (
    "file",
    "category",
    "description",
    "up",
    "front",
    "unit",
    "depth",
    "width",
    "height",
    "mass",
    "friction",
    "mount",
    "licence",
    "attribution",
    "color",
    "material",
    "style",
    "yaw",
)
_UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}


def fits(path: Path) -> bool:
    """Any file or folder may be one."""
    return path.exists()


def read(path: Path) -> Iterator[Hints]:
    """The mesh files of a folder; of those that a manifest names, with what it says."""
    if path.is_file():
        yield Hints(path=path, name=path.stem)
        return
    rows = _manifest(path)
    if rows is None:
        for file in sorted(p for p in path.rglob("*") if p.suffix.lower() in SUFFIXES and p.is_file()):
            category = file.parent.name if file.parent != path else None
            yield Hints(path=file, name=file.stem, category=category)
        return
    for row in rows:
        yield _hints(path, row)


def _manifest(path: Path) -> list[dict[str, Any]] | None:
    if (path / "manifest.json").exists():
        data = load_packed_json(path / "manifest.json")
        if isinstance(data, dict):
            data = [{"file": name, **row} for name, row in data.items() if isinstance(row, dict)]
        if not isinstance(data, list) or not all(isinstance(row, dict) for row in data):
            raise InputError("manifest.json: must be a list of objects, or an object from file name to object")
        return data
    if (path / "manifest.csv").exists():
        return [{k: v for k, v in row.items() if v not in ("", None)} for row in load_csv(path / "manifest.csv")]
    return None


def _hints(root: Path, row: dict[str, Any]) -> Hints:
    given = row.get("file")
    if not isinstance(given, str) or not given:
        raise InputError("manifest: a row has no 'file'")
    name = text(given)
    for key in row:
        if key not in _COLUMNS:
            raise InputError(f"manifest: {name}: unknown column {quote(key)}{suggest(key, _COLUMNS)}")
    file = named_inside(root, root / given)
    if file is None:
        raise InputError(f"manifest: {name}: the file lies outside the folder")
    for key in ("up", "front"):
        if key in row and axis_of(row[key]) is None:
            raise InputError(f"manifest: {name}: {key} {quote(row[key])} is no axis; use x, -x, y, -y, z or -z")
    values = {}
    for key in ("depth", "width", "height", "mass", "friction", "yaw"):
        if key in row:
            values[key] = number(row[key])
            if values[key] is None or (values[key] <= 0 and key != "yaw"):
                raise InputError(f"manifest: {name}: {key} {quote(row[key])} is no number above 0")
    unit = row.get("unit")
    metres = _UNITS.get(str(unit).lower(), number(unit)) if unit is not None else None
    if unit is not None and (metres is None or metres <= 0):
        raise InputError(f"manifest: {name}: unit {quote(unit)} is unknown; use m, cm, mm, in, ft or metres per unit")
    return Hints(
        path=file,
        name=file.stem,
        category=text(row.get("category")) or None,
        description=text(row.get("description")),
        up=axis_of(row.get("up")),
        front=axis_of(row.get("front")),
        yaw=math.radians(values.get("yaw", 0.0) or 0.0),
        metres=metres,
        size=(values.get("depth"), values.get("width"), values.get("height")),
        mass=values.get("mass"),
        friction=values.get("friction"),
        mount=text(row.get("mount")) or None,
        licence=text(row.get("licence")) or "unknown",
        attribution=text(row.get("attribution")),
        attributes={k: text(row[k]) for k in ("color", "material", "style") if k in row},
    )
