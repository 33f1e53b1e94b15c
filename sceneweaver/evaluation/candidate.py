"""Scenes to be judged, wherever they come from, and what their files do not say."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sceneweaver.datasets import Folder
from sceneweaver.datasets.reading import scenes_of, shards_of, spans_of
from sceneweaver.importers import AUTO, ImportedScene, read_scenes
from sceneweaver.importers.bodies import Assets
from sceneweaver.importers.own import OWN, own_files, own_scenes
from sceneweaver.importers.sizes import SizeTable
from sceneweaver.io import InputError
from sceneweaver.io.messages import clean, path_name
from sceneweaver.scene import Scene

from .metrics import ABSENT, Needs

Source = Scene | ImportedScene | str | os.PathLike[str]
"""A scene, or a file or folder of scenes."""

_GUESSED = "category"  # where a size comes from that is in no file


@dataclass(frozen=True)
class Candidate:
    """A scene to judge.

    Attributes:
        scene: as it is judged.
        name: of the scene, within its system.
        format: that its file was read as.
        lacks: what figures cannot be given for, with the reason.
        notes: what was assumed or left out when it was read.
    """

    scene: Scene
    name: str
    format: str = OWN
    lacks: Mapping[Needs, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Reading:
    """How files are read: ``format`` ("auto": by what is in them), what stands for objects, folder and table of sizes;
    ``assume_sizes``: whether figures are given for sizes that are in no file, but usual ones of their categories."""

    format: str = AUTO
    assets: Assets = "own"
    folder: Path | None = None
    sizes: SizeTable | None = None
    assume_sizes: bool = False


def candidates(
    sources: Source | Iterable[Source], reading: Reading | None = None, on_error: Callable[[str], None] | None = None
) -> Iterator[Candidate]:
    """The scenes of some sources, one by one.

    Args:
        sources: scenes, files and folders.
        reading: how files are read.
        on_error: called with one line for a file that cannot be read, which is then passed over; None: it is raised.

    Raises:
        InputError: a file is broken, or nothing in a folder is a scene.
    """
    how = reading or Reading()
    each = [sources] if isinstance(sources, Scene | ImportedScene | str | os.PathLike) else sources
    for source in each:
        if isinstance(source, Scene):
            yield _of_scene(source, source.id, how)
        elif isinstance(source, ImportedScene):
            yield _of_import(source, how)
        elif isinstance(source, str | os.PathLike):
            yield from _of_path(Path(source), how, on_error)
        else:
            raise InputError(f"scenes: {type(source).__name__} is no scene; give scenes, files or folders")


def _of_path(path: Path, how: Reading, on_error: Callable[[str], None] | None) -> Iterator[Candidate]:
    own = own_files(path) if how.format in (AUTO, OWN) else []
    if how.format in (AUTO, OWN) and path.is_dir() and (path / "dataset.json").is_file():
        yield from _of_data_set(path, how)
        return
    for file, scene in own_scenes(own, on_error):
        inside = file.relative_to(path) if path.is_dir() else Path(file.name)
        name = str(inside.parent) if file.name == "scene.json" and inside.parent != Path() else str(inside)
        yield _of_scene(scene, name.removesuffix(".json"), how)
    if own:
        return
    if how.format == OWN:
        raise InputError(f"{path_name(path)}: no scene of ours in it; give scene files, or another format with --from")
    for found in read_scenes(
        path, how.format, assets=how.assets, folder=how.folder, sizes=how.sizes, relations=False, on_error=on_error
    ):
        yield _of_import(found, how)


def _of_data_set(path: Path, how: Reading) -> Iterator[Candidate]:
    """The scenes of a packed data set of ours."""
    shards = shards_of(Folder(path))
    if not shards:
        raise InputError(f"{path_name(path)}: the data set is not packed yet; finish it with: dataset resume")
    for shard in shards:
        for span in spans_of(shard, 1):
            for key, files in scenes_of(span, {"scene.json"}):
                yield _of_scene(Scene.loads(files["scene.json"]), key, how)


def _of_import(found: ImportedScene, how: Reading) -> Candidate:
    made = _of_scene(found.scene, found.scene.id, how)
    return Candidate(made.scene, made.name, found.format, made.lacks, tuple(clean(note) for note in found.notes))


def _of_scene(scene: Scene, name: str, how: Reading) -> Candidate:
    """A scene with what it lacks: an imported one says so in its provenance, wherever its file has been since."""
    told = scene.provenance.get("imported") if isinstance(scene.provenance, Mapping) else None
    if not isinstance(told, Mapping):
        return Candidate(scene, clean(name))
    return Candidate(scene, clean(name), str(told.get("format", OWN)), _lacks(scene, told, how.assume_sizes))


def _lacks(scene: Scene, told: Mapping[str, Any], assume_sizes: bool) -> dict[Needs, str]:
    lacks: dict[Needs, str] = {}
    rows = _told_objects(scene).values()
    unnamed = [row for row in rows if not row.get("confidence", 1.0)]
    guessed = [row for row in rows if row.get("size_from") == _GUESSED]
    if 2 * len(unnamed) > len(rows):
        lacks["labels"] = ABSENT["labels"]
    if guessed and (not assume_sizes or any(row in unnamed for row in guessed)):  # what it is says how large
        some = "" if len(guessed) == len(rows) else f" for {len(guessed)} of {len(rows)} objects"
        lacks["sizes"] = f"{ABSENT['sizes']}{some}"
    if told.get("boundary") == "objects":
        lacks["room"] = ABSENT["room"]
    if not scene.room.doors and not scene.room.windows:
        lacks["openings"] = ABSENT["openings"]
    return lacks


def _told_objects(scene: Scene) -> dict[str, Mapping[str, Any]]:
    """What is known of the objects of an imported scene, by id."""
    told = scene.provenance.get("imported") if isinstance(scene.provenance, Mapping) else None
    objects = told.get("objects") if isinstance(told, Mapping) else None
    if not isinstance(objects, Mapping):
        return {}
    return {str(name): row for name, row in objects.items() if isinstance(row, Mapping)}


def guessed_sizes(scene: Scene) -> tuple[str, ...]:
    """Ids of the objects of an imported scene whose size is in no file."""
    return tuple(name for name, row in _told_objects(scene).items() if row.get("size_from") == _GUESSED)
