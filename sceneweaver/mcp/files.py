"""Files that the server writes, and which files are its own: only those are ever replaced."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sceneweaver.io import locked, parse_json, read_bytes, sha256_of, sweep, temporary_folder, write_atomic
from sceneweaver.scene import InputError

from .paths import Folder, holds_links

LEDGER = ".sceneweaver-mcp.json"
"""What the server has written: names with the digests of what they held."""

MOST_NOTED = 20_000
"""Files that the ledger remembers, the latest."""

RUNS = {"state.json": "sceneweaver.run/1", "run.json": "sceneweaver.home-run/1"}
"""Files of the state of a design of a room, and of a home, with the schemas that they name."""

FIRST = {"state.json": {"steps"}, "run.json": {"rooms"}}
"""Folders that such a design makes before it writes its state."""


class Files:
    """Writes files below a folder, and remembers which are its own.

    A file counts as ours as long as it holds what we wrote. Anything else in its place is somebody's and stays.
    """

    def __init__(self, folder: Folder) -> None:
        self.folder = folder

    def write(self, name: str, content: bytes, field: str, suffix: str = "") -> Path:
        """Write one file, whole or not at all, with the folders above it.

        Raises:
            InputError: for a name that is refused, or in whose place there is a file that is not ours.
        """
        path = self.folder.to_write(name, field, suffix)
        if path.exists() and not self._ours([path]):
            raise InputError(f"{field}: '{name}' is there and is not from this server; give another name")
        self._make(path.parent, field)
        write_atomic(path, content)
        self._note([path])
        return path

    @contextmanager
    def new_folder(self, name: str, field: str) -> Iterator[Path]:
        """An empty folder to fill, that takes the place of ``name`` when the block ends without an error.

        Raises:
            InputError: for a name that is refused, or where there is a folder with anything that is not ours.
        """
        path = self.folder.to_write(name, field)
        if path.exists() and not (path.is_dir() and self._ours(_files_below(path))):
            raise InputError(f"{field}: '{name}' is there and holds other things; give another name")
        self._make(path.parent, field)
        with temporary_folder(path.parent) as draft:
            new = draft / "new"
            new.mkdir()
            yield new
            if path.exists():
                path.rename(draft / "old")
            new.rename(path)
        self._note(_files_below(path))

    def run_folder(self, name: str, field: str, state: str = "state.json") -> Path:
        """The folder of a design: a new one, an empty one, or that of a run whose file of state is of this name.

        Raises:
            InputError: for a name that is refused, or a folder that holds other things, or links.
        """
        path = self.folder.to_write(name, field)
        if path.exists():
            if not path.is_dir():
                raise InputError(f"{field}: '{name}' is a file; give another name")
            if any(path.iterdir()) and not _is_run(path, state):
                raise InputError(f"{field}: '{name}' is there and holds other things; give another name")
            if holds_links(path):
                raise InputError(f"{field}: '{name}' holds links; give another name")
        self._make(path.parent, field)
        return path

    def free_name(self, stem: str) -> str:
        """The first of ``stem``-1, ``stem``-2, ... that is not there."""
        return next(name for k in range(1, 10**6) if not os.path.lexists(self.folder.root / (name := f"{stem}-{k}")))

    def _make(self, folder: Path, field: str) -> None:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"{field}: its folder cannot be made ({error.strerror}); give another name") from None

    def _ours(self, paths: list[Path]) -> bool:
        """Whether all these files hold what we wrote."""
        noted = self._noted()
        return all(not p.is_symlink() and noted.get(self.folder.shown(p)) == _digest(p) for p in paths)

    def _noted(self) -> dict[str, Any]:
        try:
            data = parse_json(read_bytes(self.folder.root / LEDGER))
        except InputError:
            return {}
        return data if isinstance(data, dict) else {}

    def _note(self, paths: list[Path]) -> None:
        noted = self._noted()
        for path in paths:
            name = self.folder.shown(path)
            noted.pop(name, None)
            noted[name] = _digest(path)
        kept = dict(list(noted.items())[-MOST_NOTED:])
        write_atomic(self.folder.root / LEDGER, json.dumps(kept, indent=0, ensure_ascii=False) + "\n")


def tidy(folder: Path) -> None:
    """Clear away what a process that was ended in the middle has left in a folder: temporary files, and its lock."""
    if folder.is_dir():
        with contextlib.suppress(OSError, InputError):
            for each in (folder, folder / "views", *folder.glob("steps/*"), *folder.glob("rooms/*")):
                sweep(each)
            for name in ("scene.json", "home.json"):
                with locked(folder / name, "the folder"):
                    pass


def _is_run(folder: Path, state: str) -> bool:
    if not (folder / state).exists():
        return {p.name for p in folder.iterdir()} <= FIRST[state]  # a run that ended before its first step
    try:
        data = parse_json(read_bytes(folder / state))
    except InputError:
        return False
    return isinstance(data, dict) and data.get("schema") == RUNS[state]


def _files_below(folder: Path) -> list[Path]:
    return [Path(at, name) for at, _, names in os.walk(folder) for name in names]


def _digest(path: Path) -> str:
    return sha256_of(path)
