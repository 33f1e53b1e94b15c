"""The scenes of some requests."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import sceneweaver
from sceneweaver.agent import design

from ..requests import Request
from ..sample import Sample
from ..spec import Spec
from ..store import AssetStore


def produce(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "auto") -> Iterator[Sample]:
    """The scenes of some requests, in the order of their index.

    What a scene becomes does not depend on the requests beside it, nor on what was made before.
    """
    del store
    for request in requests:
        with tempfile.TemporaryDirectory() as folder:
            result = design(
                request.prompt,
                seed=request.attempt(0),
                candidates=spec.rooms.candidates,
                clutter=request.clutter,
                device=device,
                time_limit=None,
                reflect=False,
                generations=0,
                out=folder,
                export=spec.exports,
                pictures=False,
            )
            files = {
                suffix: (Path(folder) / name).read_bytes()
                for suffix, name in (("scene.json", "scene.json"), ("glb", "scene.glb"), ("xml", "scene.xml"))
                if (Path(folder) / name).exists()
            }
        row = {
            "room": request.room,
            "layout": 0,
            "attempt": 0,
            "seed": request.seed,
            "prompt": request.prompt,
            "kind": request.kind,
            "clutter": request.clutter,
            "room_type": result.scene.room.type,
            "object_count": len(result.scene.objects),
            "valid": result.report.valid,
            "grade": result.review.total,
            "unmet": list(result.unmet),
            "version": sceneweaver.__version__,
        }
        yield Sample(request.index, request.key(0), "ok", row, files, {"design": result.seconds})
