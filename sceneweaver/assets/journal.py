"""Results of costly calls that processes tell each other: a folder with one growing file of each process.

A record is the key, the length of the value, a checksum of key and value, and the value. What a killed process left
half written at the end of its file is never read.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import struct
import time
import zlib
from collections.abc import Hashable
from hashlib import blake2b
from pathlib import Path
from threading import Lock

from sceneweaver.io import InputError, open_regular, open_writable

_HEAD = struct.Struct("<16sII")
_MOST = 2**40  # [bytes] of a file
_LOOK = 1.0  # [s] between two looks for what others wrote


class Journal:
    """Values by key in the files of a folder; where that cannot be written, nothing is kept.

    Args:
        folder: The folder, made when something is written.
    """

    def __init__(self, folder: Path):
        self.folder = folder
        self._places: dict[bytes, tuple[Path, int, int, int]] = {}
        self._read: dict[Path, int] = {}
        self._own: Path | None = None
        self._process = 0
        self._looked = -_LOOK
        self._lock = Lock()

    def get(self, key: bytes) -> bytes | None:
        """The value of a key of 16 bytes; None when nobody has told it."""
        with self._lock:
            if key not in self._places:
                self._look()
            if key not in self._places:
                return None
            path, start, length, check = self._places[key]
        with contextlib.suppress(OSError, InputError), open_regular(path, _MOST) as file:
            value = os.pread(file.fileno(), length, start)
            if len(value) == length and zlib.crc32(key + value) == check:
                return value
        return None

    def put(self, key: bytes, value: bytes) -> None:
        """Tell a value."""
        with self._lock, contextlib.suppress(OSError, InputError):
            if self._own is None or self._process != os.getpid():
                self._own, self._process = self.folder / f"{secrets.token_hex(8)}.journal", os.getpid()
                self.folder.mkdir(parents=True, exist_ok=True)
            with open_writable(self._own, "ab") as file:
                file.write(_HEAD.pack(key, len(value), zlib.crc32(key + value)) + value)

    def _look(self) -> None:
        """Note where things stand that were written since the last look."""
        if time.monotonic() - self._looked < _LOOK:
            return
        self._looked = time.monotonic()
        for path in self.folder.glob("*.journal"):
            with contextlib.suppress(OSError, InputError), open_regular(path, _MOST) as file:
                self._read[path] = self._index(path, file.fileno(), self._read.get(path, 0))

    def _index(self, path: Path, file: int, at: int) -> int:
        """Note the whole records of a file from there on, by their heads; returns where they end."""
        end = os.fstat(file).st_size
        while at + _HEAD.size <= end:
            key, length, check = _HEAD.unpack(os.pread(file, _HEAD.size, at))
            start = at + _HEAD.size
            if start + length > end:
                break
            self._places[key] = path, start, length, check
            at = start + length
        return at


def journal_key(*parts: Hashable) -> bytes:
    """A key for values that follow from some parts, by what ``repr`` says of them."""
    return blake2b(repr(parts).encode(), digest_size=16).digest()
