"""What a finished design leaves in its folder: scene, metrics, model, pictures and report, each whole or not at all."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from sceneweaver.assets import Library
from sceneweaver.critic import phrases
from sceneweaver.io import own_folder, whole, write_atomic
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.scene import Scene, SceneWeaverError

from .faults import fault
from .memory import Step
from .request_file import NAME, RequestFile
from .result import Result
from .transcript import calls_of

if TYPE_CHECKING:
    from PIL.Image import Image

    from sceneweaver.report import ThoughtRow

STEP_WIDTH = 880
"""Pixels of the picture of a step, twice as wide as the report shows it."""

PACKING = 4
"""How hard pictures are packed, 0 to 9: harder takes twice the time for a few hundredths of the size."""

LEAST = 0.5
"""Seconds without which no further file is begun."""

HANGS = 0.3
"""Seconds after which a file is given up that comes to no checkpoint: less than the report takes."""

AMPLE = 60.0
"""Seconds in which pictures of full size are drawn for sure."""

SIZES = ((320, 240), (640, 480), (1280, 960))
"""Pixels of the views, the smaller ones for when time is short."""

EYE_LEVEL = (((640, 480), "draft"), ((960, 720), "draft"), ((960, 720), "normal"))
"""Pixels and quality of the pictures at eye level, those first that are for when time is short."""

PER_SIZE, REPORT, PAGE = 4.0, 1.0, 0.35
"""How much longer each size takes than the one before, and the report than the pictures in it; and the share of the
time for both that is kept for the report."""

VIEWS = (("top", "top_annotated"), ("corner",))
"""The views of a room, those together that are drawn from one picture."""


def deliver(
    result: Result,
    folder: Path,
    library: Library,
    device: str,
    pictures: bool,
    formats: Sequence[str],
    deadline: Deadline = NEVER,
) -> Result:
    """Write everything; the result with the seconds that it took.

    When time runs short the pictures, which come first, are small, and what there is no time for is left out and noted.
    The scene, its metrics and what became of the request are always written.
    """
    began = time.monotonic()
    load = cache(library.load)
    write_atomic(folder / "scene.json", result.scene.dumps())
    result.report.save(folder / "metrics.json")
    differing = result.models.disagreements if result.models else ()
    RequestFile.of(result.brief, result.review, differing).save(folder / NAME)
    album = _Album(result.scene, load, _drawing_device(device), deadline) if pictures else None
    if album is not None:
        album.smallest()
    missed, broken = _exported(result.scene, folder, formats, load, deadline.before(album.page if album else 0.0))
    if album is not None:
        album.enlarge()
        album.at_eye_level()
        album.save(folder / "views")
        missed += ["pictures"] if album.short or not (album.views or album.broken) else []
        broken += album.broken
        result = replace(result, notes=(*result.notes, *album.notes))
        if deadline.passed:
            missed.append("report")
    undone = (*result.undone, *missed, *broken)
    if missed:
        broken = [f"time was up before these were written: {', '.join(missed)}", *broken]
    result = replace(result, notes=(*result.notes, *broken), undone=undone)
    spent = time.monotonic() - began
    seconds = {**result.report.seconds, "files": round(spent, 3)}
    seconds["total"] = round(float(seconds.get("total", 0.0)) + spent, 3)
    result = replace(result, report=replace(result.report, seconds=seconds), seconds=result.seconds + spent)
    result.report.save(folder / "metrics.json")
    if album is not None and "report" not in missed:
        _report(result, folder, load, album.views, deadline.before(album.page))
    return result


def _exported(
    scene: Scene, folder: Path, formats: Sequence[str], load: Callable, deadline: Deadline
) -> tuple[list[str], list[str]]:
    """Write the files for other tools; those that there was no time for, and what broke down."""
    from sceneweaver.export import export_scene

    missed, broken = list[str](), list[str]()
    for name in formats:
        try:
            if deadline.left < LEAST:
                raise TimeUp
            with deadline.enforced(patience=HANGS):
                export_scene(scene, folder, (name,), load)
        except TimeUp:
            missed.append(name)
        except SceneWeaverError:
            raise
        except Exception as error:
            broken.append(fault(name, error))
    return missed, broken


@dataclass
class _Album:
    """The views of a scene, as large as there is time for.

    ``took`` says how many seconds the last ones took, ``short`` that there was no time for all of the smallest.
    """

    scene: Scene
    load: Callable
    device: str
    deadline: Deadline
    views: dict[str, Image] = field(default_factory=dict)
    size: tuple[int, int] = SIZES[-1]
    took: float = LEAST
    short: bool = False
    notes: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()

    @property
    def page(self) -> float:
        """About how many seconds the report takes."""
        return max(LEAST, REPORT * self.took)

    def smallest(self) -> None:
        """Draw small views first when time is short, if there is time for them and the report."""
        if LEAST <= self.deadline.left <= AMPLE:
            self._draw(SIZES[0], PAGE * self.deadline.left)

    def enlarge(self) -> None:
        """Draw the larger views that there is time for: the smaller ones told how long they take here."""
        if self.deadline.left > AMPLE:
            self._draw(SIZES[-1], self.page)
        for size in SIZES[SIZES.index(self.size) + 1 :] if self.views and not self.short else ():
            short = (PER_SIZE + REPORT) * self.took + LEAST > self.deadline.left
            if short or not self._draw(size, self.page):
                self.notes = (f"time was short, so the pictures have {self.size[0]} x {self.size[1]} pixels",)
                break

    def at_eye_level(self) -> None:
        """Draw the room at eye level, as well as there is time for; one picture tells how long the next ones take."""
        if self.short or not self.views:
            return
        from sceneweaver.render import EyeLevel, Quality

        began, wanted = time.monotonic(), 1
        drawn: dict[str, Image] = {}
        levels = EYE_LEVEL if self.deadline.left <= AMPLE else EYE_LEVEL[-1:]
        try:
            with self.deadline.before(self.page).enforced(patience=HANGS):
                if self.deadline.before(self.page).left < LEAST:
                    raise TimeUp
                room = EyeLevel(self.scene, self.load, device=self.device)
                wanted = len(room.cameras)
                for size, quality in levels:
                    if drawn and PER_SIZE * (time.monotonic() - began) > self.deadline.before(self.page).left:
                        break
                    began = time.monotonic()
                    for view in room.cameras:
                        drawn[view] = room.draw(view, *size, getattr(Quality, quality)())
        except SceneWeaverError:
            raise
        except TimeUp:
            pass
        except Exception as error:
            self.broken = (*self.broken, fault("pictures at eye level", error))
            return
        if len(drawn) < wanted:
            self.notes = (*self.notes, "time was short, so there are not all pictures at eye level")
        self.views = {**self.views, **drawn}

    def save(self, folder: Path) -> None:
        """Write a PNG for each view."""
        if self.views:
            own_folder(folder)
        for name, picture in self.views.items():
            with whole(folder / f"{name}.png") as path:
                picture.save(path, "PNG", compress_level=PACKING)

    def _draw(self, size: tuple[int, int], kept: float) -> bool:
        """Draw the views, with so many seconds kept for what comes after; whether they are there."""
        from sceneweaver.render import draw_rooms

        started, drawn = time.monotonic(), {}
        try:
            with self.deadline.before(kept).enforced(patience=HANGS):
                for views in VIEWS:
                    drawn |= draw_rooms(self.scene, self.load, views, *size, device=self.device)
        except SceneWeaverError:
            raise
        except Exception as error:
            self.broken = (fault("pictures", error),)
            return False
        except TimeUp:
            if not self.views:  # some small ones are better than none
                self.views, self.size, self.took, self.short = drawn, size, time.monotonic() - started, True
            return False
        self.views, self.size, self.took = drawn, size, time.monotonic() - started
        return True


def _report(result: Result, folder: Path, load: Callable, drawn: dict, deadline: Deadline) -> None:
    """Write the page; steps that there is no time to draw have no picture on it."""
    from sceneweaver.render import draw_top
    from sceneweaver.report import ReportData, StepRow, write_report

    rows = []
    for step in result.steps:
        kept = folder / "steps" / f"{step.number:02d}" / "scene.json"
        picture = None
        if kept.exists() and step.accepted and not deadline.passed:
            with suppress(TimeUp), deadline.enforced(patience=HANGS):
                picture = draw_top(Scene.load(kept), width=STEP_WIDTH)
        rows.append(
            StepRow(
                number=step.number,
                tool=step.call.tool if step.call else "",
                instruction=(step.call.instruction or step.call.reason) if step.call else "",
                accepted=step.accepted,
                seconds=step.seconds,
                grades=dict(step.after),
                note=step.note,
                picture=picture,
                thought=_thought(step),
            )
        )
    data = ReportData(
        scene=result.scene,
        metrics=result.report.to_dict(),
        review=result.review,
        pictures=drawn,
        steps=tuple(rows),
        notes=result.notes,
        unmet=result.unmet,
        warnings=result.report.warnings,
        load=load,
        title=result.brief.text[:120],
        request=result.brief.text,
        phrases=phrases(result.brief, result.review.alignment),
    )
    with whole(folder / "report.html") as path:
        write_report(path, data)


def _thought(step: Step) -> ThoughtRow | None:
    """What a planner said before a step; None where the rules alone plan."""
    if step.plan is None:
        return None
    from sceneweaver.report import RankedCall, ThoughtRow

    said = step.plan
    note = said.note or (f"would have stopped: {said.overruled}" if said.overruled else "")
    calls = [RankedCall(c.tool, c.confidence, c.instruction or c.reason, what) for c, what in calls_of(step)]
    return ThoughtRow(said.by, said.problem, said.last_step, said.solved, note, tuple(calls))


def _drawing_device(device: str) -> str:
    """Pictures are drawn where layouts are refined, on one device."""
    from sceneweaver.layout.devices import pick_devices

    return pick_devices(device)[0]
