"""Where everything of a data set lies.

``dataset.json`` names the specification that the folder belongs to. Blocks are written to ``work/`` as they are
made; when all are there, they are packed: into ``data/`` (shards) and ``meta/`` (tables). Assets lie in ``assets/``
from the first, by the hash of their content, shared by all scenes.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Folder:
    """The paths of a data set."""

    path: Path

    @property
    def manifest(self) -> Path:
        """The specification, its hash and the versions of what makes it."""
        return self.path / "dataset.json"

    @property
    def spec(self) -> Path:
        """The specification as it was given."""
        return self.path / "spec.yaml"

    @property
    def assets(self) -> Path:
        """The store of assets, by content."""
        return self.path / "assets"

    @property
    def data(self) -> Path:
        """Shards."""
        return self.path / "data"

    @property
    def meta(self) -> Path:
        """Index, statistics, checksums, times."""
        return self.path / "meta"

    @property
    def work(self) -> Path:
        """What runs need on the way; no part of the data set."""
        return self.path / "work"

    @property
    def blocks(self) -> Path:
        """Blocks that are made and not packed yet."""
        return self.work / "blocks"

    @property
    def records(self) -> Path:
        """When blocks were made, by whom, with how much memory."""
        return self.work / "records"

    @property
    def complete(self) -> Path:
        """Is there as soon as all blocks were made: from then on they are packed, and none is made again."""
        return self.work / "complete"

    @property
    def packed(self) -> Path:
        """Is there as soon as the blocks are packed."""
        return self.work / "packed"

    def rooms(self, number: int) -> Path:
        """Rooms of a block that is made room by room, as its worker was killed."""
        return self.work / "rooms" / f"{number:08d}"

    @property
    def plan(self) -> Path:
        """What packing is to write; once it is there, no block is made any more."""
        return self.path / "work" / "plan"

    @property
    def index(self) -> Path:
        """The index, when all is packed."""
        return self.meta / "index.parquet"

    @property
    def asset_table(self) -> Path:
        """What is known about each asset: recipe, category, licence, source, attribution."""
        return self.meta / "assets.parquet"

    @property
    def checksums(self) -> Path:
        """Checksums of all files but times, written last."""
        return self.path / "checksums.sha256"

    def block(self, number: int) -> Path:
        """The folder of a block; where it is, the block is whole.

        It holds ``samples.tar`` (files of the delivered scenes, in order), ``rows.jsonl`` (a row a scene) and
        ``seconds.jsonl`` (times, which no two runs agree on).
        """
        return self.blocks / f"{number // 1000:05d}" / f"{number:08d}"
