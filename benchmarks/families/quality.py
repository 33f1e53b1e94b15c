"""How many candidates become valid, and how different they are, from three kinds of starts."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.audit import audit, spread
from benchmarks.judging import Judge, share
from benchmarks.results import Column, Plot, Result
from benchmarks.rivals import Rival, present, solve
from benchmarks.settings import Settings
from benchmarks.signature import count_distinct
from benchmarks.starts import STARTS, noisy_poses, random_poses, start
from benchmarks.timing import timed, warm
from sceneweaver.scene import Scene

OURS = "sceneweaver"
WALKED = 20  # layouts whose floor is flooded

ROOM, START = Column("room", "room"), Column("start", "start")
VALIDITY = (
    ROOM,
    START,
    Column("candidates", "candidates", "count"),
    Column("claimed", "status valid", "share"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
    Column("soft", "soft held", "share"),
    Column("walkable", "walkable", "share"),
    Column("seconds", "seconds", "number"),
)
VARIETY = (
    ROOM,
    START,
    Column("good", "fully valid", "count"),
    Column("distinct", "distinct (signature)", "count"),
    Column("different", "different poses (> 1 cm)", "count"),
)
RIVALS = (
    ROOM,
    START,
    Column("system", "system"),
    Column("candidates", "candidates", "count"),
    Column("valid", "fully valid", "share"),
    Column("solid", "no overlap", "share"),
    Column("hard", "hard held", "share"),
    Column("seconds", "seconds", "number"),
    Column("rate", "valid / s", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Refine every room from every kind of start; rivals beside it."""
    about = (
        "Candidates that become valid from random starts, from starts drawn from the relations (sample) and from noisy "
        "ones (the witness with N(0, 0.3 m) and N(0, 15 degrees) noise on what stands on the floor). The engine calls "
        "a candidate valid; the judge, which shares no arithmetic with it, judges each of those: an exception is a "
        "contradiction and must not be. Distinct layouts differ in the wall, the 0.5 m cell or the eighth of a turn of "
        "some floor object; of different poses, any two have some object more than 1 cm or 1 degree apart. "
        "Witnesses are taken out of the scenes for random and sample starts."
    )
    result = Result("quality", "Quality", about)
    ours: list[dict[str, Any]] = []
    everyone: list[dict[str, Any]] = []
    rivals = present(settings, result.notes)
    for name in rooms.chosen(settings, rooms.ROOMS):
        for kind in STARTS:
            ours.append(_ours(result, settings, judge, name, kind))
            everyone.append(ours[-1])
            if kind != "sample":
                everyone += [_theirs(rival, settings, judge, name, kind) for rival in rivals]
    result.add("validity", "Validity by room and start", VALIDITY, keys=2).rows = ours
    result.add("variety", "Different layouts among the fully valid ones", VARIETY, keys=2).rows = ours
    result.add("rivals", "Beside the rivals", RIVALS, keys=3).rows = everyone
    result.notes.append(
        f"All that is valid by its status is judged. Soft held: the share of soft relations that hold. Walkable: the "
        f"mean share of the floor that a robot can reach, over {WALKED} valid layouts at most."
    )
    result.notes.append(
        "No overlap: nothing collides or leaves the room. Hard held: the share of hard relations that hold. Rivals get "
        "fewer candidates where they are slow; all of their layouts are judged."
    )
    for kind in STARTS:
        _plot(result, [row for row in everyone if row["start"] == kind], kind)
    return result


def _ours(result: Result, settings: Settings, judge: Judge, name: str, kind: str) -> dict[str, Any]:
    scene, count = rooms.load(name), rooms.candidates(settings, name)
    begin, init = start(scene, kind, count, settings.seed)
    warm(begin, settings, init if isinstance(init, str) else init[:2])
    solution, seconds = timed(begin, settings, candidates=count, seed=settings.seed, init=init)
    found = audit(solution, judge, result, f"{name} {kind} seed {settings.seed}", settings.out)
    agreed = found.agreed
    distinct, different = count_distinct(scene, solution.poses[agreed])
    return {
        "room": name,
        "objects": len(scene.objects),
        "start": kind,
        "system": OURS,
        "candidates": len(solution.status),
        "claimed": len(found.valid) / len(solution.status),
        "judged": len(found.judged),
        "exceptions": found.exceptions,
        "valid": len(agreed) / len(solution.status),
        "good": len(agreed),
        "distinct": distinct,
        "different": different,
        "soft": found.soft,
        "walkable": _walkable(judge, scene, solution.poses[agreed]),
        "seconds": seconds,
        "rate": len(agreed) / seconds,
    }


def _theirs(rival: Rival, settings: Settings, judge: Judge, name: str, kind: str) -> dict[str, Any]:
    scene = rooms.load(name)
    count = min(rooms.candidates(settings, name), rival.most(len(scene.objects), settings.device))
    starts = (noisy_poses if kind == "noisy" else random_poses)(scene, count, settings.seed)
    poses, seconds = solve(rival, scene, starts, settings.seed, settings.device)
    opinions = judge(scene, poses)
    good = [i for i, o in enumerate(opinions) if o.valid]
    distinct, different = count_distinct(scene, poses[good])
    return {
        "room": name,
        "objects": len(scene.objects),
        "start": kind,
        "system": rival.name,
        "candidates": count,
        "judged": count,
        "valid": len(good) / count,
        "solid": sum(o.solid for o in opinions) / count,
        "hard": share([o.hard for o in opinions]),
        "good": len(good),
        "distinct": distinct,
        "different": different,
        "soft": share([opinions[i].soft for i in good]),
        "walkable": _walkable(judge, scene, poses[good]),
        "seconds": seconds,
        "rate": len(good) / seconds,
    }


def _walkable(judge: Judge, scene: Scene, poses: np.ndarray) -> float | None:
    """Mean walkable share of some of the layouts."""
    some = spread(np.arange(len(poses)), WALKED)
    shares = [o.walkable for o in judge(scene, poses[some], walkable=True) if o.walkable is not None]
    return sum(shares) / len(shares) if shares else None


def _plot(result: Result, rows: list[dict[str, Any]], kind: str) -> None:
    """A picture of fully valid shares from one kind of start."""
    name, title = f"quality-{kind}", f"Fully valid from {kind} starts"
    columns = (ROOM, Column("system", "system"), Column("valid", "fully valid", "share"))
    kept = [{c.key: row[c.key] for c in columns} for row in rows]
    result.add(name, title, columns, keys=2, detail=True).rows = kept
    result.plots.append(Plot(name, title, name, "room", ("valid",), series="system"))
