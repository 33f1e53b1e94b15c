"""Large batches: what a GPU is for. Throughput over many candidates, memory, several GPUs."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks import children, rooms
from benchmarks.audit import audit
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.starts import blind
from benchmarks.timing import timed, warm

SIZES = {"bedroom-small": (524288, 16), "office-20": (262144, 8), "restaurant-60": (32768, 4)}
JUDGED = 2048  # layouts of each room that the judge looks at
RUNS = 3
FLOOR = (50, 65536)  # objects and candidates of the room whose memory is measured

COLUMNS = (
    Column("room", "room"),
    Column("device", "device"),
    Column("candidates", "candidates", "count"),
    Column("seconds", "seconds", "number"),
    Column("valid", "status valid", "share"),
    Column("distinct", "distinct", "count"),
    Column("rate", "distinct valid / s", "number"),
    Column("worst", "slowest run [s]", "number"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
)
MEMORY = (
    Column("objects", "objects", "count"),
    Column("candidates", "candidates", "count"),
    Column("device", "device pool, peak [MiB]", "mib"),
    Column("valid", "valid layouts", "count"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Time warm calls of many candidates from random starts."""
    about = (
        "Warm calls of `refine` from random starts, from call to return with all poses on the host: the fastest of "
        f"{RUNS} runs with different seeds. Distinct are layouts of which no two have all objects in the same "
        "centimetre and degree. The judge looks at an even sample of what is called valid."
    )
    result = Result("large", "Large batches", about)
    table = result.add("large", "Large batches", COLUMNS, keys=2)
    devices = [settings.device] + (["cuda:all"] if _gpus() > 1 and settings.device != "cpu" else [])
    for name in rooms.chosen(settings, tuple(SIZES)):
        for device in devices:
            table.rows.append(_row(result, settings, judge, name, device))
    objects, full = FLOOR
    count = settings.size(full, 8)
    task = {"device": settings.device, "seed": settings.seed, "repeat": 1, "scenes": [objects], "candidates": count}
    found = children.run(task)
    memory = result.add("memory", "Memory of a large batch", MEMORY, keys=2)
    valid = found["calls"][-1]["valid"]
    memory.rows.append({"objects": objects, "candidates": count, "device": found["device_mib"], "valid": valid})
    return result


def _gpus() -> int:
    import warp as wp

    return wp.get_cuda_device_count() if wp.is_cuda_available() else 0


def _row(result: Result, settings: Settings, judge: Judge, name: str, device: str) -> dict[str, Any]:
    scene = blind(rooms.load(name))
    full, quick = SIZES.get(name, (32768, 4))
    count = settings.size(full, quick)
    here = Settings(**{**settings.__dict__, "device": device})
    warm(scene, here, init="random")
    timed(scene, here, candidates=count, seed=settings.seed + RUNS, init="random")  # memory pools grow
    runs = [timed(scene, here, candidates=count, seed=settings.seed + k, init="random") for k in range(RUNS)]
    solution, seconds = min(runs, key=lambda run: run[1])
    found = audit(solution, judge, result, f"{name} {device}", settings.out, JUDGED)
    distinct = _distinct(solution.poses[solution.status == 0])
    return {
        "room": name,
        "device": device,
        "candidates": count,
        "seconds": seconds,
        "valid": float(np.mean(solution.status == 0)),
        "distinct": distinct,
        "rate": distinct / seconds,
        "worst": max(s for _, s in runs),
        "judged": len(found.judged),
        "exceptions": found.exceptions,
    }


def _distinct(poses: np.ndarray) -> int:
    """Layouts [B, N, 4] with cells of their own on a grid of a centimetre and a degree."""
    cells = np.round(poses * np.array([100.0, 100.0, 100.0, 180.0 / np.pi])).astype(np.int32)
    rows = np.ascontiguousarray(cells.reshape(len(cells), -1))
    return len(np.unique(rows.view([("", np.void, rows.shape[1] * 4)]))) if len(rows) else 0
