"""One room of a home: what is to be done with it, and what came of that; made here or in a worker process."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sceneweaver.agent import Result, design
from sceneweaver.critic import Review
from sceneweaver.runtime.deadline import Stop
from sceneweaver.scene import InputError, Palette, Room, Scene
from sceneweaver.verify import Report


@dataclass(frozen=True)
class RoomJob:
    """A room to furnish.

    Attributes:
        room_id: its id in the home.
        request: what it is to hold, in words.
        shell: the empty room, finished.
        palette: the look of its furniture; None: as its request says.
        seed: of all that is drawn.
        options: of `sceneweaver.design`: steps, candidates, device, clutter, settle.
    """

    room_id: str
    request: str
    shell: Room
    palette: Palette | None
    seed: int
    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def key(self) -> dict[str, Any]:
        """What decides the scene, as JSON data: equal keys give equal scenes."""
        return {
            "request": self.request,
            "shell": self.shell.model_dump(mode="json"),
            "palette": None if self.palette is None else self.palette.model_dump(mode="json"),
            "seed": self.seed,
            "options": {name: value for name, value in self.options.items() if name != "device"},
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
        """Whether it is valid and holds what was asked for."""
        return self.valid and not self.unmet


def furnish_room(job: RoomJob, seconds: float | None = None, stop: Stop | None = None) -> FurnishedRoom:
    """Furnish a room.

    Args:
        job: the room.
        seconds: that it may take; None: any.
        stop: asks it to end before, with what is best then.
    """
    began = time.process_time()
    try:
        result = design(
            job.request,
            room=job.shell,
            palette=job.palette,
            seed=job.seed,
            pictures="none",
            export="none",
            time_limit=seconds,
            stop=stop,
            **job.options,
        )
    except InputError as error:
        return FurnishedRoom(job.room_id, job.request, failed=str(error), seconds=time.process_time() - began)
    return _furnished(job, result, time.process_time() - began)


def _furnished(job: RoomJob, result: Result, seconds: float) -> FurnishedRoom:
    return FurnishedRoom(
        job.room_id,
        job.request,
        result.scene,
        result.report,
        result.review,
        result.unmet,
        result.notes,
        round(seconds, 3),
        result.report.cut_off or "",
    )
