"""Boxes of AI2-THOR's assets, which house files leave out: ProcTHOR's asset database and objathor's annotations."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from sceneweaver.io import load_packed_json
from sceneweaver.io.references import named_inside

from .sizes import Size
from .values import Entry

_DATABASES = ("asset-database.json", "asset_database.json", "annotations.json.gz", "annotations.json", "assets.json")
_ONE = ("{0}/annotations.json.gz", "{0}/annotations.json", "{0}/{0}.json.gz", "{0}/{0}.json", "{0}.json.gz", "{0}.json")


def box(folder: Path | None, asset: str) -> Size | None:
    """(depth, width, height) [m] of an asset as its own folder or a database in ``folder`` says; None: neither does.

    Their boxes are in Unity's frame, where a thing faces +z: x is its width, y its height, z its depth.
    """
    if folder is None or not asset:
        return None
    known = _database(folder)
    if asset in known:
        return known[asset]
    for form in _ONE:
        place = named_inside(folder, folder / form.format(asset))
        if place is not None and place.is_file():
            return _size(Entry.of(place, load_packed_json(place)))
    return None


@lru_cache(maxsize=4)
def _database(folder: Path) -> dict[str, Size]:
    found: dict[str, Size] = {}
    for base in (folder, folder / "procthor" / "databases", folder / "databases"):
        for name in _DATABASES:
            if (base / name).is_file():
                for asset, entry in _assets(Entry.of(base / name, load_packed_json(base / name))):
                    size = _size(entry)
                    if size is not None:
                        found[asset] = size
    return found


def _assets(data: Entry) -> Iterator[tuple[str, Entry]]:
    """Assets by id: ``{type: [{assetId, ..}]}`` as ProcTHOR has them, or ``{id: {..}}`` as objathor has."""
    for name, entry in data.items():
        if isinstance(entry.value, list):
            for one in entry.entries():
                if one.word("assetId"):
                    yield one.word("assetId"), one
        elif isinstance(entry.value, dict):
            yield name, entry


def _size(entry: Entry) -> Size | None:
    """The box of an asset: its sides, or its least and largest corners."""
    for key in ("thor_metadata", "assetMetadata"):
        entry = entry[key] if entry.has(key) else entry
    if not entry.has("boundingBox"):
        return None
    found = entry["boundingBox"]
    found = found["size"] if found.has("size") else found
    if found.has("min"):
        low, high = found["min"].named("xyz"), found["max"].named("xyz")
        width, height, depth = (b - a for a, b in zip(low, high, strict=True))
    else:
        width, height, depth = found.named("xyz")
    return (depth, width, height) if min(width, height, depth) >= 0 else None
