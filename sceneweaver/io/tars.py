"""Tar files as data sets have them: plain files one behind the other, read by their headers.

Anything else that a tar file may hold (links, devices, long names, extensions) is refused before it is read.
"""

from __future__ import annotations

import os
import tarfile
from collections.abc import Iterator
from typing import IO, NamedTuple

from .archives import is_plain_name
from .errors import InputError
from .messages import clean

BLOCK = tarfile.BLOCKSIZE

MOST_MEMBER = 2**30
"""Largest file in a shard [bytes]."""

_PLAIN = (tarfile.REGTYPE, tarfile.AREGTYPE)


class Member(NamedTuple):
    """A file in a tar file: its name, where its header and its content begin, and its size [bytes]."""

    name: str
    start: int
    data: int
    size: int

    @property
    def end(self) -> int:
        """Where the next header begins."""
        return self.data + padded(self.size)


def padded(size: int) -> int:
    """Bytes that a content of some size takes."""
    return -(-size // BLOCK) * BLOCK


def header(name: str, size: int) -> bytes:
    """The header of a file in a shard."""
    member = tarfile.TarInfo(name)
    member.size, member.mtime, member.mode = size, 0, 0o644
    return member.tobuf(tarfile.USTAR_FORMAT)


def ending(end: int) -> bytes:
    """What follows the last file of a tar file, which ends there."""
    size = end + 2 * BLOCK
    return bytes(2 * BLOCK + -size % tarfile.RECORDSIZE)


def members(file: IO[bytes], name: str, start: int = 0) -> Iterator[Member]:
    """The files of a tar file in order, from a header on; where the file is then read does not matter.

    Args:
        file: a regular file.
        name: how errors call it.
        start: where the first header begins [bytes].

    Raises:
        InputError: it is cut off or damaged, or holds something else than files.
    """
    size, at = os.fstat(file.fileno()).st_size, start
    while True:
        block = _read(file, at, BLOCK, name)
        if len(block) < BLOCK:
            raise InputError(f"{name}: no whole tar file: cut off after {at + len(block)} bytes")
        if not any(block):
            return
        try:
            found = tarfile.TarInfo.frombuf(block, "utf-8", "strict")
        except (tarfile.HeaderError, UnicodeDecodeError) as error:
            raise InputError(f"{name}: no whole tar file: {clean(str(error))} at byte {at}") from None
        member = Member(found.name, at, at + BLOCK, found.size)
        if found.type not in _PLAIN:
            raise InputError(f"{name}: {clean(found.name)} in it is no plain file; fetch it anew")
        if not is_plain_name(found.name):
            raise InputError(f"{name}: {clean(found.name)} in it leads out of its folder; fetch it anew")
        if not 0 <= member.size <= MOST_MEMBER or member.end > size:
            raise InputError(f"{name}: no whole tar file: {clean(found.name)} in it has {member.size} bytes")
        yield member
        at = member.end


def content(file: IO[bytes], member: Member, name: str) -> bytes:
    """The content of a file in a tar file; ``name`` is how errors call the tar file."""
    found = _read(file, member.data, member.size, name)
    if len(found) < member.size:
        raise InputError(f"{name}: no whole tar file: cut off within {clean(member.name)}")
    return found


def _read(file: IO[bytes], at: int, size: int, name: str) -> bytes:
    try:
        file.seek(at)
        return file.read(size)
    except OSError as error:
        raise InputError(f"{name}: cannot be read ({error.strerror}); check the disk") from None
