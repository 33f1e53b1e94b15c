"""The work of a data set: its blocks, each made on its own."""

from __future__ import annotations

from .blocks import write_block
from .folder import Folder
from .produce import produce
from .requests import Requests
from .store import AssetStore


def make_block(folder: Folder, requests: Requests, number: int, device: str = "auto") -> None:
    """Make one block of a data set, unless it is there.

    Args:
        folder: the data set.
        requests: what is asked for, with its specification.
        number: which block.
        device: where layouts are refined.
    """
    path = folder.block(number)
    if not path.exists():
        samples = produce(requests.spec, requests.block(number), AssetStore(folder.path), device)
        write_block(path, samples)
