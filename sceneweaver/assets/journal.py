"""Results of costly calls that processes tell each other: a folder with one growing file of each process.

A record is the key, the length and a checksum of the value, and the value. What a killed process left half written at
the end of its file is never read.
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

_HEAD = struct.Struct("<16sII")
_LOOK = 1.0  # [s] between two looks for what others wrote


class Journal:
    """Values by key in the files of a folder; where that cannot be written, nothing is kept.

    Args:
        folder: The folder, made when something is written.
    """

    def __init__(self, folder: Path):
        self.folder = folder
        self._places: dict[bytes, tuple[Path, int, int]] = {}
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
            path, start, length = self._places[key]
        with contextlib.suppress(OSError), open(path, "rb") as file:
            return os.pread(file.fileno(), length, start)
        return None

    def put(self, key: bytes, value: bytes) -> None:
        """Tell a value."""
        with self._lock, contextlib.suppress(OSError):
            if self._own is None or self._process != os.getpid():
                self._own, self._process = self.folder / f"{secrets.token_hex(8)}.journal", os.getpid()
                self.folder.mkdir(parents=True, exist_ok=True)
            with open(self._own, "ab", buffering=0) as file:
                file.write(_HEAD.pack(key, len(value), zlib.crc32(value)) + value)

    def _look(self) -> None:
        """Read what was written since the last look."""
        if time.monotonic() - self._looked < _LOOK:
            return
        self._looked = time.monotonic()
        for path in self.folder.glob("*.journal"):
            with contextlib.suppress(OSError), open(path, "rb") as file:
                file.seek(self._read.get(path, 0))
                self._read[path] = self._index(path, file.tell(), file.read())

    def _index(self, path: Path, start: int, content: bytes) -> int:
        """Note the whole records of a part of a file that starts there; returns where they end."""
        at = 0
        while at + _HEAD.size <= len(content):
            key, length, check = _HEAD.unpack_from(content, at)
            value = content[at + _HEAD.size : at + _HEAD.size + length]
            if len(value) < length or zlib.crc32(value) != check:
                break
            self._places[key] = path, start + at + _HEAD.size, length
            at += _HEAD.size + length
        return start + at


def journal_key(*parts: Hashable) -> bytes:
    """A key for values that follow from some parts, by what ``repr`` says of them."""
    return blake2b(repr(parts).encode(), digest_size=16).digest()
