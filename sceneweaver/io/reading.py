"""Files that somebody else may have written: only regular ones are opened, and no more is read than a limit."""

from __future__ import annotations

import contextlib
import gzip
import hashlib
import os
import stat
import zlib
from collections.abc import Iterator
from typing import IO

from .errors import InputError
from .folders import Place, opened_folder, require_no_link
from .messages import clean, path_name

MAX_BYTES = 64 * 2**20
"""Largest file [bytes] that is read unless told otherwise."""

MAX_UNPACKED = 256 * 2**20
"""Most [bytes] that a compressed file may hold, unless told otherwise."""


def open_regular(path: Place, max_bytes: int = MAX_BYTES, *, within: Place | None = None) -> IO[bytes]:
    """A regular file of at most ``max_bytes``, open for reading. Never waits, as opening a pipe would.

    Args:
        path: The file.
        max_bytes: A larger one is refused.
        within: A folder above it, from which on no link is followed; None: links are.

    Raises:
        InputError: when it is missing, no regular file (a folder, pipe, socket or device), too large, or unreadable;
            where a link is, and none may be.
    """
    name = path_name(path)
    folder, file = os.path.split(os.fspath(path))
    try:
        with contextlib.ExitStack() as stack:
            if within is None:
                place, at, flags = os.fspath(path), None, 0
            else:
                place, at, flags = file, stack.enter_context(opened_folder(folder, within=within)), os.O_NOFOLLOW
                require_no_link(place, at, name)
            _require_readable(os.stat(place, dir_fd=at), name, max_bytes)
            descriptor = os.open(place, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC | flags, dir_fd=at)
        try:
            _require_readable(os.fstat(descriptor), name, max_bytes)  # another file may have taken its place
            return open(descriptor, "rb")
        except BaseException:
            os.close(descriptor)
            raise
    except FileNotFoundError:
        raise InputError(f"{name}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: cannot be read ({reason(error)}); check the path and its permissions") from None


def _require_readable(status: os.stat_result, name: str, max_bytes: int) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise InputError(f"{name}: this is a folder; give the file in it, such as scene.json")
    if not stat.S_ISREG(status.st_mode):
        raise InputError(f"{name}: this is a pipe or a device; give a regular file")
    if status.st_size > max_bytes:
        raise InputError(f"{name}: the file has {_megabytes(status.st_size)}; at most {_megabytes(max_bytes)} are read")


def read_bytes(path: Place, *, max_bytes: int = MAX_BYTES, within: Place | None = None) -> bytes:
    """The content of a regular file of at most ``max_bytes``; a larger one is refused before it is read.

    Raises:
        InputError: as `open_regular`, which says what ``within`` means.
    """
    with open_regular(path, max_bytes, within=within) as file:
        try:
            content = file.read(max_bytes + 1)
        except OSError as error:
            raise InputError(f"{path_name(path)}: cannot be read ({reason(error)}); check the disk") from None
    if len(content) > max_bytes:  # it grew since it was opened
        raise InputError(f"{path_name(path)}: the file has more than {_megabytes(max_bytes)}")
    return content


def read_text(path: Place, *, max_bytes: int = MAX_BYTES) -> str:
    """The text of a regular file in UTF-8, as `read_bytes` reads it.

    Raises:
        InputError: as `open_regular`, and when it is no UTF-8.
    """
    try:
        return read_bytes(path, max_bytes=max_bytes).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        name = path_name(path)
        raise InputError(f"{name}: not UTF-8 text (byte {error.start}); save the file as UTF-8") from None


def sha256_of(path: Place, *, max_bytes: int = 2**62) -> str:
    """SHA-256 of a regular file, as hexadecimal digits; errors as `read_bytes`."""
    with open_regular(path, max_bytes) as file:
        try:
            return hashlib.file_digest(file, "sha256").hexdigest()  # pyright: ignore[reportArgumentType]
        except OSError as error:
            raise InputError(f"{path_name(path)}: cannot be read ({reason(error)}); check the disk") from None


@contextlib.contextmanager
def open_unpacked(path: Place, max_bytes: int = MAX_UNPACKED) -> Iterator[IO[bytes]]:
    """A regular file as a stream, unpacked where its name ends in ``.gz``. It may hold more than ``max_bytes``.

    Raises:
        InputError: as `open_regular`, and for a gzip file that is damaged.
    """
    name = path_name(path)
    with open_regular(path, max_bytes) as packed:
        try:
            yield gzip.GzipFile(fileobj=packed) if name.endswith(".gz") else packed  # pyright: ignore[reportReturnType]
        except (gzip.BadGzipFile, EOFError, zlib.error) as error:
            raise InputError(f"{name}: not readable as gzip ({reason(error)}); fetch it anew") from None


def read_unpacked(path: Place, *, max_bytes: int = MAX_UNPACKED) -> bytes:
    """The content of a file, unpacked where its name ends in ``.gz``; no more than ``max_bytes`` are ever unpacked.

    Raises:
        InputError: as `open_unpacked`, and when it holds more.
    """
    with open_unpacked(path, max_bytes) as file:
        content = file.read(max_bytes + 1)
    _require_fewer(len(content), path, max_bytes)
    return content


def lines_unpacked(path: Place, *, max_bytes: int = MAX_UNPACKED) -> Iterator[bytes]:
    """The lines of a file, one by one, unpacked where its name ends in ``.gz``; errors as `read_unpacked`."""
    done = 0
    with open_unpacked(path, max_bytes) as file:
        while line := file.readline(max_bytes + 1):
            done += len(line)
            _require_fewer(done, path, max_bytes)
            yield line


def _require_fewer(size: int, path: Place, max_bytes: int) -> None:
    if size > max_bytes:
        raise InputError(
            f"{path_name(path)}: it unpacks to more than {_megabytes(max_bytes)}; split it into smaller files"
        )


def reason(error: BaseException) -> str:
    """What an error of the system or of a reader says, on one line."""
    text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return clean(text)[:120] or type(error).__name__


def _megabytes(count: int) -> str:
    return f"{count / 2**20:.6g} MB"
