"""Where the library keeps what it can make again, and what a user taught it: one place decides, for all floors.

The usual places are those of the XDG base directories. Where one cannot be made or written (a home that is read-only or
not there, a file in its place, a full disk), a temporary folder of the user takes its place, and one line says so.
"""

from __future__ import annotations

import atexit
import contextlib
import logging
import multiprocessing
import os
import shutil
import stat
import tempfile
from functools import cache
from pathlib import Path

log = logging.getLogger(__name__)

ROOM = 64 * 2**20
"""Bytes that a disk has to have free where something is kept."""

SHARED_MEMORY = "/dev/shm"
"""Where temporary folders go when the usual place for them is full as well."""

NO_HOME = "/dev/null/home"
"""Stands for the home of a user who has none; it cannot be made."""

_told = False


def cache_place(name: str) -> Path:
    """Where the library keeps what it can make again: ``$XDG_CACHE_HOME``, else ``~/.cache``; nothing is made.

    Args:
        name: of the cache, such as "sceneweaver/textures".
    """
    return _place("XDG_CACHE_HOME", ".cache", name)


def data_place(name: str) -> Path:
    """Where what a user taught is kept: ``$XDG_DATA_HOME``, else ``~/.local/share``; nothing is made."""
    return _place("XDG_DATA_HOME", ".local/share", name)


def places(usual: Path) -> tuple[Path, ...]:
    """The folders to look in for what is kept at a usual place: that one, and the one that stands in for it."""
    return (usual, _own_folder() / _key(usual)) if _own_is_there() else (usual,)


def kept_in(usual: Path) -> Path:
    """The one folder of what is read much more often than written: the usual place wherever something is there.

    Nothing is made. Where the usual place is not there and cannot be made, it is what stands in for it.
    """
    if os.path.isdir(usual) or _could_be_made(usual):
        return usual
    try:
        return writable(usual)
    except OSError:
        return usual


def writable(usual: Path, trouble: str = "") -> Path:
    """A folder to write to: the usual one, made if need be, or the one that stands in for it.

    Args:
        usual: where things are kept, as long as that can be written.
        trouble: why it cannot, where that is known already.

    Raises:
        OSError: neither can be written.
    """
    why = trouble or _why_not(usual)
    if not why:
        return usual
    for root in _temporary_roots():
        folder = root / _key(usual)
        if folder != usual and not _why_not(folder):
            _tell(usual, why, root)
            return folder
    raise OSError(f"{usual} cannot be written ({why}), and neither can a temporary folder; set TMPDIR to one that can")


def _place(variable: str, below_home: str, name: str) -> Path:
    """A place of the XDG base directories; relative values count as not set, as their specification says."""
    given = os.environ.get(variable, "")
    if os.path.isabs(given):
        return Path(given, name)
    return Path(_home(), below_home, name)


def _home() -> str:
    """The home of the user, by the system's list of users where ``$HOME`` is not set; `NO_HOME` where there is none."""
    home = os.path.expanduser("~")
    return home if os.path.isabs(home) and home != "/" else NO_HOME


def _why_not(folder: Path) -> str:
    """Why a folder cannot be made or written; empty where it can. It is there then."""
    try:
        _require_home(folder)
        folder.mkdir(parents=True, exist_ok=True)
        if not os.access(folder, os.W_OK | os.X_OK):
            return "it is read-only"
        disk = os.statvfs(folder)
    except (OSError, ValueError) as error:
        return getattr(error, "strerror", None) or str(error)
    return "" if disk.f_bavail * disk.f_frsize >= ROOM else "the disk is full"


def _could_be_made(folder: Path) -> bool:
    """Whether there is a folder above that can be written to."""
    try:
        _require_home(folder)
    except OSError:
        return False
    above = next(place for place in folder.parents if os.path.lexists(place) or place == place.parent)
    return os.path.isdir(above) and os.access(above, os.W_OK | os.X_OK)


def _require_home(folder: Path) -> None:
    """FileNotFoundError for a place in a home that is not there: nobody wants that made."""
    home = _home()
    if folder.is_relative_to(home) and not os.path.isdir(home):
        raise FileNotFoundError(2, "there is no home folder")


def _key(usual: Path) -> Path:
    """The path in a temporary folder of what stands in for a place."""
    return Path(*usual.parts[-2:])


def _temporary_roots() -> list[Path]:
    """Folders of this user alone, the best first."""
    found = []
    for parent in (_temporary(), SHARED_MEMORY):
        root = _private(parent)
        if root is not None and root not in found:
            found.append(root)
    return found


def _own_folder() -> Path:
    return Path(_temporary(), f"sceneweaver-{_user()}")


def _own_is_there() -> bool:
    return _is_private(_own_folder())


def _temporary() -> str:
    try:
        return tempfile.gettempdir()
    except FileNotFoundError:
        return SHARED_MEMORY


def _private(parent: str) -> Path | None:
    """A folder below ``parent`` that nobody else can write to: the user's, or one of this process alone."""
    folder = Path(parent, f"sceneweaver-{_user()}")
    with contextlib.suppress(OSError):
        folder.mkdir(mode=0o700, exist_ok=True)
    if _is_private(folder):
        return folder
    return _of_this_process(parent)


@cache
def _of_this_process(parent: str) -> Path | None:
    """A folder that is gone when this process ends; None where none can be made."""
    try:
        folder = tempfile.mkdtemp(prefix="sceneweaver-", dir=parent)
    except OSError:
        return None
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


def _is_private(folder: Path) -> bool:
    """Whether it is a folder, no link, of this user, and closed to all others."""
    try:
        found = os.lstat(folder)
    except OSError:
        return False
    return stat.S_ISDIR(found.st_mode) and found.st_uid == _user() and not found.st_mode & 0o077


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0


def _tell(usual: Path, why: str, root: Path) -> None:
    """One line a run: a process that works for another leaves it to that one."""
    global _told
    if _told:
        return
    _told = True
    line = "%s cannot be written (%s): caches go to %s for now; set XDG_CACHE_HOME to a folder that can be written"
    level = logging.INFO if multiprocessing.parent_process() is not None else logging.WARNING
    log.log(level, line, usual, why, root)
