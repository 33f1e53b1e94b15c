"""The tables of a data set: rows against each other, against the shards, and what a gate or a licence asks."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.io import InputError, MissingDependencyError, SceneWeaverError, load_json, reason
from sceneweaver.scene import Scene
from sceneweaver.verify import check

from ..digests import NAMED, TIMES, read_checksums
from ..engines.manifest import PROMPTS, Dataset, begun_with, input_faults
from ..folder import Folder
from ..gates import failures
from ..layouts.tables import posed, schema
from ..reading import Span
from ..seals import DamagedError, fault_of, kind_fault, read_seal, sha256
from ..spec import Spec, load_spec
from ..statistics import statistics
from ..store import DIGITS
from ..tables import open_table, read_schema, read_table, schema_of
from .findings import Findings

if TYPE_CHECKING:
    import pyarrow as pa

_NEEDED = ("index", "key", "status", "reason", "split", "shard", "room", "content_hash", "bytes")

_EXCLUSIVE = ("room", "near_duplicate_group", "content_hash")
"""Columns of which no value may be in two splits."""


def check_rows(
    rows: Iterable[Mapping[str, Any]], spec: Spec, found: Findings, licences: Mapping[str, str] | None = None
) -> None:
    """Order, keys, states, gates, licences and splits of the rows of an index.

    Memory grows by some tens of bytes a row: what may not be in two splits is remembered by its hash.

    Args:
        rows: the rows, in order.
        spec: the specification.
        found: takes the faults.
        licences: of each asset; None: not known.
    """
    keys: set[str] = set()
    splits: dict[str, dict[int, str]] = {name: {} for name in _EXCLUSIVE}
    count = 0
    for count, row in enumerate(rows, start=1):
        key = row["key"]
        if row["index"] != count - 1:
            found.fault("index", key, f"row {count - 1} has index {row['index']}")
        if key in keys:
            found.fault("index", key, "is there twice")
        keys.add(key)
        if row["status"] != "ok":
            for line in _undelivered(row):
                found.fault("index", key, line)
            continue
        found.counts["scenes"] += 1
        of_row = {"index": _delivered(row, spec), "gate": gates_failed(row, spec), "licence": _licences(row, licences)}
        for name, lines in of_row.items():
            for line in lines:
                found.fault(name, key, line)
        for column, known in splits.items():
            if row.get(column) is None:
                continue
            first = known.setdefault(hash(row[column]), row["split"])
            if first != row["split"]:
                found.fault("split", key, f"{column} {row[column]} is in {first} and in {row['split']}")
    found.counts["rows"] += count
    if count != spec.count:
        found.fault("index", "index.parquet", f"has {count} rows; the specification asks for {spec.count}")


def _undelivered(row: Mapping[str, Any]) -> Iterator[str]:
    if row["status"] not in ("rejected", "failed"):
        yield f"has the status {row['status']!r}"
    if not row.get("reason"):
        yield f"is {row['status']} without a reason"
    if row.get("shard") or row.get("content_hash"):
        yield f"is {row['status']}, and has files"


def _delivered(row: Mapping[str, Any], spec: Spec) -> Iterator[str]:
    for column in ("split", "shard", "content_hash", "bytes"):
        if row.get(column) is None:
            yield f"has no {column}"
    yield from _split_faults(row.get("split"), [row["shard"]] if row.get("shard") else [], spec)


def _split_faults(split: str | None, shards: Iterable[str], spec: Spec) -> Iterator[str]:
    """Lines about a split that there is not, and shards of another one."""
    if split is not None and split not in spec.splits:
        yield f"is in split {split!r}, which the specification does not have"
    for shard in shards:
        if not Path(shard).name.startswith(f"{split}-"):
            yield f"is in split {split!r}, and lies in {shard}"


def _licences(row: Mapping[str, Any], licences: Mapping[str, str] | None) -> Iterator[str]:
    used, said = row.get("asset_ids") or (), set(row.get("licences") or ())
    if used and not said:
        yield "has assets without a licence"
    elif licences is not None:
        for asset in used:
            if not licences.get(asset):
                yield f"has an asset of unknown licence: {asset}"
            elif licences[asset] not in said:
                yield f"does not name the licence {licences[asset]} of {asset}"


def asset_licences(folder: Folder, found: Findings) -> dict[str, str] | None:
    """The licence of each asset by the table of assets; None where it cannot be read."""
    with guarded(found, "licence", folder.asset_table.name):
        return {row["asset"]: row["licence"] for row in read_table(folder.asset_table, ["asset", "licence"])}
    return None


def gates_failed(row: Mapping[str, Any], spec: Spec) -> Iterator[str]:
    """Lines about gates of a specification that a delivered row does not pass."""
    for name, through in (row.get("gates") or {}).items():
        if through is False:
            yield f"is delivered, but gate {name} failed"
    yield from failures(spec.gates, row.get)


def check_schema(folder: Folder, table: str, found: Findings) -> bool:
    """The types of the columns of the index. Only those that all else needs have to be there: versions add some.

    Returns:
        Whether they are right, so that rows can be looked at.
    """
    there, before = {field.name: field.type for field in read_schema(folder.index)}, found.faults["index"]
    for field in schema_of(table):
        if there.get(field.name, None if field.name in _NEEDED else field.type) != field.type:
            found.fault("index", folder.index.name, f"column {field.name} is {there.get(field.name)}, not {field.type}")
    return found.faults["index"] == before


def check_statistics(folder: Folder, rows: Iterable[Mapping[str, Any]], found: Findings) -> None:
    """Whether the statistics are those of the rows."""
    path = folder.statistics
    name = path.relative_to(folder.path).as_posix()
    try:
        said = load_json(path)
        if not isinstance(said, dict):
            raise InputError("is no object")
    except InputError as error:
        return found.fault("record", name, f"cannot be read: {error}")
    measured = statistics(rows)
    for key in measured.keys() | said.keys():
        if measured.get(key) != said.get(key):
            found.fault("record", name, f"{key} is not what the rows of the index give")
    return None


def check_spans(spans: Iterable[Span], shards: Mapping[str, str], found: Findings) -> None:
    """Every delivered scene lies in its shard, once, and no other does.

    Args:
        spans: the scenes of all shards.
        shards: name of the shard of each delivered scene, by key.
        found: takes the faults.
    """
    seen: set[str] = set()
    for span in spans:
        for key in span.keys:
            if key in seen:
                found.fault("shard", key, f"is there twice, again in {span.path.name}")
            elif key not in shards:
                found.fault("shard", key, f"lies in {span.path.name}, and the index has no such scene")
            elif shards[key] != span.path.name:
                found.fault("shard", key, f"lies in {span.path.name}; the index says {shards[key]}")
            seen.add(key)
    for key in sorted(shards.keys() - seen):
        found.fault("shard", key, f"is not in {shards[key]}")


def checksums(folder: Folder, found: Findings) -> list[tuple[Path, str]]:
    """The files in the list of checksums that are there, with their SHA-256; all that every data set has is listed."""
    path = folder.checksums
    if not os.path.lexists(path):
        found.fault("checksum", path.name, "is not there")
        return []
    try:
        listed = read_checksums(folder)
    except DamagedError as error:
        found.fault("checksum", path.name, str(error))
        return []
    for name in NAMED:
        if name not in listed:
            found.fault("checksum", name, f"is not in {path.name}")
    for part in (folder.data, folder.meta, folder.assets):
        for file in _files(part):
            name = file.relative_to(folder.path).as_posix()
            if name not in listed and name != TIMES:
                found.fault("checksum", name, f"is not in {path.name}")
    for name, digest in listed.items():
        if (stem := _store_name(name)) and not digest.startswith(stem):
            found.fault("checksum", name, f"is listed with {digest[:16]}..., which is not its name")
    faults = {name: kind_fault(folder.path / name) for name in listed}
    for name, fault in sorted(faults.items()):
        if fault in ("is missing", "is a folder"):
            found.fault("checksum", name, f"{'is not there' if fault == 'is missing' else fault}; {path.name} lists it")
    return [(folder.path / name, digest) for name, digest in listed.items() if not faults[name]]


KNOWN = ("dataset.json", "spec.yaml", "checksums.sha256", *NAMED)
WRITTEN = ("verification.json", "verification.md", "report.html")
"""What commands write into a data set beside it."""

PLACES = ("assets", "data", "meta", "work", "inputs")


def check_files(dataset: Dataset, found: Findings) -> None:
    """Whether all that lies in a data set are regular files, and what is at its root belongs there.

    What is hidden at the root and what is below ``work`` is no part of a data set, and is passed over.
    """
    folder = dataset.folder
    if fault := kind_fault(folder.meta / Path(TIMES).name):
        found.fault("file", TIMES, fault)
    for path in sorted(folder.path.iterdir()):
        if path.name.startswith("."):
            continue
        fault, place = kind_fault(path), path.name in PLACES
        if path.name not in (*KNOWN, *WRITTEN, *PLACES, *dataset.inputs):
            found.fault("file", path.name, "is no part of the data set")
        elif fault != ("is a folder" if place else ""):
            found.fault("file", path.name, fault or "is no folder")
        elif place and path != folder.work:
            for file in _files(path):
                name = file.relative_to(folder.path).as_posix()
                if fault := kind_fault(file):
                    found.fault("file", name, fault)
                elif path.name == "inputs" and name not in dataset.inputs:
                    found.fault("file", name, "is no part of the data set")


def check_manifest(dataset: Dataset, found: Findings) -> None:
    """Whether specification and inputs are what the data set was begun with.

    That the fields of the manifest agree with each other is seen where it is read.
    """
    folder, begun = dataset.folder, begun_with(dataset.folder)
    if begun is None and os.path.lexists(folder.begun):
        found.fault("manifest", folder.begun.relative_to(folder.path).as_posix(), "is damaged")
    for name, fault in input_faults(dataset, begun):
        found.fault("manifest", name, fault)
    if folder.spec.name in dataset.inputs or kind_fault(folder.spec):
        return
    try:
        given = load_spec(folder.spec)
    except InputError as error:
        return found.fault("manifest", folder.spec.name, str(error))
    asked = given.requests
    changed = {"prompts_file": PROMPTS} if asked.prompts_file is not None else {}
    changed |= {"scenes": dataset.spec.requests.scenes} if asked.scenes is not None else {}
    said = given.model_copy(update={"requests": asked.model_copy(update=changed)})
    if said != dataset.spec:
        found.fault("manifest", folder.spec.name, "is not the specification that dataset.json has")
    return None


def check_seal(folder: Folder, found: Findings) -> None:
    """Whether what has no checksum is as it was when the data set was packed, where its seal is still there."""
    if not os.path.lexists(folder.packed):
        return
    name = folder.packed.relative_to(folder.path).as_posix()
    try:
        entries = read_seal(folder.packed)
    except DamagedError:
        return found.fault("file", name, "is damaged")
    for path in (folder.checksums, folder.path / TIMES):
        entry = entries.get(path.relative_to(folder.path).as_posix())
        if entry is not None and (fault := fault_of(path, entry)):
            found.fault("file", path.relative_to(folder.path).as_posix(), fault)
    return None


def check_version(dataset: Dataset, rows: Iterable[Mapping[str, Any]], found: Findings) -> None:
    """Whether any row was made by the version that the manifest states."""
    made = {row["version"] for row in rows if row.get("version") is not None}
    said = dataset.versions["sceneweaver"]
    if made and said not in made:
        found.fault("manifest", "dataset.json", f"says version {said}; the rows were made by {min(made)}")


def _files(place: Path) -> Iterator[Path]:
    """All that lies in a folder but folders, in order; links are not followed."""
    for path, folders, files in os.walk(place):
        folders.sort()
        links = [name for name in folders if Path(path, name).is_symlink()]
        yield from (Path(path, name) for name in sorted((*files, *links)))


def _store_name(name: str) -> str:
    """The hash that the name of a file of the store gives; empty for any other file."""
    stem = Path(name).stem
    return stem if name.startswith("assets/") and len(stem) == DIGITS else ""


def check_digests(root: Path, files: Iterable[tuple[Path, str]]) -> Findings:
    """Whether the SHA-256 of files begins as it should."""
    found = Findings()
    for path, expected in files:
        found.counts["files hashed"] += 1
        name = path.relative_to(root).as_posix()
        try:
            digest = sha256(path)
        except InputError as error:
            found.fault("checksum", name, f"cannot be read: {error}")
            continue
        if not expected or not digest.startswith(expected.lower()):
            found.fault("checksum", name, f"has SHA-256 {digest[:16]}..., not {expected}")
    return found


SAMPLE = 5000
"""How many layouts are judged unless told otherwise."""


def check_layouts(path: Path, row_group: int, rows: Sequence[int], program: int, text: str) -> Findings:
    """Judge some layouts of a program.

    Args:
        path: the shard.
        row_group: its number in the shard.
        rows: which rows of it.
        program: number of the program.
        text: the JSON of its scene.
    """
    found = Findings()
    with guarded(found, "shard", str(program)):
        scene = Scene.loads(text)
        with open_table(path) as file:
            table = file.read_row_group(row_group, columns=["program", "layout", "poses"])
        for row in table.take(rows).to_pylist():
            key, poses = f"{program}/{row['layout']}", np.array(row["poses"], dtype=np.float32)
            found.counts["judged"] += 1
            if row["program"] != program or not np.isfinite(poses[: 4 * len(scene.objects)]).all():
                found.fault("record", key, "is of another program, or has poses that are no numbers")
                continue
            placed = posed(scene, poses)
            found.judged(key, placed, check(placed, walkable=False))
    return found


def layout_tasks(folder: Folder, spec: Spec, found: Findings, sample: int | None) -> Iterator[Callable[[], Findings]]:
    """Check the tables of a data set of layouts; what is left are the layouts to judge."""
    programs: dict[int, dict[str, Any]] = {}
    with guarded(found, "index", folder.programs.name):
        _require_columns(folder.programs, schema_of("programs"))
        programs = {row["program"]: row for row in read_table(folder.programs)}
        _check_programs(list(programs.values()), spec, found)
    places: list[_Place] = []
    for shard in sorted(folder.data.glob("*.parquet")):
        with guarded(found, "shard", f"data/{shard.name}"):
            _require_columns(shard, schema(0))
            places += _row_groups(shard, programs, found)
    _check_counts(places, programs, found)
    total = sum(rows for _, _, _, rows in places)
    found.counts["layouts"] += total
    count = min(SAMPLE if sample is None else sample, total)
    drawn = np.sort(np.random.default_rng(0).choice(total, size=count, replace=False)) if total else np.zeros(0, int)
    start = 0
    for path, number, program, rows in places:
        first, last = np.searchsorted(drawn, [start, start + rows])
        if last > first and program in programs:
            chosen = tuple((drawn[first:last] - start).tolist())
            yield partial(check_layouts, path, number, chosen, program, programs[program]["scene"])
        start += rows


def _require_columns(path: Path, wanted: pa.Schema) -> None:
    """InputError when a table lacks columns, or has others of the same name."""
    there = {field.name: field.type for field in read_schema(path)}
    for field in wanted:
        kind = there.get(field.name)
        same = kind == field.type or (kind is not None and field.name == "poses" and kind.id == field.type.id)
        if not same:
            raise InputError(f"column {field.name} is {kind}, not {field.type}")


_TROUBLES = (OSError, EOFError, ArithmeticError, AttributeError, LookupError, RuntimeError, TypeError, ValueError)


@contextmanager
def guarded(found: Findings, check: str, key: str) -> Iterator[None]:
    """What goes wrong in the block because of files that others wrote is a fault."""
    try:
        yield
    except MissingDependencyError:
        raise
    except (SceneWeaverError, *_TROUBLES) as error:
        found.fault(check, key, f"cannot be read: {reason(error)}")


_Place = tuple[Path, int, int, int]  # shard, row group, program, rows


def _row_groups(shard: Path, programs: Mapping[int, Mapping[str, Any]], found: Findings) -> Iterator[_Place]:
    """The row groups of a shard; that each is of one program, whose layouts are distinct."""
    name, seen, last = f"data/{shard.name}", np.zeros(0, dtype=np.int64), None
    with open_table(shard) as file:
        groups = [file.read_row_group(k, columns=["program", "signature"]) for k in range(file.metadata.num_row_groups)]
    for number, columns in enumerate(groups):
        if not len(columns):
            continue
        mine = np.unique(columns["program"].to_numpy())
        program = int(mine[0])
        if len(mine) != 1 or name not in (programs.get(program) or {"shards": ()})["shards"]:
            found.fault(
                "shard", name, f"row group {number} has layouts of programs that are not listed there: {mine[:3]}"
            )
        seen = np.concatenate([seen if program == last else seen[:0], columns["signature"].to_numpy()])
        if len(np.unique(seen)) < len(seen):
            found.fault("content", str(program), f"has the same layout twice in {name}")
        last = program
        yield shard, number, program, columns.num_rows


def _check_programs(rows: Sequence[Mapping[str, Any]], spec: Spec, found: Findings) -> None:
    groups: dict[int, str] = {}
    found.counts["programs"] += len(rows)
    for place, row in enumerate(rows):
        key = str(row["program"])
        if row["program"] != place:
            found.fault("index", key, f"is in row {place}")
        if not row["layouts"]:
            if not row["reason"]:
                found.fault("index", key, f"is {row['status']} without a reason")
            continue
        found.counts["scenes"] += 1
        for line in _split_faults(row["split"] or "", row["shards"], spec):
            found.fault("index", key, line)
        first = groups.setdefault(row["near_duplicate_group"], row["split"])
        if first != row["split"]:
            found.fault("split", key, f"group {row['near_duplicate_group']} is in {first} and in {row['split']}")


def _check_counts(places: Sequence[_Place], programs: Mapping[int, Mapping[str, Any]], found: Findings) -> None:
    counts: Counter[int] = Counter()
    for _, _, program, rows in places:
        counts[program] += rows
    for program, row in programs.items():
        if counts[program] != row["layouts"]:
            line = f"has {counts[program]} layouts in its shards; the table says {row['layouts']}"
            found.fault("shard", str(program), line)
