"""Rows of layouts read again from their files: all counted, a sample judged."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.signature import signatures
from sceneweaver.datasets.layouts.tables import posed
from sceneweaver.datasets.tables import arrow
from sceneweaver.runtime.processes import cores, pool
from sceneweaver.scene import Scene
from sceneweaver.verify import check


@dataclass(frozen=True)
class Written:
    """The layouts of a program as they lie in a file: how many there should be, and how many of them to judge."""

    program: int
    scene: str
    path: Path
    count: int
    judged: int


@dataclass(frozen=True)
class Examined:
    """What was found of a program's layouts.

    Attributes:
        rows: how many there are.
        signatures: different signatures among these, as they were written.
        distinct: of these, by the `signatures` of the benchmarks, taken anew from the poses of every row.
        groups: arrangements of the large pieces.
        judged: how many the judge looked at.
        wrong: what it found in those that are not valid.
    """

    rows: int
    signatures: int
    distinct: int
    groups: int
    judged: int
    wrong: tuple[str, ...]


def examine_all(written: Sequence[Written], processes: int | None = None) -> Iterator[Examined]:
    """What is found of each program's layouts, in their order, by so many processes: as many as there are cores."""
    with pool(processes or cores()) as started:
        yield from started.map(examine, written)


def examine(written: Written) -> Examined:
    """Count the layouts of a program, and judge an even sample of them."""
    table = arrow().parquet.read_table(
        written.path,
        columns=["poses", "signature", "near_duplicate_group"],
        filters=[("program", "=", written.program)],
        use_threads=False,
    )
    scene, width = Scene.loads(written.scene), table.schema.field("poses").type.list_size
    poses = table["poses"].combine_chunks().flatten().to_numpy(zero_copy_only=False).reshape(-1, width)
    if not len(poses):
        return Examined(0, 0, 0, 0, 0, ())
    chosen = np.unique(np.linspace(0, len(poses) - 1, written.judged).astype(int))
    reports = [check(posed(scene, poses[k]), walkable=False) for k in chosen]
    own = poses[:, : 4 * len(scene.objects)].reshape(len(poses), -1, 4)
    return Examined(
        rows=len(poses),
        signatures=len(np.unique(table["signature"].to_numpy())),
        distinct=different_rows(signatures(scene, own)),
        groups=len(np.unique(table["near_duplicate_group"].to_numpy())),
        judged=len(chosen),
        wrong=tuple(f"{r.violations[0].kind}: {r.violations[0].objects}" for r in reports if not r.valid),
    )


def different_rows(numbers: np.ndarray) -> int:
    """How many different rows there are among small integers [K, M]; exact, and quicker than `np.unique` of rows."""
    rows = np.ascontiguousarray(numbers, dtype=np.int16)
    return len({row.tobytes() for row in rows})
