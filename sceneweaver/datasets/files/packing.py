"""From blocks to the files of a data set, in steps that may each be cut off and go on."""

from __future__ import annotations

import os
import shutil

from sceneweaver.scene.files import sweep

from ..folder import Folder
from ..requests import Requests
from .finish import finish
from .plan import ASSETS, INDEX, SECONDS_TABLE, packing, write_plan
from .shards import write_shards
from .tables import read_table


def pack(folder: Folder, requests: Requests) -> None:
    """Make shards, tables, card and checksums of the blocks of a data set; does nothing where all is there.

    The plan comes first, shards next, then tables and texts, checksums last. Killed in between, it goes on when it is
    called again, to the same bytes. Only one process at a time may run it.

    Raises:
        InputError: when a block is missing.
        OSError: when the disk is full; called again, it goes on.
    """
    if folder.checksums.exists():
        return
    for place in (folder.path, folder.plan.parent, *folder.blocks.glob("*")):
        sweep(place)
    if not packing(folder):
        write_plan(folder, requests)
    if (folder.plan / INDEX).exists():
        write_shards(folder, requests)
        folder.meta.mkdir(exist_ok=True)
        for name in (SECONDS_TABLE, ASSETS, INDEX):
            if (folder.plan / name).exists():
                os.replace(folder.plan / name, folder.meta / name)
    for place in (folder.plan, folder.blocks):
        shutil.rmtree(place, ignore_errors=True)
    _prune(folder)
    finish(folder, requests.spec)


def _prune(folder: Folder) -> None:
    """Remove files from the store that no scene needs: what a run that was killed wrote for scenes that then failed."""
    columns = ((folder.index, "assets"), (folder.asset_table, "files"))
    used = {name for table, column in columns for row in read_table(table, [column]) for name in row[column] or ()}
    for place in folder.assets.glob("*"):
        for name in os.listdir(place) if place.is_dir() else ():
            if f"{folder.assets.name}/{place.name}/{name}" not in used:
                (place / name).unlink()
