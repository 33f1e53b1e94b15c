"""The work of a data set: its blocks, each made on its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from .folder import Folder
from .requests import Request, Requests
from .samples import Sample, write_block
from .spec import Spec
from .store import AssetStore

Produce = Callable[[Spec, Sequence[Request], AssetStore, str], Iterator[Sample]]
"""What makes the scenes of some requests, as `produce` does."""


def make_block(
    folder: Folder, requests: Requests, number: int, device: str = "auto", produce: Produce | None = None
) -> None:
    """Make one block of a data set, unless it is there.

    Args:
        folder: the data set.
        requests: what is asked for, with its specification.
        number: which block.
        device: where layouts are refined.
        produce: what makes its scenes, if not `produce`.
    """
    path = folder.block(number)
    if requests.spec.product == "layouts":
        from . import layouts

        layouts.make_block(folder, requests, number, device)
    elif not path.exists():
        produce = produce or usual()
        samples = produce(requests.spec, requests.block(number), store_of(folder), device)
        write_block(path, samples)


def pack(folder: Folder, requests: Requests) -> None:
    """Make the files of a data set of its blocks, which are all there; goes on where it was cut off."""
    if requests.spec.product == "layouts":
        from .layouts import pack as pack_layouts

        pack_layouts(folder, requests)
    else:
        from .files import pack as pack_scenes

        pack_scenes(folder, requests)


def usual() -> Produce:
    """`produce`, which is loaded only where scenes are made."""
    from .produce import produce

    return produce


def failed_samples(request: Request, reason: str) -> list[Sample]:
    """The scenes of a room that could not be made at all."""
    row = {"reason": reason, **request.columns(0)}
    return [
        Sample(request.index + layout, request.key(layout), "failed", {**row, "layout": layout})
        for layout in range(request.layouts)
    ]


def store_of(folder: Folder) -> AssetStore:
    """The store of a data set, one for all blocks that this process makes."""
    return _store(folder.path, folder.path.stat().st_ino)


@lru_cache(maxsize=1)
def _store(root: Path, inode: int) -> AssetStore:
    """The store of a data set, for all blocks that this process makes; another one when its folder was made anew."""
    del inode
    return AssetStore(root)
