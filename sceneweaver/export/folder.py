"""Folders that are there whole or not at all: written under a temporary name beside their place, then renamed."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from sceneweaver.io import open_writable, opened_folder, require_no_link, temporary_folder
from sceneweaver.runtime.threads import map_threads
from sceneweaver.scene import InputError

_WRITERS = 16  # files that wait for the disk at once


def write_folder(target: Path, files: Mapping[str, bytes], ours: Callable[[set[str]], bool]) -> None:
    """Write a folder whole; an older export of the same kind in its place is replaced.

    Args:
        target: Where it goes; its parent must be there.
        files: Contents by path relative to the folder, at most one folder deep.
        ours: Whether a folder that holds these names is an export of this kind, and so may be replaced.

    Raises:
        InputError: the place cannot be written, or holds something else; nothing has changed then.
    """
    with staged(target) as draft:
        if target.exists() and not (target.is_dir() and ours({p.name for p in target.iterdir()})):
            raise InputError(f"folder: {target} is there and holds other things; give a new or empty folder")
        new, old = draft / "new", draft / "old"
        new.mkdir()
        fill(new, files)
        try:
            if target.exists():
                target.rename(old)
            new.rename(target)
        except OSError:
            if old.exists() and not target.exists():
                with contextlib.suppress(OSError):
                    old.rename(target)
            raise


@contextmanager
def staged(target: Path, field: str = "folder") -> Iterator[Path]:
    """A temporary folder beside ``target``, gone at the end; its errors become InputErrors on ``field``."""
    try:
        if not target.parent.is_dir():
            raise InputError(f"{field}: {target.parent} is no folder; make it first")
        with temporary_folder(target.parent) as draft:
            yield draft
    except InputError:
        raise
    except (OSError, ValueError) as error:  # a path with a zero byte is a ValueError
        reason = (error.strerror if isinstance(error, OSError) else None) or type(error).__name__
        raise InputError(f"{field}: {target} cannot be written ({reason}); choose another place") from None


def write_beside(path: Path, files: Mapping[str, bytes], stale: Mapping[str, str]) -> None:
    """Write a file, which comes last, and those that it names, in a folder that holds other things as well.

    Args:
        path: The file; its folder must be there.
        files: Contents by path relative to that folder, the file's own among them.
        stale: By folder there, a pattern of paths in it that exports of this kind have; those that this one has not, of
            an export that it replaces, are removed.

    Raises:
        InputError: the place cannot be written; each file is whole or as it was before.
    """
    with staged(path, "path") as draft:
        if path.is_dir():
            raise InputError(f"path: {path} is a folder; give a file name in it")
        for folder in stale:
            require_no_link(path.parent / folder)
        fill(draft, files)
        move(draft, sorted(files, key=lambda name: name == path.name), path.parent)
    for folder, pattern in stale.items():
        for left in (path.parent / folder).rglob("*"):
            ours = re.fullmatch(pattern, left.relative_to(path.parent / folder).as_posix())
            if ours and left.relative_to(path.parent).as_posix() not in files:
                with opened_folder(left.parent, within=path.parent) as descriptor:
                    os.unlink(left.name, dir_fd=descriptor)


def fill(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files below a folder that is there."""
    for parent in {(folder / name).parent for name in files}:
        parent.mkdir(parents=True, exist_ok=True)

    def write(name: str) -> None:
        with open_writable(folder / name, "wb") as file:
            file.write(files[name])
            file.flush()
            os.fsync(file.fileno())

    map_threads(write, files, _WRITERS)


def move(draft: Path, names: Sequence[str], home: Path) -> None:
    """Give files their final names, one after the other; when one fails, those that were not there before go again.

    Args:
        draft: The folder in which they lie.
        names: Their paths relative to it, and to ``home``.
        home: Where they go; folders below it are made where they are not there, and none may be a link.

    Raises:
        InputError: when a link or a file stands where a folder has to be.
        OSError: when one cannot be moved.
    """
    fresh: list[Path] = []
    try:
        for place in (home / name for name in names):
            for folder in [p for p in reversed(place.parents) if home in p.parents]:
                if not os.path.lexists(folder):
                    folder.mkdir()
                    fresh.append(folder)
            if not os.path.lexists(place):
                fresh.append(place)
            with opened_folder(place.parent, within=home) as descriptor:
                os.replace(draft / place.relative_to(home), place.name, dst_dir_fd=descriptor)
    except (OSError, ValueError):
        for path in reversed(fresh):
            with contextlib.suppress(OSError, ValueError):
                path.rmdir() if path.is_dir() else path.unlink()
        raise
