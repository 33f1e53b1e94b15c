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

import sceneweaver
from sceneweaver.assets import Library
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from ..counterfactuals import twin_files, twins
from ..describe import describe
from ..files import fingerprint
from ..requests import Request
from ..spec import Spec, Views
from ..store import AssetStore
from ..store.scene_files import scene_files
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


def columns_of(request: Request, layout: int, attempt: int) -> dict[str, Any]:
    """The columns of a row that follow from the request alone."""
    return {
        "room": request.room,
        "layout": layout,
        "attempt": attempt,
        "seed": request.seed,
        "prompt": request.prompt,
        "kind": request.kind,
        "clutter": request.clutter,
        "version": sceneweaver.__version__,
    }


def measured(done: Finished, library: Library) -> dict[str, Any]:
    """The columns of a row that tell of a scene that was made."""
    scene, report, review = done.outcome.scene, done.outcome.report, done.outcome.review
    asset_ids = sorted({o.asset for o in scene.objects if o.asset is not None})
    tallies = (report.relations.hard, report.relations.soft)
    total = sum(t.total for t in tallies)
    return {
        "room_type": scene.room.type,
        "area": round(shapely.Polygon(scene.room.outline).area, 3),
        "wall_count": len(scene.room.outline),
        "object_count": len(scene.objects),
        "categories": sorted({o.category for o in scene.objects}),
        "relation_count": len(scene.relations),
        "valid": report.valid,
        "collisions": report.collisions,
        "out_of_bounds": report.out_of_bounds,
        "relations_satisfied": sum(t.satisfied for t in tallies) / total if total else 1.0,
        "openable_share": report.openable_share,
        "walkable_share": report.walkable_share,
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
