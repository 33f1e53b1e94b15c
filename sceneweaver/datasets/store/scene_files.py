"""A scene in the formats of other tools, its meshes and images in the store of its data set."""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from sceneweaver.assets.journal import Journal
from sceneweaver.assets.placed import Load
from sceneweaver.assets.sources.parametric import share_drawings
from sceneweaver.export import FORMATS
from sceneweaver.export.shared import SharedFiles
from sceneweaver.home import Home
from sceneweaver.io import InputError, open_writable, write_atomic
from sceneweaver.physics.hulls import share_parts
from sceneweaver.scene import Scene

from ..seals import open_own, opened_row, sealed_row
from . import NAME, AssetStore

SUFFIXES = {name: one.file.rpartition(".")[2] for name, one in FORMATS.items() if one.shared}
"""By format, the suffix of its file."""

RECORDS = "work/assets"
"""Where processes write what they know of assets, relative to the root of the data set."""

JOURNAL = "work/journal"
"""Where processes tell each other what they have made, so that each thing is made once; it may go at any time."""


def scene_files(scene: Scene | Home, formats: Sequence[str], store: AssetStore, load: Load) -> dict[str, bytes]:
    """The files of a scene by suffix: as `SceneFiles.of`, with one writer for all scenes of a store.

    Args:
        scene: the scene, or a whole home.
        formats: "glb", "mjcf", "usd".
        store: where meshes and images go.
        load: from asset id to asset; all that are given for one store give equal assets.
    """
    return writer_of(store, load).of(scene, formats)


def writer_of(store: AssetStore, load: Load) -> SceneFiles:
    """The one writer of a store. From when it is there, what processes draw and merge they tell each other.

    Args:
        store: where meshes and images go.
        load: from asset id to asset; all that are given for one store give equal assets.
    """
    if SceneFiles not in store.notes:
        store.notes[SceneFiles] = SceneFiles(store, load)
    return store.notes[SceneFiles]


class SceneFiles:
    """Writes the scenes of a data set, and remembers what is in the store.

    Args:
        store: Where meshes and images go.
        load: From asset id to asset, for all scenes.
    """

    def __init__(self, store: AssetStore, load: Load):
        self._store, self._load = store, load
        journal = Journal(store.root / JOURNAL)
        share_parts(journal)
        share_drawings(Journal(journal.folder / "drawings"))
        self._shared = SharedFiles(store, self._used, journal)
        self._recorded: set[str] = set()
        self._fresh: dict[str, set[str]] = {}
        self._records = store.root / RECORDS / f"{secrets.token_hex(8)}.jsonl"

    def of(self, scene: Scene | Home, formats: Sequence[str]) -> dict[str, bytes]:
        """The files of a scene by suffix. They name those of the store by paths from the root of the data set.

        Raises:
            InputError: when an asset cannot be loaded.
            OSError: the store cannot be written.
        """
        rows = {name: FORMATS[name].for_homes() if isinstance(scene, Home) else FORMATS[name] for name in formats}
        found = {SUFFIXES[name]: row.shared_bytes(scene, self._load, self._shared) for name, row in rows.items()}
        self._record()
        return found

    def _used(self, asset: str, path: str) -> None:
        if asset not in self._recorded:
            self._fresh.setdefault(asset, set()).add(path)

    def _record(self) -> None:
        """Write a line for each asset that this process has met for the first time."""
        if not self._fresh:
            return
        rows = (sealed_row(self._row(name, paths)) for name, paths in self._fresh.items())
        lines = [json.dumps(row, ensure_ascii=False) for row in rows]
        self._records.parent.mkdir(parents=True, exist_ok=True)
        with open_writable(self._records, "ab") as file:
            file.write("".join(line + "\n" for line in lines).encode())
            os.fsync(file.fileno())
        self._recorded |= self._fresh.keys()
        self._fresh.clear()

    def _row(self, name: str, paths: Iterable[str]) -> dict[str, Any]:
        asset, files = self._load(name), sorted(paths)
        return {
            "asset": name,
            "category": asset.category,
            "source": asset.origin.source,
            "licence": asset.origin.licence,
            "attribution": asset.origin.attribution,
            "files": files,
            "bytes": sum((self._store.root / path).stat().st_size for path in files),
        }


def asset_rows(store: AssetStore) -> list[dict[str, Any]]:
    """What is known of each asset of a data set, by id: category, source, licence, attribution, files and bytes.

    Lines that are not what was written are left out: a killed process leaves its last one half written, and the block
    that it was for is not there, either.
    """
    found: dict[str, dict[str, Any]] = {}
    for path in sorted((store.root / RECORDS).glob("*.jsonl")):
        for row in filter(None, map(opened_row, read_records(path))):
            found[row["asset"]] = row
    return [found[name] for name in sorted(found)]


def read_records(path: Path) -> list[bytes]:
    """The lines of a file of records; none where it is no file of ours."""
    try:
        with open_own(path) as file:
            return file.read().splitlines(keepends=True)
    except InputError:
        return []


def references(files: Mapping[str, bytes]) -> list[str]:
    """The files of the store that the files of a scene name, by path from the root of the data set.

    Args:
        files: by suffix, or by name.
    """
    found: set[str] = set()
    for suffix, content in files.items():
        if suffix.endswith("usdc"):
            content = _usd_text(content)
        found |= {match.decode() for match in NAME.findall(content)}
    return sorted(found)


def _usd_text(content: bytes) -> bytes:
    """A binary stage as text."""
    import tempfile
    from pathlib import Path

    from sceneweaver.export.usd_layer import usd

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.usdc"
        write_atomic(path, content)
        return usd().Sdf.Layer.FindOrOpen(str(path)).ExportToString().encode()
