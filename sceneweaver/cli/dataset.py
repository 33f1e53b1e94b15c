"""``sceneweaver dataset``: what the commands do."""

from __future__ import annotations

from pathlib import Path

from .output import no_chatter


def run_make(source: Path, out: Path, *, device: str) -> int:
    """Make the blocks of a data set."""
    with no_chatter():
        from sceneweaver.datasets import Folder, Requests, load_spec, make_block

        spec = load_spec(source)
        folder, requests = Folder(out), Requests(spec, source.parent)
        for number in range(requests.blocks):
            make_block(folder, requests, number, device)
    return 0
