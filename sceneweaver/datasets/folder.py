"""Where everything of a data set lies, and whether there is room for it.

``dataset.json`` names the specification that the folder belongs to. Blocks are written to ``work/`` as they are
made; when all are there, they are packed: into ``data/`` (shards) and ``meta/`` (tables). Assets lie in ``assets/``
from the first, by the hash of their content, shared by all scenes.
"""

from __future__ import annotations

import errno
import shutil
import time
from dataclasses import dataclass, field
from pathlib import Path

from sceneweaver.scene import SceneWeaverError

FULL = (errno.ENOSPC, errno.EDQUOT)
LEAST = 64 * 2**20
"""Bytes that have to be free before a run goes on that knows no better."""

RETRY = 30.0
"""Seconds after which a run tries again at the latest."""


class Folder:
    """The paths of a data set.

    Attributes:
        path: its root.
        manifest: the specification, its hash and the versions of what makes it.
        spec: the specification as it was given.
        checksums: checksums of all files but times, written last.
        assets: the store of assets, by content.
        data: shards.
        meta: tables and statistics.
        index: the table with a row a scene, when all is packed.
        programs: the table with a row a program, when a data set of layouts is packed.
        asset_table: what is known about each asset: recipe, category, licence, source, attribution.
        statistics: what the data set is made of, in numbers.
        work: what runs need on the way; no part of the data set.
        blocks: blocks that are made and not packed yet.
        records: when blocks were made, by whom, with how much memory.
        complete: is there as soon as all blocks were made.
        packed: the seal of all files, written when the blocks are packed.
        plan: what packing is to write; it stays until all is written.
        begun: the seal of what the data set was begun with.
        joined: the data sets that this one was joined of, whose blocks cannot be made from its specification.
    """

    def __init__(self, path: Path):
        self.path = path
        self.manifest, self.spec = path / "dataset.json", path / "spec.yaml"
        self.checksums = path / "checksums.sha256"
        self.assets, self.data, self.meta, self.work = (path / name for name in ("assets", "data", "meta", "work"))
        self.index, self.programs = self.meta / "index.parquet", self.meta / "programs.parquet"
        self.asset_table, self.statistics = self.meta / "assets.parquet", self.meta / "statistics.json"
        self.blocks, self.records, self.plan = (self.work / name for name in ("blocks", "records", "plan"))
        self.complete, self.packed = self.work / "complete", self.work / "packed"
        self.begun, self.joined = self.work / "begun.sha256", self.work / "joined.txt"

    def block(self, number: int) -> Path:
        """The folder of a block; where it is, the block is whole. `samples` says which files it holds."""
        return self.blocks / f"{number // 1000:05d}" / f"{number:08d}"

    def rooms(self, number: int) -> Path:
        """Rooms of a block that is made room by room, as its worker was killed."""
        return self.work / "rooms" / f"{number:08d}"

    def room(self, number: int, place: int) -> Path:
        """The folder of a room of such a block, by its place in it."""
        return self.rooms(number) / f"{place:04d}"

    def table(self, product: str) -> Path:
        """The table with a row a request: of "scenes", "homes", or of "layouts", whose programs have many."""
        return self.programs if product == "layouts" else self.index


class DiskFullError(SceneWeaverError):
    """There is no room on the disk of a data set, and the run does not wait for it."""

    exit_code = 4


def disk_full(error: BaseException | None) -> bool:
    """Whether an error, or one that it was raised from or while handling, says that the disk or a quota is full."""
    while error is not None:
        if isinstance(error, OSError) and error.errno in FULL:
            return True
        error = error.__cause__ or error.__context__
    return False


@dataclass
class Wait:
    """A pause of a run while its disk is full.

    Attributes:
        path: a folder on that disk.
        needed: bytes with which the run goes on.
        until: when it tries again whatever the system says of free bytes, since that knows of no quota.
    """

    path: Path
    needed: int
    until: float = field(default_factory=lambda: time.monotonic() + RETRY)

    @property
    def free(self) -> int:
        """Bytes that are free."""
        return shutil.disk_usage(self.path).free

    @property
    def over(self) -> bool:
        """Whether it is worth a try."""
        return self.free >= self.needed or time.monotonic() >= self.until

    def __str__(self) -> str:
        return (
            f"disk full: {self.path} has {self.free / 2**20:.0f} MB free, about {self.needed / 2**20:.0f} MB are "
            "needed; remove something"
        )


def waiting(path: Path, needed: int = LEAST, *, wait: bool) -> Wait:
    """The pause to make.

    Raises:
        DiskFullError: the run does not wait.
    """
    pause = Wait(path, needed)
    if not wait:
        raise DiskFullError(f"{pause}, then resume")
    return pause
