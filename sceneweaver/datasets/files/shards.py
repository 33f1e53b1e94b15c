"""From blocks to shards: samples are copied in order, blocks go when what they held is safe.

The state of a packing that was killed follows from the first block that is left: what came before it is in shards that
are finished or in the beginnings of others. These are cut after the last sample of a block that is gone, and go on.
"""

from __future__ import annotations

import os
import tarfile
from contextlib import ExitStack
from pathlib import Path
from typing import IO

from sceneweaver.scene.files import temporary_folder

from ..blocks import SAMPLES
from ..folder import Folder
from ..requests import Requests
from .plan import INDEX
from .tables import read_table

SAFE = 256 * 10**6
"""Bytes after which what was copied is written to the disk for good, so that its blocks may go."""


def write_shards(folder: Folder, requests: Requests) -> None:
    """Copy the samples of all blocks that are left into shards, and remove the blocks."""
    folder.data.mkdir(exist_ok=True)
    blocks = [n for n in range(requests.blocks) if folder.block(n).exists()]
    plan = read_table(folder.plan / INDEX, ["index", "key", "shard"])
    places = {row["key"]: (row["index"], row["shard"]) for row in plan if row["shard"] is not None}
    first = requests.block(blocks[0])[0].index if blocks else requests.spec.count
    copied, done = 0, []
    with ExitStack() as stack:
        shards = Shards(folder, stack, {key for key, (index, _) in places.items() if index < first})
        for number in blocks:
            copied += _copy(folder.block(number) / SAMPLES, places, shards)
            done.append(folder.block(number))
            if copied > SAFE:
                shards.sync()
                _remove(done)
                copied, done = 0, []
        shards.finish({shard for _, shard in places.values()})
        _remove(done)


class Shards:
    """The shards of a data set, one open for each split; closed by an `ExitStack`."""

    def __init__(self, folder: Folder, stack: ExitStack, safe: set[str]):
        """Start or go on.

        Args:
            folder: the data set.
            stack: closes the files.
            safe: keys of the samples whose block is gone.
        """
        self._folder, self._stack, self._safe = folder, stack, safe
        self._open: dict[str, IO[bytes]] = {}

    def file(self, shard: str) -> IO[bytes] | None:
        """Where samples of a shard are appended; None when it is finished already."""
        if shard not in self._open:
            if (self._folder.path / shard).exists():
                return None
            split = shard.rpartition("-")[0]
            for other in [name for name in self._open if name.rpartition("-")[0] == split]:
                self._finish(other)
            self._open[shard] = self._begun(shard)
        return self._open[shard]

    def sync(self) -> None:
        """Write what was appended to the disk."""
        for file in self._open.values():
            file.flush()
            os.fsync(file.fileno())

    def finish(self, shards: set[str]) -> None:
        """End all shards."""
        for shard in sorted(shards):
            if self.file(shard) is not None:
                self._finish(shard)

    def _begun(self, shard: str) -> IO[bytes]:
        path = self._draft(shard)
        end = _end_of(path, self._safe) if path.exists() else 0
        path.touch()
        file = self._stack.enter_context(path.open("r+b"))
        file.truncate(end)
        file.seek(end)
        return file

    def _finish(self, shard: str) -> None:
        file = self._open.pop(shard)
        file.write(bytes(2 * tarfile.BLOCKSIZE))
        file.write(bytes(-file.tell() % tarfile.RECORDSIZE))
        file.flush()
        os.fsync(file.fileno())
        file.close()
        os.replace(self._draft(shard), self._folder.path / shard)

    def _draft(self, shard: str) -> Path:
        return self._folder.plan / Path(shard).name


def _end_of(path: Path, safe: set[str]) -> int:
    """Where in a beginning of a shard the samples end that are in no block any more [bytes]."""
    end = 0
    try:
        with tarfile.open(path, "r:") as tar:
            for member in tar:
                if member.name.partition(".")[0] not in safe:
                    break
                end = member.offset_data + _padded(member.size)
    except tarfile.ReadError:  # it ends within a header
        pass
    return end


def _copy(path: Path, places: dict[str, tuple[int, str]], shards: Shards) -> int:
    """Append the samples of a block to their shards; returns their bytes."""
    copied = 0
    with open(path, "rb") as source, tarfile.open(path, "r:") as tar:
        for member in tar:
            file = shards.file(places[member.name.partition(".")[0]][1])
            if file is not None:
                source.seek(member.offset)
                size = member.offset_data - member.offset + _padded(member.size)
                file.write(source.read(size))
                copied += size
    return copied


def _remove(blocks: list[Path]) -> None:
    """Remove blocks in order; each is there whole or not at all."""
    for path in blocks:
        with temporary_folder(path.parent) as folder:
            os.rename(path, folder / path.name)


def _padded(size: int) -> int:
    return -(-size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
