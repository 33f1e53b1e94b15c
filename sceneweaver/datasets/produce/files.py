"""The files of a delivered scene, and its columns in the index."""

from __future__ import annotations

import io
import json
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import shapely

from sceneweaver.assets import Library
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from ..describe import describe
from ..files import fingerprint
from ..samples import report_columns, scene_columns
from ..spec import Spec, Views
from ..store import AssetStore
from ..store.scene_files import scene_files
from ..twins import twin_files, twins
from .drafts import Finished


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
                files[path.name] = path.read_bytes()
    return files
