"""Small data sets made by hand: blocks of tiny scenes, without a design."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import sceneweaver as sw
from sceneweaver.datasets import Folder, Requests, Sample, Spec, write_block
from sceneweaver.datasets.files import fingerprint

KINDS = ("bedroom", "study", "living-room")


def small_spec(count: int = 6, **changes) -> Spec:
    """A specification of small blocks."""
    given = {"schema": "sceneweaver.dataset/1", "name": "small", "count": count, "block": 2}
    asked = {"requests": {"kinds": dict.fromkeys(KINDS, 1.0)}, "splits": {"train": 0.5, "test": 0.5}}
    return Spec.model_validate(given | asked | changes)


def small_scene(number: int) -> sw.Scene:
    """One of many rooms: an example whose large furniture stands somewhere else each time."""
    scene = sw.Scene.example(KINDS[number % len(KINDS)])
    rng = np.random.default_rng(number)
    for thing in scene.objects:
        if thing.mount == "floor":
            scene = scene.move(thing.id, by=tuple(rng.uniform(-1, 1, 2)))
    return scene


def small_sample(request, scene: sw.Scene, status: str = "ok", layout: int = 0, columns=None, **files: bytes) -> Sample:
    """The sample of a scene, with what packing reads of its row."""
    row = {
        "room": request.room,
        "layout": layout,
        "seed": request.seed,
        "prompt": request.prompt,
        "kind": request.kind,
    }
    index, key = request.index + layout, request.key(layout)
    if status != "ok":
        return Sample(index, key, status, row | {"reason": "too small: nothing fits"}, seconds={"design": 0.1})
    row |= {
        "room_type": scene.room.type,
        "object_count": len(scene.objects),
        "categories": [o.category for o in scene.objects],
        "valid": True,
        "grade": 7.5,
        "grades": {"realism": 7.0, "functionality": 8.0, "layout": 7.0, "completion": 8.0},
        "gates": {"valid": True, "grade": True},
        "unmet": [],
        "licences": ["Apache-2.0"],
        **fingerprint(scene),
        **(columns or {}),
    }
    content = {"scene.json": scene.dumps().encode(), "metrics.json": b'{"valid": true}\n', **files}
    return Sample(index, key, "ok", row, content, {"design": 0.25, "export": 0.5})


def make_small(
    root: Path, count: int = 6, *, failed: tuple[int, ...] = (), files=None, row=None, **changes
) -> Requests:
    """Write the blocks of a small data set; all its scenes have the files (perhaps by the scene) and columns given."""
    requests = Requests(small_spec(count, **changes))
    for number in range(requests.blocks):
        samples = [
            small_sample(
                request,
                small_scene(request.index + layout),
                "failed" if request.index + layout in failed else "ok",
                layout,
                row,
                **(files(small_scene(request.index + layout)) if callable(files) else files or {}),
            )
            for request in requests.block(number)
            for layout in range(request.layouts)
        ]
        write_block(Folder(root).block(number), samples)
    return requests
