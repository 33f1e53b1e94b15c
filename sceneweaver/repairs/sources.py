"""Scenes to repair out of files: our own ``scene.json`` and all that importers read."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from sceneweaver.importers import AUTO, read_scenes
from sceneweaver.importers.own import OWN, own_files, own_scenes
from sceneweaver.importers.relations import relations_of
from sceneweaver.io import InputError

from .stream import Given, file_name


def given_scenes(
    path: Path,
    source: str = AUTO,
    *,
    infer: bool = True,
    on_error: Callable[[str], None] | None = None,
    **options: Any,
) -> Iterator[Given]:
    """The scenes of a file or folder, in an order that depends on names alone.

    Args:
        path: a file or a folder; in a folder with scene files of ours these are taken, else what importers recognise.
        source: a format of importers, "scene" for scene files of ours, or "auto".
        infer: whether soft relations are inferred from the geometry, to be kept by the repair. Those of scene files of
            ours are not written.
        on_error: as for `sceneweaver.importers.read_scenes`.
        options: for `read_scenes`: assets, folder, sizes, room.

    Raises:
        InputError: nothing is recognised, or a file is broken and there is no ``on_error``.
    """
    own = own_files(path) if source in (AUTO, OWN) else []
    if source == OWN and not own:
        raise InputError(f"{path}: no scene file in it; give scene.json files, or another format with --from")
    if own:
        yield from _own_scenes(path, own, infer, on_error)
        return
    used: set[str] = set()
    for imported in read_scenes(path, source, relations=infer, on_error=on_error, **options):
        about = {"format": imported.format, "room": imported.room, "boundary": imported.boundary}
        yield Given(_unused(imported.scene.id, used), imported.scene, about)


def _own_scenes(path: Path, files: list[Path], infer: bool, on_error: Callable[[str], None] | None) -> Iterator[Given]:
    used: set[str] = set()
    for file, scene in own_scenes(files, on_error):
        said = {(r.type, r.subject, r.target) for r in scene.relations}
        found = relations_of(scene) if infer else ()
        more = tuple(r for r in found if (r.type, r.subject, r.target) not in said)
        name = file.relative_to(path) if path.is_dir() else Path(file.name)
        about = {"format": OWN, "room": scene.id, "boundary": "file"}
        wishing = scene.model_copy(update={"relations": (*scene.relations, *more)})
        yield Given(_unused(str(name.with_suffix("")), used), wishing, about, len(more))


def _unused(text: str, used: set[str]) -> str:
    """A name of files that no other scene has."""
    stem = file_name(text)
    name, k = stem, 2
    while name in used:
        name, k = f"{stem}-{k}", k + 1
    used.add(name)
    return name
