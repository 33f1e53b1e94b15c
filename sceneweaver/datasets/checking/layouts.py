"""A data set of layouts checked: its programs against its rows, and a sample of the rows by the judge."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.scene import Scene
from sceneweaver.verify import check

from ..folder import Folder
from ..layouts.read import posed
from ..spec import Spec
from ..tables import arrow, read_table
from .findings import Findings

SAMPLE = 5000
"""How many layouts are judged unless told otherwise."""


@dataclass(frozen=True)
class Layouts:
    """Some layouts of a program, in a row group of a shard.

    Attributes:
        path: the shard.
        row_group: its number.
        rows: which rows of it.
        program: number of the program.
        scene: the JSON of its scene.
    """

    path: Path
    row_group: int
    rows: tuple[int, ...]
    program: int
    scene: str

    def run(self) -> Findings:
        """Judge them."""
        found, scene = Findings(), Scene.loads(self.scene)
        file = arrow().parquet.ParquetFile(self.path)
        for row in (
            file.read_row_group(self.row_group, columns=["program", "layout", "poses"]).take(self.rows).to_pylist()
        ):
            key = f"{self.program}/{row['layout']}"
            poses = np.array(row["poses"], dtype=np.float32)
            found.counts["judged"] += 1
            if row["program"] != self.program or not np.isfinite(poses[: 4 * len(scene.objects)]).all():
                found.fault("record", key, "is of another program, or has poses that are no numbers")
                continue
            report = check(posed(scene, poses), walkable=False)
            found.counts["objects"] += len(scene.objects)
            found.counts["collisions"] += report.collisions
            found.counts["out of bounds"] += report.out_of_bounds
            if not report.valid:
                worst = next(v for v in report.violations if v.hard)
                found.fault("judge", key, f"is not valid: {worst.kind}: {worst.detail}")
        return found


def layout_tasks(folder: Folder, spec: Spec, found: Findings, sample: int | None) -> Iterator[Layouts]:
    """Check the tables of a data set of layouts; what is left are the layouts to judge."""
    programs = {row["program"]: row for row in read_table(folder.programs)}
    _check_programs(list(programs.values()), spec, found)
    shards = sorted(folder.data.glob("*.parquet"))
    places = [place for shard in shards for place in _row_groups(shard, programs, found)]
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
            yield Layouts(path, number, chosen, program, programs[program]["scene"])
        start += rows


_Place = tuple[Path, int, int, int]  # shard, row group, program, rows


def _row_groups(shard: Path, programs: Mapping[int, Mapping[str, Any]], found: Findings) -> Iterator[_Place]:
    """The row groups of a shard; that each is of one program, whose layouts are distinct."""
    file = arrow().parquet.ParquetFile(shard)
    name, seen, last = f"data/{shard.name}", np.zeros(0, dtype=np.int64), None
    for number in range(file.metadata.num_row_groups):
        columns = file.read_row_group(number, columns=["program", "signature"])
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
        if row["split"] not in spec.splits:
            found.fault("index", key, f"is in split {row['split']!r}, which the specification does not have")
        for shard in row["shards"]:
            if not Path(shard).name.startswith(f"{row['split']}-"):
                found.fault("index", key, f"is in split {row['split']!r}, and lies in {shard}")
        first = groups.setdefault(row["near_duplicate_group"], row["split"])
        if first != row["split"]:
            found.fault("split", key, f"group {row['near_duplicate_group']} is in {first} and in {row['split']}")


def _check_counts(places: Sequence[_Place], programs: Mapping[int, Mapping[str, Any]], found: Findings) -> None:
    counts: dict[int, int] = {}
    for _, _, program, rows in places:
        counts[program] = counts.get(program, 0) + rows
    for program, row in programs.items():
        if counts.get(program, 0) != row["layouts"]:
            line = f"has {counts.get(program, 0)} layouts in its shards; the table says {row['layouts']}"
            found.fault("shard", str(program), line)
