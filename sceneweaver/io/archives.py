"""Zip and NumPy archives that somebody else made: members with plain names, bounded before they unpack."""

from __future__ import annotations

import contextlib
import os
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
