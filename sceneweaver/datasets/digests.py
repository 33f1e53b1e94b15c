"""SHA-256: of files, by as many processes as there are cores where that is quicker, and lists of them."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import repeat
from pathlib import Path

from sceneweaver.io import InputError, read_bytes, reason, write_atomic
from sceneweaver.runtime.processes import cores, pool

from .folder import Folder
from .seals import MOST_SEAL, DamagedError, require_inside, sha256

MANY = 4096
"""Files from which on processes are worth their start."""

TOGETHER = 256
"""Files that a process is given at a time."""

DIGEST = re.compile("[0-9a-fA-F]{64}")

NAMED = ("LICENSES.md", "README.md", "croissant.json")
FOLDERS = ("assets", "data", "meta")
TIMES = "meta/seconds.parquet"
"""What no two runs agree on has no checksum, so that equal data sets have equal files of checksums."""


def sha256_of(root: Path, names: Sequence[str]) -> list[str]:
    """SHA-256 of each of some files, given by their paths relative to a folder."""
    workers = cores()
    if len(names) < MANY or workers == 1:
        return _some(root, names)
    parts = -(-len(names) // TOGETHER)
    found = [""] * len(names)
    with pool(workers) as processes:  # each takes every so-manieth, as neighbours are alike in size
        for k, some in enumerate(processes.map(_some, repeat(root), [names[k::parts] for k in range(parts)])):
            found[k::parts] = some
    return found


def _some(root: Path, names: Sequence[str]) -> list[str]:
    return [sha256(root / name) for name in names]


def content_of(files: Mapping[str, bytes]) -> tuple[str, int]:
    """Content hash and bytes of the files of a scene, by suffix, as its row has them."""
    digest, size = hashlib.sha256(), 0
    for suffix in sorted(files):
        digest.update(f"{suffix}:{len(files[suffix])}\n".encode() + files[suffix])
        size += len(files[suffix])
    return digest.hexdigest(), size


def checksums_of(folder: Folder) -> dict[str, str]:
    """SHA-256, in hex, of shards, tables and assets by their paths relative to the root."""
    names = sorted(_names(folder.path))
    return dict(zip(names, sha256_of(folder.path, names), strict=True))


def write_checksums(folder: Folder, known: Mapping[str, str] | None = None) -> None:
    """Write a line for each file: its checksum, two blanks, its path relative to the root, as `sha256sum -c` reads it.

    Args:
        folder: the data set.
        known: what `checksums_of` says of it; None: that is worked out.
    """
    texts = [name for name in NAMED if (folder.path / name).exists()]
    sums = {**(checksums_of(folder) if known is None else known)}
    sums.update(zip(texts, sha256_of(folder.path, texts), strict=True))
    write_atomic(folder.checksums, "".join(f"{sums[name]}  {name}\n" for name in sorted(sums)))


def read_checksums(folder: Folder) -> dict[str, str]:
    """The checksums that are listed, by path relative to the root.

    Raises:
        DamagedError: the list cannot be read, or a line of it is none.
    """
    try:
        text = read_bytes(folder.checksums, max_bytes=MOST_SEAL).decode()
    except (InputError, UnicodeDecodeError) as error:
        raise DamagedError(f"{folder.checksums}: cannot be read: {reason(error)}") from None
    found: dict[str, str] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        digest, _, name = line.partition(" ")
        name = name.lstrip(" *").removeprefix("./")
        if not DIGEST.fullmatch(digest) or not name:
            raise DamagedError(f"{folder.checksums}: line {number} is no checksum and path")
        require_inside(name, folder.checksums)
        found[name] = digest.lower()
    return found


def _names(root: Path) -> Iterator[str]:
    for place in FOLDERS:
        for path, folders, files in os.walk(root / place):
            folders[:] = [name for name in folders if not name.startswith(".")]
            below = Path(path).relative_to(root).as_posix()
            names = (f"{below}/{name}" for name in files if not name.startswith("."))
            yield from (name for name in names if name != TIMES)
