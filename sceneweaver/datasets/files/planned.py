"""What packing is to write, and how much of it is there: shards are checked scene by scene against the plan."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sceneweaver.io.tars import content, ending, header, members

from ..digests import content_of
from ..folder import Folder
from ..requests import Requests
from ..seals import kind_fault, open_own
from ..spec import Spec
from ..tables import read_table

INDEX, SECONDS_TABLE, ASSETS = "index.parquet", "seconds.parquet", "assets.parquet"


class Planned(NamedTuple):
    """A scene of a shard: its number, name, content hash, and bytes."""

    index: int
    key: str
    digest: str
    size: int


def packing_began(folder: Folder) -> bool:
    """Whether packing has begun: then blocks may be gone."""
    return folder.plan.exists() or folder.index.exists() or folder.programs.exists()


def place_of(folder: Folder, name: str) -> Path:
    """Where a file of the plan lies: in the plan, or where it is to be already."""
    draft = folder.plan / name
    return draft if os.path.lexists(draft) else final_place(folder, name)


def final_place(folder: Folder, name: str) -> Path:
    """Where a file of the plan is to be."""
    return folder.path / name if name.startswith("data/") else folder.meta / name


def planned(folder: Folder) -> dict[str, list[Planned]]:
    """The scenes of each shard in order, by the path of the shard."""
    found: dict[str, list[Planned]] = {}
    for row in read_table(place_of(folder, INDEX), ["index", "key", "shard", "content_hash", "bytes"]):
        if row["shard"] is not None:
            one = Planned(row["index"], row["key"], row["content_hash"], row["bytes"])
            found.setdefault(row["shard"], []).append(one)
    return found


def there(path: Path, scenes: Sequence[Planned]) -> tuple[int, int]:
    """How many of its scenes the beginning of a shard has as they were delivered, and where they end [bytes]."""
    count = end = 0
    if kind_fault(path):
        return count, end
    try:
        for count, end in enumerate(_ends(path, scenes), start=1):  # noqa: B007
            pass
    except ValueError:  # it is cut off there, or damaged
        pass
    return count, end


def is_whole(path: Path, scenes: Sequence[Planned]) -> bool:
    """Whether a shard has its scenes as they were delivered, and nothing else."""
    count, end = there(path, scenes)
    if count < len(scenes):
        return False
    with open_own(path) as file:
        file.seek(end)
        return file.read(len(ending(end)) + 1) == ending(end)


def _ends(path: Path, scenes: Sequence[Planned]) -> Iterator[int]:
    """Where each scene ends [bytes], as long as they are what was delivered."""
    name = str(path)
    with open_own(path) as file:
        left = members(file, name)
        for scene in scenes:
            files: dict[str, bytes] = {}
            size = 0
            while size < scene.size or content_of(files) != (scene.digest, scene.size):
                member = next(left, None)
                if member is None or size + member.size > scene.size:
                    return
                key, _, suffix = member.name.partition(".")
                file.seek(member.start)
                if key != scene.key or file.read(member.data - member.start) != header(member.name, member.size):
                    return
                files[suffix] = content(file, member, name)
                if any(file.read(member.end - member.data - member.size)):
                    return
                size, end = size + member.size, member.end
            yield end


def block_of(spec: Spec, index: int) -> int:
    """The block of a scene by its number."""
    return index // spec.rooms.layouts // spec.block


def needed(folder: Folder, requests: Requests) -> list[int]:
    """The blocks that packing, which has begun, needs, and that are not there.

    They hold scenes that lie in no shard yet, or name files that the store lacks.
    """
    spec, numbers = requests.spec, set[int]()
    for shard, scenes in planned(folder).items():
        if not os.path.lexists(folder.path / shard):
            count, _ = there(folder.plan / Path(shard).name, scenes)
            numbers |= {block_of(spec, scene.index) for scene in scenes[count:]}
    files = asset_files(read_table(place_of(folder, ASSETS)))
    rows = read_table(place_of(folder, INDEX), ["index", "status", "assets", "asset_ids"])
    delivered = (row for row in rows if row["status"] == "ok")
    numbers |= covering(folder, ((block_of(spec, row["index"]), named_files(row, files)) for row in delivered))
    return sorted(number for number in numbers if not folder.block(number).exists())


def asset_files(rows: Iterable[Mapping[str, Any]]) -> dict[str, list[str]]:
    """The files of each asset by its id."""
    return {row["asset"]: row["files"] for row in rows}


def named_files(row: Mapping[str, Any], files: Mapping[str, Sequence[str]]) -> set[str]:
    """The files of the store that a scene needs: those that it names, and those of its assets."""
    return set(row.get("assets") or ()).union(*(files.get(asset, ()) for asset in row.get("asset_ids") or ()))


def covering(folder: Folder, named: Iterable[tuple[int, set[str]]]) -> set[int]:
    """Blocks which, made again, bring all files back that the store lacks: the first that needs each.

    Args:
        folder: the data set.
        named: blocks with the files that they need.
    """
    known: dict[str, bool] = {}
    chosen: set[int] = set()
    for number, files in named:
        fresh = {name: not kind_fault(folder.path / name) for name in files if name not in known}
        known |= fresh
        if not all(fresh.values()):
            chosen.add(number)
    return chosen
