"""The work of a data set: its blocks, each made on its own."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import chain
from pathlib import Path

from .folder import Folder
from .requests import Request, Requests
from .samples import Sample, read_samples, write_block
from .seals import folder_fault, remove
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
    make_rooms(folder, requests, folder.block(number), requests.block(number), device, produce)


def make_rooms(
    folder: Folder,
    requests: Requests,
    path: Path,
    rooms: Sequence[Request],
    device: str = "auto",
    produce: Produce | None = None,
) -> None:
    """Make some rooms, unless they are there as they were made; as `make_block`, at a path of their own."""
    if os.path.lexists(path):
        if path.is_dir() and not folder_fault(path):
            return
        remove(path)
    if requests.spec.product == "layouts":
        from .layouts import write_programs

        write_programs(path, requests, rooms, device)
    else:
        write_block(path, (produce or usual(requests.spec))(requests.spec, rooms, store_of(folder), device))


def join_rooms(folder: Folder, requests: Requests, number: int, failed: Mapping[int, str]) -> None:
    """Make a block of its rooms, which were made one by one.

    Args:
        folder: the data set.
        requests: what is asked for, with its specification.
        number: which block.
        failed: of rooms that are given up, by their place in the block, why.
    """
    rooms, block = requests.block(number), folder.block(number)
    paths = [folder.room(number, place) for place in range(len(rooms))]
    if requests.spec.product == "layouts":
        from .layouts import join, write_programs

        for place, reason in failed.items():
            write_programs(paths[place], requests, [rooms[place]], "cpu", {rooms[place].room: reason})
        join(block, requests, paths)
    elif not block.exists():
        parts = (
            failed_samples(room, failed[place]) if place in failed else read_samples(paths[place])
            for place, room in enumerate(rooms)
        )
        write_block(block, chain.from_iterable(parts))
    shutil.rmtree(folder.rooms(number), ignore_errors=True)


def pack(folder: Folder, requests: Requests) -> None:
    """Make the files of a data set of its blocks, which are all there; goes on where it was cut off."""
    if requests.spec.product == "layouts":
        from .layouts import pack as pack_layouts

        pack_layouts(folder, requests)
    else:
        from .files import pack as pack_scenes

        pack_scenes(folder, requests)


def usual(spec: Spec) -> Produce:
    """What makes the product of a specification, which is loaded only where it is made."""
    if spec.product == "homes":
        from .homes import produce_homes

        return produce_homes
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
