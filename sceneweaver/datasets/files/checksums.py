"""Checksums of all files of a data set, as ``sha256sum -c checksums.sha256`` reads them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from sceneweaver.scene import write_atomic

from ..digests import sha256_of
from ..folder import Folder

NAMED = ("LICENSES.md", "README.md", "croissant.json")
FOLDERS = ("assets", "data", "meta")
TIMES = "meta/seconds.parquet"
"""What no two runs agree on has no checksum, so that equal data sets have equal files of checksums."""


def checksums_of(folder: Folder) -> dict[str, str]:
    """SHA-256, in hex, of shards, tables and assets by their paths relative to the root."""
    names = sorted(_names(folder.path))
    return dict(zip(names, sha256_of(folder.path, names), strict=True))


def write_checksums(folder: Folder, known: Mapping[str, str] | None = None) -> None:
    """Write a line for each file: its checksum, two blanks, its path relative to the root.

    Args:
        folder: the data set.
        known: what `checksums_of` says of it; None: that is worked out.
    """
    texts = [name for name in NAMED if (folder.path / name).exists()]
    sums = {**(checksums_of(folder) if known is None else known)}
    sums.update(zip(texts, sha256_of(folder.path, texts), strict=True))
    write_atomic(folder.checksums, "".join(f"{sums[name]}  {name}\n" for name in sorted(sums)))


def _names(root: Path) -> Iterator[str]:
    for place in FOLDERS:
        for path, folders, files in os.walk(root / place):
            folders[:] = [name for name in folders if not name.startswith(".")]
            below = Path(path).relative_to(root).as_posix()
            names = (f"{below}/{name}" for name in files if not name.startswith("."))
            yield from (name for name in names if name != TIMES)
