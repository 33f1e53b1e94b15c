"""Files that users name: only regular ones are opened, no more is read than a limit, and none is seen half written.

What is being written lies in a temporary folder beside its place, which an advisory lock holds while its process lives.
The system frees that lock with the process, however it ends, so `sweep` tells what a killed run has left from what
another run is writing.
"""

from __future__ import annotations

import contextlib
import errno
import fcntl
import gzip
import os
import secrets
import shutil
import stat
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from .errors import InputError
from .messages import clean

MAX_BYTES = 64 * 2**20
"""Largest file [bytes] that is read unless told otherwise."""

MAX_UNPACKED = 256 * 2**20
"""Most [bytes] that a compressed file may hold, unless told otherwise."""

TEMPORARY, SUFFIX = ".sceneweaver-", ".tmp"
"""How the names of temporary folders begin and end."""

Place = str | os.PathLike[str]


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
    name = clean(os.fspath(path))
    folder, file = os.path.split(os.fspath(path))
    try:
        with contextlib.ExitStack() as stack:
            if within is None:
                place, at, flags = os.fspath(path), None, 0
            else:
                place, at, flags = file, stack.enter_context(opened_folder(folder, within=within)), os.O_NOFOLLOW
                _require_no_link(place, at, name)
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
            raise InputError(f"{clean(os.fspath(path))}: cannot be read ({reason(error)}); check the disk") from None
    if len(content) > max_bytes:  # it grew since it was opened
        raise InputError(f"{clean(os.fspath(path))}: the file has more than {_megabytes(max_bytes)}")
    return content


@contextlib.contextmanager
def open_unpacked(path: Place, max_bytes: int = MAX_UNPACKED) -> Iterator[IO[bytes]]:
    """A regular file as a stream, unpacked where its name ends in ``.gz``. It may hold more than ``max_bytes``.

    Raises:
        InputError: as `open_regular`, and for a gzip file that is damaged.
    """
    name = clean(os.fspath(path))
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
            f"{clean(os.fspath(path))}: it unpacks to more than {_megabytes(max_bytes)}; split it into smaller files"
        )


@contextlib.contextmanager
def whole(path: Place, *, through_link: bool = False, within: Place | None = None) -> Iterator[Path]:
    """A temporary path, of the same file name, that takes the place of ``path`` when the block ends without an error.

    Others see the old file or the whole new one. After an error, or a kill and a `sweep`, nothing stays behind. The
    folder is opened once: the file lands in it, whatever takes its name meanwhile.

    Args:
        path: Where the file goes; its folder must be there.
        through_link: What happens where a link stands at ``path``. By default the file takes its place, so that nothing
            outside the folder changes; where a user named the link itself, the file goes to where it leads.
        within: A folder above ``path``; no folder from there on may be a link.

    Raises:
        InputError: when the folder is missing or cannot be written, ``path`` is a folder, or a link stands on the way.
    """
    name = clean(os.fspath(path))
    try:
        target = os.path.realpath(path) if through_link else os.path.abspath(path)
        folder, file = os.path.split(target)
        with opened_folder(folder, within=within) as place:
            with contextlib.suppress(FileNotFoundError):
                if stat.S_ISDIR(os.stat(file, dir_fd=place, follow_symlinks=False).st_mode):
                    raise InputError(f"{name}: this is a folder; give a file name in it, such as scene.json")
            with _temporary(folder, place) as (draft, drafts):
                yield draft / file
                descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=drafts)
                try:
                    os.fsync(descriptor)
                finally:
                    os.close(descriptor)
                os.replace(file, file, src_dir_fd=drafts, dst_dir_fd=place)
    except FileNotFoundError:
        raise InputError(f"{name}: its folder does not exist; make it first") from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: cannot be written ({reason(error)}); choose another place") from None


def write_atomic(path: Place, content: str | bytes, *, through_link: bool = False, within: Place | None = None) -> None:
    """Write a file so that others see the old one or the whole new one: temporary name, fsync, rename.

    Raises:
        InputError: as `whole`, which says what ``through_link`` and ``within`` mean.
    """
    with whole(path, through_link=through_link, within=within) as temporary, open(temporary, "wb") as file:
        file.write(content.encode("utf-8") if isinstance(content, str) else content)


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
                raise InputError(f"{clean(os.fspath(path))}: this is outside of {clean(os.fspath(within or ''))}")
            _require_no_link(part, descriptor, start)
            inner = os.open(part, flags | os.O_NOFOLLOW, dir_fd=descriptor)
            os.close(descriptor)
            descriptor = inner
        yield descriptor
    finally:
        os.close(descriptor)


def own_folder(path: Path) -> Path:
    """A folder of a run or an export, made where it is not there; what is written to it lands in it.

    Raises:
        InputError: when a link or a file stands in its place, or it cannot be made.
    """
    require_no_link(path)
    try:
        path.mkdir(exist_ok=True)
    except (OSError, ValueError) as error:
        raise InputError(f"{clean(str(path))}: cannot be made ({reason(error)}); choose another place") from None
    return path


def require_no_link(path: Path) -> None:
    """InputError when a link stands at ``path``: what is written below it would land elsewhere."""
    _require_no_link(os.fspath(path), None, os.fspath(path))


def _require_no_link(place: str, folder: int | None, name: str) -> None:
    with contextlib.suppress(FileNotFoundError):
        if stat.S_ISLNK(os.stat(place, dir_fd=folder, follow_symlinks=False).st_mode):
            raise InputError(f"{clean(name)}: this is a link to another place; remove it, or choose another folder")


@contextlib.contextmanager
def temporary_folder(parent: Place) -> Iterator[Path]:
    """A folder in ``parent`` that is gone when the block ends; see `sweep` for one whose process was killed.

    Raises:
        OSError: when it cannot be made.
    """
    with opened_folder(parent) as descriptor, _temporary(parent, descriptor) as (folder, _):
        yield folder


@contextlib.contextmanager
def _temporary(parent: Place, descriptor: int) -> Iterator[tuple[Path, int]]:
    """A temporary folder in an opened one: its path, and its own descriptor, which holds its lock."""
    while True:
        name = f"{TEMPORARY}{secrets.token_hex(8)}{SUFFIX}"
        os.mkdir(name, dir_fd=descriptor)
        try:
            lock = os.open(name, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=descriptor)
        except OSError:
            os.rmdir(name, dir_fd=descriptor)
            raise
        with contextlib.suppress(OSError):  # a file system without locks: then nobody sweeps there, either
            fcntl.flock(lock, fcntl.LOCK_EX)
        with contextlib.suppress(FileNotFoundError):  # else it was swept before it was locked
            os.stat(name, dir_fd=descriptor)
            break
        os.close(lock)
    try:
        yield Path(parent, name), lock
    finally:
        shutil.rmtree(name, ignore_errors=True, dir_fd=descriptor)
        os.close(lock)


def sweep(folder: Place) -> None:
    """Remove the temporary folders in ``folder`` whose process is no more; those in use stay."""
    for stale in Path(folder).glob(f"{TEMPORARY}*{SUFFIX}"):
        with contextlib.suppress(OSError):
            lock = os.open(stale, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(stale, ignore_errors=True)
            finally:
                os.close(lock)


@contextlib.contextmanager
def locked(path: Place, what: str) -> Iterator[None]:
    """Hold the lock file of ``path``, which states our process number, for as long as the block runs.

    A lock of a process that was killed is taken over. Where the file system knows no locks, nothing is held.

    Args:
        path: what only one process at a time may write; the lock file lies beside it and is gone at the end.
        what: names what is locked in the error, such as "--out: DIR".

    Raises:
        InputError: when another process holds it, with the number of that process.
    """
    folder, file = os.path.split(path)
    name = os.path.join(folder, f"{TEMPORARY}{file}.lock")
    descriptor = _locked_file(name, what)
    try:
        os.truncate(descriptor, 0)
        os.write(descriptor, f"{os.getpid()}\n".encode())
        yield
    finally:
        with contextlib.suppress(OSError):
            os.unlink(name)
        os.close(descriptor)


def _locked_file(name: str, what: str) -> int:
    while True:
        try:
            descriptor = os.open(name, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, 0o666)
        except OSError as error:
            raise InputError(f"{what} cannot be written ({reason(error)}); choose another place") from None
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or status.st_nlink > 1:  # to write to it would change something else
            os.close(descriptor)
            raise InputError(f"{what} cannot be written ({clean(name)} is no lock file of ours); remove that")
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno not in (errno.EAGAIN, errno.EACCES):
                return descriptor
            holder = os.read(descriptor, 32).decode(errors="replace").strip()
            os.close(descriptor)
            by = f"process {holder}" if holder.isdigit() else "another process"
            raise InputError(f"{what} is being written by {by}; wait for it, or choose another place") from None
        with contextlib.suppress(OSError):
            if os.path.samestat(os.fstat(descriptor), os.stat(name)):  # else its last holder has just removed it
                return descriptor
        os.close(descriptor)


def reason(error: BaseException) -> str:
    """What an error of the system or of a reader says, on one line."""
    text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return clean(text)[:120] or type(error).__name__


def _megabytes(count: int) -> str:
    return f"{count / 2**20:.6g} MB"
