"""The scenes of some requests with their files: together and fast at first, one by one where that does not serve."""

from __future__ import annotations

import io
import json
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import shapely

from sceneweaver.agent.executor import Outcome
from sceneweaver.assets import Library
from sceneweaver.io import read_bytes
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import InputError, MissingDependencyError, Scene
from sceneweaver.verify import Report

from ..describe import describe
from ..files import fingerprint
from ..folder import disk_full
from ..requests import Request
from ..samples import Sample, report_columns, scene_columns
from ..spec import Spec, Views
from ..store import AssetStore
from ..store.pool import dataset_library
from ..store.scene_files import references, scene_files
from ..twins import twin_files, twins
from .drafts import Draft, Finished, designed, drafted, finished
from .layouts import chosen, laid_out


def files_of(
    spec: Spec, done: Finished, seed: int, library: Library, store: AssetStore, device: str
) -> dict[str, bytes]:
    """By suffix, what a shard holds of a scene; ``seed`` decides how it is described."""
    scene = done.outcome.scene
    return {
        "scene.json": _text(scene.to_json()),
        "metrics.json": _text(_metrics(spec, done).to_dict()),
        **scene_files(scene, spec.exports, store, library.load),
        **_pictures(scene, spec.views, device),
        **(describe(scene, seed) if spec.captions else {}),
        **twin_files(twins(scene, spec.counterfactuals, seed)),
    }


def _metrics(spec: Spec, done: Finished) -> Report:
    """The judge's report as ``metrics.json`` of a design has it, without what differs from run to run."""
    review = done.outcome.review
    return replace(
        done.outcome.report,
        scores={"critic": review.critic, **{name: round(grade, 2) for name, grade in review.grades.items()}},
        alignment=review.alignment.summary,
        seed=done.seed,
        candidates=spec.rooms.candidates,
        seconds={},
    )


def measured(done: Finished, library: Library) -> dict[str, Any]:
    """The columns of a row that tell of a scene that was made."""
    scene, report, review = done.outcome.scene, done.outcome.report, done.outcome.review
    asset_ids = sorted({o.asset for o in scene.objects if o.asset is not None})
    return {
        **scene_columns(scene),
        **report_columns(report),
        "area": round(shapely.Polygon(scene.room.outline).area, 3),
        "grade": round(review.total, 4),
        "grades": {name: round(grade, 4) for name, grade in review.grades.items()},
        "unmet": list(done.unmet),
        "gates": done.gates,
        "asset_ids": asset_ids,
        "licences": sorted({library.load(asset_id).origin.licence for asset_id in asset_ids}),
        **fingerprint(scene),
    }


def _text(data: Mapping[str, Any]) -> bytes:
    return json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()


def _pictures(scene: Scene, views: Views, device: str) -> dict[str, bytes]:
    """By suffix, the pictures of a scene: ``<camera>.png``, and ``<camera>.<pass>...`` of data passes."""
    if not views.cameras and not views.passes:
        return {}
    from sceneweaver.layout.devices import pick_devices
    from sceneweaver.render import draw_room
    from sceneweaver.render.pass_files import write_passes
    from sceneweaver.render.passes import PassRenderer, auto_shots

    where, size, files = pick_devices(device)[0], (views.width, views.height), {}
    for camera in views.cameras:
        content = io.BytesIO()
        draw_room(scene, None, camera, *size, device=where).save(content, "PNG")
        files[f"{camera}.png"] = content.getvalue()
    if views.passes:
        with tempfile.TemporaryDirectory() as folder:
            renderer = PassRenderer(scene, auto_shots(scene, *size), device=where)
            for path in write_passes(renderer, Path(folder), views.passes):
                files[path.name] = read_bytes(path, max_bytes=2**32)
    return files


LAYOUT_SEED = 0x85EBCA6B
"""What lies between the seeds of two layouts of a room."""

ALONE = "cpu"
"""Where a room is searched for by itself: too few layouts for a GPU, whose searches are made for thousands."""

FULL = 2
"""Attempt from which on the agent makes the room, with reflection."""


@dataclass
class _Room:
    """A room on its way.

    Attributes:
        request: what is asked for.
        spent: wall time that the first attempt took before it came to a single scene [s].
        draft: what the first attempt drew.
        layouts: layouts of it, the most promising first, not judged yet.
        reason: why there is no draft.
    """

    request: Request
    spent: dict[str, float] = field(default_factory=dict)
    draft: Draft | None = None
    layouts: list[Scene] = field(default_factory=list)
    reason: str = ""


def produce(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "auto") -> Iterator[Sample]:
    """The scenes of some requests, in the order of their index.

    What a scene becomes does not depend on the requests beside it, nor on what was made before. One that breaks down
    or takes too long is a row with the reason; errors of the machine, such as a full disk, are raised.
    """
    library = dataset_library(spec.variants)
    maker = _Maker(spec, library, store, device)
    rooms = [_Room(request) for request in requests]
    for room in rooms:
        try:
            with lap(room.spent, "draft"), _limit(spec.time_limit).enforced():
                room.draft = drafted(spec, room.request, room.request.attempt(0), library, ALONE)
        except (Exception, TimeUp) as error:
            room.reason = reason_of(error)
    _lay_out([room for room in rooms if room.draft is not None], device)
    for room in rooms:
        yield from maker.scenes(room)
        room.draft, room.layouts = None, []
    store.sync()


def _lay_out(rooms: Sequence[_Room], device: str) -> None:
    """Give rooms their layouts; where a search breaks down, its room alone is left without."""
    began = time.monotonic()
    try:
        for room, layouts in zip(rooms, laid_out([r.draft for r in rooms if r.draft], device), strict=True):
            room.layouts = layouts
    except Exception as error:
        if len(rooms) > 1:
            for room in rooms:
                _lay_out([room], device)
            return
        rooms[0].reason = reason_of(error)
    for room in rooms:
        room.spent["layouts"] = (time.monotonic() - began) / len(rooms)


@dataclass(frozen=True)
class _Maker:
    """Makes the scenes of rooms, one by one."""

    spec: Spec
    library: Library
    store: AssetStore
    device: str

    def scenes(self, room: _Room) -> Iterator[Sample]:
        """The scenes of a room, whose layouts were searched for."""
        spec, request = self.spec, room.request
        shared = {name: seconds / request.layouts for name, seconds in room.spent.items()}
        first: list[Outcome] = []
        try:
            with lap(shared, "choice"), _limit(spec.time_limit).enforced():
                if room.draft is not None:
                    first = chosen(room.draft, room.layouts, request.layouts)
        except (Exception, TimeUp) as error:
            room.reason = reason_of(error)
        for layout in range(request.layouts):
            yield self._scene(room, layout, first[layout] if layout < len(first) else None, dict(shared))

    def _scene(self, room: _Room, layout: int, first: Outcome | None, seconds: dict[str, float]) -> Sample:
        """A scene of a room; ``first`` is the layout that the first attempt found for it."""
        spec, library, request, done, attempt = self.spec, self.library, room.request, None, 0
        reason = room.reason or ("" if first else "no valid layout was found")

        def sample(status: Any, row: dict[str, Any], files: dict[str, bytes] | None = None) -> Sample:
            index, named = request.index + layout, request.columns(attempt) | {"layout": layout}
            rounded = {name: round(value, 4) for name, value in seconds.items()}
            return Sample(index, request.key(layout), status, named | row, files or {}, rounded)

        try:
            with _limit(spec.time_limit - sum(seconds.values())).enforced():
                for attempt in range(spec.rooms.attempts):
                    try:
                        with lap(seconds, "finish" if attempt == 0 else "again"):
                            made = self._made(room, layout, attempt, first)
                        if made is None:
                            continue
                        done, reason = made, made.reason
                        if not reason:
                            with lap(seconds, "files"):
                                files = files_of(spec, done, request.seed + layout, library, self.store, self.device)
                            row = measured(done, library) | {"assets": references(files)}
                            return sample("ok", row, files)
                    except Exception as error:
                        done, reason = None, reason_of(error)
                        if isinstance(error, InputError) and room.draft is None:
                            break  # it is the request, which no other draw makes better
        except TimeUp:
            return sample("failed", {"reason": reason_of(TimeUp())})
        if done is not None:
            return sample("rejected", measured(done, library) | {"reason": reason})
        return sample("rejected" if room.draft is not None and not room.reason else "failed", {"reason": reason})

    def _made(self, room: _Room, layout: int, attempt: int, first: Outcome | None) -> Finished | None:
        """What an attempt at a scene leads to; None where the first found no layout."""
        spec, library, request, aside = self.spec, self.library, room.request, layout * LAYOUT_SEED
        if attempt == 0:
            if room.draft is None or first is None:
                return None
            return finished(room.draft, first, (room.draft.seed + aside) % 2**32, spec.gates)
        seed = (request.attempt(attempt) + aside) % 2**32
        if attempt >= FULL:
            return designed(spec, request, seed, library, ALONE)
        draft = drafted(spec, request, seed, library, ALONE)
        outcome = draft.executor.run(draft.context.scene, draft.proposal, seed)
        return finished(draft, outcome, seed, spec.gates)


def _limit(seconds: float) -> Deadline:
    return Deadline(time.monotonic() + seconds)


@contextmanager
def lap(seconds: dict[str, float], name: str) -> Iterator[None]:
    """Add the time that a block takes to those of its name."""
    began = time.monotonic()
    try:
        yield
    finally:
        seconds[name] = seconds.get(name, 0.0) + time.monotonic() - began


def reason_of(error: BaseException) -> str:
    """Why a scene was not made, in one line. What is no fault of a scene is raised: a full disk, a missing library."""
    if isinstance(error, MissingDependencyError) or disk_full(error):
        raise error
    if isinstance(error, TimeUp):
        return "time limit"
    text = " ".join(str(error).split())
    return text if isinstance(error, InputError) else f"{type(error).__name__}: {text}"
