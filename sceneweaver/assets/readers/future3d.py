"""3D-FUTURE: ``model_info.json`` and a folder a model with ``raw_model.obj``; y up, front +z, metres."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sceneweaver.io import load_packed_json

from ..imports.hints import Hints
from .tables import file_of, rows_of, text


def fits(path: Path) -> bool:
    """True for a folder with model_info.json."""
    return (path / "model_info.json").is_file()


def read(path: Path) -> Iterator[Hints]:
    """Models whose mesh is there."""
    table = path / "model_info.json"
    for row in rows_of(table, load_packed_json(table)):
        uid = text(row.get("model_id"))
        files = (file_of(path, uid, name) for name in ("raw_model.obj", "normalized_model.obj"))
        file = next((f for f in files if f is not None), None)
        if not uid or file is None:
            continue
        # Categories read like "King-size Bed" or "Lounge Chair / Cafe Chair / Office Chair".
        category = text(row.get("category") or row.get("super-category")).split("/")[0].strip().lower()
        yield Hints(
            path=file,
            name=uid,
            category=category or None,
            up="y",
            front="z",
            metres=1.0,
            source="3d-future",
            licence="3D-FUTURE terms of use",
            attributes={
                "style": text(row.get("style")).lower(),
                "material": text(row.get("material")).lower(),
                "theme": text(row.get("theme")).lower(),
            },
        )
