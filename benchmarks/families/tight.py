"""Random starts in tight bedrooms made for this: how many end valid."""

from __future__ import annotations

from typing import Any

from benchmarks.audit import audit
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.starts import blind
from benchmarks.tight_rooms import tight_room
from benchmarks.timing import timed, warm
from sceneweaver.scene import Scene

SEEDS = range(5, 13)
QUICK_SEEDS = range(7, 9)

COLUMNS = (
    Column("seed", "seed"),
    Column("size", "room [m]"),
    Column("objects", "objects", "count"),
    Column("floor", "floor covered", "share"),
    Column("walls", "walls taken", "share"),
    Column("candidates", "candidates", "count"),
    Column("claimed", "status valid", "share"),
    Column("valid", "fully valid", "share"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
    Column("seconds", "seconds", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Refine tight rooms from random starts, and judge all that is called valid."""
    about = (
        "Bedrooms in which furniture covers half of the floor and takes half of the walls, each with a known valid "
        "layout that is taken out: the share of random starts that end fully valid. All that the engine calls valid "
        "is judged; an exception is a contradiction and must not be."
    )
    result = Result("tight", "Tight rooms", about)
    table = result.add("tight", "Random starts by room", COLUMNS)
    table.rows = [_one(settings, judge, result, seed) for seed in (QUICK_SEEDS if settings.quick else SEEDS)]
    result.notes.append("Seeds are those of the rooms. Walls taken: widths of what stands at walls over their length.")
    return result


def _one(settings: Settings, judge: Judge, result: Result, seed: int) -> dict[str, Any]:
    scene, count = tight_room(seed), settings.size(1024, 16)
    begin = blind(scene)
    warm(begin, settings, "random")
    solution, seconds = timed(begin, settings, candidates=count, seed=settings.seed, init="random")
    found = audit(solution, judge, result, f"{scene.id} seed {settings.seed}", settings.out)
    width, depth = scene.room.outline[2]
    floor, walls = fill(scene)
    return {
        "seed": str(seed),
        "size": f"{width:.2f} x {depth:.2f}",
        "objects": len(scene.objects),
        "floor": floor,
        "walls": walls,
        "candidates": len(solution.status),
        "claimed": len(found.valid) / len(solution.status),
        "valid": len(found.agreed) / len(solution.status),
        "judged": len(found.judged),
        "exceptions": found.exceptions,
        "seconds": seconds,
    }


def fill(scene: Scene) -> tuple[float, float]:
    """Shares of a rectangular room's floor that furniture covers, and of its walls that backs of furniture take."""
    width, depth = scene.room.outline[2]
    standing = [o for o in scene.objects if o.mount == "floor"]
    backed = {r.subject for r in scene.relations if r.type == "against_wall"}
    floor = sum(o.size[0] * o.size[1] for o in standing) / (width * depth)
    return floor, sum(o.size[1] for o in standing if o.id in backed) / (2 * (width + depth))
