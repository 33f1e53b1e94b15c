"""What is made of requests: the files of scenes with their rows, in blocks that are written whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from sceneweaver.io import open_writable, temporary_folder
from sceneweaver.io.tars import content, ending, header, members, padded
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from .digests import content_of
from .seals import open_own, seal_folder
from .tables import read_lines, write_lines

Status = Literal["ok", "rejected", "failed"]
"""Delivered; made, but not through the gates; not made."""

SAMPLES, ROWS, SECONDS = "samples.tar", "rows.jsonl", "seconds.jsonl"
"""The files of a block: of the delivered scenes, in order; a row a scene; times, which no two runs agree on."""


@dataclass(frozen=True)
class Sample:
    """A scene of a data set, or the reason why there is none.

    Attributes:
        index: its number in the data set.
        key: its name in shards.
        status: "ok", "rejected" or "failed".
        row: its columns in the index that follow from specification and index alone, see ``columns.yaml``.
        files: by suffix (``scene.json``, ``glb``, ``xml``, ...), its files in a shard; empty unless it is "ok".
        seconds: by stage, how long it took; kept apart from the index, as no two runs agree on it.
    """

    index: int
    key: str
    status: Status
    row: dict[str, Any]
    files: dict[str, bytes] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)


def scene_columns(scene: Scene) -> dict[str, Any]:
    """The columns of a row that tell of a scene itself."""
    return {
        "room_type": scene.room.type,
        "wall_count": len(scene.room.outline),
        "object_count": len(scene.objects),
        "categories": sorted({o.category for o in scene.objects}),
        "relation_count": len(scene.relations),
    }


def report_columns(report: Report) -> dict[str, Any]:
    """The columns of a row that the judge measures."""
    hard, soft = report.relations.hard, report.relations.soft
    total = hard.total + soft.total
    names = ("valid", "collisions", "out_of_bounds", "openable_share", "walkable_share")
    return {
        **{name: getattr(report, name) for name in names},
        "relations_satisfied": (hard.satisfied + soft.satisfied) / total if total else 1.0,
    }


@contextmanager
def whole_folder(path: Path) -> Iterator[Path]:
    """A folder to fill, which is sealed and gets its name at the end; another process may have been as quick."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with temporary_folder(path.parent) as folder:
        draft = folder / path.name
        draft.mkdir()
        yield draft
        seal_folder(draft)
        try:
            os.rename(draft, path)
        except OSError:  # the folder is there and not empty
            if not path.exists():
                raise


def write_block(path: Path, samples: Iterable[Sample]) -> None:
    """Write a block under a temporary name and rename it; does nothing where it is already.

    Args:
        path: the folder of the block, which is there as soon as it is whole.
        samples: its samples, in the order of their index.
    """
    rows, seconds = [], []
    with whole_folder(path) as draft:
        with open_writable(draft / SAMPLES, "xb") as tar:
            for sample in samples:
                for suffix, content in sorted(sample.files.items()):
                    written = len(content)
                    tar.write(header(f"{sample.key}.{suffix}", written) + content + bytes(padded(written) - written))
                row = {"index": sample.index, "key": sample.key, "status": sample.status, **sample.row}
                if sample.files:
                    digest, size = content_of(sample.files)
                    row |= {"content_hash": digest, "bytes": size}
                rows.append(row)
                seconds.append({"index": sample.index, **sample.seconds})
            tar.write(ending(tar.tell()))
        write_lines(draft / ROWS, rows)
        write_lines(draft / SECONDS, seconds)


def read_rows(path: Path) -> Iterator[dict[str, Any]]:
    """The rows of a block."""
    return read_lines(path / ROWS)


def read_samples(path: Path) -> Iterator[Sample]:
    """The samples of a block; `write_block` makes the same block of them."""
    name = str(path / SAMPLES)
    with open_own(path / SAMPLES) as file:
        left = members(file, name)
        member = next(left, None)
        for row, seconds in zip(read_rows(path), read_lines(path / SECONDS), strict=True):
            files: dict[str, bytes] = {}
            while member is not None and member.name.startswith(f"{row['key']}."):
                files[member.name.partition(".")[2]] = content(file, member, name)
                member = next(left, None)
            index, key, status = (row.pop(name) for name in ("index", "key", "status"))
            for name in ("content_hash", "bytes") if files else ():
                del row[name]
            del seconds["index"]
            yield Sample(index, key, status, row, files, seconds)
