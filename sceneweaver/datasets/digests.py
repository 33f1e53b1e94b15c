"""SHA-256 of many files, by as many processes as there are cores where that is quicker."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from itertools import repeat
from pathlib import Path

from sceneweaver.runtime.processes import cores, pool

MANY = 4096
"""Files from which on processes are worth their start."""

TOGETHER = 256
"""Files that a process is given at a time."""


def sha256(path: Path) -> str:
    """SHA-256 of a file, in hex."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


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
