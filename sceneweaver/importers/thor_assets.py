"""Boxes and types of AI2-THOR's assets, which house files leave out: ProcTHOR's database, objathor's annotations."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from sceneweaver.io import load_packed_json
from sceneweaver.io.references import named_inside

from .sizes import Size
from .values import Entry

_DATABASES = ("asset-database.json", "asset_database.json", "annotations.json.gz", "annotations.json", "assets.json")
_ONE = ("{0}/annotations.json.gz", "{0}/annotations.json", "{0}/{0}.json.gz", "{0}/{0}.json", "{0}.json.gz", "{0}.json")


class Asset(NamedTuple):
    """What is known of an asset: (depth, width, height) [m], and its type ("DiningTable"), "" where it has none."""

    size: Size
    kind: str = ""


def known_asset(folder: Path | None, asset: str) -> Asset | None:
    """An asset as its own folder or a database in ``folder`` says; None: neither does.

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
            return _asset(Entry.of(place, load_packed_json(place)))
    return None


@lru_cache(maxsize=4)
def _database(folder: Path) -> dict[str, Asset]:
    found: dict[str, Asset] = {}
    for base in (folder, folder / "procthor" / "databases", folder / "databases"):
        for name in _DATABASES:
            if (base / name).is_file():
                for asset, kind, entry in _assets(Entry.of(base / name, load_packed_json(base / name))):
                    one = _asset(entry, kind)
                    if one is not None:
                        found[asset] = one
    return found


def _assets(data: Entry) -> Iterator[tuple[str, str, Entry]]:
    """Assets with id and type: ``{type: [{assetId, ..}]}`` as ProcTHOR has them, or ``{id: {..}}`` as objathor has."""
    for name, entry in data.items():
        if isinstance(entry.value, list):
            for one in entry.entries():
                if one.word("assetId"):
                    yield one.word("assetId"), name, one
        elif isinstance(entry.value, dict):
            yield name, "", entry


def _asset(entry: Entry, kind: str = "") -> Asset | None:
    """An asset by its box, given as its sides or as its least and largest corners; None without one."""
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
    return Asset((depth, width, height), kind) if min(width, height, depth) >= 0 else None
