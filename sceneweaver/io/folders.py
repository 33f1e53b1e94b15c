"""Folders as descriptors: what is opened once stays that folder, and no link leads out of one of ours."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Iterator
from pathlib import Path

from .errors import InputError
from .messages import clean, path_name

Place = str | os.PathLike[str]


@contextlib.contextmanager
def opened_folder(path: Place, *, within: Place | None = None) -> Iterator[int]:
    """The descriptor of a folder, for calls that take a ``dir_fd``: it stays that folder, whatever takes its name.

    Args:
        path: The folder.
        within: A folder above it, or itself, from which on no link is followed; None: links are.

    Raises:
        InputError: when a link or a file stands where there has to be a folder below ``within``.
        OSError: when it cannot be opened.
    """
    flags = os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC
    start = os.fspath(path) if within is None else os.fspath(within)
    below = () if within is None else Path(os.path.relpath(path, within)).parts
    descriptor = os.open(start or ".", flags)
    try:
        for part in below:
            start = os.path.join(start, part)
            if part == os.pardir:
                raise InputError(f"{path_name(path)}: this is outside of {clean(os.fspath(within or ''))}")
            require_no_link(part, descriptor, start)
            inner = os.open(part, flags | os.O_NOFOLLOW, dir_fd=descriptor)
            os.close(descriptor)
            descriptor = inner
        yield descriptor
    finally:
        os.close(descriptor)


def require_no_link(path: Place, folder: int | None = None, name: str | None = None) -> None:
    """InputError when a link stands at a path: what is written below it would land elsewhere.

    Args:
        path: The path, relative to ``folder`` if that is given.
        folder: Descriptor of an opened folder.
        name: What to call it; None: its path.
    """
    with contextlib.suppress(FileNotFoundError):
        if stat.S_ISLNK(os.stat(path, dir_fd=folder, follow_symlinks=False).st_mode):
            shown = clean(os.fspath(path) if name is None else name)
            raise InputError(f"{shown}: this is a link to another place; remove it, or choose another folder")
