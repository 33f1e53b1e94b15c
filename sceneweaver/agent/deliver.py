"""What a finished design leaves in its folder: scene, metrics, model, pictures and report, each whole or not at all."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from sceneweaver.assets import Library
from sceneweaver.scene import Scene, whole

from .deadline import NEVER, Deadline
from .result import Result

if TYPE_CHECKING:
    from PIL.Image import Image

LEAST = 0.5
"""Seconds without which no further file is begun."""

AMPLE = 60.0
"""Seconds in which pictures of full size are drawn for sure."""

SIZES = ((320, 240), (640, 480), (1280, 960))
"""Pixels of the views, the smaller ones for when time is short."""

PER_SIZE, REPORT, PICTURES = 4.0, 1.0, 1.5
"""How much longer each size takes than the one before, the report than the pictures before it, and the smallest
pictures with their report than all files before them."""

VIEWS = ("top", "top_annotated", "corner")


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

    When time runs short the pictures are smaller, and what there is no time for is left out and noted. The scene and
    its metrics are always written.
    """
    began = time.monotonic()
    load = cache(library.load)
    result.scene.save(folder / "scene.json")
    result.report.save(folder / "metrics.json")
    from sceneweaver.export import export_scene

    missed = []
    for name in formats:
        if deadline.left < LEAST:
            missed.append(name)
        else:
            export_scene(result.scene, folder, (name,), load)
    if pictures and deadline.left < max(LEAST, PICTURES * (time.monotonic() - began)):
        pictures = False
        missed.append("pictures")
    if missed:
        result = replace(result, notes=(*result.notes, f"time was up before these were written: {', '.join(missed)}"))
    drawn = {}
    if pictures:
        drawn, note = _drawn(result.scene, load, _drawing_device(device), deadline)
        result = replace(result, notes=(*result.notes, *note))
        (folder / "views").mkdir(exist_ok=True)
        for name, picture in drawn.items():
            with whole(folder / "views" / f"{name}.png") as path:
                picture.save(path, "PNG")
    spent = time.monotonic() - began
    seconds = {**result.report.seconds, "files": round(spent, 3)}
    seconds["total"] = round(float(seconds.get("total", 0.0)) + spent, 3)
    result = replace(result, report=replace(result.report, seconds=seconds), seconds=result.seconds + spent)
    result.report.save(folder / "metrics.json")
    if pictures:
        _report(result, folder, load, drawn)
    return result


def _drawn(scene: Scene, load: Callable, device: str, deadline: Deadline) -> tuple[dict[str, Image], tuple[str, ...]]:
    """The views as large as there is time for, and what to note of it.

    A small one, which has to be drawn anyway when time is short, tells how long the larger ones would take here.
    """
    from sceneweaver.render import draw_rooms

    if deadline.left > AMPLE:
        return draw_rooms(scene, load, VIEWS, device=device), ()
    drawn = {}
    for width, height in SIZES:
        started = time.monotonic()
        drawn = draw_rooms(scene, load, VIEWS, width, height, device=device)
        if (width, height) == SIZES[-1]:
            return drawn, ()
        if (PER_SIZE + REPORT) * (time.monotonic() - started) + LEAST > deadline.left:
            return drawn, (f"time was short, so the pictures have {width} x {height} pixels",)
    return drawn, ()


def _report(result: Result, folder: Path, load: Callable, drawn: dict) -> None:
    from sceneweaver.render import draw_top
    from sceneweaver.report import ReportData, StepRow, write_report

    rows = []
    for step in result.steps:
        kept = folder / "steps" / f"{step.number:02d}" / "scene.json"
        picture = draw_top(Scene.load(kept)) if kept.exists() and step.accepted else None
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
    )
    with whole(folder / "report.html") as path:
        write_report(path, data)


def _drawing_device(device: str) -> str:
    """Pictures are drawn where layouts are refined, on one device."""
    from sceneweaver.layout.devices import pick_devices

    return pick_devices(device)[0]
