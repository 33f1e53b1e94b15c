"""What a run finds in a folder is what was written there, or goes, so that it is made anew.

Blocks and plans have seals, assets are named by their content, rows of records carry their SHA-256, shards are checked
against the plan. Since all of it follows from the specification, what is made anew has the same bytes.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

from sceneweaver.io import own_folder, reason, sweep, temporary_folder, write_atomic

from ..digests import read_checksums, sha256_of
from ..files.planned import (
    SECONDS_TABLE,
    asset_files,
    covering,
    is_whole,
    named_files,
    needed,
    packing_began,
    place_of,
    planned,
)
from ..folder import Folder
from ..samples import read_rows
from ..seals import (
    SEAL,
    DamagedError,
    Entry,
    entry_of,
    fault_of,
    folder_fault,
    kind_fault,
    opened_row,
    read_seal,
    remove,
    write_seal,
)
from ..store import DIGITS
from ..tables import schema_of, write_table
from .manifest import Dataset

Notice = Callable[[str], None]
"""Told in one line what is made anew, and why."""

NAMED = 8
"""How many files of a kind are named, one a line; of the others only the number is said."""

FILES = ("complete", "packed", "begun.sha256", "joined.txt")
FOLDERS = ("assets", "blocks", "journal", "plan", "records", "rooms", "shards")
"""What lies in ``work/``."""


def missing(dataset: Dataset, shard: tuple[int, int] | None = None) -> list[int]:
    """The blocks of a data set, or of a shard of the work, that are not made yet and are needed."""
    folder, (first, step) = dataset.folder, shard or (0, 1)
    if packing_began(folder):
        found = needed(folder, dataset.requests) if dataset.spec.product != "layouts" else []
        return [number for number in found if number % step == first]
    return [n for n in range(first, dataset.requests.blocks, step) if not folder.block(n).exists()]


def mend(dataset: Dataset, notice: Notice, *, full: bool = True) -> bool:
    """Remove what is not as it was written, and what depends on it, so that it counts as missing.

    Args:
        dataset: the data set, which no other run works on.
        notice: told of all that goes.
        full: whether contents are read, too; else only links, pipes and devices go.

    Returns:
        Whether anything went.
    """
    mender = _Mender(dataset, notice)
    mender.strays()
    if full:
        mender.assets()
        mender.records()
        if packing_began(dataset.folder):
            mender.packing()
        mender.blocks()
        mender.sources()
    return mender.found


class _Mender:
    def __init__(self, dataset: Dataset, notice: Notice):
        self._dataset, self._folder, self._notice = dataset, dataset.folder, notice
        self.found = False

    def strays(self) -> None:
        """What is neither a file nor a folder of ours, in the places that runs read."""
        folder = self._folder
        for path in _sorted(folder.work):
            fault = kind_fault(path)
            if fault and (path.name in FILES or fault != "is a folder"):
                self._gone([(path, fault)])
            elif not fault and path.name in FOLDERS:
                self._gone([(path, "is no folder")])
        for top in (folder.work, folder.assets, folder.data, folder.meta):
            if os.path.lexists(top) and kind_fault(top) != "is a folder":
                self._gone([(top, kind_fault(top) or "is no folder")])
            found = ((path, kind_fault(path)) for path in _below(top))
            self._gone([(path, fault) for path, fault in found if fault not in ("", "is a folder", "is missing")])

    def assets(self) -> None:
        """Files of the store that do not have the content that their names say."""
        root, names = self._folder.path, []
        for place in _sorted(self._folder.assets):
            if place.name.startswith("."):
                continue
            if place.is_file():
                self._gone([(place, "is no file of the store")])
                continue
            for path in _sorted(place):
                if path.is_dir() or len(path.stem) != DIGITS or path.stem[:2] != place.name:
                    self._gone([(path, "is no file of the store")])
                else:
                    names.append(path.relative_to(root).as_posix())
        wrong = [name for name, digest in zip(names, sha256_of(root, names), strict=True) if not _named(name, digest)]
        self._gone([(root / name, "has other content than its name says") for name in wrong])

    def records(self) -> None:
        """Rows about assets that are not what was written; one at the end that is cut off is no news."""
        from ..store.scene_files import read_records  # which loads all exporters

        for path in _sorted(self._folder.work / "assets"):
            lines = read_records(path)
            good = [line for line in lines if opened_row(line) is not None]
            torn = bool(lines) and not lines[-1].endswith(b"\n")
            if len(good) + torn < len(lines):
                self._say(path, f"{len(lines) - len(good)} of {len(lines)} rows are damaged")
            if len(good) < len(lines):
                write_atomic(path, b"".join(good))

    def packing(self) -> None:
        """Tables and shards of a packing that has begun. Where the tables are damaged, all is made anew."""
        folder = self._folder
        fault = self._plan_fault()
        if fault:
            self._say(folder.plan, f"{fault}; packing begins anew")
            start_over(folder)
            return
        if self._dataset.spec.product == "layouts":
            return
        wanted = planned(folder)
        for path in _sorted(folder.data):
            name = f"data/{path.name}"
            if name not in wanted:
                self._gone([(path, "is no shard of the plan")])
            elif not is_whole(path, wanted[name]):
                self._gone([(path, kind_fault(path) or "is not what was packed")])

    def _plan_fault(self) -> str:
        """What is wrong with the plan and what was moved out of it already."""
        folder = self._folder
        try:
            entries = read_seal(folder.plan / SEAL)
        except DamagedError as error:
            return reason(error).removeprefix(f"{folder.plan}/")
        for name, entry in entries.items():
            if fault := fault_of(place_of(folder, name), entry):
                return f"{name} {fault}"
        return ""

    def blocks(self) -> None:
        """Blocks that are not what was written."""
        folder, numbers = self._folder, range(self._dataset.requests.blocks)
        known = {folder.block(number) for number in numbers}
        for group in _sorted(folder.blocks):
            if not group.is_dir():
                self._gone([(group, "is no block")])
                continue
            for path in _sorted(group):
                if path.name.startswith("."):
                    continue
                if path not in known:
                    self._gone([(path, "is no block of this data set")])
                elif fault := folder_fault(path) if path.is_dir() else "is no folder":
                    self._gone([(path, fault)])

    def sources(self) -> None:
        """Blocks which, made again, bring back files and records of assets that others need as well."""
        folder, spec = self._folder, self._dataset.spec
        if spec.product == "layouts" or not folder.blocks.exists():
            return
        from ..store import AssetStore
        from ..store.scene_files import asset_rows

        files = asset_files(asset_rows(AssetStore(folder.path)))
        told: set[str] = set()

        def delivered() -> Iterator[tuple[int, set[str], list[str]]]:
            for number in range(self._dataset.requests.blocks):
                path = folder.block(number)
                for row in read_rows(path) if path.exists() else ():
                    if row["status"] == "ok":
                        yield number, named_files(row, files), row.get("asset_ids") or []

        chosen = covering(folder, ((number, names) for number, names, _ in delivered()))
        if not packing_began(folder):  # the plan has what it needs of records
            for number, _, assets in delivered():
                unknown = [name for name in assets if name not in files and name not in told]
                told |= set(unknown)
                if unknown:
                    chosen.add(number)
        self._gone([(folder.block(number), "needs files of the store that are gone") for number in sorted(chosen)])

    def _gone(self, damaged: list[tuple[Path, str]]) -> None:
        for number, (path, fault) in enumerate(damaged):
            remove(path)
            if number < NAMED:
                self._say(path, f"{fault}; it is made again")
        if len(damaged) > NAMED:
            self._say(damaged[-1][0].parent, f"{len(damaged) - NAMED} more are damaged; they are made again")

    def _say(self, path: Path, text: str) -> None:
        self.found = True
        self._notice(f"{path.relative_to(self._folder.path)}: {text}")


def start_over(folder: Folder) -> None:
    """Forget a packing, with all that it wrote: blocks that it has packed are missing from then on.

    The tables go first, so that what is left of a cut-off call counts as damaged as well.
    """
    for path in (folder.index, folder.programs, folder.plan, folder.data, folder.meta, folder.checksums):
        remove(path)
    for path in (folder.packed, folder.complete):
        remove(path)


def lost(dataset: Dataset, *, full: bool = False) -> list[tuple[str, str]]:
    """The files of a whole data set that are missing or damaged, with what is wrong with each.

    Args:
        dataset: the data set.
        full: whether contents are read; else there is a look at names and sizes only, where a seal has these.
    """
    folder = dataset.folder
    try:
        entries = read_seal(folder.packed)
    except DamagedError:
        return _differing(folder)
    found = ((name, fault_of(folder.path / name, entry, full=full)) for name, entry in entries.items())
    return [(name, fault) for name, fault in found if fault]


def _differing(folder: Folder) -> list[tuple[str, str]]:
    """What is missing or damaged by the checksums; they themselves, where they cannot be read."""
    try:
        listed = read_checksums(folder)
    except DamagedError as error:
        return [(folder.checksums.name, reason(error))]
    faults = {name: kind_fault(folder.path / name) for name in listed}
    good = [name for name, fault in faults.items() if not fault]
    for name, digest in zip(good, sha256_of(folder.path, good), strict=True):
        if digest != listed[name]:
            faults[name] = "has other content"
    times = folder.meta / SECONDS_TABLE
    faults[times.relative_to(folder.path).as_posix()] = kind_fault(times)
    return [(name, fault) for name, fault in sorted(faults.items()) if fault]


def reopen(dataset: Dataset, damaged: list[tuple[str, str]], notice: Notice) -> None:
    """Bring a whole data set back to where its packing goes on, without what is damaged.

    Args:
        dataset: the data set.
        damaged: from `lost`.
        notice: told of each file.
    """
    folder = dataset.folder
    for name, fault in damaged[:NAMED]:
        notice(f"{name}: {fault}; it is made again")
    if len(damaged) > NAMED:
        notice(f"{len(damaged) - NAMED} more files are damaged; they are made again")
    names = {name for name, _ in damaged}
    times = folder.meta / SECONDS_TABLE
    if times.relative_to(folder.path).as_posix() in names:  # what no run can measure again
        remove(times)
        own_folder(folder.meta)
        write_table(times, [], schema_of("seconds"))
    planned = _plan_of(dataset, names)
    if planned is None:
        notice("its tables have to be made anew, and all blocks with them")
        start_over(folder)
        return
    sweep(folder.work)
    remove(folder.plan)
    folder.work.mkdir(exist_ok=True)
    with temporary_folder(folder.work) as drafts:
        (drafts / folder.plan.name).mkdir()
        write_seal(drafts / folder.plan.name / SEAL, planned)
        os.rename(drafts / folder.plan.name, folder.plan)
    for name in names - {times.relative_to(folder.path).as_posix()}:
        remove(folder.path / name)
    for path in (folder.checksums, folder.packed, folder.complete):
        remove(path)


def _plan_of(dataset: Dataset, damaged: set[str]) -> dict[str, Entry] | None:
    """What the plan of a whole data set had; None where packing cannot go on from what is there.

    Shards of layouts are not written one by one.
    """
    folder, known = dataset.folder, _known(dataset.folder)
    tables = [folder.programs] if dataset.spec.product == "layouts" else [folder.asset_table, folder.index]
    needed = [path.relative_to(folder.path).as_posix() for path in tables]
    if dataset.spec.product == "layouts":
        needed += [name for name in known if name.startswith("data/")]
    if any(name not in known or name in damaged for name in needed):
        return None
    times = folder.meta / SECONDS_TABLE
    entries = {name.removeprefix("meta/"): known[name] for name in needed}
    return entries if kind_fault(times) else {**entries, SECONDS_TABLE: entry_of(times)}


def _known(folder: Folder) -> dict[str, Entry]:
    """The files of a whole data set as they were: by its seal, or by its checksums."""
    try:
        return read_seal(folder.packed)
    except DamagedError:
        pass
    try:
        listed = read_checksums(folder)
    except DamagedError:
        return {}
    there = {name: digest for name, digest in listed.items() if not kind_fault(folder.path / name)}
    return {name: Entry(digest, (folder.path / name).lstat().st_size) for name, digest in there.items()}


def seal_whole(folder: Folder) -> None:
    """Write the seal of a data set whose checksums are there."""
    listed = read_checksums(folder) if folder.checksums.exists() else {}
    entries = {name: Entry(digest, (folder.path / name).stat().st_size) for name, digest in listed.items()}
    for path in (folder.checksums, folder.meta / SECONDS_TABLE):
        if not kind_fault(path):
            entries[path.relative_to(folder.path).as_posix()] = entry_of(path)
    write_seal(folder.packed, entries)


def _named(name: str, digest: str) -> bool:
    return digest.startswith(Path(name).stem)


def _sorted(path: Path) -> list[Path]:
    return sorted(path.iterdir()) if path.is_dir() and not path.is_symlink() else []


def _below(path: Path) -> Iterator[Path]:
    """All that lies below a folder; links are not followed."""
    for place, folders, files in os.walk(path):
        yield from (Path(place, name) for name in (*files, *folders))
