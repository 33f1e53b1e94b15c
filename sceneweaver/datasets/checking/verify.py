"""A data set checked as a whole: its sums, its tables, and each of its scenes by the judge."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import asdict, dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

import sceneweaver
from sceneweaver.io import InputError, write_atomic
from sceneweaver.runtime.processes import pool

from ..digests import content_of
from ..engines import open_dataset, require_free
from ..folder import Folder
from ..reading import Span, rows_of, scenes_of, shards_of, spans_of
from ..spec import Spec
from ..tables import open_table
from . import tables
from .findings import CHECKS, KEPT, Findings, markdown
from .scene import Judge
from .tables import SAMPLE, layout_tasks

Task = Callable[[], Findings]
"""Some work; it can be sent to another process."""


def check_scenes(
    judge: Judge, span: Span, rows: dict[str, dict[str, Any]], judged: frozenset[str], simulated: dict[str, float]
) -> Findings:
    """Check some scenes of a shard.

    Args:
        judge: how they are judged.
        span: where they lie.
        rows: their rows, by key; scenes without one are passed over.
        judged: keys of those that are judged; of the others only the content is hashed.
        simulated: keys of those that are compiled by MuJoCo, and how long they are let loose [s].
    """
    found = Findings()
    with tables.guarded(found, "shard", span.path.name):
        for key, files in scenes_of(span):
            if (row := rows.get(key)) is None:
                continue
            if content_of(files) != (row["content_hash"], row["bytes"]):
                found.fault("content", key, "is not what was delivered: its content hash differs from the index")
            if key in judged:
                with tables.guarded(found, "judge", key):
                    judge.judge(row, files, found)
            if key in simulated and "xml" in files:
                with tables.guarded(found, "compile", key):
                    judge.simulate(key, files["xml"], simulated[key], found)
    return found


def results(tasks: Iterable[Task], workers: int) -> Iterator[Findings]:
    """What tasks find, as they end; no more than two a worker wait at a time.

    Raises:
        InputError: a process was killed, as where memory runs out.
    """
    if workers <= 1:
        yield from (task() for task in tasks)
        return
    try:
        yield from _shared_out(tasks, workers)
    except BrokenProcessPool:
        raise InputError("a process that judges was killed; is there memory for so many? use fewer --workers") from None


def _shared_out(tasks: Iterable[Task], workers: int) -> Iterator[Findings]:
    with pool(workers) as processes:
        waiting: set[Future[Findings]] = set()
        for task in tasks:
            waiting.add(processes.submit(task))
            if len(waiting) >= 2 * workers:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (future.result() for future in done)
        while waiting:
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            yield from (future.result() for future in done)


SCHEMA = "sceneweaver.dataset-verification/1"
JSON, MARKDOWN = "verification.json", "verification.md"

COMPILED = 50
"""How many scenes are compiled by MuJoCo, at most, besides those that are let loose."""

_TOGETHER = 16  # scenes of a task
_ROW = ["key", "status", "shard", "prompt", "room_type", "area", "wall_count", "object_count", "relation_count"]
_ROW += ["categories", "assets", "valid", "collisions", "out_of_bounds", "relations_satisfied", "walkable_share"]
_ROW += ["content_hash", "bytes"]
_HOME_ROW = ["kind", "storeys", "room_count", "room_types", "door_count", "plan_valid", "furnished", "reachable_share"]
_HOME_ROW += ["unreached", *_ROW]

_ZERO = ("collisions", "judged", "out of bounds", "scenes")  # counts that are said at zero, too

Progress = Callable[[int, int], object]
"""Called with how many scenes are done, and how many there are."""


@dataclass(frozen=True)
class Verification:
    """What `verify_dataset` found.

    Attributes:
        data: all of it as plain JSON, as in ``verification.json``.
    """

    data: dict[str, Any]

    @property
    def ok(self) -> bool:
        """Whether all holds."""
        return not self.data["faults"]

    def lines(self) -> list[str]:
        """A summary for a terminal, with the first faults by key."""
        counts, stability = self.data["counts"], self.data["stability"]
        what = f"programs with {counts['layouts']} layouts" if "layouts" in counts else "scenes"
        lines = [
            f"{counts.get('scenes', 0)} {what}, {counts.get('judged', 0)} judged again: "
            f"{counts.get('collisions', 0)} collisions, {counts.get('out of bounds', 0)} out of bounds"
        ]
        if stability is not None:
            lines.append(
                f"{stability['scenes']} let loose in MuJoCo, {stability['things']} things: "
                f"{100 * stability['moved_over_0_01m']:.2f} % moved over 1 cm, "
                f"{100 * stability['moved_over_0_1m']:.2f} % over 10 cm"
            )
        if self.ok:
            return [*lines, "all holds"]
        lines.append("faults: " + ", ".join(f"{name} {count}" for name, count in self.data["faults"].items()))
        return lines + [f"{fault['key']}: {fault['check']}: {fault['detail']}" for fault in self.data["first"][:KEPT]]


def verify_dataset(
    path: str | os.PathLike[str],
    *,
    workers: int = 1,
    sample: int | None = None,
    stability: int = 0,
    progress: Progress | None = None,
) -> Verification:
    """Check a packed data set from its files alone, and write ``verification.json`` and ``.md`` into it.

    Every row, shard and sum is checked, and every delivered scene is judged again. Grades and what opens are taken as
    they are recorded.

    Args:
        path: the data set.
        workers: processes that judge; 1: this one.
        sample: how many scenes or layouts are judged; None: all scenes, 5,000 layouts.
        stability: how many of these are let loose in MuJoCo for 3 s.
        progress: called as scenes are done.

    Raises:
        InputError: no data set, one that a run is at work on, or one that is not packed yet.
        MissingDependencyError: when pyarrow is not installed.
    """
    began = time.perf_counter()
    require_free(Folder(Path(path)))
    dataset = open_dataset(Path(path))
    folder, spec, found = dataset.folder, dataset.spec, Findings()
    layouts = spec.product == "layouts"
    if not any(map(os.path.lexists, (folder.table(spec.product), folder.checksums, folder.packed))):
        raise InputError(f"{folder.path}: is not packed yet; finish it with `sceneweaver dataset resume`")
    tables.check_files(dataset, found)
    tables.check_manifest(dataset, found)
    tables.check_seal(folder, found)
    work: Iterable[Task] = ()
    if layouts:
        work = layout_tasks(folder, spec, found, sample)
    else:
        with tables.guarded(found, "index", folder.index.name):
            if tables.check_schema(folder, spec.table, found):
                tables.check_version(dataset, rows_of(folder, ["version"]), found)
                tables.check_rows(rows_of(folder), spec, found, tables.asset_licences(folder, found))
                tables.check_statistics(folder, rows_of(folder), found)
                work = _scenes(folder, _table(folder, spec), spec, found, sample, stability)
    done = 0
    for result in results(chain(_digests(folder, found), work), workers):
        found.add(result)
        done += result.counts["judged"]
        if progress is not None and result.counts["judged"]:
            total = found.counts["layouts" if layouts else "scenes"]
            progress(done, min(total, sample or (SAMPLE if layouts else total)))
    verification = Verification(_result(found, spec, time.perf_counter() - began))
    write_atomic(folder.path / JSON, json.dumps(verification.data, indent=1, ensure_ascii=False) + "\n")
    write_atomic(folder.path / MARKDOWN, markdown(verification.data))
    return verification


def _digests(folder: Folder, found: Findings) -> Iterator[Task]:
    """All files to hash, the large ones first."""
    files = tables.checksums(folder, found)
    large = [pair for pair in files if pair[0].parent == folder.data]
    yield from (partial(tables.check_digests, folder.path, (pair,)) for pair in large)
    small = [pair for pair in files if pair[0].parent != folder.data]
    yield from (partial(tables.check_digests, folder.path, small[k : k + 256]) for k in range(0, len(small), 256))


def _scenes(
    folder: Folder, table: Any, spec: Spec, found: Findings, sample: int | None, stability: int
) -> Iterator[Task]:
    """All scenes of the shards; the contents of these are checked on the way."""
    delivered = [status == "ok" for status in table["status"].to_pylist()]
    table = table.filter(delivered)
    places = {key: place for place, key in enumerate(table["key"].to_pylist())}
    shards = {key: Path(shard or "").name for key, shard in zip(places, table["shard"].to_pylist(), strict=True)}
    judged = _chosen(list(places), sample)
    simulated = dict.fromkeys(_chosen(sorted(judged), COMPILED), 0.0) if "mjcf" in spec.exports else {}
    judge = Judge(folder.path, spec.exports, still=spec.gates.still)
    if spec.product == "homes":
        from .home import HomeJudge  # which loads plans and words

        judge = HomeJudge(folder.path, spec.exports, still=spec.gates.still, homes=spec.of_homes)
    simulated |= dict.fromkeys(_chosen(sorted(judged), stability), judge.seconds)
    spans: list[Span] = []
    for shard in shards_of(folder):
        try:
            of_shard = list(spans_of(shard, _TOGETHER))
        except InputError as error:
            found.fault("shard", shard.name, f"cannot be read: {error}")
            continue
        spans += of_shard
        for span in of_shard:
            rows = table.take([places[key] for key in span.keys if key in places]).to_pylist()
            mine = {row["key"]: row for row in rows}
            loose = {key: simulated[key] for key in mine if key in simulated}
            yield partial(check_scenes, judge, span, mine, judged & mine.keys(), loose)
    tables.check_spans(spans, shards, found)


def _table(folder: Folder, spec: Spec) -> Any:
    """What is compared of the index, as an Arrow table: names that many rows share are held once."""
    shared = [f"{name}.list.element" for name in ("assets", "categories")]
    names = _HOME_ROW if spec.product == "homes" else _ROW
    with open_table(folder.index, dictionaries=shared) as file:
        return file.read(columns=[name for name in names if name in file.schema_arrow.names])


def _chosen(keys: Sequence[str], count: int | None) -> frozenset[str]:
    """Some keys, drawn evenly; always the same."""
    if count is None or count >= len(keys):
        return frozenset(keys)
    drawn = np.random.default_rng(0).choice(len(keys), size=count, replace=False)
    return frozenset(keys[int(k)] for k in drawn)


def _result(found: Findings, spec: Spec, seconds: float) -> dict[str, Any]:
    first = sorted(fault for faults in found.first.values() for fault in faults)
    return {
        "schema": SCHEMA,
        "name": spec.name,
        "spec": spec.hash,
        "version": sceneweaver.__version__,
        "ok": not found.faults,
        "counts": {name: count for name, count in sorted(found.counts.items()) if count or name in _ZERO},
        "faults": {check: found.faults[check] for check in CHECKS if found.faults[check]},
        "first": [asdict(fault) for fault in first],
        "stability": found.stability(),
        "seconds": round(seconds, 1),
    }
