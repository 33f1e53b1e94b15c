"""What a finished design leaves in its folder: scene, metrics, model, pictures and report, each whole or not at all."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from sceneweaver.assets import Library
from sceneweaver.critic import phrases
from sceneweaver.export import format_named
from sceneweaver.io import whole, write_atomic
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.runtime.options import PictureSet
from sceneweaver.scene import Scene, SceneWeaverError

from .album import FOLDER, HANGS, Album
from .faults import fault
from .memory import Step
from .request_file import NAME, RequestFile
from .result import Result
from .schedule import Schedule
from .transcript import calls_of

if TYPE_CHECKING:
    from sceneweaver.report import ThoughtRow

STEP_WIDTH = 880
"""Pixels of the picture of a step, twice as wide as the report shows it."""

LEAST = 0.5
"""Seconds without which no further file is begun."""

SCENE, METRICS, REPORT = "scene.json", "metrics.json", "report.html"
"""Files that every format leaves alone."""


def deliver(
    result: Result,
    folder: Path,
    library: Library,
    device: str,
    pictures: PictureSet,
    formats: Sequence[str],
    deadline: Deadline = NEVER,
    *,
    started: float = 0.0,
    asked: bool = True,
    ready: Callable[[Result, Sequence[str]], None] = lambda result, files: None,
) -> Result:
    """Write everything; the result with what was written, what was left out, and the seconds that it took.

    The scene, its metrics and what became of the request are always written. Where there is plenty of time, a first
    picture and the report come next. Then come small pictures, the files for other tools, and better pictures as far as
    there is time; what there is no time for is left out and noted.

    Args:
        result: what is written.
        folder: where it goes.
        library: where assets come from.
        device: where pictures are drawn.
        pictures: which of them are; with "none" there is no report either.
        formats: files for other tools.
        deadline: when all has to be written.
        started: seconds that it took to start up.
        asked: whether somebody asked for these formats; all small pictures go before those that nobody did.
        ready: called with the result and the files that can be opened: when the scene is there, and when there are a
            first picture and the report. What comes after changes nothing of the scene.
    """
    began = time.monotonic()
    load = cache(library.load)
    write_atomic(folder / SCENE, result.scene.dumps())
    result.report.save(folder / METRICS)
    differing = result.models.disagreements if result.models else ()
    RequestFile.of(result.brief, result.review, differing).save(folder / NAME)
    plan = Schedule(started, len(result.scene.objects), formats, pictures != "none")
    page = max(LEAST, plan.page) if pictures != "none" else 0.0
    album = None
    if pictures != "none":
        album = Album(result.scene, load, _drawing_device(device), folder, deadline, page, pictures == "hero")
    ready(result, (SCENE, METRICS, NAME))
    shown = False
    if album is not None and album.begin_with_hero():
        with suppress(TimeUp), deadline.enforced(patience=HANGS):
            _report(result, folder, load, album.views, deadline.before(page))
            shown = True
        if shown:
            ready(result, (REPORT, *(f"{FOLDER}/{view}.png" for view in album.views)))
    if album is not None:
        album.begin()
        if not asked:
            album.begin_at_eye_level()
    until = deadline.before(page + (LEAST if album is not None and asked else 0.0))
    written, missed, broken = _exported(result.scene, folder, formats, load, until)
    late = list(missed)
    left_out = [format_named(name).file for name in missed]
    drawn: list[str] = []
    if album is not None:
        if asked:
            album.begin_at_eye_level()
        album.enlarge()
        album.improve_at_eye_level()
        broken += album.broken
        drawn = [f"{FOLDER}/{view}.png" for view in album.views]
        if album.missing and not album.broken:
            late.append("pictures")
            left_out += [f"{FOLDER}/{view}.png" for view in album.missing]
        if deadline.passed and not shown:
            late.append("report")
            left_out.append(REPORT)
        result = replace(result, notes=(*result.notes, *album.notes))
    spent = time.monotonic() - began
    seconds = {**result.report.seconds, "files": round(spent, 3)}
    seconds["total"] = round(float(seconds.get("total", 0.0)) + spent, 3)
    result = replace(
        result,
        report=replace(result.report, seconds=seconds),
        notes=(*result.notes, *broken),
        undone=(*result.undone, *broken),
        broken=(*result.broken, *broken),
        files=(*drawn, SCENE, *(format_named(name).file for name in written), METRICS, NAME),
        seconds=result.seconds + spent,
    )
    result = _without(result, late, left_out, deadline)
    result.report.save(folder / METRICS)
    if album is None or REPORT in left_out:
        return result
    try:
        with deadline.enforced(patience=HANGS):
            _report(result, folder, load, album.views, deadline.before(page))
    except TimeUp:
        if not shown:
            result = _without(result, ["report"], [REPORT], deadline)
            result.report.save(folder / METRICS)
            return result
        result = replace(result, notes=(*result.notes, "time was short, so the report shows the first picture alone"))
    return replace(result, files=(REPORT, *result.files))


def _without(result: Result, late: Sequence[str], files: Sequence[str], deadline: Deadline) -> Result:
    """A result that says what there was no time for, as its names and its files, and what ended that time."""
    if not files:
        return result
    ended = f"{reason} came" if (reason := deadline.stop.reason) else "time was up"
    left_out = (*result.left_out, *files)
    return replace(
        result,
        notes=(*result.notes, f"{ended} before these were written: {', '.join(files)}"),
        undone=(*result.undone, *late),
        left_out=left_out,
        report=replace(result.report, left_out=left_out),
    )


def _exported(
    scene: Scene, folder: Path, formats: Sequence[str], load: Callable, deadline: Deadline
) -> tuple[list[str], list[str], list[str]]:
    """Write the files for other tools; those that are there, those without time, and what broke down."""
    from sceneweaver.export import export_scene

    written, missed, broken = list[str](), list[str](), list[str]()
    for name in formats:
        try:
            if deadline.left < LEAST:
                raise TimeUp
            with deadline.enforced(patience=HANGS):
                export_scene(scene, folder, (name,), load)
            written.append(name)
        except TimeUp:
            missed.append(name)
        except SceneWeaverError:
            raise
        except Exception as error:
            broken.append(fault(name, error))
    return written, missed, broken


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
                picture = draw_top(Scene.load(kept, within=folder), width=STEP_WIDTH)
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
