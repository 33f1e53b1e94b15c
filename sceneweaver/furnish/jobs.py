"""One room of a home: what is to be done with it, and what came of that; made here or in a worker process."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.agent import design
from sceneweaver.agent.design import chosen_room
from sceneweaver.critic import Review
from sceneweaver.knowledge.kin import excluded_kinds
from sceneweaver.language import SceneGraph
from sceneweaver.runtime.deadline import Stop
from sceneweaver.scene import InputError, Palette, Room, Scene
from sceneweaver.verify import Report

AGAIN = 0x5BD1E995
"""What lies between the seeds of two draws of a room."""

DRAWS = 1
"""How often a room is furnished where nobody says it; docs/homes.md has what more of them bring."""

LEAST = 2.0
"""Seconds without which a room is not drawn again."""


@dataclass(frozen=True)
class RoomJob:
    """A room to furnish.

    Attributes:
        room_id: its id in the home.
        request: what it is to hold, in words.
        shell: the empty room, finished.
        palette: the look of its furniture; None: as its request says.
        seed: of all that is drawn.
        options: of `sceneweaver.design`: steps, candidates, device, clutter, settle, library.
        draws: how often it is furnished, of which the best is kept.
    """

    room_id: str
    request: str
    shell: Room
    palette: Palette | None
    seed: int
    options: Mapping[str, Any] = field(default_factory=dict)
    draws: int = DRAWS

    @property
    def key(self) -> dict[str, Any]:
        """What decides the scene, as JSON data: equal keys give equal scenes."""
        return {
            "request": self.request,
            "shell": self.shell.model_dump(mode="json"),
            "palette": None if self.palette is None else self.palette.model_dump(mode="json"),
            "seed": self.seed,
            "draws": self.draws,
            "options": {name: value for name, value in self.options.items() if name not in ("device", "library")},
        }


@dataclass(frozen=True)
class FurnishedRoom:
    """What became of a room.

    Attributes:
        room_id: its id in the home.
        request: what it was to hold.
        scene: the furnished room; None where nothing could be made of it, and ``failed`` says why.
        report: the judge on it.
        review: grades of the critic and what it finds fault with.
        unmet: what was asked for and is not so.
        lacking: categories of what such a room needs and has not.
        notes: what was assumed.
        seconds: processor time that it took [s].
        cut_off: what ended its search before it was done; empty: nothing.
        failed: why there is no scene.
    """

    room_id: str
    request: str
    scene: Scene | None = None
    report: Report | None = None
    review: Review | None = None
    unmet: tuple[str, ...] = ()
    lacking: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    seconds: float = 0.0
    cut_off: str = ""
    failed: str = ""

    @property
    def valid(self) -> bool:
        """Whether there is a valid scene."""
        return self.report is not None and self.report.valid

    @property
    def satisfied(self) -> bool:
        """Whether it is valid and holds what was asked for and what such a room needs."""
        return self.valid and not self.unmet and not self.lacking

    @property
    def worth(self) -> tuple[float, ...]:
        """Larger is better: valid, as asked, with what it needs, then the critic's grades."""
        total = self.review.total if self.review is not None else 0.0
        return float(self.valid), -float(len(self.unmet)), -float(len(self.lacking)), round(total, 6)


def ready() -> None:
    """Nothing; a process that is asked for it has loaded what furnishes rooms."""


def furnish_room(job: RoomJob, seconds: float | None = None, stop: Stop | None = None) -> FurnishedRoom:
    """Furnish a room so many times as the job says, from other seeds, once more where something has no place, and keep
    the best.

    Args:
        job: the room.
        seconds: that it may take; None: any.
        stop: asks it to end before, with what is best then.
    """
    began, until = time.process_time(), math.inf if seconds is None else time.monotonic() + seconds
    best: FurnishedRoom | None = None
    for draw in range(job.draws + 1):
        left = None if seconds is None else until - time.monotonic()
        if best is not None and (best.cut_off or (left is not None and left < LEAST)):
            break
        if best is not None and best.satisfied and draw >= job.draws:
            break
        made = _furnished(job, (job.seed + draw * AGAIN) % 2**32, left, stop)
        best = made if best is None else max(best, made, key=lambda room: room.worth)
    assert best is not None
    return replace(best, seconds=round(time.process_time() - began, 3))


def _furnished(job: RoomJob, seed: int, seconds: float | None, stop: Stop | None) -> FurnishedRoom:
    try:
        result = design(
            job.request,
            room=job.shell,
            palette=job.palette,
            seed=seed,
            pictures="none",
            export="none",
            time_limit=seconds,
            stop=stop,
            **job.options,
        )
    except InputError as error:
        return FurnishedRoom(job.room_id, job.request, failed=str(error))
    return FurnishedRoom(
        job.room_id,
        job.request,
        result.scene,
        result.report,
        result.review,
        result.unmet,
        lacking(result.scene, result.brief),
        result.notes,
        cut_off=result.report.cut_off or "",
    )


def lacking(scene: Scene, brief: SceneGraph) -> tuple[str, ...]:
    """Categories of what a room of its kind needs on such a floor and a scene has not, as far as nobody wants it so."""
    kind, _ = chosen_room(brief, scene.room)
    there = {o.intent.program_item for o in scene.objects}
    categories = {o.category for o in scene.objects}
    unwanted = excluded_kinds(brief.without)
    needed = [item for item in kind.items if item.need == "needed" and not brief.only]
    gone = [i for i in needed if i.id not in there and not categories & {*i.what} and not unwanted >= {*i.what}]
    hosts = {item.id for item in gone}
    unwanted_hosts = {item.id for item in needed if unwanted >= {*item.what}}
    return tuple(item.what[0] for item in gone if item.with_ not in hosts | unwanted_hosts)
