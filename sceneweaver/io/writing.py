"""Files of our own: whole or not at all, in the folder that was chosen, and never through a link to elsewhere.

What is being written lies in a temporary folder beside its place, which an advisory lock holds while its process lives.
The system frees that lock with the process, however it ends, so `sweep` tells what a killed run has left from what
another run is writing.
"""

from __future__ import annotations

import contextlib
import errno
import fcntl
import os
import secrets
import shutil
import socket
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Literal

from .errors import InputError
from .folders import Place, opened_folder, require_no_link
from .messages import clean, path_name
from .reading import reason

TEMPORARY, SUFFIX = ".sceneweaver-", ".tmp"
"""How the names of temporary folders begin and end."""


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
    name = path_name(path)
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


def open_writable(path: Place, mode: Literal["xb", "ab", "wb", "r+b"]) -> IO[bytes]:
    """A file of a folder of ours, open for writing: a regular one that no link leads to.

    What is appended is written at once, so that it stays together where several processes append.

    Raises:
        OSError: it cannot be opened, or a link, pipe or device stands there.
    """
    flags = {"xb": os.O_WRONLY | os.O_CREAT | os.O_EXCL, "ab": os.O_WRONLY | os.O_CREAT | os.O_APPEND}
    flags |= {"wb": os.O_WRONLY | os.O_CREAT, "r+b": os.O_RDWR}
    descriptor = os.open(path, flags[mode] | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, 0o666)
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise OSError(errno.EINVAL, "no regular file", os.fspath(path))
        if mode == "wb":  # only now that it is known to be one
            os.ftruncate(descriptor, 0)
        return open(descriptor, "wb" if mode == "xb" else mode, buffering=0 if mode == "ab" else -1)
    except BaseException:
        os.close(descriptor)
        raise


def bring_to_disk(path: Place) -> None:
    """Wait until what was written to a file is on the disk.

    Raises:
        OSError: the disk is full or gone.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC)
    try:
        os.fsync(descriptor)
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
        raise InputError(f"{path_name(path)}: cannot be made ({reason(error)}); choose another place") from None
    return path


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
    """Hold the lock file of ``path``, which states our process number and host, for as long as the block runs.

    A lock of a process that was killed is taken over. Where the file system knows no locks, nothing is held.

    Args:
        path: what only one process at a time may write; the lock file lies beside it and is gone at the end.
        what: names what is locked in the error, such as "--out: DIR".

    Raises:
        InputError: when another process holds it, with the number of that process.
    """
    name = _lock_of(path)
    descriptor = _locked_file(name, what)
    try:
        os.truncate(descriptor, 0)
        os.write(descriptor, f"{os.getpid()} {socket.gethostname()}\n".encode())
        yield
    finally:
        with contextlib.suppress(OSError):
            os.unlink(name)
        os.close(descriptor)


def require_unlocked(path: Place, what: str) -> None:
    """InputError when another process holds the lock of ``path``; nothing is written. Arguments as of `locked`."""
    with contextlib.suppress(OSError):
        descriptor = os.open(_lock_of(path), os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            raise InputError(f"{what} is being written by {_holder(descriptor)}; wait for it") from None
        finally:
            os.close(descriptor)


def _lock_of(path: Place) -> str:
    folder, file = os.path.split(path)
    return os.path.join(folder, f"{TEMPORARY}{file}.lock")


def _holder(descriptor: int) -> str:
    """Who holds a lock, by what its file says."""
    number, _, host = os.pread(descriptor, 320, 0).decode(errors="replace").strip().partition(" ")
    if not number.isdigit():
        return "another process"
    return f"process {number}" + (f" on {clean(host)}" if host and host != socket.gethostname() else "")


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
            holder = _holder(descriptor)
            os.close(descriptor)
            raise InputError(f"{what} is being written by {holder}; wait for it, or choose another place") from None
        with contextlib.suppress(OSError):
            if os.path.samestat(os.fstat(descriptor), os.stat(name)):  # else its last holder has just removed it
                return descriptor
        os.close(descriptor)
