"""One scene out of a data set, as a folder that stands alone."""

from __future__ import annotations

import os
import shutil
import tarfile
from pathlib import Path
from typing import Any

from sceneweaver.scene import InputError
from sceneweaver.scene.files import reason, temporary_folder
from sceneweaver.scene.messages import suggest

from .folder import Folder
from .reading import rows_of, shards_of, split_name

SCENE = ("glb", "xml", "usdc")
"""Suffixes that become ``scene.<suffix>``, as a design has them; other files have the names of their suffixes."""


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
    folder = Folder(path)
    files = _files(folder, key, _row(folder, key))
    from .store.scene_files import references

    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError(f"out: {out} is there already; give a new or empty folder")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with temporary_folder(out.parent) as drafts:
            draft = drafts / "scene"
            draft.mkdir()
            for name, content in files.items():
                (draft / name).write_bytes(content)
            for relative in references(files):
                _link(folder.path / relative, draft / relative)
            os.replace(draft, out)
    except OSError as error:
        raise InputError(f"out: {out} cannot be written ({reason(error)}); choose another place") from None
    return [out / name for name in files]


def _row(folder: Folder, key: str) -> dict[str, Any]:
    keys = []
    for row in rows_of(folder, ["key", "status", "reason", "shard"]):
        if row["key"] == key:
            if row["status"] != "ok":
                raise InputError(f"key: scene {key} was not delivered ({row.get('reason')}); see the index")
            return row
        keys.append(row["key"])
    raise InputError(f"key: {folder.path} has no scene '{key}'{suggest(key, keys[:100_000])}")


def _files(folder: Folder, key: str, row: dict[str, Any]) -> dict[str, bytes]:
    """The files of a scene by the names that they have in a folder of their own."""
    for path in [folder.path / row["shard"]] if row.get("shard") else shards_of(folder):
        found: dict[str, bytes] = {}
        try:
            with tarfile.open(path, "r:") as tar:
                for member in tar:
                    name, suffix = split_name(member.name)
                    content = tar.extractfile(member) if name == key else None
                    if content is not None:
                        found[f"scene.{suffix}" if suffix in SCENE else suffix] = content.read()
                    elif found:
                        break
        except (tarfile.TarError, OSError) as error:
            raise InputError(f"{path}: no whole tar file ({reason(error)}); fetch it anew") from None
        if found:
            return found
    raise InputError(f"key: no shard of {folder.path} has scene '{key}'; fetch all of the data set")


def _link(source: Path, target: Path) -> None:
    if not source.is_file():
        raise InputError(f"{source}: no such file; fetch the assets of the data set as well")
    target.parent.mkdir(parents=True, exist_ok=True)
    try:
        os.link(source, target)
    except OSError:
        shutil.copyfile(source, target)
