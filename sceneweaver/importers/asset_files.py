"""Meshes and labels in a folder of assets: which file shows an asset of a given id, and what it is called there."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from sceneweaver.assets.imports.hints import Hints
from sceneweaver.assets.readers import READERS
from sceneweaver.io import InputError, load_json

MAX_FILES = 1_000_000
"""Files of a folder that are looked at."""

_RANK = {".glb": 0, ".gltf": 1, ".obj": 2, ".ply": 3, ".stl": 4}
_PLAIN = ("raw_model", "normalized_model", "model", "mesh", "textured", "object", "scene", "visual")
"""Names of files that say nothing: the asset is called like the folder."""

_TABLES = ("3d-future", "hssd", "objathor", "abo")
"""Readers of `sceneweaver.assets.readers` that know categories from a table beside the meshes."""


@dataclass(frozen=True)
class AssetFile:
    """What a folder of assets knows of one: its mesh, its label, and its up and front axis where a table says them."""

    mesh: Path | None = None
    label: str = ""
    up: str | None = None
    front: str | None = None


class AssetFiles:
    """The assets of a folder by id, however it is laid out.

    ``<id>.glb`` anywhere below it (also OBJ, PLY, STL and glTF), and files of no name of their own such as
    ``<id>/raw_model.obj``. Labels come from the tables of 3D-FUTURE, HSSD, Objathor and ABO, or from the
    ``<id>/data.json`` of LayoutVLM and of our own exports.
    """

    def __init__(self, folder: Path):
        if not folder.is_dir():
            raise InputError(f"--asset-folder: {folder} is no folder")
        self._hints = _hints(folder)
        self._meshes = _meshes(folder)

    def find(self, asset: str) -> AssetFile:
        """What is known of an asset; its id may have a source before it, as in ``3dfModel.<id>``."""
        for name in dict.fromkeys((asset, asset.rpartition(".")[2], asset.rpartition("/")[2])):
            hints, mesh = self._hints.get(name.lower()), self._meshes.get(name.lower())
            if hints is not None:
                return AssetFile(hints.path, hints.category or hints.description, hints.up, hints.front)
            if mesh is not None:
                return AssetFile(mesh, _label(mesh, name))
        return AssetFile()


@lru_cache(maxsize=4)
def asset_files(folder: Path | None) -> AssetFiles | None:
    """The assets of a folder, which is looked at once; None where there is none."""
    return None if folder is None else AssetFiles(folder)


def _hints(folder: Path) -> dict[str, Hints]:
    found: dict[str, Hints] = {}
    for name in _TABLES:
        reader = READERS[name]
        try:
            if reader.fits(folder):
                for hints in reader.read(folder):
                    stem = hints.path.stem
                    found.setdefault((hints.path.parent.name if stem.lower() in _PLAIN else stem).lower(), hints)
        except InputError:  # a table that is damaged says nothing; the meshes are there still
            continue
    return found


def _meshes(folder: Path) -> dict[str, Path]:
    found: dict[str, Path] = {}
    seen = 0
    for here, folders, files in os.walk(folder):
        folders.sort()
        for file in sorted(files):
            seen += 1
            if seen > MAX_FILES:
                raise InputError(
                    f"--asset-folder: {folder} holds more than {MAX_FILES} files; give the one of the assets"
                )
            place = Path(here) / file
            rank = _RANK.get(place.suffix.lower())
            if rank is None:
                continue
            name = (place.parent.name if place.stem.lower() in _PLAIN else place.stem).lower()
            other = found.get(name)
            if other is None or rank < _RANK[other.suffix.lower()]:
                found[name] = place
    return found


def _label(mesh: Path, name: str) -> str:
    for place in (mesh.with_name("data.json"), mesh.with_name(f"{name}.json")):
        if not place.is_file():
            continue
        try:
            data = load_json(place)
        except InputError:
            continue
        notes = data.get("annotations", data) if isinstance(data, dict) else {}
        for key in ("category", "label", "name") if isinstance(notes, dict) else ():
            if isinstance(notes.get(key), str) and notes[key]:
                return notes[key]
    return ""
