"""Metadata of asset libraries: each reader lists the mesh files of a folder with what is known of them.

A reader is a function from a folder to hints, and a test whether a folder is of its kind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.io import required_inside
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from ..imports.hints import Hints
from . import abo, folder, future3d, hssd, metascenes, mjcf, objathor

Read = Callable[[Path], Iterator[Hints]]


@dataclass(frozen=True)
class Reader:
    """One format: ``fits`` says whether a folder looks like it, ``read`` lists its assets."""

    name: str
    fits: Callable[[Path], bool]
    read: Read


READERS: dict[str, Reader] = {
    reader.name: reader
    for reader in (
        Reader("objathor", objathor.fits, objathor.read),
        Reader("3d-future", future3d.fits, future3d.read),
        Reader("hssd", hssd.fits, hssd.read),
        Reader("abo", abo.fits, abo.read),
        Reader("mjcf", mjcf.fits, mjcf.read),
        Reader("metascenes", metascenes.fits, metascenes.read),
        Reader("folder", folder.fits, folder.read),
    )
}


def entries(path: Path, kind: str = "auto") -> Iterator[Hints]:
    """The assets of a folder, or of one file, each once; ``kind`` names a reader, or "auto" takes the first that fits.

    Raises:
        InputError: for a folder that is not there, a reader that is unknown, one that does not fit, or an asset whose
            files lie outside of the folder.
    """
    if not path.exists():
        raise InputError(f"{path}: no such file or folder")
    if kind == "auto":
        reader = next(r for r in READERS.values() if r.fits(path))
    elif kind in READERS:
        reader = READERS[kind]
        if not reader.fits(path):
            raise InputError(f"{path}: this does not look like a folder of {kind}")
    else:
        raise InputError(f"format: '{kind}' is unknown{suggest(kind, READERS)}")
    folder = path if path.is_dir() else path.parent
    seen: set[str] = set()
    for found in reader.read(path):
        if (row := repr(found)) in seen:  # a table that names an asset twice in the same words
            continue
        seen.add(row)
        for place in (found.path, *found.hulls):
            required_inside(folder, place, found.name)
        yield found
