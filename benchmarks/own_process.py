"""Rooms designed side by side, each in a process of its own that keeps to one core.

``python -m benchmarks.own_process TASK`` designs one: TASK is a JSON object with the fields of `Task` and ``core``,
``device``, ``candidates``, ``seconds`` and ``file``, to which the scene is written; it prints one line of JSON.
"""

from __future__ import annotations

import json
import os
import queue
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from benchmarks.settings import ROOT, Settings
from sceneweaver.scene import Scene

GRACE_S = 120
"""Seconds beyond its time limit after which a process is ended, or all that one without a limit gets."""

LONGEST = ("restaurant", "office", "gym", "kitchen", "living_room", "meeting_room", "childrens_room")
"""Kinds of rooms that take longest; they begin first, so that no core waits for them at the end."""


@dataclass(frozen=True)
class Task:
    """A room to design: kind, seed, and switches of the agent under a name."""

    room: str
    seed: int
    variant: str = ""
    switches: Mapping[str, Any] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """A name for a folder."""
        return "-".join(filter(None, (self.room, str(self.seed), self.variant.replace(" ", "_"))))


@dataclass(frozen=True)
class Made:
    """A designed room: its scene, what judge and critic say of it, seconds by the clock and of the processor."""

    task: Task
    scene: Scene
    valid: bool
    cut_off: bool
    grades: Mapping[str, float]
    counts: Mapping[str, int]
    seconds: float
    cpu: float

    @property
    def total(self) -> float:
        """Mean of the grades."""
        return sum(self.grades.values()) / max(1, len(self.grades))


def designed_apart(tasks: Sequence[Task], settings: Settings, limit: float | None) -> tuple[list[Made], list[str]]:
    """Design rooms, as many at a time as ``settings.jobs``; those that were made in the order of the tasks.

    Args:
        tasks: what to design; the scenes are kept below ``settings.out``, a folder for each.
        settings: device, candidates, processes and folder.
        limit: time limit of a design [s]; None: none.

    Returns:
        What was made, and a line for each that broke down.
    """
    cores: queue.SimpleQueue[int | None] = queue.SimpleQueue()
    known = sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []
    for k in range(settings.jobs):
        cores.put(known[k % len(known)] if known else None)

    def one(task: Task) -> Made | str:
        core = cores.get()
        try:
            return _run(task, core, settings, limit)
        finally:
            cores.put(core)

    order = sorted(tasks, key=lambda t: LONGEST.index(t.room) if t.room in LONGEST else len(LONGEST))
    with ThreadPoolExecutor(settings.jobs) as pool:
        jobs = {id(task): pool.submit(one, task) for task in order}
        found = [jobs[id(task)].result() for task in tasks]
    return [m for m in found if isinstance(m, Made)], [m for m in found if isinstance(m, str)]


def _run(task: Task, core: int | None, settings: Settings, limit: float | None) -> Made | str:
    file = settings.out / "designs" / task.name / "scene.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    more = {"core": core, "device": settings.device, "candidates": settings.most, "seconds": limit, "file": str(file)}
    command = [sys.executable, "-m", "benchmarks.own_process", json.dumps({**asdict(task), **more})]
    try:
        done = subprocess.run(
            command, cwd=ROOT, capture_output=True, text=True, timeout=None if limit is None else limit + GRACE_S
        )
    except subprocess.TimeoutExpired:
        return f"{task.name}: not done {GRACE_S} s after its time limit"
    if done.returncode:
        return f"{task.name}: failed with {done.returncode}: {done.stderr.strip()[-500:]}"
    row = json.loads(done.stdout.strip().splitlines()[-1])
    return Made(task, Scene.load(file), **row)


def _design(options: dict[str, Any]) -> dict[str, Any]:
    """Design one room and write its scene."""
    began = time.perf_counter()
    if options["core"] is not None:
        os.sched_setaffinity(0, {options["core"]})
    from benchmarks.designs import request
    from sceneweaver.agent import design
    from sceneweaver.critic import review_scene
    from sceneweaver.knowledge import room_type

    made = design(
        request(options["room"]),
        seed=options["seed"],
        device=options["device"],
        candidates=options["candidates"],
        time_limit=options["seconds"],
        **options["switches"],
    )
    seconds, cpu = time.perf_counter() - began, time.process_time()
    made.scene.save(Path(options["file"]))
    report = made.report
    # whatever the agent looked at: all the rules
    review = review_scene(made.scene, report, room_type(made.scene.room.type), made.brief)
    return {
        "valid": report.valid,
        "cut_off": any(note.startswith("the work was cut off") for note in made.notes),
        "grades": review.grades,
        "counts": {
            "objects": report.placed,
            "out": report.out_of_bounds,
            "colliding": report.collisions,
            "dropped": report.dropped,
        },
        "seconds": seconds,
        "cpu": cpu,
    }


if __name__ == "__main__":
    sys.stdout.write("\n" + json.dumps(_design(json.loads(sys.argv[1]))) + "\n")
