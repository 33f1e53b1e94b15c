"""The feasible layout nearest to a disturbed one: how often it is found, how near it is, and how long that takes."""

from __future__ import annotations

import importlib.util
import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.audit import audit
from benchmarks.judging import Judge
from benchmarks.results import Column, Plot, Result
from benchmarks.settings import Settings
from benchmarks.starts import noisy_poses
from benchmarks.timing import timed, warm
from sceneweaver.scene import Scene

NOISE_M = 0.2
NOISE_RAD = math.radians(10)
ARM = 0.5  # [m] that a radian counts as
RIVAL = "benchmarks.rivals.drake_projection"
PATIENCE = 10.0  # [s] that the rival has for a layout

ROOM, OBJECTS = Column("room", "room"), Column("objects", "objects", "count")
OURS = (
    Column("layouts", "layouts", "count"),
    Column("feasible", "feasible", "share"),
    Column("exceptions", "exceptions", "count"),
    Column("movement", "movement [m]", "number"),
    Column("ms", "ms a layout", "number"),
)
BESIDE = (
    ROOM,
    OBJECTS,
    Column("theirs", "layouts", "count"),
    Column("their_feasible", "Drake feasible", "share"),
    Column("their_ms", "Drake ms", "number"),
    Column("both", "both", "count"),
    Column("ratio", "movement / Drake's", "number"),
    Column("our_ms", "our ms", "number"),
)

Project = Callable[[Scene, np.ndarray, float], tuple[np.ndarray, bool]]


def run(settings: Settings, judge: Judge) -> Result:
    """Disturb witnesses, project them, and let Drake do the same where it is there."""
    about = (
        f"Witnesses with N(0, {NOISE_M} m) and N(0, {math.degrees(NOISE_RAD):.0f} degrees) noise on every floor "
        "object, moved as little as makes them feasible. Movement is the root of the sum over objects of dx^2 + dy^2 + "
        f"({ARM} m/rad dyaw)^2, the mean over layouts that are feasible by the judge."
    )
    result = Result("projection", "Projection", about)
    project = _rival(settings, result)
    bodies = result.add("bodies", "Bodies in a room: collisions and bounds only", (ROOM, OBJECTS, *OURS))
    scenes = result.add("scenes", "Whole scenes", (ROOM, Column("what", "relations"), OBJECTS, *OURS), keys=2)
    for name in rooms.chosen(settings, (*rooms.SMALL, *rooms.MIDDLE)):
        bodies.rows.append(_bodies(settings, judge, result, name, project))
        for what, change in (("off", without_relations), ("on", lambda scene: scene)):
            row, _, _ = _ours(settings, judge, result, name, what, change(rooms.load(name)))
            scenes.rows.append({"what": what, **row})
    compared = [row for row in bodies.rows if "theirs" in row]
    if compared:
        result.add("drake", "The same beside Drake (SNOPT), one layout at a time", BESIDE).rows = compared
    result.notes.append(
        "Bodies: floor objects only, without relations, zones, doors and windows, as Drake knows of none. Whole scenes "
        "keep their zones, doors, windows and what stands on surfaces; their relations are left out (off) or are to "
        "hold as well (on). Milliseconds are wall time of the whole call over its layouts. Movement over Drake's: "
        "the ratio of the means over the layouts that both make feasible."
    )
    result.plots.append(Plot("projection", "Feasible after projection", "bodies", "room", ("feasible",)))
    return result


def without_relations(scene: Scene) -> Scene:
    """The scene with its zones and openings, but nothing that has to hold between objects."""
    return scene.model_copy(update={"relations": ()})


def bodies_of(scene: Scene) -> Scene:
    """The floor objects of a scene as mere bodies in its room."""
    objects = tuple(o.model_copy(update={"zones": (), "surfaces": ()}) for o in scene.objects if o.mount == "floor")
    room = scene.room.model_copy(update={"doors": (), "windows": ()})
    return scene.model_copy(update={"objects": objects, "relations": (), "room": room})


def movement(scene: Scene, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """How far layouts [B, N, 4] moved [m]; what stands on an object goes with it and does not count."""
    roots = [i for i, o in enumerate(scene.objects) if o.support is None]
    d = (after - before)[:, roots]
    turn = np.remainder(d[..., 3] + math.pi, 2 * math.pi) - math.pi
    return np.sqrt(np.sum(d[..., :3] ** 2, axis=(1, 2)) + np.sum((ARM * turn) ** 2, axis=1))


def _rival(settings: Settings, result: Result) -> Project | None:
    """Drake's projection where it can run; else a note says why not."""
    if settings.rivals is not None and not any("drake" in name.lower() for name in settings.rivals):
        return None
    try:
        module = importlib.import_module(RIVAL)
    except ImportError as error:
        result.notes.append(f"Drake left out: {error.name or error} cannot be imported")
        return None
    if importlib.util.find_spec("pydrake") is None:
        result.notes.append("Drake left out: it is not installed; pip install drake")
        return None
    return module.project


def _ours(
    settings: Settings, judge: Judge, result: Result, name: str, what: str, scene: Scene
) -> tuple[dict[str, Any], np.ndarray, np.ndarray]:
    """Our row, the layouts before, and our movement [B] with NaN where there is nothing feasible."""
    count = settings.size(rooms.by_size(name, 1024, 512, 32), rooms.by_size(name, 16, 4, 2))
    before = noisy_poses(scene, count, settings.seed, NOISE_M, NOISE_RAD)
    warm(scene, settings, before[:2], optimizer="projection")
    options = {"seed": settings.seed, "init": before, "optimizer": "projection"}
    solution, seconds = timed(scene, settings, **options)
    found = audit(solution, judge, result, f"{name} {what} projection", settings.out)
    moved = np.full(count, math.nan)
    good = found.agreed
    moved[good] = movement(scene, before[good], solution.poses[good].astype(np.float64))
    row = {
        "room": name,
        "objects": len(scene.objects),
        "layouts": count,
        "feasible": len(good) / count,
        "exceptions": found.exceptions,
        "movement": float(np.mean(moved[good])) if good else None,
        "ms": 1e3 * seconds / count,
    }
    return row, before, moved


def _bodies(settings: Settings, judge: Judge, result: Result, name: str, project: Project | None) -> dict[str, Any]:
    scene = bodies_of(rooms.load(name))
    row, before, ours = _ours(settings, judge, result, name, "bodies", scene)
    few = min(len(before), settings.size(rooms.by_size(name, 32, 8, 0), 1))
    if project is None or not few:
        return row
    project(scene, before[0], PATIENCE)  # so that what it builds for a scene is there
    began, after = time.perf_counter(), []
    for start in before[:few]:
        after.append(np.asarray(project(scene, start, PATIENCE)[0], dtype=np.float64))
    ms = 1e3 * (time.perf_counter() - began) / few
    after = np.array(after)
    good = np.array([o.valid for o in judge(scene, after)])
    both = good & np.isfinite(ours[:few])
    theirs = movement(scene, before[:few], after)
    return row | {
        "theirs": few,
        "their_feasible": float(good.mean()),
        "their_ms": ms,
        "both": int(both.sum()),
        "ratio": float(ours[:few][both].mean() / theirs[both].mean()) if both.any() else None,
        "our_ms": row["ms"],
    }
