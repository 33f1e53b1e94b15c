"""A producer of scenes that costs nothing, with troubles on request: words of a prompt say which."""

from __future__ import annotations

import errno
import os
import signal
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from sceneweaver.datasets import AssetStore, Request, Sample, Spec


def produce(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "cpu") -> Iterator[Sample]:
    """Scenes of a few bytes that follow from seed and prompt, with an asset each."""
    for request in requests:
        trouble(request, store.root)
        for layout in range(request.layouts):
            asset = store.put(f"asset {request.seed % 7}".encode(), "bin")
            status = "rejected" if "hopeless" in request.prompt else "ok"
            row = {"room": request.room, "layout": layout, "seed": request.seed, "prompt": request.prompt}
            row |= {"reason": "gate grade"} if status == "rejected" else {"assets": [asset]}
            text = f'{{"seed": {request.seed}, "asset": "{asset}", "on": "{spec.name}"}}\n'
            files = {"scene.json": text.encode(), "glb": bytes([request.seed % 251]) * 1000} if status == "ok" else {}
            yield Sample(request.index + layout, request.key(layout), status, row, files, {"all": time.perf_counter()})


def trouble(request: Request, root: Path) -> None:
    """What the prompt asks for beside a scene."""
    if "slow" in request.prompt:
        time.sleep(0.05)
    if "crash" in request.prompt:
        os.kill(os.getpid(), signal.SIGKILL)
    if "hang" in request.prompt:
        time.sleep(60)
    if "fault" in request.prompt:
        raise ValueError("no such wall")
    once = root / "work" / f"trouble-{request.room}"
    if "flaky" in request.prompt and not once.exists():
        once.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    if "full" in request.prompt and not once.exists():
        once.touch()
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
