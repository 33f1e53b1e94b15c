"""Data sets joined to one: shares of the same that were made on different disks, or whole ones of any specification."""

from __future__ import annotations

import csv
import io
import os
import re
import shutil
from collections.abc import Iterator, Sequence
from itertools import chain, islice
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, read_bytes, temporary_folder, write_atomic
from sceneweaver.scene import Scene

from ..digests import content_of
from ..folder import Folder
from ..reading import link, of_others, rows_of, scenes_of, shards_of, spans_of
from ..samples import Sample, write_block
from ..seals import folder_fault, kind_fault, sealed_row, sha256
from ..spec import Spec
from ..tables import read_table, write_lines
from .manifest import MAX_INPUT, PROMPTS, Dataset, begun_with, create, digests, input_faults, open_dataset, restore
from .mending import lost, missing
from .run import require_free, run_lock, whole

BLOCK = 64
"""Scenes of a block of joined data sets."""

PACKED = ("index", "key", "status", "split", "shard", "near_duplicate_group", "content_hash", "bytes")
"""Columns that packing fills, or that a sample has as fields."""


def merge(sources: Sequence[Path], out: Path) -> Dataset:
    """Bring data sets into one folder; a run there then makes what is missing, and packs it.

    Those of one specification are shares of one data set: their blocks are united. Others have to be whole; their
    scenes follow each other with new numbers, and the column ``source`` says the name of the data set that each is of.
    Killed in between, it goes on when called again.

    Args:
        sources: two data sets or more.
        out: a folder that is missing, empty, or holds the beginning of this.

    Returns:
        The data set, not packed yet.

    Raises:
        InputError: they do not go together, or a folder holds something else.
    """
    parts = [open_dataset(path) for path in sources]
    for part in parts:
        require_free(part.folder, "merge: ")
    if len(parts) < 2 or len({path.resolve() for path in [*sources, out]}) <= len(parts):
        raise InputError("merge: give two different data sets or more, and another folder for --out")
    first = parts[0]
    if all(
        (part.spec.hash, part.inputs, part.device) == (first.spec.hash, first.inputs, first.device) for part in parts
    ):
        return _unite(parts, out)
    return _join(parts, out)


def _unite(parts: Sequence[Dataset], out: Path) -> Dataset:
    """The blocks of shares of one data set in one folder."""
    for part in parts:
        if whole(part):
            raise InputError(f"{part.folder.path} is whole: there is nothing to merge with it")
    first = parts[0]
    for part in parts:
        for name, fault in input_faults(part, begun_with(part.folder)):
            raise InputError(f"{part.folder.path / name}: {fault}; resume that data set first")
    inputs = {name: read_bytes(first.folder.path / name, max_bytes=MAX_INPUT) for name in first.inputs}
    given = read_bytes(first.folder.spec) if first.folder.spec.exists() else None
    dataset = _begun(out, first.spec, inputs) or create(Folder(out), first.spec, first.device, inputs, given)
    with run_lock(dataset.folder, None):
        for k, part in enumerate(parts):
            _take_assets(part.folder, dataset.folder, k)
            for number in missing(dataset):
                if part.folder.block(number).is_dir() and not folder_fault(part.folder.block(number)):
                    _take_folder(part.folder.block(number), dataset.folder.block(number))
    return dataset


def _join(parts: Sequence[Dataset], out: Path) -> Dataset:
    """The scenes of whole data sets, one after the other, as blocks of a new one."""
    for part in parts:
        if whole(part) and (damaged := lost(part)):
            raise InputError(f"{part.folder.path / damaged[0][0]}: {damaged[0][1]}; resume that data set first")
        if part.spec.product != "scenes" or not whole(part):
            what = f"holds {part.spec.product}" if part.spec.product != "scenes" else "is not whole"
            raise InputError(
                f"{part.folder.path} {what}: data sets of different specifications are joined as whole scenes"
            )
    prompts = io.StringIO()
    table = csv.writer(prompts, lineterminator="\n")
    table.writerow(["prompt"])
    count = 0
    for part in parts:
        for row in rows_of(part.folder, ["prompt"]):
            table.writerow([row["prompt"]])
            count += 1
    spec = parts[0].spec
    spec = spec.model_copy(
        update={
            "name": re.sub("[^a-z0-9_-]+", "-", out.absolute().name.lower()).strip("-_")[:64] or spec.name,
            "count": count,
            "block": BLOCK,
            "rooms": spec.rooms.model_copy(update={"layouts": 1}),
            "requests": type(spec.requests)(prompts_file=PROMPTS),
        }
    )
    spec = type(spec).model_validate(spec.model_dump(mode="json"))
    inputs = {PROMPTS: prompts.getvalue().encode()}
    names = "".join(f"{part.folder.path.absolute()}\n" for part in parts)
    marker = {Folder(out).joined.relative_to(out).as_posix(): names.encode()}
    dataset = _begun(out, spec, inputs) or create(Folder(out), spec, "cpu", inputs, more=marker)
    with run_lock(dataset.folder, None):
        for k, part in enumerate(parts):
            _take_assets(part.folder, dataset.folder, k)
        samples = chain.from_iterable(_samples(parts))
        for number in range(dataset.requests.blocks):
            some = islice(samples, BLOCK)
            if dataset.folder.block(number).exists():
                next(islice(some, BLOCK, BLOCK), None)
            else:
                write_block(dataset.folder.block(number), some)
    return dataset


def _begun(out: Path, spec: Spec, inputs: dict[str, bytes]) -> Dataset | None:
    """The data set in a folder, if it is the one that is wanted; None where there is none."""
    restore(Folder(out), spec, inputs, None)
    if not Folder(out).manifest.exists():
        return None
    there = open_dataset(out)
    if (there.spec.hash, there.inputs) != (spec.hash, digests(inputs)):
        raise InputError(f"--out: {out} holds another data set; choose another folder")
    return there


def _samples(parts: Sequence[Dataset]) -> Iterator[Iterator[Sample]]:
    index = room = 0
    for part in parts:
        yield _of_part(part, index, room)
        index += part.spec.count
        room += len(part.requests)


def _of_part(part: Dataset, first: int, first_room: int) -> Iterator[Sample]:
    """The scenes of a whole data set in order, with new numbers."""
    with of_others(part.folder):
        yield from _samples_of(part, first, first_room)


def _samples_of(part: Dataset, first: int, first_room: int) -> Iterator[Sample]:
    from ..files import fingerprint

    places = {span.keys[0]: span for path in shards_of(part.folder) for span in spans_of(path, 1)}
    times = _times(part.folder)
    for row in rows_of(part.folder):
        index, status = first + row["index"], row["status"]
        kept: dict[str, Any] = {name: value for name, value in row.items() if name not in PACKED and value is not None}
        kept |= {"room": first_room + row["room"], "source": part.spec.name}
        files: dict[str, bytes] = {}
        if status == "ok":
            files = next(scenes_of(places[row["key"]]))[1] if row["key"] in places else {}
            if content_of(files) != (row["content_hash"], row["bytes"]):
                raise InputError(f"{part.folder.path}: scene {row['key']} is not what was delivered; fetch it anew")
            kept |= fingerprint(Scene.loads(files["scene.json"].decode()))
        yield Sample(index, f"{index:08d}", status, kept, files, times.get(row["index"], {}))


def _times(folder: Folder) -> dict[int, dict[str, float]]:
    """How long each stage of each scene took [s], by its number."""
    found: dict[int, dict[str, float]] = {}
    path = folder.meta / "seconds.parquet"
    for row in read_table(path) if path.exists() else ():
        found.setdefault(row["index"], {})[row["stage"]] = row["seconds"]
    return found


def _take_assets(source: Folder, target: Folder, number: int) -> None:
    """Assets of a data set, and what is known about them."""
    from ..store.scene_files import read_records

    for path in source.assets.glob("*/*"):
        place = target.path / path.relative_to(source.path)
        good = not kind_fault(path) and sha256(path).startswith(path.stem)
        if good and not place.exists():
            place.parent.mkdir(parents=True, exist_ok=True)
            link(path, place)
    place = target.work / "assets"
    place.mkdir(parents=True, exist_ok=True)
    for path in (source.work / "assets").glob("*.jsonl"):
        write_atomic(place / f"{number:04d}-{path.name}", b"".join(read_records(path)))
    if source.asset_table.exists():
        write_lines(place / f"{number:04d}.jsonl", map(sealed_row, read_table(source.asset_table)))


def _take_folder(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    with temporary_folder(target.parent) as folder:
        shutil.copytree(source, folder / target.name, copy_function=link)
        os.rename(folder / target.name, target)
