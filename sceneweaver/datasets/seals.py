"""Seals: what files held when they were whole, so that damage is noticed before anything is made of them.

A seal is a file with a line for each of some files: SHA-256, size [bytes], path. Its last line has the SHA-256 of the
lines before and of the name of the seal, so that a damaged seal, and one of another folder, are noticed as well.
Rows of growing files carry their seal in themselves.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import stat
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import IO, Any, NamedTuple

from sceneweaver.io import (
    InputError,
    SceneWeaverError,
    open_regular,
    read_bytes,
    reason,
    sha256_of,
    write_atomic,
)
from sceneweaver.io.messages import clean

SEAL = "seal.sha256"
"""The seal of a folder that is written whole or not at all, such as that of a block."""

MOST = 2**42
"""Largest file of a data set [bytes]."""

MOST_SEAL = 2**30
"""Largest seal or list of checksums [bytes]: some millions of files."""


class DamagedError(SceneWeaverError):
    """Files of a data set are not what was written, and cannot be made anew from what is there."""

    exit_code = 3


class Entry(NamedTuple):
    """A file in a seal: SHA-256 in hex, and size [bytes]."""

    digest: str
    size: int


def open_own(path: Path, max_bytes: int = MOST) -> IO[bytes]:
    """A file of a data set, open for reading: a regular file that is no link.

    Raises:
        InputError: as `open_regular`, and for a link.
    """
    _require_own(path)
    return open_regular(path, max_bytes)


def sha256(path: Path) -> str:
    """SHA-256 of a file of a data set, in hex; errors as `open_own`, and when it cannot be read."""
    _require_own(path)
    return sha256_of(path, max_bytes=MOST)


def _require_own(path: Path) -> None:
    if path.is_symlink():
        raise InputError(f"{clean(str(path))}: this is a link; a data set has files of its own")


def fault_of(path: Path, entry: Entry, *, full: bool = True) -> str:
    """What is wrong with a file by its seal, in a few words; empty where nothing is.

    Args:
        path: the file.
        entry: what it was.
        full: whether it is read; else only its size is looked at.
    """
    fault = kind_fault(path)
    if fault:
        return fault
    try:
        size = path.lstat().st_size
        if size != entry.size:
            return f"has {size} bytes, not {entry.size}"
        return "has other content" if full and sha256(path) != entry.digest else ""
    except (OSError, InputError) as error:
        return f"cannot be read: {reason(error)}"


def kind_fault(path: Path) -> str:
    """What a path is that is no regular file of its own, in a few words; empty for a regular file."""
    try:
        mode = path.lstat().st_mode
    except FileNotFoundError:
        return "is missing"
    except OSError as error:
        return f"cannot be read: {reason(error)}"
    if stat.S_ISREG(mode):
        return ""
    if stat.S_ISLNK(mode):
        return "is a link"
    return "is a folder" if stat.S_ISDIR(mode) else "is a pipe or a device"


def remove(path: Path) -> None:
    """Remove whatever is at a path; nothing where there is nothing. A link goes, not what it leads to."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def entry_of(path: Path) -> Entry:
    """The entry of a file as it is now."""
    return Entry(sha256(path), path.lstat().st_size)


def entry_of_bytes(content: bytes) -> Entry:
    """The entry of a file with some content."""
    return Entry(hashlib.sha256(content).hexdigest(), len(content))


def write_seal(path: Path, entries: Mapping[str, Entry]) -> None:
    """Write a seal, whole or not at all.

    Args:
        path: the seal.
        entries: of each file, by a path with "/" between its parts.
    """
    write_atomic(path, seal_text(path, entries))


def seal_text(path: Path, entries: Mapping[str, Entry]) -> str:
    """The text of a seal at a path."""
    text = "".join(f"{digest}  {size}  {name}\n" for name, (digest, size) in sorted(entries.items()))
    return text + _end(path, text)


def read_seal(path: Path) -> dict[str, Entry]:
    """The entries of a seal.

    Raises:
        DamagedError: it is missing, no regular file, or not what was written.
    """
    fault = kind_fault(path)
    if fault:
        raise DamagedError(f"{path}: {fault}")
    try:
        text = read_bytes(path, max_bytes=MOST_SEAL).decode()
    except ValueError as error:
        raise DamagedError(f"{path}: {reason(error)}") from None
    body = text[: text.rstrip("\n").rfind("\n") + 1]
    if text != body + _end(path, body):
        raise DamagedError(f"{path}: has other content")
    rows = (line.split("  ", 2) for line in body.splitlines())
    entries = {name: Entry(digest, int(size)) for digest, size, name in rows}
    for name in entries:
        require_inside(name, path)
    return entries


def require_inside(name: str, source: Path) -> None:
    """Refuse a path that leads out of the folder that it is relative to.

    Raises:
        DamagedError: with the name of the file that has it.
    """
    parts = PurePosixPath(name).parts
    if not parts or ".." in parts or "\0" in name or PurePosixPath(name).is_absolute():
        raise DamagedError(f"{source}: names {clean(name)!r}, which is no path within the data set")


def _end(path: Path, body: str) -> str:
    digest = hashlib.sha256(f"{body}{path.parent.name}/{path.name}".encode()).hexdigest()
    return f"{digest}  {len(body.encode())}  {path.parent.name}/{path.name}\n"


def seal_folder(folder: Path) -> None:
    """Write the seal of a folder: of all its files, as the last of them."""
    write_seal(folder / SEAL, {name: entry_of(folder / name) for name in sorted(_files(folder)) if name != SEAL})


def folder_fault(folder: Path) -> str:
    """What is wrong with a sealed folder, in a few words; empty where it holds what was written, and nothing else."""
    try:
        entries = read_seal(folder / SEAL)
        more = set(_files(folder)) - {SEAL} - entries.keys()
    except (DamagedError, OSError) as error:
        return reason(error).removeprefix(f"{folder}/")
    for name, entry in entries.items():
        if fault := fault_of(folder / name, entry):
            return f"{name} {fault}"
    return f"{min(more)} is no part of it" if more else ""


def _files(folder: Path) -> Iterator[str]:
    """All that lies in a folder but folders, by relative paths; links are not followed."""
    for place, folders, files in os.walk(folder):
        below = Path(place).relative_to(folder)
        links = [name for name in folders if Path(place, name).is_symlink()]
        yield from ((below / name).as_posix() for name in (*files, *links))


DIGEST = "sha256"
"""The field of a row that has the SHA-256 of the others."""


def sealed_row(row: Mapping[str, Any]) -> dict[str, Any]:
    """A row with its own SHA-256."""
    plain = {name: value for name, value in row.items() if name != DIGEST}
    return {**plain, DIGEST: _digest(plain)}


def opened_row(line: bytes) -> dict[str, Any] | None:
    """The row of a line of JSON that `sealed_row` made, without its SHA-256; None where it is another."""
    try:
        row = json.loads(line)
        digest = row.pop(DIGEST)
        return row if digest == _digest(row) else None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None


def _digest(row: Mapping[str, Any]) -> str:
    return hashlib.sha256(json.dumps(row, ensure_ascii=False, sort_keys=True).encode()).hexdigest()
