"""Scenes of designs that were made before, read from their folders."""

from __future__ import annotations

import gzip
from collections.abc import Sequence
from pathlib import Path

from sceneweaver.scene import Scene


def design_files(paths: Sequence[Path]) -> dict[str, Path]:
    """The scene files of some designs by name: files, folders of a design, or folders of such folders or files.

    Raises:
        ValueError: there is no scene in one of them.
    """
    found: dict[str, Path] = {}
    for path in paths:
        files = [path] if path.is_file() else _within(path)
        if not files:
            raise ValueError(f"designs: {path} holds no scene.json and no scene files")
        for file in files:
            name = (
                file.parent.name if file.name == "scene.json" else file.name.removesuffix(".gz").removesuffix(".json")
            )
            unique = name if name not in found else f"{name} ({sum(k.split(' (')[0] == name for k in found) + 1})"
            found[unique] = file
    return found


def _within(folder: Path) -> list[Path]:
    """The scenes of a folder; those of the steps of a design are not designs."""
    scenes = [p for p in sorted(folder.rglob("scene.json")) if "steps" not in p.relative_to(folder).parts]
    return scenes or sorted([*folder.glob("*.json"), *folder.glob("*.json.gz")])


def read_scene(path: Path) -> Scene:
    """The scene of a file, packed or not."""
    return Scene.loads(gzip.decompress(path.read_bytes())) if path.suffix == ".gz" else Scene.load(path)
