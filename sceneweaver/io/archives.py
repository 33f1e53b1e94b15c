"""Zip, NumPy and tar archives that somebody else made: regular members with plain names, bounded before they unpack."""

from __future__ import annotations

import contextlib
import os
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import IO, TYPE_CHECKING

from .errors import InputError
from .messages import clean, quote
from .reading import Place, open_regular, reason

if TYPE_CHECKING:
    import numpy as np

MAX_BYTES = 2**30
"""Largest archive [bytes], and the most that it may unpack to, unless told otherwise."""

MAX_MEMBERS = 100_000
"""Files in an archive that is read into memory."""

TAR_BYTES = 2**40
"""Largest tar [bytes]: those of a data set are read member by member."""

TAR_MEMBER = 2**30
"""Largest member [bytes] of a tar."""


def is_plain_name(name: str) -> bool:
    """Whether a name of a file in an archive or a table stays in its folder: relative, with no ``..``, one line."""
    parts = PurePosixPath(name).parts
    return bool(parts) and not name.startswith("/") and ".." not in parts and "\\" not in name and name == clean(name)


@contextlib.contextmanager
def open_zip(path: Place, *, max_bytes: int = MAX_BYTES) -> Iterator[zipfile.ZipFile]:
    """A zip archive that unpacks to at most ``max_bytes``.

    Raises:
        InputError: as `open_regular`; damaged, too many members, too large, a name that leads out of it.
    """
    name = os.path.basename(os.fspath(path))
    with open_regular(path, max_bytes) as file:
        try:
            with zipfile.ZipFile(file) as packed:
                entries = packed.infolist()
                if len(entries) > MAX_MEMBERS:
                    raise InputError(f"{name}: it holds {len(entries)} files; at most {MAX_MEMBERS} are read")
                if sum(entry.file_size for entry in entries) > max_bytes:
                    raise InputError(f"{name}: it unpacks to more than {max_bytes >> 20} MiB")
                for entry in entries:
                    if not is_plain_name(entry.filename):
                        raise InputError(f"{name}: {quote(entry.filename)} is no name of a file in it; pack it anew")
                yield packed
        except (zipfile.BadZipFile, EOFError, OSError, NotImplementedError, RuntimeError, ValueError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"{name}: the file is damaged or cut off ({reason(error)})") from error


def read_arrays(path: Place, *, max_bytes: int = MAX_BYTES) -> dict[str, np.ndarray]:
    """The arrays of an ``.npz`` file by name; objects of Python are not read.

    Raises:
        InputError: as `open_zip`.
    """
    name = os.path.basename(os.fspath(path))
    found: dict[str, np.ndarray] = {}
    with open_zip(path, max_bytes=max_bytes) as packed:
        left = max_bytes
        for entry in packed.infolist():
            try:
                with packed.open(entry) as member:
                    found[entry.filename.removesuffix(".npy")] = _array(member, left)
            except Exception as error:  # NumPy parses headers, and raises whatever a damaged one leads to
                raise InputError(f"{name}: the file is damaged or cut off ({reason(error)})") from error
            left -= found[entry.filename.removesuffix(".npy")].nbytes
    return found


def _array(file: IO[bytes], max_bytes: int) -> np.ndarray:
    """An array, whose header is believed only as far as there are bytes for it."""
    import numpy as np

    version = np.lib.format.read_magic(file)
    read = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
    if version not in read:
        raise ValueError(f"arrays of version {version} are not read")
    shape, by_columns, kind = read[version](file)
    count = 1
    for length in shape:
        count *= int(length)
    if kind.hasobject:
        raise ValueError("objects of Python are not read")
    if count * kind.itemsize > max_bytes:
        raise ValueError(f"an array of {count * kind.itemsize >> 20} MiB")
    content = file.read(count * kind.itemsize)
    if len(content) < count * kind.itemsize:
        raise ValueError("an array ends too early")
    array = np.frombuffer(bytearray(content), dtype=kind, count=count)
    return array.reshape(shape[::-1]).T if by_columns else array.reshape(shape)


@contextlib.contextmanager
def open_tar(path: Place, *, max_bytes: int = TAR_BYTES) -> Iterator[TarMembers]:
    """A tar without compression, whose members are regular files with plain names.

    Raises:
        InputError: as `open_regular`; on the way through it where it is damaged, or has other members.
    """
    name = os.path.basename(os.fspath(path))
    with open_regular(path, max_bytes) as file:
        try:
            with tarfile.open(fileobj=file, mode="r:") as tar:
                yield TarMembers(tar, name)
        except (tarfile.TarError, EOFError, OSError, ValueError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"{name}: the file is damaged or cut off ({reason(error)})") from error


class TarMembers:
    """The files of a tar in order.

    Iterating gives ``(name, size, offset)``: size [bytes] and where the content begins in the file [bytes].
    """

    def __init__(self, tar: tarfile.TarFile, name: str) -> None:
        self._tar, self._name, self._member = tar, name, tarfile.TarInfo()

    def __iter__(self) -> Iterator[tuple[str, int, int]]:
        while (member := self._tar.next()) is not None:
            self._tar.members.clear()  # pyright: ignore[reportAttributeAccessIssue] - else it remembers each of millions
            if not member.isreg() or not is_plain_name(member.name):
                raise InputError(f"{self._name}: {quote(member.name)} is no plain file in it; pack it anew")
            if member.size > TAR_MEMBER:
                raise InputError(f"{self._name}: {quote(member.name)} has over {TAR_MEMBER >> 20} MiB")
            self._member = member
            yield member.name, member.size, member.offset_data

    def read(self) -> bytes:
        """The content of the member that was given last."""
        file = self._tar.extractfile(self._member)
        content = b"" if file is None else file.read()
        if len(content) < self._member.size:
            raise InputError(
                f"{self._name}: the file is damaged or cut off ({quote(self._member.name)} ends too early)"
            )
        return content
