"""The first call in a new process, with an empty kernel cache and with a filled one."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from benchmarks import children
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings

FIRST = "bedroom-small"
OTHERS = ("dining-round", "living-dining-L", "office-20", "gym-30")  # between them every relation type of the zoo
QUICK_OTHERS = ("dining-round",)

COLUMNS = (
    Column("case", "case"),
    Column("scene", "room"),
    Column("imported", "import [s]", "number"),
    Column("first", "1st call [s]", "number"),
    Column("second", "2nd call [s]", "number"),
    Column("process", "process [s]", "number"),
    Column("valid", "valid", "count"),
    Column("before", "cached", "count"),
    Column("new", "new", "count"),
)


def modules(folder: Path) -> set[str]:
    """Compiled modules in a kernel cache."""
    return {p.name for p in folder.rglob("wp_*") if p.is_dir()}


def run(settings: Settings, judge: Judge) -> Result:
    """Start processes with a kernel cache of their own."""
    about = (
        "What a new process waits for: the import, the first call with an empty Warp kernel cache (everything is "
        "compiled), the same in a second process that finds the cache filled, and rooms with other relations: built-in "
        "relations are data, so that those compile nothing. Cached: modules in the cache before; new: those compiled."
    )
    result = Result("cold", "Cold start", about)
    table = result.add("cold", "Cold start", COLUMNS, keys=2)
    task: dict[str, Any] = {"candidates": settings.size(64, 8), "device": settings.device, "seed": settings.seed}
    with tempfile.TemporaryDirectory(prefix="sceneweaver-cold-") as name:
        cache = Path(name)
        for case, scene in (
            ("empty cache", FIRST),
            ("filled cache", FIRST),
            *(("other relations", other) for other in (QUICK_OTHERS if settings.quick else OTHERS)),
        ):
            before = modules(cache)
            found = children.run({**task, "scenes": [scene]}, {"WARP_CACHE_PATH": str(cache)})
            call, after = found["calls"][0], modules(cache)
            table.rows.append(
                {
                    "case": case,
                    "scene": scene,
                    "imported": found["imported"],
                    "first": call["seconds"][0],
                    "second": call["seconds"][1],
                    "process": found["process"],
                    "valid": call["valid"],
                    "before": len(before),
                    "new": len(after - before),
                }
            )
            if case != "empty cache" and after - before:
                result.notes.append(f"{scene} ({case}) compiled {len(after - before)} more: {_names(after - before)}.")
    if len(table.rows) > 1 and not any(row["new"] for row in table.rows[1:]):
        result.notes.append("Once the cache is filled, no room compiles anything.")
    result.notes.append(f"{task['candidates']} candidates a call; each row is a process of its own.")
    return result


def _names(found: set[str]) -> str:
    return ", ".join(sorted(found))
