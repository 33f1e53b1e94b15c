"""What a finished home leaves in its folder: data, plan, models, pictures and page, each whole or not at all."""

from __future__ import annotations

import io
import json
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from sceneweaver.agent.faults import fault
from sceneweaver.assets import Library
from sceneweaver.export import export_home
from sceneweaver.io import own_folder, write_atomic
from sceneweaver.render.home import draw_plan, plan_picture
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.runtime.options import PictureSet
from sceneweaver.scene import SceneWeaverError

from .folder import HOME, METRICS, VIEWS
from .result import HomeResult

PATIENCE = 2.0
"""Seconds after its time that a part of the folder gets to come to an end."""

LEAST = 0.5
"""Seconds without which no further part is begun."""

Part = tuple[str, Callable[[], Sequence[str]]]
"""What a part of the folder is called where it fails, and what writes it and says its files."""


def deliver(
    result: HomeResult,
    folder: Path,
    library: Library,
    device: str,
    pictures: PictureSet,
    formats: Sequence[str],
    deadline: Deadline = NEVER,
) -> HomeResult:
    """Write everything; the result with what was written, what there was no time for, and what broke down.

    The home and its metrics are always written, then plans, models and pictures as far as there is time.

    Args:
        result: what is written.
        folder: where it goes.
        library: where assets come from.
        device: where pictures are drawn.
        pictures: which of them are: all, the plans and the views from above, or none and no page either.
        formats: models for other tools.
        deadline: when all has to be written.
    """
    began = time.monotonic()
    write_atomic(folder / HOME, result.home.dumps())
    save_metrics(result, folder)
    files, late, broken = [HOME, METRICS], list[str](), list[str]()
    for name, write in _parts(result, folder, library, device, pictures, formats):
        try:
            if deadline.left < LEAST:
                raise TimeUp
            with deadline.enforced(patience=PATIENCE):
                files += write()
        except TimeUp:
            late.append(name)
        except SceneWeaverError:
            raise
        except Exception as error:
            broken.append(fault(name, error))
    done = replace(
        result,
        files=(*result.files, *files),
        undone=(*result.undone, *(f"no time for {name}" for name in late), *broken),
        broken=(*result.broken, *broken),
        seconds={**result.seconds, "files": round(time.monotonic() - began, 3)},
    )
    save_metrics(done, folder)
    return done


def save_metrics(result: HomeResult, folder: Path) -> None:
    """Write ``metrics.json``: the judge's report, and what the design says of itself."""
    data = {**result.report.to_dict(), "plan": result.plan_report.to_dict(), "design": result.to_dict()}
    write_atomic(folder / METRICS, json.dumps(data, indent=1, allow_nan=False, ensure_ascii=False) + "\n")


def _parts(
    result: HomeResult,
    folder: Path,
    library: Library,
    device: str,
    pictures: PictureSet,
    formats: Sequence[str],
) -> Iterator[Part]:
    """The parts of the folder in the order in which they are written."""
    load, home = cache(library.load), result.home
    yield "plan", lambda: _plans(result, folder)
    for name in formats:
        yield (
            name,
            lambda name=name: [
                path.relative_to(folder).as_posix() for path in export_home(home, folder, (name,), load).values()
            ],
        )
    if pictures == "none":
        return


def _plans(result: HomeResult, folder: Path) -> list[str]:
    """The plan of the lowest storey, and of each storey where there are several."""
    home, files = result.home, ["plan.svg", "plan.png"]
    write_atomic(folder / "plan.svg", draw_plan(home))
    write_atomic(folder / "plan.png", _png(plan_picture(home)))
    if len(home.storeys) > 1:
        own_folder(folder / VIEWS)
        for storey in home.storeys:
            write_atomic(folder / VIEWS / f"plan_{storey.id}.png", _png(plan_picture(home, storey.id)))
            files.append(f"{VIEWS}/plan_{storey.id}.png")
    return files


def _png(picture) -> bytes:
    content = io.BytesIO()
    picture.save(content, "PNG", dpi=picture.info.get("dpi", (160, 160)))
    return content.getvalue()
