"""Rooms designed side by side, each in a process with cores to itself, and kept in folders."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from benchmarks.designs import request
from benchmarks.parallel import each
from benchmarks.settings import Settings
from sceneweaver.agent import design
from sceneweaver.critic import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.scene import Scene

LONGEST = ("restaurant", "office", "gym", "kitchen", "living_room", "meeting_room", "childrens_room")
"""Kinds of rooms that take longest; they begin first, so that no core waits for them at the end."""


@dataclass(frozen=True)
class Task:
    """A room to design: its kind, seed, and switches of the agent under a name."""

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
    """A designed room: what judge and critic say of it, seconds by the clock and of the processor."""

    task: Task
    scene: Scene
    valid: bool
    cut_off: bool
    grades: Mapping[str, float]
    counts: Mapping[str, int]
    seconds: float
    cpu: float


def made_side_by_side(tasks: Sequence[Task], settings: Settings, limit: float | None) -> list[Made]:
    """Design rooms without pictures, in the order of the tasks.

    Args:
        tasks: what to design; each scene is kept in a folder below ``settings.out``.
        settings: device, candidates, processes and folder.
        limit: time limit of a design [s]; None: none.
    """
    if min(settings.jobs, len(tasks)) > 1:  # kernels are compiled here, and not by every process
        design(request("bathroom"), device=settings.device, candidates=4, steps=1, time_limit=None)
    order = sorted(
        range(len(tasks)), key=lambda k: LONGEST.index(tasks[k].room) if tasks[k].room in LONGEST else len(LONGEST)
    )
    found = each(made, [(tasks[k], settings, limit) for k in order], settings.jobs)
    return [one for _, one in sorted(zip(order, found, strict=True), key=lambda pair: pair[0])]


def made(task: Task, settings: Settings, limit: float | None) -> Made:
    """Design one room and keep its scene; whatever the agent looked at, it is graded by all the rules."""
    began, cpu = time.perf_counter(), time.process_time()
    result = design(
        request(task.room),
        seed=task.seed,
        device=settings.device,
        candidates=settings.most,
        time_limit=limit,
        **task.switches,
    )
    seconds, cpu = time.perf_counter() - began, time.process_time() - cpu
    folder = settings.out / "designs" / task.name
    folder.mkdir(parents=True, exist_ok=True)
    result.scene.save(folder / "scene.json")
    report = result.report
    counts = {"objects": report.placed, "out": report.out_of_bounds, "colliding": report.collisions}
    return Made(
        task=task,
        scene=result.scene,
        valid=report.valid,
        cut_off=any(note.startswith("the work was cut off") for note in result.notes),
        grades=review_scene(result.scene, report, room_type(result.scene.room.type), result.brief).grades,
        counts={**counts, "dropped": report.dropped},
        seconds=seconds,
        cpu=cpu,
    )
