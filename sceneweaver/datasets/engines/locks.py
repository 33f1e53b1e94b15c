"""Who may write into a data set: one run, or several of different shards."""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from sceneweaver.scene import InputError, locked
from sceneweaver.scene.files import TEMPORARY

from ..folder import Folder

PATIENCE = 5.0
"""Seconds that a shard waits for others which look, as it does, whether a whole run is at work."""


@contextmanager
def run_lock(folder: Folder, shard: tuple[int, int] | None) -> Iterator[None]:
    """Keep other runs out while the block goes on; runs of other shards may work beside one of a shard.

    Raises:
        InputError: another run is at work, with its process number.
    """
    what, shards = f"--out: {folder.path}", folder.work / "shards"
    with ExitStack() as held:
        if shard is None:
            held.enter_context(locked(folder.manifest, what))
            for lock in shards.glob(f"{TEMPORARY}*.lock"):
                with locked(shards / lock.name.removeprefix(TEMPORARY).removesuffix(".lock"), what):
                    pass
        else:
            shards.mkdir(parents=True, exist_ok=True)
            held.enter_context(locked(shards / f"{shard[0]}-of-{shard[1]}", f"{what}, shard {shard[0]}/{shard[1]}"))
            _require_no_whole_run(folder.manifest, what)
        yield


def _require_no_whole_run(manifest: Path, what: str) -> None:
    until = time.monotonic() + PATIENCE
    while True:
        try:
            with locked(manifest, what):
                return
        except InputError:
            if time.monotonic() > until:
                raise
        time.sleep(random.uniform(0.02, 0.2))
