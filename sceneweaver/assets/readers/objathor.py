"""Objaverse assets with objathor's annotations (``annotations.json`` or ``.json.gz``, beside the GLB files).

Objaverse files have no canonical front or scale. ``scale`` is the height in centimetres / 100, ``pose_z_rot_angle``
[rad] turns the object about the vertical, ``frontView`` names the rendered view (0 to 3, a quarter turn each) that
shows the front.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.io import load_packed_json

from ..imports.hints import Hints
from .tables import file_of, number, rows_of, text

_NAMES = ("annotations.json", "annotations.json.gz")


def fits(path: Path) -> bool:
    """True for a folder with annotations, at its top or beside each asset."""
    return path.is_dir() and (_table(path) is not None or next(path.glob("*/annotations.json*"), None) is not None)


def read(path: Path) -> Iterator[Hints]:
    """Assets whose GLB is there, by uid."""
    table = _table(path)
    if table is not None:
        rows = load_packed_json(table)
        if isinstance(rows, dict):
            rows = [{"uid": uid, **row} for uid, row in rows.items() if isinstance(row, dict)]
        for row in rows_of(table, rows):
            uid = text(row.get("uid"))
            for names in ((f"{uid}.glb",), (uid, f"{uid}.glb"), ("glbs", f"{uid}.glb")):
                if (file := file_of(path, *names)) is not None:
                    yield _hints(file, uid, row)
                    break
        return
    for notes in sorted(path.glob("*/annotations.json*")):
        file = next(iter(sorted(notes.parent.glob("*.glb"))), None)
        if file is not None:
            (row,) = rows_of(notes, [load_packed_json(notes)])
            yield _hints(file, notes.parent.name, row)


def _table(path: Path) -> Path | None:
    return next((path / name for name in _NAMES if (path / name).exists()), None)


def _hints(file: Path, uid: str, row: dict[str, Any]) -> Hints:
    height = number(row.get("scale"))
    view = number(row.get("frontView"))
    turn = number(row.get("pose_z_rot_angle")) or 0.0
    # The annotators' views look along -z, +x, +z, -x of the GLB for 0 to 3: view 0 sees the +z face.
    front = ("z", "x", "-z", "-x")[int(view) % 4] if view is not None else None
    return Hints(
        path=file,
        name=uid,
        category=text(row.get("category")) or None,
        description=text(row.get("description")),
        up="y",
        front=front,
        yaw=wrap_angle(turn),
        size=(None, None, height),
        mass=number(row.get("mass")),
        mount=_mount(row),
        source="objaverse",
        licence=text(row.get("license", row.get("licence"))) or "unknown",
        attribution=text(row.get("uid")) or uid,
        attributes={"material": text(", ".join(map(text, row["materials"][:20])))}
        if isinstance(row.get("materials"), list)
        else {},
    )


def _mount(row: dict[str, Any]) -> str | None:
    for key, mount in (("onCeiling", "ceiling"), ("onWall", "wall"), ("onFloor", "floor"), ("onObject", "surface")):
        if row.get(key):
            return mount
    return None
