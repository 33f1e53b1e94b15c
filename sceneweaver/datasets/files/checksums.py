"""Checksums of all files of a data set, as ``sha256sum -c checksums.sha256`` reads them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from sceneweaver.scene import write_atomic

from ..folder import Folder

NAMED = ("LICENSES.md", "README.md", "croissant.json")
FOLDERS = ("assets", "data", "meta")
TIMES = "meta/seconds.parquet"
"""What no two runs agree on has no checksum, so that equal data sets have equal files of checksums."""


def sha256(path: Path) -> str:
    """SHA-256 of a file, in hex."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write_checksums(folder: Folder) -> None:
    """Write a line for each file: its checksum, two blanks, its path relative to the root."""
    names = sorted(_names(folder.path))
    with ThreadPoolExecutor(4) as pool:
        sums = pool.map(lambda name: sha256(folder.path / name), names)
        write_atomic(folder.checksums, "".join(f"{digest}  {name}\n" for digest, name in zip(sums, names, strict=True)))


def _names(root: Path) -> Iterator[str]:
    yield from (name for name in NAMED if (root / name).exists())
    for folder in FOLDERS:
        for path in (root / folder).rglob("*"):
            name = path.relative_to(root).as_posix()
            if path.is_file() and name != TIMES and not any(part.startswith(".") for part in name.split("/")):
                yield name
