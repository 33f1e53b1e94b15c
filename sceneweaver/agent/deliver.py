"""What a finished design leaves in its folder: scene, metrics, model, pictures and report, each whole or not at all."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from sceneweaver.assets import Library
from sceneweaver.scene import Scene, whole

from .result import Result

VIEWS = ("top", "top_annotated", "corner")


def deliver(
    result: Result, folder: Path, library: Library, device: str, pictures: bool, formats: Sequence[str]
) -> Result:
    """Write everything; the result with the seconds that it took."""
    began = time.monotonic()
    load = cache(library.load)
    result.scene.save(folder / "scene.json")
    from sceneweaver.export import export_scene

    export_scene(result.scene, folder, formats, load)
    drawn = {}
    if pictures:
        from sceneweaver.render import draw_rooms

        drawn = draw_rooms(result.scene, load, VIEWS, device=_drawing_device(device))
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
    write_report(folder / "report.html", data)


def _drawing_device(device: str) -> str:
    """Pictures are drawn where layouts are refined, on one device."""
    from sceneweaver.layout.devices import pick_devices

    return pick_devices(device)[0]
