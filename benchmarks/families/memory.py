"""Peak memory over candidates and over objects, and what a process holds after many designs."""

from __future__ import annotations

from typing import Any

from benchmarks import children
from benchmarks.judging import Judge
from benchmarks.results import Column, Plot, Result, Table
from benchmarks.settings import Settings

ROOM = "bedroom-small"
CANDIDATES = (64, 512, 2048, 8192)
OBJECTS = (50, 100, 200, 350, 500)
DESIGNS = 200
QUICK_CANDIDATES = (8, 64)
QUICK_OBJECTS = (50, 100)
QUICK_DESIGNS = 2

FLAT = 1.05
"""How much more may be held after all designs than after those that fill the caches."""

TAIL = (
    Column("peak", "peak RSS [MiB]", "mib"),
    Column("more", "above the smallest call [MiB]", "mib"),
    Column("device", "device pool, peak [MiB]", "mib"),
    Column("valid", "valid layouts", "count"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """One process for each number."""
    about = (
        "The most memory that a process ever held, each measured in a new process with a warm kernel cache, over the "
        "number of candidates and over the number of objects. The smallest call has two candidates and stands for "
        "Python, Warp and the kernels."
    )
    result = Result("memory", "Memory", about)
    task: dict[str, Any] = {"device": settings.device, "seed": settings.seed, "repeat": 1}
    base = children.run({**task, "scenes": [ROOM], "candidates": 2})["peak_mib"]
    table = result.add(
        "candidates", f"Memory over candidates ({ROOM})", (Column("candidates", "candidates", "count"), *TAIL)
    )
    wanted = QUICK_CANDIDATES if settings.quick else CANDIDATES
    for count in sorted({settings.size(c, c) for c in wanted}):
        _measure(table, {"candidates": count}, {**task, "scenes": [ROOM], "candidates": count}, base)
    count = settings.size(32, 4)
    table = result.add(
        "objects", f"Memory over objects ({count} candidates)", (Column("objects", "objects", "count"), *TAIL)
    )
    for objects in QUICK_OBJECTS if settings.quick else OBJECTS:
        _measure(table, {"objects": objects}, {**task, "scenes": [objects], "candidates": count}, base)
    designs = QUICK_DESIGNS if settings.quick else DESIGNS
    table = result.add(
        "designs",
        "Memory over designs in one process",
        (Column("designs", "designs", "count"), Column("held", "RSS [MiB]", "mib")),
    )
    made = children.run(
        {"device": settings.device, "seed": settings.seed, "designs": designs}, module="benchmarks.many_designs"
    )
    table.rows += [{"designs": int(count), "held": held} for count, held in made["mib"].items()]
    if made["ratio"] is not None:
        result.notes.append(f"After {designs} designs {made['ratio']:.2f} of what was held after {made['warm']}.")
        if made["ratio"] > FLAT:
            result.failures.append(f"memory grows over designs: {made['ratio']:.2f} of what it was")
    result.notes.append(f"The smallest call peaks at {base:.0f} MiB." if base else "Peak memory is not known here.")
    for name in ("candidates", "objects"):
        result.plots.append(Plot(f"memory-{name}", "Peak RSS [MiB]", name, name, ("peak",)))
    return result


def _measure(table: Table, row: dict[str, Any], task: dict[str, Any], base: float | None) -> None:
    found = children.run(task)
    peak = found["peak_mib"]
    table.rows.append(
        row
        | {
            "peak": peak,
            "more": None if peak is None or base is None else max(0.0, peak - base),
            "device": found["device_mib"],
            "valid": found["calls"][0]["valid"],
        }
    )
