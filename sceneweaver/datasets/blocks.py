"""Blocks: what is made together is written together, whole or not at all."""

from __future__ import annotations

import hashlib
import io
import json
import os
import tarfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from sceneweaver.scene.files import temporary_folder

from .sample import Sample

SAMPLES, ROWS, SECONDS = "samples.tar", "rows.jsonl", "seconds.jsonl"


def write_block(path: Path, samples: Iterable[Sample]) -> None:
    """Write a block under a temporary name and rename it; does nothing where it is already.

    Args:
        path: the folder of the block, which is there as soon as it is whole.
        samples: its samples, in the order of their index.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with temporary_folder(path.parent) as folder:
        draft = folder / path.name
        draft.mkdir()
        rows, seconds = [], []
        with tarfile.open(draft / SAMPLES, "w", format=tarfile.USTAR_FORMAT) as tar:
            for sample in samples:
                digest, size = hashlib.sha256(), 0
                for suffix in sorted(sample.files):
                    content = sample.files[suffix]
                    digest.update(f"{suffix}:{len(content)}\n".encode() + content)
                    size += len(content)
                    tar.addfile(_member(f"{sample.key}.{suffix}", len(content)), io.BytesIO(content))
                row = {"index": sample.index, "key": sample.key, "status": sample.status, **sample.row}
                if sample.files:
                    row |= {"content_hash": digest.hexdigest(), "bytes": size}
                rows.append(row)
                seconds.append({"index": sample.index, **sample.seconds})
        for name, data in ((ROWS, rows), (SECONDS, seconds)):
            (draft / name).write_text("".join(json.dumps(row, ensure_ascii=False) + "\n" for row in data))
        try:
            os.rename(draft, path)
        except OSError:  # the folder is not empty: another process was as quick
            if not path.exists():
                raise


def read_rows(path: Path) -> Iterator[dict[str, Any]]:
    """The rows of a block."""
    with open(path / ROWS, encoding="utf-8") as file:
        yield from (json.loads(line) for line in file)


def read_samples(path: Path) -> Iterator[Sample]:
    """The samples of a block; `write_block` makes the same block of them."""
    with open(path / SECONDS, encoding="utf-8") as file:
        times = [json.loads(line) for line in file]
    with tarfile.open(path / SAMPLES) as tar:
        member = tar.next()
        for row, seconds in zip(read_rows(path), times, strict=True):
            files: dict[str, bytes] = {}
            while member is not None and member.name.startswith(f"{row['key']}."):
                files[member.name.partition(".")[2]] = tar.extractfile(member).read()  # pyright: ignore[reportOptionalMemberAccess]
                member = tar.next()
            index, key, status = (row.pop(name) for name in ("index", "key", "status"))
            for name in ("content_hash", "bytes") if files else ():
                del row[name]
            del seconds["index"]
            yield Sample(index, key, status, row, files, seconds)


def _member(name: str, size: int) -> tarfile.TarInfo:
    info = tarfile.TarInfo(name)
    info.size, info.mtime, info.mode = size, 0, 0o644
    return info
