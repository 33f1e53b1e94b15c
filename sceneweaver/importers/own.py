"""Scene files of ours among others: how they are told and read."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from sceneweaver.io import InputError, open_regular
from sceneweaver.io.messages import path_name
from sceneweaver.scene import Scene

OWN = "scene"
"""The name of our own format, for ``--from``."""

_HEAD = 4096
_MARK = b'"sceneweaver.scene/'


def is_own(path: Path) -> bool:
    """Whether a file begins like a scene of ours."""
    try:
        with open_regular(path, 2**62) as file:
            return _MARK in file.read(_HEAD)
    except (InputError, OSError):
        return False


def own_files(path: Path) -> list[Path]:
    """The scene files of ours that a path holds, by name; of a design's folder only its scene.

    Raises:
        InputError: there is nothing at the path.
    """
    if not path.exists():
        raise InputError(f"{path_name(path)}: no such file or folder")
    if not path.is_dir():
        return [path] if is_own(path) else []
    found: list[Path] = []
    for folder, folders, files in os.walk(path):
        folders.sort()
        here = Path(folder)
        if "scene.json" in files and is_own(here / "scene.json"):
            folders.clear()  # its steps are no scenes of their own
            found.append(here / "scene.json")
        else:
            found += [here / name for name in sorted(files) if name.endswith(".json") and is_own(here / name)]
    return found


def own_scenes(files: Sequence[Path], on_error: Callable[[str], None] | None) -> Iterator[tuple[Path, Scene]]:
    """Each file with its scene; a broken one is told to ``on_error`` and passed over, or raised where that is None."""
    for file in files:
        try:
            scene = Scene.load(file)
        except InputError as error:
            if on_error is None:
                raise
            on_error(str(error))
            continue
        yield file, scene
