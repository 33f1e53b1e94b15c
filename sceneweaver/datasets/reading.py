"""Reading a data set: its rows, the files of its scenes straight from the shards, and one scene on its own.

A set that is packed is read from ``meta/`` and ``data/``; one that is still made, from its blocks.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Container, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, reason, temporary_folder, write_atomic
from sceneweaver.io.messages import clean, suggest
from sceneweaver.io.tars import content, members

from .digests import content_of
from .folder import Folder
from .samples import ROWS, SAMPLES, read_rows
from .seals import DamagedError, kind_fault, open_own, require_inside
from .tables import read_table

SCENE = ("glb", "xml", "usdc")
"""Suffixes that become ``scene.<suffix>``, or ``home.<suffix>`` of a home, as a design has them; other files have the
names of their suffixes."""


@dataclass(frozen=True)
class Span:
    """Some scenes that lie one behind the other in a shard.

    Attributes:
        path: the tar file.
        start: where the first member begins [bytes].
        keys: the keys of the scenes, in order.
    """

    path: Path
    start: int
    keys: tuple[str, ...]


def block_folders(folder: Folder) -> list[Path]:
    """The blocks that are whole, in order."""
    return sorted(path.parent for path in folder.blocks.glob(f"*/*/{ROWS}"))


def rows_of(folder: Folder, columns: list[str] | None = None) -> Iterator[dict[str, Any]]:
    """The rows of the index, or of the blocks made so far; in order of index, a batch in memory at a time.

    Args:
        folder: the data set.
        columns: which; None: all.
    """
    if folder.index.exists():
        yield from map(_plain, read_table(folder.index, columns))
    else:
        for block in block_folders(folder):
            yield from read_rows(block)


def _plain(row: dict[str, Any]) -> dict[str, Any]:
    """A row with the fields of its structs that are there."""
    for name in ("grades", "gates"):
        if row.get(name) is not None:
            row[name] = {field: value for field, value in dict(row[name]).items() if value is not None}
    return row


def shards_of(folder: Folder) -> list[Path]:
    """The tar files with scenes, in order."""
    if folder.index.exists():
        return sorted(folder.data.glob("*.tar"))
    return [block / SAMPLES for block in block_folders(folder)]


def spans_of(path: Path, scenes: int) -> Iterator[Span]:
    """The scenes of a tar file by groups, from the headers of its members alone.

    Raises:
        InputError: no regular file, no tar file, or a damaged one.
    """
    start, keys = 0, []
    with open_own(path) as file:
        for member in members(file, clean(str(path))):
            key = split_name(member.name)[0]
            if not keys or key != keys[-1]:
                if len(keys) == scenes:
                    yield Span(path, start, tuple(keys))
                    keys = []
                if not keys:
                    start = member.start
                keys.append(key)
    if keys:
        yield Span(path, start, tuple(keys))


def scenes_of(span: Span, suffixes: Container[str] | None = None) -> Iterator[tuple[str, dict[str, bytes]]]:
    """The key and the files (by suffix) of each scene of a span, one scene in memory at a time.

    Args:
        span: where they lie.
        suffixes: which files are read; None: all. A scene without any of them is passed over.

    Raises:
        InputError: as `spans_of`.
    """
    left, key, files, name = len(span.keys), "", {}, clean(str(span.path))
    with open_own(span.path) as file:
        for member in members(file, name, span.start):
            own, suffix = split_name(member.name)
            if files and own != key:
                yield key, files
                files, left = {}, left - 1
                if not left:
                    return
            if suffixes is None or suffix in suffixes:
                key, files[suffix] = own, content(file, member, name)
    if files:
        yield key, files


@contextmanager
def of_others(folder: Folder) -> Iterator[None]:
    """Rows and scenes that lack what every data set has, or have it in another form, are one line.

    Raises:
        InputError: with the way to see all that is wrong.
    """
    try:
        yield
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"{clean(str(folder.path))}: its tables or scenes are not those of a data set ({type(error).__name__}: "
            f"{reason(error)}); see: sceneweaver dataset verify"
        ) from error


def split_name(name: str) -> tuple[str, str]:
    """Key and suffix of a member of a shard: all before and all after its first dot."""
    key, _, suffix = name.rpartition("/")[2].partition(".")
    return key, suffix


def extract(path: Path, key: str, out: Path) -> list[Path]:
    """Copy a scene with all that its files name into a new folder.

    Files of the store are hard links where the disk allows it.

    Args:
        path: the data set, packed or not.
        key: the key of the scene.
        out: the folder, which is not there yet or is empty.

    Returns:
        The files of the scene; those of the store lie in ``assets/`` beside them.

    Raises:
        InputError: there is no such scene, a file is missing, or the folder cannot be written.
    """
    from .store.scene_files import references

    folder = Folder(path)
    with of_others(folder):
        files = _files(folder, key, _row(folder, key))
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError(f"out: {out} is there already; give a new or empty folder")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with temporary_folder(out.parent) as drafts:
            draft = drafts / "scene"
            draft.mkdir()
            for name, written in files.items():
                write_atomic(draft / name, written)
            for relative in references(files):
                if fault := kind_fault(folder.path / relative):
                    raise InputError(f"{folder.path / relative}: {fault}; fetch the assets of the data set as well")
                (draft / relative).parent.mkdir(parents=True, exist_ok=True)
                link(folder.path / relative, draft / relative)
            os.replace(draft, out)
    except OSError as error:
        raise InputError(f"out: {out} cannot be written ({reason(error)}); choose another place") from None
    return [out / name for name in files]


def link(source: str | Path, target: str | Path) -> None:
    """The same file at another place: by a link where both are on one disk, else copied whole."""
    try:
        os.link(source, target)
    except OSError:
        with temporary_folder(Path(target).parent) as folder:
            draft = folder / Path(target).name
            shutil.copyfile(source, draft)
            os.replace(draft, target)


def _row(folder: Folder, key: str) -> dict[str, Any]:
    keys = []
    for row in rows_of(folder, ["key", "status", "reason", "shard", "content_hash", "bytes"]):
        if row["key"] == key:
            if row["status"] != "ok":
                raise InputError(f"key: scene {key} was not delivered ({row.get('reason')}); see the index")
            return row
        keys.append(row["key"])
    raise InputError(f"key: {folder.path} has no scene '{key}'{suggest(key, keys[:100_000])}")


def _files(folder: Folder, key: str, row: dict[str, Any]) -> dict[str, bytes]:
    """The files of a scene by the names that they have in a folder of their own."""
    if row.get("shard"):
        try:
            require_inside(row["shard"], folder.index)
        except DamagedError as error:
            raise InputError(str(error)) from None
    for path in [folder.path / row["shard"]] if row.get("shard") else shards_of(folder):
        try:
            span = next((span for span in spans_of(path, 1) if span.keys == (key,)), None)
            found = None if span is None else next(scenes_of(span))[1]
        except InputError as error:
            raise InputError(f"{error}; fetch it anew") from None
        if found is not None:
            if row.get("content_hash") and content_of(found) != (row["content_hash"], row["bytes"]):
                raise InputError(f"key: scene {key} in {path} is not what was delivered; fetch it anew")
            what = "home" if "home.json" in found else "scene"
            return {f"{what}.{suffix}" if suffix in SCENE else suffix: text for suffix, text in found.items()}
    raise InputError(f"key: no shard of {folder.path} has scene '{key}'; fetch all of the data set")
