"""All systems on the room of ten boxes, from the same kinds of starts: a table of the throughput family."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks.audit import audit
from benchmarks.families.quality import OURS
from benchmarks.judging import Judge, share
from benchmarks.results import Column, Result
from benchmarks.rivals import Rival, batch_size, solve
from benchmarks.settings import Settings
from benchmarks.starts import noisy_poses, random_poses, start
from benchmarks.tenbox import ten_boxes
from benchmarks.timing import timed, warm
from sceneweaver.scene import Scene

STARTS = {"random": random_poses, "noisy": noisy_poses}
CPU, GPU = 1024, 32768  # candidates of ours

COLUMNS = (
    Column("start", "start"),
    Column("system", "system"),
    Column("candidates", "candidates", "count"),
    Column("each", "ms each", "number"),
    Column("solid", "no overlap", "share"),
    Column("hard", "hard held", "share"),
    Column("valid", "fully valid", "share"),
    Column("rate", "valid / s", "number"),
)


def add_table(result: Result, settings: Settings, judge: Judge, rivals: Sequence[Rival]) -> None:
    """Measure ours and the rivals; what ours calls valid is audited like anywhere."""
    scene = ten_boxes()
    table = result.add("boxes", "Ten boxes with fourteen relations on 4 x 5 m", COLUMNS, keys=2)
    for kind, make in STARTS.items():
        count = settings.size(GPU if settings.device.startswith("cuda") else CPU, 16)
        begin, init = start(scene, kind, count, settings.seed)
        warm(begin, settings, init if isinstance(init, str) else init[:2])
        solution, seconds = timed(begin, settings, candidates=count, seed=settings.seed, init=init)
        audit(solution, judge, result, f"{scene.id} {kind} seed {settings.seed}", settings.out)
        table.rows.append(_row(kind, OURS, judge, scene, solution.poses, seconds))
        for rival in rivals:
            starts = make(scene, batch_size(rival, settings, len(scene.objects)), settings.seed)
            poses, seconds = solve(rival, scene, starts, settings.seed, settings.device)
            table.rows.append(_row(kind, rival.name, judge, scene, poses, seconds))
    result.notes.append(
        "Ten boxes: everybody gets starts of the same kind, in batches that suit them; all layouts are judged."
    )


def _row(kind: str, system: str, judge: Judge, scene: Scene, poses: np.ndarray, seconds: float) -> dict[str, Any]:
    opinions = judge(scene, poses)
    good = sum(o.valid for o in opinions)
    return {
        "start": kind,
        "system": system,
        "candidates": len(poses),
        "seconds": seconds,
        "each": 1000 * seconds / len(poses),
        "solid": sum(o.solid for o in opinions) / len(poses),
        "hard": share([o.hard for o in opinions]),
        "valid": good / len(poses),
        "rate": good / seconds,
    }
