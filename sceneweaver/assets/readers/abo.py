"""Amazon Berkeley Objects: ``3dmodels.csv`` (path and extents) and ``listings_*.json(.gz)``; y up, front +z, metres."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.io import load_csv, load_json_lines

from ..imports.hints import Hints
from .tables import file_of


def fits(path: Path) -> bool:
    """True for a folder with 3dmodels.csv, at its top or under metadata/."""
    return path.is_dir() and _table(path) is not None


def read(path: Path) -> Iterator[Hints]:
    """Models whose GLB is there, with the category of their listing."""
    table = _table(path)
    assert table is not None
    listings = _listings(path)
    for row in load_csv(table):
        uid, place = row.get("3dmodel_id") or "", row.get("path") or ""
        bases = ("original", "", str(table.parent.relative_to(path)))
        file = next((f for base in bases if (f := file_of(path, base, place)) is not None), None) if place else None
        if not uid or file is None:
            continue
        listing = listings.get(uid, {})
        yield Hints(
            path=file,
            name=uid,
            category=_text(listing.get("product_type")).replace("_", " ").lower() or None,
            description=_text(listing.get("item_name")),
            up="y",
            front="z",
            metres=1.0,
            source="abo",
            licence="CC-BY-4.0",
            attribution="Amazon Berkeley Objects",
            attributes={
                "color": _text(listing.get("color")).lower(),
                "material": _text(listing.get("material")).lower(),
                "style": _text(listing.get("style")).lower(),
            },
        )


def _table(path: Path) -> Path | None:
    places = (path / "3dmodels.csv", path / "metadata" / "3dmodels.csv")
    return next((place for place in places if place.is_file()), None)


def _listings(path: Path) -> dict[str, dict[str, Any]]:
    """Listings (one JSON object a line) by the id of their 3D model."""
    found = {}
    for file in sorted(path.rglob("listings_*.json*")):
        for row in load_json_lines(file):
            if isinstance(row, dict) and isinstance(row.get("3dmodel_id"), str):
                found[row["3dmodel_id"]] = row
    return found


def _text(value: Any) -> str:
    """The English text, or the first, of ABO's lists of {language_tag, value}."""
    if isinstance(value, list):
        rows = [row for row in value if isinstance(row, dict) and row.get("value")]
        best = next(
            (row for row in rows if str(row.get("language_tag", "")).startswith("en")), rows[0] if rows else None
        )
        return str(best["value"]) if best else ""
    return str(value or "")
