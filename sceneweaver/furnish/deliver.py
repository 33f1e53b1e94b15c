"""What a finished home leaves in its folder: data, plan, models, pictures and page, each whole or not at all."""

from __future__ import annotations

import io
import json
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.agent.faults import fault
from sceneweaver.assets import Library
from sceneweaver.export import export_home
from sceneweaver.io import own_folder, write_atomic
from sceneweaver.layout.devices import pick_devices
from sceneweaver.render.home import draw_plan, home_pictures, home_views, plan_picture
from sceneweaver.runtime.deadline import NEVER, Deadline, TimeUp
from sceneweaver.runtime.options import PictureSet
from sceneweaver.scene import SceneWeaverError

from .folder import HOME, METRICS, REPORT, VIEWS
from .result import HomeResult

if TYPE_CHECKING:
    from PIL import Image

WALK = "walk_"
"""What the names of views at eye level begin with."""

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

    The home and its metrics are always written. Then come the plan, the views from above with a first page, the models
    for other tools, the walk at eye level and the page with all pictures, as far as there is time.

    Args:
        result: what is written.
        folder: where it goes.
        library: where assets come from.
        device: where pictures are drawn.
        pictures: all of them; those from above; or none but the plan, and no page.
        formats: models for other tools.
        deadline: when all has to be written.
    """
    began = time.monotonic()
    write_atomic(folder / HOME, result.home.dumps())
    save_metrics(result, folder)
    files, late, broken = [HOME, METRICS], list[str](), list[str]()
    for name, write in _Parts(result, folder, library, device).wanted(pictures, formats):
        try:
            if deadline.left < LEAST:
                raise TimeUp
            with deadline.enforced(patience=PATIENCE):
                files += [file for file in write() if file not in files]
        except TimeUp:
            late.append(name)
        except SceneWeaverError:
            raise
        except Exception as error:
            broken.append(fault(name, error))
    if REPORT in files:
        files = [REPORT, *(file for file in files if file != REPORT)]
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
    """Write ``metrics.json``."""
    write_atomic(folder / METRICS, json.dumps(metrics_of(result), indent=1, allow_nan=False, ensure_ascii=False) + "\n")


def metrics_of(result: HomeResult) -> dict[str, Any]:
    """The judge's report with that of the plan, and what the design says of itself, as JSON data."""
    return {**result.report.to_dict(), "plan": result.plan_report.to_dict(), "design": result.to_dict()}


def png_bytes(picture: Image.Image) -> bytes:
    """A picture as a PNG file, with the resolution at which it prints to scale where it has one."""
    content = io.BytesIO()
    picture.save(content, "PNG", **({"dpi": picture.info["dpi"]} if "dpi" in picture.info else {}))
    return content.getvalue()


@dataclass
class _Parts:
    """The parts of the folder of a home, which share assets and pictures."""

    result: HomeResult
    folder: Path
    library: Library
    device: str
    album: dict[str, Image.Image] = field(default_factory=dict)

    def wanted(self, pictures: PictureSet, formats: Sequence[str]) -> Iterator[Part]:
        """The parts in the order in which they are written."""
        views = list(home_views(self.result.home)) if pictures != "none" else []
        above = [name for name in views if not name.startswith(WALK)]
        walk = [name for name in views if name.startswith(WALK)] if pictures == "full" else []
        yield "plan", self._plan
        for name in above:
            yield name, lambda name=name: self._view(name)
        if above:
            yield "page", self._page
        for name in formats:
            yield name, lambda name=name: self._model(name)
        for name in walk:
            yield name, lambda name=name: self._view(name)
        if walk:
            yield "page", self._page

    @cached_property
    def _load(self):
        from functools import cache

        return cache(self.library.load)

    @cached_property
    def _drawing_device(self) -> str:
        return pick_devices(self.device)[0]

    def _plan(self) -> list[str]:
        """The plan of the lowest storey; the views have those of all."""
        home = self.result.home
        write_atomic(self.folder / "plan.svg", draw_plan(home))
        write_atomic(self.folder / "plan.png", png_bytes(plan_picture(home)))
        return ["plan.svg", "plan.png"]

    def _view(self, name: str) -> list[str]:
        own_folder(self.folder / VIEWS)
        pictures = home_pictures(self.result.home, self._load, [name], device=self._drawing_device)
        for drawn, picture in pictures:
            self.album[drawn] = picture
            write_atomic(self.folder / VIEWS / f"{drawn}.png", png_bytes(picture))
        return [f"{VIEWS}/{name}.png"]

    def _model(self, name: str) -> list[str]:
        written = export_home(self.result.home, self.folder, (name,), self._load)
        return [path.relative_to(self.folder).as_posix() for path in written.values()]

    def _page(self) -> list[str]:
        """The page about the home, with the pictures that there are."""
        from sceneweaver.render.home import report_parts
        from sceneweaver.report.home import HomePage, write_home_report

        home, pictures = self.result.home, dict(self.album)
        page = HomePage(home, metrics=metrics_of(self.result), pictures=pictures, load=self._load, **report_parts(home))
        write_home_report(self.folder / REPORT, page)
        return [REPORT]


__all__ = ["deliver", "metrics_of", "png_bytes", "save_metrics"]
