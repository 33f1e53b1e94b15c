"""Edits of a live session: how long one takes, and who moves."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.changes import CHANGES, involved
from benchmarks.families.edits import STILL
from benchmarks.judging import Judge
from benchmarks.results import Column, Result, Table
from benchmarks.settings import Settings
from sceneweaver.editing import EditResult, EditSession
from sceneweaver.scene import Scene

SIZED = 30  # objects of a room for which an edit has to be quick

MEASURES = (
    Column("edits", "edits", "count"),
    Column("valid", "valid", "share"),
    Column("still", "others still", "share"),
    Column("calm", "nothing else moved", "share"),
    Column("p50", "p50 [ms]", "number"),
    Column("p95", "p95 [ms]", "number"),
    Column("worst", "most [ms]", "number"),
    Column("cpu50", "CPU p50 [ms]", "number"),
    Column("cpu95", "CPU p95 [ms]", "number"),
)
DETAIL = ("room", "objects", "edit", "number", "object", "valid", "freed", "furthest", "moved", "seconds", "cpu")


def run(settings: Settings, judge: Judge) -> Result:
    """Edit the witness of each room in a session, and take each edit back."""
    about = (
        "The edits of the family `edits`, each in a live session (`sceneweaver.EditSession`) on the witness of a room: "
        "from the edit to a valid scene, the judge included. Bystanders are the objects that are neither edited nor "
        "named by any violation of the edited scene, nor stand on such an object."
    )
    result = Result("live", "Live edits", about)
    detail = Table("detail", "Every edit", [Column(key, key) for key in DETAIL], keys=4, detail=True)
    for name in rooms.chosen(settings, rooms.ROOMS):
        session = EditSession(rooms.load(name), device=settings.device, seed=settings.seed)
        _warm(session)
        for edit in CHANGES:
            times = 1 if settings.quick else rooms.by_size(name, 4, 3, 1)
            detail.rows += [row for k in range(times) if (row := _one(session, judge, settings, name, edit, k))]
    for row in detail.rows:
        if row["valid"] != row["judged"]:
            result.failures.append(f"{row['room']} {row['edit']} {row['number']}: the session and the judge differ")
    sizes = {
        f"rooms of up to {SIZED} objects": [r for r in detail.rows if r["objects"] <= SIZED],
        "all rooms": detail.rows,
    }
    table = result.add("sizes", "By size", (Column("rooms", "rooms"), *MEASURES))
    table.rows = [_summary({"rooms": key}, rows) for key, rows in sizes.items() if rows]
    table = result.add("edits", f"By edit, rooms of up to {SIZED} objects", (Column("edit", "edit"), *MEASURES))
    small = next(iter(sizes.values()))
    table.rows = [_summary({"edit": edit}, [r for r in small if r["edit"] == edit]) for edit in CHANGES if small]
    table = result.add("rooms", "By room", (Column("room", "room"), Column("objects", "objects", "count"), *MEASURES))
    for name in dict.fromkeys(r["room"] for r in detail.rows):
        rows = [r for r in detail.rows if r["room"] == name]
        table.rows.append(_summary({"room": name, "objects": rows[0]["objects"]}, rows))
    result.tables.append(detail)
    result.notes.append(
        "Valid: the scene is valid afterwards, by the judge. Others still: no bystander moves more than 1 cm. Nothing "
        "else moved: nor does anything else but what was edited and what stands on it. Milliseconds of wall time from "
        "call to return, and of the CPU time of all threads; on a busy machine the former says little."
    )
    return result


def _warm(session: EditSession) -> None:
    """Load what the first edits would load."""
    for obj in session.scene.objects[:1]:
        session.move(obj.id, by=(0.3, 0.2))
        session.undo()


def _one(
    session: EditSession, judge: Judge, settings: Settings, name: str, edit: str, number: int
) -> dict[str, Any] | None:
    """One edit, taken back afterwards; None where there is no free spot for it."""
    before = session.scene
    rng = np.random.default_rng([settings.seed, number, list(CHANGES).index(edit)])
    changed = CHANGES[edit](before, rng)
    if changed is None:
        return None
    scene, edited = changed
    cpu = time.process_time()
    done = session.update(scene, [edited])
    cpu = time.process_time() - cpu
    session.undo()
    opinion = judge(scene, rooms.witness(done.scene)[None])[0]
    bystanders = [o.id for o in scene.objects if o.id not in involved(scene, edited)]
    return {
        "room": name,
        "objects": len(before.objects),
        "edit": edit,
        "number": number,
        "object": edited,
        "valid": done.valid,
        "judged": opinion.valid,
        "freed": done.freed,
        "furthest": _furthest(scene, done, bystanders),
        "moved": _furthest(scene, done, [o.id for o in scene.objects if not _with(scene, o.id, edited)]),
        "seconds": done.seconds,
        "cpu": cpu,
    }


def _with(scene: Scene, object_id: str, edited: str) -> bool:
    """Whether an object is the edited one or stands on it."""
    while object_id != edited:
        support = scene.object(object_id).support
        if support is None:
            return False
        object_id = support.object
    return True


def _furthest(scene: Scene, done: EditResult, names: list[str]) -> float:
    """How far that of some objects went that went furthest [m]."""
    steps = [
        np.subtract(done.scene.object(name).pose.position, scene.object(name).pose.position).tolist() for name in names
    ]
    return max((float(np.linalg.norm(step)) for step in steps), default=0.0)


def _summary(key: dict[str, Any], rows: list[dict[str, Any]]) -> dict[str, Any]:
    wall, cpu = np.array([r["seconds"] for r in rows]) * 1e3, np.array([r["cpu"] for r in rows]) * 1e3
    return key | {
        "edits": len(rows),
        "valid": float(np.mean([r["judged"] for r in rows])),
        "still": float(np.mean([r["furthest"] <= STILL for r in rows])),
        "calm": float(np.mean([r["moved"] <= STILL for r in rows])),
        "p50": float(np.percentile(wall, 50)),
        "p95": float(np.percentile(wall, 95)),
        "worst": float(wall.max()),
        "cpu50": float(np.percentile(cpu, 50)),
        "cpu95": float(np.percentile(cpu, 95)),
    }
