"""Time a candidate over the number of objects and over the number of candidates."""

from __future__ import annotations

from typing import Any

from benchmarks.audit import audit
from benchmarks.floors import floor
from benchmarks.judging import Judge
from benchmarks.machine import resolve
from benchmarks.results import Column, Plot, Result
from benchmarks.rooms import load
from benchmarks.settings import Settings
from benchmarks.starts import blind
from benchmarks.timing import timed, warm
from sceneweaver.scene import Scene

OBJECTS = (50, 100, 200, 350, 500)
CANDIDATES = (64, 128, 256, 512, 1024, 2048, 4096, 8192)
QUICK_OBJECTS = (50, 100)
QUICK_CANDIDATES = (8, 64)
ROOM = "bedroom-small"
JUDGED = 256

TAIL = (
    Column("claimed", "status valid", "share"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
    Column("seconds", "seconds", "number"),
    Column("each", "ms each", "number"),
    Column("each_valid", "ms each valid one", "number"),
)
BY_OBJECTS = (
    Column("objects", "objects", "count"),
    Column("relations", "relations", "count"),
    Column("candidates", "candidates", "count"),
    *TAIL,
)


def run(settings: Settings, judge: Judge) -> Result:
    """Time warm calls over objects, then over candidates."""
    about = (
        "Time over the number of objects on generated open-plan floors (tables with four chairs, desks with a chair, "
        "cabinets at walls, plants) at one floor fill (0.2) and one mix of relations, and over the number of "
        f"candidates on {ROOM}. Starts are drawn from the relations; times are warm."
    )
    result = Result("scaling", "Scaling", about)
    _objects(settings, judge, result)
    _candidates(settings, judge, result)
    return result


def _objects(settings: Settings, judge: Judge, result: Result) -> None:
    count = settings.size(32 if resolve(settings.device) == "cpu" else 1024, 4)
    table = result.add("objects", "Time over objects", BY_OBJECTS)
    for objects in QUICK_OBJECTS if settings.quick else OBJECTS:
        scene = floor(objects)
        side = scene.room.outline[2][0]
        row = {"objects": objects, "relations": len(scene.relations), "area": side * side, "candidates": count}
        table.rows.append(row | _measure(settings, judge, result, scene, count))
    first, last = table.rows[0], table.rows[-1]
    times = last["objects"] / first["objects"]
    for key, what in (("each", "a candidate"), ("each_valid", "a valid candidate")):
        if first[key] and last[key]:
            result.notes.append(
                f"From {first['objects']} to {last['objects']} objects ({times:g} times) the time of {what} grows "
                f"{last[key] / first[key]:.1f} times."
            )
    result.plots.append(
        Plot("scaling-objects", "Time a candidate [ms]", "objects", "objects", ("each", "each_valid"), log=True)
    )


def _candidates(settings: Settings, judge: Judge, result: Result) -> None:
    table = result.add(
        "candidates", f"Time over candidates ({ROOM})", (Column("candidates", "candidates", "count"), *TAIL)
    )
    wanted = QUICK_CANDIDATES if settings.quick else CANDIDATES
    for count in sorted({settings.size(c, c) for c in wanted}):
        table.rows.append({"candidates": count} | _measure(settings, judge, result, load(ROOM), count))
    result.plots.append(
        Plot("scaling-candidates", "Time a candidate [ms]", "candidates", "candidates", ("each",), log=True)
    )


def _measure(settings: Settings, judge: Judge, result: Result, scene: Scene, count: int) -> dict[str, Any]:
    scene = blind(scene)
    warm(scene, settings)
    solution, seconds = timed(scene, settings, candidates=count, seed=settings.seed)
    label = f"{scene.id} sample of {count} seed {settings.seed}"
    found = audit(solution, judge, result, label, settings.out, most=JUDGED)
    return {
        "claimed": len(found.valid) / count,
        "judged": len(found.judged),
        "exceptions": found.exceptions,
        "seconds": seconds,
        "each": 1e3 * seconds / count,
        "each_valid": 1e3 * seconds / len(found.valid) if len(found.valid) else None,
    }
