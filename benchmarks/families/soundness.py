"""Whatever the engine calls valid, the judge calls valid: over the whole zoo, all starts, several seeds."""

from __future__ import annotations

import numpy as np

from benchmarks import rooms
from benchmarks.audit import audit, spread
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.starts import STARTS, start
from sceneweaver.layout import refine

TARGET = 20_000
QUICK_TARGET = 100
MOST_ROUNDS = 12
STRICT = 32  # of what the engine calls invalid, judged in each call

COLUMNS = (
    Column("room", "room"),
    Column("objects", "objects", "count"),
    Column("candidates", "candidates", "count"),
    Column("claimed", "status valid", "count"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
    Column("refused", "others judged", "count"),
    Column("strict", "valid all the same", "count"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Judge everything that is called valid, seed after seed, until there is enough of it."""
    target = QUICK_TARGET if settings.quick else TARGET
    if settings.most is not None:
        target = min(target, settings.most)
    about = (
        f"At least {target:,} layouts that the engine calls valid, from random, sample and noisy starts with several "
        "seeds, each judged in float64 by the independent judge. An exception is one that the judge calls invalid: "
        "there must be none. Of those that the engine calls invalid a few are judged, too: valid all the same means "
        "that the engine is stricter there than it has to be, which is no error."
    )
    result = Result("soundness", "Soundness", about)
    names = rooms.chosen(settings, rooms.ROOMS)
    counts: dict[str, dict[str, int]] = {
        name: dict.fromkeys(("candidates", "claimed", "judged", "exceptions", "refused", "strict"), 0) for name in names
    }
    rounds = 0
    while rounds < MOST_ROUNDS and sum(c["judged"] for c in counts.values()) < target:
        for name in names:
            for kind in STARTS:
                _one(settings, judge, result, counts[name], name, kind, settings.seed + rounds)
        rounds += 1
    table = result.add("soundness", "Status valid against the judge", COLUMNS)
    for name in names:
        table.rows.append({"room": name, "objects": len(rooms.load(name).objects), **counts[name]})
    total = {key: sum(c[key] for c in counts.values()) for key in next(iter(counts.values()))}
    table.rows.append({"room": "all", "objects": None, **total})
    result.notes.append(f"Rounds over the rooms, each with a seed of its own: {rounds}.")
    if total["judged"] < target:
        result.notes.append(f"Only {total['judged']:,} of {target:,} layouts were valid in all rounds.")
    return result


def _one(
    settings: Settings, judge: Judge, result: Result, count: dict[str, int], name: str, kind: str, seed: int
) -> None:
    candidates = settings.size(rooms.by_size(name, 256, 64, 8), rooms.by_size(name, 8, 4, 2))
    scene, init = start(rooms.load(name), kind, candidates, seed)
    solution = refine(scene, candidates=candidates, seed=seed, init=init, device=settings.device)
    found = audit(solution, judge, result, f"{name} {kind} seed {seed}", settings.out)
    others = spread(np.flatnonzero(solution.status != 0), STRICT)
    opinions = judge(scene, solution.poses[others])
    count["candidates"] += len(solution.status)
    count["claimed"] += len(found.valid)
    count["judged"] += len(found.judged)
    count["exceptions"] += found.exceptions
    count["refused"] += len(others)
    count["strict"] += sum(o.valid for o in opinions)
