"""What an edit of one object does to the others."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.audit import audit
from benchmarks.changes import CHANGES, involved
from benchmarks.judging import Judge
from benchmarks.results import Column, Plot, Result, Table
from benchmarks.settings import Settings
from benchmarks.timing import timed
from sceneweaver.layout import refine
from sceneweaver.scene import Scene

STILL = 0.01  # [m] what counts as not moved
STARTS = 1024  # random starts that look for another way, with the bystanders fixed

MEASURES = (
    Column("edits", "edits", "count"),
    Column("valid", "valid", "share"),
    Column("solved", "solved", "share"),
    Column("exceptions", "exceptions", "count"),
    Column("calm", "others still", "share"),
    Column("forced", "no other way", "count"),
    Column("typical", "median [mm]", "mm"),
    Column("worst", "most [mm]", "mm"),
    Column("seconds", "s a call", "number"),
)
DETAIL = (
    "room",
    "edit",
    "number",
    "object",
    "bystanders",
    "valid",
    "solved",
    "furthest",
    "who",
    "forced",
    "exceptions",
    "seconds",
)


def run(settings: Settings, judge: Judge) -> Result:
    """Edit witnesses, refine them from where they are, and see who moved."""
    about = (
        'The witness of a room after an edit of one object, refined with init="current". Bystanders are the objects '
        "that are neither edited nor named by any violation of the edited scene, nor stand on such an object: how far "
        "the best valid layout moves them. Of a good editor they stay where they are."
    )
    result = Result("edits", "Edits", about)
    detail = Table("detail", "Every edit", [Column(key, key) for key in DETAIL], keys=4, detail=True)
    for name in rooms.chosen(settings, rooms.ROOMS):
        for edit in CHANGES:
            times = 1 if settings.quick else rooms.by_size(name, 4, 3, 1)
            detail.rows += [_one(settings, judge, result, name, edit, k) for k in range(times)]
    table = result.add("edits", "By edit", (Column("edit", "edit"), *MEASURES))
    table.rows = [_summary({"edit": edit}, [r for r in detail.rows if r["edit"] == edit]) for edit in CHANGES]
    table = result.add("rooms", "By room", (Column("room", "room"), *MEASURES))
    table.rows = [
        _summary({"room": name}, [r for r in detail.rows if r["room"] == name])
        for name in dict.fromkeys(r["room"] for r in detail.rows)
    ]
    result.tables.append(detail)
    skipped = sum(row["object"] is None for row in detail.rows)
    result.notes.append(
        f"{settings.size(16, 4)} candidates a call. Valid: share of candidates. Solved: the best layout is valid. "
        "Others still: share of edits for which no bystander moves more than 1 cm. No other way: edits, among the "
        f"others, for which {settings.size(STARTS, 4):,} random starts with all bystanders fixed find no valid layout "
        "either. Median and most: over edits, how "
        f"far the bystander moves that moves furthest. Edits for which there was no free spot: {skipped}."
    )
    title = "Edits solved, and edits after which the others stood still"
    result.plots.append(Plot("edits", title, "edits", "edit", ("solved", "calm")))
    return result


def _one(settings: Settings, judge: Judge, result: Result, name: str, edit: str, number: int) -> dict[str, Any]:
    rng = np.random.default_rng([settings.seed, number, list(CHANGES).index(edit)])
    changed = CHANGES[edit](rooms.load(name), rng)
    row: dict[str, Any] = {"room": name, "edit": edit, "number": number, "object": None}
    if changed is None:
        return row
    scene, edited = changed
    busy = involved(scene, edited)
    bystanders = [i for i, o in enumerate(scene.objects) if o.id not in busy]
    count = settings.size(16, 4)
    solution, seconds = timed(scene, settings, candidates=count, seed=settings.seed, init="current")
    found = audit(solution, judge, result, f"{name} {edit} {number}", settings.out)
    best = int(solution.order[0])
    moved = np.linalg.norm(solution.poses[best, bystanders, :3] - rooms.witness(scene)[bystanders, :3], axis=1)
    solved = bool(solution.status[best] == 0)
    who = int(moved.argmax()) if len(moved) else None
    far = bool(moved.max(initial=0.0) > STILL)
    return row | {
        "object": edited,
        "bystanders": len(bystanders),
        "valid": len(found.valid) / count,
        "solved": solved,
        "furthest": float(moved.max(initial=0.0)) if solved else None,
        "who": None if who is None or not solved else scene.objects[bystanders[who]].id,
        "forced": solved and far and not _another_way(settings, scene, bystanders),
        "exceptions": found.exceptions,
        "seconds": seconds,
    }


def _another_way(settings: Settings, scene: Scene, bystanders: list[int]) -> bool:
    """Whether a search finds a valid layout with the bystanders where they are."""
    still = {scene.objects[i].id for i in bystanders}
    objects = tuple(o.model_copy(update={"fixed": True}) if o.id in still else o for o in scene.objects)
    held = scene.model_copy(update={"objects": objects})
    found = refine(held, candidates=settings.size(STARTS, 4), seed=settings.seed, init="random", device=settings.device)
    return bool(np.any(found.status == 0))


def _summary(key: dict[str, Any], rows: list[dict[str, Any]]) -> dict[str, Any]:
    done = [r for r in rows if r["object"] is not None]
    far = [r["furthest"] for r in done if r["furthest"] is not None]

    def mean(name: str) -> float | None:
        return float(np.mean([r[name] for r in done])) if done else None

    return key | {
        "edits": len(done),
        "valid": mean("valid"),
        "solved": mean("solved"),
        "exceptions": sum(r["exceptions"] for r in done),
        "calm": float(np.mean([f <= STILL for f in far])) if far else None,
        "forced": sum(r["forced"] for r in done),
        "typical": float(np.median(far)) if far else None,
        "worst": max(far) if far else None,
        "seconds": mean("seconds"),
    }
